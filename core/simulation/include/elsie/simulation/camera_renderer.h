// Pictures for sensors that look through cameras. The simulation says what each camera looks at;
// whoever runs it hands in what takes the pictures: worlds without cameras need no OpenGL.
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

/// One camera in its place, and where its picture goes.
struct CameraView {
  Frame frame;  // the camera looks along forward; up is the top of the picture
  Camera camera;
  std::size_t robot = 0;     // its body is not in the picture
  Image* picture = nullptr;  // gets the camera's size and three channels
};

/// Takes the pictures of one world.
class CameraRenderer {
 public:
  virtual ~CameraRenderer() = default;
  /// The most pixels that a picture may have in width and height.
  virtual int largest_size() const = 0;
  /// Takes the pictures of one instant: all bodies are where the engine has them. Throws
  /// base::Error.
  virtual void take(const physics::Engine& engine, std::span<const CameraView> views) = 0;
};

/// Makes one for a world, which lives longer. Throws base::Error with a sentence where no pictures
/// can be taken.
using MakeCameraRenderer = std::function<std::unique_ptr<CameraRenderer>(const world::World&)>;

}  // namespace elsie::simulation
