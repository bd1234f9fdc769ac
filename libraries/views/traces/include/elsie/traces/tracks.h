// The paths of robots, for pictures of a run.
#pragma once

#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/simulation/observer.h"
#include "elsie/simulation/simulation.h"
#include "elsie/traces/sampling.h"

namespace elsie::traces {

/// Calls `see` for the events, from the one with the index `next`, by which an edit put a robot
/// somewhere else, where it did not drive. Moves `next` behind the last event.
template <class See>
void see_placements(const simulation::Simulation& simulation, std::size_t& next, const See& see) {
  const auto events = simulation.events();
  for (; next < events.size(); ++next) {
    const auto* const changed = events[next].as<events::Changed>();
    if (changed && changed->moves_robot()) {
      see(events[next]);
    }
  }
}

/// The path of one robot.
struct Track {
  std::vector<Pose> path;        // a pose per period
  std::vector<Vector2> touches;  // its positions when it collided
  /// Poses that it did not drive to, because a user had moved it since the pose before. Places in
  /// `path`, ascending.
  std::vector<std::size_t> placed{};
  double from_s = 0.0;  // time of the first pose; later than 0 for a robot that an edit added
  /// Where it took itself to be at each pose of the path; empty: it has no localisation.
  std::vector<Pose> believed{};
};

/// Keeps the path of every robot.
class TrackRecorder final : public simulation::Observer {
 public:
  /// `period_s`: simulated time from one pose to the next, rounded to whole steps.
  explicit TrackRecorder(double period_s = 0.1) : asked_period_s_(period_s) {}

  void started(const simulation::Simulation& simulation) override;
  void stepped(const simulation::Simulation& simulation) override;
  void replaced(const simulation::Simulation& simulation) override;

  /// In the order of the world's robots; without those that an edit removed.
  const std::vector<Track>& tracks() const { return tracks_; }
  /// Time between two poses, s.
  double period_s() const { return sampling_.period_s(); }

 private:
  void sample(const simulation::Simulation& simulation);
  void note_placements(const simulation::Simulation& simulation);

  double asked_period_s_;
  Sampling sampling_;
  std::unordered_map<std::string, std::size_t> places_;  // of the tracks, by robot
  std::vector<Track> tracks_;
  std::vector<int> collisions_;
  std::vector<bool> was_placed_;  // since the last pose of its path
  std::size_t events_ = 0;        // number of events processed
};

}  // namespace elsie::traces
