#include "floor_texture.h"

#include <string>

#include "elsie/render/renderer.h"

namespace elsie::render {

void load_floor(const Image& image, GLint filter) {
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  if (image.width > largest || image.height > largest) {
    throw RenderError("cameras cannot see the image of the floor, which has " +
                      std::to_string(image.width) + " x " + std::to_string(image.height) +
                      " pixels: the OpenGL driver takes at most " + std::to_string(largest) +
                      " in each direction; make the image smaller");
  }
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, image.width, image.height, 0, GL_RGB, GL_UNSIGNED_BYTE,
               image.bytes.data());
  for (const GLenum which : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
    glTexParameteri(GL_TEXTURE_2D, which, filter);
  }
  for (const GLenum edge : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
    glTexParameteri(GL_TEXTURE_2D, edge, GL_CLAMP_TO_EDGE);
  }
}

}  // namespace elsie::render
