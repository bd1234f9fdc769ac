// Names of a robot's perceptions: the inputs of fuzzy models of contexts.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <elsie/api/perception.h>

/// One of the inputs. docs/coordinators/fusion_context_blending.md has the table for users.
struct PerceptionInput {
  const char* name;
  /// Its current value; finite if the robot has what it needs. Angles in degrees.
  double (*value)(const elsie::Perception& now);
  /// What a robot needs for it: "a beam-range sensor that looks to the left"; empty if nothing.
  const char* needs;
  /// True if the robot has this part.
  bool (*available)(const elsie::Perception& example);
};

std::span<const PerceptionInput> perception_inputs();

/// Finds the input of this name, in any letter case; null if there is none.
const PerceptionInput* find_perception_input(std::string_view name);

/// Returns "; did you mean 'front_range'?" or "", to end a sentence about an unknown name.
std::string perception_input_hint(std::string_view name);
