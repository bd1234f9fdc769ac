// The cameras of all robots and their pictures.
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

#include "robot/robot.h"

namespace elsie::simulation {

/// Takes the pictures of all sensors with a camera, of one instant in one batch. Without such a
/// sensor it does nothing and needs no OpenGL.
class Cameras {
 public:
  /// The robots must outlive this object. Adds problems of cameras, of the machine, and of a
  /// missing renderer to `problems`, with the sensor's place in the world file.
  Cameras(const world::World& world, const std::vector<std::shared_ptr<Robot>>& robots,
          const MakeCameraRenderer& make_renderer, std::vector<base::Problem>& problems);

  bool empty() const { return mounts_.empty(); }
  /// The problem with a new camera for one of these sensors; none when it can be used.
  std::optional<std::string> problem_of(const Camera& camera) const;

  /// Takes the present picture for every sensor with a camera, except on robots with an empty
  /// battery. Throws base::Error.
  void take(const physics::Engine& engine);

 private:
  struct Mount {
    std::size_t robot, sensor;
  };

  const std::vector<std::shared_ptr<Robot>>& robots_;
  std::vector<Mount> mounts_;
  std::unique_ptr<CameraRenderer> renderer_;  // none without cameras
  // Of the pictures being taken:
  std::vector<CameraView> views_;
  std::vector<CarriedLight> lights_;
};

}  // namespace elsie::simulation
