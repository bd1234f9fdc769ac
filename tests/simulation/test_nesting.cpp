// Behaviours that hold behaviours and a coordinator of their own.
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "wheels.h"
#include "world_builder.h"

using namespace elsie;
using namespace elsie::test;
using elsie::test::rates;
using elsie::test::wheels;
using simulation::Simulation;
using simulation::TracedMember;

namespace {

class Holder final : public Behavior {
 public:
  Coordination* inside = nullptr;
  Response respond(const Perception& now) override {
    Response response = inside->respond(now);
    activations.push_back(response.activation);
    return response;
  }
  CommandSets command_sets(const Perception&, const Response&) const override {
    return inside->command_sets();
  }
  void rate(const Perception&, const Response&, std::span<const Motion> candidates,
            std::span<double> desirability) const override {
    inside->rate(candidates, desirability);
  }
  std::vector<double> activations;
};

/// Asks the first member for its fuzzy sets, after it answered.
class AsksForSets final : public Coordinator {
 public:
  Motion coordinate(std::span<Member> members, const Perception&) override {
    const CommandSets sets = members[0].command_sets();
    members[0].trace.share = 1.0;
    return WheelPair().motion({sets.left.points.at(1).x, sets.right.points.at(1).x});
  }
};

struct NestingHost : ScriptedHost {
  explicit NestingHost(Scripted::Answer answer) : ScriptedHost(std::move(answer)) {
    host.add(declare<Holder>(PluginKind::behavior, "holder", "holds others",
                             holds_behaviors(&Holder::inside)));
    host.add(declaration_of(PluginKind::coordinator, "asks_for_sets",
                            [] { return std::make_unique<AsksForSets>(); }));
  }
};

world::PluginUse coordinator(const std::string& plugin) {
  world::PluginUse use;
  use.plugin = use.id = plugin;
  return use;
}

world::BehaviorUse holder(const std::string& id, std::vector<world::BehaviorUse> behaviors,
                          const std::string& coordinator_plugin = "fusion_vector_summation") {
  world::BehaviorUse use = behavior("holder");
  use.id = id;
  use.inside.push_back({std::move(behaviors), coordinator(coordinator_plugin)});
  return use;
}

world::World world_of(const world::BehaviorUse& only) {
  world::World world = one_robot(only);
  world.limits.time = 0.05;
  return world;
}

}  // namespace

TEST_CASE("A behaviour that holds others drives as their coordinator decides") {
  NestingHost scripted([](const Perception&) { return wheels(4, 8); });
  world::BehaviorUse second = behavior("scripted");
  second.id = "second";
  Simulation simulation(world_of(holder("pair", {behavior("scripted"), second})), scripted.host);
  simulation.step();
  CHECK(rates(simulation.robot(0).command) == WheelRates{4, 8});
}

TEST_CASE("Nesting goes to any depth, and each member is traced below the one that holds it") {
  NestingHost scripted([](const Perception&) { return wheels(4, 8); });
  Simulation simulation(world_of(holder("outer", {holder("inner", {behavior("scripted")})})),
                        scripted.host);
  simulation.step();
  const std::span<const TracedMember> trace = simulation.robot(0).trace;
  REQUIRE(trace.size() == 3);
  CHECK(trace[0].path == "outer");
  CHECK(trace[1].path == "outer/inner");
  CHECK(trace[2].path == "outer/inner/scripted");
  CHECK(trace[2].plugin == "scripted");
  CHECK(trace[0].coordinator == "arbiter_suppression");
  CHECK(trace[2].coordinator == "fusion_vector_summation");
  CHECK((trace[0].parent == -1 && trace[1].parent == 0 && trace[2].parent == 1));
  CHECK(trace[2].depth == 2);
  for (const TracedMember& member : trace) {
    CHECK(member.member->trace.asked);
    CHECK(rates(member.member->trace.command) == WheelRates{4, 8});
  }
}

TEST_CASE("An outer coordinator may ask further once the holder has answered") {
  NestingHost scripted([](const Perception&) { return wheels(4, 8); });
  world::World world = world_of(holder("pair", {behavior("scripted")}, "asks_for_sets"));
  world.robots[0].coordinator = coordinator("asks_for_sets");
  Simulation simulation(std::move(world), scripted.host);
  simulation.step();
  CHECK(rates(simulation.robot(0).command) == WheelRates{4, 8});
}

TEST_CASE("Members inside draw from streams of their own, named by where they stand") {
  std::vector<double> drawn;
  NestingHost scripted([&](const Perception& now) {
    drawn.push_back(now.random().uniform(0, 1));
    return wheels(1, 1);
  });
  const auto draws_of = [&](const world::BehaviorUse& only) {
    drawn.clear();
    Simulation(world_of(only), scripted.host, {.seed = 3}).run();
    return drawn;
  };
  const auto alone = draws_of(behavior("scripted"));
  const auto inside = draws_of(holder("a", {behavior("scripted")}));
  CHECK(alone.size() == inside.size());
  CHECK(alone != inside);
  CHECK(inside != draws_of(holder("b", {behavior("scripted")})));
  CHECK(inside == draws_of(holder("a", {behavior("scripted")})));
}

TEST_CASE("What a member inside asks of the robot is done") {
  NestingHost scripted([](const Perception&) {
    Response response(wheels(0, 0));
    response.charge = true;
    response.events.push_back({"hello"});
    return response;
  });
  world::World world = world_of(holder("outer", {holder("inner", {behavior("scripted")})}));
  world.robots[0].energy = 100.0;
  world.chargers.emplace_back();
  Simulation simulation(std::move(world), scripted.host);
  simulation.step();
  CHECK(simulation.robot(0).state->charging);
  CHECK(simulation.events()[0].name() == "hello");
}

TEST_CASE("A fault inside names the plugin that failed, not the ones around it") {
  NestingHost scripted([](const Perception&) -> Response { throw std::runtime_error("lost"); });
  Simulation simulation(world_of(holder("outer", {holder("inner", {behavior("scripted")})})),
                        scripted.host);
  CHECK_THROWS_WITH(simulation.step(),
                    "plugin 'scripted' of robot 'r1' failed in step 0 (at 0 s): lost");
}

TEST_CASE("A holder with nothing in it stands still and is not active") {
  NestingHost scripted([](const Perception&) { return wheels(4, 8); });
  Simulation simulation(world_of(behavior("holder")), scripted.host);
  simulation.step();
  CHECK(rates(simulation.robot(0).command) == WheelRates{0, 0});
  CHECK(simulation.robot(0).trace[0].member->trace.activation == 0.0);
}

TEST_CASE("Plugins tell the user how they are prepared, once a run") {
  struct Talker final : Behavior {
    double luck = 0.0;
    void reset(Random& random) override { luck = random.uniform(0, 1); }
    Response respond(const Perception&) override { return Motion{}; }
    std::vector<std::string> notes() const override { return {"luck " + std::to_string(luck)}; }
  };
  NestingHost scripted([](const Perception&) { return Motion{}; });
  scripted.host.add(
      declaration_of(PluginKind::behavior, "talker", [] { return std::make_unique<Talker>(); }));
  Simulation simulation(world_of(holder("outer", {behavior("talker")})), scripted.host);
  REQUIRE(simulation.notes().size() == 1);
  const std::string first = simulation.notes()[0].text;
  CHECK(simulation.notes()[0].robot == "r1");
  CHECK(simulation.notes()[0].plugin == "talker");
  simulation.reset(2);
  REQUIRE(simulation.notes().size() == 1);
  CHECK(simulation.notes()[0].text != first);
  simulation.reset(1);
  CHECK(simulation.run().notes[0].text == first);
}
