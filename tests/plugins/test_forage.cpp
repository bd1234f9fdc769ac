#include <catch2/catch.hpp>

#include "elsie/commands/gripper.h"
#include "elsie/messages/say.h"
#include "elsie/readings/omnidirectional_camera.h"

#include "shipped.h"
#include "situation.h"

using namespace elsie;
using namespace elsie::test;

namespace {

OmnidirectionalReading seen(double distance_m, double bearing_rad, const Colour& colour) {
  return {{{distance_m, bearing_rad, colour.red, colour.green, colour.blue}}, 10};
}

constexpr Colour kFood{0x2e, 0x9e, 0x4f};

bool closes(const Response& response) {
  REQUIRE(response.acts.size() == 1);
  return static_cast<const GripCommand*>(response.acts[0].command())->closed;
}

plugin::Object<Behavior> forager() { return test::make<Behavior>(PluginKind::behavior, "forage"); }

}  // namespace

TEST_CASE("It drives to a resource of its colour, and grips it when it is near") {
  Situation now;
  const auto behavior = forager();
  now.reading(seen(1.0, 0.5, kFood));
  const Response far = behavior->respond(now.perception());
  CHECK(far.command.forward > 0.0);
  CHECK(far.command.turn == Approx(3.0 * 0.5));
  CHECK_FALSE(closes(far));
  Situation near;
  near.reading(seen(0.1, 0.0, kFood));
  CHECK(closes(behavior->respond(near.perception())));
}

TEST_CASE("It wants nothing while it sees no resource of its colour") {
  Situation now;
  now.reading(seen(0.1, 0.0, {255, 0, 0}));
  const Response response = forager()->respond(now.perception());
  CHECK(response.activation == 0.0);
  CHECK_FALSE(closes(response));
}

TEST_CASE("It carries what it holds to the nest, and opens the gripper there") {
  Situation now;
  const HeldThing thing{"puck", "gripper", true};
  now.self.held = {&thing, 1};
  now.nest(2.0, 0.0);
  const auto behavior = forager();
  now.at(0, 0, 90);
  const Response away = behavior->respond(now.perception());
  CHECK(closes(away));
  CHECK(away.command.turn < 0.0);
  now.at(1.7, 0, 0);
  CHECK_FALSE(closes(behavior->respond(now.perception())));
  SECTION("without a nest it keeps it") {
    now.team.nest.reset();
    const Response response = forager()->respond(now.perception());
    CHECK(closes(response));
    CHECK(response.activation == 0.0);
  }
}

TEST_CASE("A colour that is none is refused") {
  CHECK_THROWS_WITH(
      test::make<Behavior>(PluginKind::behavior, "forage", {{"colour", std::string("green")}}),
      Catch::Contains("expected six hexadecimal digits after #"));
}

TEST_CASE("It lets go of what nobody helps it to carry, and leaves it alone for a while") {
  Situation now;
  const HeldThing stuck{"stick", "gripper", false};
  now.self.held = {&stuck, 1};
  now.nest(2.0, 0.0);
  now.reading(seen(0.1, 0.0, kFood));
  const auto behavior = test::make<Behavior>(PluginKind::behavior, "forage", {{"patience", 5.0}});
  const auto at = [&](double time_s) { return behavior->respond(now.time(time_s).perception()); };
  CHECK(closes(at(1.0)));
  CHECK(closes(at(5.9)));
  CHECK_FALSE(closes(at(6.0)));
  now.self.held = {};
  CHECK_FALSE(closes(at(10.9)));
  CHECK(closes(at(11.0)));
}

TEST_CASE("It gives up what it comes no nearer to, and a hand that stays empty") {
  const auto behavior = forager();
  const auto at = [&](double time_s, double distance_m) {
    Situation now;
    now.reading(seen(distance_m, 0.0, kFood)).time(time_s);
    return behavior->respond(now.perception());
  };
  CHECK(at(0.0, 0.5).activation == 1.0);
  CHECK(at(9.9, 0.46).activation == 1.0);
  CHECK(at(10.0, 0.46).activation == 0.0);
  CHECK(at(19.9, 0.46).activation == 0.0);
  CHECK(at(20.0, 0.46).activation == 1.0);
  CHECK(at(29.0, 0.3).activation == 1.0);
  CHECK(at(38.9, 0.3).activation == 1.0);  // it has come nearer
  CHECK(closes(at(38.95, 0.1)));
  CHECK(closes(at(39.9, 0.1)));
  CHECK_FALSE(closes(at(39.96, 0.1)));
}

TEST_CASE(
    "It drives to a place that it hears of while it sees nothing, and forgets it on arrival") {
  Situation now;
  const auto behavior = forager();
  now.at(0, 0, 0).reading(OmnidirectionalReading{{}, 10});
  now.hear(PlaceMessage{0.0, 2.0}, "r2");
  const Response called = behavior->respond(now.perception());
  CHECK(called.activation == 1.0);
  CHECK(called.command.turn > 0.0);
  Situation there;
  there.at(0, 1.9, 90).reading(OmnidirectionalReading{{}, 10});
  behavior->respond(there.perception());
  CHECK(behavior->respond(there.perception()).activation == 0.0);
}
