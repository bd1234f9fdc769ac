// Robots on drives: what the simulation makes of their commands.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/api/drive.h"
#include "elsie/world/error.h"

#include "world_builder.h"

using namespace elsie;
using namespace elsie::test;
using simulation::Simulation;

namespace {

world::Robot driven(const std::string& drive, double x = 0.0, double y = 0.0) {
  world::Robot made = robot("r1", x, y, 0, behavior("scripted"));
  made.drive.emplace();
  made.drive->plugin = made.drive->id = drive;
  return made;
}

/// Through the wheels of a differential drive, as a behaviour does that thinks in their rates.
Motion by_wheels(const Perception& now, double forward, double turn) {
  const WheelPair& wheels = now.self().wheels;
  return wheels.motion(wheels.wheel_rates({forward, 0.0, turn}));
}

const std::string kAll[] = {"articulated",   "car",
                            "differential",  "front_rear_steering",
                            "mecanum",       "omnidirectional",
                            "rear_steering", "skid_steer",
                            "synchro",       "tricycle"};

class TwoWheels : public Drive {
 public:
  void build(const Chassis& chassis, BodyPlan& plan) override {
    pair_ = {chassis.wheel_radius, half_track(chassis)};
    for (const double side : {1.0, -1.0}) {
      plan.parts.push_back({side > 0 ? "left_wheel" : "right_wheel",
                            PartRole::wheel,
                            Shape::wheel(chassis.wheel_radius, chassis.wheel_width),
                            {.origin = {0.0, side * pair_.half_axle, chassis.wheel_radius}},
                            chassis.wheel_mass,
                            0,
                            WheelJoint{.torque = chassis.wheel_torque}});
    }
    const double radius = 0.4 * chassis.clearance;
    for (const double end : {0.4, -0.4}) {
      plan.parts.push_back({end > 0 ? "front_caster" : "rear_caster",
                            PartRole::caster,
                            Shape::sphere(radius),
                            {.origin = {end * chassis.length, 0.0, radius}},
                            0.02 * chassis.mass,
                            0,
                            CasterJoint{}});
    }
  }
  Motion command(const Motion& asked, const DriveState&, std::span<JointSetting> joints) override {
    const WheelRates rates = pair_.wheel_rates(asked);
    joints[0] = {rates.left};
    joints[1] = {rates.right};
    return asked;
  }
  Motion odometry(std::span<const JointSetting> joints) const override {
    return pair_.motion({joints[0].rate_rad_s, joints[1].rate_rad_s});
  }

 protected:
  virtual double half_track(const Chassis& chassis) const { return chassis.half_axle; }

  WheelPair pair_;
};

/// Gives no number after a while.
class Failing final : public TwoWheels {
 public:
  Motion command(const Motion& asked, const DriveState& now,
                 std::span<JointSetting> joints) override {
    const Motion possible = TwoWheels::command(asked, now, joints);
    if (++count_ == 5) joints[0] = {std::numeric_limits<double>::quiet_NaN()};
    return possible;
  }

 private:
  int count_ = 0;
};

/// Cannot be slow.
class Fast final : public TwoWheels {
  Motion command(const Motion& asked, const DriveState& now,
                 std::span<JointSetting> joints) override {
    if (now.max_speed < 0.1) throw std::runtime_error("too slow");
    return TwoWheels::command(asked, now, joints);
  }
};

/// Notes at which rate its wheels are when it is asked for the first time.
class Noting final : public TwoWheels {
 public:
  static inline std::vector<double> rates;
  Motion command(const Motion& asked, const DriveState& now,
                 std::span<JointSetting> joints) override {
    rates.push_back(now.joints[0].rate_rad_s);
    return TwoWheels::command(asked, now, joints);
  }
};

/// Heeds no maximum speed.
class Racing final : public TwoWheels {};

/// Says that it moves as asked, and moves at half the speed.
class Boasting final : public TwoWheels {
 public:
  Motion command(const Motion& asked, const DriveState& now,
                 std::span<JointSetting> joints) override {
    TwoWheels::command(0.5 * asked, now, joints);
    return asked;
  }
};

/// Has an odometry that is no number, once it drives.
class Lost final : public TwoWheels {
 public:
  Motion odometry(std::span<const JointSetting> joints) const override {
    return joints[0].rate_rad_s > 0.1 ? Motion{std::numeric_limits<double>::infinity()}
                                      : TwoWheels::odometry(joints);
  }
};

class Wider final : public TwoWheels {
  double half_track(const Chassis& chassis) const override { return 2.0 * chassis.half_axle; }
};

}  // namespace

TEST_CASE("A behaviour that thinks in wheel rates drives every body along its arc") {
  for (const std::string& drive : kAll) {
    CAPTURE(drive);
    // At this pace the creep of tyres that glide sideways, up to a millimetre a second, is little.
    ScriptedHost scripted([](const Perception& now) { return by_wheels(now, 0.4, 0.8); });
    world::World world;
    world.robots.push_back(driven(drive));
    Simulation simulation(world, scripted.host);
    advance(simulation, 200);  // until the steering is where it is to be
    const Pose before = simulation.robot(0).pose;
    advance(simulation, 250);
    const auto view = simulation.robot(0);
    CHECK(wrap_angle(view.pose.heading_rad - before.heading_rad) == Approx(2.0).epsilon(0.02));
    for (const Motion& motion : {view.moving, view.state->odometry}) {
      CHECK(motion.forward == Approx(0.4).epsilon(0.03));
      CHECK(motion.turn == Approx(0.8).epsilon(0.03));
    }
    // The chord of an arc of 2 rad with a radius of half a metre, or a little more.
    CHECK(distance(before, view.pose) == Approx(2 * 0.5 * std::sin(1.0)).epsilon(0.03));
  }
}

TEST_CASE("A drive that can move sideways is asked for it, another one leaves it out") {
  const auto sideways = [](const std::string& drive) {
    ScriptedHost scripted([](const Perception&) { return Motion{0.1, 0.1, 0.0}; });
    world::World world;
    world.robots.push_back(driven(drive));
    Simulation simulation(world, scripted.host);
    advance(simulation, 500);
    CHECK(simulation.robot(0).state->channels.lateral == (simulation.robot(0).command.lateral > 0));
    return simulation.robot(0).pose.y;
  };
  CHECK(sideways("mecanum") == Approx(0.5).epsilon(0.05));
  CHECK(sideways("omnidirectional") == Approx(0.5).epsilon(0.05));
  CHECK(sideways("differential") == Approx(0.0).margin(0.005));
}

TEST_CASE("Every drive runs the same way after a reset") {
  for (const std::string& drive : kAll) {
    CAPTURE(drive);
    ScriptedHost scripted([](const Perception& now) {
      return Motion{0.2, 0.0, 2.0 * std::sin(3.0 * now.time_s())};
    });
    world::World world;
    world.robots.push_back(driven(drive));
    Simulation simulation(world, scripted.host);
    for (int i = 0; i < 300; ++i) simulation.step();
    const auto hash = simulation.state_hash();
    simulation.reset();
    for (int i = 0; i < 300; ++i) simulation.step();
    CHECK(simulation.state_hash() == hash);
  }
}

TEST_CASE("Segments hang behind the last vehicle of a drive") {
  ScriptedHost scripted([](const Perception&) { return Motion{0.1, 0.0, 0.2}; });
  world::World world;
  world.robots.push_back(driven("articulated"));
  world.robots[0].segments.emplace_back().id = "wagon";
  Simulation simulation(world, scripted.host);
  REQUIRE(simulation.segments(0) == 2);
  CHECK(simulation.segment(0, 0).description == nullptr);
  REQUIRE(simulation.segment(0, 1).description);
  CHECK(simulation.segment(0, 1).description->id == "wagon");
  const Pose rear = simulation.segment(0, 0).pose, wagon = simulation.segment(0, 1).pose;
  CHECK(rear.x == Approx(-0.12));  // two halves of 0.08 m, and the gap of 0.04 m
  CHECK(wagon.x < rear.x - 0.1);
  advance(simulation, 500);
  CHECK(simulation.robot(0).distance_m > 0.45);
}

TEST_CASE("The drive that fails is named, and what is wrong with its answer") {
  ScriptedHost scripted([](const Perception&) { return Motion{0.8, 0.0, 0.0}; });
  scripted.host.add(declare<Failing>(PluginKind::drive, "failing", "For a test"));
  scripted.host.add(declare<Racing>(PluginKind::drive, "racing", "For a test"));
  scripted.host.add(declare<Boasting>(PluginKind::drive, "boasting", "For a test"));
  scripted.host.add(declare<Lost>(PluginKind::drive, "lost", "For a test"));
  const auto run = [&](const std::string& drive, double max_speed) {
    world::World world;
    world.robots.push_back(driven(drive));
    world.robots[0].max_speed = max_speed;
    Simulation simulation(world, scripted.host);
    advance(simulation, 20);
  };
  for (const auto& [drive, max_speed, problem] :
       {std::tuple("failing", 1.0, "command() gives numbers that are not finite"),
        std::tuple("racing", 0.5, "a wheel rolls at 0.8 m/s, and the most is 0.5 m/s"),
        std::tuple("boasting", 1.0, "is (0.4 m/s, 0 m/s, 0 rad/s), and command() returned (0.8"),
        std::tuple("lost", 1.0, "odometry() of the joints that command() set is (inf m/s")}) {
    CHECK_THROWS_WITH(run(drive, max_speed),
                      Catch::Contains("plugin '" + std::string(drive)) && Catch::Contains(problem));
  }
  CHECK_NOTHROW(run("racing", 1.0));
}

TEST_CASE("A drive that does not fit its chassis is refused when the simulation is made") {
  ScriptedHost scripted([](const Perception&) { return Motion{}; });
  world::World world;
  world.robots.push_back(driven("mecanum"));
  world.robots[0].drive->parameters["wheelbase"] = 0.01;
  CHECK_THROWS_AS(Simulation(world, scripted.host), world::WorldError);
}

TEST_CASE("A drive is replaced while it runs, unless it would build another body") {
  const auto answer = [](const Perception&) { return Motion{0.2, 0.0, 0.0}; };
  ScriptedHost first(answer), same(answer), other(answer);
  first.host.add(declare<TwoWheels>(PluginKind::drive, "pair", "For a test"));
  same.host.add(declare<TwoWheels>(PluginKind::drive, "pair", "For a test"));
  other.host.add(declare<Wider>(PluginKind::drive, "pair", "For a test"));
  world::World world;
  world.robots.push_back(driven("pair"));
  Simulation simulation(world, first.host);
  advance(simulation, 100);
  CHECK_THROWS_WITH(simulation.replace_plugins(other.host),
                    Catch::Contains("robot 'r1', drive: it would build another body now"));
  advance(simulation, 100);
  const auto replaced = simulation.replace_plugins(same.host);
  CHECK(std::any_of(replaced.objects.begin(), replaced.objects.end(),
                    [](const auto& object) { return object.path == "drive"; }));
  advance(simulation, 100);
  CHECK(simulation.robot(0).pose.x == Approx(0.6).epsilon(0.03));
}

TEST_CASE("A drive that takes the place of another begins with its own joints, at rest") {
  ScriptedHost scripted([](const Perception&) { return Motion{0.2, 0.0, 0.0}; });
  scripted.host.add(declare<TwoWheels>(PluginKind::drive, "pair", "For a test"));
  scripted.host.add(declare<Noting>(PluginKind::drive, "noting", "For a test"));
  world::World world;
  world.robots.push_back(driven("pair"));
  Simulation simulation(world, scripted.host);
  advance(simulation, 50);
  Noting::rates.clear();
  simulation.edit("robot[r1]/drive", "<noting/>");
  REQUIRE_FALSE(Noting::rates.empty());
  CHECK(Noting::rates.front() == 0.0);
}

TEST_CASE("A drive that fails at an edit of its robot ends the run, with whatever else is edited") {
  for (const bool is_alone : {true, false}) {
    ScriptedHost scripted([](const Perception&) { return Motion{0.2, 0.0, 0.0}; });
    scripted.host.add(declare<Fast>(PluginKind::drive, "fast", "For a test"));
    world::World world;
    world.robots.push_back(driven("fast"));
    Simulation simulation(world, scripted.host);
    std::vector<simulation::Edit> edits{{"robot[r1]/@max_speed", "0.05"}};
    if (!is_alone) edits.push_back({"@name", "slow"});
    CHECK_THROWS_AS(simulation.edit(edits), simulation::PluginFault);
  }
}
