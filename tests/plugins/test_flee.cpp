#include <cmath>

#include <catch2/catch.hpp>

#include "shipped.h"
#include "situation.h"

using namespace elsie;
using elsie::test::Situation;

namespace {

plugin::Object<Behavior> flee(test::Parameters parameters = {}) {
  return test::make<Behavior>(PluginKind::behavior, "flee", std::move(parameters));
}

Response to(Situation now) { return flee()->respond(now.perception()); }

}  // namespace

TEST_CASE("What is at the sphere or beyond does not matter") {
  for (const double distance : {0.5, 0.9, 1.0}) {
    const Response response = to(Situation().beam(0, distance).proximity(90, false));
    CHECK(response.command == Motion{});
    CHECK(response.activation == 0.0);
    CHECK(response.strength == 0.0);
    CHECK(response.events.empty());
  }
}

TEST_CASE("The nearer something is, the higher the activation: 1 at the margin and nearer") {
  CHECK(to(Situation().beam(0, 0.4)).activation == Approx(0.25));
  CHECK(to(Situation().beam(0, 0.3)).activation == Approx(0.5));
  CHECK(to(Situation().beam(0, 0.1)).activation == Approx(1.0));
  CHECK(to(Situation().beam(0, 0.02)).activation == 1.0);
  CHECK(to(Situation().beam(0, -0.01)).activation == 1.0);  // noise
  CHECK(to(Situation().proximity(0, true)).activation == 0.5);
  CHECK(to(Situation().beam(0, 0.4).beam(90, 0.2)).activation == Approx(0.75));
}

TEST_CASE("Away from something behind it drives straight on, the faster the nearer it is") {
  const Motion fast = to(Situation().beam(180, 0.1)).command;
  CHECK(fast.forward == Approx(0.4));
  CHECK(fast.turn == Approx(0.0).margin(1e-9));
  CHECK(to(Situation().beam(180, 0.3)).command.forward == Approx(0.2));
}

TEST_CASE("Away from something on one side it turns to the other") {
  const Motion right = to(Situation().beam(90, 0.1)).command;
  CHECK(right.turn == Approx(-4.0 * radians(90)));
  CHECK(right.forward == Approx(0.0).margin(1e-9));
  const Motion left = to(Situation().proximity(-150, true)).command;
  CHECK(left.turn == Approx(4.0 * radians(30)));
  CHECK(left.forward == Approx(0.4 * 0.5 * std::cos(radians(30))));
}

TEST_CASE("Repulsions add up as vectors, each with its strength") {
  // 1 to the back from ahead, 0.5 to the right from the left.
  const Motion away = to(Situation().beam(0, 0.1).beam(90, 0.3).beam(-90, 1.0)).command;
  // 1.5 - |(-1, -0.5)| remains, and adds to the open side.
  const double left_over = 1.5 - std::hypot(1.0, 0.5);
  CHECK(away.turn == Approx(4.0 * std::atan2(-0.5 - left_over, -1.0)));
  CHECK(away.forward == 0.0);
}

TEST_CASE("Between two threats it runs out to where nothing is, and not to where it is closed") {
  const Motion out = to(Situation().beam(90, 0.2).beam(-90, 0.2).beam(180, 0.6)).command;
  CHECK(std::abs(out.turn) == Approx(4.0 * radians(180)));
  const Motion ahead =
      to(Situation().beam(90, 0.2).beam(-90, 0.2).beam(180, 0.6).beam(0, 1)).command;
  CHECK(ahead.turn == Approx(0.0).margin(1e-9));
  CHECK(ahead.forward == Approx(0.4 * 0.75));
}

TEST_CASE("Having begun to turn round it keeps to that side until the way is ahead") {
  const auto behavior = flee();
  const auto turn = [&](double left_m, double right_m) {
    Situation now;
    now.beam(10, left_m).beam(-10, right_m);
    return behavior->respond(now.perception()).command.turn;
  };
  CHECK(turn(0.2, 0.21) < 0.0);
  CHECK(turn(0.21, 0.2) < 0.0);  // noise: on its own it would turn left now
  Situation clear;
  clear.beam(10, 1).beam(-10, 1);
  behavior->respond(clear.perception());
  CHECK(turn(0.21, 0.2) > 0.0);
  Random random;
  behavior->reset(random);
  CHECK(turn(0.2, 0.21) < 0.0);
}

TEST_CASE("It says when something comes near and when nothing is near any more") {
  const auto behavior = flee();
  Situation near, far;
  near.beam(0, 0.3);
  far.beam(0, 0.5);
  CHECK(behavior->respond(far.perception()).events.empty());
  const Response alarmed = behavior->respond(near.perception());
  REQUIRE(alarmed.events.size() == 1);
  CHECK(alarmed.events[0].name == "alarmed");
  CHECK(behavior->respond(near.perception()).events.empty());
  const Response calm = behavior->respond(far.perception());
  REQUIRE(calm.events.size() == 1);
  CHECK(calm.events[0].name == "calm");
}

TEST_CASE("A robot without range or proximity sensors is refused, and so is a margin too large") {
  CHECK_THROWS_WITH(flee()->equipped(Situation().camera().perception()),
                    Catch::Contains("the robot has none"));
  CHECK_NOTHROW(flee()->equipped(Situation().proximity(0, false).perception()));
  CHECK_THROWS_WITH(flee({{"margin", 0.5}}), Catch::Contains("margin is 0.5 m and sphere 0.5 m"));
}
