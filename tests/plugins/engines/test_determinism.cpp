// The same calls give the same bits.
#include <thread>

#include <catch2/catch.hpp>

#include "physics_context.h"

using namespace elsie;
using namespace elsie::physics;
using world::ObstacleKind;

TEST_CASE("An engine may go on in another thread than it was made in") {
  PhysicsContext here, there;
  for (PhysicsContext* context : {&here, &there}) {
    context->robot(0, 0);
    context->obstacle(ObstacleKind::dynamic, 0.3, 0.01, {0.2, 0.2, 0.2});
    context->drive(0, {20, 18});
    context->run(0.5);
  }
  here.run(1.0);
  std::thread other([&] { there.run(1.0); });
  other.join();
  CHECK(here.engine->hash_state() == there.engine->hash_state());
}

TEST_CASE("Questions do not change the world") {
  PhysicsContext asked, left_alone;
  for (PhysicsContext* context : {&asked, &left_alone}) {
    context->robot(0, 0);
    context->drive(0, {20, 18});
  }
  left_alone.run(1.0);
  asked.run(1.0, [&] {
    const Frame frame = asked.engine->robot(0).frame;
    asked.engine->cast_ray(frame.point({0.04, 0, 0.09}), frame.forward, 1.0, 0);
    asked.engine->anything_in({frame, 0.7, 0.1, 0.5}, 0);
    asked.engine->hash_state();
  });
  CHECK(asked.engine->hash_state() == left_alone.engine->hash_state());
}

TEST_CASE("The hash tells states apart and continues from another") {
  PhysicsContext a, b;
  a.robot(0, 0);
  b.robot(0, 1e-15);
  CHECK(a.engine->hash_state() != b.engine->hash_state());
  CHECK(a.engine->hash_state(1) != a.engine->hash_state());
  const auto before = a.engine->hash_state();
  a.drive(0, {1, 1});
  a.run(0.01);
  CHECK(a.engine->hash_state() != before);
}

TEST_CASE("The hash knows which boxes are left") {
  PhysicsContext a;
  const std::size_t box = a.obstacle(ObstacleKind::resource, 1, 1, {0.1, 0.1, 0.1});
  const auto before = a.engine->hash_state();
  a.engine->remove_obstacle(box);
  CHECK(a.engine->hash_state() != before);
}
