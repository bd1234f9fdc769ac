// Pictures of a scene, drawn off screen with EGL and OpenGL 3.3. No display is needed; without a
// graphics card Mesa draws in software.
//
// All cameras of one instant are drawn together, side by side into one picture that is read back
// once: a hundred small pictures cost little more than one large one.
//
// The cameras are pinhole cameras (see elsie::Camera). A pixel has the colour of the nearest
// surface, at least kNearest away, that the ray through its middle meets; edges are not smoothed.
// On one machine, the same scene and views give the same bytes. A graphics card and Mesa's
// software, or two versions of Mesa, may differ in pixels at edges. LIBGL_ALWAYS_SOFTWARE=1 in the
// environment selects Mesa's software.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "elsie/api/image.h"
#include "elsie/base/error.h"
#include "elsie/render/scene.h"

namespace elsie::render {

/// The camera does not see surfaces that are nearer along its axis, m.
inline constexpr double kNearest = 0.01;

/// No picture can be taken; what() is a sentence that says why, and what to install.
class RenderError : public base::Error {
 public:
  using base::Error::Error;
};

/// Owns an OpenGL context; renderers are independent of each other. Any thread may use it, one at a
/// time. Each call restores the context that was current before.
class Renderer {
 public:
  /// Throws RenderError where EGL or OpenGL 3.3 is not available.
  Renderer();
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// Takes a picture from each view. `pictures` has one entry for each, which gets the camera's
  /// size and three channels. The memory of the images is reused.
  ///
  /// Throws std::invalid_argument for a camera whose size or field of view makes no picture (sizes
  /// from 1 to largest_size() pixels, angles in (0, pi)), RenderError when the driver fails.
  void render(const Scene& scene, std::span<const View> views, std::span<Image* const> pictures);

  /// The most pixels that a picture may have in width and height.
  int largest_size() const;
  /// The device that draws, as the driver names it: "llvmpipe (LLVM 15.0.6, 256 bits)".
  const std::string& device() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace elsie::render
