// Draws pictures for people, a pass at a time, into the framebuffer of the current context.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <epoxy/gl.h>

#include "elsie/render/exposure.h"
#include "elsie/render/scene.h"

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
  /// Draws into the lower left part of a framebuffer with a stencil, as large as the view's camera.
  /// Passes are counted from 0.
  void paint(GLuint framebuffer, Shadows shadows, int pass);

 private:
  using Matrix = std::array<float, 16>;  // by columns

  /// Of a mesh's corners, then of what there are many of.
  enum Location : GLuint { position, normal, inset, first, second, third, fourth, fifth };

  struct Attribute {
    GLuint location;
    GLint size;
    GLenum type;
    std::size_t at;
    GLboolean is_part = GL_FALSE;  // of 255
  };
  /// Instances of a mesh, or of a strip of four corners.
  struct Batch {
    GLuint array = 0;
    GLuint buffer = 0;    // of the instances
    GLsizei indices = 0;  // 0: a strip
    GLsizei drawn = 0;    // of the indices
    GLsizei instances = 0;
  };
  /// The shaders of what has light and shade.
  struct Shaders {
    GLuint floor = 0, around = 0, image = 0;
    std::array<GLuint, kMaterials> solids{};
  };
  /// What a light sees.
  struct Map {
    GLuint framebuffer = 0, texture = 0;
    int size = 0;  // px
  };
  /// The sun, and the part of the sky that shines in a pass.
  struct Lights {
    Vector3 sun_direction, dome_direction;
    Matrix sun{}, dome{};
  };

  static Map make_map(int size);
  static Batch make_mesh(const SmoothMesh& mesh);
  static void enable(std::span<const Attribute> attributes, std::size_t stride, GLuint divisor);
  Batch make_strip(std::span<const Attribute> attributes, std::size_t stride) const;
  template <class Item>
  static void upload(Batch& batch, const std::vector<Item>& items);
  static void draw(const Batch& batch);
  void draw_solids() const;
  void find_room(double tallest);
  Matrix camera_matrix(int pass) const;
  Matrix light_matrix(const Vector3& direction) const;
  void draw_map(const Map& map, const Matrix& matrix) const;
  void use(GLuint program, const Matrix& camera) const;
  void light(GLuint program, const Lights& lights) const;
  void draw_sky() const;
  void draw_floor(const Matrix& camera, const Shaders& with, const Lights& lights);
  void draw_hard_shadows(const Matrix& camera) const;
  void draw_strokes(const Matrix& camera) const;
  void draw_near_walls(const Matrix& camera, const Shaders& with, const Lights& lights) const;
  void use_image();

  GLuint corner_buffer_ = 0;
  std::array<Batch, kBox> flat_;
  std::array<std::array<Batch, kMeshes>, kMaterials> solids_;
  Batch around_, near_walls_, contacts_, drawing_, strokes_, halos_, pools_, sky_strip_;
  Shaders plain_, mapped_;
  GLuint sky_ = 0, shadow_ = 0, contact_ = 0, stroke_ = 0, halo_ = 0, pool_ = 0, depth_ = 0;
  Map sun_map_, dome_map_;
  GLuint texture_ = 0;
  std::shared_ptr<const Image> image_{};  // in the texture

  // What is drawn.
  View view_;
  Style style_;
  std::shared_ptr<const Image> floor_image_{};
  double near_ = 0.0;                 // m
  double across_ = 0.0, down_ = 0.0;  // 1 / tan of half the field of view
  Vector3 low_, high_;                // where shadows are seen, from the camera's place
};

}  // namespace elsie::render
