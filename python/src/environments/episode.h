// One world of an environment: its simulation, and the robots that observe and act.
//
//   Episode episode(declared, make, host);
//   episode.begin(7);
//   while (!episode.has_ended()) {
//     episode.begin_step(actions);
//     while (!episode.finish_step(Turn())) look_for_signals();
//   }
//   episode.save("learned.xml");
//
// An episode begins with one control period in which the robots sense for the first time. Then
// every step sets the actions, makes its steps of the physics, and ends when the run does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "elsie/plugin/host.h"
#include "elsie/simulation/observer.h"
#include "elsie/simulation/run.h"
#include "elsie/simulation/simulation.h"

#include "acting.h"
#include "declared.h"
#include "observing.h"
#include "rewarding.h"
#include "turn.h"

namespace elsie::python {

/// The world for a run with this seed. Several threads may call it.
using MakeWorld = std::function<world::World(std::uint64_t seed)>;

class Episode {
 public:
  /// Both must outlive the episode.
  Episode(const Declared& declared, const MakeWorld& make, const plugin::Host& host);
  Episode(const Episode&) = delete;
  Episode& operator=(const Episode&) = delete;
  ~Episode();

  /// Begins with this seed. Throws what the world's making, and its first steps, throw.
  void begin(std::uint64_t seed);
  /// Begins a step. `actions`: of all robots, one after the other. Throws base::BadInput after
  /// the episode's end, after a fault, and after interrupt().
  void begin_step(const float* actions);
  /// Makes the steps of the physics until all are made or the turn is over, but at least one.
  /// Returns whether the step is complete; nothing else may be asked before it is.
  bool finish_step(Turn turn);
  /// Throws base::BadInput after a fault and after interrupt().
  void require_sound() const;
  /// Whether a step has begun and is not complete.
  bool is_stepping() const { return is_stepping_; }
  /// Gives the episode up, perhaps in the middle of a step.
  void interrupt();

  /// Whether the run has come to its end, or the batteries of all robots are empty.
  bool has_ended() const { return terminated_ || truncated_; }
  bool terminated() const { return terminated_; }
  /// By the limit of time.
  bool truncated() const { return truncated_; }
  /// Whether a robot has come to its end, before the run or with it.
  bool has_ended(std::size_t robot) const { return ended_[robot]; }
  /// Of the last step, for each robot.
  const std::vector<double>& rewards() const { return rewards_; }
  /// Writes what all robots observe, one after the other.
  void observe(float* to) const;

  const std::vector<Observing>& eyes() const { return eyes_; }
  const std::vector<Acting>& hands() const { return hands_; }
  /// Throws base::BadInput when the last begin() could make no world.
  const simulation::Simulation& simulation() const;
  std::uint64_t seed() const { return seed_; }

  /// Keeps the episode so far: its world with the actions as edits (.xml), or a recording (.mcap).
  /// Throws base::BadInput, and what writing throws.
  /// Returns the time limit, s, that a world file cannot have because a goal lasts longer; the run
  /// of the file needs it.
  std::optional<double> save(const std::filesystem::path& file) const;

 private:
  /// The actions of a step.
  struct Deed {
    double time_s;
    std::vector<float> actions;
  };

  class Watcher;

  void make_simulation(std::uint64_t seed);
  void find_names();
  void apply();
  void take_edits();
  void advance();
  world::World kept() const;

  const Declared& declared_;
  const MakeWorld& make_;
  const plugin::Host& host_;
  std::unique_ptr<simulation::Simulation> simulation_;
  std::unique_ptr<Watcher> watcher_;
  std::unique_ptr<simulation::Run> run_;
  bool is_sound_ = false;  // false: it has not begun, is in a step, or was broken off
  bool is_stepping_ = false;
  bool is_interrupted_ = false;
  std::size_t steps_left_ = 0;  // of the physics, in this step
  bool is_drawn_ = false;       // the world depends on the seed
  bool by_edits_ = false;
  std::uint64_t seed_ = 1;
  std::size_t seen_ = 0;    // events that were looked at
  int since_decision_ = 0;  // steps
  std::vector<std::size_t> robots_;
  std::vector<const OwnState*> states_;
  std::vector<Observing> eyes_;
  std::vector<Acting> hands_;
  std::unique_ptr<Rewarding> rewarding_;
  std::vector<double> rewards_;
  std::vector<char> ended_;
  bool terminated_ = false, truncated_ = false;
  std::vector<Deed> deeds_;
};

}  // namespace elsie::python
