#include <cmath>

#include <catch2/catch.hpp>

#include "shipped.h"
#include "situation.h"
#include "wheels.h"

using namespace elsie;
using namespace elsie::test;

namespace {

plugin::Object<Behavior> recharge(test::Parameters parameters = {}) {
  return test::make<Behavior>(PluginKind::behavior, "recharge", std::move(parameters));
}

/// A robot at the origin with 500 of 5000 units left and a charger at (x, y).
Situation hungry(double x, double y = 0.0) {
  Situation now;
  now.self.energy = 500.0;
  now.team.charger = Vector2{x, y};
  return now;
}

Motion command(double distance_m, double theta_deg) {
  return recharge()
      ->respond(hungry(distance_m * std::cos(radians(theta_deg)),
                       distance_m * std::sin(radians(theta_deg)))
                    .perception())
      .command;
}

std::vector<std::string> events(const Response& response) {
  std::vector<std::string> names;
  for (const Event& event : response.events) {
    names.emplace_back(event.name);
  }
  return names;
}
using Names = std::vector<std::string>;

void check_rates(const Motion& command, double left, double right) {
  CHECK(rates(command).left == Approx(left).margin(1e-12));
  CHECK(rates(command).right == Approx(right).margin(1e-12));
}

}  // namespace

TEST_CASE("With enough energy it only drives on and is not active") {
  Situation now = hungry(1);
  now.self.energy = std::nextafter(500.0, 1000.0);
  const Response response = recharge()->respond(now.perception());
  CHECK(rates(response.command) == WheelRates{10, 10});
  CHECK(response.activation == 0.0);
  CHECK(response.strength == 0.0);
  CHECK_FALSE(response.charge);
  CHECK(response.events.empty());
}

TEST_CASE("At a tenth of the capacity it drives to the charger") {
  const Response response = recharge()->respond(hungry(1).perception());
  CHECK(rates(response.command) == WheelRates{40, 40});
  CHECK(response.activation == 0.5);
  CHECK_FALSE(response.charge);
  CHECK(events(response) == Names{"battery_low"});
}

TEST_CASE("The law of its turns and straights") {
  CHECK(rates(command(0.5, 0)) == WheelRates{40, 40});
  CHECK(rates(command(std::nextafter(0.5, 0.0), 0)) == WheelRates{30, 30});
  CHECK(rates(command(0.1, 0)) == WheelRates{30, 30});
  CHECK(rates(command(std::nextafter(0.1, 0.0), 0)) == WheelRates{0, 0});
  check_rates(command(1.0, 9.999), 40, 40);
  check_rates(command(1.0, 10.001), -1.0001, 1.0001);
  check_rates(command(1.0, -10.001), 1.0001, -1.0001);
  check_rates(command(0.3, -9.999), 30, 30);
  check_rates(command(0.3, 10.001), -2.0002, 2.0002);
  check_rates(command(0.3, 180), -36, 36);
  check_rates(command(0.05, 90), 0, 0);
}

TEST_CASE("It becomes more urgent as the battery empties") {
  const auto behavior = recharge();
  Situation now = hungry(1);
  CHECK(behavior->respond(now.perception()).activation == 0.5);
  now.self.energy = 250;
  CHECK(behavior->respond(now.perception()).activation == 0.75);
  now.self.energy = 1e-9;
  CHECK(behavior->respond(now.perception()).activation == Approx(1.0));
  now.self.energy = 2000;  // a resource that it found on the way is not enough
  const Response response = behavior->respond(now.perception());
  CHECK(rates(response.command) == WheelRates{40, 40});
  CHECK(response.activation == 0.5);
}

TEST_CASE("At the charger it stands and asks to be charged until it is full, then drives on") {
  const auto behavior = recharge();
  Situation now = hungry(0.05);
  Response response = behavior->respond(now.perception());
  CHECK(response.command == Motion{});
  CHECK(response.charge);
  CHECK(response.activation == 1.0);
  CHECK(events(response) == Names{"battery_low", "at_charger"});
  now.self.charging = true;
  now.self.energy = std::nextafter(5000.0, 0.0);
  response = behavior->respond(now.perception());
  CHECK(response.command == Motion{});
  CHECK(response.charge);
  CHECK(response.events.empty());
  now.self.charging = false;
  now.self.energy = 5000.0;
  response = behavior->respond(now.perception());
  CHECK(rates(response.command) == WheelRates{10, 10});
  CHECK_FALSE(response.charge);
  CHECK(response.activation == 0.0);
  CHECK(events(response) == Names{"recharged"});
  now.self.energy = 4999;  // a little was used: no reason to return
  CHECK(rates(behavior->respond(now.perception()).command) == WheelRates{10, 10});
}

TEST_CASE("Pushed aside it stays as long as it is being charged, else comes back") {
  const auto behavior = recharge();
  Situation now = hungry(0.05);
  behavior->respond(now.perception());
  now.team.charger = Vector2{0.12, 0};
  now.self.charging = true;
  now.self.energy = 3000;
  CHECK(behavior->respond(now.perception()).charge);
  now.self.charging = false;
  Response response = behavior->respond(now.perception());
  CHECK_FALSE(response.charge);
  CHECK(rates(response.command) == WheelRates{30, 30});
  CHECK(response.events.empty());
  now.team.charger = Vector2{0.05, 0};
  CHECK(events(behavior->respond(now.perception())) == Names{"at_charger"});
}

TEST_CASE("It reports once when it stands at the charger in vain") {
  const auto behavior = recharge();
  Situation now = hungry(0.05);
  behavior->respond(now.perception());
  CHECK(behavior->respond(now.time(1.0).perception()).events.empty());
  CHECK(events(behavior->respond(now.time(1.01).perception())) == Names{"not_charged"});
  CHECK(behavior->respond(now.time(3.0).perception()).events.empty());
}

TEST_CASE("Without a charger it drives on, and reports it once each time the battery runs low") {
  const auto behavior = recharge();
  Situation now;
  now.self.energy = 400;
  Response response = behavior->respond(now.perception());
  CHECK(rates(response.command) == WheelRates{10, 10});
  CHECK(response.activation == 0.0);
  CHECK(events(response) == Names{"no_charger"});
  CHECK(behavior->respond(now.perception()).events.empty());
  now.self.energy = 3000;
  CHECK(behavior->respond(now.perception()).events.empty());
  now.self.energy = 500;
  CHECK(events(behavior->respond(now.perception())) == Names{"no_charger"});
}

TEST_CASE("A note before the run says that the team has no charger") {
  const auto behavior = recharge();
  behavior->equipped(Situation().perception());
  REQUIRE(behavior->notes().size() == 1);
  CHECK_THAT(behavior->notes()[0], Catch::Contains("no charger"));
  behavior->equipped(hungry(1).perception());
  CHECK(behavior->notes().empty());
}

TEST_CASE("A reset ends its present phase") {
  const auto behavior = recharge();
  Situation now = hungry(1);
  behavior->respond(now.perception());
  now.self.energy = 600;
  CHECK(rates(behavior->respond(now.perception()).command) == WheelRates{40, 40});
  Random random;
  behavior->reset(random);
  CHECK(rates(behavior->respond(now.perception()).command) == WheelRates{10, 10});
}

TEST_CASE(
    "Level and speed are parameters of recharge, and a charger that it never nears is refused") {
  Situation now = hungry(1);
  now.self.energy = 2500;
  const auto behavior = recharge({{"start_level", 0.5}, {"idle_speed", 3.0}});
  CHECK(rates(behavior->respond(now.perception()).command) == WheelRates{40, 40});
  now.self.energy = 5000;
  CHECK(rates(behavior->respond(now.perception()).command) == WheelRates{3, 3});
  CHECK_THROWS_WITH(recharge({{"stop_distance", 0.7}}), Catch::Contains("stop_distance is 0.7 m"));
}
