#include "planar_vehicle.h"

#include <algorithm>
#include <cmath>

namespace elsie::physics {
namespace {

constexpr double kFlush = 1e-9;  // m: a wheel that is flush with the side of the chassis is inside

// This part of the weight makes the loads of wheels in one row definite.
constexpr double kRegular = 1e-9;

Direction heading_of(const Part& part) {
  return Direction{part.frame.forward.x, part.frame.forward.y};
}

bool is_within(const Part& part, const Part& chassis) {
  if (const auto* wheel = std::get_if<WheelJoint>(&part.joint); wheel && wheel->steered) {
    return false;
  }
  const Vector3 &at = part.frame.origin, &middle = chassis.frame.origin;
  const Direction ahead = heading_of(part);
  const double c = std::abs(ahead.c), s = std::abs(ahead.s);
  const double x =
      std::abs(at.x - middle.x) + 0.5 * (c * part.shape.size.x + s * part.shape.size.y);
  const double y =
      std::abs(at.y - middle.y) + 0.5 * (s * part.shape.size.x + c * part.shape.size.y);
  const Shape& shape = chassis.shape;
  if (at.z + 0.5 * part.shape.size.z > middle.z + 0.5 * shape.size.z + kFlush) return false;
  if (shape.is_round()) return std::hypot(x, y) <= shape.radius() + kFlush;
  return shape.kind == Shape::Kind::box && x <= 0.5 * shape.size.x + kFlush &&
         y <= 0.5 * shape.size.y + kFlush;
}

}  // namespace

std::vector<Solid> solids_of(std::span<const Part> vehicle) {
  std::vector<Solid> solids;
  for (const Part& part : vehicle) {
    Solid solid{Outline::of(part.shape, part.frame.origin.z),
                {part.frame.origin.x, part.frame.origin.y},
                heading_of(part)};
    solid.is_wheel = std::holds_alternative<WheelJoint>(part.joint);
    solid.below = &part != &vehicle.front() && is_within(part, vehicle.front());
    solids.push_back(std::move(solid));
  }
  return solids;
}

Inertia inertia_of(std::span<const Part> vehicle) {
  Inertia all;
  Vector2 moment;
  for (const Part& part : vehicle) {
    all.mass += part.mass;
    moment.x += part.mass * part.frame.origin.x;
    moment.y += part.mass * part.frame.origin.y;
  }
  all.center = {moment.x / all.mass, moment.y / all.mass};
  for (const Part& part : vehicle) {
    const double dx = part.frame.origin.x - all.center.x, dy = part.frame.origin.y - all.center.y;
    all.about_center += upright_inertia_of(part.shape, part.mass) + part.mass * (dx * dx + dy * dy);
  }
  return all;
}

std::vector<double> loads_of(std::span<const Part> vehicle, const Inertia& inertia,
                             double gravity) {
  struct Support {
    Twist lever;  // 1, and its place
    std::size_t part;
  };
  std::vector<Support> supports;
  const auto support = [&](double x, double y, std::size_t part) {
    supports.push_back({{1.0, x - inertia.center.x, y - inertia.center.y}, part});
  };
  constexpr std::size_t kHitch = static_cast<std::size_t>(-1);
  for (std::size_t i = 0; i < vehicle.size(); ++i) {
    const Part& part = vehicle[i];
    if (std::holds_alternative<WheelJoint>(part.joint) ||
        std::holds_alternative<CasterJoint>(part.joint)) {
      support(part.frame.origin.x, part.frame.origin.y, i);
    } else if (const auto* hitch = std::get_if<HitchJoint>(&part.joint)) {
      support(hitch->ahead, 0.0, kHitch);
    }
  }
  std::vector<double> loads(vehicle.size(), 0.0);
  const double weight = inertia.mass * std::abs(gravity);
  while (!supports.empty()) {
    Symmetric moments;
    for (const Support& each : supports) moments.add(1.0, each.lever);
    moments.xx += kRegular * moments.xx;
    moments.yy += kRegular * moments.xx;
    moments.tt += kRegular * moments.xx;
    const Twist sinking = moments.inverse() * Twist{weight, 0.0, 0.0};
    const auto lifted = std::find_if(supports.begin(), supports.end(), [&](const Support& each) {
      return dot(sinking, each.lever) < 0.0;
    });
    if (lifted != supports.end()) {
      supports.erase(lifted);
      continue;
    }
    for (const Support& each : supports) {
      if (each.part != kHitch) loads[each.part] = dot(sinking, each.lever);
    }
    break;
  }
  return loads;
}

double lever_of(const Outline& outline) {
  double sum = 0.0;
  for (const Vector2& corner : outline.corners) {
    sum += std::hypot(corner.x, corner.y) + outline.radius;
  }
  return sum / static_cast<double>(outline.corners.size());
}

Mover mover_of(std::span<const Part> vehicle, const world::Physics& physics) {
  const Inertia inertia = inertia_of(vehicle);
  const bool rolls = std::any_of(vehicle.begin(), vehicle.end(), [](const Part& part) {
    return std::holds_alternative<WheelJoint>(part.joint);
  });
  if (!rolls) {
    const Part& chassis = vehicle.front();
    const Outline outline = Outline::of(chassis.shape, chassis.frame.origin.z);
    const bool is_ball = chassis.shape.kind == Shape::Kind::sphere;  // which rolls
    return {inertia,
            is_ball ? FloorFriction() : FloorFriction(inertia, lever_of(outline), physics)};
  }
  return Mover(
      Undercarriage(vehicle, loads_of(vehicle, inertia, physics.gravity), inertia, physics));
}

}  // namespace elsie::physics
