#include "elsie/recording/mcap_recorder.h"

#include <cmath>
#include <exception>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

#include "elsie/base/number_text.h"
#include "elsie/files/emergency.h"
#include "elsie/mcap/writer.h"
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
namespace {

using simulation::RobotView;
using simulation::Simulation;

class McapRecorder final : public simulation::Observer, private files::EmergencyWriter {
 public:
  McapRecorder(const std::filesystem::path& file, const RecorderOptions& options)
      : options_(checked(options)),
        chosen_(options_.robots.begin(), options_.robots.end()),
        out_(file, {.library = options_.program}) {}

  ~McapRecorder() override { retire(); }

  void started(const Simulation& simulation) override {
    const world::Physics& physics = simulation.world().physics;
    every_ = traces::steps_in(1.0 / options_.rate_hz, physics.step);
    sampling_ = traces::Sampling(static_cast<double>(every_) * physics.step);
    sampling_.is_due(simulation.time_s());
    control_steps_ = static_cast<std::uint64_t>(physics.control_steps);
    write_head(simulation);
    out_.set_last_words(
        {kResultMetadata,
         {{"outcome", kStopped}, {"reason", "the program was brought down in the step after it"}}},
        kEndTime);
    add_channels(simulation);
    write_world(simulation);
    write_scene(simulation);
    write_events(simulation);
    find_graphs(simulation);
    remember_who_sees(simulation);
    sample(simulation, false);
  }

  void stepped(const Simulation& simulation) override {
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
    if (has_other_boxes(simulation)) write_scene(simulation);
    if (sampling_.is_due(simulation.time_s())) {
      sample(simulation, true);
    }
    remember_who_sees(simulation);
    out_.pass(now(simulation));
  }

  /// Robots that are new, or have other behaviours or other sensors than before, get channels of
  /// their own from now on.
  void replaced(const Simulation& simulation) override {
    add_robots(simulation);
    write_world(simulation);
    write_scene(simulation);
    write_events(simulation);
    find_graphs(simulation);
    remember_who_sees(simulation);
  }

  void ended(const Simulation& simulation) override {
    std::exception_ptr fault;
    const simulation::RunResult result = result_of(simulation, fault);
    const bool stopped = fault || result.outcome == simulation::Outcome::running;
    write_events(simulation);
    if (sampled_ != simulation.steps()) {
      // The last decision may be half of a step that a plugin did not end.
      sample(simulation, !stopped);
    }
    if (fields_written_ != simulation.steps()) write_fields(simulation);
    out_.write(mcap::Metadata{kResultMetadata,
                              {{"outcome", stopped ? kStopped : to_string(result.outcome)},
                               {"reason", result.reason},
                               {kEndTime, base::number_text(result.simulated_s)},
                               {"steps", std::to_string(result.steps)},
                               {"state_hash", simulation::hash_text(result.state_hash)}}});
    write_measures(result);
    out_.close();
    if (fault) {
      std::rethrow_exception(fault);
    }
  }

 private:
  bool write_now() noexcept override { return out_.write_in_emergency(); }

  static const RecorderOptions& checked(const RecorderOptions& options) {
    if (!(options.rate_hz > 0.0) || !std::isfinite(options.rate_hz)) {
      throw std::invalid_argument("a recording needs a positive number of samples a second");
    }
    return options;
  }

  static std::uint64_t now(const Simulation& simulation) {
    return nanoseconds(simulation.time_s());
  }

  void write_head(const Simulation& simulation) {
    const world::World& world = simulation.world();
    out_.write(mcap::Metadata{kRunMetadata,
                              {{"program", options_.program},
                               {"world", world.name},
                               {"file", world.file},
                               {"seed", std::to_string(simulation.seed())},
                               {"time_limit_s", base::number_text(simulation.time_limit_s())},
                               {"step_s", base::number_text(world.physics.step)},
                               {"control_steps", std::to_string(control_steps_)},
                               {"sample_steps", std::to_string(every_)}}});
  }

  /// A measure that fails at the end has no values; its fault is reported later.
  static simulation::RunResult result_of(const Simulation& simulation, std::exception_ptr& fault) {
    try {
      return simulation.result();
    } catch (const simulation::PluginFault&) {
      fault = std::current_exception();
      return simulation.result();
    }
  }

  void write_measures(const simulation::RunResult& result) {
    mcap::Metadata measures{kMeasuresMetadata, {}};
    for (const simulation::MeasuredValue& measure : result.measures) {
      if (measure.value) {
        measures.values[measure.name] = base::number_text(*measure.value);
      }
    }
    out_.write(measures);
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
      const std::string cast = kind_of(simulation, r);
      if (const auto known = before.find(cast); known != before.end()) {
        robots_.push_back(std::move(known->second));
        robots_.back().place = r;
        continue;
      }
      robots_.push_back(robot_channels(channels_, simulation, r, options_.images));
    }
    if (!crowd_.empty() && crowd_channel_ == 0) {
      crowd_channel_ = channels_.add(kCrowdTopic, channels_.schema("foxglove.PointCloud"));
    }
  }

  void write(std::uint16_t channel, std::uint64_t time_ns, const Json& message) {
    out_.write(channel, time_ns, recording::text_of(message));
  }

  void write_world(const Simulation& simulation) {
    out_.write(world_, now(simulation), world_text(simulation, options_.program, crowd_));
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
    write(scene_, now(simulation), scene_message(now(simulation), simulation, places_seen()));
  }

  void write_events(const Simulation& simulation) {
    const auto events = simulation.events();
    for (; seen_events_ < events.size(); ++seen_events_) {
      const simulation::EventRecord& event = events[seen_events_];
      const auto robot = places_.find(event.robot);
      std::optional<Pose> where;
      if (robot != places_.end()) where = simulation.robot(robot->second).pose;
      const std::uint64_t time_ns = nanoseconds(event.time_s);
      write(events_, time_ns, event_message(time_ns, event, where ? &*where : nullptr));
    }
  }

  void remember_who_sees(const Simulation& simulation) {
    empty_.clear();
    for (std::size_t r = 0; options_.images && r < simulation.robots(); ++r) {
      empty_.push_back(simulation.robot(r).empty);
    }
  }

  void write_fields(const Simulation& simulation) {
    fields_written_ = simulation.steps();
    const world::Arena& arena = simulation.world().arena;
    for (std::size_t i = 0; i < simulation.fields(); ++i) {
      const auto field = picture::floor_field(simulation.field(i), kMostFieldCells);
      const auto [known, is_new] = fields_.try_emplace(field.id, std::uint16_t{0});
      if (is_new) {
        known->second = channels_.add(field_topic(field.id), channels_.schema("foxglove.Grid"));
      }
      const std::uint64_t time_ns = now(simulation);
      out_.write(known->second, time_ns, field_text(time_ns, field, arena.length, arena.width));
    }
  }

  void sample(const Simulation& simulation, bool decided) {
    sampled_ = simulation.steps();
    const std::uint64_t time_ns = now(simulation);
    if (field_sampling_.is_due(simulation.time_s())) write_fields(simulation);
    write(transforms_, time_ns, transforms_message(time_ns, simulation, places_seen()));
    for (RobotChannels& channels : robots_) {
      const RobotView robot = simulation.robot(channels.place);
      write(channels.pose, time_ns, pose_message(time_ns, robot.pose));
      write(channels.state, time_ns, state_message(time_ns, simulation, channels.place));
      if (channels.belief) {
        write(*channels.belief, time_ns, pose_message(time_ns, robot.state->pose));
      }
      if (decided) {
        write_decision(simulation, channels, robot, time_ns);
      }
    }
    if (!crowd_.empty()) {
      out_.write(crowd_channel_, time_ns, crowd_text(time_ns, simulation, crowd_));
    }
    if (decided) {
      write_sketches(
          sketches_, nullptr, [&] { return simulation.sketches(); }, time_ns);
      if (published_) {
        write(*published_, time_ns, published_message(time_ns, published_of_measures(simulation)));
      }
    }
    new_pictures_ = new_pictures_ && !decided;
  }

  /// Writes the decisions that differ from the previous ones.
  void write_traces(const Simulation& simulation) {
    for (RobotChannels& channels : robots_) {
      const RobotView robot = simulation.robot(channels.place);
      if (channels.rows.changed(robot) || options_.with_times) {
        out_.write(channels.trace, decided_ns_,
                   channels.texts.message(decided_ns_, robot, options_.with_times));
      }
    }
  }

  /// Each message once. Robots that have never heard anything get no channel.
  void write_heard(const Simulation& simulation) {
    for (RobotChannels& channels : robots_) {
      if (simulation.heard(channels.place).empty()) continue;
      if (!channels.heard) {
        channels.heard = channels_.add(*simulation.robot(channels.place).description, kHeardKind,
                                       channels_.schema("elsie.Heard"));
      }
      write(*channels.heard, decided_ns_, heard_message(simulation, channels.place, decided_ns_));
    }
  }

  /// Whose coordinators have any is asked at the start and after edits, not in each decision.
  void find_graphs(const Simulation& simulation) {
    for (RobotChannels& channels : robots_) write_graphs(simulation, channels, now(simulation));
  }

  void write_graphs(const Simulation& simulation, RobotChannels& channels, std::uint64_t time_ns) {
    const auto [graphs, lights] = channels.graph_news.take(
        shown("graphs", [&] { return simulation.graphs(channels.place); }), time_ns);
    const auto put = [&](std::optional<std::uint16_t>& to, const char* kind, const char* schema,
                         const std::optional<Json>& message) {
      if (!message) return;
      if (!to) {
        to = channels_.add(*simulation.robot(channels.place).description, kind,
                           channels_.schema(schema));
      }
      write(*to, time_ns, *message);
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
        options_.warn(std::string("the recording lacks ") + what + ": " + fault.what());
      }
      return {};
    }
  }

  /// `robot`: null for measures. Plugins that have never drawn anything get no channel.
  template <class List>
  void write_sketches(std::optional<std::uint16_t>& to, const world::Robot* robot, List list,
                      std::uint64_t time_ns) {
    const std::vector<simulation::PluginSketch> sketches = shown("sketches", list);
    if (!to && sketches.empty()) return;
    if (!to) {
      const std::uint16_t scene = channels_.schema("foxglove.SceneUpdate");
      to = robot ? channels_.add(*robot, kSketchesKind, scene)
                 : channels_.add(kSketchesTopic, scene);
    }
    const std::string whose = robot ? robot->id : "measures";
    const auto lifetime_ns = static_cast<std::uint64_t>(1.5 * sampling_.period_s() * 1e9);
    write(*to, time_ns, sketches_message(time_ns, lifetime_ns, whose, sketches));
  }

  void write_decision(const Simulation& simulation, RobotChannels& channels, const RobotView& robot,
                      std::uint64_t time_ns) {
    const std::size_t r = channels.place;
    write(channels.readings, time_ns, readings_message(simulation, r, decided_ns_));
    write(channels.command, time_ns, command_message(decided_ns_, robot));
    write_sketches(
        channels.sketches, robot.description, [&] { return simulation.sketches(r); }, time_ns);
    if (channels.published) {
      write(*channels.published, time_ns, published_message(time_ns, published_of(simulation, r)));
    }
    if (new_pictures_ && !channels.cameras.empty() && !blind_[r]) {
      write_pictures(simulation, channels, time_ns);
    }
  }

  void write_pictures(const Simulation& simulation, const RobotChannels& channels,
                      std::uint64_t time_ns) {
    const std::size_t r = channels.place;
    for (const CameraChannels& camera : channels.cameras) {
      visit_pictures(simulation, r, camera.sensor, [&](std::string_view name, const Image& image) {
        const std::string& id = simulation.robot(r).description->id;
        write(camera.of.find(name)->second, time_ns, image_message(decided_ns_, id, image));
      });
    }
  }

  RecorderOptions options_;
  std::set<std::string> chosen_;  // robots; empty: see kMostWithChannels
  mcap::Writer out_;
  Channels channels_{out_};
  std::uint64_t every_ = 1;  // steps from one sample to the next, as the run begins
  traces::Sampling sampling_, field_sampling_{1.0};
  std::uint64_t control_steps_ = 1;  // from one decision to the next
  std::uint16_t world_ = 0, scene_ = 0, transforms_ = 0, events_ = 0, crowd_channel_ = 0;
  std::optional<std::uint16_t> sketches_, published_;  // of measures
  std::map<std::string, std::uint16_t> fields_;        // of the floor, by id
  std::set<std::string> lacking_;                      // what a plugin failed to show
  std::vector<RobotChannels> robots_;
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

}  // namespace

std::unique_ptr<simulation::Observer> mcap_recorder(const std::filesystem::path& file,
                                                    const RecorderOptions& options) {
  return std::make_unique<McapRecorder>(file, options);
}

Format mcap_format() {
  return {.suffix = ".mcap",
          .description = "a recording for viewers, `elsie replay` and `elsie explain`",
          .mark = "\x89MCAP",
          .maker = "elsie",
          .images = true,
          .most_robots = kMostWithChannels,
          .recorder = mcap_recorder};
}

}  // namespace elsie::recording
