// Pictures of a scene, drawn off screen with EGL and OpenGL 3.3. No display is needed; without a
// graphics card Mesa draws in software.
//
// All cameras of one instant are drawn at once, side by side into one picture that is read back
// once: a hundred small pictures cost little more than a large one.
//
// The pictures are those of pinhole cameras (see elsie::Camera), with hard edges: a pixel has the
// colour of the nearest surface, no closer than kNearest, on the ray through its middle. On one
// machine, the same scene and views give the same bytes; between a graphics card and Mesa's
// software (or another version of it) pixels at edges may differ. LIBGL_ALWAYS_SOFTWARE=1 in the
// environment selects software.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "elsie/api/image.h"
#include "elsie/base/error.h"
#include "elsie/render/exposure.h"
#include "elsie/render/scene.h"

namespace elsie::render {

/// Surfaces nearer to the camera, along its axis, are invisible, m.
inline constexpr double kNearest = 0.01;

/// Pictures cannot be taken; what() is a sentence with the reason and the packages to install.
class RenderError : public base::Error {
 public:
  using base::Error::Error;
};

/// A renderer with its own OpenGL context, independent of other renderers. May be used from any
/// thread, by one at a time; the caller's current context is restored.
class Renderer {
 public:
  /// Throws RenderError without EGL or OpenGL 3.3.
  Renderer();
  ~Renderer();

  /// Takes a picture of each view into `pictures`, which has as many entries; they get the size of
  /// the camera and three channels. An image's memory is reused.
  ///
  /// Throws std::invalid_argument for a camera whose size or field of view is out of range (sizes
  /// from 1 to largest_size() pixels, angles in (0, pi)), RenderError when the driver fails.
  void render(const Scene& scene, std::span<const View> views, std::span<Image* const> pictures);

  /// Chooses what the next passes of expose() show: for people, see exposure.h. Throws as render().
  void compose(const Scene& scene, const View& view, const Style& style);
  /// Adds a pass to a picture of the size of the composed view's camera.
  void expose(Shadows shadows, Exposure& exposure);

  /// The largest width and height of a picture, in pixels.
  int largest_size() const;
  /// The device that draws, in the driver's words: "llvmpipe (LLVM 15.0.6, 256 bits)".
  const std::string& device() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace elsie::render
