// Programs of shaders.
#pragma once

#include <string>

#include <epoxy/gl.h>

namespace elsie::render {

/// Compiles and links a program, and makes it the current one. Throws RenderError with the driver's
/// words.
GLuint link(const std::string& vertex_shader, const std::string& fragment_shader);

/// An offset in a buffer, as OpenGL takes it.
inline const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

}  // namespace elsie::render
