// What rays hit, and rays in batches: against closed forms, and against single rays.
#include <array>
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/base/random.h"
#include "elsie/shapes/obstacle_shapes.h"

#include "conformance.h"

using namespace elsie;
using namespace elsie::physics;
using world::ObstacleKind;

namespace {

/// Rays in a batch, with the frames that they begin at.
struct Batch {
  std::vector<Frame> from;
  std::vector<RayQuery> rays;
  std::vector<Surface> surfaces;

  void add(const Vector3& origin, const Vector3& along, double range = 20.0) {
    from.push_back({origin, along, {}, {}});
    rays.push_back({nullptr, range});
    surfaces.emplace_back();
  }
  void cast(const Engine& engine, const Frame& within = {}, std::size_t except = kNobody) {
    for (std::size_t i = 0; i < rays.size(); ++i) rays[i].from = &from[i];
    engine.cast_rays(within, rays, surfaces, except);
  }
};

Surface surface(const PhysicsContext& context, const Vector3& from, const Vector3& along) {
  Batch batch;
  batch.add(from, along);
  batch.cast(*context.engine);
  return batch.surfaces.front();
}

void check_near(const Vector3& found, const Vector3& expected) {
  CHECK(found.x == Approx(expected.x).margin(1e-9));
  CHECK(found.y == Approx(expected.y).margin(1e-9));
  CHECK(found.z == Approx(expected.z).margin(1e-9));
}

void check(const Surface& found, Surface::Kind kind, std::size_t index, const Vector3& normal) {
  CHECK(found.kind == kind);
  CHECK(found.index == index);
  check_near(found.normal, normal);
}

world::Obstacle of_shape(ObstacleShape shape, double x, double y) {
  world::Obstacle made;
  made.kind = ObstacleKind::fixed;
  made.shape = shape;
  made.x = x;
  made.y = y;
  return made;
}

/// A crowded arena with bodies of all shapes.
struct Crowd : PhysicsContext {
  Crowd(const std::string& engine_name, std::uint64_t seed)
      : PhysicsContext(with(engine_name), {.length = 8.0, .width = 6.0}), random(seed) {
    for (int i = 0; i < 30; ++i) {
      const std::array shapes{ObstacleShape::box, ObstacleShape::cylinder, ObstacleShape::prism};
      world::Obstacle made = of_shape(shapes[static_cast<std::size_t>(i) % 3], x(), y());
      made.radius = random.uniform(0.05, 0.3);
      made.points = {{-0.1, -0.1}, {0.3, -0.1}, {0.2, 0.2}, {-0.1, 0.3}};
      made.length = random.uniform(0.05, 1.0);
      made.height = random.uniform(0.05, 0.4);
      made.z = random.chance(0.3) ? random.uniform(0.0, 0.2) : 0.0;
      made.heading_deg = random.uniform(-180, 180);
      engine->add_obstacle(made);
    }
    for (int i = 0; i < 6; ++i) robot(x(), y(), random.uniform(-180, 180));
    for (int i = 0; i < 6; ++i) robot(x(), y(), random.uniform(-180, 180), round_body());
    for (const Shape& shape :
         {Shape::sphere(0.1), Shape::capsule(0.05, 0.3, Shape::Axis::left),
          Shape::capsule(0.05, 0.3), Shape::wheel(0.1, 0.05), Shape::box({0.2, 0.1, 0.1})}) {
      engine->add_robot(alone(shape), {x(), y(), random.uniform(-3, 3)});
    }
    train(x(), y(), random.uniform(-180, 180), {world::Segment(), world::Segment()});
  }
  double x() { return random.uniform(-4.0, 4.0); }
  double y() { return random.uniform(-3.0, 3.0); }
  Vector3 place() { return {x(), y(), random.uniform(0.0, 0.35)}; }
  Vector3 direction(bool is_level) {
    return Frame::turned({}, random.uniform(-4, 4), is_level ? 0.0 : random.uniform(-1.5, 1.5))
        .forward;
  }

  Random random;
};

}  // namespace

TEST_CASE("A ray tells the wall and the floor that it hits") {
  const PhysicsContext context(with(each_engine()), {.length = 8.0, .width = 6.0});
  using Kind = Surface::Kind;
  check(surface(context, {0, 0, 0.1}, {1, 0, 0}), Kind::wall, 0, {-1, 0, 0});
  check(surface(context, {0, 0, 0.1}, {0, 1, 0}), Kind::wall, 1, {0, -1, 0});
  check(surface(context, {0, 0, 0.1}, {-0.8, 0.6, 0}), Kind::wall, 1, {0, -1, 0});
  check(surface(context, {0, 0, 0.1}, {-1, 0, 0}), Kind::wall, 2, {1, 0, 0});
  check(surface(context, {0, 0, 0.1}, {0, -1, 0}), Kind::wall, 3, {0, 1, 0});
  check(surface(context, {0, 0, 0.1}, {0.6, 0, -0.8}), Kind::floor, 0, {0, 0, 1});
  check(surface(context, {0, 0, 0.5}, {1, 0, 0}), Kind::nothing, 0, {});
}

TEST_CASE("The normal of a box is that of the face that the ray enters") {
  PhysicsContext context(with(each_engine()), open_field());
  const double turned = GENERATE(0.0, 17.0, 45.0, -130.0);
  context.obstacle(ObstacleKind::fixed, 9.0, 9.0, {0.1, 0.1, 0.1});
  const std::size_t box = context.obstacle(ObstacleKind::fixed, 1.0, 2.0, {0.6, 0.4, 0.2}, turned);
  const Frame at = Frame::turned({1.0, 2.0, 0.1}, radians(turned), 0.0);
  const auto from = [&](const Vector3& own, const Vector3& along) {
    return surface(context, at.point(own), at.direction(along));
  };
  check(from({-1, 0.1, 0}, {1, 0, 0}), Surface::Kind::obstacle, box, -1.0 * at.forward);
  check(from({1, 0.1, 0}, {-0.8, -0.1, 0.0}), Surface::Kind::obstacle, box, at.forward);
  check(from({0.1, 1, 0}, {0, -1, 0}), Surface::Kind::obstacle, box, at.left);
  check(from({0.1, 0.1, 1}, {0, 0, -1}), Surface::Kind::obstacle, box, at.up);
  // Within the body: against the ray.
  check(from({0.1, 0.1, 0}, {0.6, 0.8, 0}), Surface::Kind::obstacle, box,
        at.direction({-0.6, -0.8, 0}));
}

TEST_CASE("The normals of round bodies point away from their axes and middles") {
  PhysicsContext context(with(each_engine()), open_field());
  const double r = 0.05, middle = r + 1e-3;
  world::Obstacle pillar = of_shape(ObstacleShape::cylinder, 3.0, 0.0);
  pillar.radius = 0.5;
  pillar.height = 0.4;
  context.engine->add_obstacle(pillar);
  const auto ball = context.engine->add_robot(alone(Shape::sphere(r)), {0.0, 3.0, 0.0});
  const auto capsule = context.engine->add_robot(
      alone(Shape::capsule(r, 0.3, Shape::Axis::left)), {-3.0, 0.0, 0.0});
  for (const double off : {0.0, 0.3, -0.4}) {
    const double back = std::sqrt(0.25 - off * off);
    check(surface(context, {0, off, 0.1}, {1, 0, 0}), Surface::Kind::obstacle, 0,
          {-2.0 * back, 2.0 * off, 0});
  }
  check(surface(context, {3.1, 0.1, 1.0}, {0, 0, -1}), Surface::Kind::obstacle, 0, {0, 0, 1});
  for (const double off : {0.0, 0.02, -0.03}) {
    const double back = std::sqrt(r * r - off * off);
    check(surface(context, {off, 0, middle}, {0, 1, 0}), Surface::Kind::robot, ball,
          {off / r, -back / r, 0});
    check(surface(context, {0, 0, middle + off}, {0, 1, 0}), Surface::Kind::robot, ball,
          {0, -back / r, off / r});
    check(surface(context, {0, off, middle}, {-1, 0, 0}), Surface::Kind::robot, capsule,
          {1, 0, 0});
    // Its end.
    check(surface(context, {0, 0.1 + std::abs(off), middle}, {-1, 0, 0}), Surface::Kind::robot,
          capsule, {back / r, std::abs(off) / r, 0});
  }
}

TEST_CASE("The normals of a prism are those of its sides") {
  PhysicsContext context(with(each_engine()), open_field());
  const double turned = GENERATE(0.0, 30.0, -100.0);
  world::Obstacle prism = of_shape(ObstacleShape::prism, 0.0, 0.0);
  prism.points = {{0.5, 0.0}, {0.0, 0.5}, {-0.5, 0.0}, {0.0, -0.5}};
  prism.height = 0.4;
  prism.heading_deg = turned;
  context.engine->add_obstacle(prism);
  for (int side = 0; side < 4; ++side) {
    const double yaw = radians(turned + 45.0 + 90.0 * side);
    const Vector3 out{std::cos(yaw), std::sin(yaw), 0.0};
    const Vector3 aside{-0.1 * out.y, 0.1 * out.x, 0.2};
    check(surface(context, 2.0 * out + aside, -1.0 * out), Surface::Kind::obstacle, 0, out);
  }
  check(surface(context, {0.1, 0.1, 1.0}, {0, 0, -1}), Surface::Kind::obstacle, 0, {0, 0, 1});
}

TEST_CASE("A ray tells a robot's chassis from its wheel by the normal") {
  PhysicsContext context(with(each_engine()), open_field());
  context.robot(5, 5);
  const std::size_t robot = context.robot(0, 0);
  using Kind = Surface::Kind;
  check(surface(context, {1, 0.045, 0.02}, {-1, 0, 0}), Kind::robot, robot, {1, 0, 0});
  check(surface(context, {1, 0.045, 0.032}, {-1, 0, 0}), Kind::robot, robot, {0.8, 0, 0.6});
  check(surface(context, {0.01, 1, 0.02}, {0, -1, 0}), Kind::robot, robot, {0, 1, 0});
  check(surface(context, {1, 0.01, 0.04}, {-1, 0, 0}), Kind::robot, robot, {1, 0, 0});
}

TEST_CASE("All bodies are where their surfaces say: a step back along the normal finds them") {
  Crowd crowd(each_engine(), GENERATE(1u, 2u));
  constexpr double kAway = 1e-4;
  int bodies = 0;
  for (int i = 0; i < 3000; ++i) {
    Batch batch;
    batch.add(crowd.place(), crowd.direction(i % 2 == 0));
    batch.cast(*crowd.engine);
    const Surface& hit = batch.surfaces.front();
    const double distance = batch.rays.front().distance_m;
    const Vector3& along = batch.from.front().forward;
    CAPTURE(i);
    CHECK((hit.kind == Surface::Kind::nothing) == (distance == kNone));
    if (hit.kind == Surface::Kind::nothing || distance == 0.0) continue;
    CHECK(dot(hit.normal, hit.normal) == Approx(1.0).margin(1e-9));
    CHECK(dot(hit.normal, along) <= 1e-9);
    if (hit.kind == Surface::Kind::floor) continue;
    const Vector3 there = batch.from.front().origin + distance * along;
    // Other bodies may be nearer, as may one behind an edge.
    CHECK(cast(crowd, there + kAway * hit.normal, -1.0 * hit.normal, 1.0) <=
          Approx(kAway).margin(1e-8));
    CHECK(cast(crowd, there - 1e-7 * hit.normal, hit.normal, 1.0) <= 1e-7);
    ++bodies;
  }
  CHECK(bodies > 1000);
}

TEST_CASE("Rays in a batch have the distances and bodies of single rays, bit for bit") {
  Crowd crowd(each_engine(), GENERATE(1u, 2u, 3u));
  const std::size_t count = GENERATE(1u, 3u, 16u, 17u, 60u, 360u, 10000u);
  const bool is_level = GENERATE(true, false), at_one_point = GENERATE(true, false);
  const std::size_t self = GENERATE(std::size_t{31}, kNobody);
  const Frame within = is_level ? Frame::turned(crowd.place(), 0.3, 0.0)
                                : Frame::turned(crowd.place(), 0.3, 0.1);
  const Vector3 mounted{0.1, 0.02, 0.1};
  Batch batch;
  for (std::size_t i = 0; i < count; ++i) {
    // Now and then a point of its own, a long range, or straight up or down.
    const bool has_own = !at_one_point || i % 700 == 699;
    const double range = i % 5 == 0 ? kNone : crowd.random.uniform(0.0, 3.0);
    const Vector3 along = i % 50 == 49 && !is_level ? Vector3{0, 0, i % 4 < 2 ? 1.0 : -1.0}
                                                    : crowd.direction(is_level);
    batch.add(has_own ? mounted + 0.2 * crowd.place() : mounted, along, range);
  }
  batch.cast(*crowd.engine, within, self);
  const std::vector<RayQuery> answers = batch.rays;
  batch.cast(*crowd.engine, within, self);
  std::vector<RayQuery> alone = batch.rays;
  for (RayQuery& ray : alone) ray.distance_m = -1.0;
  crowd.engine->cast_rays(within, alone, self);
  for (std::size_t i = 0; i < count; ++i) {
    const Frame& from = batch.from[i];
    const auto hit = crowd.engine->cast_ray(within.point(from.origin),
                                            within.direction(from.forward),
                                            batch.rays[i].max_range_m, self);
    CAPTURE(i);
    REQUIRE(answers[i].distance_m == (hit ? hit->distance : kNone));
    REQUIRE(alone[i].distance_m == answers[i].distance_m);
    const Surface& surface = batch.surfaces[i];
    const auto kind = !hit                                ? Surface::Kind::nothing
                      : hit->floor                        ? Surface::Kind::floor
                      : hit->body.kind == BodyKind::wall  ? Surface::Kind::wall
                      : hit->body.kind == BodyKind::robot ? Surface::Kind::robot
                                                          : Surface::Kind::obstacle;
    REQUIRE(surface.kind == kind);
    REQUIRE(surface.index == (hit && !hit->floor ? hit->body.index : 0));
  }
}

TEST_CASE("Rays that are not finite hit nothing, in a batch as alone") {
  Crowd crowd(each_engine(), 1);
  Batch batch;
  for (int i = 0; i < 40; ++i) batch.add({}, i == 7 ? Vector3{kNone, 0, 0} : Vector3{1, 0, 0});
  batch.cast(*crowd.engine, Frame::turned({0, 0, 0.1}, 0.0, 0.0));
  CHECK(batch.rays[7].distance_m == kNone);
  CHECK(batch.surfaces[7] == Surface());
  CHECK(batch.rays[8].distance_m < 8.0);
}

TEST_CASE("Surfaces that are not as many as the rays are refused") {
  const PhysicsContext context(with(each_engine()));
  Batch batch;
  batch.add({}, {1, 0, 0});
  batch.add({}, {0, 1, 0});
  batch.surfaces.pop_back();
  CHECK_THROWS_AS(batch.cast(*context.engine), std::invalid_argument);
}
