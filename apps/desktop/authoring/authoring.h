// The selection, and what a user does with it. clipboard.cpp has deleting, copying and pasting.
#pragma once

#include <QObject>
#include <QPointF>
#include <QStringList>
#include <optional>
#include <utility>
#include <vector>

#include "engine/elements.h"

class QPoint;
class QWidget;

namespace elsie::desktop {

struct Piece;
class SceneView;
class Stage;
class Workbench;

/// Holds the selection and makes all changes of the world that use it: dialogs, menus, the
/// clipboard, and drags in the view. Each change is one edit with a name, so that undo reverts all
/// of it.
class Authoring : public QObject {
  Q_OBJECT

 public:
  /// Does what users do in the view, which shows the selection. `window` owns this object and the
  /// dialogs.
  Authoring(Workbench& workbench, SceneView& view, QWidget* window);

  const QStringList& selection() const { return selection_; }
  void select(const QStringList& paths);
  /// The selected robot, or the robot that contains the selected object; "" if there is none.
  QString robot() const;

  /// Opens the editor of an element, or raises the one that is open, or says why it has none.
  void edit_element(const QString& path);
  void edit_selected();
  /// Closes the dialogs without entering what was typed in them: their world is closed.
  void close_dialogs();
  /// How a new element begins.
  struct Beginning {
    QString kind;               // "": the first of the list
    QString team;               // of a robot
    std::optional<QPointF> at;  // m
  };
  /// Opens the dialog for a new member of `list` ("sensors") in the element `holder` ("robot[r1]");
  /// with "" for one of the elements that a plugin declares for what is there.
  void add_element(const QString& holder, const QString& list, const Beginning& beginning = {});
  void add_waypoint(const QString& path);
  void add_point(const QString& path);
  /// These act on a robot, or on a behaviour that holds others.
  void edit_behaviors(const QString& holder);
  /// The element that takes members of that list where this element is selected: the behaviour at
  /// the path if it holds others, otherwise its robot; "" outside of robots.
  QString holder_for(const QString& list, const QString& path) const;
  /// An obstacle that can be added.
  struct Obstacle {
    QString name;  // "dynamic" for a box, "cylinder" for another shape
    QString kind;  // "dynamic_box", "static_cylinder"
    QString text;  // for a menu that adds things, with a letter that no other entry has
  };
  /// The boxes of all kinds, and the other shapes.
  static std::vector<Obstacle> obstacles();
  /// Opens the menu of the element, or of the world if the path is "".
  void open_menu(const QString& path, const QPoint& global);
  /// Opens the menu of what can be added `at` that point of the floor, m; none: to the world.
  void open_floor_menu(const QPoint& global, std::optional<QPointF> at = {});
  /// Opens the menu of the list ("sensors") of the element at `holder`: what can be added to it,
  /// and pasted.
  void open_list_menu(const QString& holder, const QString& list, const QPoint& global);

  void remove_selected();
  void copy_selected();
  void cut_selected();
  void paste();
  void duplicate_selected();
  void rename_selected();
  /// Makes the present poses of the selected robots their start poses.
  void make_start_poses();

  /// Make the edit at the end of a drag in the view; lengths in m, angles in rad. While the view
  /// shows the past, where all stands elsewhere, they change nothing and emit moved_in_the_past().
  void move(const QStringList& paths, double by_x, double by_y);
  void turn(const QString& path, double by_rad);
  void resize(const QString& path, double length, double width);

 Q_SIGNALS:
  void selected(const QStringList& paths);
  void said(const QString& sentence);
  void moved_in_the_past();
  /// The path of an element has changed, whether it is selected or not.
  void called_otherwise(const QString& from, const QString& to);

 private:
  void find_renamed();
  /// Brings the open dialog that edits the element, or the behaviours of the holder, to the front.
  /// Returns false if there is none.
  bool has_raised_editor(const QString& path);
  bool has_raised_behaviors(const QString& holder);
  bool is_the_present();
  QString title(const QString& path) const;
  QStringList wholes() const;
  QString markup_of_selected() const;
  QString list_for(const QString& name) const;
  std::optional<QString> holder_of_part(const Piece& piece) const;
  /// Whether the clipboard has elements that may stand in that list.
  bool may_paste_into(const QString& list) const;
  void insert(const QString& markup, const QString& name);
  /// Whether the world may have another of each selected element.
  bool may_duplicate() const;
  /// The edit that puts a piece into the world; "", with a sentence, if it cannot be put there.
  /// Adds the id that it gives to `taken`.
  QString insertion_of(Piece piece, const QPointF& aside, QStringList& taken, QString& why) const;
  /// The places of the waypoints of a path, or of the points of an outline.
  std::vector<QPointF> places_in(const QString& path, const QString& name) const;
  void add_place(const QString& path, const QString& name, const QPointF& at);
  /// How far from their originals the copies stand, so that each has a free place.
  QPointF way_aside(const std::vector<Piece>& pieces) const;
  /// The elements that edits with these paths have just added: for each path the last element
  /// there, for a path that occurs twice the last two.
  QStringList last_of(const QStringList& places) const;

  Workbench& workbench_;
  SceneView& view_;
  const Stage& stage_;  // where the bodies are now
  QWidget* window_;
  QStringList selection_;
  QStringList copied_;  // paths of what was copied or duplicated last
  Outline outline_;     // of the world
};

}  // namespace elsie::desktop
