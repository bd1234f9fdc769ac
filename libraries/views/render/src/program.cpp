#include "program.h"

#include "elsie/render/renderer.h"

namespace elsie::render {
namespace {

[[noreturn]] void refuse(const char* what, const std::string& why) {
  throw RenderError("the OpenGL driver refuses the " + std::string(what) +
                    " with which pictures are drawn: " + why);
}

GLuint compile(GLenum type, const std::string& text) {
  const GLuint shader = glCreateShader(type);
  const char* const source = text.c_str();
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (!compiled) {
    char why[1024] = "";
    glGetShaderInfoLog(shader, sizeof(why), nullptr, why);
    refuse("shader", why);
  }
  return shader;
}

}  // namespace

GLuint link(const std::string& vertex_shader, const std::string& fragment_shader) {
  const GLuint program = glCreateProgram();
  for (const GLuint shader :
       {compile(GL_VERTEX_SHADER, vertex_shader), compile(GL_FRAGMENT_SHADER, fragment_shader)}) {
    glAttachShader(program, shader);
    glDeleteShader(shader);  // deleted with the program
  }
  glLinkProgram(program);
  GLint linked = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (!linked) {
    char why[1024] = "";
    glGetProgramInfoLog(program, sizeof(why), nullptr, why);
    refuse("program", why);
  }
  glUseProgram(program);
  return program;
}

}  // namespace elsie::render
