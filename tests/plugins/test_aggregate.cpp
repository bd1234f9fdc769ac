#include <cmath>

#include <catch2/catch.hpp>

#include "group.h"

using namespace elsie;
using namespace elsie::test;

namespace {

plugin::Object<Behavior> aggregator(Parameters parameters = {}) {
  return test::make<Behavior>(PluginKind::behavior, "aggregate", std::move(parameters));
}

Response aggregated(const Situation& now, Parameters parameters = {}) {
  return aggregator(std::move(parameters))->respond(now.perception());
}

}  // namespace

TEST_CASE("aggregate: in the end all are within a radius") {
  for (const char* from : {"team", "messages"}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      CAPTURE(from, seed);
      Group group("aggregate", {{"distance", 0.3}, {"from", std::string(from)}},
                  Group::scattered(10, 3.0, seed));
      REQUIRE(group.radius() > 2.0);
      group.run(60.0);
      // The middle of the others is 10/9 as far away as the middle of all.
      CHECK(group.radius() <= 0.9 * 0.3 + 1e-9);
      const auto end = group.poses();
      group.run(10.0);
      CHECK(group.poses() == end);
    }
  }
}

TEST_CASE("aggregate: any control period will do, and a robot that stands does not aggregate") {
  const auto start = Group::scattered(6, 1.0, 3);
  for (const double period : {1e-3, 1e-2, 0.1}) {
    CAPTURE(period);
    Group group("aggregate", {}, start);
    group.run(15.0, period);
    CHECK(group.radius() <= 0.3);
  }
  Group slow("aggregate", {{"speed", 0.0}}, start);
  slow.run(15.0);
  CHECK(slow.radius() > 0.5);
}

TEST_CASE("aggregate: out of each other's reach, groups stay groups") {
  std::vector<Pose> two{{0, 0, 0}, {1, 0, 0}, {10, 0, 0}, {11, 0, 0}};
  Group group("aggregate", {}, two, 3.0);
  group.run(60.0);
  CHECK(distance(group.poses()[0], group.poses()[1]) <= 0.3);
  CHECK(distance(group.poses()[2], group.poses()[3]) <= 0.3);
  CHECK(distance(group.poses()[1], group.poses()[2]) > 9.0);
}

TEST_CASE("aggregate: it drives to the middle of all that it perceives, and stops near it") {
  const Response there = aggregated(Situation().mate("a", 1, 0).mate("b", 0, 1));
  CHECK(there.command.turn == Approx(4.0 * radians(45)));
  CHECK(there.command.forward == Approx(0.2 * std::cos(radians(45))));
  CHECK(there.activation == 1.0);
  const Response behind = aggregated(Situation().mate("a", -1, 0.001));
  CHECK(behind.command.forward == 0.0);
  // The middle of (1, 0) and (-0.5, 0) is 0.25 m away: near enough, though one of them is far.
  for (const Situation& now :
       {Situation().mate("a", 1, 0).mate("b", -0.5, 0), Situation().mate("a", 0, 0), Situation()}) {
    const Response response = aggregated(now);
    CHECK(response.command == Motion{});
    CHECK(response.activation == 0.0);
    CHECK(response.strength == 0.0);
  }
}

TEST_CASE("aggregate: it says when it is among the others, and when it is not any more") {
  const auto behavior = aggregator();
  const auto at = [&](const Situation& now) {
    const auto events = behavior->respond(now.perception()).events;
    return events.empty() ? std::string() : std::string(events.at(0).name);
  };
  CHECK(at(Situation().mate("a", 1, 0)).empty());
  CHECK(at(Situation().mate("a", 0.3, 0)) == "aggregated");
  CHECK(at(Situation().mate("a", 0.2, 0)).empty());
  CHECK(at(Situation().mate("a", 0.31, 0)) == "apart");
  CHECK(at(Situation().mate("a", 0.2, 0)) == "aggregated");
  CHECK(at(Situation()) == "apart");
  CHECK(at(Situation()).empty());
}

TEST_CASE("aggregate: parameters that mean nothing are refused") {
  CHECK_THROWS_WITH(aggregator({{"distance", -1.0}}), Catch::Contains("distance"));
  CHECK_THROWS_WITH(aggregator({{"from", std::string("all")}}), Catch::Contains("messages"));
}
