#include "elsie/recording/run_messages.h"

#include <algorithm>
#include <exception>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

#include "elsie/picture/top_view.h"
#include "elsie/recording/sensor_pictures.h"
#include "elsie/simulation/fault.h"
#include "elsie/simulation/simulation.h"
#include "elsie/traces/sampling.h"

#include "crowd.h"
#include "fields.h"
#include "format.h"
#include "messages.h"
#include "published.h"
#include "readings.h"
#include "robot_channels.h"
#include "scene.h"
#include "sketches.h"

namespace elsie::recording {

using simulation::RobotView;
using simulation::Simulation;

class RunMessages::Impl {
 public:
  Impl(MessageSink& sink, RecorderOptions options)
      : options_(std::move(options)),
        chosen_(options_.robots.begin(), options_.robots.end()),
        out_(sink) {}

  void begin(const Simulation& simulation) {
    add_channels(simulation);
    write_world(simulation);
    write_scene(simulation);
    write_events(simulation);
    find_graphs(simulation);
    remember_who_sees(simulation);
  }

  void step(const Simulation& simulation) {
    if (simulation.decided()) {
      decided_ns_ = nanoseconds(simulation.step_began_s());
      blind_ = empty_;
      new_pictures_ = true;
      write_traces(simulation);
      write_heard(simulation);
      for (RobotChannels& channels : robots_) {
        if (channels.graph_news.has_graphs()) write_graphs(simulation, channels, decided_ns_);
      }
    }
    write_events(simulation);
    if (out_.wants(scene_) && has_other_boxes(simulation)) write_scene(simulation);
    remember_who_sees(simulation);
  }

  void sample(const Simulation& simulation, bool decided, double period_s) {
    sampled_ = simulation.steps();
    if (field_sampling_.is_due(simulation.time_s())) write_fields(simulation);
    write_state(simulation, decided, new_pictures_, period_s);
    new_pictures_ = new_pictures_ && !decided;
  }

  void replace(const Simulation& simulation) {
    add_robots(simulation);
    write_world(simulation);
    write_scene(simulation);
    write_events(simulation);
    find_graphs(simulation);
    remember_who_sees(simulation);
  }

  void end(const Simulation& simulation, bool decided, double period_s) {
    write_events(simulation);
    if (sampled_ != simulation.steps()) sample(simulation, decided, period_s);
    if (fields_written_ != simulation.steps()) write_fields(simulation);
  }

  void repeat(const Simulation& simulation, double period_s) {
    constexpr std::size_t kMostEvents = 1000;
    const bool decided = simulation.steps() > 0;
    write_world(simulation);
    write_scene(simulation);
    const std::size_t events = simulation.events().size();
    for (std::size_t i = events - std::min(events, kMostEvents); i < events; ++i) {
      write_event(simulation, simulation.events()[i]);
    }
    for (RobotChannels& channels : robots_) {
      const RobotView robot = simulation.robot(channels.place);
      if (decided) write_trace(channels, robot);
      GraphNews all;
      put_graphs(simulation, channels, all, decided ? decided_ns_ : now(simulation));
      // What is compared with next: decisions that nobody wanted were not remembered.
      if (decided) channels.rows.changed(robot);
      channels.graph_news = std::move(all);
    }
    write_fields(simulation);
    write_state(simulation, decided, decided, period_s);
  }

  void follow(const Simulation& simulation, double decided_s) {
    decided_ns_ = nanoseconds(decided_s);
    add_robots(simulation);
    seen_events_ = simulation.events().size();
    find_graphs(simulation);
    remember_who_sees(simulation);
    blind_ = empty_;
    new_pictures_ = false;
    field_sampling_ = traces::Sampling(field_sampling_.period_s());
    field_sampling_.is_due(simulation.time_s());
  }

  void resume(const Simulation& simulation, double decided_s, double period_s) {
    follow(simulation, decided_s);
    sampled_ = simulation.steps();
    repeat(simulation, period_s);
  }

  double decided_s() const { return static_cast<double>(decided_ns_) * 1e-9; }

 private:
  static std::uint64_t now(const Simulation& simulation) {
    return nanoseconds(simulation.time_s());
  }

  void add_channels(const Simulation& simulation) {
    world_ = channels_.add(kWorldTopic, channels_.schema("elsie.World"));
    scene_ = channels_.add(kSceneTopic, channels_.schema("foxglove.SceneUpdate"));
    transforms_ = channels_.add(kTransformsTopic, channels_.schema("foxglove.FrameTransforms"));
    events_ = channels_.add(kEventsTopic, channels_.schema("foxglove.Log"));
    const std::string title = "elsie.Published";
    if (const auto text = published_schema(title, published_of_measures(simulation));
        !text.empty()) {
      published_ = channels_.add(kPublishedTopic, channels_.schema(title, text));
    }
    add_robots(simulation);
  }

  /// The given robots have channels of their own, or as many as a viewer can list.
  bool has_channels(const std::string& robot) const {
    return chosen_.empty() ? robots_.size() < kMostWithChannels : chosen_.contains(robot);
  }

  void add_robots(const Simulation& simulation) {
    std::map<std::string, RobotChannels> before;  // by kind
    for (RobotChannels& channels : std::exchange(robots_, {})) {
      std::string kind = channels.kind;
      before.emplace(std::move(kind), std::move(channels));
    }
    places_.clear();
    crowd_.clear();
    for (std::size_t r = 0; r < simulation.robots(); ++r) {
      const world::Robot& robot = *simulation.robot(r).description;
      places_.emplace(robot.id, r);
      if (!has_channels(robot.id)) {
        crowd_.push_back(r);
        continue;
      }
      if (const auto known = before.find(kind_of(simulation, r)); known != before.end()) {
        robots_.push_back(std::move(known->second));
        robots_.back().place = r;
        before.erase(known);
        continue;
      }
      robots_.push_back(robot_channels(channels_, simulation, r, options_.images));
    }
    has_cameras_ = std::any_of(robots_.begin(), robots_.end(),
                               [](const RobotChannels& each) { return !each.cameras.empty(); });
    for (const auto& [kind, channels] : before) {
      for (const std::uint32_t id : ids_of(channels)) out_.remove_channel(id);
    }
    if (!crowd_.empty() && crowd_channel_ == 0) {
      crowd_channel_ = channels_.add(kCrowdTopic, channels_.schema("foxglove.PointCloud"));
    }
  }

  /// `make` gives the message or its text; it is only called if someone wants the message.
  template <class Make>
  void write(std::uint32_t channel, std::uint64_t time_ns, const Make& make) {
    if (!out_.wants(channel)) return;
    if constexpr (std::is_same_v<decltype(make()), Json>) {
      out_.write(channel, time_ns, text_of(make()));
    } else {
      out_.write(channel, time_ns, make());
    }
  }

  void write_world(const Simulation& simulation) {
    write(world_, now(simulation),
          [&] { return world_text(simulation, options_.program, crowd_); });
  }

  /// Places of the robots that a viewer shows as bodies.
  std::vector<std::size_t> places_seen() const {
    std::vector<std::size_t> places;
    for (const RobotChannels& channels : robots_) {
      places.push_back(channels.place);
    }
    return places;
  }

  /// What a scene says of a box: whether it is there, and where it began.
  static std::optional<Pose> shown_box(const Simulation& simulation, std::size_t index) {
    if (!simulation.obstacle(index)) return std::nullopt;
    return picture::start_of(simulation.world().obstacles[index]);
  }
  bool has_other_boxes(const Simulation& simulation) const {
    if (shown_.size() != simulation.world().obstacles.size()) return true;
    for (std::size_t i = 0; i < shown_.size(); ++i) {
      if (shown_box(simulation, i) != shown_[i]) return true;
    }
    return false;
  }

  void write_scene(const Simulation& simulation) {
    shown_.clear();
    for (std::size_t i = 0; i < simulation.world().obstacles.size(); ++i) {
      shown_.push_back(shown_box(simulation, i));
    }
    write(scene_, now(simulation),
          [&] { return scene_message(now(simulation), simulation, places_seen()); });
  }

  void write_events(const Simulation& simulation) {
    const auto events = simulation.events();
    for (; seen_events_ < events.size(); ++seen_events_) {
      write_event(simulation, events[seen_events_]);
    }
  }

  void write_event(const Simulation& simulation, const simulation::EventRecord& event) {
    const std::uint64_t time_ns = nanoseconds(event.time_s);
    write(events_, time_ns, [&] {
      const auto robot = places_.find(event.robot);
      std::optional<Pose> where;
      if (robot != places_.end()) where = simulation.robot(robot->second).pose;
      return event_message(time_ns, event, where ? &*where : nullptr);
    });
  }

  void remember_who_sees(const Simulation& simulation) {
    empty_.clear();
    for (std::size_t r = 0; has_cameras_ && r < simulation.robots(); ++r) {
      empty_.push_back(simulation.robot(r).empty);
    }
  }

  void write_fields(const Simulation& simulation) {
    fields_written_ = simulation.steps();
    const world::Arena& arena = simulation.world().arena;
    for (std::size_t i = 0; i < simulation.fields(); ++i) {
      const std::string& id = simulation.field(i).description->id;
      const auto [known, is_new] = fields_.try_emplace(id, std::uint32_t{0});
      if (is_new) {
        known->second = channels_.add(field_topic(id), channels_.schema("foxglove.Grid"));
      }
      const std::uint64_t time_ns = now(simulation);
      write(known->second, time_ns, [&] {
        return field_text(time_ns, picture::floor_field(simulation.field(i), kMostFieldCells),
                          arena.length, arena.width);
      });
    }
  }

  /// `with_pictures`: there are new ones.
  void write_state(const Simulation& simulation, bool decided, bool with_pictures,
                   double period_s) {
    const std::uint64_t time_ns = now(simulation);
    const auto lifetime_ns = static_cast<std::uint64_t>(1.5 * period_s * 1e9);
    write(transforms_, time_ns,
          [&] { return transforms_message(time_ns, simulation, places_seen()); });
    for (RobotChannels& channels : robots_) {
      const RobotView robot = simulation.robot(channels.place);
      write(channels.pose, time_ns, [&] { return pose_message(time_ns, robot.pose); });
      write(channels.state, time_ns,
            [&] { return state_message(time_ns, simulation, channels.place); });
      if (channels.belief) {
        write(*channels.belief, time_ns, [&] { return pose_message(time_ns, robot.state->pose); });
      }
      if (decided) {
        write_decision(simulation, channels, robot, time_ns, lifetime_ns);
        if (with_pictures && !channels.cameras.empty() && !blind_[channels.place]) {
          write_pictures(simulation, channels, time_ns);
        }
      }
    }
    if (!crowd_.empty()) {
      write(crowd_channel_, time_ns, [&] { return crowd_text(time_ns, simulation, crowd_); });
    }
    if (decided) {
      write_sketches(
          sketches_, nullptr, [&] { return simulation.sketches(); }, time_ns, lifetime_ns);
      if (published_) {
        write(*published_, time_ns,
              [&] { return published_message(time_ns, published_of_measures(simulation)); });
      }
    }
  }

  /// Writes the decisions that differ from the previous ones.
  void write_traces(const Simulation& simulation) {
    for (RobotChannels& channels : robots_) {
      if (!out_.wants(channels.trace)) continue;
      const RobotView robot = simulation.robot(channels.place);
      if (channels.rows.changed(robot) || options_.with_times) write_trace(channels, robot);
    }
  }

  void write_trace(RobotChannels& channels, const RobotView& robot) {
    write(channels.trace, decided_ns_, [&] {
      return std::string_view(channels.texts.message(decided_ns_, robot, options_.with_times));
    });
  }

  /// Each message once. Robots that have never heard anything get no channel.
  void write_heard(const Simulation& simulation) {
    for (RobotChannels& channels : robots_) {
      if (simulation.heard(channels.place).empty()) continue;
      if (!channels.heard) {
        channels.heard = channels_.add(*simulation.robot(channels.place).description, kHeardKind,
                                       channels_.schema("elsie.Heard"));
      }
      write(*channels.heard, decided_ns_,
            [&] { return heard_message(simulation, channels.place, decided_ns_); });
    }
  }

  /// Whose coordinators have any is asked at the start and after edits, not in each decision.
  void find_graphs(const Simulation& simulation) {
    for (RobotChannels& channels : robots_) {
      put_graphs(simulation, channels, channels.graph_news, now(simulation));
    }
  }

  void write_graphs(const Simulation& simulation, RobotChannels& channels, std::uint64_t time_ns) {
    const auto is_wanted = [&](const auto& channel) { return channel && out_.wants(*channel); };
    if (is_wanted(channels.graphs) || is_wanted(channels.lit)) {
      put_graphs(simulation, channels, channels.graph_news, time_ns);
    }
  }

  void put_graphs(const Simulation& simulation, RobotChannels& channels, GraphNews& news,
                  std::uint64_t time_ns) {
    const auto [graphs, lights] =
        news.take(shown("graphs", [&] { return simulation.graphs(channels.place); }), time_ns);
    const auto put = [&](std::optional<std::uint32_t>& to, const char* kind, const char* schema,
                         const std::optional<Json>& message) {
      if (!message) return;
      if (!to) {
        to = channels_.add(*simulation.robot(channels.place).description, kind,
                           channels_.schema(schema));
      }
      write(*to, time_ns, [&] { return text_of(*message); });
    };
    put(channels.graphs, kGraphsKind, "elsie.Graphs", graphs);
    put(channels.lit, kLitKind, "elsie.Lit", lights);
  }

  /// What plugins show; nothing when one fails, which is said once.
  template <class List>
  auto shown(const char* what, const List& list) -> decltype(list()) {
    try {
      return list();
    } catch (const simulation::PluginFault& fault) {
      if (!options_.warn) throw;
      if (lacking_.insert(what).second) {
        options_.warn(std::string(what) + ": " + fault.what());
      }
      return {};
    }
  }

  /// `robot`: null for measures. Plugins that have never drawn anything get no channel.
  template <class List>
  void write_sketches(std::optional<std::uint32_t>& to, const world::Robot* robot, List list,
                      std::uint64_t time_ns, std::uint64_t lifetime_ns) {
    if (to && !out_.wants(*to)) return;
    const std::vector<simulation::PluginSketch> sketches = shown("sketches", list);
    if (!to && sketches.empty()) return;
    if (!to) {
      const std::uint32_t scene = channels_.schema("foxglove.SceneUpdate");
      to = robot ? channels_.add(*robot, kSketchesKind, scene)
                 : channels_.add(kSketchesTopic, scene);
    }
    const std::string whose = robot ? robot->id : "measures";
    write(*to, time_ns, [&] { return sketches_message(time_ns, lifetime_ns, whose, sketches); });
  }

  void write_decision(const Simulation& simulation, RobotChannels& channels, const RobotView& robot,
                      std::uint64_t time_ns, std::uint64_t lifetime_ns) {
    const std::size_t r = channels.place;
    write(channels.readings, time_ns, [&] { return readings_message(simulation, r, decided_ns_); });
    write(channels.command, time_ns, [&] { return command_message(decided_ns_, robot); });
    write_sketches(
        channels.sketches, robot.description, [&] { return simulation.sketches(r); }, time_ns,
        lifetime_ns);
    if (channels.published) {
      write(*channels.published, time_ns,
            [&] { return published_message(time_ns, published_of(simulation, r)); });
    }
  }

  void write_pictures(const Simulation& simulation, const RobotChannels& channels,
                      std::uint64_t time_ns) {
    const std::size_t r = channels.place;
    const auto is_wanted = [&](const auto& each) { return out_.wants(each.second); };
    for (const CameraChannels& camera : channels.cameras) {
      if (std::none_of(camera.of.begin(), camera.of.end(), is_wanted)) continue;
      visit_pictures(simulation, r, camera.sensor, [&](std::string_view name, const Image& image) {
        const std::string& id = simulation.robot(r).description->id;
        write(camera.of.find(name)->second, time_ns,
              [&] { return image_message(decided_ns_, id, image); });
      });
    }
  }

  RecorderOptions options_;
  std::set<std::string> chosen_;  // robots; empty: see kMostWithChannels
  MessageSink& out_;
  Channels channels_{out_};
  traces::Sampling field_sampling_{1.0};
  std::uint32_t world_ = 0, scene_ = 0, transforms_ = 0, events_ = 0, crowd_channel_ = 0;
  std::optional<std::uint32_t> sketches_, published_;  // of measures
  std::map<std::string, std::uint32_t> fields_;        // of the floor, by id
  std::set<std::string> lacking_;                      // what a plugin failed to show
  std::vector<RobotChannels> robots_;
  bool has_cameras_ = false;                             // whose pictures are recorded
  std::vector<std::size_t> crowd_;                       // places of the robots without channels
  std::unordered_map<std::string, std::size_t> places_;  // of all robots in the simulation
  std::size_t seen_events_ = 0;
  std::vector<std::optional<Pose>> shown_;  // boxes, when the scene was last written
  std::uint64_t sampled_ = 0, fields_written_ = 0;
  std::uint64_t decided_ns_ = 0;
  bool new_pictures_ = false;  // since the last sample
  // Robots whose battery is empty now, and was before the last decision: then they saw nothing.
  std::vector<bool> empty_, blind_;
};

std::string why_stopped() {
  if (const std::exception_ptr thrown = std::current_exception()) {
    try {
      std::rethrow_exception(thrown);
    } catch (const std::exception& error) {
      return error.what();
    } catch (...) {  // the user's interruption
    }
  }
  return {};
}

RunMessages::RunMessages(MessageSink& sink, RecorderOptions options)
    : impl_(std::make_unique<Impl>(sink, std::move(options))) {}
RunMessages::~RunMessages() = default;

void RunMessages::begin(const Simulation& simulation) { impl_->begin(simulation); }
void RunMessages::step(const Simulation& simulation) { impl_->step(simulation); }
void RunMessages::sample(const Simulation& simulation, bool decided, double period_s) {
  impl_->sample(simulation, decided, period_s);
}
void RunMessages::replace(const Simulation& simulation) { impl_->replace(simulation); }
void RunMessages::end(const Simulation& simulation, bool decided, double period_s) {
  impl_->end(simulation, decided, period_s);
}
void RunMessages::repeat(const Simulation& simulation, double period_s) {
  impl_->repeat(simulation, period_s);
}
void RunMessages::resume(const Simulation& simulation, double decided_s, double period_s) {
  impl_->resume(simulation, decided_s, period_s);
}
void RunMessages::follow(const Simulation& simulation, double decided_s) {
  impl_->follow(simulation, decided_s);
}
double RunMessages::decided_s() const { return impl_->decided_s(); }

}  // namespace elsie::recording
