// Obstacles that are put elsewhere, and that come back.
#include "conformance.h"

namespace elsie::physics {
namespace {

using world::ObstacleKind;

}  // namespace

TEST_CASE("An obstacle is put elsewhere at rest, where rays and robots meet it") {
  const std::string engine = each_engine();
  const ObstacleKind kind = GENERATE(ObstacleKind::fixed, ObstacleKind::resource,
                                     ObstacleKind::dynamic, ObstacleKind::moving);
  const bool was_away = GENERATE(false, true);
  CAPTURE(engine, int(kind), was_away);
  PhysicsContext context(with(engine));
  const std::size_t robot = context.robot(0.0, 0.0);
  const std::size_t box = context.obstacle(kind, 0.5, 1.0, {0.2, 0.2, 0.2}, 30.0, 0.0, 0.2);
  context.run(0.1);  // neighbours are known
  CHECK_FALSE(context.engine->cast_ray({0, 0, 0.1}, {1, 0, 0}, 2, robot).has_value());
  if (was_away) {
    context.engine->remove_obstacle(box);
    context.run(0.1);
  }
  context.engine->place_obstacle(box, {0.5, 0.0, radians(90.0)});
  CHECK(context.engine->has_obstacle(box));
  const Frame frame = context.engine->obstacle(box);
  CHECK(frame.origin.x == Approx(0.5));
  CHECK(frame.origin.y == Approx(0.0).margin(1e-12));
  CHECK(frame.forward.y == Approx(1.0));
  const auto hit = context.engine->cast_ray({0, 0, 0.1}, {1, 0, 0}, 2, robot);
  REQUIRE(hit);
  CHECK(hit->distance == Approx(0.4));
  context.run(0.2);
  CHECK(context.engine->obstacle(box).origin.x == Approx(0.5).margin(1e-4));
  context.drive(robot, {25, 25});
  bool touched = false;
  context.run(2.0, [&] {
    touched = touched || context.touching({BodyKind::robot, robot}, {BodyKind::obstacle, box});
  });
  CHECK(touched);
  CHECK((context.pose(robot).x > 0.45) == (kind == ObstacleKind::dynamic));
  CHECK((context.engine->obstacle(box).origin.x > 0.52) == (kind == ObstacleKind::dynamic));
}

TEST_CASE("A resource that comes back where it was stops a robot that stands before it") {
  PhysicsContext context(with(each_engine()));
  const std::size_t robot = context.robot(0.0, 0.0);
  const std::size_t box = context.obstacle(ObstacleKind::resource, 0.2, 0.0, {0.1, 0.1, 0.1});
  context.run(0.5);
  context.engine->remove_obstacle(box);
  context.run(0.5);
  context.engine->place_obstacle(box, {0.2, 0.0, 0.0});
  context.drive(robot, {25, 25});
  context.run(1.0);
  CHECK(context.pose(robot).x < 0.15);
}

TEST_CASE("An engine that takes over has what was put elsewhere, and goes on in the same way") {
  const std::string engine = each_engine();
  PhysicsContext context(with(engine)), next(with(engine));
  world::Obstacle crate;
  crate.kind = ObstacleKind::dynamic;
  crate.x = 1.0;
  context.engine->add_obstacle(crate);
  context.run(0.1);
  context.engine->remove_obstacle(0);
  context.engine->place_obstacle(0, {-1.0, 0.5, 1.0});
  context.run(0.1);
  next.engine->go_on_from(*context.engine);
  next.engine->add_obstacle_of(*context.engine, 0, crate);
  CHECK(next.engine->hash_state() == context.engine->hash_state());
  context.run(0.1);
  next.run(0.1);
  CHECK(next.engine->hash_state() == context.engine->hash_state());
  CHECK_THROWS_AS(context.engine->place_obstacle(1, {}), std::out_of_range);
  CHECK_THROWS_AS(context.engine->place_obstacle(0, {NAN, 0, 0}), std::invalid_argument);
}

}  // namespace elsie::physics
