// Coordinators with neural networks, two behaviours and two beams.
#pragma once

#include <cmath>
#include <exception>
#include <string>
#include <utility>

#include "elsie/neural/trainable.h"

#include "folder.h"
#include "shipped.h"
#include "situation.h"
#include "wheels.h"

namespace elsie::test {

inline const char* const kFusion = "fusion_neural_network";
inline const char* const kArbiter = "arbiter_neural_network";

using Object = plugin::Object<Coordinator>;

/// A coordinator with these parameters; with the reference samples unless others or weights are
/// given.
inline Object coordinator(const char* name, Parameters parameters = {}) {
  if (!parameters.contains("weights")) {
    parameters["weights"] = std::string();
    parameters.try_emplace("training", source_path("training_sets/two_sensors_two_behaviors.txt"));
  }
  parameters.try_emplace("training", std::string());
  return make<Coordinator>(PluginKind::coordinator, name, std::move(parameters));
}

/// Two behaviours, as in the reference samples.
inline void add_two_behaviors(Team& team) {
  team.member("avoid_obstacle", 1, wheels(-10, 10)).member("find_resource", 1, wheels(20, 20));
}

inline Situation beams(double left, double right) {
  Situation now;
  now.beam(15, left).beam(-15, right);
  return now;
}

/// Equips the coordinator for a robot with two beams, and trains it with a seed.
inline void start(Coordinator& object, Team& team, std::uint64_t seed = 1) {
  Situation now = beams(1, 1);
  object.equipped(team.members(), now.perception());
  Random random(seed);
  object.reset(random);
}

/// The command for these readings; the trace is in the team.
inline Motion decide(Coordinator& object, Team& team, double left, double right) {
  for (Member& member : team.members()) {
    member.begin_step();
  }
  Situation now = beams(left, right);
  return object.coordinate(team.members(), now.perception());
}

inline double weight(Team& team, std::size_t i) { return team.members()[i].trace.weight; }
inline double share(Team& team, std::size_t i) { return team.members()[i].trace.share; }
inline std::string reason(Team& team, std::size_t i) { return team.members()[i].trace.reason; }

/// Weight files in a folder of their own.
class Files {
 public:
  std::string weights(const neural::Weights& weights) {
    const std::string path = folder_.file("w" + std::to_string(++count_));
    neural::write_weights(weights, path);
    return path;
  }
  std::string text(const std::string& content) {
    return folder_.write("t" + std::to_string(++count_), content);
  }

 private:
  Folder folder_;
  int count_ = 0;
};

inline double logistic(double x) { return 1.0 / (1.0 + std::exp(-x)); }

/// No hidden layer: the first priority is s(left), the second s(1 - 2 right).
inline neural::Network simple_network() {
  neural::Network network({2, 2});
  network.set_weight(0, 0, 0, 1.0);
  network.set_bias(0, 1, 1.0);
  network.set_weight(0, 1, 1, -2.0);
  return network;
}

/// The message when equipping fails; "" otherwise.
inline std::string refusal(Coordinator& object, Team& team, Situation& now) {
  try {
    object.equipped(team.members(), now.perception());
    return "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace elsie::test
