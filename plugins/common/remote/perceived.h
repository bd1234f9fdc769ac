// What a program is told, as JSON: docs/any-language.md has the protocol.
#pragma once

#include <nlohmann/json.hpp>

#include <elsie/api/perception.h>

namespace remote {

/// Keeps the order of its fields.
using Json = nlohmann::ordered_json;

inline constexpr int kProtocol = 1;

/// What stays the same in a run unless the robot is edited: the robot and its sensors.
Json facts(const elsie::Perception& now, const char* role);

/// What the robot perceives now.
Json perceived(const elsie::Perception& now);

Json motion(const elsie::Motion& motion);

}  // namespace remote
