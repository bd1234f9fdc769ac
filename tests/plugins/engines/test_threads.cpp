// An engine gives parts of a step to the threads of a pool.
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/base/thread_pool.h"
#include "elsie/physics/failure.h"

#include "conformance.h"

using namespace elsie;
using namespace elsie::physics;
using world::ObstacleKind;

TEST_CASE("A step is the same with any crew") {
  const std::string engine = each_engine();
  CAPTURE(engine);
  const Bustle bustle{.seed = 3, .steps = 150, .side = 9, .apart = 0.45};
  const auto alone = history(engine, bustle);
  for (const std::size_t threads : {2, 3, 8}) {
    CAPTURE(threads);
    CHECK(history(engine, bustle, threads) == alone);
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
      rams.push_back(context.obstacle(ObstacleKind::moving, 4.5, y, {0.2, 0.2, 0.2}));
    }
    for (int i = 0; i < 300; ++i) {
      for (std::size_t k = 0; k < rams.size(); ++k) {
        const double y = 2.0 * (static_cast<double>(k) - 1.0);
        context.engine->drive_obstacle(rams[k], {4.5 + 0.002 * (i + 1), y}, {0.2, 0.0});
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
