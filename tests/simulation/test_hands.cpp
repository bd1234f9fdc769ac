// What robots take, hold, release and deliver.
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/api/actuator.h"
#include "elsie/commands/gripper.h"
#include "elsie/simulation/simulation.h"

#include "lively.h"

using namespace elsie;
using namespace elsie::test;

namespace {

/// Drives straight, and closes its gripper.
class Grips final : public Behavior {
 public:
  bool closed = true;
  double speed = 0.0;
  Response respond(const Perception& now) override {
    Response response(Motion{speed, 0.0, 0.0});
    response.act(GripCommand{closed});
    held = static_cast<double>(now.self().held.size());
    moves = held > 0.0 && now.self().held[0].moves ? 1.0 : 0.0;
    return response;
  }
  double held = 0.0, moves = 0.0;
};

const plugin::Host& gripping() {
  static const plugin::Host made = [] {
    plugin::Host host(shipped_directory());
    host.add(declare<Grips>(PluginKind::behavior, "grips", "closes its gripper",
                            commands<GripCommand>(), parameter("closed", &Grips::closed),
                            parameter("speed", &Grips::speed), publishes("held", &Grips::held),
                            publishes("moves", &Grips::moves)));
    return host;
  }();
  return made;
}

std::string gripper_at(const std::string& id, double x, double y, const std::string& team = "red",
                       const std::string& more = "") {
  return "<robot id=\"" + id + "\" team=\"" + team + "\" x=\"" + std::to_string(x) + "\" y=\"" +
         std::to_string(y) + "\" " + more +
         "><actuators><gripper reach=\"0.05\"/></actuators><behaviors><grips/></behaviors>"
         "<coordinator><arbiter_suppression/></coordinator></robot>";
}

/// A puck before a robot at the origin, or elsewhere.
std::string puck(const std::string& id, double x = 0.09, const std::string& more = "") {
  return "<resource id=\"" + id +
         "\" collect=\"nest\" length=\"0.05\" width=\"0.05\" height=\"0.05\" x=\"" +
         std::to_string(x) + "\" " + more + "/>";
}

std::string world_of(const std::string& robots, const std::string& resources,
                     const std::string& more = "") {
  return "<world format=\"1\"><physics engine=\"" + std::string(GENERATE("ode", "planar")) +
         "\"/><robots>" + robots + "</robots><resources>" + resources + "</resources>" + more +
         "</world>";
}

simulation::Simulation handling(const std::string& world) {
  return {world::parse_world(world, "hands.xml", gripping()), gripping()};
}

void steps(simulation::Simulation& simulation, int count) {
  for (int i = 0; i < count; ++i) simulation.step();
}

/// What robots did, as "robot: name detail", in their order.
std::vector<std::string> deeds(const simulation::Simulation& simulation) {
  std::vector<std::string> all;
  for (const auto& event : simulation.events()) {
    const std::string name = event.name();
    if (name == "taken" || name == "released" || name == "delivered") {
      all.push_back(event.robot + ": " + name + " " + event.detail());
    }
  }
  return all;
}

using Deeds = std::vector<std::string>;

double published(const simulation::Simulation& simulation, const std::string& name) {
  double value = -1.0;
  simulation.visit_published(0, [&](const simulation::PublishedValue& published) {
    if (published.number.name == name) value = published.value;
  });
  return value;
}

}  // namespace

TEST_CASE("A gripper takes the nearest thing within its reach, and carries it") {
  simulation::Simulation simulation =
      handling(world_of(gripper_at("r1", 0, 0), puck("far", 0.16) + puck("near", 0.09)));
  steps(simulation, 2);
  CHECK(deeds(simulation) == Deeds{"r1: taken near"});
  CHECK(published(simulation, "held") == 1.0);
  CHECK(published(simulation, "moves") == 1.0);
  simulation.edit("robot[r1]/behavior[grips]/@speed", "-0.2");
  steps(simulation, 100);
  const double x = simulation.robot(0).pose.x;
  CHECK(x < -0.1);
  CHECK(simulation.obstacle(1)->x - x == Approx(0.09).margin(2e-3));
  CHECK(simulation.obstacle(0)->x == Approx(0.16).margin(1e-3));
  simulation.edit("robot[r1]/behavior[grips]/@closed", "false");
  steps(simulation, 1);
  CHECK(deeds(simulation) == Deeds{"r1: taken near", "r1: released near"});
  steps(simulation, 1);
  CHECK(published(simulation, "held") == 0.0);
  const double put_down = simulation.obstacle(1)->x;
  steps(simulation, 50);
  CHECK(simulation.obstacle(1)->x == Approx(put_down).margin(0.02));
  simulation.reset();
  CHECK(deeds(simulation).empty());
}

TEST_CASE(
    "Nobody takes what is fixed, out of reach, of another team, or in as many hands as it has") {
  const std::string collected = "<resource id=\"p\" length=\"0.05\" width=\"0.05\" x=\"0.09\"/>";
  const auto [robots, things] =
      GENERATE_COPY(std::pair(gripper_at("r1", 0, 0), collected),
                    std::pair(gripper_at("r1", 0, 0), puck("p", 0.2)),
                    std::pair(gripper_at("r1", 0, 0), puck("p", 0.09, "team=\"blue\"")));
  simulation::Simulation simulation = handling(world_of(robots, things));
  steps(simulation, 3);
  CHECK(deeds(simulation).empty());
}

TEST_CASE("Of two robots at one thing, the first of the file has it") {
  simulation::Simulation simulation = handling(world_of(
      gripper_at("b", 0, 0) + gripper_at("a", 0.18, 0, "red", "heading_deg=\"180\""), puck("p")));
  steps(simulation, 3);
  CHECK(deeds(simulation) == Deeds{"b: taken p"});
}

TEST_CASE("What needs two hands moves when two robots hold it") {
  simulation::Simulation simulation = handling(
      world_of(gripper_at("a", 0, 0) + gripper_at("b", 0.18, 0, "red", "heading_deg=\"180\""),
               puck("p", 0.09, "hands=\"2\"")));
  simulation.edit("robot[b]/behavior[grips]/@closed", "false");
  simulation.edit("robot[a]/behavior[grips]/@speed", "-0.1");
  steps(simulation, 50);
  CHECK(deeds(simulation) == Deeds{"a: taken p"});
  CHECK(published(simulation, "moves") == 0.0);
  CHECK(simulation.robot(0).pose.x == Approx(0.0).margin(2e-3));
  simulation.edit("robot[b]/behavior[grips]/@closed", "true");
  simulation.edit("robot[b]/behavior[grips]/@speed", "0.1");
  steps(simulation, 100);
  CHECK(published(simulation, "moves") == 1.0);
  CHECK(simulation.obstacle(0)->x < 0.02);
}

TEST_CASE("What needs two hands stands still when both robots are gone") {
  simulation::Simulation simulation = handling(
      world_of(gripper_at("a", 0, 0) + gripper_at("b", 0.18, 0, "red", "heading_deg=\"180\""),
               puck("p", 0.09, "hands=\"2\"")));
  simulation.edit("robot[a]/behavior[grips]/@speed", "-0.1");
  simulation.edit("robot[b]/behavior[grips]/@speed", "0.1");
  steps(simulation, 100);
  const double x = simulation.obstacle(0)->x;
  CHECK(x < 0.02);
  const std::vector<simulation::Edit> both{{"robot[a]/@remove", "true"},
                                           {"robot[b]/@remove", "true"}};
  simulation.edit(both);
  steps(simulation, 100);
  CHECK(simulation.obstacle(0)->x == Approx(x).margin(1e-6));
}

TEST_CASE("What needs two hands is delivered only by two") {
  const bool is_helped = GENERATE(false, true);
  simulation::Simulation simulation = handling(
      world_of(gripper_at("a", 0, 0) + gripper_at("b", 0.18, 0, "red", "heading_deg=\"180\""),
               puck("p", 0.09, "hands=\"2\""), "<nests><nest radius=\"0.3\"/></nests>"));
  if (!is_helped) simulation.edit("robot[b]/behavior[grips]/@closed", "false");
  steps(simulation, 5);
  simulation.edit("robot[b]/behavior[grips]/@closed", "false");
  steps(simulation, 5);
  CHECK(simulation.obstacle(0));  // still in a hand
  simulation.edit("robot[a]/behavior[grips]/@closed", "false");
  steps(simulation, 1);
  CHECK(deeds(simulation).back() == (is_helped ? "a: delivered p" : "a: released p"));
  CHECK(bool(simulation.obstacle(0)) != is_helped);
}

TEST_CASE("What a robot releases in a nest of its team is delivered") {
  const std::string nest =
      R"(<nests><nest team="red" x="0" y="0" radius="0.3"/></nests><goals><deliver/></goals>)";
  const std::string team = GENERATE("red", "blue");
  simulation::Simulation simulation =
      handling(world_of(gripper_at("r1", 0, 0, team, "battery=\"5000\" energy=\"1000\""),
                        puck("p", 0.09, "energy=\"500\""), nest));
  steps(simulation, 2);
  CHECK(simulation.obstacle(0));  // it is in a nest, but nobody has released it there
  const double energy = simulation.robot(0).state->energy;
  simulation.edit("robot[r1]/behavior[grips]/@closed", "false");
  steps(simulation, 1);
  if (team == "blue") {
    CHECK(deeds(simulation) == Deeds{"r1: taken p", "r1: released p"});
    CHECK(simulation.obstacle(0));
    CHECK(simulation.outcome() == simulation::Outcome::running);
    return;
  }
  CHECK(deeds(simulation) == Deeds{"r1: taken p", "r1: released p", "r1: delivered p"});
  CHECK_FALSE(simulation.obstacle(0));
  CHECK(simulation.outcome() == simulation::Outcome::success);
  CHECK(simulation.result().robots[0].collected == 1);
  CHECK(simulation.robot(0).state->energy == Approx(energy + 500.0).margin(1.0));
}

TEST_CASE("To touch a resource for the nest is no collision, and does not collect it") {
  simulation::Simulation simulation = handling(world_of(gripper_at("r1", 0, 0), puck("p", 0.2)));
  simulation.edit("robot[r1]/behavior[grips]/@closed", "false");
  simulation.edit("robot[r1]/behavior[grips]/@speed", "0.2");
  steps(simulation, 150);
  CHECK(simulation.obstacle(0)->x > 0.25);  // pushed
  CHECK(simulation.robot(0).collisions == 0);
}

TEST_CASE("A robot without energy lets go") {
  simulation::Simulation simulation = handling(
      world_of(gripper_at("r1", 0, 0, "red", "battery=\"100\" energy=\"0.05\""), puck("p")));
  steps(simulation, 20);
  CHECK(deeds(simulation) == Deeds{"r1: taken p", "r1: released p"});
}

TEST_CASE("What is held stays in the hand through edits that leave both where they are") {
  simulation::Simulation simulation =
      handling(world_of(gripper_at("r0", 3, 3) + gripper_at("r1", 0, 0), puck("p")));
  steps(simulation, 2);
  const auto drive = [&] {
    simulation.edit("robot[r1]/behavior[grips]/@speed", "-0.2");
    steps(simulation, 50);
    return simulation.obstacle(0)->x < 0.05;
  };
  SECTION("a new engine") {
    simulation.edit("physics/@friction", "0.4");
    CHECK(drive());
  }
  SECTION("another robot is removed") {
    simulation.edit("robot[r0]/@remove", "true");
    CHECK(drive());
  }
  SECTION("the robot is placed elsewhere") {
    simulation.edit("robot[r1]/@x", "1");
    CHECK_FALSE(drive());
    CHECK(deeds(simulation).back() == "r1: released p");
  }
  SECTION("the robot is only turned") {
    simulation.edit("robot[r1]/@heading_deg", "5");
    CHECK(deeds(simulation).back() == "r1: released p");
  }
  SECTION("the thing is only turned") {
    simulation.edit("resource[p]/@heading_deg", "90");
    CHECK(deeds(simulation).back() == "r1: released p");
    steps(simulation, 5);  // it takes it again
    CHECK(std::abs(simulation.robot(0).moving.turn) < 0.01);
  }
  SECTION("its actuator is removed") {
    simulation.edit("robot[r1]/actuator[+]", R"(<gripper id="rear" x="-0.04"/>)");
    simulation.edit("robot[r1]/actuator[gripper]/@remove", "true");
    CHECK_FALSE(drive());
  }
  SECTION("the robot is removed") {
    simulation.edit("robot[r1]/@remove", "true");
    steps(simulation, 5);
    CHECK(simulation.obstacle(0)->x == Approx(0.09).margin(2e-3));
  }
  SECTION("the thing is removed") {
    simulation.edit("resource[p]/@remove", "true");
    steps(simulation, 5);
    CHECK(published(simulation, "held") == 0.0);
  }
}
