// The checker asks plugins in two threads: here for the thread sanitizer.
#include <catch2/catch.hpp>

#include "elsie/testing/catch.h"

#include "shipped.h"

using namespace elsie;
using namespace elsie::testing;

TEST_CASE("Objects of several robots are asked in two threads") {
  CheckOptions options;
  options.variants = 3;
  options.steps = 200;
  const Plugins plugins{test::plugin_directory()};
  for (const PluginKind kind : {PluginKind::behavior, PluginKind::coordinator}) {
    for (const char* name : {"braitenberg", "wander", "arbiter_suppression"}) {
      if (!plugins.host().find(kind, name)) continue;
      CAPTURE(name);
      CHECK_THAT(check_plugin(kind, name, options, plugins), finds_nothing());
    }
  }
  CHECK_THAT(check_plugin(PluginKind::sensor, "beam_range", options, plugins), finds_nothing());
}
