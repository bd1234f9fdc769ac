// The picture of the scene in the view: rough and quick while it moves, and finer with every pass
// while it stands still.
#pragma once

#include <QImage>
#include <QString>
#include <memory>
#include <vector>

#include "elsie/render/exposure.h"
#include "elsie/render/scene.h"

#include "scene/quality.h"

namespace elsie::render {
class Renderer;
}

namespace elsie::desktop {

/// Draws a layer over what is floor or sky in a photograph, into `result`: what stands there hides
/// it.
void lay_on_floor(const QImage& photograph, const QImage& layer, QImage& result);

class Photograph {
 public:
  Photograph();
  ~Photograph();

  /// False without OpenGL, when nothing can be drawn.
  bool is_possible() const { return renderer_ != nullptr; }
  /// The OpenGL renderer; "" without OpenGL.
  QString device() const;

  /// Draws one thing of each kind, unseen: an OpenGL in software compiles each when it is drawn for
  /// the first time, which takes up to half a second.
  void warm_up();
  /// Begins another picture, and draws it as finely as the time allows.
  void take(const render::Scene& scene, const render::View& view, const render::Style& style);
  /// Adds a pass with soft shadows.
  void refine();
  /// Whether another pass would add nothing, or would stop the window for too long.
  bool is_finished() const { return refined_ >= render::kFinished || long_passes_ == 2; }
  /// The passes with soft shadows.
  int refined() const { return refined_; }
  /// Makes image() what the passes so far have given.
  void develop();
  /// Null before the first picture. The alpha of a pixel, which is not drawn, is how much of it is
  /// floor or sky.
  const QImage& image() const { return image_; }
  const Quality& quality() const { return quality_; }

 private:
  bool expose(render::Shadows shadows);

  bool is_warm_ = false;
  std::unique_ptr<render::Renderer> renderer_;
  render::Exposure exposure_;
  std::vector<std::uint32_t> pixels_;
  QImage image_;  // of pixels_
  Quality quality_;
  int refined_ = 0;
  int long_passes_ = 0;  // in a row
};

}  // namespace elsie::desktop
