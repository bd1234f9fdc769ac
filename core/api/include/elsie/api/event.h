// Named events.
#pragma once

#include <string_view>

namespace elsie {

/// Something that a behaviour or the simulator says has happened: an element of the finite event
/// space of a robot. `name` refers to text that lives as long as the plugin, in practice a literal;
/// a behaviour raises only events that its declaration names (elsie::raises()).
struct Event {
  std::string_view name;
};

}  // namespace elsie
