#include <cmath>

#include <catch2/catch.hpp>

#include "shipped.h"
#include "situation.h"
#include "wheels.h"

using namespace elsie;
using namespace elsie::test;

namespace {

plugin::Object<Behavior> follower(test::Parameters parameters = {}) {
  return test::make<Behavior>(PluginKind::behavior, "follow_the_leader", std::move(parameters));
}

/// The answer to a leader at this distance and direction.
Response follow(double distance_m, double theta_deg, test::Parameters parameters = {}) {
  Situation now;
  now.mate("leader", distance_m * std::cos(radians(theta_deg)),
           distance_m * std::sin(radians(theta_deg)), true);
  return follower(std::move(parameters))->respond(now.perception());
}

/// A leader straight ahead, at exactly this distance.
Motion ahead(double distance_m) { return follow(distance_m, 0.0).command; }

void check_follow(const Motion& command, double left, double right) {
  CHECK(rates(command).left == Approx(left).margin(1e-12));
  CHECK(rates(command).right == Approx(right).margin(1e-12));
}

}  // namespace

TEST_CASE("A leader straight ahead is driven to at one of two speeds, and not too near") {
  CHECK(rates(ahead(2.0)) == WheelRates{40, 40});
  CHECK(rates(ahead(0.5)) == WheelRates{40, 40});
  CHECK(rates(ahead(std::nextafter(0.5, 0.0))) == WheelRates{30, 30});
  CHECK(rates(ahead(0.3)) == WheelRates{30, 30});
  CHECK(rates(ahead(std::nextafter(0.3, 0.0))) == WheelRates{0, 0});
  CHECK(rates(ahead(0.05)) == WheelRates{0, 0});
}

TEST_CASE("A leader to the side is turned to, the faster the farther it is off") {
  check_follow(follow(1.0, 90).command, -9, 9);
  check_follow(follow(1.0, -90).command, 9, -9);
  check_follow(follow(0.4, 90).command, -18, 18);
  check_follow(follow(0.4, -45).command, 9, -9);
  CHECK(rates(follow(0.29, 90).command) == WheelRates{0, 0});
  CHECK(rates(follow(0.29, 9).command) == WheelRates{0, 0});
}

TEST_CASE("Up to the threshold it drives straight on, beyond it turns: far, near, left, right") {
  for (const double distance : {1.0, 0.4}) {
    const double gain = distance < 0.5 ? 0.20 : 0.10;
    const double speed = distance < 0.5 ? 30 : 40;
    for (const double side : {1.0, -1.0}) {
      CAPTURE(distance, side);
      check_follow(follow(distance, side * 9.999).command, speed, speed);
      check_follow(follow(distance, side * 10.001).command, -side * gain * 10.001,
                   side * gain * 10.001);
    }
  }
  // Exactly at the threshold.
  Situation now;
  now.mate("leader", 1.0, 0.2, true);
  const double theta = degrees(now.perception().team().mates[0].bearing_rad);
  const auto straight = follower({{"turn_above", theta}});
  CHECK(straight->respond(now.perception()).command == wheels(40, 40));
  const auto turning = follower({{"turn_above", std::nextafter(theta, 0.0)}});
  CHECK(rates(turning->respond(now.perception()).command).left == Approx(-0.1 * theta));
}

TEST_CASE("The direction is wrapped: it takes the shorter way round") {
  Situation now;
  now.at(0, 0, 170).mate("leader", std::cos(radians(-170)), std::sin(radians(-170)), true);
  check_follow(follower()->respond(now.perception()).command, -2,
               2);  // 20 deg to the left, not -340
  Situation other;
  other.at(0, 0, -170).mate("leader", std::cos(radians(170)), std::sin(radians(170)), true);
  check_follow(follower()->respond(other.perception()).command, 2, -2);
  Situation behind;
  behind.mate("leader", -1, 0, true);
  check_follow(follower()->respond(behind.perception()).command, -18, 18);  // 180, not -180
}

TEST_CASE("Without a leader in reach it stands still and is not active") {
  Situation alone;
  alone.mate("mate", 0.4, 0);
  Response response = follower()->respond(alone.perception());
  CHECK(response.command == Motion{});
  CHECK(response.activation == 0.0);
  CHECK(response.strength == 0.0);
  CHECK(response.events.empty());
}

TEST_CASE("A leader follows nobody") {
  Situation now;
  now.mate("other", 0.4, 0, true);
  now.self.is_leader = true;
  const Response response = follower()->respond(now.perception());
  CHECK(response.command == Motion{});
  CHECK(response.activation == 0.0);
}

TEST_CASE("Of several leaders it follows the nearest") {
  Situation now;
  now.mate("far", 0, 0.9, true).mate("mate", 0.1, 0).mate("near", 0, -0.4, true);
  check_follow(follower()->respond(now.perception()).command, 18, -18);
}

TEST_CASE("The farther the leader, the higher the activation; near it, it is not zero") {
  CHECK(follow(0.8, 0).activation == 1.0);
  CHECK(follow(0.5, 50).activation == Approx(1.0));
  CHECK(follow(0.4, 0).activation == Approx(0.8));
  CHECK(follow(0.2, 0).activation == Approx(0.4));
}

TEST_CASE("It says when a leader comes into reach and when it goes, and forgets at a reset") {
  Situation with, without;
  with.mate("leader", 0.4, 0, true);
  const auto behavior = follower();
  REQUIRE(behavior->respond(with.perception()).events.size() == 1);
  CHECK(behavior->respond(with.perception()).events.empty());
  const Response gone = behavior->respond(without.perception());
  REQUIRE(gone.events.size() == 1);
  CHECK(gone.events[0].name == "leader_out_of_reach");
  CHECK(behavior->respond(without.perception()).events.empty());
  const Response back = behavior->respond(with.perception());
  REQUIRE(back.events.size() == 1);
  CHECK(back.events[0].name == "leader_in_reach");
  Random random;
  behavior->reset(random);
  CHECK(behavior->respond(with.perception()).events.size() == 1);
}

TEST_CASE("Every constant of the law is a parameter") {
  const test::Parameters parameters{
      {"turn_above", 20.0}, {"far_distance", 1.0}, {"far_gain", 0.3},     {"far_speed", 7.0},
      {"near_gain", 0.4},   {"near_speed", 5.0},   {"stop_distance", 0.6}};
  check_follow(follow(1.0, 19.9, parameters).command, 7, 7);
  check_follow(follow(1.001, 30, parameters).command, -9, 9);
  check_follow(follow(0.9, 30, parameters).command, -12, 12);
  check_follow(follow(0.7, 15, parameters).command, 5, 5);
  check_follow(follow(0.59, 90, parameters).command, 0, 0);
}

TEST_CASE("A follower that would stop before it comes near is refused") {
  CHECK_THROWS_WITH(follower({{"stop_distance", 0.6}}),
                    Catch::Contains("stop_distance is 0.6 m and far_distance 0.5 m"));
  CHECK_NOTHROW(follower({{"stop_distance", 0.5}}));
}
