// Names in a recording, shared by its writer and its reader.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace elsie::recording {

using Json = nlohmann::ordered_json;  // members always keep their order

// Metadata: at the start, and at the end.
constexpr const char* kRunMetadata = "elsie.run";
constexpr const char* kResultMetadata = "elsie.result";
constexpr const char* kMeasuresMetadata = "elsie.measures";
constexpr const char* kStopped = "stopped";  // an outcome: a plugin failed, or the user ended it
constexpr const char* kEndTime = "simulated_s";

constexpr const char* kWorldTopic = "/world";
constexpr const char* kSceneTopic = "/scene";
constexpr const char* kTransformsTopic = "/tf";
constexpr const char* kEventsTopic = "/events";
constexpr const char* kCrowdTopic = "/crowd";
// Of measures.
constexpr const char* kSketchesTopic = "/sketches";
constexpr const char* kPublishedTopic = "/published";

// Kinds of a robot's channels.
constexpr const char* kSketchesKind = "sketches";
constexpr const char* kBeliefKind = "belief";
constexpr const char* kPublishedKind = "published";
constexpr const char* kReadingsKind = "readings";
constexpr const char* kHeardKind = "heard";
constexpr const char* kGraphsKind = "graphs";
constexpr const char* kLitKind = "lit";
constexpr const char* kPublishedNumbers =
    "numbers";  // its metadata: the numbers and their units, as JSON

/// "/robots/r1/pose"
inline std::string robot_topic(std::string_view robot, std::string_view kind) {
  return "/robots/" + std::string(robot) + "/" + std::string(kind);
}

// Metadata of a robot's channel "trace": the plugin of the outermost coordinator, and the constant
// facts about the behaviours, as JSON.
constexpr const char* kTraceKind = "trace";
constexpr const char* kCoordinator = "coordinator";
constexpr const char* kBehaviors = "behaviors";

// foxglove.LogLevel of events.
constexpr int kInfo = 2;
constexpr int kWarning = 3;

// Frames: the world, robots and their segments, boxes that may move.
constexpr const char* kWorldFrame = "world";
inline std::string robot_frame(std::string_view robot) { return "robot/" + std::string(robot); }
inline std::string segment_frame(std::string_view robot, std::string_view segment) {
  return robot_frame(robot) + "/" + std::string(segment);
}
/// Also the entity of any box in the scene.
inline std::string box_frame(std::string_view box) { return "box/" + std::string(box); }
constexpr const char* kStart = "start";  // metadata of that entity: x, y, heading (rad) as JSON

}  // namespace elsie::recording
