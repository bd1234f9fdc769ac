// The JSON schemas of the channels. Those whose names begin with "foxglove." have the members that
// Foxglove's documentation gives for them (https://docs.foxglove.dev/docs/sdk/schemas), so that
// viewers draw them; members that are Elsie's own stand beside these. Only such schemas are used as
// viewers understand: objects with properties, arrays, and plain values.
#pragma once

#include <string>

#include "schema_parts.h"

namespace elsie::recording::schemas {

std::string frame_transforms();
std::string pose_in_frame();
std::string scene_update();
std::string compressed_image();
std::string log();

std::string world();
std::string state();
/// Of a robot, `sensors` being the schemas of its sensors' numbers by their ids: viewers list for
/// plots what a schema names.
std::string readings(const Json& sensors);
std::string command();
std::string trace();

}  // namespace elsie::recording::schemas
