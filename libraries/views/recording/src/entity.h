// Parts of scenes for viewers (foxglove.SceneEntity).
#pragma once

#include <cstdint>
#include <string>

#include "elsie/api/geometry.h"
#include "elsie/api/image.h"

#include "format.h"

namespace elsie::recording {

Json colour_json(const Colour& colour, double opacity = 1.0);
Json pose_json(const Frame& frame);
/// An entity to which primitives are added. It stays for ever.
Json entity(std::uint64_t time_ns, const std::string& id, const std::string& frame);

}  // namespace elsie::recording
