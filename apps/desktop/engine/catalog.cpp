#include "engine/catalog.h"

#include <QCoreApplication>

namespace elsie::desktop {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("elsie::desktop", text); }

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

/// A plugin's own element, or one that it declares, at whatever depth: plugin::DeclaredElement, of
/// what the engine says.
class Declared {
 public:
  explicit Declared(const Json& plugin) : own_(&plugin), among_(&member(plugin, "elements")) {}

  const Json& json() const { return *own_; }
  /// All that may stand in it.
  std::vector<Declared> inside() const {
    std::vector<Declared> all;
    if (is_inner_) {
      const Json& own = member(*own_, "elements");
      for (const Json& each : own) all.push_back(Declared(each, own));
    }
    for (const Json& each : *among_) {
      const bool is_beside =
          member(*own_, "nests") == true && member(each, "list") == member(*own_, "list");
      if (!is_inner_ || is_beside) all.push_back(Declared(each, *among_));
    }
    return all;
  }
  std::optional<Declared> inside(const QString& name) const {
    for (const Declared& each : inside()) {
      if (text_of(*each.own_, "name") == name) return each;
    }
    return std::nullopt;
  }
  Kind kind() const {
    Kind kind;
    kind.name = text_of(*own_, "name");
    kind.description = text_of(*own_, is_inner_ ? "meaning" : "description");
    kind.is_of_plugin = true;
    add_fields(kind, *own_, "parameters");
    for (const Declared& each : inside()) kind.elements << text_of(*each.own_, "name");
    return kind;
  }

 private:
  Declared(const Json& element, const Json& among)
      : own_(&element), among_(&among), is_inner_(true) {}

  const Json* own_;
  const Json* among_;  // the elements where it is declared
  bool is_inner_ = false;
};

Kind plugin_of(const Json& json) {
  Kind kind = Declared(json).kind();
  kind.holds_behaviors = json.value("holds_behaviors", false);
  for (const auto& [name, list] : {std::pair("needs", &kind.needs), {"produces", &kind.produces}}) {
    for (const Json& each : member(json, name)) {
      *list << words_of(each);
    }
  }
  return kind;
}

/// Adds the attributes that all plugins of its kind may have in a world: the place of a sensor, the
/// priority of a behaviour.
void add_common(Kind& plugin, const std::optional<Kind>& common) {
  if (!common) return;
  plugin.fields.insert(plugin.fields.begin(), common->fields.begin(), common->fields.end());
  plugin.can_be_removed = common->can_be_removed;
}

const Json* plugin_named(const Json& answer, const QString& kind, const QString& name) {
  for (const Json& each : member(answer, "plugins")) {
    if (text_of(each, "name") == name && text_of(each, "kind") == kind) return &each;
  }
  return nullptr;
}

/// The last of these elements, if it is a plugin or stands in one.
std::optional<Declared> declared_at(const Json& answer, const QStringList& names) {
  std::optional<Declared> at;
  for (qsizetype i = 1; i < names.size(); ++i) {
    const Json& holder = member(member(answer, "elements"), names[i - 1].toUtf8().constData());
    const QString holds = text_of(holder, "holds");
    const Json* const plugin = holds.isEmpty() ? nullptr : plugin_named(answer, holds, names[i]);
    auto inner = at ? at->inside(names[i]) : std::nullopt;
    at = inner ? inner : plugin ? std::optional(Declared(*plugin)) : std::nullopt;
  }
  return at;
}

}  // namespace

std::vector<Kind> Catalog::plugins(const QString& kind) const {
  const auto common = element(kind);
  std::vector<Kind> kinds;
  for (const Json& each : member(answer_, "plugins")) {
    if (text_of(each, "kind") == kind) {
      add_common(kinds.emplace_back(plugin_of(each)), common);
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
  return place.element ? kind_of(place.around + QStringList{name_of(*place.element)})
                       : std::nullopt;
}

std::optional<Kind> Catalog::kind_of(const QStringList& names) const {
  const auto declared = declared_at(answer_, names);
  if (!declared) return names.isEmpty() ? std::nullopt : element(names.back());
  const QString plugin = text_of(declared->json(), "kind");
  if (plugin.isEmpty()) return declared->kind();
  Kind kind = plugin_of(declared->json());
  add_common(kind, element(plugin));
  return kind;
}

std::vector<Kind> Catalog::declared_in(const ElementPlace& place) const {
  std::vector<Kind> kinds;
  const auto declared =
      place.element ? declared_at(answer_, place.around + QStringList{name_of(*place.element)})
                    : std::nullopt;
  if (declared) {
    for (const Declared& each : declared->inside()) kinds.push_back(each.kind());
  }
  return kinds;
}

}  // namespace elsie::desktop
