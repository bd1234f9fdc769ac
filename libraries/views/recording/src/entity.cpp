#include "entity.h"

#include "messages.h"

namespace elsie::recording {

Json colour_json(const Colour& colour, double opacity) {
  return {{"r", colour.red / 255.0},
          {"g", colour.green / 255.0},
          {"b", colour.blue / 255.0},
          {"a", opacity}};
}

Json pose_json(const Frame& frame) {
  return {{"position", position_json(frame.origin)}, {"orientation", rotation_json(frame)}};
}

Json entity(std::uint64_t time_ns, const std::string& id, const std::string& frame) {
  Json made{{"timestamp", time_json(time_ns)},
            {"frame_id", frame},
            {"id", id},
            {"lifetime", time_json(0)},  // for ever
            {"frame_locked", true}};
  for (const char* list : {"metadata", "arrows", "cubes", "spheres", "cylinders", "lines",
                           "triangles", "texts", "models"}) {
    made[list] = Json::array();
  }
  return made;
}

}  // namespace elsie::recording
