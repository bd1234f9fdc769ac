#include "start_page.h"

#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QPixmap>
#include <QPushButton>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QStyledItemDelegate>
#include <QTextLayout>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "engine/elements.h"
#include "look/icons.h"
#include "look/theme.h"
#include "paint/boxes.h"

namespace elsie::desktop {
namespace {

constexpr int kFile = Qt::UserRole;
constexpr int kAbout = Qt::UserRole + 1;
constexpr int kDelay_ms = 300;
constexpr int kNarrowest_em = 36;  // of a card
constexpr int kLines = 4;          // of the sentence on a card
/// The examples to begin with.
const QStringList kFirst{"four_resources", "ten_robots", "clutter", "maze",   "flock",
                         "escape",         "patrol",     "fetch",   "pushing"};

QFont sized(QFont font, double times, QFont::Weight weight) {
  font.setPointSizeF(times * font.pointSizeF());
  font.setWeight(weight);
  return font;
}

/// The text in so many lines, with dots if it is longer.
void draw_lines(QPainter* painter, const QRectF& room, const QString& text, int lines) {
  QTextLayout layout(text, painter->font());
  layout.beginLayout();
  const QFontMetricsF metrics(painter->font());
  double y = room.top();
  for (int i = 0; i < lines; ++i) {
    QTextLine line = layout.createLine();
    if (!line.isValid()) break;
    line.setLineWidth(room.width());
    const bool is_last = i == lines - 1;
    const QString part =
        is_last ? metrics.elidedText(text.mid(line.textStart()), Qt::ElideRight, room.width())
                : text.mid(line.textStart(), line.textLength());
    painter->drawText(QPointF(room.left(), y + metrics.ascent()), part);
    y += metrics.lineSpacing();
  }
  layout.endLayout();
}

/// The plate behind an entry: lit under the pointer, with a rim where the keyboard is.
void draw_plate(QPainter* painter, const QStyleOptionViewItem& option, const QRect& rect,
                bool is_raised) {
  const bool is_under = option.state & QStyle::State_MouseOver;
  const bool has_keys =
      (option.state & QStyle::State_HasFocus) && (option.state & QStyle::State_KeyboardFocusChange);
  const QPalette& palette = option.palette;
  const bool is_lit = is_under || has_keys;
  painter->setPen(is_lit      ? QPen(palette.color(QPalette::Highlight), 1.5)
                  : is_raised ? QPen(line_colour(palette))
                              : QPen(Qt::NoPen));
  painter->setBrush(palette.color(is_raised || is_lit ? QPalette::Window : QPalette::Base));
  painter->drawRoundedRect(QRectF(rect).adjusted(1, 1, -1, -1), 6, 6);
}

/// A card: the picture of a world, its title, and what it is about.
class CardDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  static int height(const QFontMetrics& metrics, int width) {
    return picture_height(width) + metrics.lineSpacing() * (kLines + 1) + 5 * metrics.height() / 2;
  }
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const override {
    const auto* list = qobject_cast<const QListView*>(option.widget);
    return list ? list->gridSize() : QSize();
  }
  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setRenderHint(QPainter::SmoothPixmapTransform);
    const int gap = option.fontMetrics.height() / 2;
    const QRect card = option.rect.adjusted(0, 0, -gap, -gap);
    draw_plate(painter, option, card, true);
    const QRect frame(card.left() + gap, card.top() + gap, card.width() - 2 * gap,
                      picture_height(option.rect.width()));
    const QPixmap picture = index.data(Qt::DecorationRole)
                                .value<QIcon>()
                                .pixmap(QSize(StartPage::kPicture_px, StartPage::kPicture_px));
    if (is_dark(option.palette)) painter->setOpacity(0.8);  // paper that does not glare
    painter->setPen(Qt::NoPen);
    painter->setBrush(picture.isNull() ? option.palette.color(QPalette::AlternateBase)
                                       : QColor(0xfa, 0xfa, 0xf7));
    painter->drawRoundedRect(frame, 3, 3);
    if (!picture.isNull()) {
      const QSizeF size = (QSizeF(picture.size()) / picture.devicePixelRatio())
                              .scaled(frame.size(), Qt::KeepAspectRatio);
      QRectF place(QPointF(), size);
      place.moveCenter(QRectF(frame).center());
      painter->drawPixmap(place, picture, QRectF(picture.rect()));
    }
    painter->setOpacity(1.0);
    QRect text(frame.left(), frame.bottom() + gap, frame.width(),
               card.bottom() - frame.bottom() - gap);
    painter->setFont(sized(option.font, 1.05, QFont::DemiBold));
    painter->setPen(option.palette.color(QPalette::Text));
    painter->drawText(
        text, Qt::AlignTop | Qt::AlignLeft,
        painter->fontMetrics().elidedText(index.data().toString(), Qt::ElideRight, text.width()));
    text.setTop(text.top() + painter->fontMetrics().lineSpacing() + gap / 2);
    painter->setFont(option.font);
    painter->setPen(quiet(option.palette));
    draw_lines(painter, text, index.data(kAbout).toString(), kLines);
    painter->restore();
  }

 private:
  static int picture_height(int width) { return width * 6 / 10; }
};

/// The name of a file, and its folder below it.
class FileDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const override {
    return {0, option.fontMetrics.lineSpacing() * 3};
  }
  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    draw_plate(painter, option, option.rect, false);
    const int gap = option.fontMetrics.height() / 2;
    const QRect room = option.rect.adjusted(gap, gap, -gap, -gap);
    const QFileInfo file(index.data(kFile).toString());
    painter->setPen(option.palette.color(QPalette::Text));
    painter->setFont(sized(option.font, 1.0, QFont::DemiBold));
    painter->drawText(
        room, Qt::AlignTop | Qt::AlignLeft,
        painter->fontMetrics().elidedText(file.fileName(), Qt::ElideMiddle, room.width()));
    painter->setFont(option.font);
    painter->setPen(quiet(option.palette));
    painter->drawText(room, Qt::AlignBottom | Qt::AlignLeft,
                      option.fontMetrics.elidedText(file.path(), Qt::ElideMiddle, room.width()));
    painter->restore();
  }
};

/// The first sentence of the comment at the top of a world file, or its description.
QString about(const QString& file) {
  QFile opened(file);
  if (!opened.open(QIODevice::ReadOnly)) {
    return {};
  }
  const QString text = QString::fromUtf8(opened.read(2000));
  static const QRegularExpression comment("<!--\\s*(.*?)\\s*-->",
                                          QRegularExpression::DotMatchesEverythingOption);
  const QString first = comment.match(text).captured(1).simplified().section(". ", 0, 0);
  return first.isEmpty() || first.endsWith('.') ? first : first + '.';
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
  setBackgroundRole(QPalette::Base);
  setAutoFillBackground(true);
  const int em = fontMetrics().averageCharWidth();
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(5 * em, 4 * em, 3 * em, em);
  outer->setSpacing(em);
  auto* title = new QLabel(tr("Elsie"));
  title->setFont(sized(font(), 2.4, QFont::Light));
  outer->addWidget(title);
  auto* motto = new QLabel(
      tr("Behaviour-based robots: small behaviours side by side, and a coordinator that decides."));
  motto->setForegroundRole(QPalette::PlaceholderText);
  motto->setWordWrap(true);
  outer->addWidget(motto);
  outer->addSpacing(em);

  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(em);
  const auto button = [&](const char* name, const char* drawing, const QString& text) {
    auto* made = new QPushButton(icon(drawing), text);
    made->setObjectName(name);
    made->setMinimumHeight(fontMetrics().height() * 2);
    made->setAutoDefault(true);  // Enter presses it, as in a dialog
    buttons->addWidget(made);
    return made;
  };
  auto* fresh = button("new_world", "new", tr("&New world"));
  auto* empty = button("empty_world", "world", tr("E&mpty world"));
  fresh->setToolTip(tr("A room in which a robot collects four resources"));
  empty->setToolTip(tr("Four walls, 5 m by 5 m, and nothing in them"));
  auto* browse = button("open_world", "open", tr("&Open..."));
  buttons->addStretch(1);
  outer->addLayout(buttons);
  outer->addSpacing(em);
  connect(fresh, &QPushButton::clicked, this, &StartPage::new_wished);
  connect(empty, &QPushButton::clicked, this, &StartPage::empty_wished);
  connect(browse, &QPushButton::clicked, this, &StartPage::browse_wished);

  auto* lists = new QHBoxLayout;
  lists->setSpacing(3 * em);
  outer->addLayout(lists, 1);
  const auto list = [&](const char* name, const QString& heading, int stretch) {
    auto* whole = new QWidget;
    auto* column = new QVBoxLayout(whole);
    column->setContentsMargins(0, 0, 0, 0);
    auto* label = new QLabel(heading);
    label->setFont(sized(font(), 1.15, QFont::DemiBold));
    auto* made = new QListWidget;
    made->setObjectName(name);
    made->setFrameShape(QFrame::NoFrame);
    made->setMouseTracking(true);  // what is under the pointer is lit
    made->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    made->viewport()->setCursor(Qt::PointingHandCursor);
    made->viewport()->setAutoFillBackground(false);
    label->setBuddy(made);
    column->addWidget(label);
    column->addWidget(made, 1);
    lists->addWidget(whole, stretch);
    const auto open = [this](const QListWidgetItem* item) {
      // A double click comes after the click that has opened the world.
      if (isVisible()) Q_EMIT open_wished(item->data(kFile).toString());
    };
    connect(made, &QListWidget::itemClicked, this, open);
    connect(made, &QListWidget::itemActivated, this, open);
    return made;
  };
  examples_ = list("examples", tr("E&xamples"), 3);
  examples_->setItemDelegate(new CardDelegate(examples_));
  examples_->setViewMode(QListView::IconMode);
  examples_->setMovement(QListView::Static);
  examples_->setResizeMode(QListView::Adjust);
  examples_->viewport()->installEventFilter(this);
  recent_ = list("recent", tr("Recent&ly opened"), 1);
  recent_->setItemDelegate(new FileDelegate(recent_));
  recent_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  drawing_.setStandardOutputFile(QProcess::nullDevice());
  drawing_.setStandardErrorFile(QProcess::nullDevice());
  connect(&drawing_, &QProcess::finished, this, [this] {
    show_picture(next_++);  // a world that cannot be drawn has none
    draw_next();
  });
  const QDir folder(worlds);
  QStringList names =
      worlds.isEmpty() ? QStringList() : folder.entryList({"*.xml"}, QDir::Files, QDir::Name);
  std::stable_sort(names.begin(), names.end(), [](const QString& a, const QString& b) {
    const auto place = [](const QString& name) {
      const auto at = kFirst.indexOf(QString(name).remove(".xml"));
      return at < 0 ? kFirst.size() : at;
    };
    return place(a) < place(b);
  });
  for (const QString& name : std::as_const(names)) {
    QString words = QString(name).remove(".xml").replace('_', ' ');
    words[0] = words[0].toUpper();
    auto* item = new QListWidgetItem(words, examples_);
    item->setData(kFile, folder.filePath(name));
    item->setData(kAbout, about(folder.filePath(name)));
    item->setData(Qt::AccessibleDescriptionRole, item->data(kAbout));
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
    const QString world = examples_->item(next_)->data(kFile).toString();
    drawing_.start(elsie_, {"picture", world, "--bare", "--output", picture_of(world), "--width",
                            QString::number(kPicture_px)});
  }
}

bool StartPage::show_picture(int example) {
  QListWidgetItem* item = examples_->item(example);
  const QPixmap picture(picture_of(item->data(kFile).toString()));
  if (!picture.isNull()) item->setIcon(picture);
  return !picture.isNull();
}

void StartPage::show_recent(const QStringList& files) {
  recent_->clear();
  for (const QString& file : files) {
    auto* item = new QListWidgetItem(file, recent_);
    item->setData(kFile, file);
    item->setToolTip(file);
  }
  recent_->parentWidget()->setVisible(!files.isEmpty());
}

// As many cards in a row as have room, all of one width.
bool StartPage::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) {
    const int width = examples_->viewport()->width() - 1;
    const int narrowest = kNarrowest_em * fontMetrics().averageCharWidth();
    const int card = width / std::max(1, width / narrowest);
    examples_->setGridSize({card, CardDelegate::height(fontMetrics(), card)});
  }
  return QWidget::eventFilter(watched, event);
}

QString empty_world() {
  return R"(<?xml version="1.0" encoding="UTF-8"?>
<world format="1" name="my world">
  <arena length="5" width="5"/>
  <limits time="300"/>
</world>
)";
}

}  // namespace elsie::desktop
