// Recordings in the hands of the official reader, which holds every message against its schema.
#include <algorithm>

#include <catch2/catch.hpp>

#include "elsie/recording/recorded_run.h"

#include "official_reader.h"
#include "program.h"

using namespace elsie::test;
using nlohmann::json;

TEST_CASE("The official reader finds what was written, by the indexes and from the beginning") {
  const Workplace here;
  const char* const runs[] = {
      "worlds/find_resource.xml --duration 5 --record-images",  // cameras
      "worlds/train.xml --duration 5",                          // segments
      "worlds/clutter_moving.xml --duration 5 --record-rate 3",
      "worlds/nested.xml --duration 12.34 --record-times",
      "worlds/ten_robots.xml --duration 3 --record-rate 1000",
      "worlds/ten_robots.xml --duration 1 --record-robots r1,r4",  // a crowd
      "worlds/pushing.xml",              // to its end: events, boxes that are pushed
      "worlds/guard.xml --duration 20",  // graphs
  };
  for (const char* arguments : runs) {
    INFO(arguments);
    const auto ran = here.elsie(std::string("run ") + arguments + " --record run.mcap --json");
    REQUIRE(ran.exit_code <= 1);
    const json result = json::parse(ran.out);
    const auto own = elsie::recording::read_recorded_run(here.file("run.mcap"));
    for (const char* mode : {"indexed", "streamed"}) {
      INFO(mode);
      const json found = read_officially(here.file("run.mcap"), mode);
      CHECK(found.at("problems") == json::array());
      CHECK(found.at("complete") == true);
      CHECK(found.at("messages") == own.messages);
      CHECK(found.at("library").get<std::string>().starts_with("elsie "));
      const json& end = found.at("metadata").at("elsie.result");
      CHECK(end.at("state_hash") == result.at("state_hash"));
      CHECK(end.at("outcome") == result.at("outcome"));
      REQUIRE(found.at("channels").size() == own.channels.size());
      for (const auto& channel : own.channels) {
        const json& officially = found.at("channels").at(channel.topic);
        CHECK(officially.at("messages") == channel.messages);
        CHECK(officially.at("schema") == channel.schema);
      }
    }
  }
}

TEST_CASE("Each robot's readings can be listed by their schema, before the first message") {
  const Workplace here;
  here.write("world.xml", R"(<world format="1"><robots>
      <robot id="r1"><sensors><beam_range id="left"/><vision id="eye"/></sensors>
        <behaviors><wander/></behaviors><coordinator><arbiter_suppression/></coordinator></robot>
      <robot id="r2" x="2"><sensors><beam_range id="front"/></sensors>
        <behaviors><wander/></behaviors><coordinator><arbiter_suppression/></coordinator></robot>
      </robots><limits time="1"/></world>)");
  here.elsie("run world.xml --quiet --record run.mcap");
  const json found = read_officially(here.file("run.mcap"), "indexed");
  CHECK(found.at("problems") == json::array());
  const json& channels = found.at("channels");
  const json& one = channels.at("/robots/r1/readings");
  CHECK(one.at("schema") == "elsie.Readings.r1");
  CHECK(one.at("messages") == 10);
  const auto numbers = one.at("numbers").get<std::vector<std::string>>();
  CHECK_THAT(numbers, Catch::VectorContains(std::string("sensors.left.distance_m")));
  CHECK(std::any_of(numbers.begin(), numbers.end(),
                    [](const auto& name) { return name.starts_with("sensors.eye."); }));
  CHECK(channels.at("/robots/r2/readings").at("numbers") ==
        json{"sensors.front.distance_m", "sensors.front.hit"});
}

TEST_CASE("The official reader finds fault with what is wrong") {
  const Workplace here;
  here.elsie("run worlds/open_arena.xml --duration 3 --record run.mcap");
  std::string bytes = here.read("run.mcap");
  bytes[bytes.find("zstd") + 60] ^= 1;
  here.write("wrong.mcap", bytes);
  for (const char* mode : {"indexed", "streamed"}) {
    CHECK(!read_officially(here.file("wrong.mcap"), mode).at("problems").empty());
  }
}
