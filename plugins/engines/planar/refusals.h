// What the planar engine cannot simulate, in sentences.
#pragma once

#include <optional>
#include <string>

#include "elsie/world/description.h"

namespace elsie::physics {

/// The number of equal parts in which the engine does a step of this length, s.
int parts_of(double step);

std::optional<std::string> fault_of(const world::Physics& physics);
/// Begins with `what`: "the box 'crate'".
std::optional<std::string> fault_of(const world::Obstacle& box, const std::string& what);
std::optional<std::string> fault_of_height(double z, const std::string& what);
std::optional<std::string> fault_of(const BodyPlan& plan, const std::string& what);

}  // namespace elsie::physics
