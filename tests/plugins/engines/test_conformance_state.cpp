// What every engine must do: state and senses. Each case runs with each engine that is installed.
#include <cmath>
#include <cstdint>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/base/random.h"

#include "conformance.h"

using namespace elsie;
using namespace elsie::physics;
using world::BoxKind;

namespace {

/// A crowd in a small arena that runs into everything; the hash after every tenth step.
std::vector<std::uint64_t> history(const std::string& engine, std::uint64_t seed) {
  PhysicsContext context(with(engine), {.length = 3.0, .width = 3.0});
  Random random(seed);
  for (int i = 0; i < 9; ++i) {
    context.robot(0.8 * (i % 3 - 1), 0.8 * (i / 3 - 1), random.uniform(-180, 180));
  }
  for (int i = 0; i < 4; ++i) {
    context.box(BoxKind::dynamic, 0.4 + 0.8 * (i % 2 - 1), 0.4 + 0.8 * (i / 2 - 1), {0.1, 0.2, 0.1},
                30.0 * i);
  }
  std::vector<std::uint64_t> hashes;
  for (int i = 0; i < 300; ++i) {
    for (std::size_t robot = 0; i % 50 == 0 && robot < 9; ++robot) {
      context.drive(robot, {random.uniform(-10, 25), random.uniform(-10, 25)});
    }
    context.engine->step();
    if (i % 10 == 9) hashes.push_back(context.engine->hash_state());
  }
  return hashes;
}

}  // namespace

TEST_CASE("The same calls give the same bits, alone and beside other threads") {
  const std::string engine = each_engine();
  CAPTURE(engine);
  const auto first = history(engine, 1);
  CHECK(history(engine, 2) != first);
  CHECK(history(engine, 1) == first);
  std::vector<std::uint64_t> one, two;
  std::thread a([&] { one = history(engine, 1); });
  std::thread b([&] { two = history(engine, 1); });
  a.join();
  b.join();
  CHECK(one == first);
  CHECK(two == first);
}

TEST_CASE("An engine goes on where another one was, to the bit") {
  const std::string engine = each_engine();
  CAPTURE(engine);
  const world::Arena arena{.length = 3.0, .width = 3.0};
  world::Box pushed, taken;
  pushed.kind = BoxKind::dynamic;
  pushed.x = pushed.y = 0.4;
  taken.x = taken.y = 1.2;
  const auto hash = [&](int takeover) {
    PhysicsContext context(with(engine), arena);
    Random random(5);
    for (int i = 0; i < 9; ++i) {
      context.robot(0.8 * (i % 3 - 1), 0.8 * (i / 3 - 1), random.uniform(-180, 180));
      context.drive(static_cast<std::size_t>(i), {10.0 + i, 12.0});
    }
    const std::size_t train = context.train(1.0, -1.2, 180, {world::Segment{}});
    context.drive(train, {8, 10});
    context.engine->add_box(pushed);
    context.engine->add_box(taken);
    context.engine->remove_box(1);
    for (int i = 0; i < 300; ++i) {
      if (i == takeover) {
        auto next = make_engine(arena, context.physics);
        next->go_on_from(*context.engine);
        next->add_box_of(*context.engine, 0, pushed);
        next->add_box_of(*context.engine, 1, taken);
        for (std::size_t robot = 0; robot <= train; ++robot) {
          next->add_robot_of(*context.engine, robot);
        }
        CHECK(next->hash_state() == context.engine->hash_state());
        CHECK_FALSE(next->has_box(1));
        context.engine = std::move(next);
      }
      context.engine->step();
    }
    return context.engine->hash_state();
  };
  const std::uint64_t alone = hash(-1);
  for (const int takeover : {0, 1, 100, 299}) {
    CAPTURE(takeover);
    CHECK(hash(takeover) == alone);
  }
}

TEST_CASE("Rays find surfaces at their exact distances") {
  const std::string engine = each_engine();
  CAPTURE(engine);
  PhysicsContext context(with(engine));
  const std::size_t box = context.box(BoxKind::fixed, 1.0, 0.0, {0.2, 0.4, 0.3});
  const std::size_t turned = context.box(BoxKind::fixed, -1.0, 0.0, {0.2, 0.2, 0.3}, 45);
  const std::size_t disc = context.robot(0.0, 1.0, 20, round_body(0.12));
  const std::size_t square = context.robot(0.0, -1.0, 90);
  const std::size_t hidden = context.engine->add_box([] {
    world::Box none;
    none.x = 0.5;
    none.seen_by_range_sensors = false;
    return none;
  }());
  static_cast<void>(hidden);
  const Vector3 eye{0.0, 0.0, 0.05};
  const auto look = [&](const Vector3& direction, double range = 10.0,
                        std::size_t except = Engine::kNobody) {
    return context.engine->cast_ray(eye, direction, range, except);
  };
  const double s = std::sqrt(0.5);
  struct Expected {
    Vector3 direction;
    double distance;
    Body body;
  };
  for (const Expected& each : std::vector<Expected>{
           {{1, 0, 0}, 0.9, box_body(box)},
           {{-1, 0, 0}, 1.0 - 0.1 * std::sqrt(2.0), box_body(turned)},
           {{0, 1, 0}, 0.94, robot_body(disc)},
           {{0, -1, 0}, 0.96, robot_body(square)},
           {{s, s, 0}, 5.0 / s, wall_body(0)},
       }) {
    const auto hit = look(each.direction);
    REQUIRE(hit);
    CHECK(hit->distance == Approx(each.distance).epsilon(1e-9));
    CHECK((hit->body == each.body || each.body.kind == BodyKind::wall));
    CHECK_FALSE(look(each.direction, each.distance - 1e-6));
  }
  CHECK_FALSE(look({0, 1, 0}, 2.0, disc));
  // Over the box, into the floor, and into the top.
  const auto floor = look({0.6, 0.0, -0.8});
  REQUIRE(floor);
  CHECK(floor->floor);
  CHECK(floor->distance == Approx(0.05 / 0.8));
  const auto over = context.engine->cast_ray({0.0, 0.0, 0.31}, {1, 0, 0}, 3.0, Engine::kNobody);
  CHECK_FALSE(over);
  const auto top = context.engine->cast_ray({1.0, 0.1, 1.0}, {0, 0, -1}, 3.0, Engine::kNobody);
  REQUIRE(top);
  CHECK(top->distance == Approx(0.7));
  CHECK(top->body == box_body(box));
  // The deck of a robot: 9 cm to the top of the chassis, 2 cm more for sensors.
  const auto deck = context.engine->cast_ray({0.0, 0.0, 0.105}, {0, -1, 0}, 3.0, Engine::kNobody);
  CHECK((deck && deck->body == robot_body(square)));
  const auto above = context.engine->cast_ray({0.0, 0.0, 0.115}, {0, -1, 0}, 3.0, Engine::kNobody);
  CHECK_FALSE(above);
}

TEST_CASE("A pyramid notices what reaches into it") {
  const std::string engine = each_engine();
  CAPTURE(engine);
  PhysicsContext context(with(engine));
  context.box(BoxKind::fixed, 1.0, 0.0, {0.2, 0.2, 0.3});
  const std::size_t disc = context.robot(0.0, 1.0, 0, round_body(0.12));
  const auto anything = [&](double heading_deg, double range, std::size_t except) {
    const Frame frame = Frame::turned({0.0, 0.0, 0.05}, radians(heading_deg), 0.0);
    return context.engine->anything_in({frame, radians(20), radians(20), range}, except);
  };
  CHECK(anything(0, 0.91, Engine::kNobody));
  CHECK_FALSE(anything(0, 0.89, Engine::kNobody));
  CHECK(anything(90, 0.95, Engine::kNobody));
  CHECK_FALSE(anything(90, 0.93, Engine::kNobody));
  CHECK_FALSE(anything(90, 0.95, disc));
  CHECK_FALSE(anything(180, 2.0, Engine::kNobody));
}

TEST_CASE("Touches name each pair once, in order, while there is no gap") {
  const std::string engine = each_engine();
  CAPTURE(engine);
  PhysicsContext context(with(engine));
  const std::size_t first = context.box(BoxKind::dynamic, 4.9, 0.0, {0.2, 0.2, 0.2});
  context.box(BoxKind::fixed, 4.7, 0.5, {0.2, 0.2, 0.2});
  const std::size_t ahead = context.robot(4.75, 0.0);
  const std::size_t behind = context.robot(4.66, 0.0);
  context.robot(0.0, 0.0);
  context.drive(ahead, {10, 10});
  context.drive(behind, {10, 10});
  context.run(1.0);
  std::vector<std::pair<Body, Body>> found;
  for (const Touch& touch : context.engine->touches()) found.emplace_back(touch.a, touch.b);
  const std::vector<std::pair<Body, Body>> expected{{robot_body(ahead), robot_body(behind)},
                                                    {robot_body(ahead), box_body(first)},
                                                    {box_body(first), wall_body(0)}};
  CHECK(found == expected);
  context.drive(behind, {-10, -10});
  context.run(1.0);
  CHECK_FALSE(context.touching(robot_body(ahead), robot_body(behind)));
}
