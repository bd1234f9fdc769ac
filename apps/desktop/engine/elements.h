// The elements of a world, as the engine describes them, and the paths that edits call them by.
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
  const Json* parent = nullptr;  // null: it is the world
  QString path;  // as edits have it; "" is the world. That of a list is its holder's
  QString list;  // the word for its members if it is a list: "robot"; otherwise ""
};

/// Calls `see` for all elements, each before those in it; those in an element for which it returns
/// false are left out.
void visit(const Json& world, const std::function<bool(const ElementPlace&)>& see);
/// The same for the elements directly in one.
void visit_children(const ElementPlace& place, const std::function<void(const ElementPlace&)>& see);
/// The element with that path; its `element` is null if there is none. A list has no path of its
/// own.
ElementPlace place_of(const Json& world, const QString& path);

/// The list of that name ("sensors") directly in the element with that path; its `element` is null
/// if there is none.
ElementPlace list_at(const Json& world, const QString& holder, const QString& list);

/// The word for the members of a list: "robot" of "robots"; "" if that is no list.
QString member_word(const QString& list);
/// An id that no element of the world has, and none of `taken`: the first free one of "r1", "r2"...
QString free_id(const Json& world, const QString& letter, const QStringList& taken = {});

QString name_of(const Json& element);
/// An object; empty if it has none.
const Json& attributes_of(const Json& element);
/// "" if it has no such attribute.
QString attribute(const Json& element, const char* name);
/// What a user calls it: its id, or its element's name.
QString title_of(const Json& element);

/// The same of the element at a path; the path itself if there is none.
QString title_at(const Json& world, const QString& path);

/// "robot[r1]" of "robot[r1]/sensor[ahead]" and of itself; "" if it is in no robot.
QString robot_path(const QString& path);
/// "r1" of those; "" if it is in no robot.
QString robot_id(const QString& path);
/// "robot[r1]/@x" and "@name" of the world.
QString attribute_path(const QString& element, const QString& attribute);
/// The path of the element in which another one is; "" for those directly in the world.
QString holder_of(const QString& path);

/// The paths and the names of all elements, in their order: finds them again when they are called
/// otherwise.
using Outline = std::vector<std::pair<QString, QString>>;
Outline outline_of(const Json& world);
/// New paths by those that are no more, if the same elements are in the same places.
QHash<QString, QString> renamed(const Outline& before, const Outline& after);

/// Calls `see` for every behaviour that was asked at the instant of a `state` event, with its path
/// and the weight that its coordinator gave it: a network's is the priority that it has learned.
void visit_weights(const Json& state,
                   const std::function<void(const QString& path, double weight)>& see);

/// An element as a piece of XML, with all that is in it; `but`: without these attributes.
QString markup_of(const Json& element, const QStringList& but = {});
/// A value as it stands between quotation marks in XML.
QString escaped(const QString& value);

}  // namespace elsie::desktop
