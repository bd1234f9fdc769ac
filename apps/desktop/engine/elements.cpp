#include "engine/elements.h"

#include <QSet>
#include <algorithm>
#include <cmath>

namespace elsie::desktop {
namespace {

const Json kNone = Json::array();

const Json& children_of(const Json& element) {
  const auto found = element.find("children");
  return found == element.end() ? kNone : *found;
}

QString joined(const QString& path, const QString& step) {
  return path.isEmpty() ? step : path + '/' + step;
}

QString step_of(const Json& parent, std::size_t index, const QString& list) {
  const Json& siblings = children_of(parent);
  const Json& element = siblings[index];
  const QString name = name_of(element);
  if (list == "coordinator" || list == "drive") {
    return list;
  }
  if (!list.isEmpty()) {
    const QString id = attribute(element, "id");
    return list + '[' + (id.isEmpty() ? QString::number(index + 1) : id) + ']';
  }
  int number = 0, count = 0;
  for (std::size_t i = 0; i < siblings.size(); ++i) {
    if (name_of(siblings[i]) == name) {
      ++count;
      number += i <= index ? 1 : 0;
    }
  }
  return count > 1 ? name + '[' + QString::number(number) + ']' : name;
}

void visit_from(const ElementPlace& place, const std::function<bool(const ElementPlace&)>& see) {
  if (see(place)) {
    visit_children(place, [&](const ElementPlace& child) { visit_from(child, see); });
  }
}

}  // namespace

void visit_children(const ElementPlace& place,
                    const std::function<void(const ElementPlace&)>& see) {
  const Json& children = children_of(*place.element);
  if (children.empty()) return;  // most have none
  const QStringList around = place.around + QStringList{name_of(*place.element)};
  for (std::size_t i = 0; i < children.size(); ++i) {
    // Lists contain no lists, and a plugin may have the name of one.
    const QString list = place.list.isEmpty() ? member_word(name_of(children[i])) : QString();
    see({&children[i], place.element,
         list.isEmpty() ? joined(place.path, step_of(*place.element, i, place.list)) : place.path,
         list, around});
  }
}

void visit(const Json& world, const std::function<bool(const ElementPlace&)>& see) {
  if (world.is_object()) {
    visit_from(ElementPlace{&world, nullptr, {}, {}}, see);
  }
}

ElementPlace place_of(const Json& world, const QString& path) {
  ElementPlace found;
  visit(world, [&](const ElementPlace& place) {
    if (!found.element && place.list.isEmpty() && place.path == path) {
      found = place;
    }
    return !found.element;
  });
  return found;
}

ElementPlace list_at(const Json& world, const QString& holder, const QString& list) {
  ElementPlace found;
  visit(world, [&](const ElementPlace& place) {
    if (!place.list.isEmpty() && place.path == holder && name_of(*place.element) == list) {
      found = place;
    }
    return !found.element;
  });
  return found;
}

std::vector<ElementPlace> members_of(const Json& world, const QString& holder,
                                     const QString& list) {
  std::vector<ElementPlace> members;
  if (const ElementPlace place = list_at(world, holder, list); place.element) {
    visit_children(place, [&](const ElementPlace& each) { members.push_back(each); });
  }
  return members;
}

QString member_word(const QString& list) {
  static const QHash<QString, QString> words{{"teams", "team"},
                                             {"obstacles", "obstacle"},
                                             {"resources", "resource"},
                                             {"chargers", "charger"},
                                             {"nests", "nest"},
                                             {"lamps", "lamp"},
                                             {"patches", "patch"},
                                             {"fields", "field"},
                                             {"robots", "robot"},
                                             {"goals", "goal"},
                                             {"measures", "measure"},
                                             {"rules", "rule"},
                                             {"changes", "change"},
                                             {"sensors", "sensor"},
                                             {"actuators", "actuator"},
                                             {"behaviors", "behavior"},
                                             {"coordinator", "coordinator"},
                                             {"drive", "drive"},
                                             {"segments", "segment"}};
  return words.value(list);
}

QString free_id(const Json& world, const QString& letter, const QStringList& taken) {
  QStringList ids = taken;
  visit(world, [&](const ElementPlace& place) {
    ids << attribute(*place.element, "id");
    return true;
  });
  int number = 1;
  while (ids.contains(letter + QString::number(number))) {
    ++number;
  }
  return letter + QString::number(number);
}

QString name_of(const Json& element) { return text_of(element, "name"); }

const Json& attributes_of(const Json& element) {
  static const Json none = Json::object();
  const Json& attributes = member(element, "attributes");
  return attributes.is_object() ? attributes : none;
}

QString attribute(const Json& element, const char* name) {
  return text_of(attributes_of(element), name);
}

QString title_of(const Json& element) {
  const QString id = attribute(element, "id"), kind = name_of(element);
  const QString called = kind == "world" ? QString() : attribute(element, "name");
  return !id.isEmpty() ? id : called.isEmpty() ? kind : called;
}

QString title_at(const Json& world, const QString& path) {
  const ElementPlace place = place_of(world, path);
  return place.element ? title_of(*place.element) : path;
}

QString robot_path(const QString& path) {
  return path.startsWith("robot[") ? path.section(']', 0, 0) + ']' : QString();
}

QString robot_id(const QString& path) {
  return robot_path(path).section('[', 1).section(']', 0, 0);
}

QString attribute_path(const QString& element, const QString& attribute) {
  return element.isEmpty() ? '@' + attribute : element + "/@" + attribute;
}

QString holder_of(const QString& path) {
  int depth = 0;
  for (qsizetype i = path.size() - 1; i >= 0; --i) {
    depth += path[i] == ']' ? 1 : path[i] == '[' ? -1 : 0;
    if (path[i] == '/' && depth == 0) {
      return path.left(i);
    }
  }
  return {};
}

Outline outline_of(const Json& world) {
  Outline outline;
  visit(world, [&](const ElementPlace& place) {
    outline.emplace_back(place.path, name_of(*place.element));
    return true;
  });
  return outline;
}

QHash<QString, QString> renamed(const Outline& before, const Outline& after) {
  const bool are_the_same =
      std::equal(before.begin(), before.end(), after.begin(), after.end(),
                 [](const auto& a, const auto& b) { return a.second == b.second; });
  QHash<QString, QString> names;
  if (!are_the_same) {
    return names;
  }
  QSet<QString> still;
  for (const auto& [path, name] : after) {
    still << path;
  }
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (!still.contains(before[i].first)) {
      names.insert(before[i].first, after[i].first);
    }
  }
  return names;
}

QString renamed_path(const QString& path, const QString& from, const QString& to) {
  return path == from || path.startsWith(from + '/') ? to + path.mid(from.size()) : path;
}

void visit_weights(const Json& state,
                   const std::function<void(const QString& path, double weight)>& see) {
  for (const Json& robot : member(state, "robots")) {
    for (const Json& each : member(robot, "members")) {
      QString below = "robot[" + text_of(robot, "id") + ']';
      for (const QString& id : text_of(each, "path").split('/')) {
        below += "/behavior[" + id + ']';
      }
      const double weight = number_of(each, "weight");
      if (member(each, "asked") == true && !std::isnan(weight)) {
        see(below, weight);
      }
    }
  }
}

QString escaped(const QString& value) {
  QString text = value.toHtmlEscaped();
  return text.replace('\n', "&#10;").replace('\t', "&#9;");
}

QString markup_of(const Json& merged, const QStringList& but) {
  const Json& element = merged.contains("written") ? merged["written"] : merged;
  QString text = '<' + name_of(element);
  for (const auto& [name, value] : attributes_of(element).items()) {
    const QString attribute = QString::fromStdString(name);
    const bool is_given = attribute != "id" || !(member(element, "named") == true);
    if (is_given && !but.contains(attribute)) {
      text += ' ' + attribute + "=\"" + escaped(written(value)) + '"';
    }
  }
  QString content = text_of(element, "text").toHtmlEscaped();
  for (const Json& child : children_of(element)) {
    content += markup_of(child);
  }
  return text + (content.isEmpty() ? "/>" : '>' + content + "</" + name_of(element) + '>');
}

}  // namespace elsie::desktop
