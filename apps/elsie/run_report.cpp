#include "run_report.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <vector>

#include <nlohmann/json.hpp>

#include "elsie/api/geometry.h"

namespace {

using elsie::simulation::RobotResult;
using elsie::simulation::RunResult;

std::string text(const char* format, double value) {
  char buffer[64];
  std::snprintf(buffer, sizeof(buffer), format, value);
  return buffer;
}

std::vector<std::string> row(const RobotResult& robot) {
  return {robot.id,
          robot.team,
          text("%.2f", robot.distance_m),
          std::to_string(robot.collected),
          text("%.0f", robot.energy),
          std::to_string(robot.collisions),
          text("%.2f", robot.pose.x) + ", " + text("%.2f", robot.pose.y) + ", " +
              text("%.0f", elsie::degrees(robot.pose.heading_rad))};
}

std::string laid_out(const std::vector<std::vector<std::string>>& rows) {
  constexpr std::size_t kTextColumns = 2;  // id and team stand to the left, numbers to the right
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const auto& cells : rows) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      widths[i] = std::max(widths[i], cells[i].size());
    }
  }
  std::string text;
  for (const auto& cells : rows) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string padding(widths[i] - cells[i].size(), ' ');
      line += (i ? "  " : "") + (i < kTextColumns ? cells[i] + padding : padding + cells[i]);
    }
    text += line + '\n';
  }
  return text;
}

/// JSON text must be UTF-8; ids come from XML, which is.
std::string dumped(const nlohmann::ordered_json& object) {
  return object.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace

std::string headline(const RunResult& result) {
  return std::string(to_string(result.outcome)) + " after " + text("%.1f", result.simulated_s) +
         " s: " + result.reason;
}

std::string table(const RunResult& result) {
  const double speed = result.wall_s > 0.0 ? result.simulated_s / result.wall_s : 0.0;
  std::string out = headline(result) + '\n';
  out += "seed " + std::to_string(result.seed) + ", " + std::to_string(result.steps) +
         " steps in " + text("%.2f", result.wall_s) + " s, " + text("%.0f", speed) +
         " x real time\n";
  if (!result.robots.empty()) {
    std::vector<std::vector<std::string>> rows{{"robot", "team", "distance m", "collected",
                                                "energy", "collisions", "x m, y m, heading deg"}};
    for (const RobotResult& robot : result.robots) {
      rows.push_back(row(robot));
    }
    out += '\n' + laid_out(rows);
  }
  std::map<std::string, int> counts;
  for (const auto& event : result.events) {
    ++counts[event.name];
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
  char hash[17];
  std::snprintf(hash, sizeof(hash), "%016llx", static_cast<unsigned long long>(result.state_hash));
  nlohmann::ordered_json object;
  object["outcome"] = to_string(result.outcome);
  object["reason"] = result.reason;
  object["seed"] = result.seed;
  object["simulated_s"] = result.simulated_s;
  object["wall_s"] = result.wall_s;
  object["steps"] = result.steps;
  object["state_hash"] = hash;
  object["robots"] = nlohmann::ordered_json::array();
  for (const RobotResult& robot : result.robots) {
    object["robots"].push_back({{"id", robot.id},
                                {"team", robot.team},
                                {"distance_m", robot.distance_m},
                                {"collected", robot.collected},
                                {"energy", robot.energy},
                                {"pose", {robot.pose.x, robot.pose.y, robot.pose.heading_rad}},
                                {"collisions", robot.collisions}});
  }
  object["events"] = nlohmann::ordered_json::array();
  for (const auto& event : result.events) {
    object["events"].push_back({{"time_s", event.time_s},
                                {"robot", event.robot},
                                {"name", event.name},
                                {"detail", event.detail}});
  }
  return dumped(object) + '\n';
}
