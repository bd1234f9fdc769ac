// What stays, and what is under way, when plugins around it are replaced.
#include <algorithm>
#include <memory>

#include <catch2/catch.hpp>

#include "replacement_stage.h"

using namespace elsie;
using namespace elsie::test;
using Catch::Contains;

TEST_CASE("Coordinators that stay find published numbers where the new version has them") {
  auto holds = behavior("holds");
  auto& inside = holds.inside.emplace_back();
  inside.behaviors.push_back(behavior("numbered"));
  inside.coordinator.emplace();
  inside.coordinator->plugin = inside.coordinator->id = "watcher";
  Stage stage(holds);
  stage.world.robots.push_back(numbered_robot("r2", 2.0, behavior("numbered")));
  stage.world.robots[1].coordinator->plugin = "watcher";
  stage.world.robots[1].coordinator->parameters["strict"] = true;
  stage.start();
  const auto both = [&](double version, double asked) {
    stage.step();
    for (std::size_t i = 0; i < 2; ++i) {
      CAPTURE(i);
      const WheelRates rates = elsie::test::rates(stage.simulation->robot(i).command);
      CHECK(rates.left == Approx(0.01 * version));
      CHECK(rates.right == Approx(0.01 * asked));
    }
  };
  both(1, 1);
  const Replacement replacement = stage.replace(2, 'p');
  CHECK(replacement.objects.size() == 3);  // behaviours, and the coordinator around that of r1
  both(2, 2);

  // Of two that stay, the second does not find its number: the replacement is refused, and the
  // first one finds it where it was.
  CHECK_THAT(stage.refusal(3, 'u'),
             Contains("robot 'r2', coordinator: its member publishes no 'version'"));
  both(2, 3);
  stage.replace(4);
  both(4, 4);
}

TEST_CASE("What is under way when its library is replaced is heard, and then the library goes") {
  // With latency, commands wait in the horn, too.
  const bool is_late = GENERATE(false, true);
  CAPTURE(is_late);
  Stage stage(behavior("talker"));
  stage.world.robots[0].coordinator.reset();
  stage.world.robots.push_back(numbered_robot("r2", 2.0, behavior("numbered")));
  for (world::Robot& robot : stage.world.robots) {
    world::MountedUse& horn = robot.actuators.emplace_back();
    horn.plugin = horn.id = "horn";
    if (is_late) horn.elements.push_back({"failure", {{"latency", 0.03}}, {}, {}, {}});
  }
  Simulation& simulation = stage.start();
  const auto listen = [&](int steps) {
    std::vector<double> heard;
    for (int i = 0; i < steps; ++i) {
      simulation.step();
      for (const HeardMessage& each : simulation.heard(1)) {
        each.message->visit_fields(
            [&](const ReadingField& field) { heard.push_back(field.number(0)); });
      }
    }
    return heard;
  };
  CHECK(listen(2).empty());
  stage.replace(2);
  CHECK(Versions::loaded() == 2);
  CHECK(listen(12) == std::vector<double>{-1.0, 1.0});
  CHECK(Versions::loaded() == 1);
  simulation.reset();
  CHECK(listen(12) == std::vector<double>{-2.0, 2.0});
}

TEST_CASE("Behaviours that stay are equipped again when a sensor is replaced") {
  Stage stage(behavior("looks"));
  stage.add_levels();
  stage.start();
  CHECK(stage.step().left == Approx(0.0));
  stage.replace(2, 'v');
  CHECK(stage.step().left == Approx(1.0));
  CHECK_THAT(stage.refusal(3, 'k'), Contains("makes readings of the kind 'other' now"));
  CHECK(stage.step().left == Approx(1.0));
}
