#pragma once

#include <array>
#include <string_view>

#include "elsie/api/declaration.h"

namespace elsie::plugin {

/// All kinds, in the order in which they are listed.
inline constexpr std::array kPluginKinds{PluginKind::sensor, PluginKind::behavior,
                                         PluginKind::coordinator, PluginKind::measure,
                                         PluginKind::drive};

/// "sensor", "behavior", "coordinator", "measure" or "drive": as written in a world file.
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
    case PluginKind::drive:
      return "drive";
  }
  return "plugin";  // a kind made up by a faulty library
}

}  // namespace elsie::plugin
