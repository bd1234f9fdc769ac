// More bodies in touch than ODE's solver takes: the iterative solver.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/world/footprint.h"

#include "physics_context.h"

using namespace elsie;
using namespace elsie::physics;
using world::ObstacleKind;

namespace {

constexpr double kTolerance = 0.001;  // m: how far robots may be pressed into each other

/// Robots in a square, in layers above each other if need be, each of which drives to the middle.
class Crowd : public PhysicsContext {
 public:
  Crowd(int side, int layers, double apart, const world::Arena& in = {})
      : PhysicsContext({}, in), robots_(static_cast<std::size_t>(side * side * layers)) {
    for (int i = 0; i < side * side * layers; ++i) {
      const int column = i % side, row = i / side % side, layer = i / side / side;
      robot(apart * (column - 0.5 * (side - 1)), apart * (row - 0.5 * (side - 1)), 0.0, {},
            0.12 * layer);
    }
  }

  void step() {
    for (std::size_t i = 0; i < robots_; ++i) {
      const double to_the_left = bearing(pose(i), target.x, target.y);
      const double turn = 15.0 * std::clamp(to_the_left, -1.0, 1.0);
      const double ahead = std::abs(to_the_left) < 0.8 ? 15.0 : 0.0;
      drive(i, {ahead - turn, ahead + turn});
    }
    engine->step();
  }

  std::uint64_t hash_after(int steps) {
    for (int i = 0; i < steps; ++i) step();
    return engine->hash_state();
  }

  /// How many pairs of chassis are further in each other than the tolerance.
  int overlaps(double tolerance = kTolerance) const {
    world::RobotBody body;  // without what its wheels stand out
    body.length -= tolerance;
    body.width -= tolerance;
    body.axle = body.width - body.wheel_width;
    std::vector<world::Footprint> footprints;
    for (std::size_t i = 0; i < robots_; ++i) {
      // In the middle of the chassis: some lean by a few degrees.
      const RobotState state = engine->robot(i);
      const Vector3 middle = state.frame.point({0.0, 0.0, 0.05});
      footprints.push_back(world::footprint_of(world::plan_of(body, {}).parts,
                                               {middle.x, middle.y, state.pose.heading_rad},
                                               state.frame.origin.z));
    }
    int found = 0;
    for (std::size_t i = 0; i < robots_; ++i) {
      for (std::size_t j = 0; j < i; ++j) found += overlap(footprints[i], footprints[j]);
    }
    return found;
  }

  double lowest() const {
    double z = 1.0;
    for (std::size_t i = 0; i < robots_; ++i) {
      z = std::min(z, engine->robot(i).frame.origin.z);
    }
    return z;
  }
  std::size_t most_in_touch() const { return engine->touches().size(); }

  Vector2 target;

 private:
  std::size_t robots_;
};

}  // namespace

TEST_CASE("A crowd has the same bits in two runs, also when two take turns") {
  const std::uint64_t alone = Crowd(6, 1, 0.14).hash_after(100);
  CHECK(Crowd(6, 1, 0.14).hash_after(100) == alone);
  Crowd one(6, 1, 0.14), two(5, 2, 0.14);
  for (int i = 0; i < 100; ++i) {
    one.step();
    two.step();
  }
  CHECK(one.engine->hash_state() == alone);
  CHECK(two.engine->hash_state() == Crowd(5, 2, 0.14).hash_after(100));
}

TEST_CASE("Robots that press to one point from all sides stay apart, and on the floor") {
  Crowd crowd(10, 1, 0.15);
  std::size_t touches = 0;
  for (int i = 0; i < 400; ++i) {
    crowd.step();
    touches = std::max(touches, crowd.most_in_touch());
    if (i % 10 == 0) {
      INFO("step " << i);
      REQUIRE(crowd.overlaps() == 0);
    }
  }
  CHECK(touches > 100);  // they did press
  CHECK(crowd.lowest() > -0.001);
}

TEST_CASE("Walls hold a crowd that presses against them") {
  world::Arena arena;
  arena.length = arena.width = 2.0;
  Crowd crowd(7, 1, 0.15, arena);
  crowd.target = {3.0, 0.0};
  double furthest = 0.0;
  for (int i = 0; i < 800; ++i) {
    crowd.step();
    for (std::size_t k = 0; k < 49; ++k) furthest = std::max(furthest, crowd.pose(k).x);
  }
  CHECK(furthest > 0.9);
  CHECK(furthest < 1.0 - 0.04 + kTolerance);
  CHECK(crowd.overlaps() == 0);
}

TEST_CASE("A heap of robots that fall on each other comes to rest on the floor") {
  Crowd heap(3, 4, 0.11);
  for (std::size_t i = 0; i < 36; ++i) heap.drive(i, {0, 0});
  heap.run(3.0);
  double fastest = 0.0;
  for (std::size_t i = 0; i < 36; ++i) {
    fastest = std::max(fastest, std::abs(heap.engine->robot(i).speed));
  }
  CHECK(heap.lowest() > -0.01);
  CHECK(fastest < 0.05);
}

TEST_CASE("A row of boxes that is pushed arrives as a row") {
  PhysicsContext context({}, open_field());
  const std::size_t pusher = context.obstacle(ObstacleKind::moving, 0, 0, {0.2, 0.2, 0.2});
  std::vector<std::size_t> obstacles;
  for (int i = 0; i < 15; ++i) {
    obstacles.push_back(
        context.obstacle(ObstacleKind::dynamic, 0.25 + 0.21 * i, 0, {0.2, 0.2, 0.2}));
  }
  context.drive(pusher, {0.3, 0.0}, 5.0);
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    const Vector3 at = context.engine->obstacle(obstacles[i]).origin;
    INFO("box " << i);
    CHECK(at.x > 1.5 + 0.2 * static_cast<double>(i + 1) - kTolerance * static_cast<double>(i + 1));
    CHECK(at.x < 1.5 + 0.2 * static_cast<double>(i + 1) + 0.1);
    CHECK(std::abs(at.z) < 0.001);
  }
}
