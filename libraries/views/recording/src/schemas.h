// The JSON schemas of the channels. Those whose names begin with "foxglove." have the members that
// Foxglove's documentation gives for them (https://docs.foxglove.dev/docs/sdk/schemas), so that
// viewers draw them; Elsie adds its own members. The schemas use only what viewers understand:
// objects with properties, arrays, and plain values.
#pragma once

#include <string>

#include "schema_parts.h"

namespace elsie::recording::schemas {

std::string frame_transforms();
std::string pose_in_frame();
std::string scene_update();
std::string compressed_image();
std::string log();
std::string point_cloud();

std::string world();
std::string state();
/// The readings of a robot. `sensors`: the schemas of its sensors' numbers, by their ids, which
/// viewers offer for plots.
std::string readings(const Json& sensors);
std::string command();
std::string trace();

}  // namespace elsie::recording::schemas
