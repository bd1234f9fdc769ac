// Recordings of more robots than a viewer can list.
#include <fstream>

#include <catch2/catch.hpp>

#include "elsie/recording/csv_recorder.h"
#include "elsie/recording/formats.h"

#include "recorded.h"

using namespace elsie;
using namespace elsie::test;
using recording::read_recorded_run;
using simulation::Simulation;

namespace {

/// Robots that drive ahead, each on a way of its own.
world::World column(int robots, double duration_s = 0.5) {
  world::World world;
  world.physics.engine = "planar";
  world.arena.length = 10.0;
  world.arena.width = robots + 2.0;
  world.limits.time = duration_s;
  for (int i = 0; i < robots; ++i) {
    world.robots.push_back(robot("r" + std::to_string(i + 1), -4, i - 0.5 * robots, 0,
                                 behavior("go_to_point", 1, {{"x", 4.0}})));
  }
  return world;
}

std::string channel_of(const std::string& robot, const std::string& kind) {
  return "/robots/" + robot + "/" + kind;
}

}  // namespace

TEST_CASE("The robots that are asked for have channels; of the others the poses are recorded") {
  const RecordedFile file(column(5), shipped(), {}, {.robots = {"r2", "r4"}});
  const auto all = recorded(file.path);
  for (const char* kind : {"state", "readings", "command", "trace"}) {
    CHECK(all.contains(channel_of("r2", kind)));
    CHECK(all.contains(channel_of("r4", kind)));
    CHECK(!all.contains(channel_of("r1", kind)));
  }
  CHECK(all.at("/tf").front().content.at("transforms").size() == 2);
  CHECK(all.at("/crowd").size() == 6);  // one each 0.1 s
  CHECK(all.at("/crowd").front().content.at("point_stride") == 24);
  CHECK(all.at("/world").front().content.at("crowd") == nlohmann::json({"r1", "r3", "r5"}));

  const auto run = read_recorded_run(file.path);
  CHECK(run.crowd == std::vector<std::string>{"r1", "r3", "r5"});
  REQUIRE(run.robots.size() == 5);
  for (const picture::RobotTrack& track : run.robots) {
    const auto& robot = *std::find_if(file.result.robots.begin(), file.result.robots.end(),
                                      [&](const auto& each) { return each.id == track.id; });
    CHECK(track.now == robot.pose);  // bit for bit
    CHECK(track.path.size() == 6);
  }
}

TEST_CASE("A recording for viewers has channels for the first thousand robots") {
  const RecordedFile file(column(1003, 0.02), shipped());
  const auto run = read_recorded_run(file.path);
  CHECK(run.crowd == std::vector<std::string>{"r1001", "r1002", "r1003"});
  CHECK(run.robots.size() == 1003);
  CHECK(recording::format_of("run.mcap")->most_robots == 1000);
}

TEST_CASE("A trace has the robots whose decisions were recorded, and says who else was there") {
  world::World close = column(2, 2);
  close.robots[0].x = 4.5;  // it drives into the wall
  close.robots[0].behaviors = {behavior("go_to_point", 1, {{"x", 20.0}})};
  const RecordedFile file(close, shipped(), {}, {.robots = {"r2"}});
  const traces::Trace trace = recording::read_trace(file.path);
  REQUIRE(trace.robots.size() == 1);
  CHECK(trace.robots[0].id == "r2");
  CHECK(trace.without_decisions == std::set<std::string>{"r1"});
  const auto events = recorded(file.path).at("/events");  // of all robots
  CHECK(std::any_of(events.begin(), events.end(),
                    [](const Recorded& event) { return event.content.at("name") == "r1"; }));
}

TEST_CASE("A robot keeps its channels when an edit removes another, and the crowd its poses") {
  McapFile file;
  Simulation simulation(column(4), shipped());
  const auto recorder = recording::mcap_recorder(file.path, {.robots = {"r3"}});
  simulation::Observer* const observers[] = {recorder.get()};
  const simulation::TimedEdit changes[] = {{0.25, {"robot[r1]/@remove", "true"}}};
  const auto result = simulation.run(observers, changes);
  const auto run = read_recorded_run(file.path);
  CHECK(run.crowd == std::vector<std::string>{"r2", "r4"});
  REQUIRE(run.robots.size() == 3);
  for (const picture::RobotTrack& track : run.robots) {
    const auto& robot = *std::find_if(result.robots.begin(), result.robots.end(),
                                      [&](const auto& each) { return each.id == track.id; });
    CHECK(track.now == robot.pose);
  }
  CHECK(recorded(file.path).at(channel_of("r3", "state")).size() == 6);
}

TEST_CASE("A table has rows of the robots that are asked for, and without any of all") {
  const auto robots_in = [](std::vector<std::string> asked) {
    TemporaryFile file;
    Simulation simulation(column(3, 0.1), shipped());
    const auto recorder = recording::csv_recorder(file.path, {.rate_hz = 10, .robots = asked});
    simulation::Observer* const observers[] = {recorder.get()};
    simulation.run(observers);
    std::set<std::string> found;
    std::ifstream in(file.path);
    std::string line;
    for (std::getline(in, line); std::getline(in, line);) {
      const std::size_t comma = line.find(',') + 1;
      found.insert(line.substr(comma, line.find(',', comma) - comma));
    }
    return found;
  };
  CHECK(robots_in({"r2"}) == std::set<std::string>{"r2"});
  CHECK(robots_in({}) == std::set<std::string>{"r1", "r2", "r3"});
}

TEST_CASE("A crowd that Elsie did not write is refused in a sentence") {
  McapFile file;
  for (const char* message :
       {R"({"point_stride": 24, "data": "AAAA"})", R"({"point_stride": 24, "data": "?"})",
        R"({"point_stride": 8, "data": ""})"}) {
    mcap::Writer writer(file.path);
    writer.write(mcap::Metadata{"elsie.run", {{"step_s", "0.01"}, {"sample_steps", "10"}}});
    writer.write(writer.add_channel("/crowd", 0, "json"), 0, message);
    writer.close();
    CHECK_THROWS_WITH(read_recorded_run(file.path),
                      Catch::Contains("its data are not points of 24 bytes"));
  }
}
