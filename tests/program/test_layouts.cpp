// Random worlds from the command line, and the shipped ones over several seeds.
#include <filesystem>
#include <set>
#include <string>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "places.h"
#include "program.h"

using Catch::Contains;
using elsie::test::Workplace;
using nlohmann::json;

TEST_CASE("The scattered sisters of the shipped worlds have room for every layout") {
  Workplace here;
  for (int seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    const auto run =
        here.elsie("check worlds/scattered/*.xml --quiet --seed " + std::to_string(seed));
    CAPTURE(run.err);
    CHECK(run.exit_code == 0);
  }
}

TEST_CASE("Every shipped world has a scattered sister") {
  const std::filesystem::path folder = elsie::test::source_path("worlds");
  std::set<std::string> without;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_regular_file() && !std::filesystem::exists(folder / "scattered" / name)) {
      without.insert(entry.path().stem().string());
    }
  }
  CHECK(without.empty());
}

TEST_CASE("Robots live in any clutter, and gather and keep formation from any start") {
  Workplace here;
  for (const char* world : {"clutter", "open_arena", "gathering", "formation", "pushing", "shapes",
                            "group_to_resource", "drives", "equal_pulls", "wall_follow"}) {
    for (int seed = 1; seed <= 2; ++seed) {
      CAPTURE(world, seed);
      CHECK(here.elsie("run worlds/scattered/" + std::string(world) + ".xml --quiet --seed " +
                       std::to_string(seed))
                .exit_code == 0);
    }
  }
}

TEST_CASE("An expanded world gives the run of the world that it came from") {
  Workplace here;
  const auto hash = [&](const std::string& world, int seed) {
    const auto run = here.elsie("run " + world + " --json --duration 5 --seed " +
                                std::to_string(seed) + " || [ $? = 1 ]");
    CAPTURE(run.err);
    return json::parse(run.out).at("state_hash").get<std::string>();
  };
  here.sh("elsie check worlds/scattered/clutter.xml --seed 7 --expand > seven.xml");
  CHECK(hash("seven.xml", 7) == hash("worlds/scattered/clutter.xml", 7));
  CHECK(hash("worlds/scattered/clutter.xml", 7) != hash("worlds/scattered/clutter.xml", 8));
}

TEST_CASE("A recording has the world as it came out, and replays it") {
  Workplace here;
  here.elsie("run worlds/scattered/clutter.xml --seed 3 --duration 2 --record run.mcap --quiet");
  const auto replay = here.elsie("replay run.mcap --world again.xml");
  CAPTURE(replay.err);
  CHECK(replay.exit_code == 0);
  CHECK_THAT(here.read("again.xml"), Contains("clutter26") && !Contains("<layouts"));
}

TEST_CASE("--expand writes one world, and nothing else") {
  Workplace here;
  const auto two = here.elsie("check worlds/maze.xml worlds/clutter.xml --expand");
  CHECK(two.exit_code == 2);
  CHECK_THAT(two.err, Contains("--expand writes one world; 2 files are given"));
  const auto experiment = here.elsie("check experiments/top_speed.xml --expand");
  CHECK(experiment.exit_code == 2);
  CHECK_THAT(experiment.err, Contains("--expand is for worlds"));
  CHECK_THAT(here.elsie("check worlds/maze.xml --expand").out, Catch::StartsWith("<?xml"));
  CHECK(here.elsie("check worlds/maze.xml --seed seven").exit_code == 2);
}

TEST_CASE("A world that has no room for its layout is refused before it runs") {
  Workplace here;
  for (const std::string command : {"run", "check", "picture"}) {
    const auto run =
        here.elsie(command + " worlds/scattered/clutter.xml --set 'scatter[clutter]/@count=900'");
    CHECK(run.exit_code == 2);
    CHECK_THAT(run.err, Contains("scattered/clutter.xml:11: the layout 'clutter' has no room"));
  }
}
