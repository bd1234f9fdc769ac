// Named events.
#pragma once

#include <string_view>

namespace elsie {

/// An event that a behaviour or the simulator raises: an element of the finite event space of a
/// robot. `name` refers to text that lives as long as the plugin, usually a literal. A behaviour
/// raises only events that its declaration names (elsie::raises()).
struct Event {
  std::string_view name;
};

}  // namespace elsie
