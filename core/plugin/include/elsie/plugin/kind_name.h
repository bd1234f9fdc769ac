#pragma once

#include <string_view>

#include "elsie/api/declaration.h"

namespace elsie::plugin {

/// "sensor", "behavior" or "coordinator": as written in a world file.
constexpr std::string_view kind_name(PluginKind kind) {
  switch (kind) {
    case PluginKind::sensor:
      return "sensor";
    case PluginKind::behavior:
      return "behavior";
    case PluginKind::coordinator:
      return "coordinator";
  }
  return "plugin";  // a kind made up by a faulty library
}

}  // namespace elsie::plugin
