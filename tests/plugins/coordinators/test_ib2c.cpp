// Behaviours of iB2C: activity, target rating, inhibition, stimulation, and the fusion of them.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "elsie/testing/checker.h"
#include "elsie/testing/world.h"

#include "allocations.h"
#include "support.h"

using namespace elsie;
using Catch::Contains;
using namespace elsie::test;

namespace {

ElementValue ib2c_link(const char* kind, const char* by, const char* of, double factor = 1.0) {
  return {kind, {{"by", std::string(by)}, {"of", std::string(of)}, {"factor", factor}}};
}

/// What the fusion publishes: "activity", "rating".
double ib2c_published(Coordinated& robot, const std::string& name) {
  for (const PublishedNumber& number : robot.declaration().published) {
    if (number.name == name) {
      return number.get(*robot);
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

const char* const kIb2cFusions[] = {"maximum", "average", "sum"};

}  // namespace

TEST_CASE("The three fusion behaviours have the command, activity and rating of their formulas") {
  const double a = 0.8, b = 0.4;
  const auto fused = [&](const char* fusion) {
    Team team;
    team.member("a", 1, active(a, {0.2, 0, 1})).member("b", 1, active(b, {0.1, 0, -2}));
    Coordinated robot("fusion_ib2c", team, {{"fusion", std::string(fusion)}});
    const Motion command = robot.decide();
    return std::vector<double>{command.forward, command.turn, ib2c_published(robot, "activity"),
                               ib2c_published(robot, "rating")};
  };
  const std::vector<double> maximum = fused("maximum");
  CHECK(maximum[0] == Approx(0.2));
  CHECK(maximum[1] == Approx(1.0));
  CHECK(maximum[2] == Approx(a));
  CHECK(maximum[3] == Approx(a));
  const std::vector<double> average = fused("average");
  CHECK(average[0] == Approx((a * 0.2 + b * 0.1) / (a + b)));
  CHECK(average[1] == Approx((a * 1.0 - b * 2.0) / (a + b)));
  CHECK(average[2] == Approx((a * a + b * b) / (a + b)));
  CHECK(average[3] == Approx((a * a + b * b) / (a + b)));  // ratings are a and b
  const std::vector<double> sum = fused("sum");
  CHECK(sum[0] == Approx((a * 0.2 + b * 0.1) / a));
  CHECK(sum[1] == Approx((a * 1.0 - b * 2.0) / a));
  CHECK(sum[2] == Approx((a * a + b * b) / a));
  CHECK(sum[3] == Approx((a * a + b * b) / (a + b)));
}

TEST_CASE("Inhibition takes its part of the activation: iota = s (1 - i)") {
  for (const double inhibitor : {0.0, 0.3, 0.7, 1.0}) {
    CAPTURE(inhibitor);
    Team team;
    team.member("avoid", 1, active(inhibitor, {0, 0, 1}))
        .member("seek", 1, active(0.9, {0.2, 0, 0}));
    Coordinated robot("fusion_ib2c", team, {}, {ib2c_link("inhibit", "avoid", "seek", 0.8)});
    robot.decide();
    CHECK(team.trace("seek").weight == Approx((1.0 - 0.8 * inhibitor) * 0.9));
    CHECK(team.trace("avoid").weight == Approx(inhibitor));
    CHECK(team.trace("seek").inhibited_by == (0.8 * inhibitor > 0.5 ? 0 : -1));
    CHECK(team.reason(1) == (0.8 * inhibitor > 0.5 ? "inhibited"
                             : inhibitor > 0.0     ? "partly inhibited"
                                                   : "active"));
    CHECK(team.asked("seek") == 1);  // its target rating does not depend on its activation
  }
}

TEST_CASE("Of several inhibitions the strongest counts, in whatever order the behaviours stand") {
  for (const bool turned : {false, true}) {
    Team team;
    if (turned) {
      team.member("c", 1, active(1.0, {1, 0, 0}));
    }
    team.member("a", 1, active(0.3, {0, 0, 1})).member("b", 1, active(0.6, {0, 0, 1}));
    if (!turned) {
      team.member("c", 1, active(1.0, {1, 0, 0}));
    }
    Coordinated robot("fusion_ib2c", team, {},
                      {ib2c_link("inhibit", "a", "c"), ib2c_link("inhibit", "b", "c")});
    robot.decide();
    CHECK(team.trace("c").weight == Approx(0.4));
  }
}

TEST_CASE("An inhibited behaviour inhibits less: a chain in one step") {
  Team team;
  team.member("c", 1, active(1.0, {1, 0, 0}))
      .member("b", 1, active(1.0, {0, 0, 1}))
      .member("a", 1, active(0.75, {0, 0, -1}));
  Coordinated robot("fusion_ib2c", team, {},
                    {ib2c_link("inhibit", "a", "b"), ib2c_link("inhibit", "b", "c")});
  robot.decide();
  CHECK(team.trace("b").weight == Approx(0.25));
  CHECK(team.trace("c").weight == Approx(0.75));
}

TEST_CASE(
    "A behaviour with a stimulation is as much stimulated as its strongest stimulus is active") {
  Team team;
  team.member("grasp", 1, active(0.5, {0.1, 0, 0}))
      .member("see", 1, active(0.0, {0, 0, 1}))
      .member("hear", 1, active(0.0, {0, 0, 1}));
  Coordinated robot(
      "fusion_ib2c", team, {},
      {ib2c_link("stimulate", "see", "grasp"), ib2c_link("stimulate", "hear", "grasp")});
  CHECK(robot.decide() == Motion{});
  CHECK(team.reason(0) == "not stimulated");
  team.answer(1).activation = 0.2;
  team.answer(2).activation = 0.8;
  robot.decide();
  CHECK(team.trace("grasp").weight == Approx(0.8 * 0.5));
}

TEST_CASE("Two that inhibit each other do so one step late, and settle") {
  Team team;
  team.member("a", 1, active(0.8, {0, 0, 1})).member("b", 1, active(0.6, {0, 0, -1}));
  Coordinated robot("fusion_ib2c", team, {},
                    {ib2c_link("inhibit", "a", "b"), ib2c_link("inhibit", "b", "a")});
  robot.decide();
  CHECK(team.trace("a").weight == Approx(0.8));  // b was not active before
  CHECK(team.trace("b").weight == Approx(0.6 * 0.2));
  for (int step = 0; step < 100; ++step) {
    robot.decide();
  }
  // a = 0.8 (1 - b) and b = 0.6 (1 - a)
  CHECK(team.trace("a").weight == Approx(0.8 * 0.4 / (1.0 - 0.48)));
  CHECK(team.trace("b").weight == Approx(0.6 * 0.2 / (1.0 - 0.48)));
  robot.reset();
  robot.decide();
  CHECK(team.trace("a").weight == Approx(0.8));
}

TEST_CASE("The principles of iB2C hold for whatever behaviours answer") {
  Random random(5);
  const auto level = [&] { return random.chance(0.2) ? 0.0 : random.uniform(); };
  for (const std::string fusion : kIb2cFusions) {
    for (const std::string rating : {"activation", "strength"}) {
      CAPTURE(fusion, rating);
      Team team;
      for (const char* name : {"a", "b", "c", "d"}) {
        team.member(name, random.uniform(0.2, 2.0), Motion{});
      }
      double highest = 0.0;
      for (const Member& member : team.members()) {
        highest = std::max(highest, member.priority());
      }
      Coordinated robot("fusion_ib2c", team, {{"fusion", fusion}, {"rating", rating}},
                        {ib2c_link("inhibit", "a", "c"), ib2c_link("inhibit", "c", "a", 0.5),
                         ib2c_link("stimulate", "b", "d")});
      double c_before = 0.0;  // it inhibits a one step late
      for (int step = 0; step < 300; ++step) {
        double iota[4], target[4], activity[4];
        for (std::size_t i = 0; i < 4; ++i) {
          Response& answer = team.answer(i);
          answer.command = {random.uniform(-1, 1), 0.0, random.uniform(-4, 4)};
          answer.activation = level();
          answer.strength = level();
          target[i] = rating == "strength" ? answer.strength : answer.activation;
        }
        // iota = s (1 - i), and an activity of at most that.
        const auto decide = [&](std::size_t i, double stimulus, double inhibition) {
          iota[i] = team.members()[i].priority() / highest * stimulus * (1.0 - inhibition);
          activity[i] = iota[i] * team.answer(i).activation * team.answer(i).strength;
        };
        decide(0, 1.0, 0.5 * c_before);
        decide(1, 1.0, 0.0);
        decide(2, 1.0, activity[0]);
        decide(3, activity[1], 0.0);
        c_before = activity[2];

        const Motion command = robot.decide();
        double most = 0.0, sum = 0.0, least = 1.0, most_rating = 0.0, least_rating = 1.0;
        std::size_t strongest = 0;
        for (std::size_t i = 0; i < 4; ++i) {
          REQUIRE((activity[i] >= 0.0 && activity[i] <= iota[i] && iota[i] <= 1.0));
          REQUIRE((target[i] > 0.0 || activity[i] == 0.0));  // what is content is not active
          if (activity[i] > most) {
            most = activity[i];
            strongest = i;
          }
          if (activity[i] > 0.0) {
            sum += activity[i];
            least = std::min(least, activity[i]);
            most_rating = std::max(most_rating, target[i]);
            least_rating = std::min(least_rating, target[i]);
          }
        }
        double shares = 0.0;
        for (std::size_t i = 0; i < 4; ++i) {
          const bool loses = fusion == "maximum" && i != strongest;
          REQUIRE(team.trace(i).weight == Approx(loses ? 0.0 : activity[i]).margin(1e-12));
          shares += team.trace(i).share;
        }
        const double whole = ib2c_published(robot, "activity");
        const double whole_rating = ib2c_published(robot, "rating");
        REQUIRE((whole >= 0.0 && whole <= 1.0));
        REQUIRE((whole_rating >= 0.0 && whole_rating <= 1.0));
        if (most == 0.0) {
          REQUIRE((whole == 0.0 && whole_rating == 0.0 && command == Motion{}));
          continue;
        }
        REQUIRE(shares == Approx(1.0));
        // The fusion is as active as those that it fuses: between the least and the most active
        // one, or with `sum` up to all of them; and as content.
        constexpr double kRounding = 1e-12;
        REQUIRE(
            (whole_rating >= least_rating - kRounding && whole_rating <= most_rating + kRounding));
        if (fusion == "average") {
          REQUIRE((whole >= least - kRounding && whole <= most + kRounding));
        } else if (fusion == "sum") {
          REQUIRE((whole >= most - kRounding && whole <= std::min(1.0, sum) + kRounding));
        } else {
          REQUIRE(whole == Approx(most));
          REQUIRE(whole_rating == target[strongest]);
          REQUIRE(command == team.answer(strongest).command);
        }
      }
    }
  }
}

TEST_CASE("The maximum fusion lets one decide, and passes its wishes outwards") {
  Team team;
  team.member("a", 1, active(0.4, wheels(1, 1)))
      .member("b", 1, active(0.6, wheels(5, 5)))
      .member("c", 1, active(0.6, wheels(9, 9)));
  team.rating([](const Motion&) { return 0.25; });
  Coordinated robot("fusion_ib2c", team, {{"fusion", std::string("maximum")}});
  CHECK(rates(robot.decide()) == WheelRates{5, 5});  // the first of equals
  CHECK(team.trace("b").share == 1.0);
  CHECK(team.reason(1) == "highest activity");
  CHECK(team.reason(2) == "lower activity");
  CHECK(team.trace("a").inhibited_by == 1);
  CHECK(robot.rate({wheels(5, 5)})[0] == Approx(1.0));
}

TEST_CASE("Priorities stimulate, relative to the highest, and zero leaves a behaviour out") {
  Team team;
  team.member("a", 4, active(0.5, {1, 0, 0}))
      .member("b", 1, active(1.0, {0, 0, 1}))
      .member("c", 0, active(1.0, {0, 0, 1}));
  Coordinated robot("fusion_ib2c", team);
  robot.decide();
  CHECK(team.trace("a").weight == Approx(0.5));
  CHECK(team.trace("b").weight == Approx(0.25));
  CHECK(team.reason(2) == "priority not above zero");
  CHECK(team.asked("c") == 0);
}

TEST_CASE("Links of iB2C that cannot be are refused, and a circle is named") {
  const auto refusal = [](const std::vector<ElementValue>& links) -> std::string {
    Team team;
    team.member("avoid", 1, Motion{}).member("seek", 1, Motion{}).member("grasp", 1, Motion{});
    try {
      Coordinated robot("fusion_ib2c", team, {}, links);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  CHECK_THAT(
      refusal({ib2c_link("inhibit", "avoyd", "seek")}),
      Contains("<inhibit by=\"avoyd\"> names no behaviour") && Contains("did you mean 'avoid'?"));
  CHECK_THAT(refusal({ib2c_link("stimulate", "avoid", "x")}), Contains("it has: avoid, seek"));
  CHECK_THAT(refusal({ib2c_link("inhibit", "seek", "seek")}),
             Contains("links a behaviour to itself"));
  CHECK(
      refusal({ib2c_link("stimulate", "avoid", "seek"), ib2c_link("stimulate", "seek", "avoid")}) ==
      "the <stimulate> links go in a circle: 'avoid' stimulates 'seek' stimulates 'avoid', so none "
      "of them could ever begin; remove one of these links");
  CHECK_THAT(
      refusal({ib2c_link("stimulate", "avoid", "seek"), ib2c_link("stimulate", "grasp", "avoid"),
               ib2c_link("stimulate", "seek", "grasp")}),
      Contains("circle"));
  CHECK(refusal({ib2c_link("stimulate", "avoid", "seek"), ib2c_link("inhibit", "seek", "avoid")}) ==
        "");
  CHECK(refusal({ib2c_link("inhibit", "avoid", "seek"), ib2c_link("inhibit", "seek", "avoid")}) ==
        "");
}

TEST_CASE("iB2C allocates nothing in a step") {
  Team team;
  team.member("a", 1, wheels(9, 9)).member("b", 1, wheels(5, -5)).member("c", 2, wheels(1, 1));
  Coordinated robot("fusion_ib2c", team, {},
                    {ib2c_link("inhibit", "a", "b"), ib2c_link("stimulate", "b", "c")});
  Random random(1);
  const auto decide = [&](int times) {
    for (int step = 0; step < times; ++step) {
      for (std::size_t i = 0; i < 3; ++i) {
        team.answer(i).command = wheels(random.uniform(-40, 40), random.uniform(-40, 40));
        team.answer(i).activation = random.chance(0.2) ? 0.0 : random.uniform();
      }
      robot.decide();
    }
  };
  decide(300);
  const long before = allocations();
  decide(300);
  CHECK(allocations() == before);
}

TEST_CASE("iB2C without behaviours stands still, and has no fault that the checker finds") {
  for (const char* fusion : kIb2cFusions) {
    Team nobody;
    Coordinated robot("fusion_ib2c", nobody, {{"fusion", std::string(fusion)}});
    CHECK(robot.decide() == Motion{});
    CHECK(std::isnan(ib2c_published(robot, "activity")));
  }
  testing::CheckOptions options;
  options.variants = 5;
  options.steps = 2000;
  options.members = {"avoid_obstacle", "go_to_point", "recharge"};
  options.elements = {ib2c_link("inhibit", "avoid_obstacle", "go_to_point"),
                      ib2c_link("inhibit", "go_to_point", "avoid_obstacle"),
                      ib2c_link("stimulate", "go_to_point", "recharge")};
  const auto findings = testing::check_plugin(PluginKind::coordinator, "fusion_ib2c", options);
  CAPTURE(findings);
  CHECK(findings.empty());
}

TEST_CASE("In its world, a robot passes boxes if avoiding inhibits the drive, and else hits one") {
  const auto outcome = [](const char* coordinator) {
    testing::WorldOptions options;
    if (coordinator) {
      options.set = {"robot[r1]/coordinator=" + std::string(coordinator)};
    }
    return testing::World::from_file(source_path("worlds/inhibition.xml"), options).run().outcome;
  };
  CHECK(outcome(nullptr) == simulation::Outcome::success);
  CHECK(outcome("<fusion_ib2c/>") == simulation::Outcome::failure);
  CHECK(outcome("<arbiter_action_selection/>") == simulation::Outcome::failure);
  CHECK(
      outcome("<fusion_ib2c fusion=\"maximum\"><inhibit by=\"avoid_obstacle\" of=\"go_to_point\"/>"
              "</fusion_ib2c>") == simulation::Outcome::success);
}
