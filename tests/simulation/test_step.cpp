#include <algorithm>

#include <catch2/catch.hpp>

#include "wheels.h"
#include "world_builder.h"

using namespace elsie;
using namespace elsie::test;
using elsie::test::rates;
using elsie::test::wheels;
using simulation::Simulation;

TEST_CASE("A behaviour perceives the robot's own state, and its command moves the robot") {
  std::vector<Pose> seen;
  ScriptedHost scripted([&](const Perception& now) {
    seen.push_back(now.self().pose);
    CHECK(now.self().id == "r1");
    CHECK(now.team().name == "red");
    CHECK(now.period_s() == Approx(0.01));
    return wheels(10, 10);
  });
  world::World world;
  world.robots.push_back(robot("r1", 1, 2, 90, behavior("scripted")));
  Simulation simulation(world, scripted.host);
  advance(simulation, 500);
  REQUIRE(seen.size() == 500);
  CHECK(seen[0].x == Approx(1).margin(1e-6));
  CHECK(seen[0].y == Approx(2).margin(1e-6));
  const auto view = simulation.robot(0);
  CHECK(view.pose.x == Approx(1).margin(0.01));
  CHECK(view.pose.y == Approx(2 + 5 * 0.2).epsilon(0.01));
  CHECK(view.distance_m == Approx(1.0).epsilon(0.02));
  CHECK(view.moving.forward == Approx(0.2).epsilon(0.01));
  CHECK(view.moving.lateral == Approx(0).margin(0.01));
  CHECK(view.moving.turn == Approx(0).margin(0.01));
}

TEST_CASE("A command is scaled, both wheels alike, to the maximum speed") {
  ScriptedHost scripted([](const Perception&) { return wheels(100, 50); });
  world::World world = one_robot();
  world.robots[0].max_speed = 0.3;
  Simulation simulation(world, scripted.host);
  simulation.step();
  CHECK(rates(simulation.robot(0).asked) == WheelRates{100, 50});
  CHECK(rates(simulation.robot(0).command) == WheelRates{15, 7.5});
}

TEST_CASE("Of a motion that the drive cannot make, it makes the nearest; both can be seen") {
  std::vector<Motion> commanded;
  ScriptedHost scripted([&](const Perception& now) {
    CHECK(now.self().channels == Channels{.forward = true, .lateral = false, .turn = true});
    commanded.push_back(now.self().commanded);
    return Motion{0.2, 0.3, 1.0};
  });
  world::World world = one_robot();
  Simulation simulation(world, scripted.host);
  simulation.step();
  simulation.step();
  CHECK(simulation.robot(0).asked == Motion{0.2, 0.3, 1.0});
  const Motion made = simulation.robot(0).command;
  CHECK(made.forward == Approx(0.2));
  CHECK(made.lateral == 0.0);
  CHECK(made.turn == Approx(1.0));
  CHECK(commanded == std::vector<Motion>{{}, made});
  simulation.reset();
  CHECK(simulation.robot(0).asked == Motion{});
  simulation.step();
  CHECK(commanded.back() == Motion{});
}

TEST_CASE(
    "Sensing and deciding happen once every control period, and the command holds in between") {
  int asked = 0;
  std::vector<double> times;
  ScriptedHost scripted([&](const Perception& now) {
    times.push_back(now.time_s());
    CHECK(now.period_s() == Approx(0.05));
    return wheels(static_cast<double>(++asked), 0);
  });
  world::World world;
  world.physics.control_steps = 5;
  world.robots.push_back(robot("r1", 0, 0, 0, behavior("scripted")));
  Simulation simulation(world, scripted.host);
  for (int i = 0; i < 11; ++i) {
    simulation.step();
    CHECK(rates(simulation.robot(0).command).left == 1 + i / 5);
  }
  REQUIRE(times.size() == 3);
  CHECK(times[1] == Approx(0.05));
  CHECK(times[2] == Approx(0.10));
}

TEST_CASE("All robots decide on the same instant, before any of them moves") {
  std::vector<std::pair<std::string, double>> seen;
  ScriptedHost scripted([&](const Perception& now) {
    REQUIRE(now.team().mates.size() == 1);
    seen.emplace_back(now.self().id, now.team().mates[0].distance_m);
    return wheels(20, 20);
  });
  world::World world;
  world.robots.push_back(robot("a", 0, 0, 180, behavior("scripted")));
  world.robots.push_back(robot("b", 0.3, 0, 0, behavior("scripted")));
  world.robots[0].coverage = world.robots[1].coverage = 5;
  Simulation simulation(world, scripted.host);
  for (int i = 0; i < 50; ++i) {
    seen.clear();
    simulation.step();
    REQUIRE(seen.size() == 2);
    CHECK(seen[0].first == "a");
    CHECK(seen[0].second == seen[1].second);
  }
}

TEST_CASE("Robots of a team are numbered in file order") {
  std::vector<std::string> seen;
  ScriptedHost scripted([&](const Perception& now) {
    for (const TeamMate& mate : now.team().mates) {
      seen.push_back(std::string(now.self().id) + std::to_string(now.self().team_index) + " sees " +
                     std::string(mate.id) + std::to_string(mate.team_index));
    }
    return Motion{};
  });
  world::World world;
  world.robots.push_back(robot("a", 0, 0, 0, behavior("scripted")));
  world.robots.push_back(robot("x", 0, 2, 0, behavior("scripted")));
  world.robots[1].team = "blue";
  world.robots.push_back(robot("b", 3, 0, 0, behavior("scripted")));
  world.robots.push_back(robot("c", 0.3, 0, 0, behavior("scripted")));
  Simulation(world, scripted.host).step();
  CHECK(seen == std::vector<std::string>{"a0 sees c2", "c2 sees a0"});
}

TEST_CASE("A robot perceives those of its team whose coverage reaches it, and its leader") {
  std::vector<std::string> mates;
  std::string leader;
  ScriptedHost scripted([&](const Perception& now) {
    if (now.self().id == "watcher") {
      mates.clear();
      for (const TeamMate& mate : now.team().mates) {
        mates.emplace_back(mate.id);
      }
      const TeamMate* found = now.team().leader();
      leader = found ? std::string(found->id) : "";
      if (found) {
        CHECK(found->distance_m == Approx(0.4));
        CHECK(degrees(found->bearing_rad) == Approx(90));
      }
    }
    return Motion{};
  });
  world::World world;
  world.robots.push_back(robot("watcher", 0, 0, 0, behavior("scripted")));
  world.robots.push_back(robot("leader", 0, 0.4, 0, behavior("scripted")));
  world.robots.back().leader = true;
  world.robots.push_back(robot("mate", 0.3, 0, 0, behavior("scripted")));
  world.robots.push_back(robot("far", -0.6, 0, 0, behavior("scripted")));
  world.robots.push_back(robot("loud", -2, 0, 0, behavior("scripted")));
  world.robots.back().coverage = 2.1;
  world.robots.push_back(robot("quiet", 0, -0.3, 0, behavior("scripted")));
  world.robots.back().coverage = 0.2;
  world.robots.push_back(robot("other", -0.2, 0, 0, behavior("scripted")));
  world.robots.back().team = "blue";
  Simulation(world, scripted.host).step();
  CHECK(mates == std::vector<std::string>{"leader", "mate", "loud"});
  CHECK(leader == "leader");
}

TEST_CASE("Beams read the distance from where they are mounted") {
  double ahead = 0, left = 0;
  ScriptedHost scripted([&](const Perception& now) {
    const auto beams = now.readings<RangeReading>();
    REQUIRE(beams.size() == 2);
    ahead = beams[0]->distance_m;
    left = beams[1]->distance_m;
    return Motion{};
  });
  world::World world;
  world.obstacles.push_back(box("b", world::ObstacleKind::fixed, 0.6, 0));
  world.robots.push_back(robot("r1", 0, 0, 0, behavior("scripted")));
  world.robots[0].sensors.push_back(beam("ahead", 0));
  world.robots[0].sensors.push_back(beam("left", 90, {{"max_range", 8.0}}));
  Simulation(world, scripted.host).step();
  // The box is 0.2 m long and the sensor sits on the front edge, at x = 0.04.
  CHECK(ahead == Approx(0.5 - 0.04).margin(1e-4));
  CHECK(left == Approx(5.0).margin(1e-3));
}

TEST_CASE("A resource is collected at a touch: by its team, or by any when it has none") {
  ScriptedHost scripted([](const Perception&) { return wheels(20, 20); });
  const auto run = [&](const std::string& team) {
    world::World world;
    world.obstacles.push_back(box("gold", world::ObstacleKind::resource, 0.5, 0));
    world.obstacles[0].team = team;
    world.obstacles[0].energy = 700;
    world.robots.push_back(robot("r1", 0, 0, 0, behavior("scripted")));
    world.robots[0].energy = 1000;
    world.limits.time = 3;
    return Simulation(world, scripted.host).run();
  };
  for (const char* team : {"red", ""}) {
    const auto result = run(team);
    CHECK(result.robots[0].collected == 1);
    CHECK(result.robots[0].energy == Approx(1700));
    CHECK(result.robots[0].collisions == 0);
    CHECK(result.robots[0].pose.x > 0.8);
    REQUIRE(result.events.size() == 1);
    CHECK(result.events[0].name() == "collected");
    CHECK(result.events[0].detail() == "gold");
    REQUIRE(result.events[0].as<events::Collected>());
    CHECK(result.events[0].as<events::Collected>()->resource == "gold");
    CHECK_FALSE(result.events[0].as<events::Collision>());
  }
  const auto result = run("blue");
  CHECK(result.robots[0].collected == 0);
  CHECK(result.robots[0].collisions == 1);
  CHECK(result.robots[0].pose.x < 0.4);
  CHECK(result.events[0].name() == "collision");
  CHECK(result.events[0].detail() == "gold");
  REQUIRE(result.events[0].as<events::Collision>());
  CHECK(result.events[0].as<events::Collision>()->with == events::Collision::With::box);
}

TEST_CASE("A touch that lasts is one collision, and both robots of one count it") {
  ScriptedHost scripted(
      [](const Perception& now) { return now.self().id == "ram" ? wheels(20, 20) : Motion{}; });
  world::World world;
  world.robots.push_back(robot("ram", 0, 0, 0, behavior("scripted")));
  world.robots.push_back(robot("ox", 0.3, 0, 90, behavior("scripted")));
  world.limits.time = 1;
  const auto result = Simulation(world, scripted.host).run();
  CHECK(result.robots[0].collisions == 1);
  CHECK(result.robots[1].collisions == 1);
}

TEST_CASE("What a behaviour raises is logged, and perceived at the next step") {
  int seen = 0;
  ScriptedHost scripted([&](const Perception& now) {
    Response response;
    seen += !now.events().empty() && now.events()[0].name == "hello";
    if (now.time_s() == 0.0) {
      response.events.push_back({"hello"});
    }
    return response;
  });
  world::World world = one_robot();
  Simulation simulation(world, scripted.host);
  advance(simulation, 5);
  CHECK(seen == 1);
  REQUIRE(simulation.events().size() == 1);
  CHECK(simulation.events()[0].robot == "r1");
}

TEST_CASE("A moving obstacle goes its way") {
  world::World world;
  world.obstacles.push_back(box("shuttle", world::ObstacleKind::moving, -1, 1));
  world.obstacles[0].waypoints = {{1, 1}};
  world.obstacles[0].speed = 0.5;
  Simulation simulation(world, shipped());
  advance(simulation, 600);
  const auto pose = simulation.obstacle(0);
  REQUIRE(pose);
  CHECK(pose->x == Approx(0).margin(1e-6));  // 3 m of a way of 2 m there and 2 m back
  CHECK(pose->y == Approx(1));
}

TEST_CASE("A beam looks from its own place, in its own direction") {
  std::vector<double> read;
  ScriptedHost scripted([&](const Perception& now) {
    read.clear();
    for (const auto& reading : now.readings<RangeReading>()) {
      read.push_back(reading->distance_m);
    }
    return Motion{};
  });
  world::World world;
  world.obstacles.push_back(box("b", world::ObstacleKind::fixed, 0, 0.6));
  world.robots.push_back(robot("r1", 0, 0, 0, behavior("scripted")));
  world.robots[0].sensors.push_back(beam("down", 0));
  world.robots[0].sensors.back().pitch_deg = -45;
  world.robots[0].sensors.push_back(beam("aside", 90));
  world.robots[0].sensors.back().x = 0.02;
  world.robots[0].sensors.back().y = 0.3;
  world.robots[0].sensors.back().z = 0.05;
  Simulation(world, scripted.host).step();
  REQUIRE(read.size() == 2);
  CHECK(read[0] == Approx(0.09 * std::sqrt(2.0)).margin(1e-3));  // the floor, from the chassis' top
  CHECK(read[1] == Approx(0.2).margin(1e-3));                    // from y = 0.3 to the box at 0.5
}

namespace {

struct BeaconReading {
  static constexpr const char* kind = "beacon";
  bool heard = false;
  double distance_m = 0.0;
};

/// A sensor with a kind of reading of its own, which the core has never heard of.
class Beacon final : public SensorOf<BeaconReading> {
 public:
  BeaconReading sense(const SensorContext& now) override {
    std::vector<NearThing> near;
    now.world->things_within(0.5, near);
    const auto nearest = std::min_element(
        near.begin(), near.end(),
        [](const NearThing& a, const NearThing& b) { return a.distance_m < b.distance_m; });
    return {nearest != near.end(), nearest != near.end() ? nearest->distance_m : 0.0};
  }
};

}  // namespace

TEST_CASE("A sensor of a new kind hears the nearest robot, and its reading reaches the behaviour") {
  BeaconReading heard;
  ScriptedHost scripted([&](const Perception& now) {
    if (now.self().id == "r1") {
      heard = *now.readings<BeaconReading>()[0];
    }
    return Motion{};
  });
  scripted.host.add(
      declare<Beacon>(PluginKind::sensor, "beacon", "For a test", produces<BeaconReading>()));
  world::World world = one_robot();
  world.robots[0].sensors.push_back(beam("b", 0));
  world.robots[0].sensors[0].plugin = "beacon";
  world.robots.push_back(robot("far", 0.45, 0, 0, behavior("scripted")));
  world.robots.push_back(robot("near", 0, 0.3, 0, behavior("scripted")));
  world.robots[2].team = "blue";
  Simulation(world, scripted.host).step();
  CHECK(heard.heard);
  CHECK(heard.distance_m == Approx(0.3));
}

TEST_CASE("Sensors list what can be pushed or gripped, but not what stands") {
  const auto nearest_m = [](world::ObstacleKind kind) {
    BeaconReading heard;
    ScriptedHost scripted([&](const Perception& now) {
      heard = *now.readings<BeaconReading>()[0];
      return Motion{};
    });
    scripted.host.add(
        declare<Beacon>(PluginKind::sensor, "beacon", "For a test", produces<BeaconReading>()));
    world::World world = one_robot();
    world.robots[0].sensors.push_back(beam("b", 0));
    world.robots[0].sensors[0].plugin = "beacon";
    world.obstacles.push_back(box("b", kind, 0.4, 0));
    Simulation(world, scripted.host).step();
    return heard.distance_m;
  };
  CHECK(nearest_m(world::ObstacleKind::dynamic) == Approx(0.4).margin(1e-3));
  CHECK(nearest_m(world::ObstacleKind::fixed) == 0.0);
}
