#include "show_painter.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "elsie/render/renderer.h"

#include "floor_texture.h"
#include "program.h"
#include "show_shaders.h"

namespace elsie::render {
namespace {

/// Pixels of an edge of the sun's map of shadows: about as many as the picture has. That of the
/// sky, which has no sharp shadows, has half of them.
int map_size(const Camera& camera) {
  const int edge = std::max(camera.width, camera.height);
  return static_cast<int>(
      std::bit_ceil(static_cast<unsigned>(std::clamp(edge * 4 / 5, 256, 2048))));
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

ShowPainter::Shaders ShowPainter::make_shaders(const std::string& how) {
  const auto with = [&](const char* fragments, const char* what) {
    const bool is_shaded = how.empty() && fragments == kSolidFragments;
    return link(shader(std::string(kShares) + kBodyVertices, is_shaded ? "#define SHADED\n" : ""),
                shader(std::string(kShares) + kLightMaps + fragments, how + what));
  };
  return {with(kFloorFragments, "#define ARENA\n"),
          with(kFloorFragments, "#define AROUND\n"),
          with(kFloorFragments, "#define IMAGE\n"),
          {with(kSolidFragments, ""), with(kSolidFragments, "#define WALL\n"),
           with(kSolidFragments, "#define WHEEL\n"),
           link(shader(kBodyVertices), shader(kGlowingFragments))}};
}

const ShowPainter::Shaders& ShowPainter::shaders_for(Shadows shadows) {
  if (shadows < Shadows::sun) return plain_;
  if (shadows == Shadows::soft) return mapped_;
  if (!sunny_) sunny_ = make_shaders("#define MAPPED\n");
  return *sunny_;
}

ShowPainter::ShowPainter()
    : plain_(make_shaders("")), mapped_(make_shaders("#define MAPPED\n#define DOMED\n")) {
  depth_ = link(shader(kBodyVertices, "#define DEPTH\n"), shader(kDepthFragments));
  shadow_ =
      link(shader(kBodyVertices, "#define DEPTH\n#define FLATTENED\n"), shader(kFlatFragments));
  sky_ = link(shader(kSkyVertices), shader(kSkyFragments));
  contact_ = link(shader(kContactVertices), shader(kContactFragments));
  stroke_ = link(shader(kStrokeVertices), shader(kStrokeFragments));
  halo_ = link(shader(kGlowVertices), shader(kHaloFragments));
  pool_ = link(shader(kGlowVertices), shader(kPoolFragments));

  const std::array<SmoothMesh, kMeshes> all = smooth_meshes();
  for (std::size_t i = 0; i < kBox; ++i) flat_[i] = make_mesh(all[i]);
  around_ = make_mesh(all[kSquare]);
  beyond_ = make_mesh(all[kSquare]);
  near_walls_ = make_mesh(all[kBox]);
  for (auto& batches : solids_) {
    for (std::size_t i = kBox; i < kMeshes; ++i) batches[i] = make_mesh(all[i]);
  }
  const Attribute contact[] = {{slot::kFirst, 2, GL_FLOAT, offsetof(ShownContact, middle)},
                               {slot::kSecond, 2, GL_FLOAT, offsetof(ShownContact, forward)},
                               {slot::kThird, 2, GL_FLOAT, offsetof(ShownContact, half)},
                               {slot::kFourth, 3, GL_FLOAT, offsetof(ShownContact, rounding)}};
  contacts_ = make_strip(contact, sizeof(ShownContact));
  const Attribute stroke[] = {
      {slot::kFirst, 3, GL_FLOAT, offsetof(ShownStroke, from)},
      {slot::kSecond, 3, GL_FLOAT, offsetof(ShownStroke, to)},
      {slot::kThird, 4, GL_UNSIGNED_BYTE, offsetof(ShownStroke, colour), GL_TRUE},
      {slot::kFourth, 2, GL_FLOAT, offsetof(ShownStroke, width)}};
  drawing_ = make_strip(stroke, sizeof(ShownStroke));
  strokes_ = make_strip(stroke, sizeof(ShownStroke));
  const Attribute glow[] = {
      {slot::kFirst, 3, GL_FLOAT, offsetof(ShownGlow, middle)},
      {slot::kSecond, 1, GL_FLOAT, offsetof(ShownGlow, radius)},
      {slot::kThird, 4, GL_UNSIGNED_BYTE, offsetof(ShownGlow, colour), GL_TRUE}};
  halos_ = make_strip(glow, sizeof(ShownGlow));
  pools_ = make_strip(glow, sizeof(ShownGlow));
  sky_strip_ = make_strip({}, 0);
  sky_strip_.instances = 1;
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
  upload(beyond_, list.beyond);
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
  sun_map_.resize(map_size(view.camera));
  dome_map_.resize(sun_map_.size() / 2);
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
  room_ = {low - eye.origin, high - eye.origin};
}

/// By columns: x and y of OpenGL down and to the right, moved by part of a pixel.
Matrix ShowPainter::camera_matrix(int pass) const {
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

void ShowPainter::draw_map(const ShadowMap& map, const Matrix& matrix) const {
  map.begin();
  glUseProgram(depth_);
  glUniformMatrix4fv(at(depth_, "camera"), 1, GL_FALSE, matrix.data());
  draw_solids();
  ShadowMap::end();
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
  const double lift = 2.0 * room_.widest();  // of two pixels of a map
  set(program, "sun_lift", lift / sun_map_.size());
  set(program, "dome_lift", lift / dome_map_.size());
  set(program, "dome_blur", 2.0 / dome_map_.size());
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
  for (GLenum i = 0; i < 4; ++i) glDisable(GL_CLIP_DISTANCE0 + i);
  glDepthFunc(GL_LESS);
  glClearDepth(1.0);

  Lights lights{sun_at(pass), dome_at(pass), {}, {}};
  if (shadows >= Shadows::sun) {
    lights.sun = light_matrix(room_, lights.sun_direction);
    draw_map(sun_map_, lights.sun);
    sun_map_.bind(GL_TEXTURE1);
  } else {
    lights.sun_direction = kSunDirection;
  }
  if (shadows == Shadows::soft) {
    lights.dome = light_matrix(room_, lights.dome_direction);
    draw_map(dome_map_, lights.dome);
    dome_map_.bind(GL_TEXTURE2);
  }
  const Shaders& with = shaders_for(shadows);

  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, width, height);
  glScissor(0, 0, width, height);
  glEnable(GL_CULL_FACE);
  glFrontFace(GL_CW);  // the framebuffer's bottom row is the first row of a picture
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
  if (shadows == Shadows::hard || shadows == Shadows::sun) draw_contacts(camera);
  if (shadows == Shadows::hard) draw_hard_shadows(camera);

  glEnable(GL_CULL_FACE);
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
  for (const auto& [program, outside] :
       {std::pair{with.around, &around_}, {plain_.around, &beyond_}}) {
    prepare(program);
    set(program, "outside", style_.outside);
    set(program, "horizon", style_.horizon);
    set(program, "reach", std::max(0.1, 0.5 * std::hypot(style_.arena.x, style_.arena.y)));
    draw(*outside);
  }
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

/// The ground around things.
void ShowPainter::draw_contacts(const Matrix& camera) const {
  use(contact_, camera);
  draw(contacts_);
}

/// All things but wheels, which are below others, flattened along the sun's light. Where several
/// shadows meet, only one is drawn.
void ShowPainter::draw_hard_shadows(const Matrix& camera) const {
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
