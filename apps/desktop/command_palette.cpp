#include "command_palette.h"

#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "look/theme.h"

namespace elsie::desktop {
namespace {

constexpr int kKeyRole = Qt::UserRole;
constexpr std::size_t kMost = 200;  // more lines help nobody

/// Draws a line's key at its right end.
class LineDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const QSize usual = QStyledItemDelegate::sizeHint(option, index);
    return {usual.width(), option.fontMetrics.height() * 7 / 4};
  }
  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    QStyledItemDelegate::paint(painter, option, index);
    const bool is_chosen = option.state & QStyle::State_Selected;
    painter->save();
    painter->setPen(is_chosen ? option.palette.color(QPalette::HighlightedText)
                              : quiet(option.palette));
    painter->drawText(option.rect.adjusted(0, 0, -option.fontMetrics.height() / 2, 0),
                      Qt::AlignRight | Qt::AlignVCenter, index.data(kKeyRole).toString());
    painter->restore();
  }
};

/// How well the title or another name of the offer fits.
std::optional<int> fit_of(const QString& typed, const Offer& offer) {
  std::optional<int> best = fit(typed, offer.title);
  for (const QString& name : offer.also) best = std::max(best, fit(typed, name));
  return best;
}

bool begins_word(const QString& title, qsizetype at) {
  return at == 0 || !title[at - 1].isLetterOrNumber();
}

}  // namespace

std::optional<int> fit(const QString& typed, const QString& title) {
  if (title.startsWith(typed, Qt::CaseInsensitive)) {
    return 1000 - static_cast<int>(title.size());
  }
  if (const qsizetype at = title.indexOf(typed, 0, Qt::CaseInsensitive); at >= 0) {
    return (begins_word(title, at) ? 800 : 600) - static_cast<int>(at);
  }
  int score = 0;
  qsizetype last = -1;
  for (const QChar letter : typed) {
    if (letter.isSpace()) {
      continue;
    }
    // The beginning of a word is a better place than the next letter in the middle of one.
    qsizetype at = title.indexOf(letter, last + 1, Qt::CaseInsensitive);
    for (qsizetype next = at; next >= 0 && at != last + 1;
         next = title.indexOf(letter, next + 1, Qt::CaseInsensitive)) {
      if (begins_word(title, next)) {
        at = next;
        break;
      }
    }
    if (at < 0) {
      return std::nullopt;
    }
    score += begins_word(title, at) ? 20 : at == last + 1 ? 15 : 0;
    score -= static_cast<int>(std::min<qsizetype>(at - last, 10));
    last = at;
  }
  return score;
}

CommandPalette::CommandPalette(std::vector<Offer> offers,
                               std::function<std::vector<Offer>(const QString&)> typed_offers,
                               QWidget* parent)
    : QDialog(parent), offers_(std::move(offers)), typed_offers_(std::move(typed_offers)) {
  setObjectName("commands_dialog");
  setWindowTitle(tr("Commands"));
  auto* column = new QVBoxLayout(this);
  wish_ = new QLineEdit;
  wish_->setObjectName("wish");
  wish_->setPlaceholderText(tr("Type some letters of a command, a robot, a file; or speed 2"));
  wish_->setAccessibleName(tr("Letters of the command"));
  wish_->installEventFilter(this);
  column->addWidget(wish_);
  list_ = new QListWidget;
  list_->setObjectName("fitting");
  list_->setAccessibleName(tr("Commands that fit"));
  list_->setItemDelegate(new LineDelegate(list_));
  list_->setUniformItemSizes(true);
  list_->setFocusPolicy(Qt::NoFocus);
  column->addWidget(list_, 1);
  auto* help = new QLabel(tr("Enter does it, Up and Down choose, Esc closes"));
  help->setForegroundRole(QPalette::PlaceholderText);
  column->addWidget(help);
  connect(wish_, &QLineEdit::textChanged, this, &CommandPalette::list_fitting);
  connect(list_, &QListWidget::itemClicked, this, &CommandPalette::choose);
  resize(70 * fontMetrics().averageCharWidth(), 28 * fontMetrics().height());
  list_fitting();
}

void CommandPalette::list_fitting() {
  const QString typed = wish_->text().simplified();
  std::vector<std::pair<int, Offer>> fitting;
  for (const Offer& each : offers_) {
    if (const auto score = fit_of(typed, each)) fitting.emplace_back(*score, each);
  }
  if (typed.isEmpty()) {
    std::stable_sort(fitting.begin(), fitting.end(), [](const auto& a, const auto& b) {
      return a.second.title.localeAwareCompare(b.second.title) < 0;
    });
  } else {
    std::stable_sort(fitting.begin(), fitting.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
  }
  listed_ = typed_offers_(typed);
  for (auto& [score, each] : fitting) {
    if (listed_.size() < kMost) listed_.push_back(std::move(each));
  }
  list_->clear();
  QPixmap blank(list_->iconSize().isValid() ? list_->iconSize() : QSize(16, 16));
  blank.fill(Qt::transparent);  // so that titles without an icon are below the others
  for (const Offer& each : listed_) {
    auto* item =
        new QListWidgetItem(each.icon.isNull() ? QIcon(blank) : each.icon, each.title, list_);
    item->setData(kKeyRole, each.key);
  }
  if (listed_.empty()) {
    auto* none = new QListWidgetItem(tr("Nothing fits '%1'.").arg(typed), list_);
    none->setFlags(Qt::NoItemFlags);
  } else {
    list_->setCurrentRow(0);
  }
}

void CommandPalette::choose() {
  const auto row = static_cast<std::size_t>(std::max(0, list_->currentRow()));
  if (row < listed_.size()) {
    // After the dialog has gone: what is done may open one of its own.
    QTimer::singleShot(0, parent(), listed_[row].does);
    accept();
  }
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress) {
    return QDialog::eventFilter(watched, event);
  }
  const int key = static_cast<QKeyEvent*>(event)->key();
  const int rows = static_cast<int>(listed_.size());
  const int step = key == Qt::Key_Down       ? 1
                   : key == Qt::Key_Up       ? -1
                   : key == Qt::Key_PageDown ? 10
                   : key == Qt::Key_PageUp   ? -10
                                             : 0;
  if (key == Qt::Key_Return || key == Qt::Key_Enter) {
    choose();
    return true;
  }
  if (step != 0 && rows > 0) {
    const int next = list_->currentRow() + step;
    list_->setCurrentRow(std::abs(step) == 1 ? (next + rows) % rows
                                             : std::clamp(next, 0, rows - 1));
    return true;
  }
  return QDialog::eventFilter(watched, event);
}

}  // namespace elsie::desktop
