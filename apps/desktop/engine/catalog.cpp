#include "engine/catalog.h"

#include <QCoreApplication>

namespace elsie::desktop {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("Catalog", text); }

/// A value, or a list of values, as written in a file.
QString words_of(const Json& value) {
  if (!value.is_array()) {
    return written(value);
  }
  QStringList parts;
  for (const Json& each : value) {
    parts << words_of(each);
  }
  return parts.join(' ');
}

Field field_of(const Json& json) {
  Field field;
  field.name = text_of(json, "name");
  field.type = text_of(json, "type");
  field.unit = text_of(json, "unit");
  field.default_text = words_of(member(json, "default"));
  field.meaning = text_of(json, "meaning");
  field.is_required = json.value("required", false);
  const auto number = [&](const char* name) -> std::optional<double> {
    const Json& value = member(json, name);
    return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
  };
  QStringList bounds;
  const auto bound = [&](const char* name, const QString& words) {
    if (const auto value = number(name)) {
      bounds << words.arg(QString::number(*value, 'g', 6));
    }
  };
  bound("min", tr("at least %1"));
  bound("above", tr("above %1"));
  bound("max", tr("at most %1"));
  field.range = bounds.join(tr(" and "));
  field.least = number("min");
  field.most = number("max");
  for (const Json& each : member(json, "choices")) {
    field.choices << words_of(each);
  }
  return field;
}

void add_fields(Kind& kind, const Json& json, const char* list) {
  for (const Json& each : member(json, list)) {
    if (text_of(each, "name") == "remove") {  // an inherited element is removed in the tree
      kind.can_be_removed = true;
    } else {
      kind.fields.push_back(field_of(each));
    }
  }
}

Kind plugin_of(const Json& json) {
  Kind kind;
  kind.name = text_of(json, "name");
  kind.description = text_of(json, "description");
  kind.holds_behaviors = json.value("holds_behaviors", false);
  add_fields(kind, json, "parameters");
  for (const Json& each : member(json, "elements")) {
    kind.elements << text_of(each, "name");
  }
  for (const auto& [name, list] : {std::pair("needs", &kind.needs), {"produces", &kind.produces}}) {
    for (const Json& each : member(json, name)) {
      *list << words_of(each);
    }
  }
  return kind;
}

}  // namespace

// Adds the attributes that all plugins of the kind may have in a world: the place of a sensor, the
// priority of a behaviour.
std::vector<Kind> Catalog::plugins(const QString& kind) const {
  const auto common = element(kind);
  std::vector<Kind> kinds;
  for (const Json& each : member(answer_, "plugins")) {
    if (text_of(each, "kind") == kind) {
      Kind& made = kinds.emplace_back(plugin_of(each));
      if (common) {
        made.fields.insert(made.fields.begin(), common->fields.begin(), common->fields.end());
        made.can_be_removed = common->can_be_removed;
      }
    }
  }
  return kinds;
}

std::optional<Kind> Catalog::element(const QString& name) const {
  const Json& found = member(member(answer_, "elements"), name.toUtf8().constData());
  if (!found.is_object()) {
    return std::nullopt;
  }
  Kind kind;
  kind.name = name;
  kind.description = text_of(found, "meaning");
  add_fields(kind, found, "attributes");
  for (const Json& each : member(found, "children")) {
    kind.elements << words_of(each);
  }
  return kind;
}

std::vector<Kind> Catalog::members(const QString& list) const {
  const Json& declared = member(member(answer_, "elements"), list.toUtf8().constData());
  if (const QString kind = text_of(declared, "holds"); !kind.isEmpty()) {
    return plugins(kind);
  }
  std::vector<Kind> kinds;
  if (const auto holder = element(list)) {
    for (const QString& name : holder->elements) {
      if (auto member = element(name)) {
        kinds.push_back(std::move(*member));
      }
    }
  }
  return kinds;
}

std::optional<Kind> Catalog::kind_of(const ElementPlace& place) const {
  return place.element
             ? kind_of(name_of(*place.element), place.parent ? name_of(*place.parent) : QString())
             : std::nullopt;
}

std::optional<Kind> Catalog::kind_of(const QString& name, const QString& holder) const {
  for (const Kind& each : members(holder)) {
    if (each.name == name) {
      return each;
    }
  }
  for (const Json& plugin : member(answer_, "plugins")) {
    for (const Json& each : member(plugin, "elements")) {
      if (text_of(each, "name") == name && text_of(plugin, "name") == holder) {
        Kind kind;
        kind.name = name;
        kind.description = text_of(each, "meaning");
        add_fields(kind, each, "parameters");
        return kind;
      }
    }
  }
  return element(name);
}

}  // namespace elsie::desktop
