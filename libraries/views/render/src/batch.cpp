#include "batch.h"

#include "program.h"
#include "shown.h"

namespace elsie::render {
namespace {

void enable(std::span<const Attribute> attributes, std::size_t stride, GLuint divisor) {
  for (const Attribute& each : attributes) {
    glEnableVertexAttribArray(each.slot);
    glVertexAttribPointer(each.slot, each.size, each.type, each.is_part,
                          static_cast<GLsizei>(stride), offset(each.at));
    glVertexAttribDivisor(each.slot, divisor);
  }
}

}  // namespace

Batch make_mesh(const SmoothMesh& mesh) {
  Batch batch;
  batch.indices = batch.drawn = static_cast<GLsizei>(mesh.indices.size());
  glGenVertexArrays(1, &batch.array);
  glBindVertexArray(batch.array);
  GLuint buffers[2];
  glGenBuffers(2, buffers);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  glBufferData(GL_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(SmoothVertex)),
               mesh.vertices.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(mesh.indices[0])),
               mesh.indices.data(), GL_STATIC_DRAW);
  const Attribute corner[] = {{slot::kPosition, 3, GL_FLOAT, offsetof(SmoothVertex, position)},
                              {slot::kNormal, 3, GL_FLOAT, offsetof(SmoothVertex, normal)},
                              {slot::kInset, 3, GL_FLOAT, offsetof(SmoothVertex, inset)}};
  enable(corner, sizeof(SmoothVertex), 0);
  glGenBuffers(1, &batch.buffer);
  glBindBuffer(GL_ARRAY_BUFFER, batch.buffer);
  const Attribute body[] = {{slot::kFirst, 4, GL_FLOAT, offsetof(ShownBody, x)},
                            {slot::kSecond, 4, GL_FLOAT, offsetof(ShownBody, y)},
                            {slot::kThird, 4, GL_FLOAT, offsetof(ShownBody, z)},
                            {slot::kFourth, 4, GL_UNSIGNED_BYTE, offsetof(ShownBody, colour)},
                            {slot::kFifth, 3, GL_FLOAT, offsetof(ShownBody, bevel)}};
  enable(body, sizeof(ShownBody), 1);
  return batch;
}

Batch make_strip(std::span<const Attribute> attributes, std::size_t stride) {
  constexpr float kCorners[] = {-1, -1, -1, 1, 1, -1, 1, 1};
  Batch batch;
  glGenVertexArrays(1, &batch.array);
  glBindVertexArray(batch.array);
  GLuint corners = 0;
  glGenBuffers(1, &corners);
  glBindBuffer(GL_ARRAY_BUFFER, corners);
  glBufferData(GL_ARRAY_BUFFER, sizeof(kCorners), kCorners, GL_STATIC_DRAW);
  glEnableVertexAttribArray(slot::kPosition);
  glVertexAttribPointer(slot::kPosition, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
  glGenBuffers(1, &batch.buffer);
  glBindBuffer(GL_ARRAY_BUFFER, batch.buffer);
  enable(attributes, stride, 1);
  return batch;
}

void upload(Batch& batch, const void* items, std::size_t count, std::size_t bytes) {
  batch.instances = static_cast<GLsizei>(count);
  glBindBuffer(GL_ARRAY_BUFFER, batch.buffer);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), items, GL_STREAM_DRAW);
}

void draw(const Batch& batch) {
  if (batch.instances == 0) return;
  glBindVertexArray(batch.array);
  if (batch.indices > 0) {
    glDrawElementsInstanced(GL_TRIANGLES, batch.drawn, GL_UNSIGNED_SHORT, nullptr, batch.instances);
  } else {
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, batch.instances);
  }
}

}  // namespace elsie::render
