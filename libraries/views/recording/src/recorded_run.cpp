#include "elsie/recording/recorded_run.h"

#include <charconv>
#include <cmath>
#include <functional>
#include <utility>

#include "elsie/api/simulator_events.h"
#include "elsie/mcap/reader.h"
#include "elsie/plugin/host.h"
#include "elsie/world/reader.h"

#include "format.h"
#include "messages.h"
#include "scene.h"

namespace elsie::recording {
namespace {

constexpr double kNanosecond = 1e-9;

/// A number in metadata; zero when it is none.
template <class Number>
Number number(const std::map<std::string, std::string>& values, const char* name) {
  Number value{};
  if (const auto at = values.find(name); at != values.end()) {
    std::from_chars(at->second.data(), at->second.data() + at->second.size(), value);
  }
  return value;
}

std::string text(const std::map<std::string, std::string>& values, const char* name) {
  const auto at = values.find(name);
  return at == values.end() ? "" : at->second;
}

double number(const Json& object, const char* name) { return object.at(name).get<double>(); }

/// Goes through the messages and notes what the picture needs.
class Follower {
 public:
  explicit Follower(RecordedRun& run) : run_(run) {}

  /// Metadata is in front of what it is about.
  void read(const mcap::Metadata& metadata) {
    const auto& values = metadata.values;
    if (metadata.name == kRunMetadata) {
      run_.of_elsie = true;
      run_.world = text(values, "world");
      run_.world_file = text(values, "file");
      run_.seed = number<std::uint64_t>(values, "seed");
      run_.time_limit_s = number<double>(values, "time_limit_s");
      run_.step_s = number<double>(values, "step_s");
      sample_steps_ = number<std::uint64_t>(values, "sample_steps");
      run_.period_s = run_.step_s * static_cast<double>(sample_steps_);
    } else if (metadata.name == kResultMetadata) {
      run_.result = RecordedResult{text(values, "outcome"),
                                   text(values, "reason"),
                                   number<double>(values, "simulated_s"),
                                   number<std::uint64_t>(values, "steps"),
                                   text(values, "state_hash"),
                                   {}};
    } else if (metadata.name == kMeasuresMetadata && run_.result) {
      for (const auto& [name, value] : values) {
        run_.result->measures[name] = number<double>(values, name.c_str());
      }
    }
  }

  /// A message until the time asked for. Throws Json::exception when it is not as expected.
  void read(const mcap::Channel& channel, const mcap::Message& message) {
    const auto [robot, kind] = parts_of(channel);
    const auto json = [&] { return Json::parse(message.data); };
    if (kind == "state") {
      read_state(track_of(robot), json(), message.log_time_ns);
    } else if (kind == "beams") {
      read_beams(track_of(robot), json());
    } else if (channel.topic == kTransformsTopic) {
      read_transforms(json());
    } else if (channel.topic == kSceneTopic) {
      read_scene(json());
    } else if (channel.topic == kEventsTopic) {
      read_event(json(), message.log_time_ns);
    } else if (channel.topic == kWorldTopic) {
      run_.world_xml = json().at("xml").get<std::string>();
    }
  }

 private:
  struct Memory {
    bool placed = false;               // since the last pose of the path
    std::uint64_t touched_ns = ~0ULL;  // when it last touched something
  };

  /// Robot and kind of a channel "/robots/ROBOT/KIND"; empty for others.
  static std::pair<std::string, std::string> parts_of(const mcap::Channel& channel) {
    const auto robot = channel.metadata.find("robot");
    if (robot == channel.metadata.end()) {
      return {};
    }
    const std::string start = robot_topic(robot->second, "");
    return channel.topic.starts_with(start)
               ? std::pair(robot->second, channel.topic.substr(start.size()))
               : std::pair<std::string, std::string>();
  }

  picture::RobotTrack& track_of(const std::string& robot) {
    for (picture::RobotTrack& track : run_.robots) {
      if (track.id == robot) {
        return track;
      }
    }
    run_.robots.push_back({.id = robot, .path = {}, .now = {}, .beams = {}, .touches = {}});
    return run_.robots.back();
  }

  void read_state(picture::RobotTrack& track, const Json& state, std::uint64_t time_ns) {
    const double time_s = static_cast<double>(time_ns) * kNanosecond;
    track.now = {number(state, "x_m"), number(state, "y_m"), number(state, "heading_rad")};
    run_.shown_s = time_s;
    // The last sample of a run may be between two periods.
    const double steps = std::round(time_s / run_.step_s);
    if (sample_steps_ > 0 && std::fmod(steps, static_cast<double>(sample_steps_)) == 0.0) {
      if (std::exchange(memory_[track.id].placed, false)) {
        track.placed.push_back(track.path.size());
      }
      track.path.push_back(track.now);
    }
  }

  static void read_beams(picture::RobotTrack& track, const Json& scene) {
    const Json& entity = scene.at("entities").at(0);
    const std::string hits = entity.at("metadata").at(0).at("value").get<std::string>();
    std::size_t next[2] = {0, 0};  // point, of those that are free and of those that hit
    track.beams.clear();
    for (const char digit : hits) {
      const bool hit = digit == '1';
      const Json& points = entity.at("lines").at(hit ? 1 : 0).at("points");
      const auto take = [&] {
        const Json& point = points.at(next[hit]++);
        return Vector2{number(point, "x"), number(point, "y")};
      };
      const Vector2 from = take();
      track.beams.push_back({from, take(), hit});
    }
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
      // "robot/ROBOT/SEGMENT", in their order.
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
        run_.standing.insert(id.substr(box_frame("").size()));
      }
    }
  }

  void read_event(const Json& event, std::uint64_t time_ns) {
    const std::string robot = event.at("name").get<std::string>();
    const std::string name = event.at("event").get<std::string>();
    Memory& memory = memory_[robot];
    if (name == events::Collision::kFacts.name && event.contains("x_m") &&
        memory.touched_ns != time_ns) {
      memory.touched_ns = time_ns;
      track_of(robot).touches.push_back({number(event, "x_m"), number(event, "y_m")});
    } else if (name == events::Changed::kFacts.name && !track_of(robot).path.empty()) {
      const auto changed = events::Changed::from(event.at("detail").get<std::string>());
      memory.placed = memory.placed || (changed && changed->moves_robot());
    }
  }

  RecordedRun& run_;
  std::uint64_t sample_steps_ = 0;
  std::map<std::string, Memory> memory_;  // of each robot
};

}  // namespace

RecordedRun read_recorded_run(const std::filesystem::path& file, double until_s) {
  RecordedRun run;
  mcap::Reader reader(file);
  Follower follower(run);
  std::map<std::uint16_t, std::uint64_t> counts;
  std::size_t metadata = 0;
  const auto read_metadata = [&] {
    for (; metadata < reader.metadata().size(); ++metadata) {
      follower.read(reader.metadata()[metadata]);
    }
  };
  while (const auto message = reader.next()) {
    read_metadata();
    ++run.messages;
    ++counts[message->channel];
    const double time_s = static_cast<double>(message->log_time_ns) * kNanosecond;
    run.end_s = std::max(run.end_s, time_s);
    if (!run.of_elsie || time_s > until_s + 0.5 * kNanosecond) {
      continue;
    }
    const mcap::Channel& channel = reader.channels().at(message->channel);
    try {
      follower.read(channel, *message);
    } catch (const Json::exception& error) {
      throw mcap::McapError("recording '" + file.string() + "': a message on " + channel.topic +
                            " at " + std::to_string(time_s) +
                            " s is not as Elsie writes it: " + error.what());
    }
  }
  read_metadata();
  run.library = reader.header().library;
  for (const auto& [id, channel] : reader.channels()) {
    const auto schema = reader.schemas().find(channel.schema);
    run.channels.push_back(
        {channel.topic, schema == reader.schemas().end() ? "" : schema->second.name, counts[id]});
  }
  run.missing_end = reader.missing_end();
  return run;
}

void save_picture(const RecordedRun& run, const std::vector<std::string>& subtitles,
                  const std::filesystem::path& file, const picture::Size& size) {
  const plugin::Host none;
  world::ReadOptions options;
  options.bodies_only = true;
  const world::World world = world::parse_world(run.world_xml, run.world_file, none, options);
  picture::TopView view{world};
  view.robots = run.robots;
  for (const world::Box& box : world.boxes) {
    const auto moved = run.moved.find(box.id);
    const bool gone = !run.standing.contains(box.id);
    view.boxes.push_back(gone ? std::nullopt
                         : moved != run.moved.end()
                             ? std::optional(moved->second)
                             : std::optional(Pose{box.x, box.y, radians(box.heading_deg)}));
  }
  view.subtitles = subtitles;
  view.path_period_s = run.period_s;
  picture::save_top_view(view, file, size);
}

}  // namespace elsie::recording
