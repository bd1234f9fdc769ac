// A robot by itself, before a run.
#include <memory>
#include <stdexcept>
#include <string>

#include <catch2/catch.hpp>

#include "elsie/plugin/error.h"
#include "elsie/simulation/equipped_robot.h"
#include "elsie/world/error.h"

#include "world_builder.h"

using namespace elsie;
using namespace elsie::test;
using simulation::EquippedRobot;
using simulation::Simulation;

namespace {

/// What a coordinator saw when it was equipped.
struct Seen {
  OwnState self;
  std::string team;
  std::optional<Vector2> charger;
  std::vector<double> beams;  // azimuths of their mountings, rad
  std::vector<std::string> members;
  int resets = 0;
};

class Witness final : public Coordinator {
 public:
  explicit Witness(std::shared_ptr<Seen> seen) : seen_(std::move(seen)) {}
  void equipped(std::span<const Member> members, const Perception& example) override {
    *seen_ = {example.self(), std::string(example.team().name), example.team().charger, {}, {}, 0};
    for (const auto& beam : example.readings<RangeReading>()) {
      seen_->beams.push_back(beam.azimuth_rad());
    }
    for (const Member& member : members) {
      seen_->members.emplace_back(member.name());
    }
    if (seen_->beams.size() > 2) {
      throw std::invalid_argument("two beams are enough");
    }
  }
  void reset(Random&) override { ++seen_->resets; }
  Motion coordinate(std::span<Member>, const Perception&) override { return {}; }

 private:
  std::shared_ptr<Seen> seen_;
};

struct WitnessHost : ScriptedHost {
  WitnessHost() : ScriptedHost([](const Perception&) { return Response(); }) {
    host.add(declaration_of(PluginKind::coordinator, "witness",
                            [seen = seen] { return std::make_unique<Witness>(seen); }));
  }
  std::shared_ptr<Seen> seen = std::make_shared<Seen>();
};

/// The third of these robots is the one to look at.
world::World odd_world() {
  world::World world;
  world.robots = {robot("a", 0, 1, 0, behavior("wander")), robot("b", 0, 2, 0, behavior("wander")),
                  robot("odd", 1, 0, 0, behavior("scripted"))};
  world.robots[1].team = "blue";
  world::Robot& odd = world.robots[2];
  odd.body.wheel_radius = 0.03;
  odd.body.length = 0.2;
  odd.battery = 800;
  odd.coverage = 2;
  odd.leader = true;
  odd.max_speed = 0.3;
  odd.sensors = {beam("left", 30), beam("right", -40)};
  odd.coordinator->plugin = odd.coordinator->id = "witness";
  world.chargers.resize(2);
  world.chargers[0].x = 4;
  world.chargers[1].x = 2;
  return world;
}

}  // namespace

TEST_CASE("A robot by itself is equipped as in a simulation, and not reset") {
  const WitnessHost witness;
  const world::World world = odd_world();
  const EquippedRobot by_itself(world, 2, witness.host);
  const Seen alone = *witness.seen;
  CHECK(alone.resets == 0);
  const Simulation simulation(world, witness.host);
  const Seen& running = *witness.seen;
  CHECK(running.resets == 1);

  CHECK(alone.self.wheels.radius == 0.03);
  CHECK(alone.self.wheels.half_axle == running.self.wheels.half_axle);
  CHECK(alone.self.length_m == 0.2);
  CHECK(alone.self.capacity == 800);
  CHECK(alone.self.coverage_m == 2);
  CHECK(alone.self.max_speed_m_s == 0.3);
  CHECK(alone.self.is_leader);
  CHECK(alone.self.team_index == 1);  // the second of the red team
  CHECK(running.self.team_index == 1);
  CHECK(alone.team == "red");
  REQUIRE(alone.charger);
  CHECK(alone.charger->x == 2);
  CHECK(running.charger->x == 2);
  CHECK(alone.beams == std::vector<double>{radians(30), radians(-40)});
  CHECK(alone.beams == running.beams);
  CHECK(alone.members == std::vector<std::string>{"scripted"});
}

TEST_CASE("The objects of a robot by itself are those that its description names") {
  const WitnessHost witness;
  const world::World world = odd_world();
  EquippedRobot robot(world, 2, witness.host);
  const world::Robot& odd = world.robots[2];
  CHECK(dynamic_cast<Witness*>(&robot.object(*odd.coordinator)) != nullptr);
  CHECK(dynamic_cast<Scripted*>(&robot.object(odd.behaviors[0])) != nullptr);
  CHECK(dynamic_cast<Sensor*>(&robot.object(odd.sensors[1])) != nullptr);
  CHECK_THROWS_WITH(robot.object(world.robots[0].behaviors[0]),
                    "the plugin 'wander' is not part of the robot 'odd'");
}

TEST_CASE("A robot that a plugin refuses is refused by itself, too, and the plugin named once") {
  const WitnessHost witness;
  world::World world = odd_world();
  world.robots[2].sensors.push_back(beam("middle", 0));
  CHECK_THROWS_WITH(EquippedRobot(world, 2, witness.host),
                    Catch::EndsWith("plugin 'witness': two beams are enough"));
  world.robots[2].sensors[0].parameters["max_range"] = -1.0;
  world.robots[2].sensors.pop_back();
  const auto message = [&] {
    try {
      EquippedRobot(world, 2, witness.host);
    } catch (const world::WorldError& error) {
      return error.problems().at(0).message;
    }
    return std::string();
  }();
  CHECK_THAT(message, Catch::StartsWith("sensor 'beam_range': max_range is -1"));
  CHECK(message.find("beam_range") == message.rfind("beam_range"));
}
