// Keeping a distance: a velocity along the line to the nearest thing, and nothing else.
#include <cmath>

#include <catch2/catch.hpp>

#include "shipped.h"
#include "situation.h"

using namespace elsie;
using elsie::test::Situation;

namespace {

Response keeping(const Situation& now, test::Parameters parameters = {}) {
  return test::make<Behavior>(PluginKind::behavior, "keep_distance", std::move(parameters))
      ->respond(now.perception());
}

}  // namespace

TEST_CASE("keep_distance is not active while nothing is nearer than its distance") {
  for (const double distance : {0.4, 0.7, 1.0}) {
    const Response response = keeping(Situation().beam(0, distance));
    CHECK(response.activation == 0.0);
    CHECK(response.command == Motion{});
    CHECK_FALSE(response.matters_rad);
  }
}

TEST_CASE("keep_distance drives the point ahead away from the nearest thing, in proportion") {
  for (const double azimuth : {0.0, 30.0, -70.0, 180.0}) {
    const Response response = keeping(Situation().beam(azimuth, 0.3).beam(azimuth + 45.0, 0.35),
                                      {{"distance", 0.5}, {"gain", 3.0}, {"lookahead", 0.2}});
    const double angle = radians(azimuth), speed = 3.0 * (0.3 - 0.5);
    CHECK(response.command.forward == Approx(speed * std::cos(angle)).margin(1e-12));
    CHECK(0.2 * response.command.turn == Approx(speed * std::sin(angle)).margin(1e-12));
    REQUIRE(response.matters_rad);
    CHECK(std::cos(*response.matters_rad - angle) == Approx(1.0));
  }
}

TEST_CASE("keep_distance moves a robot to the side if its drive can") {
  Situation now = Situation().beam(90, 0.2);
  now.self.channels.lateral = true;
  const Response response = keeping(now, {{"distance", 0.4}, {"gain", 1.0}});
  CHECK(response.command.lateral == Approx(-0.2));
  CHECK(response.command.turn == 0.0);
}
