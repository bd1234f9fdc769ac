// A robot that pulls segments, and what tests measure of it.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/world/parts.h"

#include "physics_context.h"

namespace elsie::physics {

struct Train {
  PhysicsContext& context;
  std::size_t robot;
  std::vector<world::Segment> segments;
  std::vector<world::Coupling> joints = world::couplings(world::plan_of({}, {}), segments);

  SegmentState segment(std::size_t i) const { return context.engine->segment(robot, i); }
  void drive(double left, double right) { context.drive(robot, {left, right}); }

  /// The largest distance between a segment's joint and where the body in front holds it.
  double widest_gap() const {
    double widest = 0.0;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const Frame front = i == 0 ? context.engine->robot(robot).frame : segment(i - 1).frame;
      const Vector3 held = front.point({-joints[i].behind, 0.0, joints[i].height});
      const Vector3 apart = segment(i).frame.point({joints[i].ahead, 0.0, joints[i].height}) - held;
      widest = std::max(widest, std::sqrt(dot(apart, apart)));
    }
    return widest;
  }
};

inline Train train(PhysicsContext& context, const std::vector<world::Segment>& segments,
                   double x = 0.0, double y = 0.0, double heading_deg = 0.0) {
  return {context, context.train(x, y, heading_deg, segments), segments};
}

/// After a while with these rates: each axle runs at the radius of the closed form (test_segments).
inline void check_circle(const Train& train, const WheelRates& rates, double margin) {
  const world::RobotBody body;
  const double radius = body.half_axle() * (rates.right + rates.left) / (rates.right - rates.left);
  const Vector2 center = point_of(train.context.pose(train.robot), {0.0, radius});
  double squared = radius * radius;
  for (std::size_t i = 0; i < train.segments.size(); ++i) {
    const world::Coupling& joint = train.joints[i];
    squared += joint.behind * joint.behind - joint.ahead * joint.ahead;
    const Pose axle = train.segment(i).pose;
    CAPTURE(i);
    CHECK(std::hypot(axle.x - center.x, axle.y - center.y) ==
          Approx(std::sqrt(squared)).margin(margin));
  }
}

/// Kinetic energy as positions tell it, and potential energy, of a train in motion.
class Energy {
 public:
  explicit Energy(const Train& train) : train_(train), last_(frames()) {}

  double now() {
    const std::vector<Frame> frames = this->frames();
    const double h = train_.context.physics.step;
    double energy = 0.0;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const Vector3 middle{0.0, 0.0, 0.05};
      const Vector3 now = frames[i].point(middle), moved = now - last_[i].point(middle);
      const Vector3 a = frames[i].forward - last_[i].forward, b = frames[i].up - last_[i].up;
      const double mass = i == 0 ? 0.2 : train_.segments[i - 1].mass;
      const double inertia = mass * 0.02 * 0.02;
      energy += 0.5 * (mass * dot(moved, moved) + inertia * (dot(a, a) + dot(b, b))) / (h * h) +
                mass * 9.81 * now.z;
    }
    last_ = frames;
    return energy;
  }

 private:
  std::vector<Frame> frames() const {
    std::vector<Frame> frames{train_.context.engine->robot(train_.robot).frame};
    for (std::size_t i = 0; i < train_.segments.size(); ++i) {
      frames.push_back(train_.segment(i).frame);
    }
    return frames;
  }

  const Train& train_;
  std::vector<Frame> last_;
};

}  // namespace elsie::physics
