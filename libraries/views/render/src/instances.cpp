#include "instances.h"

#include <algorithm>
#include <cmath>

#include "elsie/render/renderer.h"

namespace elsie::render {
namespace {

// The direction of the light: between the axes, so that neighbouring faces of an upright box
// differ.
const Vector3 kLight = [] {
  const Vector3 direction{0.3, 0.5, 0.81};
  return (1.0 / std::sqrt(dot(direction, direction))) * direction;
}();

// Half the edge of the drawn floor. Beyond it, the floor is less than a pixel high.
constexpr double kFloorReach = 1000.0;  // m

/// A mesh in the world: its origin, and its axes with their lengths.
struct Body {
  Vector3 origin, x, y, z;
};

class Eye {
 public:
  Eye(const View& view, const Atlas& atlas, const Tile& tile)
      : frame_(view.frame),
        across_(1.0 / std::tan(0.5 * view.camera.horizontal_fov_rad)),
        down_(across_ * view.camera.width / view.camera.height),
        across_slack_(std::hypot(1.0, across_)),
        down_slack_(std::hypot(1.0, down_)),
        place_{static_cast<float>(tile.width) / static_cast<float>(atlas.width),
               static_cast<float>(tile.height) / static_cast<float>(atlas.height),
               static_cast<float>(2 * tile.x + tile.width) / static_cast<float>(atlas.width) - 1.0F,
               static_cast<float>(2 * tile.y + tile.height) / static_cast<float>(atlas.height) -
                   1.0F} {}

  /// True if part of a ball may be in the picture.
  bool may_see(const Vector3& middle, double radius) const {
    const Vector3 d = middle - frame_.origin;
    const double w = dot(frame_.forward, d);
    return w + radius >= kNearest &&
           std::abs(across_ * dot(frame_.left, d)) <= w + across_slack_ * radius &&
           std::abs(down_ * dot(frame_.up, d)) <= w + down_slack_ * radius;
  }

  Instance instance(const Body& body, const Vector3& light, const Colour& colour) const {
    Instance made{};
    fill(made.x, (-across_) * frame_.left, body);
    fill(made.y, (-down_) * frame_.up, body);
    fill(made.w, frame_.forward, body);
    std::copy(std::begin(place_), std::end(place_), made.place);
    made.light[0] = static_cast<float>(light.x);
    made.light[1] = static_cast<float>(light.y);
    made.light[2] = static_cast<float>(light.z);
    made.colour[0] = colour.red;
    made.colour[1] = colour.green;
    made.colour[2] = colour.blue;
    made.colour[3] = 255;
    return made;
  }

  const Vector3& origin() const { return frame_.origin; }

 private:
  void fill(float row[4], const Vector3& direction, const Body& body) const {
    row[0] = static_cast<float>(dot(direction, body.x));
    row[1] = static_cast<float>(dot(direction, body.y));
    row[2] = static_cast<float>(dot(direction, body.z));
    row[3] = static_cast<float>(dot(direction, body.origin - frame_.origin));
  }

  Frame frame_;
  double across_, down_;  // 1 / tan of half the field of view, in width and height
  double across_slack_, down_slack_;
  float place_[4];
};

Vector3 light_in(const Frame& frame) {
  return {dot(kLight, frame.forward), dot(kLight, frame.left), dot(kLight, frame.up)};
}

// Things flat on the floor are in full light.
constexpr Vector3 kFullLight{0.0, 0.0, 1.0};

/// The wedges between the axis of a prism and its sides.
void add_wedges(const Prism& prism, const Eye& eye, std::vector<Instance>& wedges) {
  const Frame& frame = prism.frame;
  const Vector3 light = light_in(frame);
  for (std::size_t i = 0; i < prism.outline.size(); ++i) {
    const Vector2 &from = prism.outline[i], &to = prism.outline[(i + 1) % prism.outline.size()];
    const Vector2 side{to.x - from.x, to.y - from.y};
    const double length = std::hypot(side.x, side.y);
    const double outwards = (side.y * light.x - side.x * light.y) / length;
    wedges.push_back(eye.instance(
        {frame.origin, frame.direction({0.5 * (from.x + to.x), 0.5 * (from.y + to.y), 0.0}),
         frame.direction({side.x, side.y, 0.0}), prism.height * frame.up},
        {outwards, 0.0, light.z}, prism.colour));
  }
}

/// The triangles between the middle of a patch and its sides.
void add_triangles(const FlatPatch& patch, const Eye& eye, std::vector<Instance>& triangles) {
  const auto corners = static_cast<double>(patch.outline.size());
  Vector3 middle;
  for (const Vector2& corner : patch.outline) {
    middle = middle + (1.0 / corners) * Vector3{corner.x, corner.y, 0.0};
  }
  double radius = 0.0;
  for (const Vector2& corner : patch.outline) {
    radius = std::max(radius, std::hypot(corner.x - middle.x, corner.y - middle.y));
  }
  if (!eye.may_see(middle, radius)) return;
  for (std::size_t i = 0; i < patch.outline.size(); ++i) {
    const Vector2 &from = patch.outline[i], &to = patch.outline[(i + 1) % patch.outline.size()];
    const Vector3 side_middle{0.5 * (from.x + to.x), 0.5 * (from.y + to.y), 0.0};
    triangles.push_back(eye.instance(
        {middle, side_middle - middle, {to.x - from.x, to.y - from.y, 0.0}, {0.0, 0.0, 1.0}},
        kFullLight, patch.colour));
  }
}

}  // namespace

void add_view(const Scene& scene, const View& view, const Atlas& atlas, const Tile& tile,
              DrawList& list) {
  const Eye eye(view, atlas, tile);
  const auto is_visible = [&](const auto& solid, const Vector3& middle, double radius) {
    return solid.visible && (solid.carrier != view.carrier || view.carrier == kNobody) &&
           eye.may_see(middle, radius);
  };
  const auto add_flat = [&](MeshKind mesh, double x, double y, double reach, const Colour& colour) {
    list[mesh].push_back(eye.instance(
        {{x, y, 0.0}, {reach, 0.0, 0.0}, {0.0, reach, 0.0}, {0.0, 0.0, 1.0}}, kFullLight, colour));
  };
  add_flat(kSquare, eye.origin().x, eye.origin().y, kFloorReach, scene.floor);
  if (scene.image.pixels) {
    const Vector2 half{0.5 * scene.image.size.x, 0.5 * scene.image.size.y};
    if (eye.may_see({}, std::hypot(half.x, half.y))) {
      list[kImage].push_back(eye.instance(
          {{}, {half.x, 0.0, 0.0}, {0.0, half.y, 0.0}, {0.0, 0.0, 1.0}}, kFullLight, scene.floor));
    }
  }
  for (const FlatPatch& patch : scene.patches) add_triangles(patch, eye, list[kTriangle]);
  for (const Mark& mark : scene.marks) {
    if (eye.may_see({mark.at.x, mark.at.y, 0.0}, mark.radius)) {
      add_flat(kDisc, mark.at.x, mark.at.y, mark.radius, mark.colour);
    }
  }
  for (const Box& box : scene.boxes) {
    const auto& [origin, forward, left, upwards] = box.frame;
    const Vector3 up = box.size.z * upwards;
    if (is_visible(box, origin + 0.5 * up, 0.5 * std::sqrt(dot(box.size, box.size)))) {
      list[kBox].push_back(eye.instance({origin, box.size.x * forward, box.size.y * left, up},
                                        light_in(box.frame), box.colour));
    }
  }
  for (const Prism& prism : scene.prisms) {
    double radius = 0.0;
    for (const Vector2& corner : prism.outline) {
      radius = std::max(radius, std::hypot(corner.x, corner.y));
    }
    const double up = 0.5 * prism.height;
    if (is_visible(prism, prism.frame.point({0.0, 0.0, up}), std::hypot(radius, up))) {
      add_wedges(prism, eye, list[kWedge]);
    }
  }
  for (const Cylinder& cylinder : scene.cylinders) {
    const auto& [origin, forward, left, up] = cylinder.frame;
    const double r = cylinder.radius;
    if (is_visible(cylinder, origin, std::hypot(r, 0.5 * cylinder.length))) {
      list[kCylinder].push_back(eye.instance({origin, r * forward, cylinder.length * left, r * up},
                                             light_in(cylinder.frame), cylinder.colour));
    }
  }
  for (const Ball& ball : scene.balls) {
    const double r = ball.radius;
    if (is_visible(ball, ball.middle, r)) {
      list[kBall].push_back(eye.instance({ball.middle, {r, 0.0, 0.0}, {0.0, r, 0.0}, {0.0, 0.0, r}},
                                         kLight, ball.colour));
    }
  }
}

}  // namespace elsie::render
