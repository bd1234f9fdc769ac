#include "run_texts.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "elsie/base/number_text.h"

namespace elsie::batch {
namespace {

double thousandths(double value) { return base::rounded(value, 3); }

/// To three decimals, in as few characters as possible; non-finite values become null.
void append(std::string& text, double value) {
  if (!std::isfinite(value)) {
    text += "null";
    return;
  }
  text += base::NumberText(thousandths(value)).view();
}

template <class... Values>
void append_list(std::string& text, Values... values) {
  text += text.size() > 1 ? ",[" : "[";
  std::size_t count = 0;
  ((count++ > 0 ? text += ',' : text, append(text, values)), ...);
  text += ']';
}

std::string name_of(traces::Decider decider, const traces::TraceRobot& robot) {
  if (decider >= 0) {
    return robot.members[static_cast<std::size_t>(decider)].path;
  }
  return decider == traces::kTogether ? "*" : "";
}

}  // namespace

Trajectory trajectory_of(const std::string& robot, const traces::Track& track, double period_s,
                         std::size_t most) {
  const std::size_t every = (track.path.size() + most - 1) / most;
  Trajectory trajectory{robot, period_s * static_cast<double>(std::max<std::size_t>(every, 1)), "[",
                        "["};
  for (std::size_t i = 0; i < track.path.size(); i += every) {
    const Pose& pose = track.path[i];
    append_list(trajectory.poses, pose.x, pose.y, pose.heading_rad);
  }
  for (std::size_t i = 0; i < std::min(track.touches.size(), most); ++i) {
    append_list(trajectory.touches, track.touches[i].x, track.touches[i].y);
  }
  trajectory.poses += ']';
  trajectory.touches += ']';
  return trajectory;
}

Curve curve_of(const simulation::LearningCurve& curve, std::size_t most) {
  const std::vector<elsie::Curve::Point>& all = curve.curve.points;
  const std::size_t count = std::min(all.size(), most);
  nlohmann::json points = nlohmann::json::array();
  for (std::size_t i = 0; i < count; ++i) {
    const auto& point = all[count > 1 ? i * (all.size() - 1) / (count - 1) : 0];
    points.push_back({point.x, point.y});
  }
  return {curve.robot,         curve.plugin,        curve.curve.name,
          curve.curve.x_label, curve.curve.y_label, points.dump()};
}

Timeline timeline_of(const traces::TraceRobot& robot, const traces::RobotAccount& account,
                     std::size_t most) {
  using Json = nlohmann::ordered_json;
  Json behaviors = Json::array();
  for (std::size_t i = 0; i < robot.members.size(); ++i) {
    behaviors.push_back({{"path", robot.members[i].path},
                         {"share", thousandths(account.members[i].robot_share)},
                         {"decided_s", thousandths(account.members[i].decided_s)}});
  }
  Json episodes = Json::array();
  for (const traces::Episode& episode : condensed(account.coordinators.front().episodes, most)) {
    const traces::Episode::Part& longest = episode.parts.front();
    Json shown = {{"from_s", thousandths(episode.from_s)},
                  {"to_s", thousandths(episode.to_s)},
                  {"decider", episode.parts.size() > 1 ? "*" : name_of(longest.decider, robot)},
                  {"share", thousandths(longest.share)}};
    if (episode.parts.size() > 1) {
      Json parts = Json::array();
      for (const traces::Episode::Part& part : episode.parts) {
        parts.push_back({{"decider", name_of(part.decider, robot)},
                         {"time_s", thousandths(part.time_s)},
                         {"share", thousandths(part.share)}});
      }
      shown["parts"] = std::move(parts);
    }
    episodes.push_back(std::move(shown));
  }
  return {robot.id, behaviors.dump(), episodes.dump()};
}

}  // namespace elsie::batch
