#include "world/world_tree.h"

#include <QGridLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <functional>

#include "engine/workbench.h"

namespace elsie::desktop {
namespace {

constexpr int kPath = Qt::UserRole;
constexpr int kIsList = Qt::UserRole + 1;

QString detail_of(const Json& element) {
  QStringList parts;
  for (const auto& [name, value] : attributes_of(element).items()) {
    if (name != "id" && parts.size() < 4) {
      parts << QString::fromStdString(name) + '=' +
                   QString::fromStdString(value.get<std::string>());
    }
  }
  return parts.join("  ");
}

/// "avoid (avoid_obstacle)" where the id says something else than the name.
QString label_of(const Json& element) {
  const QString id = attribute(element, "id"), name = name_of(element);
  return id.isEmpty() || id == name ? name : id + " (" + name + ')';
}

}  // namespace

QStringList teams_of(const Json& world) {
  QStringList teams{"red", "blue"};
  visit(world, [&](const ElementPlace& place) {
    const QString name = name_of(*place.element);
    const QString team = name == "team"    ? attribute(*place.element, "id")
                         : name == "robot" ? attribute(*place.element, "team")
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
  tree_->setHeaderLabels({tr("Element"), tr("Given")});
  tree_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  tree_->setContextMenuPolicy(Qt::CustomContextMenu);
  tree_->setUniformRowHeights(true);
  tree_->setIndentation(fontMetrics().averageCharWidth() * 3 / 2);
  tree_->header()->setStretchLastSection(true);
  column->addWidget(tree_, 1);
  if (!team_.isEmpty()) {
    make_team_buttons();
  }
  connect(filter_, &QLineEdit::textChanged, this, &WorldTree::filter);
  connect(tree_, &QTreeWidget::itemSelectionChanged, this, [this] {
    if (!is_showing_) {
      Q_EMIT selected(selection());
    }
  });
  connect(tree_, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) {
    if (!item->data(0, kIsList).toBool()) {
      Q_EMIT edit_wished(item->data(0, kPath).toString());
    }
  });
  // A right click opens the editor of a thing; on a list and on nothing it opens the menu.
  connect(tree_, &QTreeWidget::customContextMenuRequested, this, [this](const QPoint& at) {
    const QTreeWidgetItem* item = tree_->itemAt(at);
    Q_EMIT menu_wished(
        item && !item->data(0, kIsList).toBool() ? item->data(0, kPath).toString() : QString(),
        tree_->viewport()->mapToGlobal(at));
  });
}

void WorldTree::make_team_buttons() {
  auto* grid = new QGridLayout;
  const auto button = [&](int row, int column, const char* name, const QString& text,
                          const QString& tip) {
    auto* made = new QPushButton(text);
    made->setObjectName(name);
    made->setToolTip(tip);
    grid->addWidget(made, row, column);
    return made;
  };
  connect(button(0, 0, "add_robot", tr("Robot..."), tr("Add a robot to the team")),
          &QPushButton::clicked, this, [this] { Q_EMIT add_wished({}, "robots"); });
  connect(button(0, 1, "add_sensor", tr("Sensor..."),
                 tr("Add a sensor of any kind to the chosen robot")),
          &QPushButton::clicked, this,
          [this] { Q_EMIT add_wished(holder_for("sensors"), "sensors"); });
  connect(button(1, 0, "behaviors", tr("Behaviours..."),
                 tr("Choose the behaviours of the chosen robot")),
          &QPushButton::clicked, this,
          [this] { Q_EMIT behaviors_wished(holder_for("behaviors")); });
  connect(button(1, 1, "coordinator", tr("Coordinator..."),
                 tr("Choose or edit the coordinator of the chosen robot")),
          &QPushButton::clicked, this, [this] {
            const QString holder = holder_for("coordinator");
            if (!holder.isEmpty() && place_of(workbench_.tree(), holder + "/coordinator").element) {
              Q_EMIT edit_wished(holder + "/coordinator");
            } else {
              Q_EMIT add_wished(holder, "coordinator");
            }
          });
  static_cast<QVBoxLayout*>(layout())->addLayout(grid);
}

// The robot, or the chosen behaviour if that holds others.
QString WorldTree::holder_for(const QString& list) const {
  const QStringList chosen = selection();
  if (!chosen.isEmpty() && list != "sensors") {
    const ElementPlace place = place_of(workbench_.tree(), chosen.front());
    const auto kind = workbench_.catalog().kind_of(place);
    if (kind && kind->holds_behaviors && chosen.front().contains("/behavior[")) {
      return chosen.front();
    }
  }
  return robot();
}

QString WorldTree::robot() const {
  for (const QString& path : selection()) {
    if (path.startsWith("robot[")) {
      return path.section(']', 0, 0) + ']';
    }
  }
  for (int i = 0; i < tree_->topLevelItemCount() && !team_.isEmpty(); ++i) {
    return tree_->topLevelItem(i)->data(0, kPath).toString();  // the first of the team
  }
  return {};
}

QStringList WorldTree::selection() const {
  QStringList paths;
  for (const QTreeWidgetItem* item : tree_->selectedItems()) {
    if (!item->data(0, kIsList).toBool()) {
      paths << item->data(0, kPath).toString();
    }
  }
  return paths;
}

QTreeWidgetItem* WorldTree::item(const QString& path) const { return items_.value(path); }

void WorldTree::show_world() {
  is_showing_ = true;
  const auto key = [](const QTreeWidgetItem* item) {
    return item->data(0, kPath).toString() +
           (item->data(0, kIsList).toBool() ? '/' + item->text(0) : QString());
  };
  QSet<QString> open, chosen, known;
  for (QTreeWidgetItemIterator it(tree_); *it; ++it) {
    known << key(*it);
    if ((*it)->isExpanded()) open << key(*it);
    if ((*it)->isSelected()) chosen << key(*it);
  }
  tree_->setUpdatesEnabled(false);
  tree_->clear();
  items_.clear();
  with_weight_.clear();
  const std::function<void(const ElementPlace&, QTreeWidgetItem*)> add =
      [&](const ElementPlace& place, QTreeWidgetItem* parent) {
        auto* item = parent ? new QTreeWidgetItem(parent) : new QTreeWidgetItem(tree_);
        item->setText(0, label_of(*place.element));
        item->setText(1, detail_of(*place.element));
        item->setToolTip(1, detail_of(*place.element));
        item->setData(0, kPath, place.path);
        item->setData(0, kIsList, !place.list.isEmpty());
        if (place.list.isEmpty()) {
          items_.insert(place.path, item);
        }
        if (place.element->value("inherited", false)) {
          QFont font = item->font(0);
          font.setItalic(true);
          item->setFont(0, font);
          item->setToolTip(0, tr("It comes from the robot's template; what is changed here is "
                                 "written into the robot's own element."));
        }
        visit_children(place, [&](const ElementPlace& child) { add(child, item); });
        item->setExpanded(known.contains(key(item))
                              ? open.contains(key(item))
                              : !place.path.contains('/') || !place.list.isEmpty());
        item->setSelected(chosen.contains(key(item)));
      };
  const auto is_of_team = [&](const ElementPlace& place) {
    const QString team = attribute(*place.element, "team");
    return (team.isEmpty() ? QString("red") : team) == team_;
  };
  if (workbench_.tree().is_object()) {
    if (team_.isEmpty()) {
      add({&workbench_.tree(), nullptr, {}, {}}, nullptr);
    } else {
      visit(workbench_.tree(), [&](const ElementPlace& place) {
        const bool is_robot = name_of(*place.element) == "robot" && place.path.startsWith("robot[");
        if (is_robot && is_of_team(place)) {
          add(place, nullptr);
        }
        return !is_robot;
      });
    }
  }
  tree_->setColumnWidth(0, std::max(tree_->columnWidth(0), 150));
  tree_->setUpdatesEnabled(true);
  is_showing_ = false;
  filter(filter_->text());
}

void WorldTree::set_selection(const QStringList& paths) {
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
                item->text(1).contains(text, Qt::CaseInsensitive);
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
      found->setText(1, tr("weight %1").arg(weight, 0, 'g', 3));
      with_weight_.insert(path);
      without.remove(path);
    }
  });
  for (const QString& path : std::as_const(without)) {
    items_[path]->setText(1, items_[path]->toolTip(1));
    with_weight_.remove(path);
  }
}

}  // namespace elsie::desktop
