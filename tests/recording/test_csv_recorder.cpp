#include <filesystem>
#include <fstream>
#include <sstream>

#include <catch2/catch.hpp>

#include "elsie/recording/csv_recorder.h"
#include "elsie/traces/tracks.h"

#include "folder.h"
#include "world_builder.h"

using namespace elsie;
using namespace elsie::test;
using recording::csv_recorder;
using simulation::Simulation;

namespace {

using Table = std::vector<std::vector<std::string>>;

Table read(const std::filesystem::path& file) {
  Table table;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    std::vector<std::string> cells;
    std::string cell;
    for (std::istringstream cells_in(line); std::getline(cells_in, cell, ',');) {
      cells.push_back(cell);
    }
    if (!line.empty() && line.back() == ',') {
      cells.emplace_back();
    }
    table.push_back(std::move(cells));
  }
  return table;
}

std::size_t column(const Table& table, const std::string& name) {
  const auto at = std::find(table[0].begin(), table[0].end(), name);
  REQUIRE(at != table[0].end());
  return static_cast<std::size_t>(at - table[0].begin());
}

simulation::RunResult record_table(Simulation& simulation, const std::filesystem::path& file,
                                   double rate_hz) {
  const auto recorder = csv_recorder(file, {.rate_hz = rate_hz});
  simulation::Observer* const observers[] = {recorder.get()};
  return simulation.run(observers);
}

world::World two_robots() {
  world::World world;
  world.robots.push_back(robot("r1", 0, 0, 0, behavior("go_to_point", 2, {{"x", 3.0}})));
  world.robots[0].behaviors.push_back(behavior("wander", 1));
  world.robots[0].sensors.push_back(beam("eye", 0));
  world.robots.push_back(robot("r2", 1, 1, 0, behavior("wander")));
  world.limits.time = 1;
  return world;
}

}  // namespace

TEST_CASE(
    "A recording has a row per robot and sample, with poses, commands, readings and the trace") {
  TemporaryFile file;
  Simulation simulation(two_robots(), shipped());
  const auto result = record_table(simulation, file.path, 20);
  const Table table = read(file.path);
  REQUIRE(table.size() == 1 + 2 * 21);
  for (const auto& row : table) {
    CHECK(row.size() == table[0].size());
  }
  const auto& last = table[table.size() - 2];
  CHECK(last[column(table, "robot")] == "r1");
  CHECK(std::stod(last[column(table, "time_s")]) == 1.0);
  CHECK(std::stod(last[column(table, "x_m")]) == result.robots[0].pose.x);  // bit for bit
  CHECK(std::stod(last[column(table, "distance_m")]) == result.robots[0].distance_m);
  CHECK(std::stod(last[column(table, "sensor[eye].distance_m")]) == 1.0);
  CHECK(last[column(table, "sensor[eye].hit")] == "0");
  const simulation::RobotView robot = simulation.robot(0);
  CHECK(std::stod(last[column(table, "forward_m_s")]) == robot.moving.forward);
  CHECK(std::stod(last[column(table, "lateral_m_s")]) == robot.moving.lateral);
  CHECK(std::stod(last[column(table, "turn_rad_s")]) == robot.moving.turn);
  CHECK(std::stod(last[column(table, "asked_forward_m_s")]) == robot.asked.forward);
  CHECK(std::stod(last[column(table, "command_forward_m_s")]) == robot.command.forward);
  CHECK(std::stod(last[column(table, "behavior[go_to_point].turn_rad_s")]) == robot.asked.turn);
  CHECK(last[column(table, "behavior[go_to_point].asked")] == "1");
  CHECK(last[column(table, "behavior[go_to_point].share")] == "1");
  CHECK(last[column(table, "behavior[go_to_point].reason")] == "highest priority");
  CHECK(last[column(table, "behavior[wander].asked")] == "0");
  CHECK(last[column(table, "behavior[wander].inhibited_by")] == "go_to_point");
  const auto& other = table.back();
  CHECK(other[column(table, "robot")] == "r2");
  CHECK(other[column(table, "sensor[eye].distance_m")].empty());
  CHECK(other[column(table, "behavior[go_to_point].asked")].empty());
  CHECK(other[column(table, "behavior[wander].asked")] == "1");
}

TEST_CASE("The first row is before any decision: no readings, no trace") {
  TemporaryFile file;
  Simulation simulation(two_robots(), shipped());
  record_table(simulation, file.path, 20);
  const Table table = read(file.path);
  CHECK(table[1][column(table, "time_s")] == "0");
  CHECK(table[1][column(table, "x_m")] == "0");
  CHECK(table[1][column(table, "sensor[eye].distance_m")].empty());
  CHECK(table[1][column(table, "behavior[wander].asked")].empty());
}

TEST_CASE("A run has the same bytes each time that it is recorded, also after a reset") {
  const auto bytes = [](Simulation& simulation) {
    const Folder folder;
    record_table(simulation, folder.file("run.csv"), 100);
    return folder.read("run.csv");
  };
  Simulation simulation(two_robots(), shipped()), other(two_robots(), shipped());
  const std::string first = bytes(simulation);
  CHECK(first.size() > 10000);
  simulation.reset();
  CHECK(bytes(simulation) == first);
  CHECK(bytes(other) == first);
}

TEST_CASE("A rate of next to nothing samples the start only, a very high one every step") {
  for (const auto& [rate, rows] : {std::pair{1e-300, 1u}, std::pair{1e300, 101u}}) {
    TemporaryFile file;
    Simulation simulation(two_robots(), shipped());
    record_table(simulation, file.path, rate);
    CHECK(read(file.path).size() == 1 + 2 * rows);
  }
}

TEST_CASE("What was recorded until a plugin failed is kept") {
  TemporaryFile file;
  ScriptedHost scripted([](const Perception& now) -> Response {
    if (now.time_s() > 0.5) {
      throw std::runtime_error("enough");
    }
    return Motion{};
  });
  world::World world = one_robot();
  Simulation simulation(world, scripted.host);
  CHECK_THROWS_AS(record_table(simulation, file.path, 100), simulation::PluginFault);
  CHECK(read(file.path).size() == 1 + 52);
}

TEST_CASE("A table that cannot be made says so") {
  CHECK_THROWS_WITH(csv_recorder("/nowhere/at/all.csv", {}),
                    Catch::Contains("'/nowhere/at/all.csv' cannot be created"));
  TemporaryFile file;
  CHECK_THROWS_WITH(csv_recorder(file.path, {.rate_hz = 0}),
                    "a recording needs a positive number of samples a second");
}

TEST_CASE("Tracks keep a pose a period, and where a robot collided") {
  world::World world = one_robot(behavior("wander", 1, {{"speed", 20.0}, {"restlessness", 0.0}}));
  world.obstacles.push_back(box("b", world::ObstacleKind::fixed, 0.5, 0));
  world.limits.time = 2;
  traces::TrackRecorder tracks(0.25);
  simulation::Observer* const observers[] = {&tracks};
  Simulation(world, shipped()).run(observers);
  REQUIRE(tracks.tracks().size() == 1);
  CHECK(tracks.period_s() == Approx(0.25));
  CHECK(tracks.tracks()[0].path.size() == 9);
  REQUIRE(tracks.tracks()[0].touches.size() == 1);
  CHECK(tracks.tracks()[0].touches[0].x == Approx(0.35).margin(0.02));
}

TEST_CASE("Tracks tell which poses a robot did not drive to") {
  world::World world;
  world.robots.push_back(robot("r1", 0, 0, 0, behavior("wander", 1)));
  world.robots.push_back(robot("r2", 0, 2, 0, behavior("wander", 1)));
  world.limits.time = 2;
  traces::TrackRecorder tracks(0.25);
  simulation::Observer* const observers[] = {&tracks};
  const simulation::TimedEdit changes[] = {{1.1, {"robot[r1]/@x", "-3"}},
                                           {1.1, {"robot[r2]/@max_speed", "0.1"}}};
  Simulation(world, shipped()).run(observers, changes);
  CHECK(tracks.tracks()[0].placed == std::vector<std::size_t>{5});
  CHECK(tracks.tracks()[0].path[5].x == Approx(-3).margin(0.1));
  CHECK(tracks.tracks()[1].placed.empty());
}
