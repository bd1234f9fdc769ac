#include "start_page.h"

#include <QCryptographicHash>
#include <QDateTime>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPixmap>
#include <QPushButton>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTimer>
#include <QVBoxLayout>
#include <utility>

#include "engine/elements.h"
#include "paint/boxes.h"

namespace elsie::desktop {
namespace {

constexpr int kIcon_em = 22;
constexpr int kDelay_ms = 300;

/// The first sentence of the comment at the top of a world file, or its description.
QString about(const QString& file) {
  QFile opened(file);
  if (!opened.open(QIODevice::ReadOnly)) {
    return {};
  }
  const QString text = QString::fromUtf8(opened.read(2000));
  static const QRegularExpression comment("<!--\\s*(.*?)\\s*-->",
                                          QRegularExpression::DotMatchesEverythingOption);
  return comment.match(text).captured(1).simplified().section(". ", 0, 0);
}

/// The file of the picture of a world in its present state on disk.
QString picture_of(const QString& world) {
  const QFileInfo file(world);
  const QString which = file.absoluteFilePath() + u'\n' +
                        QString::number(file.lastModified().toMSecsSinceEpoch()) + u'\n' +
                        QString::number(file.size());
  const QString folder =
      QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + "/pictures";
  QDir().mkpath(folder);
  return folder + '/' + QCryptographicHash::hash(which.toUtf8(), QCryptographicHash::Sha1).toHex() +
         ".png";
}

}  // namespace

StartPage::StartPage(const QString& worlds, QString elsie, QWidget* parent)
    : QWidget(parent), elsie_(std::move(elsie)) {
  setObjectName("start_page");
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(24, 20, 24, 20);
  auto* title = new QLabel(tr("Elsie"));
  QFont font = title->font();
  font.setPointSizeF(1.8 * font.pointSizeF());
  title->setFont(font);
  outer->addWidget(title);
  outer->addWidget(new QLabel(tr(
      "Behaviour-based robots: small behaviours side by side, and a coordinator that decides.")));

  auto* buttons = new QHBoxLayout;
  auto* fresh = new QPushButton(tr("&New world..."));
  fresh->setObjectName("new_world");
  auto* empty = new QPushButton(tr("E&mpty world"));
  empty->setObjectName("empty_world");
  empty->setToolTip(tr("Four walls, 5 m by 5 m, and nothing in them"));
  auto* browse = new QPushButton(tr("&Open..."));
  browse->setObjectName("open_world");
  buttons->addWidget(fresh);
  buttons->addWidget(empty);
  buttons->addWidget(browse);
  buttons->addStretch(1);
  outer->addLayout(buttons);
  connect(fresh, &QPushButton::clicked, this, &StartPage::new_wished);
  connect(empty, &QPushButton::clicked, this, &StartPage::empty_wished);
  connect(browse, &QPushButton::clicked, this, &StartPage::browse_wished);

  auto* lists = new QHBoxLayout;
  outer->addLayout(lists, 1);
  const auto list = [&](const char* name, const QString& heading, int stretch) {
    auto* column = new QVBoxLayout;
    auto* label = new QLabel(heading);
    auto* made = new QListWidget;
    made->setObjectName(name);
    made->setWordWrap(true);
    label->setBuddy(made);
    column->addWidget(label);
    column->addWidget(made, 1);
    lists->addLayout(column, stretch);
    connect(made, &QListWidget::itemActivated, this, [this](const QListWidgetItem* item) {
      Q_EMIT open_wished(item->data(Qt::UserRole).toString());
    });
    return made;
  };
  examples_ = list("examples", tr("E&xamples"), 3);
  examples_->setIconSize(QSize(kIcon_em, kIcon_em * 3 / 4) * fontMetrics().averageCharWidth());
  recent_ = list("recent", tr("Recent&ly opened"), 2);
  drawing_.setStandardOutputFile(QProcess::nullDevice());
  drawing_.setStandardErrorFile(QProcess::nullDevice());
  connect(&drawing_, &QProcess::finished, this, [this] {
    show_picture(next_++);  // a world that cannot be drawn has none
    draw_next();
  });
  const QDir folder(worlds);
  for (const QString& name :
       worlds.isEmpty() ? QStringList() : folder.entryList({"*.xml"}, QDir::Files, QDir::Name)) {
    const QString what = about(folder.filePath(name));
    auto* item = new QListWidgetItem(
        QString(name).remove(".xml").replace('_', ' ') + (what.isEmpty() ? QString() : ": " + what),
        examples_);
    item->setData(Qt::UserRole, folder.filePath(name));
    item->setToolTip(folder.filePath(name));
  }
}

StartPage::~StartPage() {
  drawing_.disconnect(this);
  drawing_.kill();
  drawing_.waitForFinished(1000);
}

// Draws nothing for a page that a world replaces at once.
void StartPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  QTimer::singleShot(kDelay_ms, this, &StartPage::draw_next);
}

// One at a time, so that the machine stays responsive.
void StartPage::draw_next() {
  if (drawing_.state() != QProcess::NotRunning) {
    return;
  }
  while (next_ < examples_->count() && show_picture(next_)) {
    ++next_;
  }
  if (isVisible() && next_ < examples_->count()) {
    const QString world = examples_->item(next_)->data(Qt::UserRole).toString();
    drawing_.start(elsie_, {"picture", world, "--bare", "--output", picture_of(world), "--width",
                            QString::number(kPicture_px)});
  }
}

bool StartPage::show_picture(int example) {
  QListWidgetItem* item = examples_->item(example);
  const QPixmap picture(picture_of(item->data(Qt::UserRole).toString()));
  if (!picture.isNull()) item->setIcon(picture);
  return !picture.isNull();
}

void StartPage::show_recent(const QStringList& files) {
  recent_->clear();
  for (const QString& file : files) {
    auto* item = new QListWidgetItem(file, recent_);
    item->setData(Qt::UserRole, file);
  }
}

QString empty_world() {
  return R"(<?xml version="1.0" encoding="UTF-8"?>
<world format="1" name="my world">
  <arena length="5" width="5"/>
  <limits time="300"/>
</world>
)";
}

QString ask_for_new_world(QWidget* parent) {
  QDialog dialog(parent);
  dialog.setObjectName("new_world_dialog");
  dialog.setWindowTitle(StartPage::tr("New world"));
  auto* form = new QFormLayout(&dialog);
  auto* name = new QLineEdit(StartPage::tr("my world"));
  name->setObjectName("name");
  const auto length = [&](const char* object) {
    auto* box = new NumberBox;
    box->setObjectName(object);
    box->setRange(0.5, 1000.0);
    box->setDecimals(2);
    box->setValue(5.0);
    box->setSuffix(" m");
    return box;
  };
  auto* along = length("length");
  auto* across = length("width");
  auto* boxes = new CountBox;
  boxes->setObjectName("boxes");
  boxes->setRange(0, 12);
  boxes->setValue(4);
  auto* resources = new CountBox;
  resources->setObjectName("resources");
  resources->setRange(0, 4);
  form->addRow(StartPage::tr("&Name"), name);
  form->addRow(StartPage::tr("&Length (x)"), along);
  form->addRow(StartPage::tr("&Width (y)"), across);
  form->addRow(StartPage::tr("&Boxes, in a ring"), boxes);
  form->addRow(StartPage::tr("&Resources, in the corners"), resources);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  buttons->setObjectName("buttons");
  form->addRow(buttons);
  QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
  QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  if (dialog.exec() != QDialog::Accepted) {
    return {};
  }
  const auto number = [](double value) {
    return QString::number(std::round(100.0 * value) / 100.0);
  };
  QString text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<world format=\"1\" name=\"" +
                 escaped(name->text()) + "\">\n  <arena length=\"" + number(along->value()) +
                 "\" width=\"" + number(across->value()) + "\"/>\n";
  if (boxes->value() > 0) {
    text += "  <obstacles>\n";
    const double radius = 0.3 * std::min(along->value(), across->value());
    for (int i = 0; i < boxes->value(); ++i) {
      const double angle = 2.0 * M_PI * (i + 0.5) / boxes->value();
      text += "    <static_box x=\"" + number(radius * std::cos(angle)) + "\" y=\"" +
              number(radius * std::sin(angle)) + "\"/>\n";
    }
    text += "  </obstacles>\n";
  }
  if (resources->value() > 0) {
    text += "  <resources>\n";
    for (int i = 0; i < resources->value(); ++i) {
      const double x = (i % 2 == 0 ? 0.4 : -0.4) * along->value(),
                   y = (i < 2 ? 0.4 : -0.4) * across->value();
      text += "    <resource x=\"" + number(x) + "\" y=\"" + number(y) + "\"/>\n";
    }
    text += "  </resources>\n";
  }
  return text + "  <limits time=\"300\"/>\n</world>\n";
}

}  // namespace elsie::desktop
