// Behaviours made of behaviours.
#include <map>
#include <memory>

#include "support.h"
#include "wheels.h"
#include "world_builder.h"

using namespace elsie;
using namespace elsie::test;
using elsie::test::rates;
using elsie::test::wheels;
using simulation::Simulation;

namespace {

/// A host with the shipped plugins and behaviours by name, with fixed answers.
struct NamedHost {
  NamedHost() : host(shipped_directory()) {}
  NamedHost& add(const std::string& name, Response response, std::optional<CommandSets> sets = {}) {
    host.add(declaration_of(PluginKind::behavior, name, [=] {
      auto made = std::make_unique<testing::MadeUp>();
      made->answer = response;
      made->sets = sets;
      return made;
    }));
    return *this;
  }
  plugin::Host host;
};

world::PluginUse coordinator(const std::string& plugin, Parameters parameters = {}) {
  world::PluginUse use;
  use.plugin = use.id = plugin;
  use.parameters = std::move(parameters);
  return use;
}

world::BehaviorUse blend(const std::string& id, std::vector<world::BehaviorUse> behaviors,
                         world::PluginUse inside) {
  world::BehaviorUse use = behavior("blend");
  use.id = id;
  use.inside.push_back({std::move(behaviors), std::move(inside)});
  return use;
}

/// The robot's command in its first step.
Motion decided(const NamedHost& named, std::vector<world::BehaviorUse> behaviors,
               world::PluginUse coordinator) {
  world::World world;
  world.robots.push_back(robot("r1", 0, 0, 0, behaviors.front()));
  world.robots[0].behaviors = std::move(behaviors);
  world.robots[0].coordinator = std::move(coordinator);
  Simulation simulation(std::move(world), named.host);
  simulation.step();
  return simulation.robot(0).command;
}

CommandSets triangles(double centre, double half_width) {
  return {FuzzySet::triangle(centre, half_width), FuzzySet::triangle(centre, half_width)};
}

}  // namespace

TEST_CASE("A blend is to the outside a behaviour like any other") {
  NamedHost named;
  named.add("a", active(0.2, wheels(4, 8)))
      .add("b", active(0.8, wheels(8, 4)))
      .add("c", active(0.4, wheels(20, 20)));
  // Inside, b decides: the blend is as active as b, more than c.
  check_near(decided(named,
                     {blend("pair", {behavior("a"), behavior("b")},
                            coordinator("arbiter_action_selection")),
                      behavior("c")},
                     coordinator("arbiter_action_selection")),
             wheels(8, 4));
  // The same behaviours twice, in two blends, and blends in blends.
  const auto mean = [](std::vector<world::BehaviorUse> behaviors) {
    return blend("mean", std::move(behaviors), coordinator("fusion_vector_summation"));
  };
  world::BehaviorUse outer = mean({mean({behavior("a"), behavior("b")}), behavior("c")});
  CHECK(rates(decided(named, {outer}, coordinator("arbiter_suppression"))) == WheelRates{13, 13});
}

TEST_CASE("A blend passes its members' sets outwards before defuzzification") {
  NamedHost named;
  named.add("a", wheels(0, 0), triangles(0, 5))
      .add("b", wheels(20, 20), triangles(20, 10))
      .add("c", wheels(8, 8), triangles(8, 4));
  const auto fuzzy = coordinator("fusion_fuzzy");
  const Motion flat = decided(named, {behavior("a"), behavior("b"), behavior("c")}, fuzzy);
  const Motion nested =
      decided(named, {blend("pair", {behavior("a"), behavior("b")}, fuzzy), behavior("c")}, fuzzy);
  check_near(nested, flat);
  // If the pair had been decided first, at (0 x 5 + 20 x 10) / 15 = 13.3, the command would differ.
  NamedHost settled;
  settled.add("pair", wheels(40.0 / 3, 40.0 / 3)).add("c", wheels(8, 8), triangles(8, 4));
  const WheelRates early = rates(decided(settled, {behavior("pair"), behavior("c")}, fuzzy));
  CHECK(std::abs(early.left - rates(flat).left) > 1.0);
}

TEST_CASE("A blend of opposite wishes is rated by both, not by their mean") {
  NamedHost named;
  named.add("left", wheels(-10, 10)).add("right", wheels(10, -10));
  named.add("prefers_right", active(0.2, wheels(10, -10)));
  const auto fusion = coordinator("fusion_interval");
  const Motion command = decided(
      named,
      {blend("either", {behavior("left"), behavior("right")}, fusion), behavior("prefers_right")},
      fusion);
  check_near(command, wheels(10, -10), 0.1);
}

TEST_CASE("Context-dependent blends nest: one is a member of another") {
  NamedHost named;
  named.add("avoid", wheels(-10, 10)).add("go", wheels(20, 20));
  const auto contexts =
      coordinator("fusion_context_blending",
                  {{"model", source_path("tests/plugins/coordinators/contexts.fcl")}});
  world::World world;
  // Inside, avoid and go are blended by the distance ahead; outside, the same input decides how far
  // the blend applies.
  world::BehaviorUse inner = blend("go", {behavior("avoid"), behavior("go")}, contexts);
  world.robots.push_back(robot("r1", 0, 0, 0, inner));
  world.robots[0].behaviors.push_back(behavior("avoid"));
  world.robots[0].coordinator = contexts;
  world.robots[0].sensors.push_back(beam("ahead", 0));
  Simulation simulation(std::move(world), named.host);
  simulation.step();  // nothing within a metre: everything is far
  const auto trace = simulation.robot(0).trace;
  REQUIRE(trace.size() == 4);
  CHECK(trace[0].path == "go");
  CHECK(trace[0].member->trace.weight == 1.0);
  CHECK(trace[2].path == "go/go");
  CHECK(trace[2].member->trace.weight == 1.0);
  CHECK(trace[1].member->trace.weight == 0.0);
  check_near(simulation.robot(0).command, wheels(20, 20));
}

TEST_CASE("A blend with nobody active in it is not active, and wishes nothing") {
  NamedHost named;
  named.add("idle", active(0.0, wheels(10, 10))).add("c", active(0.1, wheels(5, 5)));
  for (const char* outer : {"arbiter_action_selection", "arbiter_voting", "fusion_interval",
                            "fusion_fuzzy", "arbiter_strength", "arbiter_subsumption"}) {
    CAPTURE(outer);
    check_near(
        decided(named, {behavior("c"), blend("b", {behavior("idle")}, coordinator("fusion_fuzzy"))},
                coordinator(outer)),
        wheels(5, 5), 1e-6);
  }
}

namespace {

/// A wish for a forward speed and a turn, with a strength for each.
Response wish(double speed, double turn, double speed_strength, double turn_strength) {
  Response response(wheels(speed - turn, speed + turn));
  response.speed_strength = speed_strength;
  response.turn_strength = turn_strength;
  return response;
}

}  // namespace

TEST_CASE("A blend of those that only steer leaves the speed to others, as they do by themselves") {
  NamedHost named;
  named.add("steers", wish(0, 6, 0, 1))
      .add("brakes", wish(2, 0, 1, 0))
      .add("go", wish(14, 0, 1, 1));
  const auto strength = coordinator("arbiter_strength");
  const auto decided_with = [&](world::BehaviorUse top) {
    top.priority = 2;
    return decided(named, {std::move(top), behavior("go")}, strength);
  };
  for (const char* inside :
       {"arbiter_suppression", "fusion_vector_summation", "arbiter_strength", "fusion_fuzzy"}) {
    CAPTURE(inside);
    check_near(decided_with(behavior("steers")), wheels(8, 20));
    check_near(decided_with(blend("b", {behavior("steers")}, coordinator(inside))), wheels(8, 20));
    check_near(decided_with(blend("b", {behavior("brakes")}, coordinator(inside))), wheels(2, 2));
    // Blends in blends.
    world::BehaviorUse inner = blend("inner", {behavior("steers")}, coordinator(inside));
    check_near(decided_with(blend("b", {inner}, coordinator(inside))), wheels(8, 20));
  }
}

TEST_CASE("The strengths of a blend's channels are the means of its members', by their shares") {
  NamedHost named;
  Response faint = wish(0, 6, 0, 1);
  faint.strength = 0.5;
  named.add("faint", faint).add("firm", wish(6, 0, 0.5, 0.25)).add("go", wish(20, 0, 1, 1));
  world::BehaviorUse pair =
      blend("pair", {behavior("faint"), behavior("firm")}, coordinator("fusion_vector_summation"));
  pair.priority = 2;
  // Half of each: speed 3 with (0.5 x 0 + 1 x 0.5) / 2, turn 3 with (0.5 x 1 + 1 x 0.25) / 2.
  const double speed = 0.25 * 3 + 0.75 * 20;
  const double turn = 0.375 * 3 + 0.625 * 0;
  check_near(decided(named, {pair, behavior("go")}, coordinator("arbiter_strength")),
             wheels(speed - turn, speed + turn));
}
