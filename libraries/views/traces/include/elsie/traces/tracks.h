// Where the robots went, for pictures of a run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/simulation/observer.h"

namespace elsie::traces {

/// The path of one robot.
struct Track {
  std::vector<Pose> path;        // a pose per period, the first at the start
  std::vector<Vector2> touches;  // where it was when it collided
  /// Poses that it did not drive to, because a user had moved it since the pose before. Places in
  /// `path`, ascending.
  std::vector<std::size_t> placed{};
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
  double period_s() const { return period_s_; }

 private:
  void sample(const simulation::Simulation& simulation);
  void note_placements(const simulation::Simulation& simulation);

  double asked_period_s_;
  double period_s_ = 0.0;
  std::uint64_t every_ = 1;
  std::vector<std::string> ids_;
  std::vector<Track> tracks_;
  std::vector<int> collisions_;
  std::vector<bool> was_placed_;  // since the last pose of its path
  std::size_t events_ = 0;        // how many were looked at
};

}  // namespace elsie::traces
