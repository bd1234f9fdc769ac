#include "painter.h"

#include <cstddef>
#include <string>

#include "elsie/render/renderer.h"

#include "floor_texture.h"
#include "program.h"

namespace elsie::render {
namespace {

// Depth ranges from the nearest distance to infinity. Each picture is clipped to its part of the
// atlas. The brightness ranges from the darkest shade, away from the light, to 1; half of it is
// ambient (so that faces in the shade differ, too).
constexpr const char* kVertexShader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 x_row;
layout(location = 3) in vec4 y_row;
layout(location = 4) in vec4 w_row;
layout(location = 5) in vec4 place;
layout(location = 6) in vec3 light;
layout(location = 7) in vec4 colour;
uniform float nearest;
uniform float darkest;
flat out vec3 shaded;
out vec2 at;
void main() {
  at = 0.5 + 0.5 * vec2(position.x, -position.y);
  vec4 point = vec4(position, 1.0);
  float x = dot(x_row, point);
  float y = dot(y_row, point);
  float w = dot(w_row, point);
  gl_ClipDistance[0] = w + x;
  gl_ClipDistance[1] = w - x;
  gl_ClipDistance[2] = w + y;
  gl_ClipDistance[3] = w - y;
  gl_Position = vec4(x * place.x + w * place.z, y * place.y + w * place.w, w - 2.0 * nearest, w);
  shaded = colour.rgb * mix(darkest, 1.0, 0.5 + 0.5 * dot(normal, light));
}
)";

constexpr const char* kFragmentShader = R"(#version 330 core
flat in vec3 shaded;
out vec4 colour;
void main() { colour = vec4(shaded, 1.0); }
)";

// The nearest pixel of an image on the floor, which is in full light.
constexpr const char* kImageShader = R"(#version 330 core
in vec2 at;
uniform sampler2D image;
out vec4 colour;
void main() { colour = vec4(texture(image, at).rgb, 1.0); }
)";

constexpr int kClipDistances = 4;

enum Location : GLuint { position, normal, x_row, y_row, w_row, place, light, colour };

/// A program that shades what it draws by this fragment shader.
GLuint link_with(const char* fragment_shader) {
  const GLuint program = link(kVertexShader, fragment_shader);
  glUniform1f(glGetUniformLocation(program, "nearest"), static_cast<float>(kNearest));
  glUniform1f(glGetUniformLocation(program, "darkest"), static_cast<float>(kDarkestShade));
  return program;
}

}  // namespace

Painter::Painter() : program_(link_with(kFragmentShader)) {
  glGenBuffers(1, &instances_);
  const std::array<Mesh, kMeshes> all = meshes();
  for (std::size_t i = 0; i < kMeshes; ++i) shapes_[i] = make(all[i]);
}

Painter::Shape Painter::make(const Mesh& mesh) {
  Shape shape;
  shape.indices = static_cast<GLsizei>(mesh.indices.size());
  glGenVertexArrays(1, &shape.array);
  glBindVertexArray(shape.array);
  GLuint buffers[2];
  glGenBuffers(2, buffers);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(Vertex)),
               mesh.vertices.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(mesh.indices[0])),
               mesh.indices.data(), GL_STATIC_DRAW);
  for (const Location location : {position, normal}) {
    const std::size_t at =
        location == position ? offsetof(Vertex, position) : offsetof(Vertex, normal);
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), offset(at));
  }
  for (const Location location : {x_row, y_row, w_row, place, light, colour}) {
    glEnableVertexAttribArray(location);
    glVertexAttribDivisor(location, 1);
  }
  return shape;
}

void Painter::draw(const Shape& shape, std::size_t first, std::size_t count) {
  if (count == 0) {
    return;
  }
  glBindVertexArray(shape.array);
  const auto attribute = [&](Location location, GLint size, GLenum type, GLboolean normalised,
                             std::size_t at) {
    glVertexAttribPointer(location, size, type, normalised, sizeof(Instance),
                          offset(first * sizeof(Instance) + at));
  };
  attribute(x_row, 4, GL_FLOAT, GL_FALSE, offsetof(Instance, x));
  attribute(y_row, 4, GL_FLOAT, GL_FALSE, offsetof(Instance, y));
  attribute(w_row, 4, GL_FLOAT, GL_FALSE, offsetof(Instance, w));
  attribute(place, 4, GL_FLOAT, GL_FALSE, offsetof(Instance, place));
  attribute(light, 3, GL_FLOAT, GL_FALSE, offsetof(Instance, light));
  attribute(colour, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(Instance, colour));
  glDrawElementsInstanced(GL_TRIANGLES, shape.indices, GL_UNSIGNED_SHORT, nullptr,
                          static_cast<GLsizei>(count));
}

void Painter::use_image(const std::shared_ptr<const Image>& image) {
  if (image_program_ == 0) {
    image_program_ = link_with(kImageShader);
    glGenTextures(1, &texture_);
  }
  glUseProgram(image_program_);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture_);
  if (image == image_) return;
  load_floor(*image, GL_NEAREST);
  image_ = image;
}

void Painter::paint(const DrawList& list, const Scene& scene, int width, int height) {
  const Colour& sky = scene.sky;
  // Sets all state again, because painters may share a context.
  glUseProgram(program_);
  glViewport(0, 0, width, height);
  glScissor(0, 0, width, height);
  glEnable(GL_SCISSOR_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_DITHER);
  glDisable(GL_MULTISAMPLE);
  glEnable(GL_CULL_FACE);
  glFrontFace(GL_CW);  // the framebuffer's bottom row is the first row of a picture
  for (GLenum i = 0; i < kClipDistances; ++i) {
    glEnable(GL_CLIP_DISTANCE0 + i);
  }
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LESS);
  glClearDepth(1.0);
  glClearColor(static_cast<float>(sky.red) / 255.0F, static_cast<float>(sky.green) / 255.0F,
               static_cast<float>(sky.blue) / 255.0F, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

  glBindBuffer(GL_ARRAY_BUFFER, instances_);
  const auto bytes = [](const std::vector<Instance>& some) {
    return static_cast<GLsizeiptr>(some.size() * sizeof(Instance));
  };
  GLsizeiptr total = 0;
  for (const auto& some : list) total += bytes(some);
  glBufferData(GL_ARRAY_BUFFER, total, nullptr, GL_STREAM_DRAW);
  GLsizeiptr at = 0;
  for (const auto& some : list) {
    glBufferSubData(GL_ARRAY_BUFFER, at, bytes(some), some.data());
    at += bytes(some);
  }

  // Everything else stands on the floor, and marks lie flat on it: they are painted over it without
  // a depth test, in which the two would flicker.
  std::size_t first = 0;
  for (std::size_t i = 0; i < kMeshes; ++i) {
    i <= kDisc ? glDisable(GL_DEPTH_TEST) : glEnable(GL_DEPTH_TEST);
    const bool is_image = i == kImage && !list[i].empty();
    if (is_image) use_image(scene.image.pixels);
    draw(shapes_[i], first, list[i].size());
    if (is_image) glUseProgram(program_);
    first += list[i].size();
  }
}

}  // namespace elsie::render
