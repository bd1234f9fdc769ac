#include "schemas.h"

#include "primitives.h"
#include "schema_parts.h"

namespace elsie::recording::schemas {
namespace {

Json heading() { return number("the rotation about z, rad, to the last digit"); }

constexpr const char* kDecided = "simulated time of the decision";

}  // namespace

std::string frame_transforms() {
  return object("foxglove.FrameTransforms",
                {{"transforms",
                  list(object("foxglove.FrameTransform", {{"timestamp", time()},
                                                          {"parent_frame_id", text()},
                                                          {"child_frame_id", text()},
                                                          {"translation", vector()},
                                                          {"rotation", quaternion()},
                                                          {"heading_rad", heading()}}))}})
      .dump();
}

std::string pose_in_frame() {
  return object("foxglove.PoseInFrame",
                {{"timestamp", time()}, {"frame_id", text()}, {"pose", pose()}})
      .dump();
}

std::string scene_update() {
  const Json deletion = object(
      "foxglove.SceneEntityDeletion",
      {{"timestamp", time()},
       {"type", choice("foxglove.SceneEntityDeletionType", {{"MATCHING_ID", 0}, {"ALL", 1}})},
       {"id", text()}});
  const Json pair = object("foxglove.KeyValuePair", {{"key", text()}, {"value", text()}});
  const Json entity = object("foxglove.SceneEntity", {{"timestamp", time()},
                                                      {"frame_id", text()},
                                                      {"id", text()},
                                                      {"lifetime", time("duration")},
                                                      {"frame_locked", boolean()},
                                                      {"metadata", list(pair)},
                                                      {"arrows", list(primitives::arrow())},
                                                      {"cubes", list(primitives::cube())},
                                                      {"spheres", list(primitives::sphere())},
                                                      {"cylinders", list(primitives::cylinder())},
                                                      {"lines", list(primitives::line())},
                                                      {"triangles", list(primitives::triangles())},
                                                      {"texts", list(primitives::text())},
                                                      {"models", list(primitives::model())}});
  return object("foxglove.SceneUpdate", {{"deletions", list(deletion)}, {"entities", list(entity)}})
      .dump();
}

std::string compressed_image() {
  return object("foxglove.CompressedImage",
                {{"timestamp", time("time", "simulated time at which it was taken")},
                 {"frame_id", text()},
                 {"data", base64_text("the picture")},
                 {"format", text("png")}})
      .dump();
}

std::string point_cloud() {
  const Json type = choice("foxglove.NumericType", {{"UNKNOWN", 0},
                                                    {"UINT8", 1},
                                                    {"INT8", 2},
                                                    {"UINT16", 3},
                                                    {"INT16", 4},
                                                    {"UINT32", 5},
                                                    {"INT32", 6},
                                                    {"FLOAT32", 7},
                                                    {"FLOAT64", 8}});
  const Json field = object("foxglove.PackedElementField",
                            {{"name", text()}, {"offset", integer("bytes")}, {"type", type}});
  return object("foxglove.PointCloud",
                {{"timestamp", time()},
                 {"frame_id", text()},
                 {"pose", pose()},
                 {"point_stride", integer("bytes from one robot to the next")},
                 {"fields", list(field)},
                 {"data", base64_text("a point for each robot of the world's `crowd`")}})
      .dump();
}

std::string log() {
  return object("foxglove.Log", {{"timestamp", time()},
                                 {"level", choice("foxglove.LogLevel", {{"UNKNOWN", 0},
                                                                        {"DEBUG", 1},
                                                                        {"INFO", 2},
                                                                        {"WARNING", 3},
                                                                        {"ERROR", 4},
                                                                        {"FATAL", 5}})},
                                 {"message", text("event and detail")},
                                 {"name", text("the robot")},
                                 {"file", text("empty")},
                                 {"line", integer("0")},
                                 {"event", text("its name, such as collision")},
                                 {"detail", text("with what, which resource, what was changed...")},
                                 {"element", text("that an edit changes"), false},
                                 {"attribute", text("empty: the element as a whole"), false},
                                 {"value", text("that it gets"), false},
                                 {"x_m", number("where the robot was"), false},
                                 {"y_m", number(), false}})
      .dump();
}

std::string world() {
  return object("elsie.World",
                {{"name", text()},
                 {"file", text("that it was read from")},
                 {"seed", text("of all randomness in the run; it may have 20 digits")},
                 {"program", text("that ran it")},
                 {"xml", text("the world file, templates merged in")},
                 {"robots", list(text("id of a robot that is there"))},
                 {"crowd",
                  list(text("id of a robot without channels of its own"),
                       "in the order of the points in the crowd; missing: none"),
                  false},
                 {"start_xml",
                  text("the same at the start, with the edits that the run was given among its "
                       "changes; missing: xml"),
                  false}})
      .dump();
}

std::string state() {
  return object("elsie.State", {{"timestamp", time()},
                                {"x_m", number()},
                                {"y_m", number()},
                                {"heading_rad", number("counter-clockwise from +x, in (-pi, pi]")},
                                {"forward_m_s", number("along the heading")},
                                {"lateral_m_s", number("to the left")},
                                {"turn_rad_s", number("counter-clockwise")},
                                {"distance_m", number("driven since the start")},
                                {"energy", number("units in the battery")},
                                {"collisions", integer("since the start")}})
      .dump();
}

std::string readings(const Json& sensors) {
  return object("elsie.Readings", {{"timestamp", time("time", kDecided)},
                                   {"sensors", members(sensors, "by the ids of the sensors")}})
      .dump();
}

std::string command() {
  return object("elsie.Command", {{"timestamp", time("time", kDecided)},
                                  {"asked_forward_m_s", number("by the coordinator")},
                                  {"asked_lateral_m_s", number()},
                                  {"asked_turn_rad_s", number()},
                                  {"forward_m_s", number("that the drive makes of it")},
                                  {"lateral_m_s", number("to the left")},
                                  {"turn_rad_s", number("counter-clockwise")}})
      .dump();
}

std::string trace() {
  const Json behavior =
      object("elsie.TraceRow",
             {{"path", text("ids from the robot on, such as explore/avoid_obstacle")},
              {"plugin", text("the behaviour's")},
              {"coordinator", text("the plugin that decides about it")},
              {"asked", boolean("whether it was; otherwise its command is zero")},
              {"forward_m_s", number("what it wished for")},
              {"lateral_m_s", number()},
              {"turn_rad_s", number()},
              {"activation", number()},
              {"strength", number()},
              {"weight", number()},
              {"share", number("in the command of its coordinator")},
              {"inhibited_by", text("path of the behaviour that silenced it, or empty")},
              {"reason", text("the coordinator's")},
              {"time_s", number("how long it took to answer, where that was measured"), false}});
  return object("elsie.Trace", {{"timestamp", time("time", kDecided)},
                                {"asked_forward_m_s", number("by the coordinator")},
                                {"asked_lateral_m_s", number()},
                                {"asked_turn_rad_s", number()},
                                {"forward_m_s", number("that the drive makes of it")},
                                {"lateral_m_s", number()},
                                {"turn_rad_s", number()},
                                {"behaviors", list(behavior, "each before those inside it")}})
      .dump();
}

}  // namespace elsie::recording::schemas
