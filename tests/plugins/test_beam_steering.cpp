#include <catch2/catch.hpp>

#include "elsie/api/inference.h"
#include "elsie/api/remember.h"
#include "elsie/fuzzy/fcl.h"

#include "shipped.h"
#include "situation.h"
#include "wheels.h"

using namespace elsie;
using namespace elsie::test;

namespace {

plugin::Object<Behavior> behavior(const char* name) {
  return test::make<Behavior>(PluginKind::behavior, name);
}

WheelRates answer(const char* name, Situation& now) {
  return rates(behavior(name)->respond(now.perception()).command);
}

/// The rates by the pair of models for one beam.
WheelRates pair(const std::string& name, double range, double azimuth) {
  const double inputs[] = {range, azimuth};
  WheelRates command;
  fuzzy::Workspace workspace;
  const auto evaluate = [&](const char* wheel, double& rate) {
    const fuzzy::Model model = fuzzy::read_fcl(test::source_path("fuzzy_models/" + name + wheel));
    REQUIRE(*model.input_index("range") == 0);
    model.evaluate(inputs, {&rate, 1}, workspace);
  };
  evaluate("_left.fcl", command.left);
  evaluate("_right.fcl", command.right);
  return command;
}

void check_equal(const WheelRates& a, const WheelRates& b) {
  CHECK(a.left == Approx(b.left).margin(1e-9));
  CHECK(a.right == Approx(b.right).margin(1e-9));
}

}  // namespace

TEST_CASE(
    "avoid_obstacle sums over the beams, counts the nearest twice, divides by their number plus "
    "one") {
  Situation now;
  now.beam(30, 0.3).beam(-30, 0.8).beam(0, 0.6);
  const WheelRates near = pair("avoid_obstacle", 0.3, 30);
  const WheelRates sum =
      near + near + pair("avoid_obstacle", 0.8, -30) + pair("avoid_obstacle", 0.6, 0);
  check_equal(answer("avoid_obstacle", now), sum / 4);
}

TEST_CASE("turn_left and turn_right are means over the beams") {
  for (const char* name : {"turn_left", "turn_right"}) {
    Situation now;
    now.beam(30, 0.3).beam(-30, 0.8);
    check_equal(answer(name, now), (pair(name, 0.3, 30) + pair(name, 0.8, -30)) / 2);
  }
}

TEST_CASE("Without beams the command of the three is zero") {
  for (const char* name : {"avoid_obstacle", "turn_left", "turn_right"}) {
    Situation now;
    now.proximity(0, true);
    CHECK(answer(name, now) == WheelRates{});
  }
}

TEST_CASE("avoid_obstacle turns away from the nearer side, near and very near") {
  for (const double distance : {0.05, 0.2, 0.3, 0.5, 0.7}) {
    CAPTURE(distance);
    for (const double azimuth : {12, 30, 45}) {
      CAPTURE(azimuth);
      Situation left, right;
      left.beam(azimuth, distance).beam(-azimuth, 1.0);
      right.beam(azimuth, 1.0).beam(-azimuth, distance);
      const WheelRates from_left = answer("avoid_obstacle", left);
      CHECK(from_left.left > from_left.right);
      const WheelRates from_right = answer("avoid_obstacle", right);
      CHECK(from_right.right > from_right.left);
      if (distance >= 0.3) {  // if it is nearer, the left side is stronger, to get out of corners
        check_equal({from_right.right, from_right.left}, from_left);
      }
    }
  }
}

TEST_CASE("avoid_obstacle drives on where all is clear, and slows down with distance") {
  Situation far, near;
  far.beam(30, 1.0).beam(-30, 1.0);
  near.beam(30, 0.4).beam(-30, 0.4);
  const WheelRates ahead = answer("avoid_obstacle", far);
  CHECK(ahead.left == Approx(ahead.right));
  CHECK(ahead.left == Approx(20).margin(2));
  const WheelRates slow = answer("avoid_obstacle", near);
  CHECK(slow.left + slow.right < ahead.left + ahead.right);
}

TEST_CASE("avoid_obstacle does not come to rest before a corner") {
  for (const double distance : {0.05, 0.1, 0.15, 0.2, 0.25}) {
    Situation corner;
    corner.beam(30, distance).beam(-30, distance);
    const WheelRates command = answer("avoid_obstacle", corner);
    CHECK(command.left - command.right > 5.0);
  }
}

TEST_CASE("turn_left sees obstacles on the right only, turn_right those on the left only") {
  Situation left, right, clear;
  left.beam(45, 0.2);
  right.beam(-45, 0.2);
  clear.beam(45, 1.0);
  const WheelRates turned = answer("turn_left", right);
  CHECK(turned.right > turned.left);
  check_equal(answer("turn_left", left), answer("turn_left", clear));
  const WheelRates mirrored = answer("turn_right", left);
  check_equal({mirrored.right, mirrored.left}, turned);
  check_equal(answer("turn_right", right), answer("turn_right", clear));
}

TEST_CASE("The fuzzy behaviours hand over their sets before defuzzification") {
  Situation now;
  now.beam(20, 0.3);
  const auto avoid = behavior("avoid_obstacle");
  const Response given = avoid->respond(now.perception());
  const CommandSets sets = avoid->command_sets(now.perception(), given);
  // With one beam the command is the centroid of the sets.
  const fuzzy::Model model =
      fuzzy::read_fcl(test::source_path("fuzzy_models/avoid_obstacle_left.fcl"));
  fuzzy::Workspace workspace;
  const double inputs[] = {0.3, 20};
  CHECK(sets.left == model.output_set(0, inputs, workspace));
}

namespace {

/// avoid_obstacle whose left wheel has DEFAULT := NC and whose right wheel DEFAULT := 7 | NC.
plugin::Object<Behavior> keeper() {
  const std::string file = test::source_path("tests/plugins/keeps_last.fcl");
  return test::make<Behavior>(PluginKind::behavior, "avoid_obstacle",
                              {{"left_model", file},
                               {"right_model", file},
                               {"left_block", std::string("keeps")},
                               {"right_block", std::string("begins_with_7")}});
}

WheelRates answer(Behavior& behavior, double first_m, double second_m) {
  Situation now;
  now.beam(30, first_m).beam(-30, second_m);
  return rates(behavior.respond(now.perception()).command);
}

}  // namespace

TEST_CASE("With DEFAULT := NC each beam keeps its last output where no rule decides") {
  const auto behavior = keeper();
  Random random(1);
  behavior->reset(random);
  check_equal(answer(*behavior, 1.0, 1.0), {0, 7});                        // nothing to keep yet
  check_equal(answer(*behavior, 0.2, 1.0), {-10.0 / 3, (-10 + 7.0) / 3});  // the nearest: twice
  check_equal(answer(*behavior, 0.9, 1.0), {-10.0 / 3, (-10 + 7.0) / 3});
  check_equal(answer(*behavior, 1.0, 0.2), {-5, -5});
  check_equal(answer(*behavior, 1.0, 0.9), {-5, -5});
  behavior->reset(random);
  check_equal(answer(*behavior, 1.0, 1.0), {0, 7});
}

TEST_CASE("A successor of a fuzzy behaviour keeps the outputs of its predecessor") {
  const auto old = keeper();
  answer(*old, 0.2, 0.2);
  const auto renewed = keeper();
  Memory memory;
  dynamic_cast<Remembers&>(*old).remember(memory);
  memory.begin_recall();
  dynamic_cast<Remembers&>(*renewed).remember(memory);
  check_equal(answer(*renewed, 1.0, 1.0), {-5, -5});
}

TEST_CASE("An inference shows the output that is kept, and asking for it changes nothing") {
  const auto behavior = keeper();
  answer(*behavior, 0.2, 1.0);
  answer(*behavior, 0.9, 1.0);
  for (int asked = 0; asked < 2; ++asked) {
    std::vector<Inference> made;
    dynamic_cast<const Infers&>(*behavior).list_inferences(made);
    REQUIRE(made.size() == 2);
    CHECK(made[0].outputs.front().value == Approx(-5));
    CHECK(made[1].outputs.front().value == Approx(-5));
  }
}

TEST_CASE("A wheel that may have nothing to keep has a note") {
  const std::vector<std::string> notes = keeper()->notes();
  REQUIRE(notes.size() == 1);
  CHECK_THAT(notes.front(), Catch::Contains("has DEFAULT := NC and no first value") &&
                                Catch::Contains("DEFAULT := 0 | NC"));
}

TEST_CASE("A model with other inputs is refused with a sentence") {
  CHECK_THROWS_WITH(
      test::make<Behavior>(PluginKind::behavior, "avoid_obstacle",
                           {{"left_model", test::source_path("tests/plugins/one_input.fcl")}}),
      Catch::Contains("must have the two inputs 'range' (m) and 'azimuth' (deg) and one output"));
}

TEST_CASE("The activation says how near the nearest thing is that concerns the behaviour") {
  const auto activation = [](const char* name, Situation& now) {
    return behavior(name)->respond(now.perception()).activation;
  };
  Situation clear;
  clear.beam(30, 1.0).beam(-30, 1.0);
  Situation on_the_right;
  on_the_right.beam(30, 1.0).beam(-30, 0.25).beam(-60, 0.5);
  Situation no_beams;
  for (const char* name : {"avoid_obstacle", "turn_left", "turn_right"}) {
    CHECK(activation(name, clear) == 0.0);
    CHECK(activation(name, no_beams) == 0.0);
  }
  CHECK(activation("avoid_obstacle", on_the_right) == Approx(0.75));
  CHECK(activation("turn_left", on_the_right) == Approx(0.75));
  CHECK(activation("turn_right", on_the_right) == 0.0);
}
