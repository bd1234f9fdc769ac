// Edits among many robots concern those that they lead to, and no others.
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "lively.h"

using namespace elsie;
using namespace elsie::test;

namespace {

std::vector<const world::Robot*> descriptions(const Simulation& simulation) {
  std::vector<const world::Robot*> all;
  for (std::size_t i = 0; i < simulation.robots(); ++i) {
    all.push_back(simulation.robot(i).description);
    CHECK(all.back() == &simulation.world().robots[i]);
  }
  return all;
}

/// A host with a behaviour "counted", which counts its objects.
class CountingHost {
 public:
  CountingHost() : host(shipped_directory()) {
    host.add(declaration_of(PluginKind::behavior, "counted", [this] {
      ++made;
      return std::make_unique<Scripted>(
          std::make_shared<Scripted::Answer>([](const Perception&) { return Response(); }));
    }));
  }

  int made = 0;
  plugin::Host host;
};

/// Robots with a counted behaviour each, and an edit of each that adds another one.
std::string edited_crowd(int robots) {
  std::string crowd, edits;
  for (int i = 1; i <= robots; ++i) {
    const std::string number = std::to_string(i);
    crowd += "<robot id=\"r" + number + "\" x=\"" + std::to_string(0.2 * i) +
             "\"><behaviors><counted/></behaviors><coordinator><arbiter_suppression/>"
             "</coordinator></robot>";
    edits += "<change time=\"" + number + "\" path=\"robot[r" + number +
             "]/behavior[+]\"><counted/></change>";
  }
  return "<world format=\"1\"><robots>" + crowd + "</robots><changes>" + edits +
         "</changes></world>";
}

}  // namespace

TEST_CASE("An edit leaves the descriptions of other robots where they are") {
  Simulation simulation(lively(), shipped(), {7});
  advance(simulation, 5);
  const auto before = descriptions(simulation);
  simulation.edit("robot[r1]/behavior[rest]", "<wander id=\"rest\" restlessness=\"2\"/>");
  auto now = descriptions(simulation);
  CHECK(now[0] != before[0]);
  CHECK(now[1] == before[1]);
  CHECK(now[2] == before[2]);
  simulation.edit("robot[r2]/@remove", "true");
  CHECK(descriptions(simulation) == std::vector<const world::Robot*>{now[0], now[2]});
  CHECK_THROWS_AS(simulation.edit("robot[r3]/body/@mass", "-1"), EditRefused);
  CHECK(descriptions(simulation) == std::vector<const world::Robot*>{now[0], now[2]});
  advance(simulation, 5);
}

TEST_CASE("What is set in place is described, but not in the worlds that others have") {
  const world::World world = lively();
  Simulation simulation(world, shipped(), {7});
  advance(simulation, 5);
  const world::World snapshot = simulation.world();
  const auto before = descriptions(simulation);
  simulation.edit("robot[r2]/@max_speed", "0.1");
  simulation.edit("robot[r1]/sensor[ahead]/@energy_cost", "3");
  simulation.edit("robot[r1]/behavior[rest]/@priority", "0.3");
  simulation.edit("robot[r1]/behavior[rest]/@restlessness", "4");
  const world::World& now = simulation.world();
  CHECK(now.robots[1].max_speed == 0.1);
  CHECK(now.robots[0].sensors[0].energy_cost == 3);
  CHECK(now.robots[0].behaviors[1].priority == 0.3);
  CHECK(now.robots[0].behaviors[1].parameters.at("restlessness") == ParameterValue(4.0));
  CHECK(descriptions(simulation)[2] == before[2]);
  for (const world::World& other : {world, snapshot, simulation.start()}) {
    CHECK(other.robots[1].max_speed == 0.5);
    CHECK(other.robots[0].sensors[0].energy_cost == 1);
    CHECK(other.robots[0].behaviors[1].priority == 0.1);
    CHECK_FALSE(other.robots[0].behaviors[1].parameters.contains("restlessness"));
  }
  CHECK(simulation.has_edits());
  // Nobody shares them any more, so they stay where they are.
  const auto then = descriptions(simulation);
  simulation.edit("robot[r2]/@max_speed", "0.2");
  CHECK(descriptions(simulation) == then);
  CHECK_THROWS_AS(simulation.edit("robot[r2]/@max_speed", "-1"), EditRefused);
  CHECK(now.robots[1].max_speed == 0.2);
  advance(simulation, 5);
  simulation.reset();
  CHECK(simulation.world().robots[1].max_speed == 0.5);
  CHECK_FALSE(simulation.has_edits());
}

TEST_CASE("Each edit makes the objects of the robots that it leads to, and no others") {
  const auto objects = [](int robots) {
    CountingHost counting;
    world::ReadOptions options;
    options.check_plugins = true;
    const world::World world =
        world::parse_world(edited_crowd(robots), "crowd.xml", counting.host, options);
    std::vector<int> counts{counting.made};
    Simulation simulation(world, counting.host, {7});
    simulation.check({});
    counts.push_back(counting.made - counts[0]);
    return counts;
  };
  const std::vector<int> few = objects(4), many = objects(12);
  CHECK(many[0] == 3 * few[0]);
  CHECK(many[1] == 3 * few[1]);
}

TEST_CASE("A robot's energy is no more than its battery holds, whatever else is edited") {
  Simulation simulation = test::of("");
  using Edits = std::vector<simulation::Edit>;
  const auto is_refused = [&](const Edits& edits) {
    return !why_not([&] { simulation.edit(edits); }).empty();
  };
  CHECK(is_refused({{"robot[r1]/@energy", "6000"}}));
  CHECK(is_refused({{"robot[r1]/@energy", "6000"}, {"robot[r1]/@max_speed", "0.1"}}));
  CHECK(is_refused({{"robot[r1]/@energy", "6000"}, {"@name", "other"}}));
  CHECK(is_refused({{"robot[r1]/@battery", "100"}, {"robot[r1]/@energy", "101"}}));
  CHECK(is_refused({{"robot[r1]", "<robot id=\"r1\" battery=\"100\" energy=\"101\"/>"}}));
  CHECK(is_refused({{"physics/@kp", "1"}, {"robot[r1]/@energy", "50"}}));
  CHECK(simulation.robot(0).state->energy == 5000);
  simulation.edit(Edits{{"robot[r1]/@battery", "7000"}, {"robot[r1]/@energy", "6000"}});
  CHECK(simulation.robot(0).state->energy == 6000);
  simulation.edit("robot[r1]/@energy", "6500");
  CHECK(is_refused({{"robot[r1]/@energy", "7001"}}));
  // Its battery may become smaller than what was put into it.
  simulation.edit("robot[r1]/@battery", "80");
  CHECK(simulation.robot(0).state->energy == 80);
  simulation.edit("robot[r1]/@max_speed", "0.2");
  simulation.edit("@name", "other");
  CHECK(simulation.robot(0).state->energy == 80);
}
