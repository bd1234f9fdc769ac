#include "world/world_tree.h"

#include <QContextMenuEvent>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollBar>
#include <QStyledItemDelegate>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <functional>
#include <utility>

#include "engine/workbench.h"
#include "look/icons.h"
#include "look/theme.h"
#include "paint/padlock.h"
#include "world/words.h"

namespace elsie::desktop {
namespace {

constexpr int kPathRole = Qt::UserRole;
constexpr int kIsList = Qt::UserRole + 1;
constexpr int kName = Qt::UserRole + 2;  // in world files
constexpr int kKind = Qt::UserRole + 3;  // grey, after the title
constexpr int kNote = Qt::UserRole + 4;  // at the right end

/// Draws a row as icon, title, its kind in grey, and a note at the right end.
class RowDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    return {QStyledItemDelegate::sizeHint(option, index).width(),
            option.fontMetrics.height() * 3 / 2};
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    QStyleOptionViewItem row = option;
    initStyleOption(&row, index);
    const QString kind = index.data(kKind).toString();
    const QString note = index.data(kNote).toString();
    row.text = index.data(kTitle).toString();
    const QStyle* style = row.widget->style();
    QRect room = style->subElementRect(QStyle::SE_ItemViewItemText, &row, row.widget);
    const QFontMetrics metrics(row.font);
    const int gap = metrics.averageCharWidth();
    room.setRight(option.rect.right() - gap);
    const int title = metrics.horizontalAdvance(row.text);
    const int note_width = note.isEmpty() ? 0 : metrics.horizontalAdvance(note) + gap;
    row.text = metrics.elidedText(row.text, Qt::ElideRight, room.width() - note_width);
    style->drawControl(QStyle::CE_ItemViewItem, &row, painter, row.widget);
    const bool is_chosen = row.state & QStyle::State_Selected;
    painter->save();
    painter->setPen(is_chosen ? row.palette.color(QPalette::HighlightedText) : quiet(row.palette));
    painter->drawText(room, Qt::AlignRight | Qt::AlignVCenter, note);
    room.adjust(title + 2 * gap, 0, -note_width, 0);
    if (room.width() > 4 * gap) {
      painter->drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                        metrics.elidedText(kind, Qt::ElideRight, room.width()));
    }
    painter->restore();
  }

  static constexpr int kTitle = Qt::UserRole + 5;
};

constexpr int kMostGiven = 12;

/// What is written in the element, a line for each.
QString detail_of(const Json& element) {
  QStringList parts;
  for (const auto& [name, value] : attributes_of(element).items()) {
    const bool is_title = name == "id" || (name == "name" && written(value) == title_of(element));
    if (!is_title && parts.size() < kMostGiven) {
      parts << QString::fromStdString(name) + '=' + written(value);
    }
  }
  return parts.join('\n');
}

/// The drawing of the element, or of its kind; none for a list.
QIcon icon_of(const ElementPlace& place) {
  if (!place.list.isEmpty()) return {};
  if (place.path.isEmpty()) return icon("world");
  const QString name = name_of(*place.element);
  if (QIcon own = icon(name); !own.isNull()) return own;
  static const QRegularExpression kind_in_path("(?:^|/)([a-z_]+)(?:\\[[^/]*)?$");
  const QString kind = kind_in_path.match(place.path).captured(1);
  static const QHash<QString, QString> others{
      {"obstacle", "box"}, {"arena", "world"}, {"floor", "patch"}};
  const QIcon of_kind = icon(others.value(kind, kind));
  return of_kind.isNull() ? icon("part") : of_kind;
}

/// The title of an element: "avoid (avoid_obstacle)" if it differs from the name.
QString label_of(const Json& element) {
  const QString title = title_of(element), name = name_of(element);
  return title == name ? name : title + " (" + name + ')';
}

/// The name of the list in a row: "sensors".
QString list_of_row(const QTreeWidgetItem& row) { return row.data(0, kName).toString(); }

QString team_of(const Json& robot) {
  const QString team = attribute(robot, "team");
  return team.isEmpty() ? "red" : team;
}

}  // namespace

QStringList teams_of(const Json& world) {
  QStringList teams;
  visit(world, [&](const ElementPlace& place) {
    const QString name = name_of(*place.element);
    const QString team = name == "team"    ? attribute(*place.element, "id")
                         : name == "robot" ? team_of(*place.element)
                                           : QString();
    if (!team.isEmpty() && !teams.contains(team)) {
      teams << team;
    }
    return name != "robot";
  });
  return teams;
}

WorldTree::WorldTree(Workbench& workbench, QString team, QWidget* parent)
    : QWidget(parent), workbench_(workbench), team_(std::move(team)) {
  setObjectName(team_.isEmpty() ? "world_tree" : "team_tree_" + team_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  filter_ = new QLineEdit;
  filter_->setObjectName("filter");
  filter_->setPlaceholderText(tr("Filter"));
  filter_->setClearButtonEnabled(true);
  filter_->setAccessibleName(tr("Filter of the tree"));
  column->addWidget(filter_);
  tree_ = new QTreeWidget;
  tree_->setObjectName("tree");
  tree_->setAccessibleName(team_.isEmpty() ? tr("World") : tr("Team %1").arg(team_));
  tree_->setHeaderHidden(true);
  tree_->setItemDelegate(new RowDelegate(tree_));
  tree_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  tree_->viewport()->installEventFilter(this);
  setFocusProxy(tree_);
  tree_->setUniformRowHeights(true);
  tree_->setIndentation(fontMetrics().averageCharWidth() * 3 / 2);
  tree_->setFrameShape(QFrame::NoFrame);
  column->addWidget(tree_, 1);
  if (!team_.isEmpty()) {
    make_team_buttons();
  }
  connect(filter_, &QLineEdit::textChanged, this, &WorldTree::filter);
  connect(tree_, &QTreeWidget::itemSelectionChanged, this, [this] {
    if (!is_showing_) {
      chosen_ = selection();
      Q_EMIT selected(chosen_);
      const QList<QTreeWidgetItem*> rows = tree_->selectedItems();
      if (rows.size() == 1 && rows.front()->data(0, kIsList).toBool()) {
        Q_EMIT list_selected(rows.front()->data(0, kPathRole).toString(),
                             list_of_row(*rows.front()));
      }
    }
  });
  // Not itemActivated, which comes with a single click on some desktops.
  connect(tree_, &QTreeWidget::itemDoubleClicked, this, &WorldTree::wish_edit);
  tree_->installEventFilter(this);
}

// The event of the menu key goes to the tree, that of the mouse to what it shows.
bool WorldTree::eventFilter(QObject* watched, QEvent* event) {
  if (watched == tree_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    const bool is_enter = key == Qt::Key_Return || key == Qt::Key_Enter;
    if (is_enter && tree_->currentItem()) {
      wish_edit(tree_->currentItem());
      return true;
    }
  }
  if (event->type() == QEvent::ContextMenu) {
    const auto& wish = *static_cast<QContextMenuEvent*>(event);
    const bool is_by_mouse = wish.reason() == QContextMenuEvent::Mouse;
    if (watched == (is_by_mouse ? tree_->viewport() : static_cast<QObject*>(tree_))) {
      wish_menu(wish);
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

// A right click on an element opens its editor; on a list, its menu; on an empty place, the menu of
// the floor; on a network that has learned, its own menu, which clears it. The menu key opens the
// menu of the selected element or list.
void WorldTree::wish_menu(const QContextMenuEvent& wish) {
  const bool is_by_mouse = wish.reason() == QContextMenuEvent::Mouse;
  const QTreeWidgetItem* item = is_by_mouse ? tree_->itemAt(wish.pos()) : tree_->currentItem();
  const QString path = item ? item->data(0, kPathRole).toString() : QString();
  const QPoint at = is_by_mouse || !item
                        ? wish.globalPos()
                        : tree_->viewport()->mapToGlobal(tree_->visualItemRect(item).center());
  if (item && item->data(0, kIsList).toBool()) {
    Q_EMIT list_menu_wished(path, list_of_row(*item), at);
    return;
  }
  const ElementPlace place = place_of(workbench_.tree(), path);
  const bool has_learned = place.element && !attribute(*place.element, "weights").isEmpty();
  if (item && is_by_mouse && !has_learned) {
    Q_EMIT edit_wished(path);
  } else {
    Q_EMIT menu_wished(path, at);
  }
}

void WorldTree::wish_edit(const QTreeWidgetItem* item) {
  if (!item->data(0, kIsList).toBool()) {
    Q_EMIT edit_wished(item->data(0, kPathRole).toString());
  }
}

void WorldTree::make_team_buttons() {
  auto* grid = new QGridLayout;
  const auto button = [&](int row, int column, const char* name, const char* list,
                          const QString& text, const QString& tip) {
    auto* made = new QPushButton(text);
    made->setObjectName(name);
    made->setToolTip(tip);
    grid->addWidget(made, row, column);
    connect(made, &QPushButton::clicked, this,
            [this, list] { Q_EMIT add_wished(selection().value(0), list); });
  };
  button(0, 0, "add_robot", "robots", tr("Robot..."), tr("Add a robot to the team"));
  button(0, 1, "add_sensor", "sensors", tr("Sensor..."),
         tr("Add a sensor of any kind to the selected robot"));
  button(1, 0, "behaviors", "behaviors", tr("Behaviours..."),
         tr("Choose the behaviours of the selected robot"));
  button(1, 1, "coordinator", "coordinator", tr("Coordinator..."),
         tr("Choose or edit the coordinator of the selected robot"));
  static_cast<QVBoxLayout*>(layout())->addLayout(grid);
}

QStringList WorldTree::selection() const {
  QStringList paths;
  for (const QTreeWidgetItem* item : tree_->selectedItems()) {
    if (!item->data(0, kIsList).toBool()) {
      paths << item->data(0, kPathRole).toString();
    }
  }
  return paths;
}

QTreeWidgetItem* WorldTree::item(const QString& path) const { return items_.value(path); }

QString WorldTree::note_of(const QString& path) const {
  const QTreeWidgetItem* found = item(path);
  return found ? found->data(0, kNote).toString() : QString();
}

// The places that the tree shows, in its order, with their parents.
std::vector<WorldTree::Shown> WorldTree::places() const {
  std::vector<Shown> all;
  const std::function<void(const ElementPlace&, int)> add = [&](const ElementPlace& place,
                                                                int parent) {
    const auto number = static_cast<int>(all.size());
    const QString list = place.list.isEmpty() ? QString() : '/' + name_of(*place.element);
    all.push_back({place, place.path + list, parent});
    visit_children(place, [&](const ElementPlace& child) { add(child, number); });
  };
  const Json& world = workbench_.tree();
  if (team_.isEmpty()) {
    if (world.is_object()) {
      add({&world, nullptr, {}, {}}, -1);
    }
    return all;
  }
  visit(world, [&](const ElementPlace& place) {
    const bool is_robot = name_of(*place.element) == "robot" && place.path.startsWith("robot[");
    if (is_robot && team_of(*place.element) == team_) {
      add(place, -1);
    }
    return !is_robot;
  });
  return all;
}

void WorldTree::show_world() {
  is_showing_ = true;
  const std::vector<Shown> shown = places();
  const bool is_same =
      std::equal(shown.begin(), shown.end(), keys_.begin(), keys_.end(),
                 [](const Shown& place, const QString& key) { return place.key == key; });
  if (!is_same) {
    build(shown);
  }
  int number = 0;
  for (QTreeWidgetItemIterator it(tree_); *it; ++it) {
    show_item(**it, shown[static_cast<std::size_t>(number++)].place);
  }
  with_weight_.clear();
  is_showing_ = false;
  filter(filter_->text());
}

// Open rows stay open, and the rows in view, the selected ones and the current one stay so.
void WorldTree::build(const std::vector<Shown>& shown) {
  QSet<QString> open;
  std::optional<QString> current;
  int number = 0;
  for (QTreeWidgetItemIterator it(tree_); *it; ++it) {
    const QString& key = keys_[static_cast<std::size_t>(number++)];
    if ((*it)->isExpanded()) open << key;
    if (*it == tree_->currentItem()) current = key;
  }
  const QSet<QString> known(keys_.begin(), keys_.end());
  const int top = tree_->verticalScrollBar()->value();
  tree_->setUpdatesEnabled(false);
  tree_->clear();
  items_.clear();
  keys_.clear();
  std::vector<QTreeWidgetItem*> made;
  for (const auto& [place, key, parent] : shown) {
    auto* item = parent < 0 ? new QTreeWidgetItem(tree_)
                            : new QTreeWidgetItem(made[static_cast<std::size_t>(parent)]);
    made.push_back(item);
    keys_.push_back(key);
    item->setData(0, kPathRole, place.path);
    item->setData(0, kIsList, !place.list.isEmpty());
    if (place.list.isEmpty()) {
      items_.insert(place.path, item);
    }
    item->setExpanded(known.contains(key) ? open.contains(key)
                                          : !place.path.contains('/') || !place.list.isEmpty());
    if (key == current) {
      tree_->setCurrentItem(item, 0, QItemSelectionModel::NoUpdate);
    }
    item->setSelected(place.list.isEmpty() && chosen_.contains(place.path));
  }
  tree_->doItemsLayout();
  tree_->verticalScrollBar()->setValue(top);
  tree_->setUpdatesEnabled(true);
}

void WorldTree::show_item(QTreeWidgetItem& item, const ElementPlace& place) {
  const bool is_inherited = member(*place.element, "inherited") == true;
  const QString name = name_of(*place.element), title = title_of(*place.element);
  const bool is_list = !place.list.isEmpty();
  item.setText(0, label_of(*place.element));
  item.setData(0, kName, name);
  item.setData(0, RowDelegate::kTitle, is_list || title == name ? in_words(name) : title);
  item.setData(0, kKind, is_list || title == name ? QString() : in_words(name));
  item.setData(0, kNote, {});
  QFont font = tree_->font();
  font.setItalic(is_inherited);
  item.setFont(0, font);
  const bool is_locked = place.list.isEmpty() && locked_.contains(place.path);
  item.setIcon(0, is_locked ? padlock_icon(palette().color(QPalette::Text)) : icon_of(place));
  QStringList tips{"<" + name + ">"};
  if (const QString given = detail_of(*place.element); !given.isEmpty()) tips << given;
  if (is_locked) tips << tr("Locked against the mouse (Ctrl+L).");
  if (is_inherited) {
    tips << tr(
        "It comes from the robot's template; changes made here are written into the "
        "robot's own element.");
  }
  item.setToolTip(0, tips.join('\n'));
}

void WorldTree::show_locked(const QSet<QString>& paths) {
  for (const QString& path : std::exchange(locked_, paths) + paths) {
    const ElementPlace place = place_of(workbench_.tree(), path);
    if (QTreeWidgetItem* found = item(path); found && place.element) {
      show_item(*found, place);
    }
  }
}

void WorldTree::set_selection(const QStringList& paths) {
  chosen_ = paths;  // some may not be shown yet
  if (paths == selection()) {
    return;
  }
  is_showing_ = true;
  tree_->clearSelection();
  for (const QString& path : paths) {
    if (QTreeWidgetItem* found = item(path)) {
      found->setSelected(true);
      tree_->scrollToItem(found);
    }
  }
  is_showing_ = false;
}

void WorldTree::filter(const QString& text) {
  const std::function<bool(QTreeWidgetItem*)> show = [&](QTreeWidgetItem* item) {
    bool fits = text.isEmpty() || item->text(0).contains(text, Qt::CaseInsensitive) ||
                item->toolTip(0).contains(text, Qt::CaseInsensitive) ||
                item->data(0, RowDelegate::kTitle).toString().contains(text, Qt::CaseInsensitive);
    for (int i = 0; i < item->childCount(); ++i) {
      fits = show(item->child(i)) || fits;
    }
    item->setHidden(!fits);
    return fits;
  };
  for (int i = 0; i < tree_->topLevelItemCount(); ++i) {
    show(tree_->topLevelItem(i));
  }
}

void WorldTree::show_weights(const Json& state) {
  QSet<QString> without = with_weight_;
  visit_weights(state, [&](const QString& path, double weight) {
    if (QTreeWidgetItem* found = item(path)) {
      found->setData(0, kNote, tr("weight %1").arg(weight, 0, 'g', 3));
      with_weight_.insert(path);
      without.remove(path);
    }
  });
  for (const QString& path : std::as_const(without)) {
    items_[path]->setData(0, kNote, {});
    with_weight_.remove(path);
  }
}

}  // namespace elsie::desktop
