// The world as a tree: robots with all their parts, obstacles, goals.
#pragma once

#include <QHash>
#include <QSet>
#include <QWidget>

#include "engine/elements.h"

class QContextMenuEvent;
class QLineEdit;
class QTreeWidget;
class QTreeWidgetItem;

namespace elsie::desktop {

class Workbench;

/// The tree of the whole world, or of one team's robots. Rows stay open, selected and in view when
/// the world changes.
class WorldTree : public QWidget {
  Q_OBJECT

 public:
  /// `team` is the team whose robots it shows; "" for the whole world.
  explicit WorldTree(Workbench& workbench, QString team = {}, QWidget* parent = nullptr);

  void show_world();
  void set_selection(const QStringList& paths);
  QStringList selection() const;
  QTreeWidget* tree() { return tree_; }
  QTreeWidgetItem* item(const QString& path) const;
  /// What stands at the right end of the row; "" if nothing does.
  QString note_of(const QString& path) const;

  /// Marks these objects as locked against the mouse.
  void show_locked(const QSet<QString>& paths);

  /// Shows numbers next to the behaviours of the robots in `state`: the priority that a network
  /// gives them now. Other robots show their own details again.
  void show_weights(const Json& state);

 Q_SIGNALS:
  void selected(const QStringList& paths);
  /// The only selected row is the list of that name of the element at `holder`.
  void list_selected(const QString& holder, const QString& list);
  void edit_wished(const QString& path);
  /// A button of the team was pressed: adds to the list where `path` is selected; "": in the world.
  void add_wished(const QString& path, const QString& list);
  void menu_wished(const QString& path, const QPoint& global);
  void list_menu_wished(const QString& holder, const QString& list, const QPoint& global);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Shown {
    ElementPlace place;
    QString key;  // its path; for a list also its name
    int parent;   // the number of the row that contains it; -1: none
  };

  void wish_edit(const QTreeWidgetItem* item);
  void wish_menu(const QContextMenuEvent& wish);
  void make_team_buttons();
  std::vector<Shown> places() const;
  void build(const std::vector<Shown>& shown);
  void show_item(QTreeWidgetItem& item, const ElementPlace& place);
  void filter(const QString& text);

  Workbench& workbench_;
  QString team_;
  QLineEdit* filter_;
  QTreeWidget* tree_;
  std::vector<QString> keys_;  // of the rows, in their order
  QStringList chosen_;         // selected in the window; the tree may have none of them
  QHash<QString, QTreeWidgetItem*> items_;  // of elements, by path
  QSet<QString> with_weight_;               // paths
  QSet<QString> locked_;                    // paths
  bool is_showing_ = false;
};

/// The names of all teams that a world declares or to which its robots belong.
QStringList teams_of(const Json& world);

}  // namespace elsie::desktop
