// Pictures for sensors with cameras. The simulation gives the pose of each camera; its caller
// passes in the renderer, so that worlds without cameras need no OpenGL.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>

#include "elsie/api/geometry.h"
#include "elsie/api/image.h"
#include "elsie/physics/engine.h"
#include "elsie/world/description.h"

namespace elsie::simulation {

/// One camera, its pose, and the destination of its picture.
struct CameraView {
  Frame frame;  // the camera looks along forward; up is the top of the picture
  Camera camera;
  std::size_t robot = 0;     // the robot that carries it; the picture does not show it
  Image* picture = nullptr;  // gets the camera's size and three channels
};

/// What an actuator of a robot shines.
struct CarriedLight {
  std::size_t robot = 0;
  Vector3 place;  // m
  Colour colour;
};

/// Takes the pictures of one world.
class CameraRenderer {
 public:
  virtual ~CameraRenderer() = default;
  /// The largest width and height of a picture, px.
  virtual int largest_size() const = 0;
  /// Takes the pictures of one instant, with the poses of bodies from the engine. Throws
  /// base::Error.
  virtual void take(const physics::Engine& engine, std::span<const CameraView> views,
                    std::span<const CarriedLight> lights) = 0;
};

/// Makes a renderer for a world, which must outlive it. Throws base::Error with a sentence when
/// pictures cannot be taken.
using MakeCameraRenderer = std::function<std::unique_ptr<CameraRenderer>(const world::World&)>;

}  // namespace elsie::simulation
