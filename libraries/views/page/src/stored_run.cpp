#include "elsie/page/stored_run.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <stdexcept>
#include <string_view>

#include <nlohmann/json.hpp>

#include "elsie/api/simulator_events.h"
#include "elsie/files/clean_text.h"
#include "elsie/picture/bodies.h"
#include "elsie/picture/svg.h"
#include "elsie/picture/timeline.h"
#include "elsie/picture/top_view.h"
#include "elsie/traces/trace.h"
#include "elsie/traces/trace_account.h"
#include "elsie/world/parts.h"
#include "elsie/world/tree.h"

#include "film.h"

namespace elsie::page {
namespace {

using recording::RecordedEvent;
using recording::RecordedRun;

constexpr double kHair_s = 1e-6;
constexpr double kMostSamples = 20'000;
constexpr double kLong_s = 1e9;  // longer than any run
/// A folder that does not exist. Images of floors are not searched on the disk: what a page shows
/// depends on the run alone.
const std::filesystem::path kNowhere = "a database";

/// A pose in the frame of another one, and back.
Pose relative(const Pose& frame, const Pose& pose) {
  const double c = std::cos(frame.heading_rad), s = std::sin(frame.heading_rad);
  const double dx = pose.x - frame.x, dy = pose.y - frame.y;
  return {c * dx + s * dy, c * dy - s * dx, wrap_angle(pose.heading_rad - frame.heading_rad)};
}
Pose absolute(const Pose& frame, const Pose& pose) {
  const Vector2 at = point_of(frame, {pose.x, pose.y});
  return {at.x, at.y, wrap_angle(frame.heading_rad + pose.heading_rad)};
}

/// Where a robot is at any time.
class Way {
 public:
  Way(const StoredRobot& robot, double end_s, const std::vector<RecordedEvent>& events)
      : robot_(robot) {
    for (std::size_t i = 0; i < robot.poses.size(); ++i) {
      const bool is_end = robot.has_end && i + 1 == robot.poses.size();
      times_.push_back(is_end ? std::max(end_s, times_.empty() ? 0.0 : times_.back())
                              : robot.from_s + static_cast<double>(i) * robot.period_s);
    }
    // Without a pose at the end of the run it was taken out some time after its last one.
    to_s_ = times_.back() + (robot.has_end ? 0.0 : robot.period_s);
    for (const RecordedEvent& event : events) {
      if (event.robot != robot.id || event.name != events::Changed::kFacts.name) continue;
      const std::string path = event.detail.substr(0, event.detail.find('='));
      if (events::Changed::of(path, "").moves_robot()) placed_s_.push_back(event.time_s);
    }
  }

  double last_s() const { return times_.back(); }
  bool is_there(double time_s) const {
    return time_s > times_.front() - kHair_s &&
           time_s < to_s_ + (robot_.has_end ? kHair_s : -kHair_s);
  }
  /// How often it was put somewhere until then.
  std::size_t times_placed(double time_s) const {
    return static_cast<std::size_t>(
        std::upper_bound(placed_s_.begin(), placed_s_.end(), time_s + kHair_s) - placed_s_.begin());
  }

  Pose at(double time_s) const {
    const auto after = std::upper_bound(times_.begin(), times_.end(), time_s + kHair_s);
    const auto next = static_cast<std::size_t>(after - times_.begin());
    const std::size_t i = next > 0 ? next - 1 : 0;
    const Pose& from = robot_.poses[i];
    if (next == robot_.poses.size() || next == 0 || time_s <= times_[i]) return from;
    const Pose& to = robot_.poses[next];
    if (times_placed(times_[next]) != times_placed(times_[i])) {
      return times_placed(time_s) != times_placed(times_[i]) ? to : from;
    }
    const double part = (time_s - times_[i]) / (times_[next] - times_[i]);
    return {from.x + part * (to.x - from.x), from.y + part * (to.y - from.y),
            wrap_angle(from.heading_rad + part * wrap_angle(to.heading_rad - from.heading_rad))};
  }

 private:
  const StoredRobot& robot_;
  std::vector<double> times_;     // of its poses
  std::vector<double> placed_s_;  // when it was put elsewhere, ascending
  double to_s_ = 0.0;
};

/// Plays a stored run as a recording is played: state by state.
class Player {
 public:
  Player(const StoredRun& stored, const plugin::Host& drives)
      : stored_(stored), world_(picture::bodies_of(stored.world_xml, stored.world_file, drives)) {
    double every_s = std::numeric_limits<double>::infinity();
    for (const StoredRobot& robot : stored.robots) {
      if (!has_poses(robot)) continue;
      robots_.push_back(&robot);
      ways_.emplace_back(robot, stored.end_s < kLong_s ? stored.end_s : 0.0, stored.events);
      every_s = std::min(every_s, robot.period_s);
      end_s_ = std::max(end_s_, ways_.back().last_s());
    }
    if (ways_.empty()) throw std::invalid_argument("the run has no robot with poses");
    run_.of_elsie = true;
    run_.library = stored.library;
    run_.world = world_.name;
    run_.world_file = world_file_.string();
    run_.world_xml = stored.world_xml;
    run_.seed = stored.seed;
    run_.period_s = std::max(every_s, end_s_ / kMostSamples);
    run_.result = stored.result;
    run_.end_s = end_s_;
    if (run_.result->simulated_s <= 0.0) run_.result->simulated_s = end_s_;
    for (const world::Obstacle& box : world_.obstacles) {
      run_.standing.insert(box.id);
      boxes_[box.id] = picture::start_of(box);
    }
    for (const world::Robot& robot : world_.robots) plans_[robot.id] = world::plan_of(robot);
  }

  /// Calls `see` with each state; returns the run at its end.
  template <class See>
  const RecordedRun& play(See see) {
    std::vector<picture::RobotTrack> tracks(ways_.size());
    for (std::size_t i = 0; i < ways_.size(); ++i) tracks[i].id = robots_[i]->id;
    bool is_last = false;
    for (std::size_t k = 0; !is_last; ++k) {
      const double time_s = std::min(static_cast<double>(k) * run_.period_s, end_s_);
      is_last = time_s > end_s_ - kHair_s;
      run_.shown_s = time_s;
      take_events(time_s, tracks);
      run_.robots.clear();
      for (std::size_t i = 0; i < ways_.size(); ++i) {
        if (ways_[i].is_there(time_s)) run_.robots.push_back(at(i, time_s, tracks[i]));
      }
      for (const auto& [id, held] : held_) {
        run_.moved[id] = absolute(pose_of(held.first, time_s), held.second);
      }
      see(run_);
    }
    run_.events = stored_.events;
    run_.robots = std::move(tracks);
    return run_;
  }

  /// What the run does not show, in sentences.
  std::string missing() const {
    std::string text = "the batch kept the robots' poses, events and who decided";
    const auto& boxes = world_.obstacles;
    if (std::any_of(boxes.begin(), boxes.end(), [](const world::Obstacle& box) {
          return box.is_dynamic() || box.kind == world::ObstacleKind::moving;
        })) {
      text += "; boxes that move stand where they began, unless a robot holds them";
    }
    if (std::any_of(world_.robots.begin(), world_.robots.end(),
                    [](const world::Robot& robot) { return !robot.segments.empty(); })) {
      text += "; segments are in line behind their robots";
    }
    const world::Element root = world::tree_of_world(stored_.world_xml, world_file_.string());
    if (const world::Element* floor = root.child("floor"); floor && floor->find("image")) {
      text += "; the floor is without its image";
    }
    if (std::any_of(stored_.events.begin(), stored_.events.end(), [](const RecordedEvent& event) {
          return event.name == events::Changed::kFacts.name;
        })) {
      text += "; the world is that of the start, without its edits";
    }
    return text;
  }

 private:
  Pose pose_of(std::size_t robot, double time_s) const { return ways_[robot].at(time_s); }

  /// The state of a robot, which also goes on in its path.
  picture::RobotTrack at(std::size_t i, double time_s, picture::RobotTrack& track) {
    picture::RobotTrack state;
    state.id = track.id;
    state.now = track.now = pose_of(i, time_s);
    if (!is_finite(state.now)) return state;
    if (track.path.empty()) track.from_s = time_s;
    const std::size_t placed = ways_[i].times_placed(time_s);
    while (track.placed.size() < placed) track.placed.push_back(track.path.size());
    state.placed = track.placed;
    track.path.push_back(state.now);
    if (const auto plan = plans_.find(state.id); plan != plans_.end()) {
      const std::vector<Frame> frames = world::in_line(plan->second);
      for (std::size_t k = 1; k < frames.size(); ++k) {
        const Vector2 place = point_of(state.now, {frames[k].origin.x, frames[k].origin.y});
        state.segments.push_back({place.x, place.y, state.now.heading_rad});
      }
      track.segments = state.segments;
    }
    return state;
  }

  void take_events(double time_s, std::vector<picture::RobotTrack>& tracks) {
    for (; next_event_ < stored_.events.size() &&
           stored_.events[next_event_].time_s <= time_s + kHair_s;
         ++next_event_) {
      take(stored_.events[next_event_], tracks);
    }
  }

  void take(const RecordedEvent& event, std::vector<picture::RobotTrack>& tracks) {
    const std::string& thing = event.detail;
    if (event.name == events::Collected::kFacts.name ||
        event.name == events::Delivered::kFacts.name) {
      run_.standing.erase(thing);
      held_.erase(thing);
      return;
    }
    const auto known = std::find_if(robots_.begin(), robots_.end(), [&](const StoredRobot* robot) {
      return robot->id == event.robot;
    });
    if (known == robots_.end()) return;
    const auto robot = static_cast<std::size_t>(known - robots_.begin());
    const Pose pose = pose_of(robot, event.time_s);
    if (!is_finite(pose)) return;
    if (event.name == events::Collision::kFacts.name) {
      tracks[robot].touches.push_back({pose.x, pose.y});
    } else if (event.name == events::Taken::kFacts.name && boxes_.contains(thing)) {
      held_[thing] = {robot, relative(pose, boxes_[thing])};
    } else if (event.name == events::Released::kFacts.name) {
      const auto held = held_.find(thing);
      if (held == held_.end() || held->second.first != robot) return;
      run_.moved[thing] = boxes_[thing] = absolute(pose, held->second.second);
      held_.erase(held);
    }
  }

  const StoredRun& stored_;
  const std::filesystem::path world_file_;
  const world::World world_;
  std::vector<const StoredRobot*> robots_;
  std::vector<Way> ways_;
  std::map<std::string, BodyPlan> plans_;
  std::map<std::string, Pose> boxes_;  // where they stood last
  /// Boxes in robots' hands: whose, and where in the robot's frame.
  std::map<std::string, std::pair<std::size_t, Pose>> held_;
  std::size_t next_event_ = 0;
  double end_s_ = 0.0;
  RecordedRun run_;
};

/// Who decided, by episodes: the part of each in which a behaviour did, in place of its share in
/// the command.
class Episodes final : public Layer {
 public:
  explicit Episodes(const StoredRun& run) : run_(run) {
    for (const StoredRobot& robot : run.robots) {
      traces::TraceRobot& traced = trace_.robots.emplace_back();
      for (const std::string& path : robot.behaviors) traced.members.emplace_back().path = path;
    }
    colours_ = picture::behavior_colours(trace_);
  }

  std::string text() const override {
    std::string out = "\"reasons\":[\"\"],\"numbers\":[],\"decisions\":[";
    char separator = ' ';
    for (const StoredRobot& robot : run_.robots) {
      if (robot.episodes.empty()) continue;
      (out += std::exchange(separator, ',')) += robot_text(robot);
    }
    return out += ']';
  }
  bool thin() override { return false; }

 private:
  std::string robot_text(const StoredRobot& robot) const {
    nlohmann::json members = nlohmann::json::array();
    for (const std::string& path : robot.behaviors) {
      members.push_back({{"path", files::one_line(path)},
                         {"plugin", ""},
                         {"depth", std::count(path.begin(), path.end(), '/')},
                         {"colour", picture::hex_text(colours_.at(path))}});
    }
    const auto place = [&](const std::string& path) {
      const auto found = std::find(robot.behaviors.begin(), robot.behaviors.end(), path);
      return found == robot.behaviors.end() ? std::int64_t{traces::kNobody}
                                            : found - robot.behaviors.begin();
    };
    constexpr double kPercent = 100.0;
    std::vector<std::int64_t> times, deciders;
    std::vector<std::vector<std::int64_t>> parts(robot.behaviors.size());
    for (const StoredRobot::Episode& episode : robot.episodes) {
      times.push_back(fine(episode.from_s));
      deciders.push_back(episode.decider == "*" ? traces::kTogether : place(episode.decider));
      std::map<std::int64_t, double> seconds;
      double whole = 0.0;
      for (const auto& [path, time_s] : episode.parts) {
        seconds[place(path)] += time_s;
        whole += time_s;
      }
      for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto member = static_cast<std::int64_t>(i);
        const double part = whole > 0.0                 ? seconds[member] / whole
                            : deciders.back() == member ? 1.0
                                                        : 0.0;
        parts[i].push_back(std::llround(kPercent * part));
      }
    }
    std::string out = "{\"robot\":" + nlohmann::json(files::one_line(robot.id)).dump() +
                      ",\"from\":" + std::to_string(fine(robot.episodes.front().from_s)) +
                      ",\"to\":" + std::to_string(fine(robot.episodes.back().to_s)) +
                      ",\"of\":\"time\",\"members\":" + members.dump() +
                      ",\"bands\":[{\"parent\":-1,\"coordinator\":\"\",\"t\":";
    append_differences(out, times);
    append_list(out += ",\"who\":", deciders);
    append_list(out += ",\"why\":", std::vector<int>(times.size(), 0));
    append_differences(out += "}],\"t\":", times);
    out += ",\"shares\":[";
    for (std::size_t i = 0; i < parts.size(); ++i) {
      append_differences(out += i > 0 ? "," : "", parts[i]);
    }
    return out += "]}";
  }

  const StoredRun& run_;
  traces::Trace trace_;
  std::map<std::string, Colour> colours_;
};

}  // namespace

bool has_poses(const StoredRobot& robot) {
  return robot.period_s > kHair_s && robot.period_s < kLong_s && std::abs(robot.from_s) < kLong_s &&
         std::any_of(robot.poses.begin(), robot.poses.end(), is_finite);
}

PageRun page_run(const StoredRun& stored, const plugin::Host& drives, const PageOptions& options) {
  Player player(stored, drives);
  Film film(drives);
  const RecordedRun& run = player.play([&](const RecordedRun& state) { film.add(state); });
  Episodes episodes(stored);
  Film::Facts facts = stored.facts;
  facts.insert(facts.end(), {{"done by", run.library}, {"kept", player.missing()}});
  constexpr std::size_t kFacts = 4096;  // about as many bytes
  PageRun shown = film.page_run(run, run.end_s, {&episodes}, "1 mm and 0.001 rad", facts,
                                options.most_bytes - std::min(kFacts, options.most_bytes));
  if (!stored.title.empty()) shown.title = escaped(stored.title);
  return shown;
}

}  // namespace elsie::page
