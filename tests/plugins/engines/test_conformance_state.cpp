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
using world::ObstacleKind;

TEST_CASE("The same calls give the same bits, alone and beside other threads") {
  const std::string engine = each_engine();
  CAPTURE(engine);
  const auto first = history(engine, {.seed = 1}), other = history(engine, {.seed = 2});
  CHECK(other != first);
  history(engine, {.seed = 2, .steps = 50});  // another world in between leaves no trace
  CHECK(history(engine, {.seed = 1}) == first);
  std::vector<std::uint64_t> one, two, three;
  std::thread a([&] { one = history(engine, {.seed = 1}); });
  std::thread b([&] { two = history(engine, {.seed = 2}); });
  std::thread c([&] { three = history(engine, {.seed = 1}); });
  for (std::thread* const thread : {&a, &b, &c}) thread->join();
  CHECK(one == first);
  CHECK(two == other);
  CHECK(three == first);
}

TEST_CASE("An engine goes on where another one was, to the bit") {
  const std::string engine = each_engine();
  CAPTURE(engine);
  const world::Arena arena{.length = 3.0, .width = 3.0};
  world::Obstacle pushed, taken;
  pushed.kind = ObstacleKind::dynamic;
  pushed.x = pushed.y = 0.4;
  taken.x = taken.y = 1.2;
  const auto hash = [&](int takeover, double friction = world::Physics{}.friction) {
    PhysicsContext context(with(engine), arena);
    world::Physics after = context.physics;
    after.friction = friction;
    Random random(5);
    for (int i = 0; i < 9; ++i) {
      context.robot(0.8 * (i % 3 - 1), 0.8 * (i / 3 - 1), random.uniform(-180, 180));
      context.drive(static_cast<std::size_t>(i), {10.0 + i, 12.0});
    }
    const std::size_t train = context.train(1.0, -1.2, 180, {world::Segment{}});
    context.drive(train, {8, 10});
    context.engine->add_obstacle(pushed);
    context.engine->add_obstacle(taken);
    context.engine->remove_obstacle(1);
    for (int i = 0; i < 300; ++i) {
      if (i == takeover) {
        auto next = make_engine(arena, after);
        next->go_on_from(*context.engine);
        next->add_obstacle_of(*context.engine, 0, pushed);
        next->add_obstacle_of(*context.engine, 1, taken);
        for (std::size_t robot = 0; robot <= train; ++robot) {
          next->add_robot_of(*context.engine, robot);
        }
        CHECK(next->hash_state() == context.engine->hash_state());
        CHECK_FALSE(next->has_obstacle(1));
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
  CHECK(hash(100, 0.5) != alone);
}

TEST_CASE("Touches name each pair once, in order, while there is no gap") {
  const std::string engine = each_engine();
  CAPTURE(engine);
  PhysicsContext context(with(engine));
  const std::size_t first = context.obstacle(ObstacleKind::dynamic, 4.9, 0.0, {0.2, 0.2, 0.2});
  context.obstacle(ObstacleKind::fixed, 4.7, 0.5, {0.2, 0.2, 0.2});
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
