#include "run_report.h"

#include <algorithm>
#include <map>
#include <vector>

#include <nlohmann/json.hpp>

#include "elsie/api/geometry.h"
#include "elsie/base/number_text.h"
#include "elsie/process/text_table.h"
#include "elsie/simulation/measures.h"

namespace elsie::program {

namespace {

using simulation::RobotResult;
using simulation::RunResult;

constexpr std::size_t kTextColumns = 2;  // id and team
constexpr std::size_t kMeasureTextColumns = 2;
constexpr std::size_t kMostRows = 100;  // of more robots, the table has the first few
constexpr std::size_t kFirstRows = 20;

/// `talks`: robots of the table may have sent messages.
std::vector<std::string> row(const RobotResult& robot, bool talks) {
  std::vector<std::string> cells{robot.id,
                                 robot.team,
                                 base::fixed_text(robot.distance_m, 2),
                                 std::to_string(robot.collected),
                                 base::fixed_text(robot.energy, 0),
                                 std::to_string(robot.collisions)};
  if (talks) {
    cells.push_back(robot.talk ? std::to_string(robot.talk->sent) : "-");
    cells.push_back(robot.talk ? std::to_string(robot.talk->heard) : "-");
  }
  cells.push_back(base::fixed_text(robot.pose.x, 2) + ", " + base::fixed_text(robot.pose.y, 2) +
                  ", " + base::fixed_text(elsie::degrees(robot.pose.heading_rad), 0));
  return cells;
}

/// The measures of the world; those of every run are in other rows of the table.
std::string measures(const RunResult& result) {
  if (result.measures.size() <= simulation::kMeasuresOfEveryRun) {
    return "";
  }
  std::vector<std::vector<std::string>> rows{{"measure", "meaning", "value", "unit"}};
  for (std::size_t i = simulation::kMeasuresOfEveryRun; i < result.measures.size(); ++i) {
    const simulation::MeasuredValue& measured = result.measures[i];
    rows.push_back({measured.name, measured.meaning,
                    measured.value ? base::number_text(*measured.value, 6) : "none",
                    measured.unit});
  }
  return '\n' + process::laid_out(rows, kMeasureTextColumns);
}

/// JSON must be UTF-8; ids come from XML, which is UTF-8.
std::string dumped(const nlohmann::ordered_json& object) {
  return object.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace

std::string headline(const std::string& outcome, double simulated_s, const std::string& reason) {
  return outcome + " after " + base::fixed_text(simulated_s, 1) + " s: " + reason;
}

std::string headline(const RunResult& result) {
  return headline(to_string(result.outcome), result.simulated_s, result.reason);
}

std::string table(const RunResult& result) {
  const double speed = result.wall_s > 0.0 ? result.simulated_s / result.wall_s : 0.0;
  std::string out = headline(result) + '\n';
  out += "seed " + std::to_string(result.seed) + ", " + std::to_string(result.steps) +
         " steps in " + base::fixed_text(result.wall_s, 2) + " s, " + base::fixed_text(speed, 0) +
         " x real time\n";
  if (!result.robots.empty()) {
    const bool talks = std::any_of(result.robots.begin(), result.robots.end(),
                                   [](const RobotResult& robot) { return robot.talk; });
    std::vector<std::vector<std::string>> rows{
        {"robot", "team", "distance m", "collected", "energy", "collisions"}};
    if (talks) rows[0].insert(rows[0].end(), {"sent", "heard"});
    rows[0].push_back("x m, y m, heading deg");
    const std::size_t count = result.robots.size();
    const std::size_t shown = count > kMostRows ? kFirstRows : count;
    for (std::size_t i = 0; i < shown; ++i) {
      rows.push_back(row(result.robots[i], talks));
    }
    out += '\n' + process::laid_out(rows, kTextColumns);
    if (shown < count) {
      out += "and " + std::to_string(count - shown) + " more; --json has all\n";
    }
  }
  out += measures(result);
  if (!result.notes.empty()) {
    out += '\n';
    for (const auto& note : result.notes) {
      out += (note.robot.empty() ? "" : note.robot + ", ") + note.plugin + ": " + note.text + '\n';
    }
  }
  std::map<std::string, int> counts;
  for (const auto& event : result.events) {
    ++counts[event.name()];
  }
  if (!counts.empty()) {
    out += "\nevents:";
    for (const auto& [name, count] : counts) {
      out += " " + name + " " + std::to_string(count);
    }
    out += '\n';
  }
  return out;
}

std::string json(const RunResult& result) {
  nlohmann::ordered_json object;
  object["outcome"] = to_string(result.outcome);
  object["reason"] = result.reason;
  object["seed"] = result.seed;
  object["simulated_s"] = result.simulated_s;
  object["wall_s"] = result.wall_s;
  object["steps"] = result.steps;
  object["state_hash"] = simulation::hash_text(result.state_hash);
  object["solver"] = {
      {"gave_up_steps", result.solver.gave_up},
      {"unsolved_steps", result.solver.unsolved},
      {"since_s",
       result.solver.gave_up > 0 ? nlohmann::ordered_json(result.solver.since_s) : nullptr}};
  object["robots"] = nlohmann::ordered_json::array();
  for (const RobotResult& robot : result.robots) {
    object["robots"].push_back({{"id", robot.id},
                                {"team", robot.team},
                                {"distance_m", robot.distance_m},
                                {"collected", robot.collected},
                                {"energy", robot.energy},
                                {"pose", {robot.pose.x, robot.pose.y, robot.pose.heading_rad}},
                                {"collisions", robot.collisions}});
    if (robot.talk) {
      object["robots"].back()["messages_sent"] = robot.talk->sent;
      object["robots"].back()["messages_heard"] = robot.talk->heard;
    }
  }
  object["events"] = nlohmann::ordered_json::array();
  for (const auto& event : result.events) {
    object["events"].push_back({{"time_s", event.time_s},
                                {"robot", event.robot},
                                {"name", event.name()},
                                {"detail", event.detail()}});
  }
  object["notes"] = nlohmann::ordered_json::array();
  for (const auto& note : result.notes) {
    object["notes"].push_back(
        {{"robot", note.robot}, {"plugin", note.plugin}, {"text", note.text}});
  }
  object["measures"] = nlohmann::ordered_json::array();
  for (const auto& measured : result.measures) {
    object["measures"].push_back(
        {{"name", measured.name},
         {"unit", measured.unit},
         {"meaning", measured.meaning},
         {"value", measured.value ? nlohmann::ordered_json(*measured.value) : nullptr}});
  }
  return dumped(object) + '\n';
}

}  // namespace elsie::program
