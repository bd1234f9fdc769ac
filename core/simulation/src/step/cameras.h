// The cameras of all robots, and what they see.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "elsie/physics/engine.h"
#include "elsie/simulation/camera_renderer.h"
#include "elsie/world/description.h"
#include "elsie/world/error.h"

#include "step/robot.h"

namespace elsie::simulation {

/// Takes the pictures of all sensors that look through a camera, of one instant in one go. Without
/// such a sensor it does nothing, and asks nothing of the machine.
class Cameras {
 public:
  /// For these robots, which live as long. What is wrong with a camera, or with the machine, is
  /// added to `problems`, with the sensor's place in the world file; also when
  /// there are cameras and no renderer.
  Cameras(const world::World& world, const std::vector<std::shared_ptr<Robot>>& robots,
          const MakeCameraRenderer& make_renderer, std::vector<base::Problem>& problems);

  /// What is wrong with a camera that one of these sensors is to look through from now on; none
  /// when nothing is.
  std::optional<std::string> problem_of(const Camera& camera) const;

  /// Hands every sensor with a camera the picture of what is before it now, except those of robots
  /// whose battery is empty. Throws base::Error.
  void take(const physics::Engine& engine);

 private:
  struct Mount {
    std::size_t robot, sensor;
  };

  const std::vector<std::shared_ptr<Robot>>& robots_;
  std::vector<Mount> mounts_;
  std::unique_ptr<CameraRenderer> renderer_;  // none without cameras
  std::vector<CameraView> views_;             // of the pictures being taken
};

}  // namespace elsie::simulation
