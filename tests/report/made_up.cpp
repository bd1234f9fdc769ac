#include "made_up.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "elsie/base/random.h"
#include "elsie/results/database_file.h"
#include "elsie/results/hash.h"
#include "elsie/results/sqlite.h"

namespace elsie::test {

namespace {

using Json = nlohmann::ordered_json;
using results::sqlite::Statement;

class Writer {
 public:
  explicit Writer(const std::filesystem::path& file)
      : connection_((std::filesystem::remove(file), results::make_database(file))) {
    results::make_schema(connection_);
    connection_.run("BEGIN");
  }

  void run(const std::string& sql) { connection_.run(sql); }

  // A row; null, numbers and texts.
  void insert(const std::string& table, const Json& row) {
    std::string columns;
    for (const auto& [name, value] : row.items()) {
      columns += (columns.empty() ? "" : ", ") + name;
    }
    auto statement = Statement::insert(connection_, table, columns);
    int place = 0;
    for (const auto& value : row) {
      ++place;
      if (value.is_null()) {
        statement.bind_null(place);
      } else if (value.is_number_integer()) {
        statement.bind(place, value.get<std::int64_t>());
      } else if (value.is_number()) {
        statement.bind(place, value.get<double>());
      } else {
        statement.bind(place, value.get<std::string>());
      }
    }
    statement.run();
  }

 private:
  results::sqlite::Connection connection_;
};

double thousandths(double value) { return std::round(value * 1e3) / 1e3; }

// Bytes that are not UTF-8 are replaced, as in a batch.
std::string dumped(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

void insert_robot(Writer& writer, std::int64_t run, const MadeRobot& robot) {
  Json poses = Json::array(), touches = Json::array(), behaviors = Json::array(),
       episodes = Json::array(), curve = Json::array();
  for (const Pose& pose : robot.poses) {
    poses.push_back({thousandths(pose.x), thousandths(pose.y), thousandths(pose.heading_rad)});
  }
  for (const Vector2& at : robot.touches) touches.push_back({at.x, at.y});
  writer.insert("trajectories", {{"run_id", run},
                                 {"robot", robot.id},
                                 {"from_s", 0.0},
                                 {"period_s", 0.5},
                                 {"poses", dumped(poses)},
                                 {"touches", dumped(touches)}});
  if (robot.end) {
    writer.insert("run_robots", {{"run_id", run},
                                 {"robot", robot.id},
                                 {"team", "red"},
                                 {"distance_m", 1.0},
                                 {"collected", 0},
                                 {"energy", 1.0},
                                 {"collisions", 0},
                                 {"x_m", robot.end->x},
                                 {"y_m", robot.end->y},
                                 {"heading_rad", robot.end->heading_rad}});
  }
  if (!robot.episodes.empty()) {
    for (const auto& [path, share] : robot.shares) {
      double decided = 0.0;
      for (const MadeEpisode& episode : robot.episodes) {
        if (episode.decider == path) decided += episode.to_s - episode.from_s;
      }
      behaviors.push_back({{"path", path}, {"share", share}, {"decided_s", decided}});
    }
    for (const MadeEpisode& episode : robot.episodes) {
      episodes.push_back({{"from_s", episode.from_s},
                          {"to_s", episode.to_s},
                          {"decider", episode.decider},
                          {"share", 0.7}});
    }
    writer.insert("timelines", {{"run_id", run},
                                {"robot", robot.id},
                                {"behaviors", dumped(behaviors)},
                                {"episodes", dumped(episodes)}});
  }
  if (!robot.curve.empty()) {
    for (const Vector2& point : robot.curve) curve.push_back({point.x, point.y});
    writer.insert("curves", {{"run_id", run},
                             {"robot", robot.id},
                             {"plugin", "fusion_neural_network"},
                             {"name", "error"},
                             {"x_label", "presentations"},
                             {"y_label", "mean square error"},
                             {"points", dumped(curve)}});
  }
}

std::string hash_of(std::size_t cell, const MadeRun& run) {
  char text[17];
  std::snprintf(text, sizeof(text), "%016llx",
                static_cast<unsigned long long>(run.seed ^ (std::uint64_t{cell} << 32)));
  return run.state_hash.empty() ? text : run.state_hash;
}

void insert_run(Writer& writer, std::int64_t id, std::size_t cell, const MadeRun& run) {
  const bool done = run.state == "done", ended = run.state != "pending";
  writer.insert("runs", {{"id", id},
                         {"cell_id", cell},
                         {"seed", static_cast<std::int64_t>(run.seed)},
                         {"repetition", run.repetition},
                         {"state", run.state},
                         {"outcome", done ? Json(run.outcome) : Json(nullptr)},
                         {"message", or_null(run.message)},
                         {"steps", done ? Json(12345) : Json(nullptr)},
                         {"simulated_s", done ? Json(123.45) : Json(nullptr)},
                         {"state_hash", done ? Json(hash_of(cell, run)) : Json(nullptr)},
                         {"signal", or_null(run.signal)},
                         {"plugin", or_null(run.plugin)},
                         {"robot", or_null(run.robot)},
                         {"step", run.step ? Json(*run.step) : Json(nullptr)},
                         {"log", or_null(run.log)},
                         {"wall_s", ended ? Json(1.25) : Json(nullptr)},
                         {"ended", ended ? Json("2026-03-01T12:00:05Z") : Json(nullptr)}});
  for (const auto& [name, value] : run.measures) {
    writer.insert(
        "run_measures",
        {{"run_id", id}, {"measure", name}, {"value", value ? Json(*value) : Json(nullptr)}});
  }
  for (const MadeRobot& robot : run.robots) insert_robot(writer, id, robot);
}

}  // namespace

void write_database(const MadeExperiment& experiment, const std::filesystem::path& file) {
  Writer writer(file);
  std::int64_t runs = 0;
  for (const MadeCell& cell : experiment.cells) runs += static_cast<std::int64_t>(cell.runs.size());
  writer.insert("about", {{"id", 1},
                          {"elsie_version", "0.1.0"},
                          {"abi", "test"},
                          {"experiment", experiment.name},
                          {"description", experiment.description},
                          {"file", "made_up.xml"},
                          {"text", experiment.text},
                          {"fingerprint", experiment.fingerprint},
                          {"shard", experiment.shard},
                          {"runs", experiment.all_runs ? experiment.all_runs : runs},
                          {"wall_limit_s", 600.0},
                          {"trajectory_period_s", 0.5},
                          {"created", "2026-03-01T12:00:00Z"}});
  for (std::size_t i = 0; i < experiment.factors.size(); ++i) {
    writer.insert("factors", {{"id", i}, {"name", experiment.factors[i]}});
  }
  std::set<std::string> measures;
  for (const MadeCell& cell : experiment.cells) {
    for (const MadeRun& run : cell.runs) {
      for (const auto& [name, value] : run.measures) measures.insert(name);
    }
  }
  for (const std::string& name : measures) {
    const auto unit = std::find_if(experiment.units.begin(), experiment.units.end(),
                                   [&](const auto& each) { return each.first == name; });
    writer.insert("measures", {{"name", name},
                               {"unit", unit == experiment.units.end() ? "" : unit->second},
                               {"meaning", "what " + name + " means"}});
  }
  std::vector<std::vector<std::string>> levels(experiment.factors.size());
  std::int64_t id = 0;
  for (std::size_t i = 0; i < experiment.cells.size(); ++i) {
    const MadeCell& cell = experiment.cells[i];
    writer.insert("cells", {{"id", i},
                            {"label", cell.label},
                            {"world", cell.levels.at(0)},
                            {"world_text", cell.world_text},
                            {"world_file", "/nowhere/made_up_world.xml"},
                            {"sha256", results::sha256(cell.world_text)}});
    for (std::size_t factor = 0; factor < cell.levels.size(); ++factor) {
      auto& known = levels.at(factor);
      auto found = std::find(known.begin(), known.end(), cell.levels[factor]);
      if (found == known.end()) found = known.insert(known.end(), cell.levels[factor]);
      writer.insert("cell_levels", {{"cell_id", i},
                                    {"factor_id", factor},
                                    {"label", cell.levels[factor]},
                                    {"place", found - known.begin()}});
    }
    for (const MadeRun& run : cell.runs) insert_run(writer, ++id, i, run);
  }
  writer.run("COMMIT");
}

std::string made_world(std::size_t robots, bool goals) {
  std::string text =
      "<world format=\"1\" name=\"four resources\">\n"
      "  <obstacles><static_box x=\"1.5\" y=\"-1\" heading_deg=\"30\" length=\"0.8\" "
      "width=\"0.3\"/>"
      "</obstacles>\n  <resources>\n"
      "    <resource x=\"4\" y=\"4\"/><resource x=\"-4\" y=\"4\"/>\n"
      "    <resource x=\"-4\" y=\"-4\"/><resource x=\"4\" y=\"-4\"/>\n  </resources>\n  <robots>\n";
  for (std::size_t i = 0; i < robots; ++i) {
    text += "    <robot id=\"r" + std::to_string(i + 1) + "\" team=\"" + (i % 2 ? "blue" : "red") +
            "\" x=\"" + std::to_string(0.5 * static_cast<double>(i)) +
            "\"><sensors><beam_range/></sensors><behaviors><not_a_plugin speed=\"2\"/></behaviors>"
            "<coordinator><neither_a_plugin/></coordinator></robot>\n";
  }
  return text + "  </robots>\n  <measures><nor_is_this_one of=\"r1\"/></measures>\n" +
         (goals ? "  <goals><collect/></goals>\n" : "") + "  <limits time=\"280\"/>\n</world>\n";
}

MadeExperiment made_from(const std::vector<std::vector<double>>& path_lengths) {
  MadeExperiment experiment;
  experiment.factors = {"world", "scheme"};
  for (const auto& values : path_lengths) {
    MadeCell& cell = experiment.cells.emplace_back();
    cell.label = std::string(1, static_cast<char>('a' + experiment.cells.size() - 1));
    cell.levels = {"w", cell.label};
    cell.world_text = made_world();
    for (const double value : values) {
      MadeRun& run = cell.runs.emplace_back();
      run.seed = cell.runs.size();
      run.measures = {{"path_length_m", value}, {"success", 1.0}};
      run.robots.emplace_back().poses = {{0, 0, 0}, {1, 0, 0}, {1, value / 100.0, 1.57}};
    }
  }
  return experiment;
}

namespace {

// A way around the four corners with some wandering.
MadeRobot made_way(Random& random, bool fusion, bool lost, double& length_m, double& time_s) {
  MadeRobot robot;
  robot.id = "collector";
  const Vector2 corners[] = {{4, 4}, {-4, 4}, {-4, -4}, {4, -4}};
  const double speed = fusion ? 0.2 : 0.4;
  Pose pose;
  std::size_t corner = 0;
  double since = 0.0;
  bool seeking = true;
  length_m = time_s = 0.0;
  while (corner < 4 && time_s < (lost ? 280.0 : 900.0)) {
    robot.poses.push_back(pose);
    const Vector2 to = corners[corner];
    const double bearing = std::atan2(to.y - pose.y, to.x - pose.x);
    const double wandering = fusion ? 0.25 : 0.9;
    double turn = std::remainder(bearing - pose.heading_rad, 2.0 * 3.14159265358979);
    if (lost && corner == 2) turn = 0.3 + random.normal(0.0, 0.3);
    pose.heading_rad += std::clamp(turn, -0.6, 0.6) + random.normal(0.0, wandering);
    pose.x = std::clamp(pose.x + 0.5 * speed * std::cos(pose.heading_rad), -4.9, 4.9);
    pose.y = std::clamp(pose.y + 0.5 * speed * std::sin(pose.heading_rad), -4.9, 4.9);
    length_m += 0.5 * speed;
    time_s += 0.5;
    if (std::hypot(to.x - pose.x, to.y - pose.y) < 0.35) ++corner;
    const bool change = random.chance(seeking ? 0.03 : 0.2);
    if (change || corner == 4) {
      robot.episodes.push_back({since, time_s, seeking ? "find_resource" : "avoid_obstacle"});
      since = time_s;
      seeking = !seeking;
    }
  }
  robot.episodes.push_back({since, time_s, seeking ? "find_resource" : "avoid_obstacle"});
  robot.shares = {{"find_resource", fusion ? 0.83 : 0.88},
                  {"avoid_obstacle", fusion ? 0.17 : 0.12}};
  return robot;
}

std::vector<Vector2> made_curve(Random& random, std::size_t layers) {
  std::vector<Vector2> points;
  const double floor = layers > 2 ? 0.12 : 1e-10;
  double error = 0.2;
  for (int i = 0; i <= 200; ++i) {
    points.push_back({500.0 * i, error});
    error = std::max(floor * random.uniform(1.0, 1.2), error * random.uniform(0.84, 0.95));
  }
  return points;
}

}  // namespace

MadeExperiment made_study() {
  MadeExperiment study;
  study.name = "Coordination by neural networks";
  study.description =
      "Four resources in an empty arena: arbitration against fusion, with networks of four sizes.";
  study.factors = {"world", "network", "coordinator"};
  study.text = "<experiment format=\"1\" name=\"Coordination by neural networks\"/>\n";
  study.units.emplace_back("energy_left", "units");
  std::size_t cells = 0;
  for (const std::string network : {"2 2", "4 4", "2 2 2 2", "4 4 4 4"}) {
    for (const std::string coordinator : {"arbitration", "fusion"}) {
      MadeCell& cell = study.cells.emplace_back();
      cell.label = network + ", " + coordinator;
      cell.levels = {"four_resources", network, coordinator};
      cell.world_text = made_world();
      const bool fusion = coordinator == "fusion", deep = network.size() > 3;
      for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Random random(100 * cells + seed, "made up");
        MadeRun& run = cell.runs.emplace_back();
        run.seed = seed;
        char hash[32];
        std::snprintf(hash, sizeof(hash), "%016llx",
                      static_cast<unsigned long long>(random.bits()));
        run.state_hash = hash;
        const bool lost = !fusion && random.chance(deep ? 0.7 : 0.1);
        double length = 0.0, time = 0.0;
        MadeRobot robot = made_way(random, fusion, lost, length, time);
        robot.curve = made_curve(random, deep ? 4 : 2);
        if (lost) {
          run.outcome = "time_limit";
          run.message = "The time limit of 280 s was reached; two of four resources are collected.";
        }
        run.measures = {{"success", lost ? 0.0 : 1.0},
                        {"path_length_m", length},
                        {"time_s", time},
                        {"collisions", std::floor(random.uniform(0.0, fusion ? 2.0 : 6.0))},
                        {"collected", lost ? 2.0 : 4.0},
                        {"energy_left", 5000.0 - 3.1 * time}};
        run.robots.push_back(std::move(robot));
      }
      ++cells;
    }
  }
  MadeRun& crash = study.cells[2].runs[11];
  crash = MadeRun{
      12, 1,         "crash",         "",          "The process was ended by a signal.",    {},
      "", "SIGSEGV", "find_resource", "collector", "run 52: step 8120\nSegmentation fault", 8123,
      {}};
  MadeRun& fault = study.cells[6].runs[3];
  fault = MadeRun{4,
                  1,
                  "fault",
                  "",
                  "behavior 'avoid_obstacle' answered with a NaN.",
                  {},
                  "",
                  "",
                  "avoid_obstacle",
                  "collector",
                  "",
                  2210,
                  {}};
  return study;
}

}  // namespace elsie::test
