// What a light sees: how far things are from it.
#pragma once

#include <epoxy/gl.h>

namespace elsie::render {

class ShadowMap {
 public:
  /// Needs the current context of all later calls.
  ShadowMap();
  ShadowMap(const ShadowMap&) = delete;
  ShadowMap& operator=(const ShadowMap&) = delete;

  /// Gives it that many pixels at each edge.
  void resize(int size);
  int size() const { return size_; }  // px
  /// Directs what is drawn next into the empty map: the fronts of things that the light sees.
  void begin() const;
  static void end();
  /// For the shaders.
  void bind(GLenum unit) const;

 private:
  GLuint framebuffer_ = 0, texture_ = 0;
  int size_ = 0;
};

}  // namespace elsie::render
