// What is left of a recording when the program is killed.
#include <catch2/catch.hpp>

#include "official_reader.h"
#include "places.h"
#include "program.h"

using namespace elsie::test;
using nlohmann::json;

TEST_CASE("A run that is killed leaves a recording that is whole up to its last chunk") {
  const Workplace here;
  here.write("endless.xml", R"(<world format="1"><robots>
      <robot id="r1" template="robots/scout.xml"/></robots><limits time="1000000"/></world>)");
  // Killed when there is something of it, in the middle of a run that would go on for hours.
  const auto killed = here.sh(
      "elsie run endless.xml --quiet --record run.mcap & pid=$!\n"
      "for i in $(seq 600); do\n"
      "  [ -e run.mcap ] && [ $(stat -c %s run.mcap) -gt 40000 ] && break\n"
      "  sleep 0.1\n"
      "done\n"
      "kill -9 $pid\n"
      "wait $pid || echo ended with $?");
  REQUIRE(killed.out == "ended with 137\n");

  const auto replay = here.elsie("replay run.mcap --picture end.png");
  CHECK(replay.exit_code == 0);
  CHECK(replay.err.empty());
  CHECK_THAT(replay.out, Catch::Contains("no outcome: the recording ends after ") &&
                             Catch::Contains("the end is missing: the file breaks off at byte "));
  CHECK(here.read("end.png").size() > 1000);

  const json found = read_officially(here.file("run.mcap"), "streamed");
  CHECK(found.at("problems") == json::array());
  CHECK(found.at("complete") == false);
  CHECK(found.at("chunks").get<int>() >= 2);
  CHECK(found.at("channels").at("/robots/r1/state").at("messages").get<int>() > 10);
  CHECK(!found.at("metadata").contains("elsie.result"));
  // A chunk for each second of the run, and nothing is missing in between.
  CHECK(std::stod(found.at("end_ns").get<std::string>()) * 1e-9 >
        found.at("chunks").get<double>() - 1.5);
}

TEST_CASE("What the official reader finds in a file that is cut off, Elsie finds, too") {
  const Workplace here;
  here.elsie("run worlds/open_arena.xml --duration 6 --record run.mcap");
  const std::string bytes = here.read("run.mcap");
  for (const double part : {0.3, 0.62, 0.9}) {
    here.write("cut.mcap",
               bytes.substr(0, static_cast<std::size_t>(part * static_cast<double>(bytes.size()))));
    const json found = read_officially(here.file("cut.mcap"), "streamed");
    CHECK(found.at("problems") == json::array());
    const auto replay = here.elsie("replay cut.mcap");
    CHECK_THAT(replay.out,
               Catch::Contains("after " + std::to_string(found.at("chunks").get<int>()) +
                               " complete chunk"));
  }
}

TEST_CASE("When a plugin crashes, all that was recorded until then is in the file") {
  const Workplace here;
  here.write("world.xml", R"(<world format="1"><robots><robot id="r1"><behaviors>
      <segfaulting/></behaviors><coordinator><arbiter_suppression/></coordinator>
      </robot></robots></world>)");
  const auto run = here.elsie("run world.xml --record run.mcap --record-rate 100 --plugin-path '" +
                              build_path("tests/program/plugins") + "'");
  CHECK(run.exit_code == 3);
  CHECK_THAT(run.err, Catch::Contains("what was recorded until then is kept"));
  const json found = read_officially(here.file("run.mcap"), "streamed");
  CHECK(found.at("problems") == json::array());
  CHECK(found.at("complete") == false);
  CHECK(found.at("channels").at("/robots/r1/state").at("messages") == 51);
  const std::string replay = here.elsie("replay run.mcap").out;
  CHECK_THAT(replay,
             Catch::Contains("stopped after 0.5 s: the program was brought down in the step "
                             "after it\n") &&
                 Catch::Contains("the end is missing") && !Catch::Contains("state hash"));
}
