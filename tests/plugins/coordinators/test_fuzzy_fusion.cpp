#include "support.h"
#include "wheels.h"

using namespace elsie;
using namespace elsie::test;

namespace {

CommandSets both(const FuzzySet& set) { return {set, set}; }
CommandSets triangle(double centre, double half_width) {
  return both(FuzzySet::triangle(centre, half_width));
}
FuzzySet box(double from, double to, double degree = 1.0) {
  return {{{from, 0}, {from, degree}, {to, degree}, {to, 0}}};
}

Motion fused(Team& team, const char* combination, const char* defuzzification = "centre_of_gravity",
             const char* weighting = "scale") {
  Coordinated robot("fusion_fuzzy", team,
                    {{"combination", std::string(combination)},
                     {"defuzzification", std::string(defuzzification)},
                     {"weighting", std::string(weighting)}});
  return robot.decide();
}

}  // namespace

TEST_CASE("Defuzzifying last gives another command than averaging what was defuzzified first") {
  // One is sure, the other one vague: wide sets have more weight because of their area.
  Team team;
  team.member("sure", 1, wheels(0, 0)).sets(triangle(0, 5));
  team.member("vague", 1, wheels(20, 20)).sets(triangle(20, 10));
  // areas 5 and 10, apart from each other: (5 x 0 + 10 x 20) / 15
  check_near(fused(team, "max"), wheels(40.0 / 3, 40.0 / 3));
  CHECK(team.trace(0).share == Approx(1.0 / 3));
  CHECK(team.trace(1).share == Approx(2.0 / 3));
  CHECK(team.reason(0) == "united");
  Coordinated averaging("fusion_vector_summation", team);
  check_near(averaging.decide(), wheels(10, 10));
}

TEST_CASE("Where sets overlap, the operators differ") {
  // 1 from 0 to 2, and 1/2 from 1 to 4.
  const auto with = [](const char* combination) {
    Team team;
    team.member("a", 1, Motion{}).sets(both(box(0, 2)));
    team.member("b", 1, Motion{}).sets(both(box(1, 4, 0.5)));
    return rates(fused(team, combination)).left;
  };
  CHECK(with("max") == Approx((2 * 1.0 + 1 * 3.0) / 3));                // 1 on [0,2], 1/2 on [2,4]
  CHECK(with("probabilistic_sum") == Approx((2 * 1.0 + 1 * 3.0) / 3));  // 1 + 1/2 - 1/2 = 1
  CHECK(with("bounded_sum") == Approx((2 * 1.0 + 1 * 3.0) / 3));        // min(1, 1.5)
  CHECK(with("min") == Approx(1.5));                                    // 1/2 on [1,2]
  CHECK(with("product") == Approx(1.5));
  CHECK(with("bounded_product") == Approx(1.5));  // 1 + 1/2 - 1

  // Both halves: here the sums differ, 3/4 and 1 in the overlap.
  const auto halves = [](const char* combination) {
    Team team;
    team.member("a", 1, Motion{}).sets(both(box(0, 2, 0.5)));
    team.member("b", 1, Motion{}).sets(both(box(1, 4, 0.5)));
    return rates(fused(team, combination)).left;
  };
  CHECK(halves("max") == Approx(2.0));  // 1/2 on [0,4]
  CHECK(halves("probabilistic_sum") ==
        Approx((0.5 * 0.5 + 0.75 * 1.5 + 1.0 * 3.0) / (0.5 + 0.75 + 1.0)));
  CHECK(halves("bounded_sum") == Approx((0.5 * 0.5 + 1.0 * 1.5 + 1.0 * 3.0) / 2.5));
  CHECK(halves("min") == Approx(1.5));
  CHECK(halves("product") == Approx(1.5));
  CHECK(halves("bounded_product") == 0.0);  // 1/2 + 1/2 - 1: a conflict
}

TEST_CASE("A conjunction of triangles is where they cross") {
  Team team;
  team.member("a", 1, Motion{}).sets(triangle(0, 10));
  team.member("b", 1, Motion{}).sets(triangle(10, 10));
  check_near(fused(team, "min"), wheels(5, 5));
  CHECK(team.reason(0) == "intersected");
  CHECK(team.trace(0).share == 0.5);
  check_near(fused(team, "min", "mean_of_maximum"), wheels(5, 5));
}

TEST_CASE("When no command suits all, the robot stands still, or the wishes are united after all") {
  Team team;
  team.member("a", 1, Motion{}).sets(triangle(0, 5));
  team.member("b", 1, Motion{}).sets(triangle(20, 5));
  CHECK(fused(team, "min") == Motion{});
  CHECK(team.reason(0) == "no command suits all");
  CHECK(team.trace(0).share == 0.0);
  Coordinated uniting("fusion_fuzzy", team,
                      {{"combination", std::string("min")}, {"conflict", std::string("unite")}});
  check_near(uniting.decide(), wheels(10, 10));
  CHECK(team.reason(0) == "united: no command suits all");
  CHECK(uniting.sets().left.degree(20) == 1.0);
}

TEST_CASE("A weight scales a set or cuts its top off") {
  Team team;
  team.member("light", 1, Motion{}).sets(triangle(0, 5));
  team.member("heavy", 2, Motion{}).sets(triangle(20, 10));
  // scaled: areas 2.5 and 10; clipped at 1/2: three quarters of 5, and 10
  check_near(fused(team, "max"), wheels(16, 16));
  CHECK(team.trace(0).weight == 0.5);
  check_near(fused(team, "max", "centre_of_gravity", "clip"), wheels(200 / 13.75, 200 / 13.75));
}

TEST_CASE("With a conjunction a light wish restricts little") {
  Team team;
  team.member("light", 1, Motion{}).sets(both(box(0, 2)));
  team.member("heavy", 2, Motion{}).sets(both(box(1, 4)));
  // The wish with the small weight allows other commands to the degree one half: 1 on [1,2], 1/2 on
  // [2,4].
  for (const char* weighting : {"scale", "clip"}) {
    check_near(fused(team, "min", "centre_of_gravity", weighting), wheels(4.5 / 2, 4.5 / 2));
  }
}

TEST_CASE("Activation weighs, too") {
  Team team;
  team.member("a", 1, active(0.5, {})).sets(triangle(0, 5));
  team.member("b", 1, Motion{}).sets(triangle(20, 10));
  check_near(fused(team, "max"), wheels(16, 16));
  team.answer(0).activation = 0.0;
  check_near(fused(team, "max"), wheels(20, 20));
  CHECK(team.reason(0) == "not active");
}

TEST_CASE("The mean of maximum follows the strongest wish, the bisector halves the area") {
  Team team;
  team.member("strong", 2, Motion{}).sets(triangle(0, 5));
  team.member("weak", 1, Motion{}).sets(both(box(10, 20)));
  check_near(fused(team, "max", "mean_of_maximum"), wheels(0, 0));
  CHECK(team.trace(0).share == 1.0);
  team.members();
  // areas 5 and 5: the middle of the gap between the halves
  check_near(fused(team, "max", "bisector"), wheels(7.5, 7.5));
}

TEST_CASE("The centre of the largest area takes a side, and the same one for both wheels") {
  Team team;
  const FuzzySet back = FuzzySet::triangle(-10, 5);
  const FuzzySet forth = FuzzySet::triangle(10, 5);
  team.member("left", 1, Motion{}).sets({back, forth});
  team.member("right", 1, Motion{}).sets({forth, back});
  check_near(fused(team, "max"), wheels(0, 0));  // the centre of gravity: between the two, at rest
  // In a tie, that of the first behaviour in the file.
  check_near(fused(team, "max", "centre_of_largest_area"), wheels(-10, 10));
  CHECK(team.trace(0).share == 1.0);
  Team other;
  other.member("right", 1, Motion{}).sets({forth, back});
  other.member("left", 1, Motion{}).sets({back, forth});
  check_near(fused(other, "max", "centre_of_largest_area"), wheels(10, -10));
  Team more;
  more.member("left", 1, Motion{}).sets({back, forth});
  more.member("right", 1.1, Motion{}).sets({forth, back});
  check_near(fused(more, "max", "centre_of_largest_area"), wheels(10, -10));
}

TEST_CASE("Spikes, of no area, are weighed by their degrees") {
  const auto spike = [](double x, double degree) { return both({{{x, 0}, {x, degree}, {x, 0}}}); };
  Team team;
  team.member("a", 1, Motion{}).sets(spike(4, 1.0));
  team.member("b", 1, Motion{}).sets(spike(8, 0.5));
  check_near(fused(team, "max"), wheels(16.0 / 3, 16.0 / 3));
}

TEST_CASE("A behaviour without a wish leaves the others alone, also in a conjunction") {
  Team team;
  team.member("mute", 1, Motion{}).sets({});
  team.member("b", 1, Motion{}).sets(triangle(3, 1));
  check_near(fused(team, "min"), wheels(3, 3));
  Team mute;
  mute.member("mute", 1, wheels(9, 9)).sets({});
  CHECK(fused(mute, "max") == Motion{});
  CHECK(mute.reason(0) == "no wish");
}

TEST_CASE("The combined sets are passed outwards, and so are ratings") {
  Team team;
  team.member("a", 1, Motion{}).sets(triangle(0, 5)).rating([](const Motion&) { return 0.8; });
  team.member("b", 2, Motion{}).sets(triangle(20, 5)).rating([](const Motion& c) {
    return rates(c).left > 0 ? 0.6 : 0.1;
  });
  Coordinated robot("fusion_fuzzy", team);
  robot.decide();
  CHECK(robot.sets().left.degree(0) == 0.5);
  CHECK(robot.sets().right.degree(20) == 1.0);
  CHECK(robot.rate({wheels(1, 0), wheels(-1, 0)})[0] == Approx(0.6));  // max(0.8 / 2, 0.6)
  CHECK(robot.rate({wheels(1, 0), wheels(-1, 0)})[1] == Approx(0.4));
}
