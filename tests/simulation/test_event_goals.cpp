// Goals that wait for events, goals of any robot or of a team, and groups of goals.
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/world/reader.h"

#include "world_builder.h"

using namespace elsie;
using namespace elsie::test;
using simulation::Outcome;
using simulation::Simulation;

namespace {

/// A host whose behaviour "scripted" says hello in every control period, on robots of the team red.
const ScriptedHost& greeting() {
  static const ScriptedHost made([](const Perception& now) {
    Response response;
    if (now.team().name == "red") response.events.push_back({"hello"});
    return response;
  });
  return made;
}

/// Two red robots and a blue one, which stand at x = 0, 1 and 2.
world::World of_three(const std::string& goals, double limit_s = 1.0) {
  const auto robot = [](const std::string& id, const std::string& team, int x) {
    return "<robot id='" + id + "' team='" + team + "' x='" + std::to_string(x) +
           "'><behaviors><scripted/></behaviors><coordinator><arbiter_suppression/></coordinator>"
           "</robot>";
  };
  return world::parse_world("<world format='1'><robots>" + robot("r1", "red", 0) +
                                robot("r2", "red", 1) + robot("b1", "blue", 2) +
                                "</robots><goals>" + goals + "</goals><limits time='" +
                                std::to_string(limit_s) + "'/></world>",
                            "goals.xml", greeting().host);
}

simulation::RunResult ended(const std::string& goals) {
  return Simulation(of_three(goals), greeting().host).run();
}

bool succeeds(const std::string& goals) { return ended(goals).outcome == Outcome::success; }

}  // namespace

TEST_CASE("An event goal is reached when the event has been raised often enough") {
  CHECK(ended("<event name='hello'/>").simulated_s == Approx(0.01));
  CHECK(ended("<event name='hello' count='10'/>").simulated_s == Approx(0.05));
  CHECK(ended("<event name='hello' team='red' count='11'/>").simulated_s == Approx(0.06));
  CHECK(ended("<event name='hello' robot='r2' count='10'/>").simulated_s == Approx(0.1));
  CHECK(ended("<event name='hello' count='201'/>").outcome == Outcome::time_limit);
  CHECK(ended("<event name='hello' robot='b1'/>").outcome == Outcome::time_limit);
}

TEST_CASE("An event goal that an edit adds counts from then on, and keeps its count after others") {
  Simulation simulation(of_three("<endure time='0.9'/>"), greeting().host);
  advance(simulation, 10);
  simulation.edit("goal[1]", "<event name='hello' robot='r1' count='10'/>");
  advance(simulation, 5);
  simulation.edit("goal[+1]", "<any><endure time='0.01'/></any>");
  advance(simulation, 4);
  CHECK(simulation.outcome() == Outcome::running);
  simulation.step();
  CHECK(simulation.outcome() == Outcome::success);
  simulation.reset();
  CHECK(simulation.run().simulated_s == Approx(0.9));
}

TEST_CASE("Of several goals that an edit makes of one, the first goes on with its count") {
  Simulation simulation(of_three("<event name='hello' count='20'/>"), greeting().host);
  advance(simulation, 9);
  simulation.edit("goal[1]",
                  "<any><event name='hello' count='30'/><event name='hello' count='10'/></any>");
  advance(simulation, 4);
  CHECK(simulation.outcome() == Outcome::running);
  advance(simulation, 1);
  CHECK(simulation.outcome() == Outcome::success);
}

TEST_CASE("A goal to reach needs somebody who reaches it") {
  Simulation simulation(of_three("<reach x='5' y='5'/>"), greeting().host);
  const std::vector<simulation::Edit> all{
      {"robot[r1]/@remove", "true"}, {"robot[r2]/@remove", "true"}, {"robot[b1]/@remove", "true"}};
  simulation.edit(all);
  advance(simulation, 5);
  CHECK(simulation.outcome() == Outcome::running);
}

TEST_CASE("An event of the simulator counts when robots perceive it") {
  auto world = of_three("<event name='collected' team='red'/>");
  world.obstacles.push_back(box("food", world::ObstacleKind::resource, 0.08, 0));
  const auto result = Simulation(world, greeting().host).run();
  CHECK(result.outcome == Outcome::success);
  REQUIRE_FALSE(result.events.empty());
}

TEST_CASE("A place may be for every robot, for any, or for those of a team") {
  CHECK(succeeds("<reach robot='r2' x='1' y='0'/>"));
  CHECK_FALSE(succeeds("<reach x='1' y='0'/>"));
  CHECK(succeeds("<reach x='1' y='0' radius='1.1'/>"));
  CHECK(succeeds("<reach x='1' y='0' any='true'/>"));
  CHECK_FALSE(succeeds("<reach x='0.5' y='0' any='true'/>"));
  CHECK(succeeds("<reach x='0' y='0' any='true' team='red'/>"));
  CHECK_FALSE(succeeds("<reach x='0' y='0' any='true' team='blue'/>"));
  CHECK(succeeds("<reach x='0.5' y='0' radius='0.6' team='red'/>"));
  CHECK_FALSE(succeeds("<reach x='0.5' y='0' radius='0.6'/>"));
}

TEST_CASE("The robot in whose frame a place is does not have to reach it") {
  CHECK(succeeds("<reach team='red' of='r1' x='1' y='0'/>"));
  CHECK_FALSE(succeeds("<reach of='r1' x='1' y='0'/>"));
  CHECK_FALSE(succeeds("<reach any='true' of='r1' x='0' y='0'/>"));
  CHECK(succeeds("<reach any='true' of='r1' x='2' y='0'/>"));
}

TEST_CASE("Of a group that says any one goal is enough, of one that says all none is missing") {
  const std::string here = "<reach robot='r1' x='0' y='0'/>";
  const std::string there = "<reach robot='r1' x='3' y='0'/>";
  CHECK(succeeds("<any>" + there + here + "</any>"));
  CHECK_FALSE(succeeds("<any>" + there + there + "</any>"));
  CHECK(succeeds("<all>" + here + here + "</all>"));
  CHECK_FALSE(succeeds("<all>" + here + there + "</all>"));
  CHECK(succeeds("<any><all>" + here + there + "</all><all>" + here + "</all></any>"));
  CHECK_FALSE(succeeds("<any>" + here + "</any>" + there));
  CHECK(ended("<all><any><endure time='0.5'/>" + there + "</any>" + here + "</all>").simulated_s ==
        Approx(0.5));
}

TEST_CASE("All goals of a group count, also when one of them is reached") {
  CHECK(ended("<any><endure time='0.01'/><event name='hello' robot='r1' count='5'/></any>"
              "<event name='hello' robot='r1' count='7'/>")
            .simulated_s == Approx(0.07));
  CHECK(ended("<all><endure time='0.2'/><event name='hello' robot='r1' count='5'/></all>")
            .simulated_s == Approx(0.2));
}

TEST_CASE("Goals to keep may be about a team") {
  auto world = of_three("<no_collision team='blue'/><battery team='red'/>", 0.1);
  world.robots[2].energy = 0.0;
  CHECK(Simulation(world, greeting().host).run().outcome == Outcome::success);
  world.robots[1].energy = 0.0;
  CHECK(Simulation(world, greeting().host).run().outcome == Outcome::failure);
}
