#include "episode.h"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include "elsie/base/error.h"
#include "elsie/base/near_name.h"
#include "elsie/base/words.h"
#include "elsie/editing/document.h"
#include "elsie/files/outputs.h"
#include "elsie/files/write_whole.h"
#include "elsie/recording/formats.h"
#include "elsie/render/world_cameras.h"
#include "elsie/world/data_directories.h"
#include "elsie/world/reader.h"
#include "elsie/world/writer.h"

namespace elsie::python {
namespace {

std::size_t index_of(const world::World& world, const std::string& robot) {
  std::vector<std::string> known;
  for (std::size_t i = 0; i < world.robots.size(); ++i) {
    if (std::as_const(world).robots[i].id == robot) return i;
    known.push_back(std::as_const(world).robots[i].id);
  }
  throw base::BadInput("The world has no robot '" + robot + "'" +
                       base::near_or_all(robot, known, "it has"));
}

void require_as_many(const std::string& robot, const char* what, std::size_t now,
                     std::size_t known) {
  if (now == known) return;
  throw base::BadInput("Robot '" + robot + "' " + what + " " + base::counted(now, "number") +
                       " now, and " + std::to_string(known) +
                       " when the environment was made; expected as many with every seed and edit");
}

simulation::Options options_for(std::uint64_t seed, std::optional<double> time_limit_s) {
  simulation::Options options;
  options.seed = seed;
  options.data_directories = world::default_data_directories();
  options.time_limit_s = time_limit_s;
  options.cameras = render::world_cameras;
  return options;
}

}  // namespace

void Episode::make_simulation(std::uint64_t seed) {
  if (simulation_ && !is_drawn_) {
    simulation_->reset(seed);
    for (const std::string& id : declared_.robots) {
      const std::size_t robot = index_of(simulation_->world(), id);
      Acting(*simulation_, host_, robot, declared_.act, by_edits_).forget();
    }
    return;
  }
  simulation_.reset();
  world::World world = make_(seed);
  is_drawn_ = world.drawn && world.drawn->by_run;
  by_edits_ = !world.rules.empty();
  robots_.clear();
  for (const std::string& id : declared_.robots) {
    robots_.push_back(index_of(world, id));
    prepare(world, host_, robots_.back(), declared_.act);
  }
  simulation_ = std::make_unique<simulation::Simulation>(std::move(world), host_,
                                                         options_for(seed, declared_.time_limit_s));
}

/// Notices that objects were made again, so that names must be looked up again.
class Episode::Watcher final : public simulation::Observer {
 public:
  void replaced(const simulation::Simulation&) override { has_seen = true; }
  bool has_seen = false;
};

Episode::Episode(const Declared& declared, const MakeWorld& make, const plugin::Host& host)
    : declared_(declared), make_(make), host_(host), watcher_(std::make_unique<Watcher>()) {}
Episode::~Episode() = default;

void Episode::begin(std::uint64_t seed) {
  is_sound_ = is_stepping_ = is_interrupted_ = false;
  run_.reset();
  hands_.clear();
  eyes_.clear();
  deeds_.clear();
  seed_ = seed;
  make_simulation(seed);
  terminated_ = truncated_ = false;
  ended_.assign(robots_.size(), false);
  rewards_.assign(robots_.size(), 0.0);
  since_decision_ = 0;
  rewarding_ = std::make_unique<Rewarding>(*simulation_, host_, robots_, declared_.rewards);
  simulation::Observer* const observers[] = {watcher_.get()};
  // The world's own edits come before actions, which they may undo.
  run_ = std::make_unique<simulation::Run>(*simulation_, observers,
                                           std::span<const simulation::TimedEdit>(),
                                           [this](simulation::Simulation&) { take_edits(); });
  const int first = simulation_->world().physics.control_steps;
  for (int i = 0; i < first; ++i) advance();
  find_names();
  rewards_.assign(robots_.size(), 0.0);
  is_sound_ = true;
}

/// Looks up what the declared names mean.
void Episode::find_names() {
  eyes_.clear();
  hands_.clear();
  robots_.clear();
  states_.clear();
  for (const std::string& id : declared_.robots) {
    const std::size_t robot = index_of(simulation_->world(), id);
    robots_.push_back(robot);
    states_.push_back(simulation_->robot(robot).state);
    eyes_.emplace_back(*simulation_, host_, robot, declared_.observe);
    hands_.emplace_back(*simulation_, host_, robot, declared_.act, by_edits_);
    if (declared_.observed.empty()) continue;
    const std::size_t i = robots_.size() - 1;
    require_as_many(id, "observes", eyes_[i].numbers().size(), declared_.observed[i].size());
    require_as_many(id, "does", hands_[i].numbers().size(), declared_.acted[i].size());
    eyes_[i].take(declared_.observed[i]);
    hands_[i].take(declared_.acted[i]);
  }
  watcher_->has_seen = false;
}

/// Sets the actions of the present step.
void Episode::apply() {
  const float* actions = deeds_.back().actions.data();
  for (const Acting& each : hands_) {
    each.apply(*simulation_, actions);
    actions += each.numbers().size();
  }
  seen_ = simulation_->events().size();
}

/// Sets the actions again if somebody else has edited the world since.
void Episode::take_edits() {
  const auto events = simulation_->events();
  if (events.size() == seen_) return;
  const bool is_edited =
      std::any_of(events.begin() + static_cast<std::ptrdiff_t>(seen_), events.end(),
                  [](const auto& each) { return each.template as<events::Changed>() != nullptr; });
  seen_ = events.size();
  if (!is_edited || deeds_.empty()) return;
  find_names();
  apply();
}

/// A step of the physics.
void Episode::advance() {
  run_->step();
  since_decision_ = simulation_->decided() ? 1 : since_decision_ + 1;
  if (since_decision_ == simulation_->world().physics.control_steps ||
      simulation_->outcome() != simulation::Outcome::running) {
    rewarding_->add_period(*simulation_, rewards_.data());
  }
}

void Episode::require_sound() const {
  if (is_interrupted_) throw base::BadInput("This episode was interrupted: call reset()");
  if (!is_sound_) throw base::BadInput("A fault has ended this episode: call reset()");
}

void Episode::interrupt() {
  is_sound_ = is_stepping_ = false;
  is_interrupted_ = true;
}

void Episode::begin_step(const float* actions) {
  require_sound();
  if (has_ended()) throw base::BadInput("This episode has ended: call reset()");
  is_sound_ = false;
  std::fill(rewards_.begin(), rewards_.end(), 0.0);
  std::size_t size = 0;
  for (const Acting& each : hands_) size += each.numbers().size();
  deeds_.push_back({simulation_->time_s(), {actions, actions + size}});
  apply();
  steps_left_ = declared_.steps > 0
                    ? declared_.steps
                    : static_cast<std::size_t>(simulation_->world().physics.control_steps);
}

bool Episode::finish_step(Turn turn) {
  is_stepping_ = false;  // a fault ends it
  while (steps_left_ > 0 && simulation_->outcome() == simulation::Outcome::running) {
    advance();
    --steps_left_;
    if (turn.is_over() && steps_left_ > 0) {
      is_stepping_ = true;
      return false;
    }
  }
  if (watcher_->has_seen) find_names();
  rewarding_->add_growth(*simulation_, rewards_.data());
  const simulation::Outcome outcome = simulation_->outcome();
  truncated_ = outcome == simulation::Outcome::time_limit;
  terminated_ = outcome != simulation::Outcome::running && !truncated_;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    // A view of the robot costs more than a look at its battery.
    const bool may_be_empty = !(states_[i]->energy > 0.0);
    ended_[i] = terminated_ || (may_be_empty && simulation_->robot(robots_[i]).empty);
  }
  if (!truncated_ && std::all_of(ended_.begin(), ended_.end(), [](char ended) { return ended; })) {
    terminated_ = true;
  }
  is_sound_ = true;
  return true;
}

const simulation::Simulation& Episode::simulation() const {
  if (!simulation_) {
    throw base::BadInput("This episode could not begin: call reset() with another seed");
  }
  return *simulation_;
}

void Episode::observe(float* to) const {
  for (const Observing& each : eyes_) {
    each.read(*simulation_, to);
    to += each.numbers().size();
  }
}

/// The world at its start, with the actions as edits.
world::World Episode::kept() const {
  world::World world = simulation_->start();
  std::vector<std::vector<double>> before(hands_.size());
  for (const Deed& deed : deeds_) {
    const float* actions = deed.actions.data();
    std::vector<simulation::Edit> edits;
    for (std::size_t i = 0; i < hands_.size(); ++i) {
      hands_[i].add_edits(actions, before[i], edits);
      actions += hands_[i].numbers().size();
    }
    for (simulation::Edit& edit : edits) {
      world.edits.push_back({deed.time_s, std::move(edit.path), std::move(edit.value), {}, {}});
    }
  }
  return world;
}

std::optional<double> Episode::save(const std::filesystem::path& file) const {
  require_sound();
  world::World world = kept();
  if (file.extension() == ".xml") {
    // The limit ends the run when the episode did, unless a goal lasts longer than that.
    std::optional<double> limit = declared_.time_limit_s;
    if (simulation_->outcome() == simulation::Outcome::running) limit = simulation_->time_s();
    bool is_too_short = false;
    world::for_each_goal(world.goals, [&](const world::Goal& goal) {
      const auto* const endure = std::get_if<world::EndureGoal>(&goal);
      is_too_short = is_too_short || (limit && endure && endure->time > *limit);
    });
    if (limit && !is_too_short) {
      world.limits.time = *limit;
      limit.reset();
    }
    world::ReadOptions reading;
    reading.data_directories = world::default_data_directories();
    const editing::Document document(world::write_world(world), world.file, host_, reading);
    const std::string folder = file.parent_path().string();
    files::require_writable(file, "save");
    files::write_whole_or_throw(file, document.text_for(folder.empty() ? "." : folder));
    return limit;
  }
  recording::require_recording(file, "save");
  const bool is_over = simulation_->outcome() != simulation::Outcome::running;
  simulation::Simulation again(
      world, host_, options_for(seed_, is_over ? declared_.time_limit_s : simulation_->time_s()));
  const auto recorder = recording::format_of(file)->recorder(file, {});
  simulation::Observer* const observers[] = {recorder.get()};
  again.run(observers);
  if (again.state_hash() != simulation_->state_hash()) {
    throw base::Error("'" + file.string() + "' holds another run than this episode: " +
                      simulation::hash_text(again.state_hash()) + ", not " +
                      simulation::hash_text(simulation_->state_hash()) +
                      "; a plugin gives other answers when it runs again");
  }
  return std::nullopt;
}

}  // namespace elsie::python
