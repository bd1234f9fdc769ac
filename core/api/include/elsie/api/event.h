// Named events.
#pragma once

#include <string>

namespace elsie {

/// An event that a behaviour or the simulator raises: an element of the finite event space of a
/// robot. A behaviour raises only events that its declaration names (elsie::raises()).
struct Event {
  std::string name;
};

}  // namespace elsie
