#include "shown.h"

#include <algorithm>
#include <cmath>

#include "bodies.h"
#include "lights.h"

namespace elsie::render {
namespace {

constexpr double kFarFloor = 1000.0;  // m; a floor beyond it is less than a pixel high

constexpr double kBevel = 0.006;  // m

void put(const Vector3& from, float to[3]) {
  to[0] = single(from.x);
  to[1] = single(from.y);
  to[2] = single(from.z);
}

void put(const Colour& from, double opacity, std::uint8_t to[4]) {
  to[0] = from.red;
  to[1] = from.green;
  to[2] = from.blue;
  to[3] = static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(opacity, 0.0, 1.0)));
}

ShownBody shown(const Body& body, const Surface& surface, const Vector3& eye,
                double most_bevel = kBevel) {
  ShownBody made{};
  const Vector3 origin = body.origin - eye;
  const auto fill = [](float row[4], double x, double y, double z, double w) {
    row[0] = single(x);
    row[1] = single(y);
    row[2] = single(z);
    row[3] = single(w);
  };
  fill(made.x, body.x.x, body.y.x, body.z.x, origin.x);
  fill(made.y, body.x.y, body.y.y, body.z.y, origin.y);
  fill(made.z, body.x.z, body.y.z, body.z.z, origin.z);
  put(surface.colour, 0.0, made.colour);
  const double edges[] = {std::sqrt(dot(body.x, body.x)), std::sqrt(dot(body.y, body.y)),
                          std::sqrt(dot(body.z, body.z))};
  const double bevel = std::min({most_bevel, edges[0] / 8.0, edges[1] / 8.0, edges[2] / 8.0});
  for (int i = 0; i < 3; ++i) made.bevel[i] = edges[i] > 0.0 ? single(bevel / edges[i]) : 0.0F;
  return made;
}

/// Adds the contacts of what is upright and near to the floor.
class Contacts {
 public:
  Contacts(const Vector3& eye, std::vector<ShownContact>& list) : eye_(eye), list_(list) {}

  void add(const Frame& bottom, const Vector2& half, double rounding, double height) {
    constexpr double kNear = 0.1, kUpright = 0.95;  // m, and the cosine of a tilt
    const double above = std::max(0.0, bottom.origin.z);
    if (above > kNear || bottom.up.z < kUpright) return;
    const double across = std::hypot(bottom.forward.x, bottom.forward.y);
    list_.push_back({{single(bottom.origin.x - eye_.x), single(bottom.origin.y - eye_.y)},
                     {single(bottom.forward.x / across), single(bottom.forward.y / across)},
                     {single(half.x), single(half.y)},
                     single(rounding),
                     single(std::clamp(0.5 * height, 0.01, 0.3) + above),
                     single(0.42 * (1.0 - above / kNear))});
  }

 private:
  const Vector3& eye_;
  std::vector<ShownContact>& list_;
};

/// Whether a wall is on a side of the arena beyond which the camera is: it hides what is in there.
bool is_in_front(const Vector3& wall, const Vector3& eye, const Style& style) {
  const auto is_beyond = [](double wall_at, double eye_at, double half) {
    return half > 0.0 && std::abs(wall_at) >= 0.99 * half && std::abs(eye_at) > half &&
           (wall_at > 0.0) == (eye_at > 0.0);
  };
  return is_beyond(wall.x, eye.x, 0.5 * style.arena.x) ||
         is_beyond(wall.y, eye.y, 0.5 * style.arena.y);
}

void list_contacts(const Scene& scene, const View& view, const Style& style, Contacts contacts) {
  const std::size_t carrier = view.carrier;
  const auto is_there = [&](const auto& solid) {
    return solid.visible && (solid.carrier != carrier || carrier == kNobody);
  };
  for (const Box& box : scene.boxes) {
    const bool is_glass =
        box.material == Material::wall && is_in_front(box.frame.origin, view.frame.origin, style);
    if (is_there(box) && !is_glass) {
      contacts.add(box.frame, {0.5 * box.size.x, 0.5 * box.size.y}, 0.0, box.size.z);
    }
  }
  for (const Prism& prism : scene.prisms) {
    if (!is_there(prism)) continue;
    double radius = 0.0;
    for (const Vector2& corner : prism.outline) {
      radius = std::max(radius, std::hypot(corner.x, corner.y));
    }
    contacts.add(prism.frame, {radius, radius}, radius, prism.height);
  }
  for (const Cylinder& cylinder : scene.cylinders) {
    if (!is_there(cylinder)) continue;
    const auto& [origin, forward, left, up] = cylinder.frame;
    const double r = cylinder.radius;
    if (std::abs(left.z) > 0.9) {  // upright
      const double half = 0.5 * cylinder.length;
      contacts.add({{origin.x, origin.y, origin.z - half}, forward, up, {0.0, 0.0, 1.0}}, {r, r}, r,
                   cylinder.length);
    } else {
      contacts.add({{origin.x, origin.y, origin.z - r}, {-left.y, left.x, 0.0}, left, {0, 0, 1}},
                   {0.3 * r, 0.5 * cylinder.length}, 0.0, r);
    }
  }
  for (const Ball& ball : scene.balls) {
    if (is_there(ball) && ball.material != Material::glowing) {
      const double r = 0.4 * ball.radius;
      contacts.add({{ball.middle.x, ball.middle.y, ball.middle.z - ball.radius}}, {r, r}, r,
                   2.0 * ball.radius);
    }
  }
}

void list_strokes(const std::vector<Stroke>& strokes, const Vector3& eye,
                  std::vector<ShownStroke>& list) {
  list.reserve(strokes.size());
  for (const Stroke& stroke : strokes) {
    ShownStroke made{};
    put(stroke.from - eye, made.from);
    put(stroke.to - eye, made.to);
    put(stroke.colour, stroke.opacity, made.colour);
    made.width = single(stroke.width);
    made.dash = single(stroke.dash);
    list.push_back(made);
  }
}

ShownGlow glow(const Vector3& middle, double radius, const Colour& colour, double opacity) {
  ShownGlow made{};
  put(middle, made.middle);
  made.radius = single(radius);
  put(colour, opacity, made.colour);
  return made;
}

/// The arena, and the floor around it and beyond that in parts which do not overlap: filling pixels
/// is what costs most without a graphics card.
void list_floor(const Colour& colour, const Style& style, const Vector3& eye, ShownList& list) {
  const double x = 0.5 * style.arena.x, y = 0.5 * style.arena.y;
  const auto rectangle = [&](double west, double east, double south, double north) {
    return shown({{0.5 * (west + east), 0.5 * (south + north), 0.0},
                  {0.5 * (east - west), 0.0, 0.0},
                  {0.0, 0.5 * (north - south), 0.0},
                  {0.0, 0.0, 1.0}},
                 {colour}, eye);
  };
  const auto frame = [&](double x_in, double y_in, double x_out, double y_out) {
    return std::vector<ShownBody>{
        rectangle(-x_out, x_out, y_in, y_out), rectangle(-x_out, x_out, -y_out, -y_in),
        rectangle(x_in, x_out, -y_in, y_in), rectangle(-x_out, -x_in, -y_in, y_in)};
  };
  list.flat[kSquare].insert(list.flat[kSquare].begin(), rectangle(-x, x, -y, y));
  const double far = kFarFloor + std::max({x, y, std::abs(eye.x), std::abs(eye.y)});
  const double reach = std::min(far, kLongestShadow * list.tallest);
  list.around = frame(x, y, x + reach, y + reach);
  list.beyond = frame(x + reach, y + reach, x + far, y + far);
}

/// White light would not be seen on a bright floor.
Colour warm(const Colour& light) {
  constexpr Colour kCandle{255, 214, 120};
  const int least = std::min({light.red, light.green, light.blue});
  const auto mixed = [&](std::uint8_t own, std::uint8_t candle) {
    return static_cast<std::uint8_t>((own * (255 - least) + candle * least) / 255);
  };
  return {mixed(light.red, kCandle.red), mixed(light.green, kCandle.green),
          mixed(light.blue, kCandle.blue)};
}

}  // namespace

ShownList list_shown(const Scene& scene, const View& view, const Style& style) {
  ShownList list;
  const Vector3& eye = view.frame.origin;
  constexpr std::size_t kManyBoxes = 3000;
  list.is_bevelled = scene.boxes.size() < kManyBoxes;
  const double bevel = list.is_bevelled ? kBevel : 0.0;
  visit_bodies(
      scene, view.carrier,
      // What is out of sight may throw a shadow into it.
      [](const Vector3&, double) { return true; },
      [&](MeshKind mesh, const Body& body, const Vector3&, const Surface& surface) {
        list.tallest = std::max(list.tallest, body.origin.z + std::abs(body.x.z) +
                                                  std::abs(body.y.z) + std::abs(body.z.z));
        if (mesh == kBox && surface.material == Material::wall &&
            is_in_front(body.origin, eye, style)) {
          list.near_walls.push_back(shown(body, surface, eye, bevel));
          return;
        }
        auto& bodies =
            mesh < kBox ? list.flat[mesh] : list.solids[index_of(surface.material)][mesh];
        bodies.push_back(shown(body, surface, eye, bevel));
      });
  list_floor(scene.floor, style, eye, list);
  list_contacts(scene, view, style, {eye, list.contacts});
  list_strokes(scene.drawing, eye, list.drawing);
  list_strokes(scene.strokes, eye, list.strokes);
  for (const Glow& each : scene.glows) {
    list.halos.push_back(glow(each.at - eye, each.halo, each.colour, 0.9));
    if (each.pool > 0.0) {
      list.pools.push_back(
          glow(Vector3{each.at.x, each.at.y, 0.0} - eye, each.pool, warm(each.colour), 0.6));
    }
  }
  return list;
}

}  // namespace elsie::render
