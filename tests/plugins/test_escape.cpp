#include <cmath>

#include <catch2/catch.hpp>

#include "shipped.h"
#include "situation.h"
#include "wheels.h"

using namespace elsie;
using namespace elsie::test;

namespace {

constexpr double kPeriod = 0.125;  // s; sums of it are exact

plugin::Object<Behavior> escape(test::Parameters parameters = {}) {
  return test::make<Behavior>(PluginKind::behavior, "escape", std::move(parameters));
}

/// A robot that is commanded and moves as given, one control period after the other.
class Drive {
 public:
  explicit Drive(test::Parameters parameters = {}) : behavior(escape(std::move(parameters))) {}

  Response step(double commanded_m_s, double measured_m_s, const char* event = nullptr) {
    Situation here;
    if (event) {
      here.event(event);
    }
    return ask(here, {commanded_m_s, 0, 0}, measured_m_s, 0);
  }
  Response turn_step(double commanded_rad_s, double measured_rad_s) {
    Situation here;
    return ask(here, {0, 0, commanded_rad_s}, 0, measured_rad_s);
  }
  /// Held for this many periods; returns the last answer.
  Response held(int steps, double commanded_m_s = 0.2) {
    Response response;
    for (int i = 0; i < steps; ++i) {
      response = step(commanded_m_s, 0.0);
    }
    return response;
  }

  plugin::Object<Behavior> behavior;
  Situation now;  // the robot's own state
  double time_s = 0.0;

 private:
  Response ask(Situation& here, const Motion& commanded, double speed, double turn_rate) {
    here.self = now.self;
    here.self.commanded = commanded;
    here.self.moving.forward = speed;
    here.self.moving.turn = turn_rate;
    here.time(time_s);
    here.random = now.random;
    const Response response = behavior->respond(here.perception());
    now.random = here.random;
    time_s += kPeriod;
    return response;
  }
};

bool raised(const Response& response, const char* name) {
  for (const Event& event : response.events) {
    if (event.name == std::string_view(name)) {
      return true;
    }
  }
  return false;
}

/// The manoeuvre of a robot that moves exactly as commanded, from the moment it is stuck.
struct Manoeuvre {
  double way_m = 0.0;       // along its heading
  double turned_rad = 0.0;  // counter-clockwise
  bool freed = false;
  double time_s = 0.0;
};
Manoeuvre carry_out(Drive& drive, Response response, bool moves = true) {
  Manoeuvre manoeuvre;
  OwnState& self = drive.now.self;
  const double start = drive.time_s;
  while (response.activation > 0.0 && drive.time_s - start < 100.0) {
    const double forward = response.command.forward;
    const double turn = response.command.turn;
    if (moves) {
      manoeuvre.way_m += forward * kPeriod;
      manoeuvre.turned_rad += turn * kPeriod;
      self.pose.x += forward * kPeriod * std::cos(self.pose.heading_rad);
      self.pose.y += forward * kPeriod * std::sin(self.pose.heading_rad);
      self.pose.heading_rad = wrap_angle(self.pose.heading_rad + turn * kPeriod);
    }
    response = drive.step(forward, moves ? forward : 0.0);
    manoeuvre.freed = manoeuvre.freed || raised(response, "freed");
  }
  manoeuvre.time_s = drive.time_s - start;
  return manoeuvre;
}

}  // namespace

TEST_CASE("A robot that moves as commanded, or is to stand, is left alone") {
  Drive drive({{"least_speed", 0.02}, {"progress_time", 0.0}});
  for (int i = 0; i < 100; ++i) {
    const Response response = drive.step(0.2, 0.0401);  // a fifth counts as moving
    REQUIRE(response.activation == 0.0);
    REQUIRE(response.strength == 0.0);
    REQUIRE(response.command == Motion{});
    REQUIRE(response.events.empty());
  }
  for (int i = 0; i < 100; ++i) {
    REQUIRE(drive.step(0.0, 0.0).activation == 0.0);
    REQUIRE(drive.step(0.0199, 0.0).activation == 0.0);
    REQUIRE(drive.turn_step(2.0, 0.5).activation == 0.0);
  }
}

TEST_CASE("Held for as long as its patience, it is stuck") {
  Drive drive;
  drive.step(0.2, 0.2);
  CHECK(drive.held(7).activation == 0.0);  // 0.875 s
  const Response response = drive.held(1);
  CHECK(response.activation == 1.0);
  CHECK(response.strength == 1.0);
  CHECK(raised(response, "stuck"));
  CHECK(rates(response.command).left == Approx(-7.5));  // 0.15 m/s backwards
  CHECK(rates(response.command).right == Approx(-7.5));
}

TEST_CASE("Just too little motion is none, and being pushed back is none either") {
  Drive slow, pushed, reversing;
  Response a, b, c;
  for (int i = 0; i < 9; ++i) {
    a = slow.step(0.2, 0.0399);
    b = pushed.step(0.2, -0.2);
    c = reversing.step(-0.2, 0.0);
  }
  CHECK(a.activation == 1.0);
  CHECK(b.activation == 1.0);
  CHECK(c.activation == 1.0);
  CHECK(rates(c.command).left == Approx(7.5));  // stuck while backing up: it drives forwards
}

TEST_CASE("A turn on the spot can be stuck, too") {
  Drive drive;
  Response response;
  for (int i = 0; i < 9; ++i) {
    response = drive.turn_step(2.0, 0.39);
  }
  CHECK(raised(response, "stuck"));
}

TEST_CASE("A jerk does not reset the time, moving does") {
  Drive jerk;
  jerk.held(8);
  jerk.step(0.2, 0.1);
  CHECK(jerk.held(2).activation == 1.0);
  Drive moving;
  moving.held(8);
  for (int i = 0; i < 7; ++i) {
    moving.step(0.2, 0.2);
  }
  CHECK(moving.held(7).activation == 0.0);
  CHECK(moving.held(1).activation == 1.0);
}

TEST_CASE("After a collision it loses patience sooner, for a second") {
  Drive hit({{"collision_patience", 0.25}});
  hit.step(0.2, 0.2);
  CHECK(hit.step(0.2, 0.0, "collision").activation == 0.0);
  CHECK(hit.held(1).activation == 1.0);
  Drive touched({{"collision_patience", 0.25}});  // and drives on along the wall
  CHECK(touched.step(0.2, 0.2, "collision").activation == 0.0);
  CHECK(touched.step(0.2, 0.2).activation == 0.0);
  Drive old({{"collision_patience", 0.25}});
  old.step(0.2, 0.2, "collision");
  for (int i = 0; i < 8; ++i) {
    old.step(0.2, 0.2);
  }
  CHECK(old.held(7).activation == 0.0);
  Drive other({{"collision_patience", 0.25}});
  other.step(0.2, 0.2, "collected");
  CHECK(other.held(7).activation == 0.0);
}

TEST_CASE("It backs up, turns, and says that it is free") {
  for (int seed = 0; seed < 50; ++seed) {
    CAPTURE(seed);
    Drive drive;
    drive.now.random = Random(seed);
    const Manoeuvre done = carry_out(drive, drive.held(9));
    CHECK(done.freed);
    CHECK(done.way_m <= -0.05);
    CHECK(done.way_m >= -0.15 - 0.15 * kPeriod);  // checked once per period
    CHECK(std::abs(done.turned_rad) >= radians(60));
    CHECK(std::abs(done.turned_rad) <= radians(150) + 2.0 * kPeriod);
    CHECK(drive.step(0.2, 0.2).activation == 0.0);
  }
}

TEST_CASE("Distance, angle and side come from its random stream") {
  int left = 0;
  double least = 10, most = 0;
  for (int seed = 0; seed < 100; ++seed) {
    Drive drive;
    drive.now.random = Random(seed);
    const double turned = carry_out(drive, drive.held(9)).turned_rad;
    left += turned > 0.0;
    least = std::min(least, std::abs(turned));
    most = std::max(most, std::abs(turned));
    Drive again;
    again.now.random = Random(seed);
    CHECK(carry_out(again, again.held(9)).turned_rad == turned);
  }
  CHECK(left == Approx(50).margin(20));  // four standard deviations
  CHECK(degrees(least) < 75);
  CHECK(degrees(most) > 135);
}

TEST_CASE("A manoeuvre that is blocked ends all the same, and the next tries the other way") {
  Drive drive;
  const Manoeuvre blocked = carry_out(drive, drive.held(9), false);
  CHECK_FALSE(blocked.freed);
  CHECK(blocked.time_s < 2 * 0.15 / 0.15 + 2 * radians(150) / 2.0 + 3 * kPeriod);
  const Response next = drive.held(9);
  REQUIRE(next.activation == 1.0);
  CHECK(rates(next.command).left == Approx(7.5));  // forwards
  carry_out(drive, next, false);
  for (double start = drive.time_s; drive.time_s < start + 3.0;) {
    drive.step(0.2, 0.2);  // it drives on: getting stuck later is a new trap
  }
  CHECK(rates(drive.held(9).command).left == Approx(-7.5));
}

TEST_CASE("Without progress it is stuck even though it moves, unless it is not to watch that") {
  const auto first_alarm = [](Drive& drive) {
    for (int i = 0; i < 100; ++i) {
      drive.now.self.pose.x = i % 2 ? 0.05 : 0.0;  // to and fro
      if (drive.step(0.2, 0.2).activation > 0.0) {
        return i * kPeriod;
      }
    }
    return -1.0;
  };
  Drive watching, not_watching({{"progress_time", 0.0}}), content({{"progress_distance", 0.05}});
  CHECK(first_alarm(watching) == 4.0);
  CHECK(first_alarm(not_watching) == -1.0);
  CHECK(first_alarm(content) == -1.0);
}

TEST_CASE("A robot that is not to move need not make progress") {
  Drive drive({{"progress_time", 1.0}});
  for (int i = 0; i < 100; ++i) {
    REQUIRE(drive.step(0.0, 0.0).activation == 0.0);
  }
}

TEST_CASE("When others drove meanwhile, it starts to watch again") {
  Drive drive;
  drive.held(8);
  drive.time_s += 2.0;
  CHECK(drive.held(8).activation == 0.0);
  CHECK(drive.held(1).activation == 1.0);
  drive.time_s += 2.0;  // an old manoeuvre does not continue either
  CHECK(drive.step(0.2, 0.2).activation == 0.0);
}

TEST_CASE("A reset ends the manoeuvre and the watch") {
  Drive drive;
  drive.held(9);
  Random random;
  drive.behavior->reset(random);
  CHECK(drive.held(8).activation == 0.0);
  CHECK(rates(drive.held(1).command).left == Approx(-7.5));
}

TEST_CASE("A smallest turn above the largest is refused") {
  CHECK_THROWS_WITH(escape({{"turn_min", 160.0}}),
                    Catch::Contains("turn_min is 160 deg and turn_max 150 deg"));
  CHECK_NOTHROW(escape({{"turn_min", 150.0}}));
}
