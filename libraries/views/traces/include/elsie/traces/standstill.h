// Robots that stay where they are, and why: what a window says while a world runs, and why a run
// reached no goal.
#pragma once

#include <string>
#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/api/motion.h"
#include "elsie/simulation/simulation.h"

namespace elsie::traces {

/// What keeps a robot where it is.
enum class Hold {
  cancel,   // the wishes of two behaviours cancel each other, at once or in turns
  blocked,  // it is asked to drive, and does not move: something is in its way
  turning,  // it turns on the spot
  empty,    // its battery is empty
  idle      // nobody asks it to move
};

/// "cancel", "blocked", ...
const char* to_string(Hold hold);

struct Standstill {
  std::string robot;
  double since_s = 0.0;
  Hold why = Hold::idle;
  /// Paths of the behaviours to blame, from the robot on, the strongest first: two that cancel each
  /// other, the one that drives or turns it, or none.
  std::vector<std::string> behaviors{};

  bool operator==(const Standstill&) const = default;
};

/// Finds the robots that have not left a small circle for ten seconds. Of a behaviour counts what
/// it puts into the robot's command: its own command times its share. Over that time, the parts of
/// two behaviours that cancel each other point in opposite directions; so it does not matter
/// whether a coordinator adds them or lets them take turns.
class StandstillWatch {
 public:
  static constexpr double kLeast_s = 10.0;

  /// Forgets everything: another run begins, or the robots have changed.
  void begin() { watched_.clear(), found_.clear(); }
  /// To be called after every decision. Of robots that move, it only looks at the place, twice a
  /// second.
  void look(const simulation::Simulation& simulation);
  /// In the order of the world's robots.
  const std::vector<Standstill>& found() const { return found_; }

 private:
  /// Sums over the time since `since_s`.
  struct Part {
    Motion sum;         // of what it puts into the command
    double size = 0.0;  // of its lengths, m/s
  };
  struct Watched {
    std::string id;
    Pose at;
    double since_s = 0.0;
    int decisions = 0;
    double asked = 0.0, turned = 0.0;  // sums of speeds ahead or sideways, and of turns
    std::vector<Part> parts;           // of the robot's members
  };

  void begin(const simulation::RobotView& robot, double now_s, Watched& watched) const;
  static void add(const simulation::RobotView& robot, Watched& watched);
  static Standstill judged(const simulation::RobotView& robot, const Watched& watched);

  std::vector<Watched> watched_;
  std::vector<Standstill> found_;
  double looked_s_ = 0.0;  // at the places
};

}  // namespace elsie::traces
