// The channels of a recording: those of each robot, and their schemas.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "elsie/mcap/writer.h"
#include "elsie/simulation/simulation.h"
#include "elsie/traces/trace_rows.h"

#include "graph_news.h"
#include "messages.h"
#include "published.h"

namespace elsie::recording {

VisitAllPublished published_of(const simulation::Simulation& simulation, std::size_t robot);
VisitAllPublished published_of_measures(const simulation::Simulation& simulation);

/// Adds channels to a file. The writer must outlive it.
class Channels {
 public:
  explicit Channels(mcap::Writer& out) : out_(out) {}

  /// Adds each schema once, whatever it is used for.
  std::uint16_t schema(const std::string& name);
  std::uint16_t schema(const std::string& name, const std::string& text);
  std::uint16_t add(const std::string& topic, std::uint16_t schema,
                    std::map<std::string, std::string> metadata = {});
  /// Of a robot.
  std::uint16_t add(const world::Robot& robot, const std::string& kind, std::uint16_t schema);

 private:
  mcap::Writer& out_;
  std::map<std::string, std::uint16_t> schemas_;  // by name and text
};

struct CameraChannels {
  std::size_t sensor;
  std::map<std::string, std::uint16_t, std::less<>> of;  // by the names of its pictures
};

struct RobotChannels {
  std::size_t place;  // in the simulation
  std::uint16_t pose, state, readings, command, trace;
  std::optional<std::uint16_t> belief, published;
  std::optional<std::uint16_t> sketches, heard, graphs, lit;  // each from the first on
  std::vector<CameraChannels> cameras;
  TraceTexts texts;
  std::string kind;
  traces::TraceRows rows{};
  GraphNews graph_news{};
};

/// The facts that determine a robot's channels.
std::string kind_of(const simulation::Simulation& simulation, std::size_t robot);

/// Adds those of a robot. `images`: also those of its cameras.
RobotChannels robot_channels(Channels& channels, const simulation::Simulation& simulation,
                             std::size_t robot, bool images);

}  // namespace elsie::recording
