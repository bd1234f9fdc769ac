// All drawing by OpenGL, into the framebuffer of the current context. Only the renderer, which owns
// the framebuffer, also calls OpenGL.
#pragma once

#include <array>
#include <memory>

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

  /// Draws the list into the lower left part of the framebuffer, cleared to the scene's sky.
  void paint(const DrawList& list, const Scene& scene, int width, int height);

 private:
  /// A mesh on the graphics card.
  struct Shape {
    GLuint array = 0;
    GLsizei indices = 0;
  };

  Shape make(const Mesh& mesh);
  void draw(const Shape& shape, std::size_t first, std::size_t count);
  /// Draws with the image of a floor, which goes to the graphics card when it is another one.
  void use_image(const std::shared_ptr<const Image>& image);

  GLuint instances_ = 0;  // buffer
  GLuint program_ = 0;
  GLuint image_program_ = 0;  // made with the first image, as is its texture
  GLuint texture_ = 0;        // of image_
  std::shared_ptr<const Image> image_{};
  std::array<Shape, kMeshes> shapes_;
};

}  // namespace elsie::render
