#include <fstream>

#include "elsie/testing/catch.h"

#include "places.h"

using namespace elsie;
using elsie::testing::Plugins;

namespace {

std::filesystem::path broken_library() {
  return test::build_path("tests/testing/plugins/broken_plugins.so");
}

}  // namespace

TEST_CASE("Plugins of the search path are found by name, and those of a given library, too") {
  CHECK(Plugins::found().host().find(PluginKind::behavior, "wander"));
  CHECK_FALSE(Plugins::found().host().find(PluginKind::behavior, "sound"));
  const Plugins both{broken_library()};
  CHECK(both.host().find(PluginKind::behavior, "wander"));
  CHECK(both.host().find(PluginKind::behavior, "sound"));
  const Plugins folder{broken_library().parent_path()};
  CHECK(folder.host().find(PluginKind::behavior, "sound"));
}

TEST_CASE("A file that is no plugin library, or is not there, is refused with a sentence") {
  CHECK_THROWS_WITH(Plugins{"no/such/place.so"}, Catch::Equals("no/such/place.so: does not exist"));
  CHECK_THROWS_WITH(Plugins{test::source_path("README.md")}, Catch::Contains("README.md: "));
}

TEST_CASE("A wrong name is reported with the nearest right one") {
  CHECK_THROWS_WITH(testing::Behavior("wandr"), Catch::Contains("did you mean 'wander'?"));
  CHECK_THROWS_WITH(testing::Behavior("wander", {{"sped", 3}}),
                    Catch::Contains("did you mean 'speed'?"));
  CHECK_THROWS_WITH(testing::Behavior("wander", {{"speed", -3}}), Catch::Contains("speed is -3"));
}

TEST_CASE("Whole numbers serve for real parameters, and for whole ones as they are") {
  testing::Behavior wander("wander", {{"speed", 3}, {"restlessness", 0}});
  CHECK_THAT(wander.respond(testing::Situation()), testing::commands_wheels(3, 3));
  CHECK_NOTHROW(testing::Behavior("keep_formation", {{"slot", 2}, {"formation", "column"}}));
}

TEST_CASE("Files are found in the data directories, defaults too; a missing one is reported") {
  CHECK_NOTHROW(testing::Behavior("avoid_obstacle"));
  CHECK_NOTHROW(
      testing::Behavior("avoid_obstacle", {{"left_model", "fuzzy_models/turn_left_left.fcl"}}));
  CHECK_THROWS_WITH(testing::Behavior("avoid_obstacle", {{"left_model", "none.fcl"}}),
                    Catch::Contains("the file 'none.fcl' of its parameter 'left_model' is not "
                                    "there; looked in the working directory, "));
}

TEST_CASE("A required parameter that is missing is reported") {
  testing::Team team;
  CHECK_THROWS_WITH(testing::Coordinator("fusion_context_blending", team),
                    Catch::Contains("its parameter 'model' has no default, and must be given"));
}
