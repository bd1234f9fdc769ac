// The messages of a recording. Each is one JSON object.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/api/image.h"
#include "elsie/api/reading.h"
#include "elsie/simulation/simulation.h"

#include "format.h"

namespace elsie::recording {

/// The text of a message; what is not UTF-8 is replaced.
std::string text_of(const Json& message);

Json time_json(std::uint64_t time_ns);
/// A duration or a time in whole ns.
std::uint64_t nanoseconds(double time_s);

Json position_json(const Vector3& position);
/// The rotation from the axes of the world to those of a frame.
Json rotation_json(const Frame& frame);
/// A frame flat on the floor.
Frame frame_of(const Pose& pose, double z = 0.0);

/// The text of the message about the world. `crowd`: places of robots without channels.
std::string world_text(const simulation::Simulation& simulation, const std::string& program,
                       std::span<const std::size_t> crowd);
/// Adds a field of a reading to the properties of its sensor in a schema: an array is an array, a
/// list of structs one of objects. Pictures have channels of their own.
void add_to_schema(const ReadingField& field, Json& properties);
/// Adds the field to the message of its sensor.
void add_to_message(const ReadingField& field, Json& sensor);
Json pose_message(std::uint64_t time_ns, const Pose& pose);
Json state_message(std::uint64_t time_ns, const simulation::Simulation& simulation,
                   std::size_t robot);
Json command_message(std::uint64_t decided_ns, const simulation::RobotView& robot);
/// The messages about a robot's decisions. There may be one for each control period, so their text
/// is built by hand. Numbers are rounded by traces::kept(); those that are not finite are left out.
class TraceTexts {
 public:
  explicit TraceTexts(const simulation::RobotView& robot);
  /// Valid until the next call.
  const std::string& message(std::uint64_t decided_ns, const simulation::RobotView& robot,
                             bool with_times);

 private:
  void add(const Motion& motion);
  void add(const char* name, double value);

  std::vector<std::string> starts_;  // the constant beginnings of the rows
  std::string text_;
};

/// The constant facts about a robot's behaviours: the metadata of its channel of traces.
std::map<std::string, std::string> trace_metadata(const simulation::RobotView& robot);
Json image_message(std::uint64_t decided_ns, std::string_view robot, const Image& image);
/// `where`: the robot's pose, or null.
Json event_message(std::uint64_t time_ns, const simulation::EventRecord& event, const Pose* where);
Json transform_json(std::uint64_t time_ns, const std::string& child, const Frame& frame,
                    double heading_rad);

}  // namespace elsie::recording
