// Words for what a robot perceives: the inputs that a fuzzy model of contexts may have.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <elsie/api/perception.h>

/// One of the words. docs/coordinators/fusion_context_blending.md has the table for users.
struct PerceptionInput {
  const char* name;
  /// Its value now; finite wherever the robot has what it takes. Angles in degrees.
  double (*value)(const elsie::Perception& now);
  /// What a robot needs for it, if it needs anything: "a beam-range sensor that looks to the left".
  const char* needs;
  /// Whether the robot has that.
  bool (*available)(const elsie::Perception& example);
};

std::span<const PerceptionInput> perception_inputs();

/// The word of that name, in any letter case, or none.
const PerceptionInput* find_perception_input(std::string_view name);

/// "; did you mean 'front_range'?" or nothing, to end a sentence about a name that is none.
std::string perception_input_hint(std::string_view name);
