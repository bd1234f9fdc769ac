#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "shipped.h"
#include "situation.h"

using namespace elsie;
using elsie::test::Situation;

namespace {

plugin::Object<Behavior> keeper(test::Parameters parameters = {}) {
  return test::make<Behavior>(PluginKind::behavior, "keep_formation", std::move(parameters));
}

bool reports(const Response& response, const char* name) {
  for (const Event& event : response.events) {
    if (event.name == std::string_view(name)) {
      return true;
    }
  }
  return false;
}

/// Whether a robot at this place is in position; the leader is at (1, 2) and heads north.
bool is_place(const test::Parameters& parameters, double back, double left, int team_index = 1,
              int leader_index = 0) {
  Situation now;
  now.at(1 - left, 2 - back, 90).mate("leader", 1, 2, true, 90, leader_index);
  now.self.team_index = team_index;
  return reports(keeper(parameters)->respond(now.perception()), "in_position");
}

/// Slot 1 of a column, 0.3 m behind a leader at the origin that heads east.
Response in_column(double x, double y = 0.0, double heading_deg = 0.0) {
  Situation now;
  now.at(x, y, heading_deg).mate("leader", 0, 0, true);
  return keeper({{"formation", "column"}, {"slot", std::int64_t{1}}})->respond(now.perception());
}

}  // namespace

TEST_CASE("The places of the four formations") {
  const auto place = [](const char* formation, int slot, double back, double left) {
    CAPTURE(formation, slot);
    const test::Parameters parameters{
        {"formation", formation}, {"slot", std::int64_t{slot}}, {"spacing", 0.5}};
    CHECK(is_place(parameters, back, left));
    CHECK_FALSE(is_place(parameters, back + 0.03, left));
    CHECK_FALSE(is_place(parameters, back, left - 0.03));
  };
  place("line", 1, 0, 0.5);
  place("line", 2, 0, -0.5);
  place("line", 3, 0, 1.0);
  place("line", 4, 0, -1.0);
  place("column", 1, 0.5, 0);
  place("column", 2, 1.0, 0);
  place("column", 5, 2.5, 0);
  place("wedge", 1, 0.5, 0.5);
  place("wedge", 2, 0.5, -0.5);
  place("wedge", 3, 1.0, 1.0);
  place("wedge", 4, 1.0, -1.0);
  place("diamond", 1, 0.5, 0.5);
  place("diamond", 2, 0.5, -0.5);
  place("diamond", 3, 1.0, 0);
  place("diamond", 4, 1.5, 0.5);
  place("diamond", 5, 1.5, -0.5);
  place("diamond", 6, 2.0, 0);
}

TEST_CASE("Without a slot, followers count in file order, wherever the leader stands in it") {
  const test::Parameters column{{"formation", "column"}};
  const auto slot = [&](int team_index, int leader_index) {
    for (int number = 1; number < 10; ++number) {
      if (is_place(column, 0.3 * number, 0, team_index, leader_index)) {
        return number;
      }
    }
    return 0;
  };
  CHECK(slot(1, 0) == 1);
  CHECK(slot(3, 0) == 3);
  CHECK(slot(0, 2) == 1);
  CHECK(slot(1, 2) == 2);
  CHECK(slot(3, 2) == 3);
}

TEST_CASE("The speed grows with the distance between the dead zone and the controlled zone") {
  const auto forward = [](double behind_m) { return in_column(-0.3 - behind_m).command.forward; };
  CHECK(forward(0.0) == Approx(0.0).margin(1e-9));
  CHECK(forward(0.0199) == Approx(0.0).margin(1e-9));
  CHECK(forward(0.0201) == Approx(0.3 * 0.0201 / 0.3));
  CHECK(forward(0.15) == Approx(0.15));
  CHECK(forward(0.2999) == Approx(0.2999));
  CHECK(forward(0.3001) == Approx(0.3));
  CHECK(forward(2.0) == Approx(0.3));
}

TEST_CASE("It steers to its place; near it, it backs up, far from it, it turns round") {
  Motion aside = in_column(-0.3, -1.0).command;
  CHECK(aside.forward == Approx(0.0).margin(1e-9));
  CHECK(aside.turn == Approx(4 * radians(90)));
  Motion slanting = in_column(-1.3, 1.0).command;
  CHECK(slanting.forward == Approx(0.3 * std::cos(radians(45))));
  CHECK(slanting.turn == Approx(-4 * radians(45)));
  const Motion ahead = in_column(-0.2).command;
  CHECK(ahead.forward == Approx(-0.1));
  CHECK(ahead.turn == Approx(0.0).margin(1e-9));
  const Motion far_ahead = in_column(0.1).command;
  CHECK(far_ahead.forward == 0.0);
  CHECK(std::abs(far_ahead.turn) == Approx(4 * radians(180)));
}

TEST_CASE("In its place behind a leader that stands it turns as the leader does") {
  const Motion turn = in_column(-0.3, 0, -40).command;
  CHECK(turn.forward == Approx(0.0).margin(1e-9));
  CHECK(turn.turn == Approx(4 * radians(40)));
}

TEST_CASE("It moves along with the formation instead of lagging behind it") {
  const auto behavior = keeper({{"formation", "column"}, {"slot", std::int64_t{1}}});
  Motion last{};
  for (int i = 0; i <= 200; ++i) {
    const double x = 0.001 * i;  // 0.1 m/s
    Situation now;
    now.at(x - 0.3, 0, 0).mate("leader", x, 0, true).time(0.01 * i);
    last = behavior->respond(now.perception()).command;
  }
  CHECK(last.forward == Approx(0.1));
  CHECK(last.turn == Approx(0.0).margin(1e-9));
  // Another leader at another place is not a jump of the first one.
  Situation now;
  now.at(-0.1, 0, 0).mate("other", 0.2, 0, true, 0, 3).time(2.01);
  CHECK(behavior->respond(now.perception()).command.forward == Approx(0.0).margin(1e-9));
}

TEST_CASE("Without a leader in reach, or as one itself, it has no place to keep") {
  Situation alone, leading;
  alone.mate("mate", 0.3, 0);
  leading.mate("leader", 1, 0, true);
  leading.self.is_leader = true;
  for (Situation* now : {&alone, &leading}) {
    const Response response = keeper()->respond(now->perception());
    CHECK(response.command == Motion{});
    CHECK(response.activation == 0.0);
    CHECK(response.strength == 0.0);
    CHECK(response.events.empty());
  }
}

TEST_CASE("The farther from its place, the higher the activation") {
  CHECK(in_column(-0.3).activation == 0.2);
  CHECK(in_column(-0.35).activation == 0.2);
  CHECK(in_column(-0.45).activation == Approx(0.5));
  CHECK(in_column(-0.61).activation == 1.0);
}

TEST_CASE("It reports when it comes into position and when it leaves it") {
  const auto behavior = keeper({{"formation", "column"}, {"slot", std::int64_t{1}}});
  const auto at = [&](double behind_m) {
    Situation now;
    now.at(-0.3 - behind_m, 0, 0).mate("leader", 0, 0, true);
    return behavior->respond(now.perception());
  };
  Response response = at(0.1);
  CHECK(reports(response, "leader_in_reach"));
  CHECK(response.events.size() == 1);
  CHECK(reports(at(0.01), "in_position"));
  CHECK(at(0.29).events.empty());
  CHECK(reports(at(0.31), "out_of_position"));
  CHECK(at(0.29).events.empty());
  CHECK(reports(at(0.0), "in_position"));
  CHECK(reports(behavior->respond(Situation().perception()), "leader_out_of_reach"));
  CHECK(at(0.0).events.size() == 2);
  Random random;
  behavior->reset(random);
  CHECK(at(0.0).events.size() == 2);
}

TEST_CASE("A dead zone as large as the controlled zone is refused") {
  CHECK_THROWS_WITH(keeper({{"dead_zone", 0.3}}),
                    Catch::Contains("dead_zone is 0.3 m and controlled_zone 0.3 m"));
}
