// `elsie run --live` as users start it, and in the hands of the official client.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "npm_packages.h"
#include "program.h"

using namespace elsie::test;
using nlohmann::json;

TEST_CASE(
    "The official client watches a run, holds it, goes on and back, and the run is the same") {
  const Workplace here;
  const auto packages = npm_packages("live/official_client", {"watch.mjs"});
  const std::string run = "elsie run worlds/ten_robots.xml --duration 4 --json";
  const auto watched =
      here.sh("node '" + (packages / "watch.mjs").string() + "' " + run + " --live 0");
  INFO(watched.err);
  REQUIRE_FALSE(watched.out.empty());
  const json found = json::parse(watched.out);
  CHECK(found.at("problems") == json::array());
  CHECK(found.at("statuses") == json::array());
  CHECK(found.at("info").at("name").get<std::string>().starts_with("elsie "));
  CHECK(found.at("channels").at("/scene") == "foxglove.SceneUpdate");
  CHECK(found.at("channels").at("/robots/r1/pose") == "foxglove.PoseInFrame");
  for (const char* topic : {"/scene", "/tf", "/world", "/robots/r1/pose", "/robots/r10/state",
                            "/robots/r1/readings", "/robots/r1/trace"}) {
    CAPTURE(topic);
    CHECK(found.at("messages").value(topic, 0) > 0);
  }
  CHECK(found.at("times") > 3);
  const auto said = found.at("said").get<std::string>();
  CHECK_THAT(said, Catch::Contains("elsie: live at ws://127.0.0.1:") &&
                       Catch::Contains("the run has ended; its live view stays until Ctrl-C") &&
                       Catch::Contains("live: 1 client, "));
  const auto alone = here.sh(run);
  CHECK(found.at("result").at("state_hash") == json::parse(alone.out).at("state_hash"));
  CHECK(found.at("exit_code") == alone.exit_code);
}

TEST_CASE("What cannot be live is refused before the run") {
  const Workplace here;
  const std::pair<const char*, const char*> wrong[] = {
      {"worlds/open_arena.xml --live 65536", "--live: '65536' is no port to listen on; expected"},
      {"worlds/open_arena.xml --live 12.5", "--live: '12.5' is no port to listen on"},
      {"worlds/open_arena.xml --live 192.0.2.1:0", "--live: cannot listen on ws://192.0.2.1:0: "},
      {"worlds/open_arena.xml --live worlds/clutter.xml",
       "--live: 'worlds/clutter.xml' is no port to listen on"},
      {"worlds/open_arena.xml --live 0 --live-origin example.org",
       "--live-origin example.org: expected scheme and host of a page"},
      {"worlds/open_arena.xml --live-origin https://example.org", "--live"}};
  for (const auto& [arguments, sentence] : wrong) {
    CAPTURE(arguments);
    const auto run = here.elsie(std::string("run ") + arguments);
    CHECK(run.exit_code == 2);
    CHECK_THAT(run.err, Catch::Contains(sentence));
    CHECK(run.out.empty());
  }
}
