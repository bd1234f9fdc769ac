// Pictures of a scene, off screen: EGL without a surface, OpenGL 3.3. No display is needed; without
// a graphics card Mesa draws in software.
//
// All cameras of one instant are drawn in one go, side by side into one picture that is read back
// once: a hundred small pictures cost little more than one large one.
//
// The pictures are those of pinhole cameras (see elsie::Camera), with hard edges: a pixel has the
// colour of the nearest surface that the ray through its middle meets, no closer than kNearest. On
// one machine, the same scene and views give the same bytes; between a graphics card and Mesa's
// software (or another version of it) pixels at edges may differ. LIBGL_ALWAYS_SOFTWARE=1 in the
// environment leaves graphics cards aside.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "elsie/api/image.h"
#include "elsie/base/error.h"
#include "elsie/render/scene.h"

namespace elsie::render {

/// Surfaces nearer to the camera, along its axis, are not seen, m.
inline constexpr double kNearest = 0.01;

/// No pictures can be taken; what() is a sentence that says why, and what to install.
class RenderError : public base::Error {
 public:
  using base::Error::Error;
};

/// One OpenGL context of its own; two renderers do not know of each other. May be used from any
/// thread, by one at a time; a context that the caller has current is so again afterwards.
class Renderer {
 public:
  /// Throws RenderError where EGL or OpenGL 3.3 is not to be had.
  Renderer();
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// Takes a picture from each view; `pictures` has as many entries, which are given the size of
  /// the camera and three channels. Memory that an image has is used again.
  ///
  /// Throws std::invalid_argument for a camera whose size or field of view makes no picture (sizes
  /// from 1 to largest_size() pixels, angles in (0, pi)), RenderError when the driver fails.
  void render(const Scene& scene, std::span<const View> views, std::span<Image* const> pictures);

  /// The most pixels that a picture may have in width and height.
  int largest_size() const;
  /// What draws, in the driver's words: "llvmpipe (LLVM 15.0.6, 256 bits)".
  const std::string& device() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace elsie::render
