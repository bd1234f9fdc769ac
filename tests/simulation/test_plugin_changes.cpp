// What a user changes while a world runs: sensors, behaviours, coordinators.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <catch2/catch.hpp>

#include "elsie/render/world_cameras.h"

#include "change_support.h"
#include "wheels.h"

using namespace elsie;
using namespace elsie::test;
using elsie::test::rates;
using elsie::test::wheels;

namespace {

double number_of(const Simulation& simulation, std::size_t sensor = 0) {
  return test::numbers_of(simulation, 0, sensor).at(0);
}

/// Mean and standard deviation of what a sensor reads in so many steps.
std::pair<double, double> spread(Simulation& simulation, int steps) {
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < steps; ++i) {
    simulation.step();
    const double value = number_of(simulation);
    sum += value;
    squares += value * value;
  }
  const double mean = sum / steps;
  return {mean, std::sqrt(std::max(0.0, squares / steps - mean * mean))};
}

/// Counts its steps, and the calls of configured() and equipped().
class Counting final : public Behavior {
 public:
  double low = 1.0;
  double high = 2.0;
  double start = 0.0;

  void configured() override {
    if (low > high) {
      throw std::invalid_argument("low is above high");
    }
    ++times_configured;
  }
  void equipped(const Perception& example) override {
    if (high > 10.0 * static_cast<double>(example.readings<RangeReading>().size())) {
      throw std::invalid_argument("high needs a beam for each 10");
    }
    ++times_equipped;
  }
  void reset(Random&) override { steps = 0; }
  Response respond(const Perception&) override { return wheels(low, 0.1 * ++steps); }

  int steps = 0;
  int times_configured = 0, times_equipped = 0;
};

/// What it takes fits every object but this one, the second time.
class Stubborn final : public Behavior {
 public:
  double value = 1.0;
  bool has_run = false;

  void configured() override {
    if (has_run && value == 2.0) {
      throw std::runtime_error("not now");
    }
  }
  Response respond(const Perception&) override {
    has_run = true;
    return wheels(value, value);
  }
};

struct PluginHost {
  PluginHost() : host(shipped_directory()) {
    host.add(declare<Counting>(PluginKind::behavior, "counting", "Counts",
                               parameter("low", &Counting::low, {.max = 100}),
                               parameter("high", &Counting::high, {.max = 100}),
                               parameter("start", &Counting::start, {.live = false})));
    host.add(declare<Stubborn>(PluginKind::behavior, "stubborn", "Refuses",
                               parameter("value", &Stubborn::value)));
  }
  plugin::Host host;
};

/// A camera, and a resource ahead of its robot.
world::World with_camera() {
  world::World world = one_robot();
  world.obstacles = {box("food", world::ObstacleKind::resource, 1, 0)};
  world::MountedUse eye;
  eye.plugin = "vision";
  eye.id = "eye";
  world.robots[0].sensors = {eye};
  return world;
}

const VisionReading& picture_of(const Simulation& simulation) {
  return *static_cast<const VisionReading*>(simulation.sensor(0, 0).sensor->reading());
}

world::BehaviorUse named(world::BehaviorUse use, const std::string& id) {
  use.id = id;
  return use;
}

}  // namespace

TEST_CASE("The error of a sensor decides how far its readings spread") {
  ScriptedHost scripted([](const Perception&) { return Motion{}; });
  world::World world = one_robot();
  world.robots[0].sensors = {beam("ahead", 0, {{"max_range", 20.0}})};
  Simulation simulation(world, scripted.host);
  const double distance = 5.0 - 0.04;
  const auto [exact, none] = spread(simulation, 50);
  CHECK(exact == Approx(distance).margin(1e-4));
  CHECK(none < 1e-6);
  simulation.edit("robot[r1]/sensor[ahead]/@error_m", "0.05");
  const auto [mean, deviation] = spread(simulation, 4000);
  CHECK(mean == Approx(distance).margin(0.004));
  CHECK(deviation == Approx(0.05).epsilon(0.06));
  const simulation::Edit fraction[] = {{"robot[r1]/sensor[ahead]/@error_m", "0"},
                                       {"robot[r1]/sensor[ahead]/@error", "0.02"}};
  simulation.edit(fraction);
  CHECK(spread(simulation, 4000).second == Approx(0.02 * distance).epsilon(0.06));
  simulation.edit("sensor[ahead]/@error", "0");
  CHECK(spread(simulation, 50).second < 1e-6);
}

TEST_CASE("What a sensor costs may change") {
  ScriptedHost scripted([](const Perception&) { return Motion{}; });
  world::World world = one_robot();
  world.robots[0].sensors = {beam("a", 0), beam("b", 90)};
  Simulation simulation(world, scripted.host);
  advance(simulation, 100);
  CHECK(simulation.robot(0).state->energy == Approx(5000 - 2));
  simulation.edit("robot[r1]/sensor[b]/@energy_cost", "9");
  advance(simulation, 100);
  CHECK(simulation.robot(0).state->energy == Approx(5000 - 2 - 10));
}

TEST_CASE("A behaviour of higher priority wins from the next decision on") {
  world::World world = one_robot(named(behavior("scripted", 2), "first"));
  world.robots[0].behaviors.push_back(
      named(behavior("wander", 1, {{"restlessness", 0.0}}), "second"));
  ScriptedHost scripted([](const Perception&) { return wheels(3, 3); });
  Simulation simulation(world, scripted.host);
  simulation.step();
  CHECK(simulation.robot(0).members[0].trace.share == 1.0);
  simulation.edit("robot[r1]/behavior[second]/@priority", "2.5");
  CHECK(simulation.robot(0).members[1].priority() == 2.5);
  CHECK(simulation.robot(0).members[0].trace.share == 1.0);  // of the last decision, as before
  simulation.step();
  CHECK(simulation.robot(0).members[0].trace.share == 0.0);
  CHECK(simulation.robot(0).members[1].trace.share == 1.0);
  CHECK(rates(simulation.robot(0).command) == WheelRates{10, 10});
  simulation.reset();
  simulation.step();
  CHECK(rates(simulation.robot(0).command) == WheelRates{3, 3});
}

TEST_CASE("Parameters of coordinators, of the elements in them, and of what is nested may change") {
  world::World world = one_robot();
  world::Robot& r1 = world.robots[0];
  r1.behaviors.push_back(behavior("scripted", 3));
  r1.behaviors[1].id = "other";
  r1.coordinator->plugin = "fusion_vector_summation";
  ScriptedHost scripted([](const Perception&) { return wheels(4, 4); });
  {
    Simulation simulation(world, scripted.host);
    simulation.step();
    CHECK(rates(simulation.robot(0).command) == WheelRates{4, 4});
    simulation.edit("robot[r1]/coordinator/@weighted", "true");
    simulation.step();
    CHECK(rates(simulation.robot(0).command) == WheelRates{8, 8});  // (1 x 4 + 3 x 4) / 2
  }
  SECTION("an element in a coordinator's") {
    r1.coordinator->plugin = "arbiter_voting";
    for (const double rate : {4.0, -4.0}) {
      world::ElementUse candidate;
      candidate.element = "candidate";
      candidate.parameters = {{"left", rate}, {"right", rate}};
      r1.coordinator->elements.push_back(candidate);
    }
    Simulation simulation(world, scripted.host);
    simulation.step();
    CHECK(rates(simulation.robot(0).command) == WheelRates{4, 4});
    simulation.edit("robot[r1]/coordinator/candidate[1]/@left", "5");
    simulation.step();
    CHECK(rates(simulation.robot(0).command) == WheelRates{5, 4});
    CHECK_THAT(why_not([&] { simulation.edit("coordinator/candidate[3]/@left", "5"); }),
               Catch::Contains("there is no candidate[3]; they are numbered from 1 to 2"));
    simulation.reset();
    simulation.step();
    CHECK(rates(simulation.robot(0).command) == WheelRates{4, 4});
  }
  SECTION("inside a behaviour that holds others") {
    world::BehaviorUse blend = behavior("blend");
    world::Coordination& inside = blend.inside.emplace_back();
    inside.behaviors = {behavior("wander", 1, {{"restlessness", 0.0}}), behavior("scripted", 0.5)};
    inside.coordinator.emplace();
    inside.coordinator->plugin = inside.coordinator->id = "arbiter_suppression";
    r1.behaviors = {blend};
    Simulation simulation(world, scripted.host);
    simulation.step();
    CHECK(rates(simulation.robot(0).command) == WheelRates{10, 10});
    simulation.edit("robot[r1]/behavior[blend]/behavior[wander]/@speed", "7");
    simulation.step();
    CHECK(rates(simulation.robot(0).command) == WheelRates{7, 7});
    simulation.edit("robot[r1]/behavior[blend]/behavior[scripted]/@priority", "2");
    simulation.step();
    CHECK(rates(simulation.robot(0).command) == WheelRates{4, 4});
    CHECK(events_of(simulation) ==
          std::vector<std::string>{
              "0.01 changed robot[r1]/behavior[blend]/behavior[wander]/@speed=7",
              "0.02 changed robot[r1]/behavior[blend]/behavior[scripted]/@priority=2"});
  }
}

TEST_CASE("What a behaviour remembers of the run outlasts a change of its parameters") {
  PluginHost plugins;
  world::World world = one_robot(behavior("counting"));
  world.robots[0].sensors = {beam("ahead", 0)};
  Simulation simulation(world, plugins.host);
  advance(simulation, 5);
  simulation.edit("robot[r1]/behavior[counting]/@low", "1.5");
  simulation.step();
  const WheelRates now = rates(simulation.robot(0).command);
  CHECK(now.left == 1.5);
  CHECK(now.right == Approx(0.1 * 6));

  // The direction that wander is minded to take, and its random stream.
  Simulation changed(one_robot(behavior("wander", 1, {{"restlessness", 20.0}})), plugins.host);
  Simulation unchanged(one_robot(behavior("wander", 1, {{"restlessness", 20.0}})), plugins.host);
  advance(changed, 50);
  advance(unchanged, 50);
  changed.edit("robot[r1]/behavior[wander]/@speed", "8");
  for (int i = 0; i < 50; ++i) {
    changed.step();
    unchanged.step();
    const WheelRates a = rates(changed.robot(0).command);
    const WheelRates b = rates(unchanged.robot(0).command);
    CHECK(b.left - a.left == Approx(2));
    CHECK(b.right - a.right == Approx(2));
  }
}

TEST_CASE("What a plugin refuses leaves all as it was") {
  PluginHost plugins;
  world::World world = one_robot(behavior("counting"));
  world.robots[0].sensors = {beam("ahead", 0)};
  Simulation simulation(world, plugins.host), untouched(world, plugins.host);
  advance(simulation, 5);
  advance(untouched, 5);
  const std::string low = "robot[r1]/behavior[counting]/@low";
  const std::string high = "robot[r1]/behavior[counting]/@high";
  CHECK(why_not([&] { simulation.edit(low, "3"); }) ==
        low + "=3: behavior 'counting': low is above high");
  CHECK(why_not([&] { simulation.edit(high, "11"); }) ==
        high + "=11: high needs a beam for each 10");
  const simulation::Edit with_another[] = {{"robot[r1]/@max_speed", "0.01"}, {low, "3"}};
  CHECK_FALSE(why_not([&] { simulation.edit(with_another); }).empty());
  CHECK(simulation.state_hash() == untouched.state_hash());
  CHECK(simulation.events().empty());
  advance(simulation, 50);
  advance(untouched, 50);
  CHECK(simulation.state_hash() == untouched.state_hash());
  CHECK(rates(simulation.robot(0).command).left == 1.0);
  // Together they fit.
  const simulation::Edit both[] = {{low, "3"}, {high, "4"}};
  simulation.edit(both);
  simulation.step();
  CHECK(rates(simulation.robot(0).command).left == 3.0);
}

TEST_CASE("An object that refuses what another one took is set back, with all changed before it") {
  PluginHost plugins;
  world::World world = one_robot(behavior("stubborn", 2));
  world.robots[0].behaviors.push_back(behavior("wander", 1, {{"restlessness", 0.0}}));
  Simulation simulation(world, plugins.host);
  simulation.step();
  const simulation::Edit both[] = {{"robot[r1]/behavior[wander]/@speed", "20"},
                                   {"robot[r1]/behavior[stubborn]/@value", "2"}};
  CHECK(why_not([&] { simulation.edit(both); }) ==
        "robot[r1]/behavior[stubborn]/@value=2: behavior 'stubborn': not now");
  simulation.step();
  CHECK(rates(simulation.robot(0).command) == WheelRates{1, 1});
  simulation.edit("robot[r1]/behavior[wander]/@priority", "3");
  simulation.step();
  CHECK(rates(simulation.robot(0).command) == WheelRates{10, 10});
  CHECK(simulation.events().size() == 1);
}

TEST_CASE("Files that a change names are found as those of the world are") {
  world::World world = one_robot(behavior("avoid_obstacle", 1, models("avoid_obstacle")));
  world.file = source_path("worlds/made_up.xml");
  world.robots[0].x = 4.6;
  world.robots[0].sensors = {beam("ahead", 0, {{"max_range", 10.0}})};
  Simulation simulation(world, shipped()), untouched(world, shipped());
  advance(simulation, 1);
  const std::string path = "robot[r1]/behavior[avoid_obstacle]/@left_model";
  CHECK_THAT(why_not([&] { simulation.edit(path, "nowhere.fcl"); }),
             Catch::Contains(path + "=nowhere.fcl: there is no such file; looked"));
  CHECK_THAT(why_not([&] { simulation.edit(path, "maze.xml"); }), Catch::Contains("maze.xml"));
  advance(simulation, 1);
  advance(untouched, 2);
  CHECK(simulation.state_hash() == untouched.state_hash());
  simulation.edit(path, "../fuzzy_models/avoid_obstacle_right.fcl");
  advance(simulation, 1);
  advance(untouched, 1);
  CHECK(rates(simulation.robot(0).command).left < rates(untouched.robot(0).command).left - 1.0);
}

TEST_CASE("A network that is to be trained otherwise is trained again, and says so") {
  world::World world = one_robot(behavior("wander", 1));
  world.robots[0].sensors = {beam("left", 15), beam("right", -15)};
  world.robots[0].behaviors.push_back(behavior("avoid_obstacle", 1, models("avoid_obstacle")));
  world.robots[0].coordinator->plugin = "fusion_neural_network";
  world.robots[0].coordinator->parameters = {
      {"training", source_path("training_sets/two_sensors_two_behaviors.txt")},
      {"presentations", std::int64_t{2000}}};
  Simulation simulation(world, shipped());
  const std::size_t notes = simulation.notes().size(), curves = simulation.result().curves.size();
  simulation.edit("robot[r1]/coordinator/@learning_rate", "0.5");
  CHECK(simulation.notes().size() > notes);
  CHECK(simulation.result().curves.size() == curves + 1);
  simulation.step();
}

TEST_CASE("A camera is not made to look for what no camera can find while a run goes on, either") {
  ScriptedHost scripted([](const Perception&) { return Motion{}; });
  world::World world = with_camera();
  world.obstacles[0].colour = Colour{128, 128, 128};
  world.robots[0].sensors[0].elements = {{"match_colour", {{"colours", "#ffd000"}}, {}, {}, {}}};
  Simulation simulation(world, scripted.host, {.cameras = render::world_cameras});
  simulation.step();
  const std::string path = "robot[r1]/sensor[eye]/match_colour/@colours";
  CHECK_THAT(why_not([&] { simulation.edit(path, ""); }),
             Catch::Contains("match_colour[1]/@colours=: it cannot look for the colour #808080"));
  CHECK(why_not([&] { simulation.edit(path, "#d03030"); }).empty());
  simulation.step();
}

TEST_CASE("A camera may take other pictures from now on, in which it looks for the same colours") {
  ScriptedHost scripted([](const Perception&) { return Motion{}; });
  Simulation simulation(with_camera(), scripted.host, {.cameras = render::world_cameras});
  simulation.step();
  CHECK(picture_of(simulation).width == 100);
  for (const int width : {60, 80}) {
    simulation.edit("robot[r1]/sensor[eye]/@width", std::to_string(width));
    simulation.step();
    CHECK(picture_of(simulation).width == width);
    CHECK(simulation.sensor(0, 0).camera->width == width);
    CHECK(picture_of(simulation).found);
  }
  simulation.edit("robot[r1]/sensor[eye]/@fov_deg", "90");
  simulation.step();
  CHECK(picture_of(simulation).horizontal_fov_rad == Approx(radians(90)));
  CHECK(simulation.sensor(0, 0).camera->horizontal_fov_rad == Approx(radians(90)));
  simulation.reset();
  simulation.step();
  CHECK(picture_of(simulation).width == 100);
}
