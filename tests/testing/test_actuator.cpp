#include <stdexcept>

#include <catch2/catch.hpp>

#include "elsie/base/error.h"
#include "elsie/commands/led.h"
#include "elsie/testing/actuator.h"
#include "elsie/testing/catch.h"
#include "elsie/testing/checker.h"

using namespace elsie;
using namespace elsie::testing;

namespace {

struct OtherCommand {
  static constexpr const char* kind = "other";
  double number = 0.0;
};

}  // namespace

TEST_CASE("An actuator under test tells what it does with a command") {
  testing::Actuator led("led", {{"intensity", 0.5}, {"power", 2.0}});
  CHECK_FALSE(led.hold().shine);
  const Done& bright = led.act(LedCommand{{255, 0, 0}, 1.0});
  CHECK(bright.shine == Colour{255, 0, 0});
  CHECK(bright.intensity == 0.5);
  CHECK(bright.power == 2.0);
  CHECK(led.act(LedCommand{{0, 0, 255}, 0.5}).intensity == 0.25);
  CHECK(led.hold().shine == Colour{0, 0, 255});
  CHECK(led.act(LedCommand{{}, 7.0}).intensity == 0.5);  // no brighter than it can be
  CHECK_FALSE(led.act(LedCommand{{}, -1.0}).shine);
  led.reset();
  CHECK_FALSE(led.hold().shine);
}

TEST_CASE("A command that is none of its own is refused with a sentence") {
  testing::Actuator led("led");
  CHECK_THROWS_WITH(led.act(OtherCommand{}),
                    Catch::Contains("actuator 'led' takes commands of the kind 'led'") &&
                        Catch::Contains("not 'other'"));
  CHECK_THROWS_AS(led.act(LedCommand{{}, 0.0 / 0.0}), base::Error);
}

TEST_CASE("The checker tries an actuator with random commands") {
  for (const char* name : {"gripper", "led", "pen", "radio", "range_and_bearing"}) {
    CHECK_THAT(check_plugin(PluginKind::actuator, name), finds_nothing());
  }
}
