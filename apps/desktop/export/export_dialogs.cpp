#include "export/export_dialogs.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QRadioButton>
#include <QStandardItemModel>
#include <algorithm>
#include <cmath>

#include "export/film_writer.h"
#include "paint/boxes.h"

namespace elsie::desktop {
namespace {

constexpr int kMost_px = 8000;  // an older graphics card has no larger pictures
constexpr double kCmPerInch = 2.54;

class Dialogs {
  Q_DECLARE_TR_FUNCTIONS(Dialogs)

 public:
  static std::optional<FilmChoice> film(const QSize& shown, double run_s, QWidget* parent);
  static std::optional<PictureChoice> picture(const QSize& shown, QWidget* parent);

 private:
  static QComboBox* box(QFormLayout* form, const QString& label, const char* name) {
    auto* made = new QComboBox;
    made->setObjectName(QLatin1String(name));
    form->addRow(label, made);
    return made;
  }
  static bool is_agreed(QDialog& dialog, QFormLayout* form) {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    buttons->setObjectName(QStringLiteral("buttons"));
    form->addRow(buttons);
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    return dialog.exec() == QDialog::Accepted;
  }
  static QString size_text(const QSize& size) {
    return tr("%1 x %2").arg(size.width()).arg(size.height());
  }
};

/// Of a film, both are even, because most formats need that.
QSize even(const QSize& size) { return {size.width() / 2 * 2, size.height() / 2 * 2}; }

std::optional<FilmChoice> Dialogs::film(const QSize& shown, double run_s, QWidget* parent) {
  QDialog dialog(parent);
  dialog.setObjectName(QStringLiteral("film_dialog"));
  dialog.setWindowTitle(tr("Export the film"));
  auto* form = new QFormLayout(&dialog);
  const bool has_ffmpeg = !FilmWriter::ffmpeg().isEmpty();
  QComboBox* format = box(form, tr("&Format"), "film_format");
  const auto add_format = [&](const QString& text, const char* ending) {
    format->addItem(text, QLatin1String(ending));
    if (!has_ffmpeg && FilmWriter::endings_with_ffmpeg().contains(QLatin1String(ending))) {
      static_cast<QStandardItemModel*>(format->model())
          ->item(format->count() - 1)
          ->setEnabled(false);
    }
  };
  add_format(tr("MP4 (H.264): for mails, slides and browsers"), "mp4");
  add_format(tr("WebM (VP9): small, for browsers"), "webm");
  add_format(tr("GIF: plays everywhere, large, without a pause"), "gif");
  add_format(tr("AVI (Motion JPEG): large, needs no other program"), "avi");
  format->setCurrentIndex(has_ffmpeg ? 0 : format->count() - 1);
  if (!has_ffmpeg) {
    auto* hint =
        new QLabel(tr("MP4, WebM and GIF need the program ffmpeg, which is not installed. "
                      "'sudo apt install ffmpeg' installs it; then open this again."));
    hint->setObjectName(QStringLiteral("film_hint"));
    hint->setWordWrap(true);
    hint->setTextInteractionFlags(Qt::TextSelectableByMouse);
    form->addRow(hint);
  }
  QComboBox* size = box(form, tr("&Size"), "film_size");
  size->addItem(tr("%1, as the view").arg(size_text(even(shown))), even(shown));
  for (const QSize& each : {QSize(640, 360), QSize(1280, 720), QSize(1920, 1080)}) {
    size->addItem(size_text(each), each);
  }
  QComboBox* speed = box(form, tr("S&peed"), "film_speed");
  for (const double factor : {0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0}) {
    speed->addItem(tr("%1x: a film of %2 s").arg(factor).arg(run_s / factor, 0, 'f', 1), factor);
  }
  speed->setCurrentIndex(2);
  if (!is_agreed(dialog, form)) {
    return std::nullopt;
  }
  return FilmChoice{format->currentData().toString(), size->currentData().toSize(),
                    speed->currentData().toDouble()};
}

std::optional<PictureChoice> Dialogs::picture(const QSize& shown, QWidget* parent) {
  QDialog dialog(parent);
  dialog.setObjectName(QStringLiteral("picture_dialog"));
  dialog.setWindowTitle(tr("Export the picture"));
  auto* form = new QFormLayout(&dialog);
  auto* view = new QRadioButton(tr("The &view, as it is shown"));
  view->setObjectName(QStringLiteral("picture_view"));
  view->setChecked(true);
  auto* above = new QRadioButton(tr("From &above, drawn: with paths, axes and a legend"));
  above->setObjectName(QStringLiteral("picture_above"));
  form->addRow(view);
  form->addRow(above);
  QComboBox* format = box(form, tr("&Format"), "picture_format");
  auto* width = new NumberBox;
  width->setObjectName(QStringLiteral("picture_width"));
  width->setRange(1.0, 100.0);
  width->setDecimals(1);
  width->setValue(16.0);
  width->setSuffix(tr(" cm"));
  form->addRow(tr("&Width in print"), width);
  QComboBox* dpi = box(form, tr("&Resolution"), "picture_dpi");
  dpi->addItem(tr("Screen: 96 dots per inch"), 96);
  dpi->addItem(tr("Slides: 150 dots per inch"), 150);
  dpi->addItem(tr("Print: 300 dots per inch"), 300);
  dpi->addItem(tr("Fine print: 600 dots per inch"), 600);
  dpi->setCurrentIndex(2);
  auto* pixels = new QLabel;
  pixels->setObjectName(QStringLiteral("picture_pixels"));
  form->addRow(tr("Pixels"), pixels);
  const auto is_drawn = [=] {
    return format->currentData().toString() == QLatin1String("svg") ||
           format->currentData().toString() == QLatin1String("pdf");
  };
  const auto dots = [=] { return is_drawn() ? kUsualDpi : dpi->currentData().toDouble(); };
  const auto size = [=] {
    const double inches = width->value() / kCmPerInch;
    const int across =
        std::clamp(static_cast<int>(std::lround(inches * dots())), kNarrowest_px, kMost_px);
    return QSize(across, across * shown.height() / shown.width());
  };
  const auto show = [=] {
    dpi->setEnabled(!is_drawn());
    // Rounded up to the decimal of the box.
    const double narrowest = std::ceil(10.0 * kNarrowest_px * kCmPerInch / kUsualDpi) / 10.0;
    width->setMinimum(is_drawn() ? narrowest : 1.0);
    pixels->setText(is_drawn()           ? tr("none: sharp at any size")
                    : above->isChecked() ? tr("%1 wide").arg(size().width())
                                         : size_text(size()));
  };
  const auto list_formats = [=] {
    const QSignalBlocker quiet(format);
    format->clear();
    format->addItem(tr("PNG"), QStringLiteral("png"));
    if (above->isChecked()) {
      format->addItem(tr("SVG: lines and texts, for editing"), QStringLiteral("svg"));
      format->addItem(tr("PDF: lines and texts, for papers"), QStringLiteral("pdf"));
    } else {
      format->addItem(tr("JPEG"), QStringLiteral("jpg"));
    }
    show();
  };
  list_formats();
  QObject::connect(above, &QRadioButton::toggled, &dialog, list_formats);
  QObject::connect(format, &QComboBox::currentIndexChanged, &dialog, show);
  QObject::connect(dpi, &QComboBox::currentIndexChanged, &dialog, show);
  QObject::connect(width, &QDoubleSpinBox::valueChanged, &dialog, show);
  if (!is_agreed(dialog, form)) {
    return std::nullopt;
  }
  return PictureChoice{above->isChecked(), format->currentData().toString(), size(), dots()};
}

}  // namespace

QString ask_for_file(const QString& title, const QString& name, const QString& kinds,
                     QWidget* parent) {
  QFileDialog dialog(parent, title, {}, kinds);
  dialog.setObjectName(QStringLiteral("export_dialog"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(QFileInfo(name).suffix());
  dialog.selectFile(name);
  return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().front() : QString();
}

std::optional<FilmChoice> ask_for_film(const QSize& shown, double run_s, QWidget* parent) {
  return Dialogs::film(shown, run_s, parent);
}

std::optional<PictureChoice> ask_for_picture(const QSize& shown, QWidget* parent) {
  return Dialogs::picture(shown, parent);
}

}  // namespace elsie::desktop
