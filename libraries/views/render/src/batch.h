// What is drawn by one call: many instances of a mesh, or of a strip of four corners.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <epoxy/gl.h>

#include "meshes.h"

namespace elsie::render {

/// Where the shaders find what is known of a mesh's corners, then of what there are many of.
namespace slot {
inline constexpr GLuint kPosition = 0, kNormal = 1, kInset = 2;
inline constexpr GLuint kFirst = 3, kSecond = 4, kThird = 5, kFourth = 6, kFifth = 7;
}  // namespace slot

struct Attribute {
  GLuint slot;
  GLint size;
  GLenum type;
  std::size_t at;
  GLboolean is_part = GL_FALSE;  // of 255
};

struct Batch {
  GLuint array = 0;
  GLuint buffer = 0;    // of the instances
  GLsizei indices = 0;  // 0: a strip
  GLsizei drawn = 0;    // of the indices
  GLsizei instances = 0;
};

/// A mesh whose instances are of ShownBody.
Batch make_mesh(const SmoothMesh& mesh);
/// The corners are those of a square from -1 to 1.
Batch make_strip(std::span<const Attribute> attributes, std::size_t stride);
void upload(Batch& batch, const void* items, std::size_t count, std::size_t bytes);
template <class Item>
void upload(Batch& batch, const std::vector<Item>& items) {
  upload(batch, items.data(), items.size(), items.size() * sizeof(Item));
}
void draw(const Batch& batch);

}  // namespace elsie::render
