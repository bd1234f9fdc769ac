// The published experiments: every file is in order, and their findings hold on a few seeds.
#include <filesystem>
#include <string>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "places.h"
#include "program.h"

namespace fs = std::filesystem;
using elsie::test::Workplace;
using nlohmann::json;

namespace {

/// The end of a run of a world in experiments/ at the original's step, with one of the two
/// coordinators of the published tables.
json result_of(const std::string& world, const std::string& coordinator, int seed) {
  Workplace here;
  const auto run =
      here.elsie("run experiments/worlds/" + world + ".xml --json --seed " + std::to_string(seed) +
                 " --set physics/@step=0.1 --set 'robot[collector]/coordinator=<" + coordinator +
                 " hidden=\"4 4\" rule=\"original\" "
                 "training=\"../../training_sets/two_sensors_two_behaviors.txt\"/>'");
  INFO(run.err);
  REQUIRE_FALSE(run.out.empty());
  return json::parse(run.out);
}

double distance_m(const json& result) { return result["robots"][0]["distance_m"]; }
double time_s(const json& result) { return result["simulated_s"]; }

}  // namespace

TEST_CASE("Every experiment that is shipped is in order, and so is every world of theirs") {
  Workplace here;
  int count = 0;
  for (const std::string folder : {"experiments", "experiments/worlds"}) {
    for (const auto& entry : fs::directory_iterator(elsie::test::source_path(folder))) {
      if (entry.path().extension() == ".xml") {
        ++count;
        const std::string file = folder + '/' + entry.path().filename().string();
        CAPTURE(file);
        const auto run = here.elsie("check --quiet " + file);
        CHECK(run.exit_code == 0);
        CHECK(run.err.empty());
      }
    }
  }
  CHECK(count > 15);
}

TEST_CASE("Past an obstacle both schemes reach the resource, arbitration in less time") {
  // The straight way to the front of the resource is 3.9 m less half the robot's length.
  for (const std::string world : {"one_obstacle", "two_obstacles"}) {
    for (int seed = 1; seed <= 2; ++seed) {
      CAPTURE(world, seed);
      const json fusion = result_of(world, "fusion_neural_network", seed);
      const json arbitration = result_of(world, "arbiter_neural_network", seed);
      CHECK(fusion["outcome"] == "success");
      CHECK(arbitration["outcome"] == "success");
      CHECK(distance_m(fusion) == Approx(3.9).margin(0.1));
      CHECK(distance_m(arbitration) == Approx(3.9).margin(0.1));
      // The original needed 51 s and 15.3 s for one obstacle. Fusion halves the speed.
      CHECK(time_s(fusion) < 60);
      CHECK(time_s(arbitration) < 0.6 * time_s(fusion));
    }
  }
}

TEST_CASE("In a clutter fusion collects three resources, and each seed has another clutter") {
  const json third = result_of("original_clutter", "fusion_neural_network", 3);
  CHECK(third["outcome"] == "success");
  CHECK(third["robots"][0]["collected"] == 3);
  CHECK(distance_m(third) < 12);
  const json ninth = result_of("original_clutter", "fusion_neural_network", 9);
  CHECK(ninth["outcome"] == "success");
  CHECK(distance_m(ninth) != Approx(distance_m(third)));
}

TEST_CASE("A leader takes its group to a resource") {
  Workplace here;
  const json result =
      json::parse(here.elsie("run experiments/worlds/group_to_resource.xml --json").out);
  CHECK(result["outcome"] == "success");
  CHECK(result["robots"][0]["collected"] == 1);
}
