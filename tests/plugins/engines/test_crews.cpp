// An engine gives parts of a step to the threads of a pool.
#include <cstdint>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/base/random.h"
#include "elsie/base/thread_pool.h"
#include "elsie/physics/failure.h"

#include "conformance.h"

using namespace elsie;
using namespace elsie::physics;
using world::BoxKind;

namespace {

/// Robots, boxes that they push, a train and a box that moves through them, close enough to meet;
/// one box is removed on the way. The hash after each step.
std::vector<std::uint64_t> history(const std::string& engine, std::size_t threads, int steps) {
  base::ThreadPool pool(threads);
  PhysicsContext context(with(engine), {.length = 4.0, .width = 4.0});
  context.engine->work_with(pool);
  Random random(3);
  for (int i = 0; i < 81; ++i) {
    context.robot(0.45 * (i % 9 - 4), 0.45 * (i / 9 - 4), random.uniform(-180, 180));
  }
  for (int i = 0; i < 16; ++i) {
    context.box(BoxKind::dynamic, 0.225 + 0.9 * (i % 4 - 2), 0.225 + 0.9 * (i / 4 - 2),
                {0.1, 0.15, 0.1}, 30.0 * i);
  }
  context.train(0.0, -1.93, 0.0, {world::Segment(), world::Segment()});
  const std::size_t moving = context.box(BoxKind::moving, -1.6, 0.225, {0.1, 0.1, 0.1});
  std::vector<std::uint64_t> hashes;
  for (int i = 0; i < steps; ++i) {
    if (i % 20 == 0) {
      for (std::size_t robot = 0; robot < 82; ++robot) {
        context.drive(robot, {random.uniform(-5, 25), random.uniform(-5, 25)});
      }
    }
    if (i == steps / 2) context.engine->remove_box(5);
    context.engine->drive_box(moving, {-1.6 + 0.02 * (i + 1), 0.225}, {2.0, 0.0});
    context.engine->step();
    hashes.push_back(context.engine->hash_state());
  }
  return hashes;
}

}  // namespace

TEST_CASE("A step is the same with any crew") {
  const std::string engine = each_engine();
  CAPTURE(engine);
  const auto alone = history(engine, 1, 150);
  for (const std::size_t threads : {2, 3, 8}) {
    CAPTURE(threads);
    CHECK(history(engine, threads, 150) == alone);
  }
}

TEST_CASE("Of several robots that are lost, the same one is named with any crew") {
  const std::string engine = each_engine();
  CAPTURE(engine);
  const auto lost = [&](std::size_t threads) {
    base::ThreadPool pool(threads);
    PhysicsContext context(with(engine));
    context.engine->work_with(pool);
    for (int i = 0; i < 40; ++i) context.robot(0.4 * (i % 8) - 4, 0.4 * (i / 8) - 1);
    for (const double y : {-2.0, 0.0, 2.0}) context.robot(4.8, y);
    // Each is pressed through the wall.
    std::vector<std::size_t> rams;
    for (const double y : {-2.0, 0.0, 2.0}) {
      rams.push_back(context.box(BoxKind::moving, 4.5, y, {0.2, 0.2, 0.2}));
    }
    for (int i = 0; i < 300; ++i) {
      for (std::size_t k = 0; k < rams.size(); ++k) {
        const double y = 2.0 * (static_cast<double>(k) - 1.0);
        context.engine->drive_box(rams[k], {4.5 + 0.002 * (i + 1), y}, {0.2, 0.0});
      }
      try {
        context.engine->step();
      } catch (const PhysicsFailure& failure) {
        CHECK(failure.failure.body->index >= 40);
        return std::string(failure.what()) + std::to_string(context.engine->hash_state());
      }
    }
    return std::string("none");
  };
  const std::string alone = lost(1);
  CHECK(alone != "none");
  for (const std::size_t threads : {2, 8}) CHECK(lost(threads) == alone);
}
