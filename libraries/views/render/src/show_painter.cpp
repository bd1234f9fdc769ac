#include "show_painter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "elsie/render/renderer.h"

#include "floor_texture.h"
#include "program.h"
#include "show_shaders.h"

namespace elsie::render {
namespace {

constexpr int kSunMap = 1024, kDomeMap = 512;  // px, of an edge of a map of shadows

// Behind the viewer's left shoulder if she looks north, so that what she sees of things is lit.
const Vector3 kSunDirection = [] {
  const Vector3 direction{-0.42, -0.36, 0.83};
  return (1.0 / std::sqrt(dot(direction, direction))) * direction;
}();
constexpr double kSunRadius = 0.07;  // rad, large enough for soft shadows

/// Numbers in [0, 1)^2 that fill the square evenly, however many are taken (Roberts 2018, R2).
Vector2 spread(int index, double shift = 0.5) {
  const auto part = [&](double step) {
    const double at = shift + step * index;
    return at - std::floor(at);
  };
  return {part(0.7548776662466927), part(0.5698402909980532)};
}

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Vector3 unit(const Vector3& v) { return (1.0 / std::sqrt(dot(v, v))) * v; }

struct Axes {
  Vector3 across, aside;
};
Axes axes_around(const Vector3& direction) {
  const Vector3 across =
      unit(cross(std::abs(direction.z) < 0.9 ? Vector3{0, 0, 1} : Vector3{1, 0, 0}, direction));
  return {across, cross(direction, across)};
}

/// A point of the sun's disc.
Vector3 sun_at(int pass) {
  if (pass == 0) return kSunDirection;
  const Vector2 at = spread(pass);
  const double away = kSunRadius * std::sqrt(at.x), round = 2.0 * std::numbers::pi * at.y;
  const Axes axes = axes_around(kSunDirection);
  return unit(kSunDirection + away * std::cos(round) * axes.across +
              away * std::sin(round) * axes.aside);
}

/// A direction of the sky, as often as a level face gets light from there.
Vector3 dome_at(int pass) {
  const Vector2 at = spread(pass, 0.31);
  const double up = std::sqrt(1.0 - 0.85 * at.x), round = 2.0 * std::numbers::pi * at.y;
  const double aside = std::sqrt(1.0 - up * up);
  return {aside * std::cos(round), aside * std::sin(round), up};
}

GLint at(GLuint program, const char* name) { return glGetUniformLocation(program, name); }

void set(GLuint program, const char* name, double value) {
  glUniform1f(at(program, name), static_cast<float>(value));
}
void set(GLuint program, const char* name, double x, double y) {
  glUniform2f(at(program, name), static_cast<float>(x), static_cast<float>(y));
}
void set(GLuint program, const char* name, const Vector3& v) {
  glUniform3f(at(program, name), static_cast<float>(v.x), static_cast<float>(v.y),
              static_cast<float>(v.z));
}
void set(GLuint program, const char* name, const Colour& c) {
  set(program, name, (1.0 / 255.0) * Vector3{double(c.red), double(c.green), double(c.blue)});
}

std::string shader(const std::string& body, const std::string& defines = {}) {
  return "#version 330 core\n" + defines + body;
}

}  // namespace

ShowPainter::ShowPainter() {
  const auto lit = [](const std::string& how) {
    const auto with = [&](const char* fragments, const char* what) {
      const bool is_shaded = how.empty() && fragments == kSolidFragments;
      return link(shader(std::string(kShares) + kBodyVertices, is_shaded ? "#define SHADED\n" : ""),
                  shader(std::string(kShares) + kLightMaps + fragments, how + what));
    };
    return Shaders{with(kFloorFragments, "#define ARENA\n"),
                   with(kFloorFragments, "#define AROUND\n"),
                   with(kFloorFragments, "#define IMAGE\n"),
                   {with(kSolidFragments, ""), with(kSolidFragments, "#define WALL\n"),
                    with(kSolidFragments, "#define WHEEL\n"),
                    link(shader(kBodyVertices), shader(kGlowingFragments))}};
  };
  plain_ = lit("");
  mapped_ = lit("#define MAPPED\n");
  depth_ = link(shader(kBodyVertices, "#define DEPTH\n"), shader(kDepthFragments));
  shadow_ =
      link(shader(kBodyVertices, "#define DEPTH\n#define FLATTENED\n"), shader(kFlatFragments));
  sky_ = link(shader(kSkyVertices), shader(kSkyFragments));
  contact_ = link(shader(kContactVertices), shader(kContactFragments));
  stroke_ = link(shader(kStrokeVertices), shader(kStrokeFragments));
  halo_ = link(shader(kGlowVertices), shader(kHaloFragments));
  pool_ = link(shader(kGlowVertices), shader(kPoolFragments));

  constexpr float kCorners[] = {-1, -1, -1, 1, 1, -1, 1, 1};
  glGenBuffers(1, &corner_buffer_);
  glBindBuffer(GL_ARRAY_BUFFER, corner_buffer_);
  glBufferData(GL_ARRAY_BUFFER, sizeof(kCorners), kCorners, GL_STATIC_DRAW);
  const std::array<SmoothMesh, kMeshes> all = smooth_meshes();
  for (std::size_t i = 0; i < kBox; ++i) flat_[i] = make_mesh(all[i]);
  around_ = make_mesh(all[kSquare]);
  near_walls_ = make_mesh(all[kBox]);
  for (auto& batches : solids_) {
    for (std::size_t i = kBox; i < kMeshes; ++i) batches[i] = make_mesh(all[i]);
  }
  const Attribute contact[] = {{first, 2, GL_FLOAT, offsetof(ShownContact, middle)},
                               {second, 2, GL_FLOAT, offsetof(ShownContact, forward)},
                               {third, 2, GL_FLOAT, offsetof(ShownContact, half)},
                               {fourth, 3, GL_FLOAT, offsetof(ShownContact, rounding)}};
  contacts_ = make_strip(contact, sizeof(ShownContact));
  const Attribute stroke[] = {{first, 3, GL_FLOAT, offsetof(ShownStroke, from)},
                              {second, 3, GL_FLOAT, offsetof(ShownStroke, to)},
                              {third, 4, GL_UNSIGNED_BYTE, offsetof(ShownStroke, colour), GL_TRUE},
                              {fourth, 2, GL_FLOAT, offsetof(ShownStroke, width)}};
  drawing_ = make_strip(stroke, sizeof(ShownStroke));
  strokes_ = make_strip(stroke, sizeof(ShownStroke));
  const Attribute glow[] = {{first, 3, GL_FLOAT, offsetof(ShownGlow, middle)},
                            {second, 1, GL_FLOAT, offsetof(ShownGlow, radius)},
                            {third, 4, GL_UNSIGNED_BYTE, offsetof(ShownGlow, colour), GL_TRUE}};
  halos_ = make_strip(glow, sizeof(ShownGlow));
  pools_ = make_strip(glow, sizeof(ShownGlow));
  sky_strip_ = make_strip({}, 0);
  sky_strip_.instances = 1;
  sun_map_ = make_map(kSunMap);
  dome_map_ = make_map(kDomeMap);
}

ShowPainter::Map ShowPainter::make_map(int size) {
  Map map{0, 0, size};
  glGenTextures(1, &map.texture);
  glBindTexture(GL_TEXTURE_2D, map.texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, size, size, 0, GL_DEPTH_COMPONENT,
               GL_UNSIGNED_INT, nullptr);
  for (const auto& [name, value] : {std::pair{GL_TEXTURE_MIN_FILTER, GL_LINEAR},
                                    {GL_TEXTURE_MAG_FILTER, GL_LINEAR},
                                    {GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER},
                                    {GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER},
                                    {GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE},
                                    {GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL}}) {
    glTexParameteri(GL_TEXTURE_2D, static_cast<GLenum>(name), value);
  }
  constexpr float kOpen[] = {1.0F, 1.0F, 1.0F, 1.0F};
  glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, kOpen);
  glGenFramebuffers(1, &map.framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, map.framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, map.texture, 0);
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
  return map;
}

void ShowPainter::enable(std::span<const Attribute> attributes, std::size_t stride,
                         GLuint divisor) {
  for (const Attribute& each : attributes) {
    glEnableVertexAttribArray(each.location);
    glVertexAttribPointer(each.location, each.size, each.type, each.is_part,
                          static_cast<GLsizei>(stride), offset(each.at));
    glVertexAttribDivisor(each.location, divisor);
  }
}

ShowPainter::Batch ShowPainter::make_mesh(const SmoothMesh& mesh) {
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
  const Attribute corner[] = {{position, 3, GL_FLOAT, offsetof(SmoothVertex, position)},
                              {normal, 3, GL_FLOAT, offsetof(SmoothVertex, normal)},
                              {inset, 3, GL_FLOAT, offsetof(SmoothVertex, inset)}};
  enable(corner, sizeof(SmoothVertex), 0);
  glGenBuffers(1, &batch.buffer);
  glBindBuffer(GL_ARRAY_BUFFER, batch.buffer);
  const Attribute body[] = {{first, 4, GL_FLOAT, offsetof(ShownBody, x)},
                            {second, 4, GL_FLOAT, offsetof(ShownBody, y)},
                            {third, 4, GL_FLOAT, offsetof(ShownBody, z)},
                            {fourth, 4, GL_UNSIGNED_BYTE, offsetof(ShownBody, colour)},
                            {fifth, 3, GL_FLOAT, offsetof(ShownBody, bevel)}};
  enable(body, sizeof(ShownBody), 1);
  return batch;
}

ShowPainter::Batch ShowPainter::make_strip(std::span<const Attribute> attributes,
                                           std::size_t stride) const {
  Batch batch;
  glGenVertexArrays(1, &batch.array);
  glBindVertexArray(batch.array);
  glBindBuffer(GL_ARRAY_BUFFER, corner_buffer_);
  glEnableVertexAttribArray(position);
  glVertexAttribPointer(position, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
  glGenBuffers(1, &batch.buffer);
  glBindBuffer(GL_ARRAY_BUFFER, batch.buffer);
  enable(attributes, stride, 1);
  return batch;
}

template <class Item>
void ShowPainter::upload(Batch& batch, const std::vector<Item>& items) {
  batch.instances = static_cast<GLsizei>(items.size());
  glBindBuffer(GL_ARRAY_BUFFER, batch.buffer);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(items.size() * sizeof(Item)), items.data(),
               GL_STREAM_DRAW);
}

void ShowPainter::draw(const Batch& batch) {
  if (batch.instances == 0) return;
  glBindVertexArray(batch.array);
  if (batch.indices > 0) {
    glDrawElementsInstanced(GL_TRIANGLES, batch.drawn, GL_UNSIGNED_SHORT, nullptr, batch.instances);
  } else {
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, batch.instances);
  }
}

void ShowPainter::draw_solids() const {
  for (const auto& batches : solids_) {
    for (std::size_t i = kBox; i < kMeshes; ++i) draw(batches[i]);
  }
}

void ShowPainter::compose(const Scene& scene, const View& view, const Style& style) {
  view_ = view;
  style_ = style;
  floor_image_ = scene.image.pixels;
  const ShownList list = list_shown(scene, view, style);
  for (std::size_t i = 0; i < kBox; ++i) upload(flat_[i], list.flat[i]);
  upload(around_, list.around);
  upload(near_walls_, list.near_walls);
  for (std::size_t material = 0; material < kMaterials; ++material) {
    for (std::size_t i = kBox; i < kMeshes; ++i) {
      upload(solids_[material][i], list.solids[material][i]);
    }
    Batch& boxes = solids_[material][kBox];
    boxes.drawn = list.is_bevelled ? boxes.indices : kBoxSides;
  }
  upload(contacts_, list.contacts);
  upload(drawing_, list.drawing);
  upload(strokes_, list.strokes);
  upload(halos_, list.halos);
  upload(pools_, list.pools);
  across_ = 1.0 / std::tan(0.5 * view.camera.horizontal_fov_rad);
  down_ = across_ * view.camera.width / view.camera.height;
  // Nothing is nearer than the highest thing below the camera.
  near_ = std::max(kNearest, 0.5 * (view.frame.origin.z - list.tallest));
  find_room(list.tallest);
}

/// The part of the arena that is in the picture, in which shadows are seen.
void ShowPainter::find_room(double tallest) {
  const Frame& eye = view_.frame;
  const Vector2 most{0.5 * style_.arena.x + 1.0, 0.5 * style_.arena.y + 1.0};
  Vector3 low{most.x, most.y, 0.0}, high{-most.x, -most.y, tallest};
  constexpr int kRays = 12;
  for (int column = 0; column <= kRays; ++column) {
    for (int row = 0; row <= kRays; ++row) {
      const Vector3 ray = eye.forward + ((1.0 - 2.0 * column / kRays) / across_) * eye.left +
                          ((1.0 - 2.0 * row / kRays) / down_) * eye.up;
      // Rays at or above the horizon reach the far end.
      const double way = ray.z < -1e-6 ? -eye.origin.z / ray.z : 1e6;
      const Vector3 at = eye.origin + way * ray;
      const double x = std::clamp(at.x, -most.x, most.x), y = std::clamp(at.y, -most.y, most.y);
      low.x = std::min(low.x, x), high.x = std::max(high.x, x);
      low.y = std::min(low.y, y), high.y = std::max(high.y, y);
    }
  }
  low_ = low - eye.origin;
  high_ = high - eye.origin;
}

/// By columns: x and y of OpenGL down and to the right, moved by part of a pixel.
ShowPainter::Matrix ShowPainter::camera_matrix(int pass) const {
  const Frame& eye = view_.frame;
  Vector2 shift;
  if (pass > 0) {
    const Vector2 part = spread(pass);
    shift = {2.0 * (part.x - 0.5) / view_.camera.width, 2.0 * (part.y - 0.5) / view_.camera.height};
  }
  const Vector3 x = (-across_) * eye.left + shift.x * eye.forward;
  const Vector3 y = (-down_) * eye.up + shift.y * eye.forward;
  const Vector3& w = eye.forward;
  const auto part = [](double value) { return static_cast<float>(value); };
  return {part(x.x), part(y.x), part(w.x),          part(w.x), part(x.y), part(y.y),
          part(w.y), part(w.y), part(x.z),          part(y.z), part(w.z), part(w.z),
          0,         0,         part(-2.0 * near_), 0};
}

/// Maps the room to a cube, seen from a light.
ShowPainter::Matrix ShowPainter::light_matrix(const Vector3& direction) const {
  const auto [across, aside] = axes_around(direction);
  const Vector3 rows[] = {across, aside, -1.0 * direction};
  Matrix matrix{};
  matrix[15] = 1.0F;
  for (int row = 0; row < 3; ++row) {
    double least = 1e300, most = -1e300;
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3 at{corner & 1 ? high_.x : low_.x, corner & 2 ? high_.y : low_.y,
                       corner & 4 ? high_.z : low_.z};
      least = std::min(least, dot(rows[row], at));
      most = std::max(most, dot(rows[row], at));
    }
    const double scale = 1.98 / std::max(1e-3, most - least), middle = 0.5 * (least + most);
    matrix[static_cast<std::size_t>(row)] = static_cast<float>(scale * rows[row].x);
    matrix[static_cast<std::size_t>(row) + 4] = static_cast<float>(scale * rows[row].y);
    matrix[static_cast<std::size_t>(row) + 8] = static_cast<float>(scale * rows[row].z);
    matrix[static_cast<std::size_t>(row) + 12] = static_cast<float>(-scale * middle);
  }
  return matrix;
}

void ShowPainter::draw_map(const Map& map, const Matrix& matrix) const {
  glBindFramebuffer(GL_FRAMEBUFFER, map.framebuffer);
  glViewport(0, 0, map.size, map.size);
  glScissor(0, 0, map.size, map.size);
  glDepthMask(GL_TRUE);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_DEPTH_CLAMP);
  glDisable(GL_CULL_FACE);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1.5F, 4.0F);
  glClear(GL_DEPTH_BUFFER_BIT);
  glUseProgram(depth_);
  glUniformMatrix4fv(at(depth_, "camera"), 1, GL_FALSE, matrix.data());
  draw_solids();
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDisable(GL_DEPTH_CLAMP);
}

void ShowPainter::use(GLuint program, const Matrix& camera) const {
  glUseProgram(program);
  glUniformMatrix4fv(at(program, "camera"), 1, GL_FALSE, camera.data());
  set(program, "eye", view_.frame.origin);
  set(program, "eye_height", view_.frame.origin.z);
  set(program, "nearest", near_);
}

void ShowPainter::light(GLuint program, const Lights& lights) const {
  set(program, "sun", lights.sun_direction);
  set(program, "dome", lights.dome_direction);
  const double widest = std::max({high_.x - low_.x, high_.y - low_.y, high_.z - low_.z});
  set(program, "sun_lift", 2.0 * widest / kSunMap);
  set(program, "dome_lift", 2.0 * widest / kDomeMap);
  // From -1 to 1 to the part of a texture.
  const auto as_texture = [](Matrix matrix) {
    for (std::size_t column = 0; column < 4; ++column) {
      for (std::size_t row = 0; row < 3; ++row) {
        matrix[4 * column + row] = 0.5F * matrix[4 * column + row] + 0.5F * matrix[4 * column + 3];
      }
    }
    return matrix;
  };
  glUniformMatrix4fv(at(program, "sun_matrix"), 1, GL_FALSE, as_texture(lights.sun).data());
  glUniformMatrix4fv(at(program, "dome_matrix"), 1, GL_FALSE, as_texture(lights.dome).data());
  glUniform1i(at(program, "sun_map"), 1);
  glUniform1i(at(program, "dome_map"), 2);
}

void ShowPainter::paint(GLuint framebuffer, Shadows shadows, int pass) {
  const int width = view_.camera.width, height = view_.camera.height;
  // Sets all state again, because painters may share a context.
  glEnable(GL_SCISSOR_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_DITHER);
  glDisable(GL_MULTISAMPLE);
  glDisable(GL_STENCIL_TEST);
  glFrontFace(GL_CW);  // the framebuffer's bottom row is the first row of a picture
  for (GLenum i = 0; i < 4; ++i) glDisable(GL_CLIP_DISTANCE0 + i);
  glDepthFunc(GL_LESS);
  glClearDepth(1.0);

  Lights lights{sun_at(pass), dome_at(pass), {}, {}};
  if (shadows == Shadows::soft) {
    lights.sun = light_matrix(lights.sun_direction);
    lights.dome = light_matrix(lights.dome_direction);
    draw_map(sun_map_, lights.sun);
    draw_map(dome_map_, lights.dome);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, sun_map_.texture);
    glActiveTexture(GL_TEXTURE2);
    glBindTexture(GL_TEXTURE_2D, dome_map_.texture);
  } else {
    lights.sun_direction = kSunDirection;
  }
  const Shaders& with = shadows == Shadows::soft ? mapped_ : plain_;

  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, width, height);
  glScissor(0, 0, width, height);
  glEnable(GL_CULL_FACE);
  glDepthMask(GL_TRUE);
  glClearStencil(0);
  glClearColor(static_cast<float>(style_.horizon.red) / 255.0F,
               static_cast<float>(style_.horizon.green) / 255.0F,
               static_cast<float>(style_.horizon.blue) / 255.0F, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glDisable(GL_DEPTH_TEST);
  draw_sky();
  const Matrix camera = camera_matrix(pass);
  draw_floor(camera, with, lights);
  if (shadows == Shadows::hard) draw_hard_shadows(camera);

  glEnable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  for (std::size_t material = 0; material < kMaterials; ++material) {
    use(with.solids[material], camera);
    light(with.solids[material], lights);
    for (std::size_t i = kBox; i < kMeshes; ++i) draw(solids_[material][i]);
  }
  draw_strokes(camera);
  draw_near_walls(camera, with, lights);
  glDepthMask(GL_TRUE);
}

/// As if of glass, without shadows: first their depth, so that only the nearest of their faces is
/// seen.
void ShowPainter::draw_near_walls(const Matrix& camera, const Shaders& with,
                                  const Lights& lights) const {
  if (near_walls_.instances == 0) return;
  const GLuint program = with.solids[index_of(Material::wall)];
  use(program, camera);
  light(program, lights);
  glEnable(GL_CULL_FACE);
  glDepthMask(GL_TRUE);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  draw(near_walls_);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthFunc(GL_LEQUAL);
  glEnable(GL_BLEND);
  glBlendColor(0.0F, 0.0F, 0.0F, 0.45F);
  glBlendFuncSeparate(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA, GL_ZERO, GL_ONE);
  draw(near_walls_);
  glDisable(GL_BLEND);
  glDepthFunc(GL_LESS);
}

/// Above the horizon, which is level in the picture unless the camera rolls.
void ShowPainter::draw_sky() const {
  const int width = view_.camera.width, height = view_.camera.height;
  const Frame& eye = view_.frame;
  const Vector3 right = (-1.0 / across_) * eye.left, down = (-1.0 / down_) * eye.up;
  double lowest = 1.0;  // of the horizon, from -1 at the top to 1
  if (down.z < -1e-6) {
    const auto horizon = [&](double x) { return -(eye.forward.z + x * right.z) / down.z; };
    lowest = std::max(horizon(-1.0), horizon(1.0));
  }
  const auto rows = static_cast<int>(std::ceil(0.5 * (1.0 + lowest) * height)) + 1;
  if (rows <= 0) return;
  glScissor(0, 0, width, std::min(rows, height));
  glDisable(GL_CULL_FACE);
  glUseProgram(sky_);
  set(sky_, "forward", eye.forward);
  set(sky_, "right", right);
  set(sky_, "down", down);
  set(sky_, "horizon", style_.horizon);
  set(sky_, "zenith", style_.zenith);
  draw(sky_strip_);
  glScissor(0, 0, width, height);
}

void ShowPainter::draw_floor(const Matrix& camera, const Shaders& with, const Lights& lights) {
  const auto prepare = [&](GLuint program) {
    use(program, camera);
    light(program, lights);
  };
  glEnable(GL_CULL_FACE);
  prepare(with.around);
  set(with.around, "outside", style_.outside);
  set(with.around, "horizon", style_.horizon);
  set(with.around, "reach", std::max(0.1, 0.5 * std::hypot(style_.arena.x, style_.arena.y)));
  draw(around_);
  prepare(with.floor);
  draw(flat_[kSquare]);
  if (flat_[kImage].instances > 0) {
    use_image();
    prepare(with.image);
    glUniform1i(at(with.image, "image"), 0);
    draw(flat_[kImage]);
    glUseProgram(with.floor);
  }
  draw(flat_[kTriangle]);
  draw(flat_[kDisc]);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  // What lies over the floor does not change how much of a pixel is floor.
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  use(pool_, camera);
  set(pool_, "right", Vector3{1, 0, 0});
  set(pool_, "down", Vector3{0, 1, 0});
  draw(pools_);
  use(stroke_, camera);
  set(stroke_, "half_picture", 0.5 * view_.camera.width, 0.5 * view_.camera.height);
  set(stroke_, "faint", 1.0);
  const double away = std::hypot(view_.frame.origin.x, view_.frame.origin.y, view_.frame.origin.z);
  set(stroke_, "fades_at", 1.2 * (away + std::hypot(style_.arena.x, style_.arena.y)));
  draw(drawing_);
}

/// The ground around things, then all things but wheels, which are below others, flattened along
/// the sun's light. Where several shadows meet, only one is drawn.
void ShowPainter::draw_hard_shadows(const Matrix& camera) const {
  use(contact_, camera);
  draw(contacts_);
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_EQUAL, 0, 0xFF);
  glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
  use(shadow_, camera);
  set(shadow_, "sun", kSunDirection);
  glUniform4f(at(shadow_, "flat_colour"), 0.05F, 0.07F, 0.1F, 0.36F);
  for (const Material material : {Material::plain, Material::wall}) {
    for (const Batch& batch : solids_[index_of(material)]) draw(batch);
  }
  glDisable(GL_STENCIL_TEST);
  glEnable(GL_CULL_FACE);
}

/// What is behind something is drawn, too, but fainter.
void ShowPainter::draw_strokes(const Matrix& camera) const {
  const Frame& eye = view_.frame;
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glDepthMask(GL_FALSE);
  use(halo_, camera);
  set(halo_, "right", -1.0 * eye.left);
  set(halo_, "down", -1.0 * eye.up);
  draw(halos_);
  use(stroke_, camera);
  set(stroke_, "half_picture", 0.5 * view_.camera.width, 0.5 * view_.camera.height);
  set(stroke_, "fades_at", 0.0);
  set(stroke_, "faint", 1.0);
  draw(strokes_);
  glDepthFunc(GL_GREATER);
  set(stroke_, "faint", 0.25);
  draw(strokes_);
  glDepthFunc(GL_LESS);
  glDisable(GL_BLEND);
}

void ShowPainter::use_image() {
  if (texture_ == 0) glGenTextures(1, &texture_);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture_);
  if (floor_image_ == image_) return;
  load_floor(*floor_image_, GL_LINEAR);
  image_ = floor_image_;
}

}  // namespace elsie::render
