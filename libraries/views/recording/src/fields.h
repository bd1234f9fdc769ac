// Fields of the floor in recordings: a foxglove.Grid for each, at most once a second.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "elsie/picture/floor_field.h"

#include "format.h"

namespace elsie::recording {

/// A recorded field has at most so many columns and rows.
constexpr std::size_t kMostFieldCells = 256;

/// "/fields/pheromone"
inline std::string field_topic(const std::string& id) { return "/fields/" + id; }

/// The text of the message. `length`, `width`: of the arena, m.
std::string field_text(std::uint64_t time_ns, const picture::FloorField& field, double length,
                       double width);

/// The field of a message, without a colour, which the world has. Throws Json::exception or
/// Unexpected for one that Elsie did not write.
picture::FloorField recorded_field(const std::string& topic, const Json& message);

}  // namespace elsie::recording
