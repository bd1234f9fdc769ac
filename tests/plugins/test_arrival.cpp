// What all behaviours that go to a place have in common.
#include <algorithm>
#include <string>

#include <catch2/catch.hpp>

#include "elsie/testing/behavior.h"

using namespace elsie;

namespace {

struct Goer {
  std::string name;
  std::string event;
  testing::Settings settings;
  testing::Elements elements;

  testing::Behavior behavior() const { return testing::Behavior(name, settings, elements); }
};

/// Each of them goes to the place (1, 0).
Goer goer(const std::string& name) {
  if (name == "home")
    return {name, "at_home", {{"x", 1.0}, {"radius", 0.1}, {"stop_within", 1.0}}, {}};
  if (name == "patrol") {
    return {name, "at_place", {{"tolerance", 0.1}}, {{"place", {{"x", 1.0}}}}};
  }
  return {name, name == "dock" ? "docked" : "arrived", {{"x", 1.0}, {"tolerance", 0.1}}, {}};
}

/// At (x, 0), with beams that see nothing. The point that motor schemas move is 5 cm ahead.
testing::Situation at(double x) {
  testing::Situation now;
  return now.beam(0, 1).beam(45, 1).beam(-45, 1).at(x, 0.0, 0.0);
}

}  // namespace

TEST_CASE("Who comes to its place says so once, and that it is done for as long as it is there") {
  const Goer it = goer(GENERATE(as<std::string>(), "bug", "dock", "dynamic_window", "go_to_point",
                                "home", "move_to", "patrol", "potential_field", "vfh_plus"));
  CAPTURE(it.name);
  testing::Behavior first = it.behavior();
  const auto ask = [&](testing::Behavior& behavior, double x) {
    const Response response = behavior.respond(at(x));
    CHECK(response.status == (x > 0.9 ? Status::success : Status::running));
    return std::count_if(response.events.begin(), response.events.end(),
                         [&](const Event& event) { return event.name == it.event; });
  };
  CHECK(ask(first, 0.0) == 0);
  CHECK(ask(first, 0.95) == 1);
  CHECK(ask(first, 0.95) == 0);
  // Its successor knows that it is there.
  testing::Behavior second = it.behavior();
  second.equip(at(0.95));
  CHECK(second.take_over(first));
  CHECK(ask(second, 0.95) == 0);
  // Pushed away, it comes again.
  CHECK(ask(second, 0.0) == 0);
  CHECK(ask(second, 0.95) == 1);
  // So does each run.
  second.reset();
  CHECK(ask(second, 0.95) == 1);
}

TEST_CASE("Who has come to its place shows nothing of its way any more") {
  const Goer it = goer(GENERATE(as<std::string>(), "dock", "dynamic_window", "move_to",
                                "potential_field", "vfh_plus"));
  CAPTURE(it.name);
  testing::Behavior behavior = it.behavior();
  const auto shows = [&](double x) {
    behavior.respond(at(x));
    Sketch sketch{Frame{}};
    behavior->sketch(sketch);
    return !sketch.empty();
  };
  CHECK(shows(0.0));
  CHECK_FALSE(shows(0.95));
  CHECK(shows(0.0));
}
