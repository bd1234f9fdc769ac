// What robots do and hear, in recordings.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

#include <catch2/catch.hpp>

#include "elsie/commands/led.h"
#include "elsie/recording/csv_recorder.h"

#include "recorded.h"

using namespace elsie;
using namespace elsie::test;
using simulation::Simulation;

namespace {

struct Offer {
  static constexpr const char* kind = "offer";
  double x = 0.0;

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("x", x, "m");
  }
};

/// "r1" shines and speaks, "r2" listens.
const ScriptedHost& talking() {
  static const ScriptedHost host([](const Perception& now) {
    Response response;
    if (now.self().id == "r1") {
      response.act(LedCommand{{0, 255, 0}, 0.5});
      response.say(Offer{1.5});
    }
    return response;
  });
  return host;
}

world::World of_two() {
  world::World world;
  const auto carries = [](world::Robot& robot, const std::string& plugin) {
    world::MountedUse& use = robot.actuators.emplace_back();
    use.plugin = use.id = plugin;
  };
  for (const std::string id : {"r1", "r2"}) {
    world::Robot robot = test::robot(id, id == "r1" ? 0 : 1, 0, 0, behavior("scripted"));
    carries(robot, "radio");
    if (id == "r1") carries(robot, "led");
    world.robots.push_back(robot);
  }
  world.limits.time = 0.5;
  return world;
}

}  // namespace

TEST_CASE(
    "A recording has the commands that actuators carry out, who gave them, and what was heard") {
  const RecordedFile file(of_two(), talking().host);
  auto all = recorded(file.path);
  const auto& last = all["/robots/r1/readings"].back().content;
  CHECK(last.at("actuators").at("led").at("brightness") == 0.5);
  CHECK(last.at("actuators").at("led").at("green") == 255.0);
  CHECK(last.at("actuators").at("led").at("by") == "scripted");
  CHECK(last.at("actuators").at("radio").at("bytes") == 8.0);
  CHECK_FALSE(all.contains("/robots/r1/heard"));
  const auto& heard = all["/robots/r2/heard"].back().content.at("heard");
  REQUIRE(heard.size() == 1);
  CHECK(heard[0].at("by") == "radio");
  CHECK(heard[0].at("from") == "r1");
  CHECK(heard[0].at("kind") == "offer");
  CHECK(heard[0].at("age_s").get<double>() == Approx(0.01));
  CHECK(heard[0].at("message").at("x") == 1.5);
}

TEST_CASE("Each message that was heard is recorded once, however often samples are taken") {
  const int control_steps = GENERATE(1, 10);
  const double rate_hz = GENERATE(5.0, 1000.0);
  world::World world = of_two();
  world.physics.control_steps = control_steps;
  recording::RecorderOptions options;
  options.rate_hz = rate_hz;
  const RecordedFile file(world, talking().host, {}, options);
  const traces::Trace trace = recording::read_trace(file.path);
  REQUIRE(file.result.robots[1].talk);
  REQUIRE(file.result.robots[1].talk->heard > 0);
  CHECK(trace.robots[1].heard.size() ==
        static_cast<std::size_t>(file.result.robots[1].talk->heard));
}

TEST_CASE("A robot without actuators has messages as before") {
  world::World world = of_two();
  for (world::Robot& robot : world.robots) robot.actuators.clear();
  const ScriptedHost silent([](const Perception&) { return Response(); });
  const RecordedFile file(world, silent.host);
  auto all = recorded(file.path);
  REQUIRE(all["/robots/r1/readings"].size() > 1);
  for (const auto& each : all["/robots/r1/readings"]) {
    CHECK_FALSE(each.content.contains("actuators"));
  }
}

TEST_CASE("A table has a column for each number of a command") {
  TemporaryFile file;
  Simulation simulation(of_two(), talking().host);
  const auto recorder = recording::csv_recorder(file.path, {});
  simulation::Observer* const observers[] = {recorder.get()};
  simulation.run(observers);
  std::ifstream in(file.path);
  std::string head, line, row;
  std::getline(in, head);
  CHECK_THAT(head, Catch::Contains(",actuator[radio].bytes,actuator[led].red,actuator[led].green,"
                                   "actuator[led].blue,actuator[led].brightness,"));
  CHECK_THAT(head, Catch::Contains(",talk.sent,talk.heard,"));
  std::string listener;
  while (std::getline(in, line)) {
    (line.find(",r1,") != std::string::npos ? row : listener) = line;
  }
  const Talk said = *simulation.robot(0).talk, understood = *simulation.robot(1).talk;
  REQUIRE(said.sent > 0);
  REQUIRE(understood.heard > 0);
  CHECK_THAT(row, Catch::Contains(",8,0,255,0,0.5," + std::to_string(said.sent) + ",0,"));
  CHECK_THAT(listener, Catch::Contains(",,,,,0," + std::to_string(understood.heard) + ","));
}

TEST_CASE("The same run is recorded and not recorded, bit for bit") {
  Simulation plain(of_two(), talking().host);
  const RecordedFile file(of_two(), talking().host);
  CHECK(plain.run().state_hash == file.result.state_hash);
}

TEST_CASE("A trace has what commanded the actuators of a robot, and what it heard") {
  const RecordedFile file(of_two(), talking().host);
  const traces::Trace trace = recording::read_trace(file.path);
  REQUIRE(trace.robots.size() == 2);
  const auto& actuators = trace.robots[0].actuators;
  REQUIRE(actuators.size() == 2);
  const auto led = std::find_if(actuators.begin(), actuators.end(),
                                [](const auto& each) { return each.id == "led"; });
  REQUIRE(led != actuators.end());
  REQUIRE_FALSE(led->commands.empty());
  CHECK(led->commands.back().by == "scripted");
  CHECK_THAT(led->commands.back().text, Catch::Contains("green 255"));
  CHECK(led->commands.size() <= 2);  // it holds
  CHECK(trace.robots[0].heard.empty());
  const auto& heard = trace.robots[1].heard;
  REQUIRE_FALSE(heard.empty());
  CHECK(heard.back().device == "radio");
  CHECK(heard.back().from == "r1");
  CHECK(heard.back().kind == "offer");
  CHECK_THAT(heard.back().text, Catch::Contains("x 1.5"));
}

TEST_CASE("What shines is read back, with its place and colour, while it shines") {
  McapFile file;
  Simulation simulation(of_two(), talking().host);
  record(simulation, file.path);
  const auto run = recording::read_recorded_run(file.path);
  REQUIRE(run.robots.size() == 2);
  const simulation::ActuatorView led = simulation.actuator(0, 1);
  REQUIRE(led.shine);
  REQUIRE(run.robots[0].lights.size() == 1);
  CHECK(run.robots[0].lights[0].colour == *led.shine);
  CHECK(run.robots[0].lights[0].place.x == led.frame.origin.x);
  CHECK(run.robots[0].lights[0].place.y == led.frame.origin.y);
  CHECK(run.robots[1].lights.empty());
  CHECK(recording::read_recorded_run(file.path, 0.0).robots[0].lights.empty());
}

TEST_CASE("In a trace an actuator ends when an edit removes it, and another one may begin") {
  McapFile file;
  world::World world = of_two();
  world.limits.time = 1.0;
  Simulation simulation(std::move(world), talking().host);
  {
    const auto recorder = recording::mcap_recorder(file.path);
    simulation::Observer* const observers[] = {recorder.get()};
    const simulation::TimedEdit changes[] = {
        {0.35, {"robot[r2]/actuator[radio]/@remove", "true"}},
        {0.65, {"robot[r2]/actuator[+]", R"(<radio id="radio"/>)"}}};
    simulation.run(observers, changes);
  }
  const traces::Trace trace = recording::read_trace(file.path);
  std::vector<traces::TraceActuator> radios;
  for (const traces::TraceRobot& robot : trace.robots) {
    if (robot.id != "r2") continue;
    radios.insert(radios.end(), robot.actuators.begin(), robot.actuators.end());
  }
  REQUIRE(radios.size() == 2);
  CHECK(radios[0].to_s == Approx(0.4));
  CHECK(radios[1].commands.front().time_s == Approx(0.7));
  CHECK(std::isinf(radios[1].to_s));
}
