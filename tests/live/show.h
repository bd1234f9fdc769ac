// A run in a thread of its own that clients watch on a free port.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "elsie/live/live_run.h"
#include "elsie/simulation/simulation.h"

#include "client.h"
#include "lively.h"

namespace elsie::test {

/// So slow that the run stands at its first steps until a client wants otherwise.
constexpr double kNearlyStill = 1e-4;

class Show {
 public:
  explicit Show(world::World world, double speed = kNearlyStill,
                const plugin::Host& host = shipped(), std::vector<simulation::TimedEdit> edits = {},
                std::vector<simulation::Observer*> observers = {})
      : simulation_(world, host, {.seed = 3}),
        live_(live::Address{.port = 0},
              {.speed = speed,
               .origins = {"https://viewer.example.org"},
               .program = "elsie test",
               .is_interrupted = [this] { return is_over_.load(); },
               .warn = [this](const std::string& text) { warnings.push_back(text); }}) {
    live_.open(simulation_, {[world, &host] {
                               return std::make_unique<Simulation>(world, host,
                                                                   simulation::Options{.seed = 3});
                             },
                             edits, ""});
    observers.push_back(&live_);
    thread_ = std::thread([this, edits = std::move(edits), observers = std::move(observers)] {
      result_ = simulation_.run(observers, edits);
      has_ended_ = true;
      has_ended_.notify_all();
      live_.linger(simulation_);
    });
  }
  ~Show() { finish(); }
  Show(const Show&) = delete;
  Show& operator=(const Show&) = delete;

  std::uint16_t port() const { return live_.address().port; }
  live::Counts counts() const { return live_.counts(); }
  bool has_ended() const { return has_ended_; }
  /// Waits for the end of the run, not of the show.
  const simulation::RunResult& result() {
    has_ended_.wait(false);
    return result_;
  }
  void finish() {
    is_over_ = true;
    if (thread_.joinable()) thread_.join();
  }

  std::vector<std::string> warnings;

 private:
  Simulation simulation_;
  std::atomic<bool> is_over_ = false, has_ended_ = false;
  simulation::RunResult result_;
  live::LiveRun live_;
  std::thread thread_;
};

/// The channels of an advertisement, by topic.
inline std::map<std::string, nlohmann::json> by_topic(const nlohmann::json& advertisement) {
  std::map<std::string, nlohmann::json> channels;
  for (const auto& channel : advertisement.at("channels")) {
    channels[channel.at("topic").get<std::string>()] = channel;
  }
  return channels;
}

/// Reads advertisements until these topics are among them; returns the ids of all.
inline std::map<std::string, std::uint32_t> ids_of(Client& client,
                                                   const std::vector<std::string>& topics) {
  std::map<std::string, std::uint32_t> ids;
  const auto is_there = [&](const std::string& topic) { return ids.contains(topic); };
  while (!std::all_of(topics.begin(), topics.end(), is_there)) {
    for (const auto& [topic, channel] : by_topic(client.text("advertise"))) {
      ids[topic] = channel.at("id").get<std::uint32_t>();
    }
  }
  return ids;
}

}  // namespace elsie::test
