#include "scene/photograph.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <algorithm>
#include <memory>
#include <span>
#include <utility>

#include "elsie/render/renderer.h"

namespace elsie::desktop {

void lay_on_floor(const QImage& photograph, const QImage& layer, QImage& result) {
  if (result.size() != photograph.size()) {
    result = QImage(photograph.size(), QImage::Format_RGB32);
  }
  const int width = std::min(photograph.width(), layer.width());
  for (int y = 0; y < photograph.height(); ++y) {
    const auto* from = reinterpret_cast<const QRgb*>(photograph.constScanLine(y));
    auto* to = reinterpret_cast<QRgb*>(result.scanLine(y));
    std::copy_n(from, photograph.width(), to);
    if (y >= layer.height()) continue;
    const auto* over = reinterpret_cast<const QRgb*>(layer.constScanLine(y));
    for (int x = 0; x < width; ++x) {
      if (over[x] == 0) continue;
      // The layer's colours are multiplied by its alpha.
      const int open = qAlpha(from[x]);
      const auto part = [](int value, int of) { return (value * of + 127) / 255; };
      const int left = 255 - part(qAlpha(over[x]), open);
      to[x] = qRgb(part(qRed(over[x]), open) + part(qRed(from[x]), left),
                   part(qGreen(over[x]), open) + part(qGreen(from[x]), left),
                   part(qBlue(over[x]), open) + part(qBlue(from[x]), left));
    }
  }
}

struct Photograph::Darkroom {
  render::Renderer renderer;
  bool is_warm = false;
  const Photograph* composed = nullptr;  // whose scene the renderer has
};

/// Lives until the application ends, because windows and films come and go.
std::shared_ptr<Photograph::Darkroom> Photograph::darkroom() {
  static std::shared_ptr<Darkroom> shared;
  if (!shared) {
    shared = std::make_shared<Darkroom>();
    qAddPostRoutine([] { shared.reset(); });
  }
  return shared;
}

Photograph::Photograph() {
  try {
    darkroom_ = darkroom();
  } catch (const render::RenderError&) {  // outlines by Qt
  }
}

Photograph::~Photograph() {
  if (darkroom_ && darkroom_->composed == this) darkroom_->composed = nullptr;
}

QString Photograph::device() const {
  return darkroom_ ? QString::fromStdString(darkroom_->renderer.device()) : QString();
}

void Photograph::warm_up() {
  if (!darkroom_ || std::exchange(darkroom_->is_warm, true)) return;
  darkroom_->composed = nullptr;
  constexpr int kSide = 32;  // px
  const Colour grey{128, 128, 128};
  const std::vector<Vector2> triangle{{1.0, 0.0}, {-1.0, 1.0}, {-1.0, -1.0}};
  render::Scene scene;
  Image pixel;
  pixel.width = pixel.height = 1;
  pixel.bytes = {128, 128, 128};
  scene.image = {{8.0, 8.0}, std::make_shared<const Image>(pixel)};
  scene.patches = {{triangle, grey}};
  for (const auto material : {render::Material::plain, render::Material::wall,
                              render::Material::wheel, render::Material::glowing}) {
    scene.boxes.push_back({{}, {1.0, 1.0, 1.0}, grey, render::kNobody, true, material});
    scene.prisms.push_back({{}, triangle, 1.0, grey, render::kNobody, true, material});
    scene.cylinders.push_back({{}, 1.0, 1.0, grey, render::kNobody, true, material});
    scene.balls.push_back({{}, 1.0, grey, render::kNobody, true, material});
  }
  scene.marks = {{{}, 1.0, grey}};
  scene.drawing = scene.strokes = {{{}, {1.0, 1.0, 1.0}, grey}};
  scene.glows = {{{0.0, 0.0, 1.0}, 1.0, 1.0, grey}};
  const Frame from{{0.0, 0.0, 9.0}, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}, {1.0, 0.0, 0.0}};
  try {
    darkroom_->renderer.compose(scene, {from, {kSide, kSide, 1.0}}, {.arena = {8.0, 8.0}});
    render::Exposure unseen;
    unseen.begin(kSide, kSide);
    for (const auto shadows :
         {render::Shadows::none, render::Shadows::hard, render::Shadows::soft}) {
      darkroom_->renderer.expose(shadows, unseen);
    }
  } catch (const render::RenderError&) {
    darkroom_.reset();
  }
}

void Photograph::begin(render::Scene scene, const render::View& view, const render::Style& style) {
  scene_ = std::move(scene);
  view_ = view;
  style_ = style;
  is_begun_ = true;
  refined_ = long_passes_ = 0;
  exposure_.begin(view.camera.width, view.camera.height);
  if (darkroom_ && darkroom_->composed == this) darkroom_->composed = nullptr;
}

void Photograph::take() {
  QElapsedTimer clock;
  clock.start();
  const Quality::Level level = quality_.level();
  for (int i = 0; i < level.passes; ++i) {
    if (!expose(level.shadows)) return;
  }
  develop();
  quality_.took(1e-6 * static_cast<double>(clock.nsecsElapsed()));
}

void Photograph::refine(render::Shadows shadows) {
  if (!is_begun_) return;
  if (refined_ == 0) exposure_.begin(exposure_.width(), exposure_.height());
  QElapsedTimer clock;
  clock.start();
  if (!expose(shadows)) return;
  ++refined_;
  constexpr qint64 kMost_ms = 400;  // for which the window may take no events
  long_passes_ = clock.elapsed() > kMost_ms ? long_passes_ + 1 : 0;
}

bool Photograph::expose(render::Shadows shadows) {
  if (!darkroom_) return false;
  try {
    if (darkroom_->composed != this) {
      darkroom_->renderer.compose(scene_, view_, style_);
      darkroom_->composed = this;
    }
    darkroom_->renderer.expose(shadows, exposure_);
    return true;
  } catch (const render::RenderError&) {
    darkroom_.reset();
    return false;
  }
}

void Photograph::develop() {
  exposure_.develop(pixels_);
  image_ = QImage(reinterpret_cast<const uchar*>(pixels_.data()), exposure_.width(),
                  exposure_.height(), QImage::Format_RGB32);
}

}  // namespace elsie::desktop
