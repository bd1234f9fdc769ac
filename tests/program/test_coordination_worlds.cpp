// Worlds that show what a coordinator can do, or cannot. `make figures` and `make four-resources`
// run 20 seeds.
#include <algorithm>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "program.h"

using elsie::test::Workplace;
using nlohmann::json;

namespace {

/// The end of a run of a shipped world; with another coordinator if one is named.
json result_of(const std::string& world, int seed, const std::string& coordinator = "") {
  Workplace here;
  const std::string set =
      coordinator.empty() ? "" : " --set 'robot[r1]/coordinator=" + coordinator + "'";
  return json::parse(
      here.elsie("run worlds/" + world + ".xml --json --seed " + std::to_string(seed) + set).out);
}

}  // namespace

TEST_CASE(
    "Between two equal pulls vector summation gets stuck, and a fusion on desirability does not") {
  for (int seed = 1; seed <= 3; ++seed) {
    CAPTURE(seed);
    const json one_after_the_other = result_of("equal_pulls", seed);
    CHECK(one_after_the_other["outcome"] == "success");
    CHECK(one_after_the_other["robots"][0]["collected"] == 2);
    // 3.61 m to the one and 4 m to the other, less the width of the resources
    CHECK(one_after_the_other["robots"][0]["distance_m"] < 7.7);

    const json stuck =
        result_of("equal_pulls", seed, "<fusion_vector_summation weighted=\"true\"/>");
    CHECK(stuck["outcome"] == "time_limit");
    CHECK(stuck["robots"][0]["collected"] == 0);
    // It stands half-way between (1, 2) and (1, -2).
    CHECK(stuck["robots"][0]["pose"][0].get<double>() == Approx(1.0).margin(0.1));
    CHECK(stuck["robots"][0]["pose"][1].get<double>() == Approx(0.0).margin(0.1));
  }
}

TEST_CASE("Voting, too, takes one of two equal pulls, given a margin") {
  for (int seed = 1; seed <= 3; ++seed) {
    CAPTURE(seed);
    CHECK(result_of("equal_pulls", seed, "<arbiter_voting margin=\"0.05\"/>")["outcome"] ==
          "success");
  }
}

TEST_CASE("Layers of competence: the robot lives, and every layer is needed") {
  for (int seed = 1; seed <= 3; ++seed) {
    CAPTURE(seed);
    CHECK(result_of("layers", seed)["outcome"] == "success");
  }
  const auto without = [](const std::string& layer, int seed) {
    Workplace here;
    std::string world = here.read("worlds/layers.xml");
    const std::size_t from = world.find("<" + layer);
    world.erase(from, world.find("/>", from) + 2 - from);
    here.write("fewer_layers.xml", world);
    return json::parse(
        here.elsie("run fewer_layers.xml --json --seed " + std::to_string(seed)).out);
  };
  const auto ends_with = [](const json& result, const std::string& words) {
    CHECK(result["outcome"] != "success");
    CHECK_THAT(result["reason"].get<std::string>(), Catch::Contains(words));
  };
  ends_with(without("wander", 1), "time");       // it does not get around
  ends_with(without("recharge", 1), "battery");  // it runs out
  ends_with(without("avoid_obstacle", 1), "collided");
  ends_with(without("escape", 4), "battery");  // a corner holds it
}

TEST_CASE("Context rules take a robot past obstacles and to the charger on its way") {
  for (int seed = 1; seed <= 3; ++seed) {
    CAPTURE(seed);
    const json result = result_of("contexts", seed);
    CHECK(result["outcome"] == "success");
    bool charged = false;
    for (const json& event : result["events"]) {
      charged = charged || event["name"] == "charging_started";
    }
    CHECK(charged);
  }
}

namespace {

std::ptrdiff_t count(const json& result, const std::string& event) {
  return std::count_if(result["events"].begin(), result["events"].end(),
                       [&](const json& raised) { return raised["name"] == event; });
}

}  // namespace

TEST_CASE("A network that blends search and avoidance collects all four resources") {
  Workplace here;
  constexpr int seeds = 3;
  for (const std::string hidden : {"2 2", "4 4"}) {
    double distance_m = 0.0, time_s = 0.0;
    for (int seed = 1; seed <= seeds; ++seed) {
      CAPTURE(hidden, seed);
      const json result = json::parse(
          here.elsie("run worlds/four_resources.xml --json --seed " + std::to_string(seed) +
                     " --set 'robot[collector]/coordinator/@hidden=" + hidden + "'")
              .out);
      CHECK(result["outcome"] == "success");
      CHECK(result["robots"][0]["collected"] == 4);
      // Each comes into view after the other, and is lost at the earliest when it is collected.
      CHECK(count(result, "resource_in_view") == 4);
      CHECK(count(result, "resource_out_of_view") == 3);
      distance_m += result["robots"][0]["distance_m"].get<double>() / seeds;
      time_s += result["simulated_s"].get<double>() / seeds;
    }
    // The original needed 32.98 m and 293.7 s, 32.87 m and 170.4 s. The way from the middle to a
    // corner and along three sides is 29.66 m, less the width of the resources.
    CHECK(distance_m == Approx(29.66).margin(0.3));
    CHECK(time_s < 294);
  }
}

TEST_CASE("Worlds that one coordinator solves, and others do not") {
  struct Case {
    std::string world;
    std::vector<std::string> others;
  };
  const Case all[] = {
      {"two_posts", {"<fusion_vector_summation/>"}},
      {"inhibition", {"<arbiter_action_selection/>"}},
      {"errand", {"<arbiter_action_selection/>", "<arbiter_suppression/>"}},
      {"fetch", {"<arbiter_action_selection/>", "<fusion_vector_summation/>"}},
      {"guard", {"<fusion_vector_summation/>", "<arbiter_suppression/>"}},
      {"slide", {"<arbiter_action_selection/>", "<arbiter_suppression/>"}},
      {"learned_arbitration",
       {"<arbiter_action_selection/>", "<arbiter_action_selection by_priority=\"true\"/>",
        "<arbiter_subsumption/>", "<arbiter_strength/>", "<fusion_vector_summation/>"}},
  };
  for (const Case& each : all) {
    CAPTURE(each.world);
    for (int seed = 1; seed <= 2; ++seed) {
      CHECK(result_of(each.world, seed)["outcome"] == "success");
      CHECK(result_of("scattered/" + each.world, seed)["outcome"] == "success");
    }
    for (const std::string& other : each.others) {
      CAPTURE(other);
      CHECK(result_of(each.world, 1, other)["outcome"] != "success");
    }
  }
}

TEST_CASE("Without learning nobody gathers and lives: no behaviour alone, and no fixed order") {
  Workplace here;
  const auto run = [&](const std::string& edits) {
    return json::parse(here.elsie("run worlds/learned_arbitration.xml --json" + edits).out);
  };
  for (const std::string behavior : {"avoid_obstacle", "gather", "recharge"}) {
    CAPTURE(behavior);
    CHECK(run(" --set 'robot[r1]/coordinator=<arbiter_suppression/>' --set 'robot[r1]/behavior[" +
              behavior + "]/@priority=2'")["outcome"] != "success");
  }
  std::vector<std::string> order{"avoid_obstacle", "gather", "recharge"};
  do {
    std::string edits =
        " --set 'robot[r1]/coordinator=<arbiter_action_selection by_priority=\"true\"/>'";
    for (std::size_t i = 0; i < order.size(); ++i) {
      edits += " --set robot[r1]/behavior[" + order[i] + "]/@priority=" + std::to_string(3 - i);
    }
    CAPTURE(edits);
    CHECK(run(edits)["outcome"] != "success");
  } while (std::next_permutation(order.begin(), order.end()));
  CHECK(run(" --set robot[r1]/coordinator/@values/@remove=true"
            " --set robot[r1]/coordinator/@untrained=true")["outcome"] != "success");
}
