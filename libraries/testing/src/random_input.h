// Random but possible input for plugins of all kinds.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "elsie/api/behavior.h"
#include "elsie/testing/checker.h"
#include "elsie/testing/scene.h"
#include "elsie/testing/sensor.h"

namespace elsie::testing {

/// One robot and what it meets, instant by instant.
struct Input {
  std::string robot;                // in words
  std::vector<Situation> instants;  // for behaviours and coordinators; none for a sensor
  /// Behaviours for a coordinator, and what each wishes at each instant. The wishes of the first
  /// one serve those inside a behaviour, too.
  std::vector<std::string> members;
  std::vector<double> priorities;
  std::vector<std::vector<Response>> wishes;
  /// For sensors: where the carrier is at each instant, and in which of the scenes.
  std::vector<std::shared_ptr<Surroundings>> scenes;
  std::vector<Pose> poses;
  Mounting mounting;
  /// For measures: the start and the instants after it, and the boxes that are gone at the end.
  std::vector<Scene> watched;
  std::vector<std::string> gone;
};

class InputMaker {
 public:
  InputMaker(const Declaration& declaration, const CheckOptions& options, const Plugins& plugins)
      : declaration_(declaration), options_(options), plugins_(plugins) {}

  /// How many robots there are to try; for measures, worlds.
  int robots() const;
  /// Something for the robot of this number to meet. The same random stream, the same input. Throws
  /// std::runtime_error, with a sentence, when a reading that the plugin needs cannot be made.
  Input make(int robot, Random& random) const;

 private:
  struct Layout;
  Layout layout(int robot, Random& random) const;
  Input make_watched(int number, Random& random) const;
  void add_own_kinds(Situation& now, Random& random) const;

  const Declaration& declaration_;
  const CheckOptions& options_;
  const Plugins& plugins_;
};

/// Walls, boxes, robots, and resources of this colour around the origin, within 3 m.
Surroundings random_surroundings(const Colour& colour, Random& random);
/// Blobs of colour before a grey background.
Image random_picture(int width, int height, Random& random);

}  // namespace elsie::testing
