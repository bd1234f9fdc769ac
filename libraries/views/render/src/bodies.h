// Walks a scene: which mesh stands where.
#pragma once

#include <algorithm>
#include <cmath>

#include "elsie/render/scene.h"

#include "meshes.h"

namespace elsie::render {

/// A mesh in the world: its origin, and its axes with their lengths.
struct Body {
  Vector3 origin, x, y, z;
};

/// The surface of a body.
struct Surface {
  Colour colour;
  Material material = Material::plain;
};

/// The direction to the light of cameras: between the axes, so that neighbouring faces of an
/// upright box differ.
inline const Vector3 kLight = [] {
  const Vector3 direction{0.3, 0.5, 0.81};
  return (1.0 / std::sqrt(dot(direction, direction))) * direction;
}();

inline Vector3 light_in(const Frame& frame) {
  return {dot(kLight, frame.forward), dot(kLight, frame.left), dot(kLight, frame.up)};
}

// Things flat on the floor are in full light.
inline constexpr Vector3 kFullLight{0.0, 0.0, 1.0};

/// The wedges between the axis of a prism and its sides.
template <class Emit>
void visit_wedges(const Prism& prism, const Emit& emit) {
  const Frame& frame = prism.frame;
  const Vector3 light = light_in(frame);
  for (std::size_t i = 0; i < prism.outline.size(); ++i) {
    const Vector2 &from = prism.outline[i], &to = prism.outline[(i + 1) % prism.outline.size()];
    const Vector2 side{to.x - from.x, to.y - from.y};
    const double length = std::hypot(side.x, side.y);
    const double outwards = (side.y * light.x - side.x * light.y) / length;
    emit(kWedge,
         Body{frame.origin, frame.direction({0.5 * (from.x + to.x), 0.5 * (from.y + to.y), 0.0}),
              frame.direction({side.x, side.y, 0.0}), prism.height * frame.up},
         Vector3{outwards, 0.0, light.z}, Surface{prism.colour, prism.material});
  }
}

/// The triangles between the middle of a patch and its sides.
template <class Sees, class Emit>
void visit_triangles(const FlatPatch& patch, const Sees& may_see, const Emit& emit) {
  const auto corners = static_cast<double>(patch.outline.size());
  Vector3 middle;
  for (const Vector2& corner : patch.outline) {
    middle = middle + (1.0 / corners) * Vector3{corner.x, corner.y, 0.0};
  }
  double radius = 0.0;
  for (const Vector2& corner : patch.outline) {
    radius = std::max(radius, std::hypot(corner.x - middle.x, corner.y - middle.y));
  }
  if (!may_see(middle, radius)) return;
  for (std::size_t i = 0; i < patch.outline.size(); ++i) {
    const Vector2 &from = patch.outline[i], &to = patch.outline[(i + 1) % patch.outline.size()];
    const Vector3 side_middle{0.5 * (from.x + to.x), 0.5 * (from.y + to.y), 0.0};
    emit(kTriangle,
         Body{middle, side_middle - middle, {to.x - from.x, to.y - from.y, 0.0}, {0.0, 0.0, 1.0}},
         kFullLight, Surface{patch.colour});
  }
}

/// Calls `emit(mesh, body, light, surface)` for the meshes that a camera carried by `carrier` may
/// see, in the order in which they are drawn within each mesh. `may_see(middle, radius)`: whether a
/// ball may be in the picture. `light`: the direction to the light of cameras in the mesh's axes.
/// The floor itself is not among them.
template <class Sees, class Emit>
void visit_bodies(const Scene& scene, std::size_t carrier, const Sees& may_see, const Emit& emit) {
  const auto is_visible = [&](const auto& solid, const Vector3& middle, double radius) {
    return solid.visible && (solid.carrier != carrier || carrier == kNobody) &&
           may_see(middle, radius);
  };
  if (scene.image.pixels) {
    const Vector2 half{0.5 * scene.image.size.x, 0.5 * scene.image.size.y};
    if (may_see(Vector3{}, std::hypot(half.x, half.y))) {
      emit(kImage, Body{{}, {half.x, 0.0, 0.0}, {0.0, half.y, 0.0}, {0.0, 0.0, 1.0}}, kFullLight,
           Surface{scene.floor});
    }
  }
  for (const FlatPatch& patch : scene.patches) visit_triangles(patch, may_see, emit);
  for (const Mark& mark : scene.marks) {
    if (may_see(Vector3{mark.at.x, mark.at.y, 0.0}, mark.radius)) {
      emit(kDisc,
           Body{{mark.at.x, mark.at.y, 0.0},
                {mark.radius, 0.0, 0.0},
                {0.0, mark.radius, 0.0},
                {0.0, 0.0, 1.0}},
           kFullLight, Surface{mark.colour});
    }
  }
  for (const Box& box : scene.boxes) {
    const auto& [origin, forward, left, upwards] = box.frame;
    const Vector3 up = box.size.z * upwards;
    if (is_visible(box, origin + 0.5 * up, 0.5 * std::sqrt(dot(box.size, box.size)))) {
      emit(kBox, Body{origin, box.size.x * forward, box.size.y * left, up}, light_in(box.frame),
           Surface{box.colour, box.material});
    }
  }
  for (const Prism& prism : scene.prisms) {
    double radius = 0.0;
    for (const Vector2& corner : prism.outline) {
      radius = std::max(radius, std::hypot(corner.x, corner.y));
    }
    const double up = 0.5 * prism.height;
    if (is_visible(prism, prism.frame.point({0.0, 0.0, up}), std::hypot(radius, up))) {
      visit_wedges(prism, emit);
    }
  }
  for (const Cylinder& cylinder : scene.cylinders) {
    const auto& [origin, forward, left, up] = cylinder.frame;
    const double r = cylinder.radius;
    if (is_visible(cylinder, origin, std::hypot(r, 0.5 * cylinder.length))) {
      emit(kCylinder, Body{origin, r * forward, cylinder.length * left, r * up},
           light_in(cylinder.frame), Surface{cylinder.colour, cylinder.material});
    }
  }
  for (const Ball& ball : scene.balls) {
    const double r = ball.radius;
    if (is_visible(ball, ball.middle, r)) {
      emit(kBall, Body{ball.middle, {r, 0.0, 0.0}, {0.0, r, 0.0}, {0.0, 0.0, r}}, kLight,
           Surface{ball.colour, ball.material});
    }
  }
}

}  // namespace elsie::render
