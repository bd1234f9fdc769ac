// The shapes of obstacles in world files; core/world/src/obstacle_shapes.cpp says what they are
// there.
#pragma once

#include <array>
#include <cstdint>

namespace elsie {

enum class ObstacleShape : std::uint8_t { box, cylinder, prism };
/// In the same order: "cylinder" of the elements "static_cylinder", "dynamic_cylinder"...
inline constexpr std::array kBoxShapes{"box", "cylinder", "prism"};

}  // namespace elsie
