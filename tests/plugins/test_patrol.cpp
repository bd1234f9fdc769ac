#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "shipped.h"
#include "situation.h"

using namespace elsie;
using namespace elsie::test;

namespace {

ElementValue patrol_place(double x, double y, double wait = 0.0) {
  return {"place", {{"x", x}, {"y", y}, {"wait", wait}}};
}

const std::vector<ElementValue> kPatrolPlaces{patrol_place(1, 0), patrol_place(1, 1),
                                              patrol_place(0, 1)};

plugin::Object<Behavior> patrolling(Parameters parameters = {},
                                    const std::vector<ElementValue>& places = kPatrolPlaces) {
  return test::make<Behavior>(PluginKind::behavior, "patrol", std::move(parameters), places);
}

/// A robot that obeys it, without a body: the places to which it came, by their number, and "." for
/// the end.
std::string patrol_visits(Behavior& behavior, double seconds, double period_s = 0.05,
                          const std::vector<ElementValue>& places = kPatrolPlaces) {
  std::string found;
  Pose pose;
  const auto steps = static_cast<int>(seconds / period_s + 0.5);
  Situation now;
  for (int step = 0; step < steps; ++step) {
    now.at(pose.x, pose.y, degrees(pose.heading_rad)).time(step * period_s).period(period_s);
    const Response response = behavior.respond(now.perception());
    for (const Event& event : response.events) {
      if (event.name == std::string_view("patrolled")) {
        found += '.';
        continue;
      }
      for (std::size_t i = 0; i < places.size(); ++i) {
        const double x = std::get<double>(places[i].parameters.at("x"));
        const double y = std::get<double>(places[i].parameters.at("y"));
        if (distance(pose, {x, y}) <= 0.05) found += static_cast<char>('1' + i);
      }
    }
    pose.heading_rad = wrap_angle(pose.heading_rad + response.command.turn * period_s);
    pose.x += response.command.forward * period_s * std::cos(pose.heading_rad);
    pose.y += response.command.forward * period_s * std::sin(pose.heading_rad);
  }
  return found;
}

}  // namespace

TEST_CASE("patrol: it visits the places in the order of the file, again and again") {
  const auto behavior = patrolling();
  CHECK_THAT(patrol_visits(*behavior, 60.0), Catch::StartsWith("123.123.123."));
  for (const double period : {1e-3, 1e-2, 0.1}) {
    CAPTURE(period);
    CHECK_THAT(patrol_visits(*patrolling(), 30.0, period), Catch::StartsWith("123.12"));
  }
}

TEST_CASE("patrol: once is once, and then it is not active") {
  const auto behavior = patrolling({{"order", std::string("once")}});
  CHECK(patrol_visits(*behavior, 60.0) == "123.");
  const Response response = behavior->respond(Situation().at(5, 5, 0).perception());
  CHECK(response.command == Motion{});
  CHECK(response.activation == 0.0);
  CHECK(response.strength == 0.0);
  Random random;
  behavior->reset(random);
  CHECK(patrol_visits(*behavior, 60.0) == "123.");
}

TEST_CASE("patrol: in a random order each place comes after each other one, never after itself") {
  const auto behavior = patrolling({{"order", std::string("random")}});
  const std::string way = patrol_visits(*behavior, 1500.0);
  REQUIRE(way.size() > 200);
  std::set<std::string> pairs;
  for (std::size_t i = 1; i < way.size(); ++i) pairs.insert(way.substr(i - 1, 2));
  CHECK(pairs == std::set<std::string>{"12", "13", "21", "23", "31", "32"});
  std::set<char> first;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto other = patrolling({{"order", std::string("random")}});
    Situation now;
    now.seed(seed);
    const Motion command = other->respond(now.perception()).command;
    first.insert(command.turn == 0.0 ? '1' : command.turn < 3.0 ? '2' : '3');
  }
  CHECK(first.size() == 3);
}

TEST_CASE("patrol: it waits by the clock, whether it is asked or not") {
  const auto behavior = patrolling({}, {patrol_place(0, 0, 5.0), patrol_place(1, 0)});
  const auto at = [&](double time_s, double x = 0.0) {
    Situation now;
    return behavior->respond(now.at(x, 0, 0).time(time_s).perception());
  };
  const Response come = at(10.0);
  REQUIRE(come.events.size() == 1);
  CHECK(come.events[0].name == "at_place");
  CHECK(come.command == Motion{});
  CHECK(come.activation == 1.0);
  CHECK(at(12.0, 0.3).command == Motion{});  // it was pushed, and waits on
  CHECK(at(14.99).command == Motion{});
  CHECK(at(15.0).command.forward > 0.0);
  CHECK(at(15.1).command.forward > 0.0);
}

TEST_CASE("patrol: a single place is what go_to_point does") {
  const auto behavior = patrolling({}, {patrol_place(1, 1)});
  const auto point =
      test::make<Behavior>(PluginKind::behavior, "go_to_point", {{"x", 1.0}, {"y", 1.0}});
  for (const Pose& pose : std::vector<Pose>{
           {0, 0, 0}, {0.9, 0.9, 1}, {0.99, 1, 1}, {1, 1, 2}, {0.5, 1, -1}, {1, 0.96, 0}}) {
    CAPTURE(pose.x, pose.y);
    Situation now;
    now.at(pose.x, pose.y, degrees(pose.heading_rad));
    const Response ours = behavior->respond(now.perception());
    const Response theirs = point->respond(now.perception());
    CHECK(ours.command == theirs.command);
    CHECK(ours.activation == theirs.activation);
    CHECK(ours.events.empty() == theirs.events.empty());
  }
}

TEST_CASE("patrol: places may go while it drives") {
  const auto behavior = patrolling();
  CHECK(patrol_visits(*behavior, 8.0) == "12");
  const Declaration* declaration = test::shipped().find(PluginKind::behavior, "patrol");
  plugin::apply_parameters(*declaration, *behavior, {}, {patrol_place(0, 0)});
  const Response response = behavior->respond(Situation().perception());
  REQUIRE_FALSE(response.events.empty());
  CHECK(response.events[0].name == "at_place");
}

TEST_CASE("patrol: a reset on the way begins anew") {
  const auto behavior = patrolling();
  CHECK(patrol_visits(*behavior, 8.0) == "12");
  Random random;
  behavior->reset(random);
  CHECK(patrol_visits(*behavior, 8.0) == "12");
}

TEST_CASE("patrol: when it may go round again, it does") {
  const auto behavior = patrolling({{"order", std::string("once")}});
  CHECK(patrol_visits(*behavior, 30.0) == "123.");
  const Declaration* declaration = test::shipped().find(PluginKind::behavior, "patrol");
  plugin::apply_parameters(*declaration, *behavior, {{"order", std::string("round")}},
                           kPatrolPlaces);
  const Response response = behavior->respond(Situation().at(1, 0, 0).time(31.0).perception());
  REQUIRE(response.events.size() == 1);
  CHECK(response.events[0].name == "at_place");
}

TEST_CASE("patrol: parameters that mean nothing are refused") {
  CHECK_THROWS_WITH(patrolling({{"order", std::string("twice")}}), Catch::Contains("random"));
  CHECK_THROWS_WITH(patrolling({}, {patrol_place(0, 0, -1.0)}), Catch::Contains("wait"));
  CHECK_THROWS_WITH(patrolling({{"tolerance", 0.0}}), Catch::Contains("tolerance"));
}
