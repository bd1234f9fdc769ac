// The shaders of pictures for people. All places are in the world's axes, from the camera's place.
#pragma once

namespace elsie::render {

/// Bodies by their meshes. Without maps of shadows, light is computed for corners only.
inline constexpr const char* kBodyVertices = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 inset;
layout(location = 3) in vec4 x_row;
layout(location = 4) in vec4 y_row;
layout(location = 5) in vec4 z_row;
layout(location = 6) in vec4 colour;
layout(location = 7) in vec3 bevel;
uniform mat4 camera;
uniform vec3 sun;
uniform float eye_height;
out vec3 place;
out vec3 outwards;
out vec3 inside;
flat out vec3 surface;
#ifdef SHADED
out vec2 light;
#endif
void main() {
  vec3 a = vec3(x_row.x, y_row.x, z_row.x), b = vec3(x_row.y, y_row.y, z_row.y),
       c = vec3(x_row.z, y_row.z, z_row.z);
  vec4 at = vec4(position - inset * bevel, 1.0);
  place = vec3(dot(x_row, at), dot(y_row, at), dot(z_row, at));
#ifndef DEPTH
  outwards = normal.x * cross(b, c) + normal.y * cross(c, a) + normal.z * cross(a, b);
  inside = position;
  surface = colour.rgb / 255.0;
#endif
#ifdef FLATTENED
  float height = max(0.0, place.z + eye_height);
  place = vec3(place.xy - sun.xy / sun.z * height, -eye_height);
#endif
#ifdef SHADED
  vec3 unit = outwards * inversesqrt(dot(outwards, outwards));
  float up = 0.5 + 0.5 * unit.z;
  light = vec2(kSky * mix(0.74, 1.0, up) + kSun * min(max(dot(unit, sun), 0.0) / sun.z, 1.15),
               0.35 * (1.0 - up));
#endif
  gl_Position = camera * vec4(place, 1.0);
}
)";

inline constexpr const char* kDepthFragments = R"(
void main() {}
)";

inline constexpr const char* kFlatFragments = R"(
uniform vec4 flat_colour;
out vec4 pixel;
void main() { pixel = flat_colour; }
)";

/// How much light comes to a place: that of the sun, and that of the sky. The shares of both on an
/// open floor add up to 1.
inline constexpr const char* kShares = R"(
const float kSun = 0.42, kSky = 0.58;
)";

inline constexpr const char* kLightMaps = R"(
uniform vec3 sun;
#ifdef MAPPED
uniform sampler2DShadow sun_map;
uniform mat4 sun_matrix;
uniform float sun_lift;
float open_to_sun(vec3 at) {
  return texture(sun_map, (sun_matrix * vec4(at, 1.0)).xyz);
}
#endif
#ifdef DOMED
uniform sampler2DShadow dome_map;
uniform mat4 dome_matrix;
uniform vec3 dome;
uniform float dome_lift, dome_blur;
// Blurred: as each pass has one direction of the sky, its shadows would have hard edges.
float open_to_dome(vec3 at) {
  vec3 place = (dome_matrix * vec4(at, 1.0)).xyz;
  float away = dome_blur;
  return 0.25 * (texture(dome_map, place + vec3(away, 0.4 * away, 0.0)) +
                 texture(dome_map, place + vec3(-0.4 * away, away, 0.0)) +
                 texture(dome_map, place + vec3(-away, -0.4 * away, 0.0)) +
                 texture(dome_map, place + vec3(0.4 * away, -away, 0.0)));
}
#endif
)";

inline constexpr const char* kFloorFragments = R"(
in vec3 place;
in vec3 inside;
flat in vec3 surface;
uniform vec3 eye;
uniform vec3 outside, horizon;
uniform float reach;
uniform sampler2D image;
out vec4 pixel;
void main() {
#if defined(IMAGE)
  vec3 colour = texture(image, 0.5 + 0.5 * vec2(inside.x, -inside.y)).rgb;
#elif defined(AROUND)
  vec2 at = place.xy + eye.xy;
  vec3 colour = mix(outside, horizon, smoothstep(reach, 4.0 * reach, length(at)));
#else
  vec3 colour = surface;
#endif
#if defined(DOMED)
  colour *= kSun * open_to_sun(place) + kSky * open_to_dome(place);
#elif defined(MAPPED)
  colour *= kSun * open_to_sun(place) + kSky;
#endif
  pixel = vec4(colour, 1.0);
}
)";

inline constexpr const char* kSolidFragments = R"(
in vec3 place;
in vec3 outwards;
in vec3 inside;
flat in vec3 surface;
uniform vec3 eye;
out vec4 pixel;
float line_at(float coordinate, float half_width) {
  float unit = fwidth(coordinate);
  float away = 0.5 - abs(fract(coordinate) - 0.5);
  return (1.0 - smoothstep(half_width, half_width + unit, away)) *
         min(1.0, 2.0 * half_width / max(unit, 1e-6));
}
vec3 material(vec3 normal) {
#if defined(WALL)
  vec3 at = place + eye;
  float along = abs(normal.x) > abs(normal.y) ? at.y : at.x;
  float side = step(abs(normal.z), 0.5 * length(normal));
  vec3 colour = surface * (1.0 - 0.16 * side * line_at(along + 0.5, 0.006));
  colour *= 1.0 - 0.22 * side * (1.0 - smoothstep(0.025, 0.03, at.z));
  return mix(colour, vec3(1.0), 0.3 * (1.0 - side));
#elif defined(WHEEL)
  float angle = atan(inside.x, inside.z) / 6.2831853, away = length(inside.xz);
  vec3 tread = surface * (1.0 - 0.6 * line_at(angle * 18.0, 0.22));
  vec3 spokes = mix(vec3(0.33), vec3(0.86), line_at(angle * 3.0, 0.16));
  vec3 hub = away < 0.2 ? vec3(0.86) : spokes;
  return abs(inside.y) < 0.49 ? tread : away > 0.66 ? surface : hub;
#else
  return surface;
#endif
}
// Darker near the floor.
float at_foot() { return max(0.0, 1.0 - (place.z + eye.z) / 0.08); }
#ifdef MAPPED
void main() {
  vec3 normal = normalize(outwards);
  float up = 0.5 + 0.5 * normal.z;
  float direct = dot(normal, sun);
  float open = 1.0, sky = mix(0.74, 1.0, up);
  if (direct > 0.0) open = open_to_sun(place + sun_lift * normal);
#ifdef DOMED
  if (dot(normal, dome) > 0.05) sky *= open_to_dome(place + dome_lift * normal);
#else
  sky *= 1.0 - 0.35 * (1.0 - up) * at_foot();
#endif
  float light = kSky * sky + kSun * open * min(max(direct, 0.0) / sun.z, 1.15);
  float shine = pow(max(0.0, dot(normal, normalize(sun - normalize(place)))), 32.0);
  pixel = vec4(material(normal) * light + 0.2 * open * shine, 0.0);
}
#else
in vec2 light;
void main() {
  pixel = vec4(material(outwards) * (light.x * (1.0 - light.y * at_foot())), 0.0);
}
#endif
)";

/// What shines needs no light.
inline constexpr const char* kGlowingFragments = R"(
in vec3 place;
in vec3 outwards;
flat in vec3 surface;
out vec4 pixel;
void main() {
  float facing = max(0.0, dot(normalize(outwards), -normalize(place)));
  pixel = vec4(mix(surface, vec3(1.0), 0.75 * facing * facing), 0.0);
}
)";

inline constexpr const char* kSkyVertices = R"(
layout(location = 0) in vec2 corner;
uniform vec3 forward, right, down;
out vec3 direction;
void main() {
  direction = forward + corner.x * right + corner.y * down;
  gl_Position = vec4(corner, 0.0, 1.0);
}
)";

inline constexpr const char* kSkyFragments = R"(
in vec3 direction;
uniform vec3 horizon, zenith;
out vec4 pixel;
void main() {
  float up = max(0.0, direction.z) * inversesqrt(dot(direction, direction));
  pixel = vec4(mix(horizon, zenith, min(1.0, 1.5 * up)), 1.0);
}
)";

/// The ground around a rectangle with round corners.
inline constexpr const char* kContactVertices = R"(
layout(location = 0) in vec2 corner;
layout(location = 3) in vec2 middle;
layout(location = 4) in vec2 ahead;
layout(location = 5) in vec2 half_size;
layout(location = 6) in vec3 blur;
uniform mat4 camera;
uniform float eye_height;
out vec2 at;
flat out vec2 room;
flat out vec3 soft;
void main() {
  at = corner * (half_size + blur.y);
  room = half_size - blur.x;
  soft = blur;
  vec2 place = middle + at.x * ahead + at.y * vec2(-ahead.y, ahead.x);
  gl_Position = camera * vec4(place, -eye_height, 1.0);
}
)";

inline constexpr const char* kContactFragments = R"(
in vec2 at;
flat in vec2 room;
flat in vec3 soft;
out vec4 pixel;
void main() {
  vec2 away = abs(at) - room;
  float distance = length(max(away, 0.0)) + min(max(away.x, away.y), 0.0) - soft.x;
  float near = 1.0 - clamp(distance / soft.y, 0.0, 1.0);
  pixel = vec4(0.0, 0.0, 0.0, soft.z * near * near);
}
)";

/// A line as a strip as wide as it is in pixels, without what is behind the camera.
inline constexpr const char* kStrokeVertices = R"(
layout(location = 0) in vec2 corner;
layout(location = 3) in vec3 from;
layout(location = 4) in vec3 to;
layout(location = 5) in vec4 colour;
layout(location = 6) in vec2 pen;
uniform mat4 camera;
uniform vec2 half_picture;
uniform float nearest;
noperspective out vec2 at;
noperspective out float nearness;
flat out vec2 shape;
flat out vec4 ink;
void main() {
  vec4 a = camera * vec4(from, 1.0), b = camera * vec4(to, 1.0);
  float least = 1.01 * nearest;
  if (a.w < least && b.w < least) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  if (a.w < least) a = mix(a, b, (least - a.w) / (b.w - a.w));
  if (b.w < least) b = mix(b, a, (least - b.w) / (a.w - b.w));
  vec2 begin = a.xy / a.w * half_picture, end = b.xy / b.w * half_picture;
  float span = max(length(end - begin), 1e-4);
  vec2 way = (end - begin) / span, side = vec2(-way.y, way.x);
  float half_width = 0.5 * pen.x + 1.0;
  bool is_end = corner.x > 0.0;
  vec4 point = is_end ? b : a;
  vec2 place = (is_end ? end : begin) + corner.y * half_width * side;
  at = vec2(corner.y * half_width, is_end ? span : 0.0);
  nearness = 1.0 / point.w;
  shape = vec2(0.5 * pen.x, pen.y);
  ink = colour;
  // A little nearer than it is, so that it does not flicker on a surface.
  float w = 0.997 * point.w;
  gl_Position = vec4(place / half_picture, 1.0 - 2.0 * nearest / max(w, nearest), 1.0);
}
)";

inline constexpr const char* kStrokeFragments = R"(
noperspective in vec2 at;
noperspective in float nearness;
flat in vec2 shape;
flat in vec4 ink;
uniform float faint, fades_at;
out vec4 pixel;
void main() {
  if (shape.y > 0.0 && mod(at.y, 2.0 * shape.y) > shape.y) discard;
  float cover = clamp(shape.x + 0.5 - abs(at.x), 0.0, 1.0) * min(1.0, 2.0 * shape.x);
  float fade = fades_at > 0.0 ? 1.0 - smoothstep(0.3, 1.0, 1.0 / (nearness * fades_at)) : 1.0;
  pixel = vec4(ink.rgb, ink.a * faint * cover * fade);
}
)";

inline constexpr const char* kGlowVertices = R"(
layout(location = 0) in vec2 corner;
layout(location = 3) in vec3 middle;
layout(location = 4) in float radius;
layout(location = 5) in vec4 colour;
uniform mat4 camera;
uniform vec3 right, down;
out vec2 at;
flat out vec4 ink;
void main() {
  at = corner;
  ink = colour;
  gl_Position = camera * vec4(middle + radius * (corner.x * right + corner.y * down), 1.0);
}
)";

inline constexpr const char* kHaloFragments = R"(
in vec2 at;
flat in vec4 ink;
out vec4 pixel;
void main() {
  float near = max(0.0, 1.0 - length(at));
  pixel = vec4(mix(ink.rgb, vec3(1.0), 0.5 * near), ink.a * near * near);
}
)";

inline constexpr const char* kPoolFragments = R"(
in vec2 at;
flat in vec4 ink;
out vec4 pixel;
void main() {
  float near = max(0.0, 1.0 - dot(at, at));
  pixel = vec4(mix(ink.rgb, vec3(1.0), 0.35), ink.a * near * near);
}
)";

}  // namespace elsie::render
