// An OpenGL context without a window.
#pragma once

#include <epoxy/egl.h>

namespace elsie::render {

/// An OpenGL 3.3 core context of a graphics card, or else of Mesa's software rasteriser.
class EglContext {
 public:
  /// Throws RenderError.
  EglContext();
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  /// Makes the context current in the calling thread while it lives, then restores the one before.
  class Current {
   public:
    /// Throws RenderError.
    explicit Current(const EglContext& context);
    ~Current();
    Current(const Current&) = delete;
    Current& operator=(const Current&) = delete;

   private:
    EGLDisplay display_;
    EGLenum api_before_;
    EGLDisplay display_before_;
    EGLSurface draw_before_, read_before_;
    EGLContext context_before_;
  };

 private:
  bool open(EGLDisplay display);

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace elsie::render
