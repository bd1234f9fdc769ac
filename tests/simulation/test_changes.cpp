// What a user changes while a world runs: robots.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "elsie/world/parts.h"

#include "change_support.h"
#include "wheels.h"

using namespace elsie;
using namespace elsie::test;
using elsie::test::rates;
using elsie::test::wheels;

TEST_CASE("A robot that was put elsewhere is there, at rest, and drives on by the kinematics") {
  ScriptedHost scripted([](const Perception&) { return wheels(10, 14); });
  Simulation simulation = run_of(scripted, {robot("r1", 0, 0, 0, behavior("scripted"))});
  advance(simulation, 100);
  const double driven = simulation.robot(0).distance_m;
  place(simulation, 0, {1.0, -2.0, radians(90)});
  const OwnState& state = *simulation.robot(0).state;
  CHECK(state.pose.x == Approx(1).margin(1e-9));
  CHECK(state.pose.y == Approx(-2).margin(1e-9));
  CHECK(state.pose.heading_rad == Approx(radians(90)).margin(1e-9));
  CHECK(state.moving.forward == Approx(0).margin(1e-9));
  CHECK(state.moving.turn == Approx(0).margin(1e-9));
  CHECK(state.odometry == Motion{});
  CHECK(simulation.robot(0).distance_m == driven);  // it did not drive there

  advance(simulation, 20);  // until it is at speed again
  const Pose start = state.pose;
  CHECK(std::hypot(start.x - 1, start.y + 2) < 0.05);
  const double t = 2.0;
  advance(simulation, 200);
  // v = r (wl + wr) / 2, w = r (wr - wl) / (2 R): an arc of the radius v / w.
  const double v = 0.02 * 12.0, w = 0.02 * 4.0 / 0.09;
  const double from = start.heading_rad, to = from + w * t;
  CHECK(state.pose.x == Approx(start.x + v / w * (std::sin(to) - std::sin(from))).margin(0.005));
  CHECK(state.pose.y == Approx(start.y - v / w * (std::cos(to) - std::cos(from))).margin(0.005));
  CHECK(wrap_angle(state.pose.heading_rad - to) == Approx(0).margin(0.01));
  CHECK(simulation.robot(0).distance_m - driven == Approx(v * (t + 0.2)).margin(0.02));
}

TEST_CASE("One coordinate may be changed by itself; the others stay") {
  ScriptedHost scripted([](const Perception&) { return Motion{}; });
  Simulation simulation = run_of(scripted, {robot("r1", 1, 2, 30, behavior("scripted"))});
  advance(simulation, 10);
  simulation.edit("robot[r1]/@x", "-3");
  simulation.edit("robot[r1]/@heading_deg", "-350");
  const Pose& pose = simulation.robot(0).pose;
  CHECK(pose.x == Approx(-3).margin(1e-9));
  CHECK(pose.y == Approx(2).margin(1e-4));
  CHECK(degrees(pose.heading_rad) == Approx(10).margin(1e-4));
  // From a height it falls.
  simulation.edit("robot[r1]/@z", "0.5");
  CHECK(simulation.sensor_frame(0, 0).origin.z == Approx(0.5 + 0.09).margin(1e-6));
  advance(simulation, 200);
  CHECK(simulation.sensor_frame(0, 0).origin.z == Approx(0.09).margin(1e-3));
}

TEST_CASE("What a robot pulls comes with it, in line behind it") {
  ScriptedHost scripted([](const Perception&) { return wheels(12, 8); });
  world::Robot train = robot("train", 0, 0, 0, behavior("scripted"));
  train.segments = {segment("a"), segment("b"), segment("c")};
  const auto chain = world::couplings(world::plan_of(train.body, {}), train.segments);
  Simulation simulation = run_of(scripted, {train});
  advance(simulation, 200);
  REQUIRE(std::abs(simulation.segment(0, 0).yaw_rad) > 0.05);  // not in line any more
  place(simulation, 0, {2.0, 1.0, radians(120)});
  for (std::size_t i = 0; i < 3; ++i) {
    const auto segment = simulation.segment(0, i);
    CAPTURE(i);
    CHECK(segment.pose.x == Approx(2.0 - chain[i].place * std::cos(radians(120))).margin(1e-9));
    CHECK(segment.pose.y == Approx(1.0 - chain[i].place * std::sin(radians(120))).margin(1e-9));
    CHECK(segment.yaw_rad == Approx(0).margin(1e-9));
  }
}

TEST_CASE("A place that is not free is refused with a sentence, and nothing has changed") {
  ScriptedHost scripted([](const Perception& now) {
    return now.self().id == "pusher" ? wheels(10, 10) : wheels(3, 4);
  });
  world::World world;
  world.robots = {robot("r1", 0, 0, 0, behavior("scripted")),
                  robot("pusher", 2, 2, 0, behavior("scripted"))};
  world.robots[1].segments = {segment("cart")};
  world.obstacles = {box("brick", world::ObstacleKind::fixed, -2, 0),
                     box("crate", world::ObstacleKind::dynamic, 2.2, 2)};
  world.obstacles[1].mass = 0.05;
  world::Charger& post = world.chargers.emplace_back();
  post.id = "post";
  post.x = post.y = -3;
  post.seen_by_range_sensors = true;
  const auto fresh = [&] { return Simulation(world, scripted.host); };
  Simulation simulation = fresh(), other = fresh();
  advance(simulation, 300);
  advance(other, 300);
  const Pose crate = *simulation.obstacle(1);
  REQUIRE(crate.x > 2.3);  // it was pushed
  const Pose pusher = simulation.robot(1).pose;

  const auto refused = [&](double x, double y, const std::string& sentence) {
    const std::uint64_t before = simulation.state_hash();
    const std::size_t events = simulation.events().size();
    CHECK_THAT(why_not([&] { place(simulation, 0, {x, y, 0}); }), Catch::Contains(sentence));
    CHECK(simulation.state_hash() == before);
    CHECK(simulation.events().size() == events);
  };
  refused(5.5, 0,
          "robot[r1]/@x=5.5: that is outside of the arena, which reaches from -5 to 5 in x");
  refused(0, -7, "robot[r1]/@y=-7: that is outside of the arena, which reaches from -5 to 5 in y");
  refused(4.98, 0, "the robot 'r1' reaches 0.02 m into the east wall; expected a free place");
  refused(0, -4.97, "the robot 'r1' reaches 0.02 m into the south wall; expected a free place");
  refused(-2.1, 0.05, "the robot 'r1' overlaps the box 'brick'; expected a free place");
  refused(-3, -3, "the robot 'r1' overlaps the charger 'post'; expected a free place");
  refused(crate.x + 0.1, crate.y, "the robot 'r1' overlaps the box 'crate'");
  refused(pusher.x, pusher.y + 0.04, "the robot 'r1' overlaps the robot 'pusher'");
  refused(pusher.x - 0.15, pusher.y,
          "the robot 'r1' overlaps the segment 'cart' of the robot 'pusher'");
  refused(NAN, 0, "robot[1]/@x=nan: expected a number");
  // Where things stood before there is room now.
  CHECK(why_not([&] { place(other, 0, {2.2, 2.0, 0}); }).empty());

  Simulation never_asked = fresh();
  advance(never_asked, 400);
  advance(simulation, 100);
  CHECK(simulation.state_hash() == never_asked.state_hash());
}

TEST_CASE("What is changed together is judged together") {
  ScriptedHost scripted([](const Perception&) { return Motion{}; });
  Simulation simulation = run_of(scripted, {robot("a", -1, 0, 0, behavior("scripted")),
                                            robot("b", 1, 0, 0, behavior("scripted"))});
  CHECK_THAT(why_not([&] { simulation.edit("robot[a]/@x", "1"); }),
             Catch::Contains("robot[a]/@x=1: the robot 'a' overlaps the robot 'b'"));
  const simulation::Edit swap[] = {{"robot[a]/@x", "1"}, {"robot[b]/@x", "-1"}};
  simulation.edit(swap);
  CHECK(simulation.robot(0).pose.x == Approx(1));
  CHECK(simulation.robot(1).pose.x == Approx(-1));
  // Both to one place.
  CHECK_THAT(why_not([&] { simulation.edit("robot[*]/@x", "0"); }),
             Catch::Contains("the robot 'a' overlaps the robot 'b'"));
  // One wrong value among good ones.
  const simulation::Edit mixed[] = {
      {"robot[a]/@max_speed", "0.1"}, {"robot[b]/@leader", "true"}, {"robot[b]/@max_speed", "x"}};
  CHECK_THAT(why_not([&] { simulation.edit(mixed); }), Catch::Contains("robot[b]/@max_speed=x"));
  CHECK(simulation.robot(0).state->max_speed_m_s == 0.5);
  CHECK_FALSE(simulation.robot(1).state->is_leader);
}

TEST_CASE("A lowered maximum speed scales both wheels alike, at once") {
  ScriptedHost scripted([](const Perception&) { return wheels(100, 50); });
  world::World world;
  world.physics.control_steps = 10;
  world.robots = {robot("r1", 0, 0, 0, behavior("scripted"))};
  Simulation simulation(world, scripted.host);
  advance(simulation, 3);
  CHECK(rates(simulation.robot(0).command) == WheelRates{25, 12.5});
  set(simulation, 0, "max_speed", 0.3);
  CHECK(rates(simulation.robot(0).command) == WheelRates{15, 7.5});  // in mid-period
  advance(simulation, 20);
  CHECK(rates(simulation.robot(0).command) == WheelRates{15, 7.5});
  set(simulation, 0, "max_speed", 1.0);
  CHECK(rates(simulation.robot(0).command) == WheelRates{15, 7.5});  // until it decides again
  advance(simulation, 10);
  CHECK(rates(simulation.robot(0).command) == WheelRates{50, 25});
  set(simulation, 0, "max_speed", 0.0);
  CHECK(rates(simulation.robot(0).command) == WheelRates{0, 0});
}

TEST_CASE("Coverage decides who is in reach") {
  std::vector<std::string> reached;
  ScriptedHost scripted([&](const Perception& now) {
    if (now.self().id == "watcher") {
      reached.clear();
      for (const TeamMate& mate : now.team().mates) {
        reached.emplace_back(mate.id);
      }
    }
    return Motion{};
  });
  Simulation simulation = run_of(scripted, {robot("watcher", 0, 0, 0, behavior("scripted")),
                                            robot("near", 0.4, 0, 0, behavior("scripted")),
                                            robot("far", 0, 1.5, 0, behavior("scripted"))});
  simulation.step();
  CHECK(reached == std::vector<std::string>{"near"});
  set(simulation, 2, "coverage", 2.0);  // that of the one who is to be heard
  simulation.step();
  CHECK(reached == std::vector<std::string>{"near", "far"});
  simulation.edit("robot[*]/@coverage", "0.3");
  simulation.step();
  CHECK(reached.empty());
}

TEST_CASE("Followers turn to whoever has the leader's flag") {
  world::World world;
  const world::Robot follower = robot("follower", 0, 0, 0, behavior("follow_the_leader"));
  world.robots = {follower, robot("north", 0, 2, 0, behavior("scripted")),
                  robot("south", 0, -2, 0, behavior("scripted"))};
  world.robots[1].coverage = world.robots[2].coverage = 5;
  ScriptedHost scripted([](const Perception&) { return Motion{}; });
  Simulation simulation(world, scripted.host);
  simulation.step();
  CHECK(rates(simulation.robot(0).command) == WheelRates{0, 0});  // nobody leads
  set(simulation, 1, "leader", true);
  simulation.step();
  CHECK(rates(simulation.robot(0).command).right ==
        Approx(9.0).epsilon(0.01));  // 0.10 x 90 deg, left
  const simulation::Edit handover[] = {{"robot[north]/@leader", "false"},
                                       {"robot[south]/@leader", "true"}};
  simulation.edit(handover);
  simulation.step();
  CHECK(rates(simulation.robot(0).command).left == Approx(9.0).epsilon(0.02));
  advance(simulation, 2000);
  const Pose& pose = simulation.robot(0).pose;
  CHECK(std::hypot(pose.x, pose.y + 2) < 0.31);
}

TEST_CASE("Energy can be taken and given: an empty robot stops, with power it goes on") {
  ScriptedHost scripted([](const Perception&) { return wheels(10, 10); });
  Simulation simulation = run_of(scripted, {robot("r1", 0, 0, 0, behavior("scripted"))});
  advance(simulation, 10);
  set(simulation, 0, "energy", 0.0);
  CHECK(simulation.robot(0).empty);
  advance(simulation, 10);
  CHECK(rates(simulation.robot(0).command) == WheelRates{0, 0});
  simulation.edit("robot[r1]/@energy", "2500");
  CHECK_FALSE(simulation.robot(0).empty);
  CHECK(simulation.robot(0).state->energy == 2500.0);
  simulation.step();
  CHECK(rates(simulation.robot(0).command) == WheelRates{10, 10});
  CHECK(events_of(simulation) == std::vector<std::string>{"0.1 changed robot[r1]/@energy=0",
                                                          "0.1 battery_empty ",
                                                          "0.2 changed robot[r1]/@energy=2500"});
  CHECK(why_not([&] { set(simulation, 0, "energy", 5001); }) ==
        "robot[r1]/@energy=5001: the battery of the robot 'r1' holds 5000 units; expected no more "
        "than that");
}
