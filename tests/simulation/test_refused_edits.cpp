// Edits that cannot be made: one sentence, and nothing has changed.
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "lively.h"

using namespace elsie;
using namespace elsie::test;
using simulation::TimedEdit;

TEST_CASE("After a refused edit, measures look at the same world as before") {
  Simulation simulation(lively(), shipped(), {7});
  Simulation undisturbed(lively(), shipped(), {7});
  advance(simulation, 40);
  CHECK_FALSE(refusal(simulation, "robot[+]", "<robot id=\"r9\" x=\"3\"/>").empty());
  advance(simulation, 20);
  advance(undisturbed, 60);
  CHECK(simulation.result().measures.at(0).value == undisturbed.result().measures.at(0).value);
  CHECK(simulation.state_hash() == undisturbed.state_hash());
}

TEST_CASE("A coordinator is asked whether it can do without a behaviour") {
  Simulation simulation =
      of("",
         "<behaviors><wander id=\"low\"/><wander id=\"high\"/></behaviors><coordinator>"
         "<arbiter_subsumption><suppress by=\"high\" of=\"low\"/></arbiter_subsumption>"
         "</coordinator>");
  simulation.step();
  CHECK_THROWS_AS(simulation.edit("robot[r1]/behavior[high]/@remove", "true"),
                  simulation::EditRefused);
  simulation.step();
  simulation.edit("robot[r1]/behavior[+]", "<wander id=\"higher\"/>");
  simulation.step();
}

TEST_CASE("An edit that cannot be made is refused in one sentence, and changes nothing") {
  Simulation simulation(lively(), shipped(), {7});
  advance(simulation, 40);
  const std::uint64_t before = simulation.state_hash();
  const std::size_t events = simulation.events().size();
  const std::string r9 = "<robot id=\"r9\" x=\"";
  const Pose r1 = simulation.robot(0).pose;
  const auto says = [&](const std::string& path, const std::string& value,
                        const std::string& part) {
    const std::string sentence = refusal(simulation, path, value);
    CAPTURE(path, value, sentence);
    CHECK(sentence.starts_with(path + "=" + value + ": "));
    CHECK(sentence.find(part) != std::string::npos);
    CHECK(sentence.find('\n') == std::string::npos);
  };
  says("robot[r7]/@remove", "true", "there is no robot[r7]");
  says("robot[r1]/@remove", "true", "r1");
  says("robot[r1]/@max_sped", "1", "no attribute 'max_sped'; did you mean 'max_speed'?");
  says("robot[r1]", "1", "expected an attribute at its end, as in robot[r1]/@max_speed");
  says("robot[r1]/@max_speed", "0,5", "decimals are written with a point, as in 1.5");
  says("robot[r1]/@max_speed", "-1", "expected a number at least 0 and at most 100 m/s");
  says("robot[r1]/@leader", "yes", "expected true or false");
  says("robot[r1]/behavior[wander]/@speed", "501", "a number at least 0 and at most 500 rad/s");
  says("robot[r1]/behavior[wander]/@sped", "5", "no attribute 'sped'; did you mean 'speed'?");
  says("robot[+]", r9 + "3\"/>", "wall");
  says("robot[+]",
       "<robot id=\"r9\" x=\"" + std::to_string(r1.x) + "\" y=\"" + std::to_string(r1.y) + "\"/>",
       "overlaps the robot 'r1'");
  says("robot[+]", r9 + "-2.5\" y=\"2.5\"/>", "overlaps the box 'mast'");
  says("robot[+]", "<robot id=\"r1\" x=\"2\"/>", "r1");
  says("obstacle[+]",
       "<static_box id=\"block\" length=\"1\" width=\"1\" x=\"" + std::to_string(r1.x) + "\" y=\"" +
           std::to_string(r1.y) + "\"/>",
       "overlaps the robot 'r1'");
  says("arena/@wall_thickness", "-1", "expected a number");
  says("robot[r1]/sensor[+]", "<no_such_sensor/>", "no_such_sensor");
  says("robot[r1]/coordinator", "<no_such_coordinator/>", "no_such_coordinator");
  says("@format", "2", "expected '1'");
  says("physics/@step", "0", "expected a number");
  CHECK(simulation.state_hash() == before);
  CHECK(simulation.events().size() == events);
  // Of several, the ones that could be made are not made either.
  CHECK_THROWS_AS(
      simulation.edit(std::vector<simulation::Edit>{
          {"robot[r2]/@max_speed", "0"}, {"robot[r3]/@remove", "true"}, {"robot[r1]/@x", "99"}}),
      EditRefused);
  CHECK(simulation.robots() == 3);
  CHECK(simulation.state_hash() == before);
  advance(simulation, 260);
  CHECK(simulation.state_hash() == hash_after(300, {}));
}

TEST_CASE("An arena does not shrink into a robot or a box") {
  Simulation simulation = of("", "");
  simulation.edit("robot[r1]/@x", "3");
  const std::uint64_t before = simulation.state_hash();
  CHECK(refusal(simulation, "arena/@length", "6").find("robot 'r1'") != std::string::npos);
  CHECK(simulation.state_hash() == before);
  simulation.edit("arena/@length", "6.5");
  CHECK(simulation.world().arena.length == 6.5);
}

TEST_CASE("A change for later of a world that no file could hold is refused in a sentence") {
  world::World world = lively();
  world.obstacles[0].id = "two words";
  const Simulation simulation(world, shipped());
  const std::string why = why_not([&] {
    simulation.check(std::vector<TimedEdit>{{1.0, {"obstacle[1]/@y", "2"}}});
  });
  CHECK(why.starts_with("at 1 s, obstacle[1]/@y=2: "));
}

TEST_CASE("Observers hear of an edit that was made before another one is refused") {
  struct Counting final : simulation::Observer {
    std::size_t robots = 0;
    void started(const Simulation& run) override { robots = run.robots(); }
    void replaced(const Simulation& run) override { robots = run.robots(); }
    void ended(const Simulation& run) override { CHECK(robots == run.robots()); }
  } counting;
  Simulation simulation(lively(), shipped());
  const std::string r2 = "<static_box length=\"6\" width=\"1\" y=\"1\"/>";
  // Both are due once the long step is over.
  CHECK_THROWS_AS(simulation.run(std::vector<simulation::Observer*>{&counting},
                                 std::vector<TimedEdit>{{0.1, {"physics/@step", "0.1"}},
                                                        {0.15, {"robot[r3]/@remove", "true"}},
                                                        {0.16, {"obstacle[+]", r2}}}),
                  EditRefused);
  CHECK(simulation.robots() == 2);
  CHECK(counting.robots == 2);
}

TEST_CASE("Parameters that were set are set back when the edit is refused") {
  const auto run = [](bool edited) {
    Simulation simulation(lively(), shipped(), {7});
    advance(simulation, 60);
    const Pose r1 = simulation.robot(0).pose;
    if (edited) {
      const std::string block = "<static_box id=\"block\" x=\"" + std::to_string(r1.x) + "\" y=\"" +
                                std::to_string(r1.y) + "\"/>";
      CHECK_THROWS_AS(
          simulation.edit(std::vector<simulation::Edit>{{"robot[r1]/behavior[wander]/@speed", "1"},
                                                        {"robot[r1]/coordinator/@weighted", "true"},
                                                        {"robot[r1]/sensor[ahead]/@error", "0.5"},
                                                        {"obstacle[+]", block}}),
          EditRefused);
    }
    advance(simulation, 200);
    return simulation.state_hash();
  };
  CHECK(run(true) == run(false));
}

TEST_CASE("A refused edit of a drive leaves the drive and its limits") {
  Simulation simulation = of("<arena length=\"6\" width=\"6\"/>",
                             "<drive><mecanum/></drive><behaviors><wander/></behaviors>"
                             "<coordinator><arbiter_suppression/></coordinator>");
  advance(simulation, 300);
  const Pose pose = simulation.robot(0).pose;
  REQUIRE(std::abs(pose.x) > 0.3);
  CHECK_THAT(why_not([&] {
               simulation.edit(std::vector<simulation::Edit>{
                   {"robot[r1]/drive", "<car/>"},
                   {"obstacle[+]", "<static_box id=\"b\" x=\"" + std::to_string(pose.x) +
                                       "\" y=\"" + std::to_string(pose.y) + "\"/>"}});
             }),
             Catch::Contains("'b'"));
  CHECK_NOTHROW(advance(simulation, 100));
}

TEST_CASE("A robot's template is read before the run, and no edit sets it later") {
  Simulation simulation(lively(), shipped(), {7});
  CHECK(refusal(simulation, "robot[r1]/@template", "robots/scout.xml")
            .find("the content of the template is part of the robot since") != std::string::npos);
}
