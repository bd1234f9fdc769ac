#pragma once

#include <array>
#include <string>
#include <string_view>

#include "elsie/api/declaration.h"

namespace elsie::plugin {

/// All kinds, in the order in which they are listed.
inline constexpr std::array kPluginKinds{
    PluginKind::sensor, PluginKind::behavior, PluginKind::coordinator,  PluginKind::measure,
    PluginKind::rule,   PluginKind::drive,    PluginKind::localisation, PluginKind::actuator};

/// "sensor", "behavior", "coordinator", "measure", "rule", "drive", "localisation" or "actuator":
/// as written in a world file.
constexpr std::string_view kind_name(PluginKind kind) {
  switch (kind) {
    case PluginKind::sensor:
      return "sensor";
    case PluginKind::behavior:
      return "behavior";
    case PluginKind::coordinator:
      return "coordinator";
    case PluginKind::measure:
      return "measure";
    case PluginKind::rule:
      return "rule";
    case PluginKind::drive:
      return "drive";
    case PluginKind::localisation:
      return "localisation";
    case PluginKind::actuator:
      return "actuator";
  }
  return "plugin";  // a kind made up by a faulty library
}

/// "a sensor", "an actuator"
inline std::string kind_with_article(PluginKind kind) {
  const std::string_view name = kind_name(kind);
  return (name.front() == 'a' ? "an " : "a ") + std::string(name);
}

/// Whether it belongs to the world, not to a robot.
constexpr bool is_of_world(PluginKind kind) {
  return kind == PluginKind::measure || kind == PluginKind::rule;
}

/// Whether a robot has at most one of them, in an element with the name of the kind.
constexpr bool is_only_one(PluginKind kind) {
  return kind == PluginKind::coordinator || kind == PluginKind::drive ||
         kind == PluginKind::localisation;
}

}  // namespace elsie::plugin
