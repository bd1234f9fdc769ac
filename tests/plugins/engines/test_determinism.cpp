// The same calls give the same bits.
#include <cstdint>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/base/random.h"

#include "physics_context.h"

using namespace elsie;
using namespace elsie::physics;
using world::BoxKind;

namespace {

/// A crowd in a small arena that runs into everything; the hash after every tenth step.
std::vector<std::uint64_t> history(std::uint64_t seed, int steps = 400) {
  world::Arena arena;
  arena.length = arena.width = 3.0;
  PhysicsContext context({}, arena);
  Random random(seed);
  for (int i = 0; i < 9; ++i) {
    context.robot(0.8 * (i % 3 - 1), 0.8 * (i / 3 - 1), random.uniform(-180, 180));
  }
  for (int i = 0; i < 4; ++i) {
    const double across = 0.4 + 0.8 * (i % 2 - 1);
    context.box(BoxKind::dynamic, across, 0.4 + 0.8 * (i / 2 - 1), {0.1, 0.2, 0.1}, 30.0 * i);
  }
  const std::size_t moving = context.box(BoxKind::moving, -1.2, 1.2, {0.1, 0.1, 0.1});
  const std::size_t resource = context.box(BoxKind::resource, 1.2, 1.2, {0.1, 0.1, 0.1});
  std::vector<std::uint64_t> hashes;
  for (int i = 0; i < steps; ++i) {
    if (i % 50 == 0) {
      for (std::size_t robot = 0; robot < 9; ++robot) {
        context.drive(robot, {random.uniform(-10, 25), random.uniform(-10, 25)});
      }
    }
    if (i == 200) context.engine->remove_box(resource);
    context.engine->drive_box(moving, {-1.2 + 0.003 * i, 1.2}, {0.3, 0.0});
    context.engine->step();
    if (i % 10 == 9) hashes.push_back(context.engine->hash_state());
  }
  return hashes;
}

/// A crowd of robots and boxes, which goes over to a new engine after so many steps; none: never.
std::uint64_t hash_with_takeover(int takeover, const world::Physics& after = {}) {
  const world::Arena arena{.length = 3.0, .width = 3.0};
  PhysicsContext context({}, arena);
  Random random(5);
  for (int i = 0; i < 9; ++i) {
    context.robot(0.8 * (i % 3 - 1), 0.8 * (i / 3 - 1), random.uniform(-180, 180));
    context.drive(static_cast<std::size_t>(i), {10.0 + i, 12.0});
  }
  world::Box pushed;
  pushed.kind = BoxKind::dynamic;
  pushed.x = pushed.y = 0.4;
  world::Box taken;
  taken.x = 1.2;
  taken.y = 1.2;
  context.engine->add_box(pushed);
  context.engine->add_box(taken);
  context.engine->remove_box(1);
  for (int i = 0; i < 300; ++i) {
    if (i == takeover) {
      auto next = make_engine(arena, after);
      next->go_on_from(*context.engine);
      next->add_box_of(*context.engine, 0, pushed);
      next->add_box_of(*context.engine, 1, taken);
      for (std::size_t robot = 0; robot < 9; ++robot) {
        next->add_robot_of(*context.engine, robot);
      }
      CHECK(next->hash_state() == context.engine->hash_state());
      CHECK_FALSE(next->has_box(1));
      context.engine = std::move(next);
    }
    context.engine->step();
  }
  return context.engine->hash_state();
}

}  // namespace

TEST_CASE("A new engine goes on from the state of another one, to the bit") {
  const std::uint64_t alone = hash_with_takeover(-1);
  for (const int takeover : {0, 1, 100, 299}) {
    CAPTURE(takeover);
    CHECK(hash_with_takeover(takeover) == alone);
  }
  world::Physics other;
  other.friction = 0.5;
  CHECK(hash_with_takeover(100, other) != alone);
}

TEST_CASE("Two engines with the same calls agree to the bit, one after the other") {
  const auto first = history(1);
  CHECK(history(1) == first);
  history(2, 50);  // another world in between leaves no trace
  CHECK(history(1) == first);
  CHECK(history(2) != first);
}

TEST_CASE("Engines in several threads agree to the bit with one alone") {
  const auto alone_1 = history(1), alone_2 = history(2);
  std::vector<std::uint64_t> one, two, three;
  std::thread a([&] { one = history(1); });
  std::thread b([&] { two = history(2); });
  std::thread c([&] { three = history(1); });
  a.join();
  b.join();
  c.join();
  CHECK(one == alone_1);
  CHECK(two == alone_2);
  CHECK(three == alone_1);
}

TEST_CASE("An engine may go on in another thread than it was made in") {
  PhysicsContext here, there;
  for (PhysicsContext* context : {&here, &there}) {
    context->robot(0, 0);
    context->box(BoxKind::dynamic, 0.3, 0.01, {0.2, 0.2, 0.2});
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
  const std::size_t box = a.box(BoxKind::resource, 1, 1, {0.1, 0.1, 0.1});
  const auto before = a.engine->hash_state();
  a.engine->remove_box(box);
  CHECK(a.engine->hash_state() != before);
}
