#include "run_texts.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "elsie/base/number_text.h"
#include "elsie/files/rounded.h"

namespace elsie::batch {
namespace {

double thousandths(double value) { return files::rounded(value, 3); }

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

void append_episodes(nlohmann::ordered_json& episodes, const traces::TraceRobot& robot,
                     const traces::RobotAccount& account, std::size_t most) {
  using Ordered = nlohmann::ordered_json;
  for (const traces::Episode& episode : condensed(account.coordinators.front().episodes, most)) {
    const traces::Episode::Part& longest = episode.parts.front();
    Ordered shown = {{"from_s", thousandths(episode.from_s)},
                     {"to_s", thousandths(episode.to_s)},
                     {"decider", episode.parts.size() > 1 ? "*" : name_of(longest.decider, robot)},
                     {"share", thousandths(longest.share)}};
    if (episode.parts.size() > 1) {
      Ordered parts = Ordered::array();
      for (const traces::Episode::Part& part : episode.parts) {
        parts.push_back({{"decider", name_of(part.decider, robot)},
                         {"time_s", thousandths(part.time_s)},
                         {"share", thousandths(part.share)}});
      }
      shown["parts"] = std::move(parts);
    }
    episodes.push_back(std::move(shown));
  }
}

}  // namespace

Trajectory trajectory_of(const std::string& robot, const traces::Track& track, double period_s,
                         std::size_t most) {
  const std::size_t every = (track.path.size() + most - 1) / most;
  Trajectory trajectory{robot, track.from_s,
                        period_s * static_cast<double>(std::max<std::size_t>(every, 1)), "[", "["};
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

std::vector<Timeline> timelines_of(const traces::AccountRecorder& recorder, std::size_t most) {
  using Ordered = nlohmann::ordered_json;
  struct Sum {
    double share_s = 0.0, decided_s = 0.0;
  };
  struct Parts {
    std::string robot;
    double length_s = 0.0;
    std::vector<std::pair<std::string, Sum>> behaviors{};
    Ordered episodes = Ordered::array();
  };
  std::vector<Parts> all;
  for (std::size_t r = 0; r < recorder.accounts().size(); ++r) {
    const traces::TraceRobot& robot = recorder.robots()[r];
    const traces::RobotAccount& account = recorder.accounts()[r];
    auto known = std::find_if(all.begin(), all.end(),
                              [&](const Parts& parts) { return parts.robot == robot.id; });
    Parts& parts = known == all.end() ? all.emplace_back(Parts{robot.id}) : *known;
    const double length_s = account.span.to_s - account.span.from_s;
    parts.length_s += length_s;
    for (std::size_t i = 0; i < robot.members.size(); ++i) {
      const std::string& path = robot.members[i].path;
      auto sum = std::find_if(parts.behaviors.begin(), parts.behaviors.end(),
                              [&](const auto& entry) { return entry.first == path; });
      if (sum == parts.behaviors.end()) {
        sum = parts.behaviors.insert(sum, {path, {}});
      }
      sum->second.share_s += account.members[i].robot_share * length_s;
      sum->second.decided_s += account.members[i].decided_s;
    }
    append_episodes(parts.episodes, robot, account, most);
  }
  std::vector<Timeline> timelines;
  for (const Parts& parts : all) {
    Ordered behaviors = Ordered::array();
    for (const auto& [path, sum] : parts.behaviors) {
      const double share = parts.length_s > 0.0 ? sum.share_s / parts.length_s : 0.0;
      behaviors.push_back({{"path", path},
                           {"share", thousandths(share)},
                           {"decided_s", thousandths(sum.decided_s)}});
    }
    timelines.push_back({parts.robot, behaviors.dump(), parts.episodes.dump()});
  }
  return timelines;
}

}  // namespace elsie::batch
