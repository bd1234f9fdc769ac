#include "refusals.h"

#include "elsie/base/near_name.h"
#include "elsie/base/words.h"
#include "elsie/plugin/host.h"
#include "elsie/plugin/kind_name.h"
#include "elsie/plugin/parameters.h"
#include "elsie/world/vocabulary.h"

namespace elsie::world {

namespace {

constexpr const char* kAttributesOfItsElement =
    "; the parameters of a plugin are attributes of its element";

// The group of a kind of plugins: <sensors>, <behaviors>, <coordinator>.
std::string group_of(PluginKind kind) {
  const std::string name(plugin::kind_name(kind));
  return plugin::is_only_one(kind) ? name : name + "s";
}

// The plugins for which `holds` is true, as tags.
template <class Function>
std::string holders(const plugin::Host& host, const Function& holds) {
  std::vector<std::string> tags;
  for (const PluginKind kind : plugin::kPluginKinds) {
    for (const Declaration* plugin : host.all(kind)) {
      if (holds(*plugin)) {
        tags.push_back("<" + plugin->name + ">");
      }
    }
  }
  return base::listed(tags);
}

}  // namespace

std::string explain_missing(const plugin::Host& host, PluginKind kind, const std::string& name) {
  for (const PluginKind other : plugin::kPluginKinds) {
    if (other != kind && host.find(other, name)) {
      return "'" + name + "' is " + plugin::kind_with_article(other) + "; it belongs in <" +
             group_of(other) + ">";
    }
  }
  return host.explain_missing(kind, name);
}

std::string explain_child(const plugin::Host& host, const Declaration& declaration,
                          const Element& child) {
  if (plugin::find_declared(declaration.parameters, child.name)) return kAttributesOfItsElement;
  const ElementSpec& coordination = coordination_vocabulary();
  if (!declaration.hold && coordination.child(child.name)) {
    const std::string able = holders(host, [](const Declaration& each) { return !!each.hold; });
    return able.empty() ? "; no plugin that was found holds behaviours"
                        : "; plugins that hold behaviours: " + able;
  }
  std::vector<std::string> names = tags_of(declaration.elements);
  if (declaration.hold) {
    for (const PluginKind kind : plugin::kPluginKinds) {
      if (host.find(kind, child.name)) {
        return "; a " + std::string(plugin::kind_name(kind)) + " belongs in " +
               (kind == PluginKind::behavior || kind == PluginKind::coordinator ? "its"
                : plugin::is_of_world(kind)                                     ? "the world's"
                                                                                : "the robot's") +
               " <" + group_of(kind) + ">";
      }
    }
    for (std::string& group : tags_of(coordination.children)) {
      names.push_back(std::move(group));
    }
  }
  const std::string others = holders(host, [&](const Declaration& each) {
    return plugin::find_declared(each.elements, child.name) != nullptr;
  });
  return !others.empty() ? "; it belongs in " + others
         : names.empty() ? kAttributesOfItsElement
                         : base::near_or_all("<" + child.name + ">", names, "it may hold");
}

std::string explain_inner(const plugin::DeclaredElement& declared, const Element& child) {
  if (plugin::find_declared(declared.parameters(), child.name)) {
    return "; its parameters are attributes";
  }
  std::vector<std::string> names = declared.names_inside();
  for (std::string& name : names) name = "<" + name + ">";
  return names.empty() ? "; expected nothing in it"
                       : base::near_or_all("<" + child.name + ">", names, "it may hold");
}

std::string on_line(const Location& where, const Location& from) {
  return where.is_edit()   ? " (" + where.file.text() + ")"
         : where.line == 0 ? ""
         : where.file == from.file
             ? " (line " + std::to_string(where.line) + ")"
             : " (" + where.file.text() + ":" + std::to_string(where.line) + ")";
}

}  // namespace elsie::world
