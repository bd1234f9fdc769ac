// elsie replay of the runs of a database.
#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "laboratory.h"
#include "places.h"

using Catch::Contains;
using elsie::test::Laboratory;
using elsie::test::world_with;
namespace fs = std::filesystem;

TEST_CASE("A run that is replayed has the same result, and can be viewed") {
  const Laboratory here;
  REQUIRE(here.batch("small_experiment.xml --quiet").exit_code == 0);
  const auto run = here.elsie(
      "replay small_experiment.sqlite 17 --picture run.png --record run.csv "
      "--explain run.trace");
  CAPTURE(run.err);
  CHECK(run.exit_code == 0);
  CHECK(run.err.empty());
  CHECK_THAT(run.out, Contains("the same: state hash ") && Contains("0.4, seed 1"));
  CHECK(here.read("run.png").starts_with("\x89PNG"));
  CHECK(here.read("run.csv").starts_with("time_s,"));
  CHECK(here.elsie("explain run.trace").exit_code == 0);

  // Recorded for viewers, it is the same run.
  const auto recorded = here.elsie("replay small_experiment.sqlite 17 --quiet --record run.mcap");
  CHECK(recorded.exit_code == 0);
  const std::string same = "the same: ";
  REQUIRE_THAT(recorded.out, Catch::StartsWith(same + "state hash "));
  CHECK_THAT(here.elsie("replay small_experiment.sqlite 17 --record i.mcap --record-images").err,
             Contains("--record-images: no robot of this world has a sensor with a camera"));
  CHECK_THAT(here.elsie("replay run.mcap").out,
             Contains(recorded.out.substr(same.size(), recorded.out.find('\n') - same.size())));

  const auto none = here.elsie("replay small_experiment.sqlite 25");
  CHECK(none.exit_code == 2);
  CHECK_THAT(none.err,
             Contains("has no run 25: the runs of its experiment have numbers from 1 to 24"));
  CHECK(here.elsie("replay small.xml 1").exit_code == 2);

  here.query("small_experiment.sqlite", "UPDATE runs SET state_hash = 'beef' WHERE id = 3");
  const auto other = here.elsie("replay small_experiment.sqlite 3");
  CHECK(other.exit_code == 1);
  CHECK_THAT(other.out, Contains("not the same: state hash ") && Contains("before beef"));
}

TEST_CASE("A replay takes from the database what has changed on disk, and says so") {
  const Laboratory here;
  fs::remove(here.file("fuzzy_models"));
  fs::copy(elsie::test::source_path("fuzzy_models"), here.file("fuzzy_models"));
  fs::create_directory(here.file("mine"));
  fs::copy(elsie::test::plugin_directory() + "/wander.so", here.file("mine/wander.so"));
  here.write("small.xml", world_with("wander",
                                     "<avoid_obstacle left_model=\"fuzzy_models/"
                                     "avoid_obstacle_left.fcl\"/>"));
  REQUIRE(here.elsie("batch small_experiment.xml --quiet --plugin-path mine").exit_code == 0);
  CHECK(here.elsie("replay small_experiment.sqlite 1").err.empty());

  const std::string model = "fuzzy_models/avoid_obstacle_left.fcl";
  const std::string content = here.read(model);
  here.write(model, "FUNCTION_BLOCK nonsense");
  here.write("small.xml", "<world/>");
  auto run = here.elsie("replay small_experiment.sqlite 1 --quiet");
  CHECK(run.exit_code == 0);
  CHECK_THAT(run.err, Contains(model + "' has changed since; the run takes what was in it"));
  fs::remove_all(here.file("fuzzy_models"));
  run = here.elsie("replay small_experiment.sqlite 1 --quiet");
  CHECK(run.exit_code == 0);
  CHECK_THAT(run.err, Contains(model + "' no longer exists"));

  here.write("mine/wander.so", here.read("mine/wander.so") + "more");
  run = here.elsie("replay small_experiment.sqlite 1 --quiet");
  CHECK(run.exit_code == 0);  // the code is the same
  CHECK_THAT(run.err, Contains("plugin 'behavior wander 1.0' comes from another library") &&
                          Contains("(it has changed since)"));
  fs::remove(here.file("mine/wander.so"));
  run = here.elsie("replay small_experiment.sqlite 1 --quiet");
  CHECK(run.exit_code == 0);
  CHECK_THAT(run.err, !Contains("comes from another library"));  // the shipped one is the same
}

TEST_CASE("A replay notices that the library of any plugin has changed, a measure's too") {
  const Laboratory here;
  const std::vector<std::string> names{"beam_range", "wander", "fusion_vector_summation",
                                       "path_length"};
  fs::create_directory(here.file("mine"));
  for (const std::string& name : names) {
    fs::copy(elsie::test::plugin_directory() + "/" + name + ".so",
             here.file("mine/" + name + ".so"));
  }
  std::string world = world_with("wander");
  world.insert(world.find("<robots>"), "<measures><path_length id=\"way\"/></measures>");
  here.write("small.xml", world);
  REQUIRE(here.batch("small_experiment.xml --quiet --plugin-path mine").exit_code == 0);
  CHECK(here.elsie("replay small_experiment.sqlite 1").err.empty());
  for (const std::string& name : names) {
    const std::string library = "mine/" + name + ".so", content = here.read(library);
    here.write(library, content + "more");
    const auto run = here.elsie("replay small_experiment.sqlite 1 --quiet");
    CHECK(run.exit_code == 0);  // the code is the same
    CHECK_THAT(run.err, Contains(" " + name + " ") && Contains("(it has changed since)"));
    here.write(library, content);
  }
}
