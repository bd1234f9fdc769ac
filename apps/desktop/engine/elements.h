// The elements of a world as the engine describes them, and their paths, which edits use.
#pragma once

#include <QHash>
#include <QString>
#include <QStringList>
#include <functional>
#include <vector>

#include "engine/json.h"

namespace elsie::desktop {

/// One element of a world.
struct ElementPlace {
  const Json* element = nullptr;
  const Json* parent = nullptr;  // null for the world
  QString path;                  // as in edits; "" for the world. A list has the path of its holder
  QString list;                  // the word for its members if it is a list: "robot"; otherwise ""
  QStringList around{};          // the names of the elements around it, the world first
};

/// Calls `see` for all elements, each before the elements in it. If `see` returns false, the
/// elements in that element are skipped.
void visit(const Json& world, const std::function<bool(const ElementPlace&)>& see);
/// Calls `see` for the elements directly in that place.
void visit_children(const ElementPlace& place, const std::function<void(const ElementPlace&)>& see);
/// The element at that path; its `element` is null if there is none. A list has no path of its own.
ElementPlace place_of(const Json& world, const QString& path);

/// The list of that name ("sensors") directly in the element at that path; its `element` is null if
/// there is none.
ElementPlace list_at(const Json& world, const QString& holder, const QString& list);
/// The elements in that list.
std::vector<ElementPlace> members_of(const Json& world, const QString& holder, const QString& list);

/// The word for the members of a list: "robot" for "robots"; "" if that is not a list.
QString member_word(const QString& list);
/// The first id of "r1", "r2"... that neither the world nor `taken` has.
QString free_id(const Json& world, const QString& letter, const QStringList& taken = {});

QString name_of(const Json& element);
/// Its attributes as an object; empty without any.
const Json& attributes_of(const Json& element);
/// The value as text; "" if the element does not have the attribute.
QString attribute(const Json& element, const char* name);
/// The name that the user sees: its id, its attribute `name`, as states have, or the name of the
/// element.
QString title_of(const Json& element);

/// The same for the element at a path; the path itself if there is none.
QString title_at(const Json& world, const QString& path);

/// The path of the robot in a path: "robot[r1]" for "robot[r1]/sensor[ahead]" and for itself; ""
/// outside of robots.
QString robot_path(const QString& path);
/// The id of that robot: "r1"; "" outside of robots.
QString robot_id(const QString& path);
/// The path of an attribute: "robot[r1]/@x"; "@name" for the world's.
QString attribute_path(const QString& element, const QString& attribute);
/// The path of the element that contains the element; "" for elements directly in the world.
QString holder_of(const QString& path);

/// The paths and names of all elements in their order. They are found again by these when their
/// paths change.
using Outline = std::vector<std::pair<QString, QString>>;
Outline outline_of(const Json& world);
/// Maps paths that no longer exist to the new ones, if the same elements are in the same places.
QHash<QString, QString> renamed(const Outline& before, const Outline& after);
/// The path after the element at `from`, perhaps around it, has got the path `to`.
QString renamed_path(const QString& path, const QString& from, const QString& to);

/// Calls `see` for every behaviour that was asked at the instant of a `state` event, with its path
/// and the weight that its coordinator gave it. A network's weight is the priority that it has
/// learned.
void visit_weights(const Json& state,
                   const std::function<void(const QString& path, double weight)>& see);

/// An element as XML, with all elements in it, but without the attributes in `but`.
QString markup_of(const Json& element, const QStringList& but = {});
/// A value as written between quotation marks in XML.
QString escaped(const QString& value);

}  // namespace elsie::desktop
