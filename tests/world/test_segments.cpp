// What a robot pulls behind it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "elsie/world/parts.h"
#include "elsie/world/writer.h"

#include "equal.h"
#include "fixture.h"

using namespace elsie;
using namespace elsie::test;

namespace {

const char* const kTrain =
    "<robots><robot id='r' x='1'><segments><segment/><segment id='last' length='0.1'/>"
    "</segments></robot></robots>";

struct Corner {
  double x, y;
};

/// By how much the segment, turned about its joint, has come past the rear face of the body in
/// front, or that one past the segment's front face; negative while there is room. The joint is at
/// the origin.
double overlap(double behind_face, double ahead_of_face, double half_width, double yaw) {
  const double c = std::cos(yaw), s = std::sin(yaw);
  double most = -1.0;
  for (const double side : {-1.0, 1.0}) {
    const Corner own{-ahead_of_face * c - side * half_width * s,
                     -ahead_of_face * s + side * half_width * c};
    most = std::max(most, own.x - behind_face);
    const Corner front{behind_face, side * half_width};
    most = std::max(most, -ahead_of_face - (front.x * c + front.y * s));
  }
  return most;
}

}  // namespace

TEST_CASE("Segments are numbered, and follow each other in file order") {
  const world::World w = read(kTrain);
  REQUIRE(w.robots[0].segments.size() == 2);
  CHECK(w.robots[0].segments[0].id == "segment_1");
  CHECK(w.robots[0].segments[0].length == world::Segment().length);
  CHECK(w.robots[0].segments[1].id == "last");
  CHECK(w.robots[0].segments[1].length == 0.1);
  CHECK_FALSE(w.robots[0].segments[1].hitch);
}

TEST_CASE("A path leads to a segment") {
  const world::World w =
      read(kTrain, {"robot[r]/segment[last]/@mass=0.5", "robot[r]/segment[1]/@gap=0.1",
                    "robot[r]/segment[*]/@max_yaw_deg=33"});
  CHECK(w.robots[0].segments[1].mass == 0.5);
  CHECK(w.robots[0].segments[0].gap == 0.1);
  CHECK(w.robots[0].segments[1].gap == world::Segment().gap);
  CHECK(w.robots[0].segments[0].max_yaw_deg == 33.0);
  CHECK(w.robots[0].segments[1].max_yaw_deg == 33.0);
}

TEST_CASE("Two segments of a robot must have different ids") {
  CHECK_THAT(problems("<robots><robot id='r'><segments><segment id='a'/><segment id='a'/>"
                      "</segments></robot></robots>"),
             Catch::Contains("a second segment of this robot with the id 'a'"));
}

TEST_CASE("The parts of a train stand in line behind the robot") {
  world::RobotBody body;
  body.length = 0.1;
  std::vector<world::Segment> segments(2);
  segments[0].length = 0.08;
  segments[0].gap = 0.04;
  segments[1].length = 0.06;
  segments[1].gap = 0.03;
  segments[1].hitch = 0.0;
  const auto chain = world::couplings(world::plan_of(body, {}), segments);
  CHECK(chain[0].place == Approx(0.05 + 0.04 + 0.04));
  CHECK(chain[0].behind == Approx(0.07));  // in the middle of the gap
  CHECK(chain[0].ahead == Approx(0.06));
  CHECK(chain[0].height == segments[0].wheel_radius);
  CHECK(chain[1].place == Approx(0.13 + 0.04 + 0.03 + 0.03));
  CHECK(chain[1].behind == 0.0);
  CHECK(chain[1].ahead == Approx(0.1));
}

TEST_CASE("By default a joint turns until the two bodies would touch, and no further") {
  const double hitch = GENERATE(0.045, 0.05, 0.06, 0.07, 0.075);
  const double gap = GENERATE(0.035, 0.04, 0.05);
  CAPTURE(hitch, gap);
  const world::RobotBody body;  // 0.1 m wide with its wheels
  world::Segment segment;
  segment.gap = gap;
  segment.hitch = hitch;
  const world::Coupling joint = world::couplings(world::plan_of(body, {}), std::vector{segment})[0];
  const double behind = hitch - 0.5 * body.length;
  const double ahead = joint.ahead - 0.5 * segment.length;
  CHECK(behind + ahead == Approx(gap));
  const double limit = joint.max_yaw_rad;
  CHECK(limit > 0.3);
  CHECK(limit < 0.5 * std::numbers::pi);
  for (double yaw = 0.0; yaw < limit; yaw += 0.01) {
    CHECK(overlap(behind, ahead, 0.05, yaw) < 1e-12);
  }
  CHECK(overlap(behind, ahead, 0.05, limit) == Approx(0.0).margin(1e-12));
  CHECK(overlap(behind, ahead, 0.05, limit + 0.01) > 0.0);
}

TEST_CASE("A joint turns no further than 90 degrees unless the file says so") {
  world::Segment segment;
  segment.gap = 0.5;
  CHECK(world::couplings(world::plan_of({}, {}), std::vector{segment})[0].max_yaw_rad ==
        0.5 * std::numbers::pi);
  segment.max_yaw_deg = 120.0;
  CHECK(world::couplings(world::plan_of({}, {}), std::vector{segment})[0].max_yaw_rad ==
        radians(120.0));
}

TEST_CASE("A train must be free of walls, boxes and other robots over its whole length") {
  const auto robot = [](const std::string& place) {
    return "<robots><robot id='r' " + place +
           "><segments><segment/><segment/></segments></robot></robots>";
  };
  CHECK(problems(robot("x='-4.6'")) == "");
  // The last segment's end is 0.04 + 2 * 0.12 m behind the robot's middle.
  CHECK_THAT(problems(robot("x='-4.73'")),
             Catch::Contains("the segment 'segment_2' of the robot 'r' reaches") &&
                 Catch::Contains("into the west wall") && !Catch::Contains("segment_1"));
  CHECK(problems(robot("y='-4.73' heading_deg='90'")) != "");
  CHECK(problems(robot("y='4.73' heading_deg='90'")) == "");
  const std::string box = "<obstacles><dynamic_box id='b' x='-0.3' length='0.1'/></obstacles>";
  CHECK_THAT(problems(box + robot("")),
             Catch::Contains("the segment 'segment_2' of the robot 'r' overlaps the box 'b'"));
  CHECK(problems(box + robot("heading_deg='180'")) == "");
  CHECK(problems(box + robot("x='0.1'")) == "");
  CHECK_THAT(
      problems("<robots><robot id='a' x='-0.19'/><robot id='r'><segments><segment/></segments>"
               "</robot></robots>") +
          problems("<robots><robot id='r'><segments><segment id='s'/></segments></robot>"
                   "<robot id='a' x='-0.12'/></robots>"),
      Catch::Contains("the robot 'a' overlaps the segment 's' of the robot 'r'") &&
          Catch::Contains("the segment 'segment_1' of the robot 'r' overlaps the robot 'a'"));
}

TEST_CASE("Segments must have room for their wheels, and their joints ahead of their axles") {
  const auto with = [](const std::string& segment) {
    return problems("<robots><robot id='r'><segments><segment " + segment +
                    "/></segments></robot></robots>");
  };
  CHECK(with("wheel_width='0.03'") == "");
  CHECK_THAT(
      with("wheel_width='0.031'"),
      Catch::Contains("the segment 'segment_1' of the robot 'r' is 0.06 m wide, which leaves "
                      "no room for two wheels of 0.031 m"));
  CHECK(with("hitch='0.119'") == "");
  CHECK_THAT(with("hitch='0.13'"),
             Catch::Contains("expected less than 0.12 m, so that the joint is ahead of the "
                             "segment's axle"));
  // What is wrong by itself is not judged once more.
  CHECK(with("width='0'").find("room") == std::string::npos);
}

TEST_CASE("A train survives writing and reading") {
  const world::World w = read(kTrain);
  CHECK(
      same(w, world::parse_world(world::write_world(w), kFolder + "again.xml", host(), options())));
}
