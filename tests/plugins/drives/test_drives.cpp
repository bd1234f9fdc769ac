// Every drive against the closed form of its law, with physics.
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "drives/support.h"

using namespace elsie;
using namespace elsie::test;

namespace {

const std::string kAll[] = {"articulated",   "car",
                            "differential",  "front_rear_steering",
                            "mecanum",       "omnidirectional",
                            "rear_steering", "skid_steer",
                            "synchro",       "tricycle"};

/// Tyres that glide sideways pull at each other, and creep by up to a millimetre a second
/// (physics/@wheel_slip). It counts less in a fast turn.
double pace(const std::string& drive) { return drive == "skid_steer" ? 2.0 : 1.0; }

/// A little more than between the middle of a skid-steered robot and its axles, m. All tyres of an
/// axle glide the same way with all the friction that they have, so that it turns about a point of
/// one axle.
constexpr double kGlide = 0.03;

}  // namespace

TEST_CASE("Every drive goes straight as far as it is asked to") {
  INFO(each_engine());
  for (const std::string& name : kAll) {
    for (const double speed : {0.2, -0.2}) {
      CAPTURE(name, speed);
      DrivenRobot robot(name);
      robot.run({speed, 0.0, 0.0}, 10.0);
      CHECK(robot.distance == within(2.0, 0.0));
      CHECK(robot.pose().x == within(speed * 10.0, 0.0));
      CHECK(std::abs(robot.pose().y) < 0.02);
      CHECK(std::abs(robot.turned) < 0.02);
      CHECK(robot.lowest > std::cos(radians(3.0)));
    }
  }
}

TEST_CASE("Every drive but the synchronous one follows an arc of half a metre") {
  INFO(each_engine());
  for (const std::string& name : kAll) {
    if (name == "synchro") continue;
    for (const double turn : {0.4, -0.4}) {
      CAPTURE(name, turn);
      DrivenRobot robot(name);
      const double times = pace(name);
      const Motion made = robot.settled({times * 0.2, 0.0, times * turn}, 10.0 / times);
      CHECK(robot.possible.turn == within(times * turn));
      CHECK(robot.possible.forward == within(times * 0.2));
      CHECK(robot.turned == within(turn * 10.0, 0.0));
      CHECK(made.forward == within(robot.possible.forward));
      const double glide = name == "skid_steer" ? times * std::abs(turn) * kGlide : 0.0;
      CHECK(made.lateral == within(robot.possible.lateral, 2e-3 + glide));
      // The middle of a car is not on its rear axle, so its circle is a little wider.
      const double speed = std::hypot(robot.possible.forward, robot.possible.lateral);
      CHECK(robot.distance / std::abs(robot.turned) == within(speed / std::abs(times * turn), 0.0));
      CHECK(robot.lowest > std::cos(radians(3.0)));
    }
  }
}

TEST_CASE("Odometry is what the body does") {
  INFO(each_engine());
  for (const std::string& name : kAll) {
    CAPTURE(name);
    DrivenRobot robot(name);
    const double times = pace(name);
    const Motion made = robot.settled({times * 0.15, 0.1, times * 0.3});
    const Motion measured = robot.odometry();
    CHECK(measured.turn == within(robot.possible.turn));
    if (name == "synchro") continue;  // its heading is not the body's
    CHECK(made.forward == within(measured.forward, 2e-3));
    CHECK(made.lateral ==
          within(measured.lateral, name == "skid_steer" ? kGlide * measured.turn + 2e-3 : 2e-3));
    CHECK(made.turn == within(measured.turn, 5e-3));
  }
}

TEST_CASE("No rim is faster than the maximum speed, and a slower curve is the same curve") {
  INFO(each_engine());
  for (const std::string& name : kAll) {
    CAPTURE(name);
    DrivenRobot robot(name);
    robot.max_speed = 0.1;
    robot.settled({1.0, 0.0, 0.5}, 1.0);
    for (std::size_t i = 0; i < robot.wanted.size(); ++i) {
      CHECK(std::abs(robot.wanted[i].rate_rad_s) * 0.02 <= 0.1 + 1e-12);
    }
    // Where wheels roll at an angle to the way, the body is faster than their rims.
    CHECK(robot.possible.forward <
          (name == "omnidirectional" ? 0.1 / std::cos(radians(30)) : 0.1) + 1e-12);
    if (name != "synchro") {
      CHECK(robot.possible.turn / robot.possible.forward == Approx(0.5));
    }
  }
}

TEST_CASE("Mecanum and omnidirectional wheels move a body sideways, slantwise and round") {
  INFO(each_engine());
  for (const std::string name : {"mecanum", "omnidirectional"}) {
    CAPTURE(name);
    DrivenRobot robot(name);
    CHECK(robot.drive->channels() == Channels{true, true, true});
    const Motion left = robot.settled({0.0, 0.15, 0.0});
    CHECK(left.lateral == within(0.15));
    CHECK(left.forward == within(0.0, 5e-3));
    CHECK(robot.turned == within(0.0, 0.05));
    const Motion aslant = robot.settled({0.1, -0.1, 0.0});
    CHECK(aslant.forward == within(0.1, 2e-3));
    CHECK(aslant.lateral == within(-0.1, 2e-3));
    robot.settled({0.0, 0.0, 1.0});
    CHECK(robot.turned == within(5.0));
    CHECK(robot.distance < 0.05);
  }
}

TEST_CASE("A tricycle has the speed and turn rate that follow from its front wheel") {
  INFO(each_engine());
  DrivenRobot robot("tricycle", {{"wheelbase", 0.1}});
  robot.settled({0.1, 0.0, 1.0}, 3.0);
  // v = u cos f, w = u sin f / l.
  const double f = robot.wanted[0].angle_rad, u = 0.02 * robot.wanted[0].rate_rad_s;
  CHECK(u * std::cos(f) == Approx(0.1));
  CHECK(u * std::sin(f) / 0.1 == Approx(1.0));
  CHECK(robot.turned == within(3.0));
}

TEST_CASE("The axles of a car's wheels meet in one point") {
  INFO(each_engine());
  DrivenRobot robot("car", {{"wheelbase", 0.1}});
  robot.settled({0.1, 0.0, 0.5}, 1.0);
  const double left = robot.wanted[0].angle_rad, right = robot.wanted[1].angle_rad;
  // Ackermann: cot(outer) - cot(inner) = track / wheelbase.
  CHECK(1.0 / std::tan(right) - 1.0 / std::tan(left) == Approx(0.09 / 0.1));
  CHECK(left > right);
}

TEST_CASE("What cannot turn in place drives the tightest curve instead") {
  INFO(each_engine());
  for (const std::string name :
       {"articulated", "car", "front_rear_steering", "rear_steering", "tricycle"}) {
    for (const double turn : {1.0, -1.0}) {
      CAPTURE(name, turn);
      DrivenRobot robot(name);
      robot.settled({0.0, 0.0, turn}, 3.0);
      CHECK(robot.possible.forward > 0.0);
      CHECK(robot.possible.turn * turn > 0.0);
      CHECK(robot.turned == within(3.0 * robot.possible.turn, 0.05));
    }
  }
}

TEST_CASE("A steering takes its time") {
  INFO(each_engine());
  DrivenRobot robot("car", {{"steer_rate_deg_s", 10.0}, {"max_steer_deg", 40.0}});
  robot.run({0.05, 0.0, 2.0}, 1.0);
  const auto joints = robot.engine->joints(0);
  CHECK(degrees(std::max(std::abs(joints[0].angle_rad), std::abs(joints[1].angle_rad))) ==
        Approx(10.0).margin(0.3));
}

TEST_CASE("A steering that is there at once, and far, makes its tightest curve") {
  INFO(each_engine());
  for (const std::string name : {"car", "rear_steering", "front_rear_steering", "tricycle"}) {
    for (const double degrees : {40.0, 60.0, 70.0, 80.0}) {
      for (const double turn : {50.0, -50.0}) {
        CAPTURE(name, degrees, turn);
        DrivenRobot robot(name, {{"max_steer_deg", degrees}, {"steer_rate_deg_s", 10000.0}});
        std::vector<JointSetting> wanted(robot.wanted.size());
        const DriveState now{robot.engine->joints(0), 0.5, 0.01};
        const Motion tight = robot.drive->command({0.1, 0.0, turn}, now, wanted);
        CHECK(tight.turn * turn > 0.0);
        const double widest = 1.2 * std::abs(tight.forward / tight.turn);
        const Motion wider =
            robot.drive->command({0.1, 0.0, std::copysign(0.1 / widest, turn)}, now, wanted);
        CHECK(wider.turn / wider.forward == Approx(std::copysign(1.0 / widest, turn)));
      }
    }
  }
}

TEST_CASE("Four-wheel steering turns in half the circle of a car") {
  INFO(each_engine());
  DrivenRobot car("car", {{"wheelbase", 0.1}});
  DrivenRobot both("front_rear_steering", {{"wheelbase", 0.1}});
  car.settled({0.05, 0.0, 100.0}, 1.0);
  both.settled({0.05, 0.0, 100.0}, 1.0);
  const auto radius = [](const DrivenRobot& robot) {
    return robot.possible.forward / robot.possible.turn;
  };
  // From the tightest wheel: r = l / tan(40 degrees) + half the track.
  const double tangent = std::tan(radians(40.0));
  CHECK(radius(car) == Approx(0.1 / tangent + 0.045));
  CHECK(radius(both) == Approx(0.05 / tangent + 0.045));
}

TEST_CASE("The body of a synchro drive keeps its direction while its heading turns") {
  INFO(each_engine());
  DrivenRobot robot("synchro");
  robot.run({0.2, 0.0, 0.5}, 2.0 * std::numbers::pi);
  const Turret turret = robot.drive->turret(robot.engine->joints(0));
  CHECK(turret.angle_rad == within(std::numbers::pi, 0.03));
  CHECK(turret.turn_rad_s == within(0.5));
  CHECK(std::abs(robot.turned) < 0.05);
  // Half a circle of the radius v / w.
  CHECK(robot.distance == within(0.2 * 2.0 * std::numbers::pi, 0.0));
  CHECK(robot.pose().y == within(0.8, 0.0));
  CHECK(std::abs(robot.pose().x) < 0.03);
}

TEST_CASE("The angle of an articulated body follows from its curve") {
  INFO(each_engine());
  DrivenRobot robot("articulated");
  robot.settled({0.1, 0.0, 0.5}, 2.0);
  const double arm = 0.04 + 0.02;
  const double angle = robot.engine->joints(0)[2].angle_rad;
  CHECK(-std::tan(0.5 * angle) / arm == within(5.0));
  CHECK(robot.turned == within(1.0));
}

TEST_CASE("Drives refuse a chassis that they do not fit") {
  INFO(each_engine());
  const auto refusal = [](const std::string& name, const testing::Settings& settings,
                          const Chassis& chassis = {}) {
    try {
      DrivenRobot(name, settings, chassis);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  using Catch::Contains;
  CHECK_THAT(refusal("mecanum", {{"wheelbase", 0.03}}), Contains("inside each other"));
  CHECK_THAT(refusal("car", {{"wheelbase", 0.03}}), Contains("inside each other"));
  CHECK_THAT(refusal("tricycle", {{"wheelbase", 0.001}}), Contains("its wheelbase is 0.001000 m"));
  CHECK_THAT(refusal("synchro", {{"radius", 0.01}}), Contains("inside each other"));
  CHECK_THAT(refusal("omnidirectional", {{"radius", 0.01}}), Contains("inside each other"));
  CHECK_THAT(refusal("skid_steer", {{"wheelbase", 0.2}}), Contains("shorter than its track"));
  CHECK_THAT(refusal("articulated", {{"max_steer_deg", 80.0}}), Contains("halves would touch"));
  CHECK_THAT(refusal("differential", {}, {.half_axle = 0.001}), Contains("inside each other"));
  CHECK(refusal("mecanum", {{"wheelbase", 0.1}}).empty());
}

TEST_CASE("Every drive passes the checker") {
  INFO(each_engine());
  for (const std::string& name : kAll) {
    CAPTURE(name);
    CHECK_THAT(testing::check_plugin(PluginKind::drive, name), testing::finds_nothing());
  }
}
