// Bug1 and Bug2: what Lumelsky and Stepanov prove of them, in worlds of random convex obstacles.
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/testing/behavior.h"
#include "elsie/testing/expectation.h"
#include "elsie/testing/world.h"

#include "shipped.h"
#include "situation.h"

using namespace elsie;
using elsie::test::Situation;

namespace {

const testing::Plugins& bug_plugins() {
  static const testing::Plugins plugins(plugin::Host(test::shipped_directory()));
  return plugins;
}

constexpr double kBugDistance = 0.3;  // from the middle of the robot to a boundary

/// A robot at the west end that wants to (5, 0), with beams all around the front and the sides.
std::string bug_robot(const std::string& algorithm, const std::string& side, double goal_x = 5.0) {
  std::string beams;
  for (int azimuth = -120; azimuth <= 120; azimuth += 15) {
    beams += "<beam_range id='b" + std::to_string(azimuth + 120) + "' yaw_deg='" +
             std::to_string(azimuth) + "' x='0' y='0' energy_cost='0'/>";
  }
  return "<robots><robot id='r1' team='red' x='-4.5' y='0'><sensors>" + beams +
         "</sensors><behaviors><bug algorithm='" + algorithm + "' side='" + side + "' x='" +
         std::to_string(goal_x) +
         "' y='0'/></behaviors><coordinator><arbiter_suppression/></coordinator></robot></robots>";
}

struct BugObstacles {
  std::string xml;
  double perimeter_m = 0.0;  // of all of them, at the distance of the boundary
};

/// A convex obstacle across the straight way: a box, a cylinder, or a prism of three to eight
/// corners on a circle.
void add_bug_obstacle(Random& random, double x, BugObstacles& all) {
  const auto number = [&](double from, double to) { return from + (to - from) * random.uniform(); };
  const std::string at =
      "x='" + std::to_string(x) + "' y='" + std::to_string(number(-0.3, 0.3)) + "'";
  const std::string turned = at + " heading_deg='" + std::to_string(number(0, 360)) + "'";
  double perimeter = 0.0;
  const int kind = static_cast<int>(number(0, 3));
  if (kind == 0) {
    const double length = number(0.2, 1.2), width = number(0.2, 1.2);
    perimeter = 2.0 * (length + width);
    all.xml += "<static_box " + turned + " length='" + std::to_string(length) + "' width='" +
               std::to_string(width) + "'/>";
  } else if (kind == 1) {
    const double radius = number(0.1, 0.7);
    perimeter = 2.0 * std::numbers::pi * radius;
    all.xml += "<static_cylinder " + at + " radius='" + std::to_string(radius) + "' height='0.4'/>";
  } else {
    const int corners = static_cast<int>(number(3, 9));
    const double radius = number(0.3, 0.7);
    all.xml += "<static_prism " + turned + " height='0.4'>";
    double last_x = 0.0, last_y = 0.0, first_x = 0.0, first_y = 0.0;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2.0 * std::numbers::pi * (i + number(0, 0.6)) / corners;
      const double px = radius * std::cos(angle), py = radius * std::sin(angle);
      all.xml += "<point x='" + std::to_string(px) + "' y='" + std::to_string(py) + "'/>";
      perimeter += i > 0 ? std::hypot(px - last_x, py - last_y) : 0.0;
      first_x = i > 0 ? first_x : px;
      first_y = i > 0 ? first_y : py;
      last_x = px;
      last_y = py;
    }
    perimeter += std::hypot(first_x - last_x, first_y - last_y);
    all.xml += "</static_prism>";
  }
  all.perimeter_m += perimeter + 2.0 * std::numbers::pi * kBugDistance;
}

std::string bug_world(const std::string& obstacles, const std::string& robots,
                      const std::string& physics = "", double length = 12.0) {
  return "<world format='1'><arena length='" + std::to_string(length) +
         "' width='8'/><physics engine='planar' " + physics +
         "/><teams><team id='red'/></teams><obstacles>" + obstacles + "</obstacles>" + robots +
         "<limits time='1000'/></world>";
}

/// Both algorithms on worlds of four obstacles each. Counts the worlds in which the robot arrives,
/// touches nothing, and drives no farther than the paper proves.
void check_bug_arrival(int worlds) {
  for (const std::string algorithm : {"bug1", "bug2"}) {
    int failed = 0;
    double worst = 0.0;
    for (int seed = 1; seed <= worlds; ++seed) {
      Random random(static_cast<std::uint64_t>(seed));
      BugObstacles obstacles;
      for (int i = 0; i < 4; ++i) {
        add_bug_obstacle(random, -3.0 + 2.1 * i, obstacles);
      }
      testing::World world = testing::World::from_text(
          bug_world(obstacles.xml, bug_robot(algorithm, seed % 2 == 0 ? "left" : "right")), {},
          bug_plugins());
      const bool arrived = world.run_until(
          [](const testing::World& now) {
            return now.count("arrived") + now.count("unreachable") > 0;
          },
          900.0);
      const double path = world.measured("path_length_m").value();
      const double straight = 9.5;
      const double bound = straight + (algorithm == "bug1" ? 1.5 : 1.0) * obstacles.perimeter_m;
      worst = std::max(worst, path / bound);
      if (!arrived || world.count("arrived") != 1 || world.count("collision") != 0 ||
          path > 1.05 * bound) {
        ++failed;
        std::printf(
            "%s: seed %d fails: arrived %d, unreachable %d, collisions %d, %.2f m of %.2f\n",
            algorithm.c_str(), seed, world.count("arrived"), world.count("unreachable"),
            world.count("collision"), path, bound);
      }
    }
    CAPTURE(algorithm, worlds, worst);
    CHECK(failed == 0);
    CHECK(worst > 0.5);  // the bound says something about these worlds
  }
}

}  // namespace

TEST_CASE("bug: it arrives past 1,000 random convex obstacles, as is proven", "[release]") {
  check_bug_arrival(250);
}

TEST_CASE("bug: it arrives past random convex obstacles") { check_bug_arrival(8); }

TEST_CASE("bug: it knows that a place inside a closed wall cannot be reached") {
  // Four walls around the place, and one of them open for comparison.
  const std::string walls =
      "<static_box x='3.5' y='0' length='0.1' width='3'/>"
      "<static_box x='5' y='1.45' length='3' width='0.1'/>"
      "<static_box x='5' y='-1.45' length='3' width='0.1'/>";
  const std::string last = "<static_box id='door' x='6.4' y='0' length='0.1' width='3'/>";
  for (const std::string algorithm : {"bug1", "bug2"}) {
    for (const std::string side : {"left", "right"}) {
      for (const bool is_closed : {true, false}) {
        testing::World world = testing::World::from_text(
            bug_world(walls + (is_closed ? last : ""), bug_robot(algorithm, side), "", 20.0), {},
            bug_plugins());
        CAPTURE(algorithm, side, is_closed);
        CHECK(world.run_until(
            [](const testing::World& now) {
              return now.count("arrived") + now.count("unreachable") > 0;
            },
            400.0));
        CHECK(world.count("unreachable") == (is_closed ? 1 : 0));
        CHECK(world.count("arrived") == (is_closed ? 0 : 1));
        CHECK(world.count("collision") == 0);
        if (is_closed) {  // it stays there, and says so once
          const Pose stands = world.pose("r1");
          world.run_for(5.0);
          CHECK(distance(world.pose("r1"), stands) < 0.01);
          CHECK(world.count("unreachable") == 1);
        }
      }
    }
  }
}

TEST_CASE("bug: it knows that it is locked in itself") {
  const std::string walls =
      "<static_box x='-3' y='0' length='0.1' width='4'/>"
      "<static_box x='-4.5' y='1.95' length='3' width='0.1'/>"
      "<static_box x='-4.5' y='-1.95' length='3' width='0.1'/>"
      "<static_box x='-5.9' y='0' length='0.1' width='4'/>";
  for (const std::string algorithm : {"bug1", "bug2"}) {
    testing::World world = testing::World::from_text(
        bug_world(walls, bug_robot(algorithm, "right")), {}, bug_plugins());
    CAPTURE(algorithm);
    CHECK(world.run_until([](const testing::World& now) { return now.count("unreachable") > 0; },
                          300.0));
    CHECK(world.count("collision") == 0);
  }
}

TEST_CASE("bug: it comes out of a trap, in which going straight ends, at any control period") {
  const std::string trap =
      "<static_box x='0' y='0' length='0.1' width='3'/>"
      "<static_box x='-1' y='1.45' length='2' width='0.1'/>"
      "<static_box x='-1' y='-1.45' length='2' width='0.1'/>";
  for (const std::string algorithm : {"bug1", "bug2"}) {
    for (const std::string physics :
         {"step='0.001'", "step='0.01'", "step='0.01' control_steps='5'", "step='0.1'"}) {
      testing::World world = testing::World::from_text(
          bug_world(trap, bug_robot(algorithm, "right"), physics), {}, bug_plugins());
      CAPTURE(algorithm, physics);
      CHECK(world.run_until([](const testing::World& now) { return now.count("arrived") > 0; },
                            300.0));
      CHECK(world.count("collision") == 0);
    }
  }
}

namespace {

/// A robot at the origin that looks east, at its place 2 m ahead, with beams of 2 m all around; an
/// obstacle at this distance in this direction.
Situation bug_facing(double distance_m = 2.0, double azimuth_deg = 0.0) {
  Situation now;
  for (int azimuth = -150; azimuth <= 150; azimuth += 10) {
    now.beam(azimuth, std::abs(azimuth - azimuth_deg) < 1.0 ? distance_m : 2.0, 2.0);
  }
  return now;
}
testing::Behavior bug_to(double x, double y, const std::string& algorithm = "bug2") {
  return {bug_plugins(), "bug", {{"x", x}, {"y", y}, {"algorithm", algorithm}}};
}

}  // namespace

TEST_CASE("bug: it goes straight, after a turn on the spot") {
  CHECK_THAT(bug_to(2, 0).respond(bug_facing()),
             testing::drives_straight_on() && testing::raises_nothing());
  CHECK_THAT(bug_to(0, 2).respond(bug_facing()),
             testing::turns_on_the_spot() && testing::turns_left());
  CHECK_THAT(bug_to(0, -2).respond(bug_facing()),
             testing::turns_on_the_spot() && testing::turns_right());
  CHECK_THAT(bug_to(0.04, 0).respond(bug_facing()),
             testing::stands() && testing::is_not_active() && testing::raises("arrived"));
}

TEST_CASE("bug: what is nearer than the distance and on its way is a hit point") {
  CHECK_THAT(bug_to(2, 0).respond(bug_facing(0.31)), testing::raises_nothing());
  CHECK_THAT(bug_to(2, 0).respond(bug_facing(0.3)),
             testing::raises("hit_point") && testing::turns_on_the_spot() && testing::turns_left());
  // Beside the way, behind it, and behind the place.
  CHECK_THAT(bug_to(2, 0).respond(bug_facing(0.25, 90)), testing::raises_nothing());
  CHECK_THAT(bug_to(2, 0).respond(bug_facing(0.25, 150)), testing::raises_nothing());
  CHECK_THAT(bug_to(0.15, 0).respond(bug_facing(0.25)), testing::raises_nothing());
  testing::Behavior left(bug_plugins(), "bug", {{"x", 2}, {"side", std::string("left")}});
  CHECK_THAT(left.respond(bug_facing(0.3)), testing::turns_right());
}

TEST_CASE("bug: bug2 leaves the boundary on the M-line, nearer than H, where the way is free") {
  const auto after_hit = [](const Situation& then) {
    testing::Behavior bug = bug_to(2, 0);
    bug.respond(bug_facing(0.3));  // H at the origin, then it is aligned
    bug.respond(bug_facing(0.3, -90).at(0, 0, 90).time(0.1));
    return bug.respond(Situation(then).time(0.2));
  };
  CHECK_THAT(after_hit(bug_facing(0.3, -90).at(1, 0, 0)), testing::raises("leave_point"));
  CHECK_THAT(after_hit(bug_facing(0.3, -90).at(1, 0.02, 0)), testing::raises_nothing());
  CHECK_THAT(after_hit(bug_facing(0.3, -90).at(-0.5, 0, 0)), testing::raises_nothing());  // farther
  CHECK_THAT(after_hit(bug_facing(0.3, 0).at(1, 0, 0)), testing::raises_nothing());  // not free
}

TEST_CASE("bug: it goes to a new place after it has given up, and may give up again") {
  const std::string locked = "<static_box x='3' y='0' length='1' width='1'/>";
  const auto change = [](int time_s, const char* x) {
    return "<change time='" + std::to_string(time_s) +
           "' path='robot[r1]/behavior[bug]/@x' value='" + x + "'/>";
  };
  for (const std::string algorithm : {"bug1", "bug2"}) {
    testing::World world = testing::World::from_text(
        bug_world(locked, bug_robot(algorithm, "right", 3.0) + "<changes>" + change(200, "-3") +
                              change(300, "3.1") + "</changes>"),
        {}, bug_plugins());
    world.run();
    std::vector<std::string> ends;
    for (const auto& event : world.simulation().events()) {
      if (event.name() == "arrived" || event.name() == "unreachable") ends.push_back(event.name());
    }
    CAPTURE(algorithm);
    CHECK(ends == std::vector<std::string>{"unreachable", "arrived", "unreachable"});
    CHECK(world.pose("r1").x > 2.0);
    CHECK(world.count("collision") == 0);
  }
}

TEST_CASE("bug: a new place is a new start") {
  testing::Behavior bug = bug_to(2, 0);
  bug.respond(bug_facing(0.3));
  CHECK_THAT(bug.respond(bug_facing().time(0.1)), testing::turns_on_the_spot());
  bug.set({{"x", 3.0}});
  CHECK_THAT(bug.respond(bug_facing().time(0.2)), testing::drives_straight_on());
  // A successor goes on where the old one was.
  testing::Behavior before = bug_to(2, 0), after = bug_to(2, 0);
  before.respond(bug_facing(0.3));
  REQUIRE(after.take_over(before));
  CHECK(after.respond(bug_facing().time(0.1)).command ==
        before.respond(bug_facing().time(0.1)).command);
  before.reset();
  CHECK_THAT(before.respond(bug_facing().time(0.2)), testing::drives_straight_on());
}

TEST_CASE("bug refuses what it cannot do") {
  const auto made = [](testing::Settings settings) {
    testing::Behavior(bug_plugins(), "bug", settings).equip(Situation().beam(0, 1).beam(-90, 1));
  };
  CHECK_NOTHROW(made({}));
  CHECK_THROWS_WITH(made({{"reach", 0.3}}), Catch::Contains("reach is 0.3 m and distance 0.3 m"));
  CHECK_THROWS_WITH(made({{"distance", 0.05}}), Catch::Contains("corners"));
  CHECK_THROWS_WITH(made({{"algorithm", std::string("bug3")}}), Catch::Contains("bug3"));
  CHECK_THROWS_WITH(made({{"side", std::string("left")}}), Catch::Contains("to the left"));
  CHECK_THROWS_WITH(made({{"algorithm", std::string("bug1")}}),
                    Catch::Contains("to the left (30 to 150)"));  // it may come back
}
