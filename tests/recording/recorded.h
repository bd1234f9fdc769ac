// Runs that are recorded, and what is in the recordings.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "elsie/mcap/reader.h"
#include "elsie/recording/mcap_recorder.h"
#include "elsie/recording/recorded_run.h"
#include "elsie/world/reader.h"

#include "support.h"
#include "world_builder.h"

namespace elsie::test {

/// A message with its time and what it says.
struct Recorded {
  std::uint64_t time_ns = 0;
  nlohmann::json content;

  double time_s() const { return static_cast<double>(time_ns) * 1e-9; }
  /// The time in the message itself.
  double timestamp_s() const {
    const auto& timestamp = content.at("timestamp");
    return timestamp.at("sec").get<double>() + timestamp.at("nsec").get<double>() * 1e-9;
  }
};

/// All messages by topic. Those of channels without messages are empty lists.
inline std::map<std::string, std::vector<Recorded>> recorded(const std::filesystem::path& file) {
  std::map<std::string, std::vector<Recorded>> all;
  mcap::Reader reader(file);
  while (const auto message = reader.next()) {
    all[reader.channels().at(message->channel).topic].push_back(
        {message->log_time_ns, nlohmann::json::parse(message->data)});
  }
  for (const auto& [id, channel] : reader.channels()) {
    all[channel.topic];
  }
  return all;
}

/// Runs a simulation with a recorder.
inline simulation::RunResult record(simulation::Simulation& simulation,
                                    const std::filesystem::path& file,
                                    const recording::RecorderOptions& options = {}) {
  const auto recorder = recording::mcap_recorder(file, options);
  simulation::Observer* const observers[] = {recorder.get()};
  return simulation.run(observers);
}

/// The recording of a whole run.
struct RecordedFile : McapFile {
  RecordedFile(world::World world, const plugin::Host& host, const simulation::Options& how = {},
               recording::RecorderOptions options = {}) {
    simulation::Simulation simulation(std::move(world), host, how);
    result = record(simulation, path, std::move(options));
  }

  simulation::RunResult result;
};

/// A shipped world that ends after some time.
inline world::World shipped_world(const std::string& name, double duration_s) {
  world::ReadOptions options;
  options.data_directories = {source_path("")};
  world::World world = world::read_world(source_path("worlds/" + name), shipped(), options);
  world.limits.time = duration_s;
  return world;
}

}  // namespace elsie::test
