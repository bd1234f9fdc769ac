// Worlds that a behaviour solves for every seed, and that fail without it. `make figures` runs 20
// seeds of each: docs/shipped-worlds.md.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "program.h"

using elsie::test::Workplace;
using nlohmann::json;

namespace {

json result_of(const std::string& world, int seed, const std::string& change = "") {
  Workplace here;
  const std::string set = change.empty() ? "" : " --set '" + change + "'";
  return json::parse(
      here.elsie("run worlds/" + world + ".xml --json --seed " + std::to_string(seed) + set).out);
}

/// The results of seeds 1 to 3; they must reach the goals of the world.
std::vector<json> check_seeds(const std::string& world) {
  std::vector<json> results;
  for (int seed = 1; seed <= 3; ++seed) {
    results.push_back(result_of(world, seed));
    CAPTURE(world, seed, results.back()["reason"].get<std::string>());
    CHECK(results.back()["outcome"] == "success");
  }
  return results;
}

/// The world proves nothing about a behaviour if it succeeds without it.
void check_fails(const std::string& world, const std::string& change) {
  CAPTURE(world, change);
  CHECK(result_of(world, 1, change)["outcome"] != "success");
}

int count(const json& result, const std::string& event) {
  int found = 0;
  for (const json& raised : result["events"]) {
    found += raised["name"] == event;
  }
  return found;
}

}  // namespace

TEST_CASE("find_resource collects what its team collects, and no decoy, through a noisy camera") {
  for (const json& result : check_seeds("find_resource")) {
    CHECK(result["robots"][0]["collected"] == 5);
  }
  check_fails("find_resource", "robot[r1]/behavior[find_resource]=<wander/>");
}

TEST_CASE("follow_the_leader gathers those within coverage around the leader, and only those") {
  check_seeds("gathering");
  check_fails("gathering", "robot[f1]/behavior[follow_the_leader]/@remove=true");
  check_fails("gathering",
              "robot[leader]/@coverage=3");  // all follow, but three should stay
}

TEST_CASE(
    "follow_the_leader: a group without sensors arrives with the leader that finds a resource") {
  for (const json& result : check_seeds("group_to_resource")) {
    CHECK(result["robots"][0]["collected"] == 1);
  }
  check_fails("group_to_resource", "robot[f4]/behavior[follow_the_leader]/@remove=true");
}

TEST_CASE("keep_formation takes its place behind a leader that wanders, and keeps it") {
  check_seeds("formation");
  check_fails("formation", "robot[f1]/behavior[keep_formation]=<follow_the_leader/>");
}

TEST_CASE("recharge keeps a robot alive six times as long as its battery lasts") {
  for (const json& result : check_seeds("recharge")) {
    CHECK(count(result, "battery_low") >= 4);
    CHECK(count(result, "charging_started") >= 4);
  }
  check_fails("recharge", "robot[r1]/behavior[recharge]/@remove=true");
}

TEST_CASE("wall_follow goes along walls and past what stands at them, to every resource there") {
  check_seeds("wall_follow");
  check_fails("wall_follow", "robot[r1]/behavior[wall_follow]=<wander/>");
}

TEST_CASE("flee keeps clear of boxes that come from any side") {
  check_seeds("flee");
  check_fails("flee", "robot[r1]/behavior[flee]/@remove=true");
}

TEST_CASE("escape frees a blind robot wherever it gets stuck") {
  for (const json& result : check_seeds("escape")) {
    CHECK(count(result, "stuck") >= 1);
    CHECK(count(result, "freed") >= 1);
  }
  check_fails("escape", "robot[r1]/behavior[escape]/@remove=true");
}

TEST_CASE("blend: a robot whose coordination nests lives among obstacles") {
  for (const json& result : check_seeds("nested")) {
    CHECK(count(result, "charging_started") >= 1);
  }
  // A charger is found only by an inner behaviour that an arbiter of fixed priorities never asks.
  check_fails("nested", "robot[r1]/behavior[journey]/coordinator=<arbiter_suppression/>");
}

TEST_CASE("disperse drives robots apart that hear each other") {
  check_seeds("disperse");
  check_fails("disperse", "robot[*]/behavior[disperse]/@remove=true");
  check_fails("disperse", "robot[*]/behavior[say]/@remove=true");
}

TEST_CASE("aggregate brings robots together from all over the arena") {
  check_seeds("aggregate");
  check_fails("aggregate", "robot[*]/behavior[aggregate]/@remove=true");
  check_fails("aggregate", "robot[*]/behavior[disperse]/@remove=true");  // they touch each other
}

TEST_CASE("home brings all robots into their nest") {
  check_seeds("home");
  check_fails("home", "robot[r3]/behavior[home]/@remove=true");
}

TEST_CASE("flock takes those along that do not know the way") {
  check_seeds("flock");
  check_fails("flock", "robot[r1]/behavior[flock]=<wander/>");
  check_fails("flock", "robot[*]/behavior[say]/@remove=true");
}

TEST_CASE("patrol goes round a house, again and again") {
  for (const json& result : check_seeds("patrol")) {
    CHECK(result["robots"][0]["collected"] == 4);
    CHECK(count(result, "at_place") == 8);
  }
  check_fails("patrol", "robot[r1]/behavior[patrol]/@order=once");
}

TEST_CASE("bug comes out of a trap and past what stands on its way") {
  for (const json& result : check_seeds("bug")) {
    CHECK(count(result, "leave_point") >= 3);
  }
  check_fails("bug", "robot[r1]/behavior[bug]=<go_to_point x=\"4\"/>");
}

TEST_CASE("vfh_plus drives through the openings between pillars and boxes") {
  check_seeds("vfh_plus");
  check_fails("vfh_plus", "robot[r1]/behavior[vfh_plus]=<go_to_point x=\"4\"/>");
}

TEST_CASE("dynamic_window drives between pillars and boxes, in little time") {
  check_seeds("dynamic_window");
  check_fails("dynamic_window", "robot[r1]/behavior[dynamic_window]=<go_to_point x=\"4\"/>");
  check_fails("dynamic_window", "robot[r1]/behavior[dynamic_window]=<vfh_plus x=\"4\"/>");
}
