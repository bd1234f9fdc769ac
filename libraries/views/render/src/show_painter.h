// Draws pictures for people, a pass at a time, into the framebuffer of the current context.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include <epoxy/gl.h>

#include "elsie/render/exposure.h"
#include "elsie/render/scene.h"

#include "batch.h"
#include "lights.h"
#include "shadow_map.h"
#include "shown.h"

namespace elsie::render {

class ShowPainter {
 public:
  /// Needs a current OpenGL 3.3 context, which must also be current in all later calls and owns the
  /// objects made here. Throws RenderError.
  ShowPainter();

  /// Chooses what the next passes draw.
  void compose(const Scene& scene, const View& view, const Style& style);
  const Camera& camera() const { return view_.camera; }
  /// Draws into a framebuffer with a stencil, as large as the view's camera. Passes are counted
  /// from 0.
  void paint(GLuint framebuffer, Shadows shadows, int pass);

 private:
  /// The shaders of what has light and shade.
  struct Shaders {
    GLuint floor = 0, around = 0, image = 0;
    std::array<GLuint, kMaterials> solids{};
  };
  /// The sun, and the part of the sky that shines in a pass.
  struct Lights {
    Vector3 sun_direction, dome_direction;
    Matrix sun{}, dome{};
  };

  static Shaders make_shaders(const std::string& how);
  const Shaders& shaders_for(Shadows shadows);
  void draw_solids() const;
  void find_room(double tallest);
  Matrix camera_matrix(int pass) const;
  void draw_map(const ShadowMap& map, const Matrix& matrix) const;
  void use(GLuint program, const Matrix& camera) const;
  void light(GLuint program, const Lights& lights) const;
  void draw_sky() const;
  void draw_floor(const Matrix& camera, const Shaders& with, const Lights& lights);
  void draw_contacts(const Matrix& camera) const;
  void draw_hard_shadows(const Matrix& camera) const;
  void draw_strokes(const Matrix& camera) const;
  void draw_near_walls(const Matrix& camera, const Shaders& with, const Lights& lights) const;
  void use_image();

  std::array<Batch, kBox> flat_;
  std::array<std::array<Batch, kMeshes>, kMaterials> solids_;
  Batch around_, beyond_, near_walls_, contacts_, drawing_, strokes_, halos_, pools_, sky_strip_;
  Shaders plain_, mapped_;
  std::optional<Shaders> sunny_;  // made for the first film
  GLuint sky_ = 0, shadow_ = 0, contact_ = 0, stroke_ = 0, halo_ = 0, pool_ = 0, depth_ = 0;
  ShadowMap sun_map_, dome_map_;
  GLuint texture_ = 0;
  std::shared_ptr<const Image> image_{};  // in the texture

  // What is drawn.
  View view_;
  Style style_;
  std::shared_ptr<const Image> floor_image_{};
  double near_ = 0.0;                 // m
  double across_ = 0.0, down_ = 0.0;  // 1 / tan of half the field of view
  Room room_;
};

}  // namespace elsie::render
