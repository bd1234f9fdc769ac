#include "watch/vision_panel.h"

#include <QContextMenuEvent>
#include <QFileDialog>
#include <QMenu>
#include <QMessageBox>
#include <QPainter>
#include <QToolButton>
#include <algorithm>

#include "paint/save_picture.h"
#include "watch/state.h"

namespace elsie::desktop {
namespace {

/// Null if it is none.
QImage image_in(const Json& picture) {
  const int width = integer_of(picture, "width", 0), height = integer_of(picture, "height", 0);
  const QByteArray bytes = QByteArray::fromBase64(text_of(picture, "pixels").toLatin1());
  if (width < 1 || height < 1 || bytes.size() != qsizetype{3} * width * height) {
    return {};
  }
  return QImage(reinterpret_cast<const uchar*>(bytes.constData()), width, height, 3 * width,
                QImage::Format_RGB888)
      .copy();
}

}  // namespace

VisionPanel::VisionPanel(QWidget* parent)
    : QWidget(parent), choose_(new QToolButton(this)), choices_(new QMenu(this)) {
  setObjectName(QStringLiteral("vision"));
  setAccessibleName(tr("Pictures of the cameras"));
  choose_->setObjectName(QStringLiteral("vision_choose"));
  choose_->setText(tr("Pictures"));
  choose_->setToolTip(tr("Choose the pictures that show"));
  choose_->setPopupMode(QToolButton::InstantPopup);
  choose_->setMenu(choices_);
  choose_->adjustSize();
  offer_figures(this);
  setContextMenuPolicy(Qt::DefaultContextMenu);  // its own menu also has the table
}

void VisionPanel::add(const Json& state) {
  take(state, &Picture::image);
  update();
}

void VisionPanel::look_back(const Instant* then) {
  then_s_ = then ? std::optional(then->time_s) : std::nullopt;
  for (auto& [name, picture] : pictures_) picture.then = QImage();
  if (then) take(then->look, &Picture::then);
  update();
}

void VisionPanel::take(const Json& state, QImage Picture::*where) {
  for (const Json& robot : member(state, "robots")) {
    for (const Json& camera : member(robot, "cameras")) {
      const QString name = text_of(robot, "id") + u'/' + text_of(camera, "id");
      for (const Json& picture : member(camera, "pictures")) {
        const QImage image = image_in(picture);
        if (!image.isNull()) offered(name + u' ' + text_of(picture, "name")).*where = image;
      }
    }
  }
}

VisionPanel::Picture& VisionPanel::offered(const QString& name) {
  if (!pictures_.contains(name)) {
    QAction* action = choices_->addAction(name);
    action->setCheckable(true);
    action->setChecked(true);
    connect(action, &QAction::toggled, this, [this, name](bool on) {
      pictures_[name].shown = on;
      update();
    });
  }
  return pictures_[name];
}

void VisionPanel::clear() {
  pictures_.clear();
  choices_->clear();
  update();
}

const QImage& VisionPanel::image_of(const Picture& picture) const {
  return then_s_ ? picture.then : picture.image;
}

QString VisionPanel::notice() const {
  const QStringList names = shown();
  if (pictures_.empty()) return tr("No camera has seen anything yet");
  if (names.isEmpty()) return tr("No picture is chosen");
  if (!then_s_) return {};
  const bool has_some = std::any_of(
      names.begin(), names.end(), [this](const QString& name) { return !picture(name).isNull(); });
  return has_some ? QString()
                  : tr("The pictures of %1 s are not stored: they are while this window is shown")
                        .arg(*then_s_, 0, 'f', 2);
}

QStringList VisionPanel::pictures() const {
  QStringList names;
  for (const auto& [name, picture] : pictures_) {
    names << name;
  }
  return names;
}

QStringList VisionPanel::shown() const {
  QStringList names;
  for (const auto& [name, picture] : pictures_) {
    if (picture.shown) {
      names << name;
    }
  }
  return names;
}

QImage VisionPanel::picture(const QString& name) const {
  const auto found = pictures_.find(name);
  return found == pictures_.end() ? QImage() : image_of(found->second);
}

// Includes the mean colour, for users who do not see the picture.
Figures VisionPanel::figures() const {
  Figures figures{{tr("picture"), tr("width [px]"), tr("height [px]"), tr("mean colour")}, {}};
  for (const auto& [name, picture] : pictures_) {
    const QImage& image = image_of(picture);
    const QImage mean = image.isNull()
                            ? image
                            : image.scaled(1, 1, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    figures.rows.push_back({name, QString::number(image.width()), QString::number(image.height()),
                            mean.isNull() ? QString() : mean.pixelColor(0, 0).name()});
  }
  return figures;
}

void VisionPanel::set_shown(const QString& name, bool shown) {
  for (QAction* action : choices_->actions()) {
    if (action->text() == name) {
      action->setChecked(shown);
    }
  }
}

QRect VisionPanel::cell(int n, int count) const {
  // The number of columns that makes the cells least narrow or flat.
  const QRect area = rect().adjusted(0, choose_->height() + 2, 0, 0);
  int columns = 1;
  int best = 0;
  for (int tried = 1; tried <= count; ++tried) {
    const int rows = (count + tried - 1) / tried;
    if (const int side = std::min(area.width() / tried, area.height() / rows); side > best) {
      best = side;
      columns = tried;
    }
  }
  const int rows = (count + columns - 1) / columns;
  const int width = area.width() / columns;
  const int height = area.height() / rows;
  return {area.left() + n % columns * width, area.top() + n / columns * height, width, height};
}

void VisionPanel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const QStringList names = shown();
  if (const QString words = notice(); !words.isEmpty()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, words);
    return;
  }
  const int line = fontMetrics().height();
  for (int n = 0; n < names.size(); ++n) {
    const QRect whole = cell(n, static_cast<int>(names.size())).adjusted(3, 0, -3, -3);
    const QImage image = picture(names[n]);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QRect(whole.topLeft(), QSize(whole.width(), line)), Qt::AlignHCenter,
                     fontMetrics().elidedText(names[n], Qt::ElideLeft, whole.width()));
    const QRect room = whole.adjusted(0, line + 1, 0, 0);
    if (image.isNull()) {
      painter.drawText(room, Qt::AlignCenter | Qt::TextWordWrap, tr("not stored"));
      continue;
    }
    const QSize size = image.size().scaled(room.size(), Qt::KeepAspectRatio);
    painter.drawImage(QRect(room.left() + (room.width() - size.width()) / 2, room.top(),
                            size.width(), size.height()),
                      image);
  }
}

void VisionPanel::contextMenuEvent(QContextMenuEvent* event) {
  const QStringList names = shown();
  for (int n = 0; n < names.size(); ++n) {
    if (cell(n, static_cast<int>(names.size())).contains(event->pos())) {
      const QString name = names[n];
      const QImage image = picture(name);  // a copy, for as long as the dialog is open
      QMenu menu;
      QAction* save = menu.addAction(tr("Save picture..."), this, [&] {
        const QString file =
            QFileDialog::getSaveFileName(this, tr("Save picture"), {}, tr("Pictures (*.png)"));
        if (const QString why = file.isEmpty() ? QString() : save_picture(image, file);
            !why.isEmpty()) {
          QMessageBox::warning(this, tr("Save picture"), why);
        }
      });
      save->setEnabled(!image.isNull());
      menu.addActions(actions());
      menu.exec(event->globalPos());
      return;
    }
  }
}

}  // namespace elsie::desktop
