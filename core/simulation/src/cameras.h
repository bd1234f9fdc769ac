// The cameras of all robots, and what they see.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "elsie/physics/engine.h"
#include "elsie/render/renderer.h"
#include "elsie/render/world_scene.h"
#include "elsie/world/description.h"
#include "elsie/world/error.h"

#include "robot.h"

namespace elsie::simulation {

/// Takes the pictures of all sensors that look through a camera, of one instant in one go. Without
/// such a sensor it does nothing, and asks nothing of the machine.
class Cameras {
 public:
  /// For these robots, which live as long. What is wrong with a camera, or with the machine, is
  /// added to `problems`, with the sensor's place in the world file.
  Cameras(const world::World& world, std::span<const std::unique_ptr<Robot>> robots,
          std::vector<world::Problem>& problems);

  /// What is wrong with a camera that one of these sensors is to look through from now on; none
  /// when nothing is.
  std::optional<std::string> problem_of(const Camera& camera) const;

  /// Hands every sensor with a camera the picture of what is before it now, except those of robots
  /// whose battery is empty. Throws render::RenderError.
  void take(const physics::Engine& engine);

 private:
  struct Mount {
    std::size_t robot, sensor;
  };

  void place_bodies(const physics::Engine& engine);

  const world::World& world_;
  std::span<const std::unique_ptr<Robot>> robots_;
  std::vector<Mount> mounts_;
  std::optional<render::Renderer> renderer_;  // none without cameras
  std::optional<render::WorldScene> scene_;   // likewise
  std::vector<render::View> views_;           // of the pictures being taken
  std::vector<Image*> pictures_;              // likewise
};

}  // namespace elsie::simulation
