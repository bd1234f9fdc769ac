// What a user chooses in the world and does with it. clipboard.cpp has deleting, copying and
// pasting.
#pragma once

#include <QObject>
#include <QPointF>
#include <QStringList>
#include <optional>

#include "engine/elements.h"

class QPoint;
class QWidget;

namespace elsie::desktop {

struct Piece;
class Stage;
class Workbench;

/// The selection, and all that changes the world with it: dialogs, menus, the clipboard and drags
/// in the view. Each change is one edit with a name, so that undo takes it back whole.
class Authoring : public QObject {
  Q_OBJECT

 public:
  /// `stage`: where the bodies are now; `window` owns this and the dialogs.
  Authoring(Workbench& workbench, const Stage& stage, QWidget* window);

  const QStringList& selection() const { return selection_; }
  void select(const QStringList& paths);
  /// The robot that is chosen, or in which the chosen thing is; "": none.
  QString robot() const;

  /// Opens the editor of an element; says why if there is none.
  void edit_element(const QString& path);
  void edit_selected();
  /// What a new element begins with.
  struct Beginning {
    QString kind;               // "": the first of the list
    QString team;               // of a robot
    std::optional<QPointF> at;  // m
  };
  /// Opens the dialog of a new member of `list` ("sensors") in the element `holder` ("robot[r1]").
  void add_element(const QString& holder, const QString& list, const Beginning& beginning = {});
  void add_waypoint(const QString& path);
  void add_point(const QString& path);
  /// These act on a robot, or on a behaviour that holds others.
  void edit_behaviors(const QString& holder);
  /// Opens the editor of its coordinator, or the dialog of a new one.
  void edit_coordinator(const QString& holder);
  /// The menu of the element, or of the world for "".
  void open_menu(const QString& path, const QPoint& global);
  /// What can be put `at` that place of the floor, in m; none: into the world.
  void open_floor_menu(const QPoint& global, std::optional<QPointF> at = {});

  void remove_selected();
  void copy_selected();
  void cut_selected();
  void paste();
  void duplicate_selected();
  void rename_selected();
  /// The world begins with the chosen robots where they are now.
  void make_start_poses();

  /// A drag in the view has ended: by this much, m and rad.
  void move(const QStringList& paths, double by_x, double by_y);
  void turn(const QString& path, double by_rad);
  void resize(const QString& path, double length, double width);

 Q_SIGNALS:
  void selected(const QStringList& paths);
  /// Something is there that was not, and it is chosen.
  void added();
  void said(const QString& sentence);
  void follow_wished(const QString& path);
  /// An element, chosen or not, has another path from now on.
  void called_otherwise(const QString& from, const QString& to);

 private:
  void find_renamed();
  QString title(const QString& path) const;
  QStringList wholes() const;
  QString markup_of_selected() const;
  QString list_for(const QString& name) const;
  std::optional<QString> holder_of_part(const QString& name) const;
  QString carrier(const QString& list) const;
  void insert(const QString& markup, const QString& name);
  /// The edit that puts a piece into the world; "", with a sentence, if it has no place. Notes the
  /// id that it gives.
  QString insertion_of(Piece piece, const QPointF& aside, QStringList& taken, QString& why) const;
  /// How far from their originals copies stand, so that all of them are where nothing is.
  /// The waypoints of a path, or the points of an outline.
  std::vector<QPointF> places_in(const QString& path, const QString& name) const;
  void add_place(const QString& path, const QString& name, const QPointF& at);
  QPointF way_aside(const std::vector<Piece>& pieces) const;
  /// The last elements of the world that an edit of that path adds to, one for each time that the
  /// path is in the list.
  QStringList last_of(const QStringList& places) const;

  Workbench& workbench_;
  const Stage& stage_;
  QWidget* window_;
  QStringList selection_;
  Outline outline_;  // of the world
};

}  // namespace elsie::desktop
