// All drawing by OpenGL, into the framebuffer of the current context. Only the renderer, which owns
// the framebuffer, also calls OpenGL.
#pragma once

#include <array>

#include <epoxy/gl.h>

#include "elsie/render/scene.h"

#include "instances.h"
#include "meshes.h"

namespace elsie::render {

class Painter {
 public:
  /// Needs a current OpenGL 3.3 context, which must also be current in all later calls and owns the
  /// objects made here. Throws RenderError.
  Painter();

  /// Draws the list into the lower left part of the framebuffer, cleared to `sky`.
  void paint(const DrawList& list, const Colour& sky, int width, int height);

 private:
  /// A mesh on the graphics card.
  struct Shape {
    GLuint array = 0;
    GLsizei indices = 0;
  };

  Shape make(const Mesh& mesh);
  void draw(const Shape& shape, std::size_t first, std::size_t count);

  GLuint instances_ = 0;  // buffer
  GLuint program_ = 0;
  std::array<Shape, kMeshes> shapes_;
};

}  // namespace elsie::render
