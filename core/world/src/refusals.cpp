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

// <sensors>, <behaviors>, <coordinator>, <measures>, <drive>.
std::string group_of(PluginKind kind) {
  const std::string name(plugin::kind_name(kind));
  return kind == PluginKind::coordinator || kind == PluginKind::drive ? name : name + "s";
}

// The plugins that declare an element of this name.
std::vector<std::string> holders_of(const plugin::Host& host, const std::string& element) {
  std::vector<std::string> holders;
  for (const PluginKind kind : plugin::kPluginKinds) {
    for (const Declaration* plugin : host.all(kind)) {
      if (plugin::find_declared(plugin->elements, element)) {
        holders.push_back("<" + plugin->name + ">");
      }
    }
  }
  return holders;
}

}  // namespace

std::string explain_missing(const plugin::Host& host, PluginKind kind, const std::string& name) {
  for (const PluginKind other : plugin::kPluginKinds) {
    if (other != kind && host.find(other, name)) {
      return "'" + name + "' is a " + std::string(plugin::kind_name(other)) + "; it belongs in <" +
             group_of(other) + ">";
    }
  }
  return host.explain_missing(kind, name);
}

std::string explain_child(const plugin::Host& host, const Declaration& declaration,
                          const Element& child) {
  if (plugin::find_declared(declaration.parameters, child.name)) {
    return kAttributesOfItsElement;
  }
  const ElementSpec& coordination = coordination_vocabulary();
  if (!declaration.hold && coordination.child(child.name)) {
    std::vector<std::string> holders;
    for (const Declaration* other : host.all(PluginKind::behavior)) {
      if (other->hold) {
        holders.push_back("<" + other->name + ">");
      }
    }
    return holders.empty() ? "; no plugin that was found holds behaviours"
                           : "; plugins that hold behaviours: " + base::listed(holders);
  }
  std::vector<std::string> names;
  for (const ElementDeclaration& element : declaration.elements) {
    names.push_back("<" + element.name + ">");
  }
  if (declaration.hold) {
    for (const PluginKind kind : plugin::kPluginKinds) {
      if (host.find(kind, child.name)) {
        return "; a " + std::string(plugin::kind_name(kind)) + " belongs in " +
               (kind == PluginKind::sensor || kind == PluginKind::drive ? "the robot's"
                : kind == PluginKind::measure                           ? "the world's"
                                                                        : "its") +
               " <" + group_of(kind) + ">";
      }
    }
    for (const ElementSpec& group : coordination.children) {
      names.push_back("<" + group.name + ">");
    }
  }
  const std::vector<std::string> others = holders_of(host, child.name);
  return !others.empty() ? "; it belongs in " + base::listed(others)
         : names.empty() ? kAttributesOfItsElement
                         : base::near_or_all("<" + child.name + ">", names, "it may hold");
}

}  // namespace elsie::world
