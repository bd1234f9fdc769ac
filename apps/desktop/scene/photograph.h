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

namespace elsie::desktop {

/// Draws a layer over what is floor or sky in a photograph, into `result`: what stands there hides
/// it.
void lay_on_floor(const QImage& photograph, const QImage& layer, QImage& result);

/// All photographs share a renderer, which is made once: it compiles what it draws with.
class Photograph {
 public:
  Photograph();
  ~Photograph();

  /// False without OpenGL, when nothing can be drawn.
  bool is_possible() const { return darkroom_ != nullptr; }
  /// The OpenGL renderer; "" without OpenGL.
  QString device() const;

  /// Draws one thing of each kind, unseen: an OpenGL in software compiles each when it is drawn for
  /// the first time, which takes up to half a second.
  void warm_up();
  /// Begins another picture, of which nothing is drawn yet.
  void begin(render::Scene scene, const render::View& view, const render::Style& style);
  /// Draws it as finely as the time allows.
  void take();
  /// Adds a pass; all passes of a picture should be with the same shadows.
  void refine(render::Shadows shadows = render::Shadows::soft);
  /// Whether another pass would add nothing, or would stop the window for too long.
  bool is_finished() const { return refined_ >= finest_ || long_passes_ == 2; }
  /// The passes after which it is finished.
  void set_finest(int passes) { finest_ = passes; }
  /// The passes of refine().
  int refined() const { return refined_; }
  /// Makes image() what the passes so far have given.
  void develop();
  /// Null before the first picture. The alpha of a pixel, which is not drawn, is how much of it is
  /// floor or sky.
  const QImage& image() const { return image_; }
  const Quality& quality() const { return quality_; }

 private:
  struct Darkroom;
  static std::shared_ptr<Darkroom> darkroom();
  bool expose(render::Shadows shadows);

  std::shared_ptr<Darkroom> darkroom_;
  render::Scene scene_;
  render::View view_;
  render::Style style_;
  bool is_begun_ = false;
  render::Exposure exposure_;
  std::vector<std::uint32_t> pixels_;
  QImage image_;  // of pixels_
  Quality quality_;
  int finest_ = render::kFinished;
  int refined_ = 0;
  int long_passes_ = 0;  // in a row
};

}  // namespace elsie::desktop
