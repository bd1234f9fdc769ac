// Properties of every coordinator that needs no file.
#include <cmath>
#include <string>
#include <utility>

#include "support.h"
#include "wheels.h"

using namespace elsie;
using namespace elsie::test;

namespace {

const char* const kAll[] = {
    "arbiter_suppression", "arbiter_action_selection", "arbiter_subsumption", "arbiter_voting",
    "arbiter_strength",    "fusion_vector_summation",  "fusion_fuzzy",        "fusion_interval"};
// Coordinators that use activations; the other two use only the user's priorities.
const char* const kByActivation[] = {
    "arbiter_action_selection", "arbiter_subsumption", "arbiter_voting",
    "arbiter_strength",         "fusion_fuzzy",        "fusion_interval"};

}  // namespace

TEST_CASE("Without behaviours the command is zero") {
  for (const char* name : kAll) {
    CAPTURE(name);
    Team nobody;
    Coordinated robot(name, nobody);
    CHECK(robot.decide() == Motion{});
    CHECK(robot.rate({wheels(0, 0), wheels(5, 5)}).size() == 2);
    robot.sets();
  }
}

TEST_CASE("A single active behaviour gets its way") {
  for (const char* name : kAll) {
    CAPTURE(name);
    Team team;
    team.member("alone", 1, wheels(7.5, 12.5));  // also on the voters' grid
    Coordinated robot(name, team);
    test::check_near(robot.decide(), wheels(7.5, 12.5));
    CHECK(team.trace(0).share == Approx(1.0));
    CHECK(team.trace(0).weight == Approx(1.0));
    CHECK(team.reason(0) != "");
    CHECK(team.trace(0).inhibited_by == -1);
  }
}

TEST_CASE("When nobody is active the robot stands still, and the trace says why") {
  for (const char* name : kByActivation) {
    CAPTURE(name);
    Team team;
    team.member("a", 1, active(0.0, wheels(5, 5))).member("b", 2, active(0.0, wheels(-5, 5)));
    Coordinated robot(name, team);
    CHECK(robot.decide() == Motion{});
    for (const Member& member : team.members()) {
      CHECK(member.trace.share == 0.0);
      CHECK_THAT(member.trace.reason,
                 Catch::Equals("not active") || Catch::Equals("nobody is active"));
    }
    // No command is desirable to anybody.
    if (std::string(name) != "arbiter_strength") {
      for (const double degree : robot.rate({wheels(0, 0), wheels(5, 5)})) {
        CHECK(degree == 0.0);
      }
    }
  }
}

TEST_CASE("A coordinator decides the same again after a reset") {
  for (const char* name : kAll) {
    CAPTURE(name);
    Team team;
    team.member("a", 1, active(0.7, wheels(10, 20))).member("b", 1, active(0.7, wheels(20, 10)));
    Coordinated robot(name, team);
    const Motion first = robot.decide();
    team.answer(0).activation = 0.1;
    robot.decide_at(1);
    team.answer(0).activation = 0.7;
    robot.reset();
    CHECK(robot.decide_at(0) == first);
  }
}

TEST_CASE("An arbiter that lets one behaviour decide hands that one's wishes outwards") {
  for (const char* name :
       {"arbiter_suppression", "arbiter_action_selection", "arbiter_subsumption"}) {
    CAPTURE(name);
    Team team;
    team.member("loser", 1, active(0.5, wheels(1, 1)))
        .member("winner", 2, active(0.9, wheels(5, 5)));
    team.rating([](const Motion& c) { return rates(c).left > 0 ? 0.75 : 0.25; })
        .sets({FuzzySet::triangle(3, 1), FuzzySet::triangle(4, 1)});
    Coordinated robot(name, team);
    CHECK(rates(robot.decide()) == WheelRates{5, 5});
    CHECK(robot.rate({wheels(1, 0), wheels(-1, 0)}) == std::vector<double>{0.75, 0.25});
    CHECK(robot.sets().left == FuzzySet::triangle(3, 1));
    CHECK(robot.sets().right == FuzzySet::triangle(4, 1));
  }
}

TEST_CASE("Whatever behaviours answer, decisions are finite and traces complete") {
  const std::pair<const char*, test::Parameters> all[] = {
      {"arbiter_suppression", {}},
      {"arbiter_action_selection", {{"margin", 0.2}, {"hold", 0.05}}},
      {"arbiter_action_selection", {{"by_priority", true}}},
      {"arbiter_subsumption", {{"hold", 0.03}, {"threshold", 0.3}}},
      {"arbiter_voting", {{"margin", 0.05}, {"smoothing", 3.0}, {"interpolate", true}}},
      {"arbiter_voting", {{"set", std::string("arcs")}, {"activation", std::string("ignore")}}},
      {"arbiter_strength", {}},
      {"arbiter_strength", {{"activation", std::string("gate")}}},
      {"fusion_vector_summation", {{"weighted", true}}},
      {"fusion_interval", {}},
      {"fusion_fuzzy", {{"defuzzification", std::string("centre_of_largest_area")}}},
      {"fusion_fuzzy", {{"combination", std::string("probabilistic_sum")}}},
      {"fusion_fuzzy", {{"combination", std::string("min")}, {"weighting", std::string("clip")}}},
      {"fusion_fuzzy",
       {{"combination", std::string("bounded_product")}, {"conflict", std::string("unite")}}}};
  const double extremes[] = {0.0, 1e-12, 5.0, -5.0, 25.0, 1e3, -1e6};
  Random random(11);
  const auto number = [&] {
    return random.chance(0.5) ? random.uniform(-30, 30)
                              : extremes[static_cast<std::size_t>(random.uniform(0, 7))];
  };
  for (const auto& [name, parameters] : all) {
    CAPTURE(name);
    for (int round = 0; round < 20; ++round) {
      Team team;
      const int size = static_cast<int>(random.uniform(1, 6));
      for (int i = 0; i < size; ++i) {
        team.member("m", number(), Motion{});
      }
      Coordinated robot(name, team, parameters);
      for (int step = 0; step < 10; ++step) {
        for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i) {
          Response& answer = team.answer(i);
          answer.command = WheelPair().motion({number(), number()});
          answer.activation = random.chance(0.3) ? 0.0 : random.uniform();
          answer.strength = random.chance(0.3) ? 0.0 : random.uniform();
          answer.speed_strength = random.chance(0.3) ? 0.0 : random.uniform();
          answer.turn_strength = random.chance(0.3) ? 0.0 : random.uniform();
        }
        const Motion command = robot.decide_at(0.01 * step);
        REQUIRE(command.is_finite());
        double sum = 0.0;
        for (const Member& member : team.members()) {
          REQUIRE(std::isfinite(member.trace.weight));
          REQUIRE((member.trace.share >= 0.0 && member.trace.share <= 1.0 + 1e-9));
          REQUIRE(std::string(member.trace.reason) != "");
          REQUIRE((member.trace.inhibited_by >= -1 && member.trace.inhibited_by < size));
          sum += member.trace.share;
        }
        // All of it belongs to some member, or nobody decided and the robot stands still.
        REQUIRE((std::abs(sum - 1.0) < 1e-9 || (sum == 0.0 && command == Motion{})));
        for (const double degree : robot.rate({wheels(0, 0), wheels(number(), number())})) {
          REQUIRE((degree >= 0.0 && degree <= 1.0));
        }
        const CommandSets sets = robot.sets();
        for (const FuzzySet* set : {&sets.left, &sets.right}) {
          double last = -1e300;
          for (const FuzzySet::Point& point : set->points) {
            REQUIRE((point.x >= last && point.degree >= 0.0 && point.degree <= 1.0));
            last = point.x;
          }
        }
      }
    }
  }
}
