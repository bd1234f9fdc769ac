#include "elsie/recording/recorded_run.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "elsie/api/simulator_events.h"
#include "elsie/picture/bodies.h"
#include "elsie/plugin/host.h"
#include "elsie/recording/graph_json.h"
#include "elsie/traces/sampling.h"

#include "crowd.h"
#include "fields.h"
#include "format.h"
#include "reading.h"
#include "sketches.h"

namespace elsie::recording {
namespace {

double number(const Json& object, const char* name) { return object.at(name).get<double>(); }

/// Collects from the messages the data for the picture.
class Follower final : public Visitor {
 public:
  using See = std::function<void(const RecordedRun&)>;

  Follower(RecordedRun& run, double until_s, See see = {})
      : run_(run), until_s_(until_s), see_(std::move(see)) {}

  /// Shows the last sample.
  void finish() {
    if (see_ && is_unseen_) see_(run_);
  }

  void message(const mcap::Channel& channel, const mcap::Message& message) override {
    if (see_ && is_unseen_ && message.log_time_ns > seen_from_ns_) {
      see_(run_);
      is_unseen_ = false;
    }
    if (static_cast<double>(message.log_time_ns) / kSecondNs > until_s_ + 0.5 / kSecondNs) {
      return;
    }
    const auto [robot, kind] = robot_and_kind(channel);
    const auto json = [&] { return Json::parse(message.data); };
    if (kind == "state") {
      read_state(track_of(robot), json(), message.log_time_ns);
    } else if (kind == kBeliefKind) {
      read_belief(track_of(robot), json());
    } else if (kind == kSketchesKind) {
      track_of(robot).sketches = sketches_of(json());
    } else if (kind == kGraphsKind) {
      read_graphs(run_.graphs[robot], json());
    } else if (kind == kLitKind) {
      read_lights(run_.graphs[robot], json());
    } else if (channel.topic == kSketchesTopic) {
      run_.sketches = sketches_of(json());
    } else if (channel.topic == kTransformsTopic) {
      read_transforms(json());
    } else if (channel.topic == kSceneTopic) {
      read_scene(json());
    } else if (channel.topic == kEventsTopic) {
      read_event(json(), message.log_time_ns);
    } else if (channel.topic == kCrowdTopic) {
      read_crowd(json(), message.log_time_ns);
    } else if (channel.topic.starts_with(field_topic(""))) {
      picture::FloorField field = recorded_field(channel.topic, json());
      std::string id = field.id;
      run_.fields[std::move(id)] = std::move(field);
    } else if (channel.topic == kWorldTopic) {
      read_world(json());
    }
  }

 private:
  struct Memory {
    bool placed = false;               // since the last pose of the path
    std::uint64_t touched_ns = ~0ULL;  // when it last touched something
  };

  picture::RobotTrack& track_of(const std::string& robot) {
    const auto [known, is_new] = places_.try_emplace(robot, run_.robots.size());
    if (is_new) {
      run_.robots.push_back({.id = robot, .path = {}, .now = {}, .sketches = {}, .touches = {}});
    }
    return run_.robots[known->second];
  }

  /// Removes the robots that an edit removed.
  void read_world(const Json& world) {
    run_.world_xml = world.at("xml").get<std::string>();
    if (run_.start_xml.empty()) {
      run_.start_xml = world.value("start_xml", run_.world_xml);
    }
    ids_ = world.at("robots").get<std::set<std::string>>();
    run_.crowd = world.value("crowd", std::vector<std::string>());
    std::erase_if(run_.robots, [&](const auto& track) { return !ids_.contains(track.id); });
    std::erase_if(memory_, [&](const auto& known) { return !ids_.contains(known.first); });
    std::erase_if(run_.graphs, [&](const auto& known) { return !ids_.contains(known.first); });
    places_.clear();
    for (std::size_t i = 0; i < run_.robots.size(); ++i) {
      places_[run_.robots[i].id] = i;
    }
  }

  void read_state(picture::RobotTrack& track, const Json& state, std::uint64_t time_ns) {
    take_pose(track, {number(state, "x_m"), number(state, "y_m"), number(state, "heading_rad")},
              time_ns);
    track.lights.clear();
    for (const Json& light : state.value("lights", Json::array())) {
      track.lights.push_back(
          {{number(light, "x_m"), number(light, "y_m")},
           {light.at("red").get<std::uint8_t>(), light.at("green").get<std::uint8_t>(),
            light.at("blue").get<std::uint8_t>()}});
    }
  }

  static void read_graphs(RecordedGraphs& shown, const Json& message) {
    shown = {};
    for (const Json& graph : message.at("graphs")) {
      shown.graphs.push_back({graph.at("path").get<std::string>(), graph_of(graph)});
      shown.lights.emplace_back(shown.graphs.back().graph.nodes.size());
    }
  }

  static void read_lights(RecordedGraphs& shown, const Json& message) {
    const Json& all = message.at("graphs");
    if (all.size() != shown.graphs.size()) {
      throw Unexpected("it is about " + std::to_string(all.size()) + " graphs; there are " +
                       std::to_string(shown.graphs.size()));
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
      shown.lights[i] = lights_of(all[i], shown.lights[i].size());
    }
  }

  void read_crowd(const Json& message, std::uint64_t time_ns) {
    const std::vector<Pose> poses = crowd_poses(message);
    if (poses.size() != run_.crowd.size()) {
      throw Unexpected("it has " + std::to_string(poses.size()) + " points for " +
                       std::to_string(run_.crowd.size()) + " robots");
    }
    for (std::size_t i = 0; i < poses.size(); ++i) {
      take_pose(track_of(run_.crowd[i]), poses[i], time_ns);
    }
  }

  void take_pose(picture::RobotTrack& track, const Pose& pose, std::uint64_t time_ns) {
    const double time_s = static_cast<double>(time_ns) / kSecondNs;
    track.now = pose;
    run_.shown_s = time_s;
    is_unseen_ = true;
    seen_from_ns_ = time_ns;
    // The last sample of a run may be between two periods.
    if (!sampling_ && run_.period_s > 0.0) {
      sampling_.emplace(run_.period_s);
    }
    if (sampling_ && time_ns != sampled_ns_) {
      sampled_ns_ = time_ns;
      is_due_ = sampling_->is_due(time_s);
    }
    if (is_due_) {
      if (track.path.empty()) {
        track.from_s = sampling_->last_s();
      }
      if (std::exchange(memory_[track.id].placed, false)) {
        track.placed.push_back(track.path.size());
      }
      track.path.push_back(track.now);
    }
  }

  /// The pose of an upright thing.
  static Pose pose_of(const Json& message) {
    const Json& at = message.at("pose").at("position");
    const Json& turn = message.at("pose").at("orientation");
    const double heading_rad = 2.0 * std::atan2(number(turn, "z"), number(turn, "w"));
    return {number(at, "x"), number(at, "y"), heading_rad};
  }

  void read_belief(picture::RobotTrack& track, const Json& message) {
    track.believed = pose_of(message);
    // The state at the same time was read before.
    if (is_due_) track.believed_path.push_back(*track.believed);
  }

  void read_transforms(const Json& message) {
    for (picture::RobotTrack& track : run_.robots) {
      track.segments.clear();
    }
    for (const Json& transform : message.at("transforms")) {
      const std::string frame = transform.at("child_frame_id").get<std::string>();
      const Json& origin = transform.at("translation");
      const Pose pose{number(origin, "x"), number(origin, "y"), number(transform, "heading_rad")};
      if (frame.starts_with(box_frame(""))) {
        run_.moved[frame.substr(box_frame("").size())] = pose;
        continue;
      }
      // "robot/ROBOT/SEGMENT", in the order of the segments.
      const std::size_t slash = frame.rfind('/');
      if (slash != std::string::npos && slash > robot_frame("").size()) {
        const std::size_t start = robot_frame("").size();
        track_of(frame.substr(start, slash - start)).segments.push_back(pose);
      }
    }
  }

  void read_scene(const Json& scene) {
    run_.standing.clear();
    for (const Json& entity : scene.at("entities")) {
      const std::string id = entity.at("id").get<std::string>();
      if (id.starts_with(box_frame(""))) {
        const std::string box = id.substr(box_frame("").size());
        run_.standing.insert(box);
        for (const Json& fact : entity.at("metadata")) {
          if (fact.at("key") == kStart) read_start(entity, box, fact.at("value"));
        }
      }
    }
  }

  void read_start(const Json& entity, const std::string& box, const Json& text) {
    const Json place = Json::parse(text.get<std::string>());
    const Pose start{place.at(0).get<double>(), place.at(1).get<double>(),
                     place.at(2).get<double>()};
    run_.starts[box] = start;
    if (entity.at("frame_id") == kWorldFrame) run_.moved[box] = start;
  }

  void read_event(const Json& event, std::uint64_t time_ns) {
    const std::string robot = event.at("name").get<std::string>();
    const std::string name = event.at("event").get<std::string>();
    run_.events.push_back({static_cast<double>(time_ns) / kSecondNs, robot, name,
                           event.at("detail").get<std::string>(),
                           event.at("level").get<int>() >= kWarning});
    if (!ids_.contains(robot)) {
      return;
    }
    Memory& memory = memory_[robot];
    if (name == events::Collision::kFacts.name && event.contains("x_m") &&
        memory.touched_ns != time_ns) {
      memory.touched_ns = time_ns;
      track_of(robot).touches.push_back({number(event, "x_m"), number(event, "y_m")});
    } else if (const auto edit = edit_of(event); edit && !track_of(robot).path.empty()) {
      memory.placed = memory.placed || edit->moves_robot();
    }
  }

  RecordedRun& run_;
  double until_s_;
  See see_;
  bool is_unseen_ = false;                // true: there is a sample that see_ did not see
  std::uint64_t seen_from_ns_ = 0;        // its time
  std::set<std::string> ids_;             // of the robots that are present
  std::map<std::string, Memory> memory_;  // of each of them
  std::unordered_map<std::string, std::size_t> places_;  // of the tracks, by robot
  std::optional<traces::Sampling> sampling_;
  std::uint64_t sampled_ns_ = ~0ULL;  // when the last state was sampled
  bool is_due_ = false;               // true: that state belongs to the path
};

/// Draws a run as it was. The world of the view lives as long as the call.
template <class Draw>
auto with_view(const RecordedRun& run, const plugin::Host& drives,
               const std::vector<std::string>& subtitles, const Draw& draw) {
  world::World world = picture::bodies_of(run.world_xml, run.world_file, drives);
  for (world::Obstacle& box : world.obstacles) {
    const auto start = run.starts.find(box.id);
    if (start == run.starts.end()) continue;
    box.x = start->second.x;
    box.y = start->second.y;
    box.heading_deg = degrees(start->second.heading_rad);
  }
  picture::TopView view{world};
  view.robots = run.robots;
  view.sketches = run.sketches;
  // A recording has the robots by name; a picture colours them in the order of the world.
  std::unordered_map<std::string_view, std::size_t> places;
  for (std::size_t i = 0; i < world.robots.size(); ++i) {
    places.emplace(world.robots[i].id, i);
  }
  const auto place = [&](const auto& track) {
    const auto known = places.find(track.id);
    return known == places.end() ? world.robots.size() : known->second;
  };
  std::stable_sort(view.robots.begin(), view.robots.end(),
                   [&](const auto& a, const auto& b) { return place(a) < place(b); });
  for (const world::Obstacle& box : world.obstacles) {
    const auto moved = run.moved.find(box.id);
    const bool gone = !run.standing.contains(box.id);
    view.boxes.push_back(gone                       ? std::nullopt
                         : moved != run.moved.end() ? std::optional(moved->second)
                                                    : std::optional(picture::start_of(box)));
  }
  for (const world::ScalarField& field : world.fields) {
    const auto recorded = run.fields.find(field.id);
    if (recorded == run.fields.end()) continue;
    view.fields.push_back(recorded->second);
    view.fields.back().colour = field.colour;
    view.fields.back().full = field.full;
  }
  view.subtitles = subtitles;
  view.path_period_s = run.period_s;
  return draw(view);
}

}  // namespace

RecordedRun read_recorded_run(const std::filesystem::path& file, double until_s) {
  RecordedRun run;
  Follower follower(run, until_s);
  read_file(file, run, follower);
  return run;
}

RecordedRun watch_recorded_run(const std::filesystem::path& file,
                               const std::function<void(const RecordedRun&)>& see) {
  RecordedRun run;
  Follower follower(run, std::numeric_limits<double>::infinity(), see);
  read_file(file, run, follower);
  follower.finish();
  return run;
}

void save_picture(const RecordedRun& run, const plugin::Host& drives,
                  const std::vector<std::string>& subtitles, const std::filesystem::path& file,
                  const picture::Size& size) {
  with_view(run, drives, subtitles,
            [&](const auto& view) { picture::save_top_view(view, file, size); });
}

std::string picture_svg(const RecordedRun& run, const plugin::Host& drives,
                        const std::vector<std::string>& subtitles, const picture::Size& size) {
  return with_view(run, drives, subtitles,
                   [&](const auto& view) { return picture::top_view_svg(view, size); });
}

}  // namespace elsie::recording
