// What rules, fields and things in the hands of robots cost: processor time on one core, each
// against the same without. Prints tables in Markdown.
//
//   effects [--repeats N]
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "elsie/api/behavior.h"
#include "elsie/commands/gripper.h"
#include "elsie/plugin/host.h"
#include "elsie/plugin/search_path.h"
#include "elsie/simulation/simulation.h"

#include "apart.h"
#include "arena_of_robots.h"
#include "statistics.h"

namespace {

using namespace elsie;
using simulation::Simulation;

constexpr double kStep = 0.01;  // s

/// Closes and opens a gripper in turn, as often as `every` says, and moves nowhere.
class Grasps final : public Behavior {
 public:
  int every = 1;  // control periods from one to the other

  void reset(Random&) override { asked_ = 0; }

  Response respond(const Perception&) override {
    Response response;
    response.act(GripCommand{asked_++ / every % 2 == 0});
    return response;
  }

 private:
  int asked_ = 0;
};

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Processor time for a step, s, in a process of its own.
double cost(const plugin::Host& host, const world::World& world, int steps) {
  return bench::apart([&] {
    Simulation run(world, host);
    run.step();
    const double start = seconds();
    for (int i = 0; i < steps; ++i) run.step();
    return (seconds() - start) / steps;
  });
}

/// Such worlds' costs in turn, because machines drift.
struct Costs {
  std::vector<double> first, second, ratios;

  Costs(int repeats, const std::function<double()>& one, const std::function<double()>& other) {
    for (int i = 0; i < repeats; ++i) {
      first.push_back(one());
      second.push_back(other());
      ratios.push_back(first.back() / second.back());
    }
  }
};

/// A hundred robots that avoid boxes, and 50 resources, which are collected when touched.
world::World pasture(const std::string& engine, bool has_rule) {
  world::World world = bench::arena_of_robots(100);
  world.physics.engine = engine;
  for (int i = 0; i < 50; ++i) {
    world::Obstacle& resource = world.obstacles.emplace_back();
    resource.id = "food" + std::to_string(i);
    resource.kind = world::ObstacleKind::resource;
    resource.seen_by_range_sensors = false;
    resource.length = resource.width = 0.1;
    resource.x = 0.9 * (i % 10) - 4.1;
    resource.y = 1.7 * (i / 10) - 3.4;
    for (const world::Robot& robot : world.robots) {
      if (std::hypot(robot.x - resource.x, robot.y - resource.y) < 0.2) resource.y += 0.25;
    }
  }
  if (has_rule) {
    world::PluginUse& respawn = world.rules.emplace_back();
    respawn.plugin = respawn.id = "respawn";
    respawn.parameters["after"] = 1.0;
  }
  return world;
}

void print_rules(const plugin::Host& host, int repeats) {
  std::printf(
      "A hundred robots among 50 resources, which a rule puts back a second after they were "
      "collected, for 30 s.\n\n| engine | came back | robot-steps per second, against the world "
      "without the rule |\n|---|---|---|\n");
  for (const std::string engine : {"planar", "ode"}) {
    const world::World with = pasture(engine, true), without = pasture(engine, false);
    const double back = bench::apart([&] {
      Simulation run(with, host);
      for (int i = 0; i < 3000; ++i) run.step();
      double changes = 0;
      for (const auto& event : run.result().events) changes += event.name() == "changed";
      return changes;
    });
    const Costs costs(
        repeats, [&] { return cost(host, without, 3000); }, [&] { return cost(host, with, 3000); });
    const auto [least, most] = std::minmax_element(costs.ratios.begin(), costs.ratios.end());
    std::printf("| `%s` | %.0f times | %.0f %% (%.0f to %.0f) |\n", engine.c_str(), back,
                100.0 * bench::median(costs.ratios), 100.0 * *least, 100.0 * *most);
    std::fflush(stdout);
  }
}

/// One robot in an arena of 10 m x 10 m; with a field of a million cells.
world::World meadow(bool has_field) {
  world::World world = bench::arena_of_robots(1);
  world.physics.engine = "planar";
  if (has_field) {
    world::ScalarField& field = world.fields.emplace_back();
    field.id = "pheromone";
    field.cell = 0.01;
    field.half_life = 30.0;
    field.spread = 0.0005;
    field.start = 1.0;
  }
  return world;
}

void print_fields(const plugin::Host& host, int repeats) {
  const world::World with = meadow(true), without = meadow(false);
  const Costs costs(
      repeats, [&] { return cost(host, with, 200); }, [&] { return cost(host, without, 200); });
  std::vector<double> speeds;
  for (std::size_t i = 0; i < costs.first.size(); ++i) {
    speeds.push_back(kStep / (costs.first[i] - costs.second[i]));
  }
  const auto [least, most] = std::minmax_element(speeds.begin(), speeds.end());
  std::printf(
      "\nA field of a million cells that evaporates and spreads, at 100 Hz, without the rest of "
      "the world: %.1f times real time (%.1f to %.1f).\n",
      bench::median(speeds), *least, *most);
}

/// A thousand robots, each with a gripper in front of a puck.
world::World pucks(const std::string& engine, int every) {
  world::World world = bench::arena_of_robots(1000);
  world.physics.engine = engine;
  world.obstacles.clear();
  for (world::Robot& robot : world.robots) {
    robot.sensors.clear();
    robot.heading_deg = 0.0;
    world::MountedUse& gripper = robot.actuators.emplace_back();
    gripper.plugin = gripper.id = "gripper";
    gripper.z = 0.02;
    world::BehaviorUse grasps;
    grasps.plugin = grasps.id = "grasps";
    grasps.parameters["every"] = std::int64_t{every};
    robot.behaviors = {grasps};
    robot.coordinator.reset();
    world::Obstacle& puck = world.obstacles.emplace_back();
    puck.id = "puck_" + robot.id;
    puck.kind = world::ObstacleKind::dynamic;
    puck.length = puck.width = 0.05;
    puck.height = 0.04;
    puck.mass = 0.05;
    puck.x = robot.x + 0.075;
    puck.y = robot.y;
  }
  return world;
}

void print_hands(const plugin::Host& host, int repeats) {
  constexpr int kSteps = 200;
  constexpr int kSeldom = 50;
  std::printf(
      "\nA thousand robots, each of which takes a puck and puts it down again, in every second "
      "step and in every hundredth.\n\n| engine | taken | microseconds for taking and "
      "releasing one |\n|---|---|---|\n");
  for (const std::string engine : {"planar", "ode"}) {
    const world::World often = pucks(engine, 1), seldom = pucks(engine, kSeldom);
    const double taken = bench::apart([&] {
      Simulation run(often, host);
      for (int i = 0; i <= kSteps; ++i) run.step();
      double count = 0;
      for (const auto& event : run.result().events) count += event.name() == "taken";
      return count;
    });
    const Costs costs(
        repeats, [&] { return cost(host, often, kSteps); },
        [&] { return cost(host, seldom, kSteps); });
    std::vector<double> each;
    for (std::size_t i = 0; i < costs.first.size(); ++i) {
      each.push_back(1e6 * kSteps * (costs.first[i] - costs.second[i]) /
                     (taken * (1.0 - 1.0 / kSeldom)));
    }
    const auto [least, most] = std::minmax_element(each.begin(), each.end());
    std::printf("| `%s` | %.0f times | %.1f (%.1f to %.1f) |\n", engine.c_str(), taken,
                bench::median(each), *least, *most);
    std::fflush(stdout);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int repeats = argc == 3 && std::string(argv[1]) == "--repeats" ? std::atoi(argv[2]) : 7;
  if ((argc != 1 && argc != 3) || repeats < 1) {
    std::fprintf(stderr, "usage: effects [--repeats N]\n");
    return EXIT_FAILURE;
  }
  try {
    plugin::Host host(plugin::default_search_path());
    host.add(declare<Grasps>(PluginKind::behavior, "grasps", "closes and opens a gripper",
                             only_acts(), commands<GripCommand>(),
                             parameter("every", &Grasps::every)));
    print_rules(host, repeats);
    print_fields(host, repeats);
    print_hands(host, repeats);
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "effects: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
