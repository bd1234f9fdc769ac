#include <cmath>
#include <string>

#include <catch2/catch.hpp>

#include "elsie/testing/world.h"

#include "group.h"

using namespace elsie;
using namespace elsie::test;

namespace {

plugin::Object<Behavior> disperser(Parameters parameters = {}) {
  return test::make<Behavior>(PluginKind::behavior, "disperse", std::move(parameters));
}

Response dispersed(const Situation& now, Parameters parameters = {}) {
  return disperser(std::move(parameters))->respond(now.perception());
}

}  // namespace

TEST_CASE("disperse: in the end no two robots are nearer than the distance") {
  for (const char* from : {"team", "messages"}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      CAPTURE(from, seed);
      const auto start = Group::scattered(10, 0.3, seed);
      Group group("disperse", {{"distance", 0.4}, {"from", std::string(from)}}, start, 0.5);
      REQUIRE(group.least_distance() < 0.2);
      group.run(60.0);
      CHECK(group.least_distance() >= 0.4);
      // It stops there: they go no farther apart than they must.
      const auto end = group.poses();
      group.run(10.0);
      CHECK(group.poses() == end);
      CHECK(group.radius() < 1.5);
    }
  }
}

TEST_CASE("disperse: the distance counts, and any control period will do") {
  const auto start = Group::scattered(6, 0.2, 3);
  Group near("disperse", {{"distance", 0.25}}, start);
  near.run(60.0);
  CHECK(near.least_distance() >= 0.25);
  CHECK(near.least_distance() < 0.4);
  Group slow("disperse", {{"speed", 0.0}}, start);
  slow.run(60.0);
  CHECK(slow.least_distance() < 0.25);
  for (const double period : {1e-3, 1e-2, 0.1}) {
    CAPTURE(period);
    Group group("disperse", {}, start);
    group.run(20.0, period);
    CHECK(group.least_distance() >= 0.4);
  }
}

TEST_CASE("disperse: it drives away from the middle of those within the distance") {
  // Behind it: straight on.
  const Response on = dispersed(Situation().mate("a", -0.2, 0));
  CHECK(on.command.forward == Approx(0.2));
  CHECK(on.command.turn == Approx(0.0).margin(1e-9));
  CHECK(on.activation == 1.0);
  // On the left: it turns right, in place.
  const Response right = dispersed(Situation().mate("a", 0, 0.2));
  CHECK(right.command.forward == Approx(0.0).margin(1e-9));
  CHECK(right.command.turn == Approx(-4.0 * radians(90)));
  // The middle of (-0.2, 0.1) and (-0.2, 0.2); a third one is too far away to count.
  const Response middle =
      dispersed(Situation().mate("a", -0.2, 0.1).mate("b", -0.2, 0.2).mate("c", 0.5, 0));
  CHECK(middle.command.turn == Approx(-4.0 * std::atan2(0.15, 0.2)));
  CHECK(middle.command.forward == Approx(0.2 * std::cos(std::atan2(0.15, 0.2))));
}

TEST_CASE("disperse: nobody near, nobody at all, and those all around it") {
  for (const Situation& now : {Situation(), Situation().mate("a", 0.4, 0)}) {
    const Response response = dispersed(now);
    CHECK(response.command == Motion{});
    CHECK(response.activation == 0.0);
    CHECK(response.strength == 0.0);
    CHECK(response.events.empty());
  }
  // No way leads away from them, nor from one at its own place: it stands until they have left.
  for (const Situation& now :
       {Situation().mate("a", 0.2, 0).mate("b", -0.2, 0), Situation().mate("a", 0, 0)}) {
    const Response response = dispersed(now);
    CHECK(response.command == Motion{});
    CHECK(response.activation == 1.0);
  }
}

TEST_CASE("disperse: of messages it takes those that tell from where, and no others") {
  const Parameters hears{{"from", std::string("messages")}};
  Situation now;
  now.mate("a", 0.1, 0).hear(HeadingMessage{}, "a");  // its team counts no longer; a radio
  CHECK(dispersed(now, hears).activation == 0.0);
  now.hear(HeadingMessage{}, "", 0.2, 90);
  CHECK(dispersed(now, hears).command.turn == Approx(-4.0 * radians(90)));
  // What noise makes of a small distance.
  CHECK(dispersed(Situation().hear(HeadingMessage{}, "", -0.01, 0), hears).activation == 1.0);
}

TEST_CASE("Who perceives others by messages needs an actuator that hears them") {
  for (const std::string name : {"aggregate", "disperse", "flock"}) {
    CAPTURE(name);
    const auto robot_with = [&](const std::string& actuators, const std::string& from) {
      return testing::World::from_text(
          "<world format='1'><robots><robot id='r1'><actuators>" + actuators +
          "</actuators><behaviors><" + name + " from='" + from +
          "'/></behaviors><coordinator><arbiter_suppression/></coordinator></robot></robots>"
          "</world>");
    };
    CHECK_THROWS_WITH(robot_with("", "messages"),
                      Catch::Contains("plugin '" + name + "': it perceives other robots by") &&
                          Catch::Contains("add <range_and_bearing>"));
    CHECK_THROWS_WITH(robot_with("<led/>", "messages"), Catch::Contains("no actuator that hears"));
    CHECK_NOTHROW(robot_with("<range_and_bearing/>", "messages"));
    CHECK_NOTHROW(robot_with("", "team"));
  }
}

TEST_CASE("disperse: it says when others come too near, and when they have left") {
  const auto behavior = disperser();
  const auto at = [&](double distance_m) {
    const auto events = behavior->respond(Situation().mate("a", distance_m, 0).perception()).events;
    return events.empty() ? std::string() : std::string(events.at(0).name);
  };
  CHECK(at(0.5).empty());
  CHECK(at(0.3) == "crowded");
  CHECK(at(0.2).empty());
  CHECK(at(0.4) == "dispersed");
  CHECK(at(0.3) == "crowded");
  Random random;
  behavior->reset(random);
  CHECK(at(0.3) == "crowded");
}

TEST_CASE("disperse: parameters that mean nothing are refused") {
  CHECK_THROWS_WITH(disperser({{"distance", 0.0}}), Catch::Contains("distance"));
  CHECK_THROWS_WITH(disperser({{"from", std::string("radio")}}), Catch::Contains("messages"));
}
