// Attractors and repellers of the heading, and the competition of those that put them there.
#include <cmath>
#include <vector>

#include "elsie/testing/checker.h"
#include "elsie/testing/world.h"

#include "allocations.h"
#include "attractors.h"

using namespace elsie;
using Catch::Contains;
using namespace elsie::test;

namespace {

/// A weight after this time without competition: the solution of tau w' = alpha (w - w^3).
double lone_weight(double w0, double alpha, double time, double tau) {
  return 1.0 / std::sqrt(1.0 + (1.0 / (w0 * w0) - 1.0) * std::exp(-2.0 * alpha * time / tau));
}

}  // namespace

TEST_CASE("Two posts far apart leave one attractor between them, close together one on each side") {
  const double sigma = 20.0 * kAttractorPi / 180.0, attraction = 2.0, repulsion = 4.0;
  // The slope of the field at the middle: an attractor while it is negative.
  const auto slope = [&](double psi) {
    const double narrow = psi * psi / (sigma * sigma);
    return -attraction + 2.0 * repulsion * (1.0 - narrow) * std::exp(-0.5 * narrow);
  };
  double low = 0.0, high = sigma;  // without the place, it changes its sign at sigma
  REQUIRE((slope(low) > 0.0 && slope(high) < 0.0));
  for (int halving = 0; halving < 40; ++halving) {
    const double middle = 0.5 * (low + high);
    (slope(middle) > 0.0 ? low : high) = middle;
  }
  const double critical = low;

  for (const double factor : {1.5, 2.0}) {
    CAPTURE(factor);
    const std::vector<double> far =
        AttractorPosts(factor * critical, 20, attraction, repulsion).attractors();
    REQUIRE(far.size() == 1);
    CHECK(far[0] == Approx(0.0).margin(1e-6));
  }
  // In between, whatever the heading is near to attracts it: the middle or the way round.
  CHECK(AttractorPosts(1.02 * critical, 20, attraction, repulsion).attractors().size() == 3);
  for (const double factor : {0.4, 0.98}) {
    CAPTURE(factor);
    AttractorPosts posts(factor * critical, 20, attraction, repulsion);
    const std::vector<double> close = posts.attractors();
    REQUIRE(close.size() == 2);
    CHECK(close[0] == Approx(-close[1]).margin(1e-6));
    CHECK(close[1] > 0.05);
    CHECK(posts.at(0.01) > 0.0);  // the middle repels
    CHECK(posts.at(-0.01) < 0.0);
  }
  // AttractorPosts so close together that the way around is outside both of them.
  CHECK(AttractorPosts(0.4 * critical, 20, attraction, repulsion).attractors()[1] > 0.4 * critical);
}

TEST_CASE("Without a place, the middle of two posts attracts when they are more than sigma off") {
  CHECK(AttractorPosts(1.05 * kAttractorPi / 9.0, 20, 0.0, 4.0).at(0.005) < 0.0);
  CHECK(AttractorPosts(0.95 * kAttractorPi / 9.0, 20, 0.0, 4.0).at(0.005) > 0.0);
}

TEST_CASE("A lone attractor turns the heading by the solution of its equation in any period") {
  for (const double period : {1e-3, 0.01, 0.02, 0.05, 0.1}) {
    CAPTURE(period);
    Team team;
    team.member("place", 1, attractor_wish(2.5));
    Coordinated robot("fusion_attractor_dynamics", team, {{"attraction", 10.0}});
    robot.now.period(period);
    for (double time = 0.0; time < 2.0; time += period) {
      robot.decide();  // until its weight is one
    }
    double off = -2.5;  // of the heading from the place
    for (double time = 0.0; time < 0.6; time += period) {
      team.answer(0).command = attractor_wish(-off);
      off += period * robot.decide().turn;
      // phi' = -lambda sin(phi) has the solution tan(phi / 2) = tan(phi0 / 2) exp(-lambda t)
      const double exact =
          2.0 * std::atan(std::tan(-2.5 / 2.0) * std::exp(-10.0 * (time + period)));
      REQUIRE(off == Approx(exact).margin(2e-5));
    }
  }
}

TEST_CASE("A weight without competition follows its closed form, whatever the period") {
  for (const double period : {1e-3, 0.01, 0.03, 0.1}) {
    for (const double activation : {0.3, 1.0}) {
      CAPTURE(period, activation);
      Team team;
      team.member("a", 1, active(activation, attractor_wish(0)));
      Coordinated robot("fusion_attractor_dynamics", team,
                        {{"tau", 0.2}, {"least", 0.02}, {"threshold", 0.1}});
      robot.now.period(period);
      const double alpha = (activation - 0.1) / 0.9;
      for (int step = 1; step * period <= 2.0; ++step) {
        robot.decide();
        REQUIRE(team.trace(0).weight ==
                Approx(lone_weight(0.02, alpha, step * period, 0.2)).epsilon(1e-6));
      }
    }
  }
}

TEST_CASE("Less active than the threshold, a weight fades and its force ends") {
  Team team;
  team.member("a", 1, attractor_wish(1.0));
  Coordinated robot("fusion_attractor_dynamics", team);
  for (int step = 0; step < 200; ++step) {
    robot.decide();
  }
  CHECK(team.trace(0).weight == Approx(1.0));
  team.answer(0).activation = 0.05;
  robot.decide();
  CHECK(team.reason(0) == "fading");
  for (int step = 0; step < 300; ++step) {
    robot.decide();
  }
  CHECK(robot.decide() == Motion{});
  CHECK(team.trace(0).weight == 0.0);
  CHECK(team.reason(0) == "not active");
}

TEST_CASE("Two that compete weakly share, and of two that compete strongly one wins") {
  const auto weights = [](double gamma_ab, double gamma_ba, double noise, std::uint64_t seed) {
    Team team;
    team.member("a", 1, attractor_wish(0.5)).member("b", 1, attractor_wish(-0.5));
    Coordinated robot(
        "fusion_attractor_dynamics", team, {{"noise", noise}},
        {attractor_competition("a", "b", gamma_ab), attractor_competition("b", "a", gamma_ba)});
    robot.reset(seed);
    for (int step = 0; step < 2000; ++step) {
      robot.decide();
    }
    const double wa = team.trace(0).weight, wb = team.trace(1).weight;
    if (wb == 0.0) {
      CHECK(team.reason(1) == "suppressed");
      CHECK(team.trace(1).inhibited_by == 0);
    }
    return std::vector<double>{wa, wb};
  };
  // The fixed point of equals: w^2 = alpha / (alpha + gamma), stable for gamma below alpha = 1.
  const std::vector<double> both = weights(0.5, 0.5, 0.0, 1);
  CHECK(both[0] == Approx(std::sqrt(1.0 / 1.5)).epsilon(1e-6));
  CHECK(both[1] == Approx(both[0]));
  // A stronger competitor wins without any noise.
  const std::vector<double> one = weights(3.0, 1.5, 0.0, 1);
  CHECK(one[0] == Approx(1.0));
  CHECK(one[1] == 0.0);
  // Equals need noise, and then each of them wins in some run.
  bool first = false, second = false;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const std::vector<double> drawn = weights(3.0, 3.0, 0.02, seed);
    CHECK(std::abs(drawn[0] - drawn[1]) > 0.8);
    (drawn[0] > drawn[1] ? first : second) = true;
  }
  CHECK((first && second));
}

TEST_CASE("Whoever was suppressed comes back when the other is no longer active") {
  Team team;
  team.member("avoid", 1, attractor_wish(1.0)).member("seek", 1, attractor_wish(-1.0));
  Coordinated robot("fusion_attractor_dynamics", team, {},
                    {attractor_competition("avoid", "seek", 4.0)});
  const auto run = [&](int steps) {
    for (int step = 0; step < steps; ++step) {
      robot.decide();
    }
  };
  run(300);
  CHECK(team.reason(1) == "suppressed");
  CHECK(robot.decide().turn > 0.0);
  team.answer(0).activation = 0.0;
  run(300);
  CHECK(team.reason(1) == "attracts");
  CHECK(team.trace(1).weight == Approx(1.0).margin(1e-6));
  CHECK(robot.decide().turn < 0.0);
}

TEST_CASE("A direction is that of the motion, and a repeller may be opposite to it") {
  const auto turn = [](const Motion& wish, bool repels, bool opposite) {
    Team team;
    team.member("a", 1, wish);
    std::vector<ElementValue> elements;
    if (repels) {
      elements.push_back({"repeller", {{"of", std::string("a")}, {"opposite", opposite}}});
    }
    Coordinated robot("fusion_attractor_dynamics", team, {}, elements);
    robot.decide();
    return robot.decide().turn;
  };
  CHECK(turn({0.1, 0.1, 0.0}, false, false) > 0.0);   // to the left
  CHECK(turn({0.0, -0.1, 0.0}, false, false) < 0.0);  // to the right
  CHECK(turn({0.0, 0.0, 2.0}, false, false) > 0.0);   // a turn in place
  CHECK(turn({0.1, 0.0, 1.0}, true, false) < 0.0);
  CHECK(turn({-0.1, 0.0, 1.0}, true, true) < 0.0);  // away from what is ahead to the left
}

TEST_CASE("A wish to stand has no direction and stops nobody") {
  Team team;
  team.member("stand", 1, Motion{}).member("seek", 1, attractor_wish(0.0, 0.3));
  Coordinated robot("fusion_attractor_dynamics", team);
  for (int step = 0; step < 300; ++step) {
    robot.decide();
  }
  CHECK(robot.decide().forward == Approx(0.3));
  CHECK(team.reason(0) == "no direction");
  CHECK(team.trace(1).share == Approx(1.0));
}

TEST_CASE("What backs off brakes: the robot turns round, and never drives backwards") {
  Team team;
  team.member("seek", 1, attractor_wish(0.0, 0.2)).member("back_off", 1, Motion{-0.1, 0.0, 1.0});
  Coordinated robot("fusion_attractor_dynamics", team);
  for (int step = 0; step < 300; ++step) {
    robot.decide();
  }
  CHECK(robot.decide().forward == Approx(0.05));
  CHECK(robot.decide().turn < 0.0);  // behind, and to the right of what is behind
  team.answer(1).command.forward = -0.5;
  CHECK(robot.decide().forward == 0.0);
}

TEST_CASE("Shares are parts of the forces, and a repeller that is far off has none") {
  Team team;
  team.member("seek", 1, attractor_wish(0.1))
      .member("near", 1, attractor_wish(0.2))
      .member("far", 1, attractor_wish(3.0));
  Coordinated robot("fusion_attractor_dynamics", team, {},
                    {attractor_repeller("near"), attractor_repeller("far")});
  for (int step = 0; step < 200; ++step) {
    robot.decide();
  }
  CHECK(team.trace(0).share + team.trace(1).share + team.trace(2).share == Approx(1.0));
  CHECK(team.trace(1).share > 0.3);
  CHECK(team.trace(2).share < 1e-4);
  CHECK(team.reason(1) == "repels");
  CHECK(robot.decide().forward == Approx(0.2));  // a repeller has no say in the speed
}

TEST_CASE("The attractor dynamics refuse what they cannot use, and say what there is") {
  const auto refusal = [](const std::vector<ElementValue>& elements) -> std::string {
    Team team;
    team.member("avoid", 1, Motion{}).member("seek", 1, Motion{});
    try {
      Coordinated robot("fusion_attractor_dynamics", team, {}, elements);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  CHECK_THAT(
      refusal({attractor_repeller("avoyd")}),
      Contains("<repeller of=\"avoyd\"> names no behaviour") && Contains("did you mean 'avoid'?"));
  CHECK_THAT(refusal({attractor_repeller("x")}), Contains("it has: avoid, seek"));
  CHECK_THAT(refusal({attractor_repeller("seek"), attractor_repeller("seek")}),
             Contains("is given twice"));
  CHECK_THAT(refusal({attractor_competition("seek", "seek", 1)}),
             Contains("none competes with itself"));
  CHECK_THAT(
      refusal({attractor_competition("x", "seek", 1), attractor_repeller("y")}),
      Contains("<competition by=\"x\">") && Contains("; ") && Contains("<repeller of=\"y\">"));
  Team nobody;
  Coordinated robot("fusion_attractor_dynamics", nobody);
  CHECK(robot.decide() == Motion{});
}

TEST_CASE("The attractor dynamics allocates nothing in a step") {
  Team team;
  team.member("a", 1, wheels(9, 9)).member("b", 1, wheels(5, -5)).member("c", 2, wheels(1, 1));
  Coordinated robot("fusion_attractor_dynamics", team, {},
                    {attractor_repeller("a"), attractor_competition("b", "c", 2)});
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

TEST_CASE("The attractor dynamics have no fault that the checker finds") {
  testing::CheckOptions options;
  options.variants = 5;
  options.steps = 2000;
  for (const bool linked : {false, true}) {
    if (linked) {
      options.members = {"avoid_obstacle", "go_to_point", "recharge"};
      options.elements = {attractor_repeller("recharge"),
                          attractor_competition("avoid_obstacle", "go_to_point", 3)};
      options.settings = {{"noise", 0.1}};
    }
    const auto findings =
        testing::check_plugin(PluginKind::coordinator, "fusion_attractor_dynamics", options);
    CAPTURE(findings);
    CHECK(findings.empty());
  }
}

TEST_CASE("In its world, a robot goes round two posts, or between them if they stand far apart") {
  const auto y_beside_the_posts = [](double half_gap) {
    testing::WorldOptions options;
    const std::string y = std::to_string(half_gap);
    for (const std::string post : {"left", "right"}) {
      const std::string at = "/@y=" + std::string(post == "right" ? "-" : "") + y;
      options.set.push_back("obstacle[" + post + "]" + at);
      options.set.push_back("robot[r1]/behavior[" + post + "_post]" + at);
    }
    testing::World world = testing::World::from_file(source_path("worlds/two_posts.xml"), options);
    REQUIRE(world.run_until([](const testing::World& w) { return w.pose("r1").x > 0.0; }, 60));
    const double y_m = std::abs(world.pose("r1").y);
    REQUIRE(world.run_until([](const testing::World& w) { return w.pose("r1").x > 1.85; }, 60));
    CHECK(world.count("collision") == 0);
    return y_m;
  };
  CHECK(y_beside_the_posts(0.13) > 0.3);
  CHECK(y_beside_the_posts(0.3) > 0.4);  // there would be room between them
  CHECK(y_beside_the_posts(0.6) < 0.1);
}

TEST_CASE(
    "A sum of commands, and going straight, run into posts that the attractor dynamics pass") {
  for (const std::string& edit :
       {std::string("robot[r1]/coordinator=<fusion_vector_summation/>"),
        std::string(
            "robot[r1]/coordinator=<fusion_attractor_dynamics repulsion=\"0\" speed=\"0.2\">"
            "<repeller of=\"left_post\"/><repeller of=\"right_post\"/>"
            "</fusion_attractor_dynamics>")}) {
    CAPTURE(edit);
    testing::World world =
        testing::World::from_file(source_path("worlds/two_posts.xml"), {.set = {edit}});
    CHECK(world.run().outcome == simulation::Outcome::failure);
    CHECK(world.count("collision") > 0);
  }
  CHECK(testing::World::from_file(source_path("worlds/two_posts.xml")).run().outcome ==
        simulation::Outcome::success);
}
