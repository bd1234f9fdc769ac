// The channels of a run: those of each robot, and their schemas.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "elsie/recording/message_sink.h"
#include "elsie/simulation/simulation.h"
#include "elsie/traces/trace_rows.h"

#include "graph_news.h"
#include "messages.h"
#include "published.h"

namespace elsie::recording {

VisitAllPublished published_of(const simulation::Simulation& simulation, std::size_t robot);
VisitAllPublished published_of_measures(const simulation::Simulation& simulation);

/// Adds channels to a sink, which must outlive it.
class Channels {
 public:
  explicit Channels(MessageSink& out) : out_(out) {}

  /// Adds each schema once, whatever it is used for.
  std::uint32_t schema(const std::string& name);
  std::uint32_t schema(const std::string& name, const std::string& text);
  std::uint32_t add(const std::string& topic, std::uint32_t schema,
                    const std::map<std::string, std::string>& metadata = {});
  /// Of a robot.
  std::uint32_t add(const world::Robot& robot, const std::string& kind, std::uint32_t schema);

 private:
  MessageSink& out_;
  std::map<std::string, std::uint32_t> schemas_;  // by name and text
};

struct CameraChannels {
  std::size_t sensor;
  std::map<std::string, std::uint32_t, std::less<>> of;  // by the names of its pictures
};

struct RobotChannels {
  std::size_t place;  // in the simulation
  std::uint32_t pose, state, readings, command, trace;
  std::optional<std::uint32_t> belief, published;
  std::optional<std::uint32_t> sketches, heard, graphs, lit;  // each from the first on
  std::vector<CameraChannels> cameras;
  TraceTexts texts;
  std::string kind;
  traces::TraceRows rows{};
  GraphNews graph_news{};
};

/// All of them.
std::vector<std::uint32_t> ids_of(const RobotChannels& channels);

/// The facts that determine a robot's channels.
std::string kind_of(const simulation::Simulation& simulation, std::size_t robot);

/// Adds those of a robot. `images`: also those of its cameras.
RobotChannels robot_channels(Channels& channels, const simulation::Simulation& simulation,
                             std::size_t robot, bool images);

}  // namespace elsie::recording
