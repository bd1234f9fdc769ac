// Random but possible input for plugins of all kinds.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "elsie/api/behavior.h"
#include "elsie/api/drive.h"
#include "elsie/testing/checker.h"
#include "elsie/testing/scene.h"
#include "elsie/testing/sensor.h"

namespace elsie::testing {

/// The time between two instants of an input, s.
inline constexpr double kPeriod = 0.01;
/// The instants of an input.
inline constexpr std::size_t kInstants = 64;

// The ids of the first robot that random input has: around a sensor, and among a behaviour's mates.
inline constexpr const char* kFirstRobot = "robot0";
inline constexpr const char* kFirstMate = "mate0";

/// A random index into something of this size.
inline std::size_t index(Random& random, std::size_t size) {
  return static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(size)));
}

/// A robot with its random input at each instant.
struct Input {
  std::string robot;                // in words
  std::vector<Situation> instants;  // for behaviours and coordinators; none for a sensor
  /// Behaviours for a coordinator, and their answers at each instant. Those of the first also serve
  /// for behaviours inside of a behaviour.
  std::vector<std::string> members;
  std::vector<double> priorities;
  std::vector<std::vector<Response>> wishes;
  /// For sensors: the carrier's pose at each instant, and its scene.
  std::vector<std::shared_ptr<Surroundings>> scenes;
  std::vector<Pose> poses;
  Mounting mounting;
  /// For measures and rules: the start and the instants after it, and the boxes that are removed by
  /// the end.
  std::vector<Scene> watched;
  std::vector<std::string> gone;
  /// For drives and localisations: the chassis above, the motions that are asked for, and the limit
  /// of rim speeds.
  Chassis chassis;
  std::vector<Motion> asked;
  double max_speed = 0.5;  // m/s
};

/// The same input for another robot of the team: the first mate that the others perceive, and their
/// leader if they have none.
Input as_a_mate(Input input);

/// What measures and rules see after a step, counted from 0. The instants repeat; counts continue,
/// and removed boxes stay away.
Scene instant(const Input& input, std::size_t step);

class InputMaker {
 public:
  InputMaker(const Declaration& declaration, const CheckOptions& options, const Plugins& plugins)
      : declaration_(declaration), options_(options), plugins_(plugins) {}

  /// The number of robots to try; for measures and rules, of worlds.
  int robots() const;
  /// Input for the robot of this number; it follows from the random stream. Throws
  /// std::runtime_error with a sentence when a reading that the plugin needs cannot be made.
  Input make(int robot, Random& random) const;

 private:
  struct Layout;
  Layout layout(int robot, Random& random) const;
  Input make_watched(int number, Random& random) const;
  static Input make_driven(int robot, Random& random);
  void add_own_kinds(Situation& now, Random& random) const;
  void add_message(Situation& now, Random& random) const;

  const Declaration& declaration_;
  const CheckOptions& options_;
  const Plugins& plugins_;
};

/// Walls, boxes, robots, and resources of this colour around the origin, within 3 m.
/// `has_company`: there is always a robot within 0.6 m.
Surroundings random_surroundings(const Colour& colour, bool has_company, Random& random);
/// Coloured blobs on a grey background.
Image random_picture(int width, int height, Random& random);

}  // namespace elsie::testing
