// A scene as plain data: boxes, prisms, cylinders, balls, and a floor with marks; and what pictures
// for people show besides.
//
// Lengths are in m, frames in the world. Colours are those in full light; faces turned away from it
// are darker, down to kDarkestShade, with the same hue and saturation.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/api/image.h"
#include "elsie/shapes/shape.h"

namespace elsie::render {

/// The carrier of things without a carrier, and of cameras that nobody carries.
inline constexpr std::size_t kNobody = static_cast<std::size_t>(-1);

/// What a surface is made of in pictures for people. Cameras see its colour only.
enum class Material : std::uint8_t {
  plain,
  wall,     // panels, with a darker foot
  wheel,    // a tyre with spokes, so that its turning is seen
  glowing,  // without shade
};

/// The brightness of the darkest face of a surface, relative to its colour in full light.
inline constexpr double kDarkestShade = 0.6;

struct Box {
  Frame frame;   // origin in the middle of its bottom
  Vector3 size;  // along forward, left and up
  Colour colour;
  std::size_t carrier = kNobody;  // its cameras do not see the box
  bool visible = true;
  Material material = Material::plain;
};

/// A prism over a convex outline, around the up axis of its frame.
struct Prism {
  Frame frame;                   // origin in the middle of its bottom
  std::vector<Vector2> outline;  // corners, counter-clockwise; the origin is inside
  double height = 0.0;
  Colour colour;
  std::size_t carrier = kNobody;
  bool visible = true;
  Material material = Material::plain;
};

/// A cylinder about the left axis of its frame, whose origin is in its middle.
struct Cylinder {
  Frame frame;
  double radius = 0.0;
  double length = 0.0;
  Colour colour;
  std::size_t carrier = kNobody;
  bool visible = true;
  Material material = Material::plain;
};

struct Ball {
  Vector3 middle;
  double radius = 0.0;
  Colour colour;
  std::size_t carrier = kNobody;
  bool visible = true;
  Material material = Material::plain;
};

/// A disc on the floor; later marks cover earlier ones.
struct Mark {
  Vector2 at;
  double radius = 0.0;
  Colour colour;
};

/// A picture on the floor, north at its top, below all patches.
struct FloorImage {
  Vector2 size;                         // m, around the origin
  std::shared_ptr<const Image> pixels;  // red, green, blue; null: none
};

/// A convex polygon on the floor, below all marks; later patches cover earlier ones.
struct FlatPatch {
  std::vector<Vector2> outline;  // counter-clockwise
  Colour colour;
};

/// A line that only people see.
struct Stroke {
  Vector3 from, to;
  Colour colour;
  double opacity = 1.0;
  double width = 1.0;  // px
  double dash = 0.0;   // px, of each dash and gap; 0: no gaps
};

/// A light that only people see as such: a halo, and a pool of light on the floor below it.
struct Glow {
  Vector3 at;
  double halo = 0.0;  // m, radius
  double pool = 0.0;  // m, radius; 0: none
  Colour colour;
};

struct Scene {
  Colour floor{80, 80, 80};  // unlimited, at z = 0; invisible from below
  FloorImage image;
  std::vector<FlatPatch> patches;
  Colour sky{140, 140, 140};  // everywhere else
  std::vector<Box> boxes;
  std::vector<Prism> prisms;
  std::vector<Cylinder> cylinders;
  std::vector<Ball> balls;
  std::vector<Mark> marks;
  std::vector<Stroke> drawing;  // on the floor, below all that stands there; fades in the distance
  std::vector<Stroke> strokes;  // in space; what is behind something is fainter
  std::vector<Glow> glows;
};

/// The place of a shape's piece in one of a scene's lists, and the frame of its middle in its body.
struct Placed {
  Shape::Kind kind;
  std::size_t index = 0;
  Frame frame;
};

/// Adds the pieces of a shape, whose middle has this frame in its body, with the body at the
/// origin.
std::vector<Placed> add(Scene& scene, const Shape& shape, const Frame& middle, const Colour& colour,
                        std::size_t carrier = kNobody, Material material = Material::plain);
/// Moves a body. None: it becomes invisible.
void put(Scene& scene, const std::vector<Placed>& body, const std::optional<Frame>& frame);

/// A camera with its pose.
struct View {
  Frame frame;  // looks along forward; up is the top of the picture
  Camera camera;
  std::size_t carrier = kNobody;  // its things are not in the picture
};

}  // namespace elsie::render
