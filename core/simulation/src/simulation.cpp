#include "elsie/simulation/simulation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "elsie/base/fnv1a.h"
#include "elsie/simulation/run.h"

#include "simulation_impl.h"

namespace elsie::simulation {

Simulation::Impl::Impl(world::World world, const plugin::Host& host, const Options& options)
    : own_world_(std::move(world)),
      time_limit_s_(options.time_limit_s.value_or(world_.limits.time)),
      seed_(options.seed),
      host_(&host),
      options_(options),
      loop_(options.threads),
      memory_(options.threads) {
  if (options.threads > 1 && (options.budget.time_s > 0.0 || options.budget.memory > 0)) {
    throw std::invalid_argument("A budget of plugins needs a simulation with one thread.");
  }
  in_place_.emplace(world_, host, options_);
  std::vector<base::Problem> problems;
  const auto common = std::make_shared<CommonData>(world_, robot_ids_);
  for (std::size_t i = 0; i < world_.robots.size(); ++i) {
    try {
      // Not shared any more, before the object refers to it.
      world::Robot* const own = world_.robots[i].drive ? &own_world_.robots[i] : nullptr;
      robots_.push_back(std::make_shared<Robot>(world_, i, common, host, options));
      if (own) own->driven = robots_.back()->take_driven();
    } catch (const world::WorldError& error) {
      problems.insert(problems.end(), error.problems().begin(), error.problems().end());
    }
  }
  note_robot_ids();
  measuring_ = std::make_shared<Measuring>(world_, host, options.budget, problems);
  if (problems.empty()) {
    cameras_ = std::make_shared<Cameras>(world_, robots_, options.cameras, problems);
  }
  if (!problems.empty()) {
    throw world::WorldError(std::move(problems));
  }
}

void Simulation::Impl::reset(std::uint64_t seed) {
  seed_ = seed;
  steps_ = base_steps_ = 0;
  decided_ = false;
  step_began_s_ = 0.0;
  base_time_s_ = 0.0;
  // A new engine, so that ODE keeps no state of the last run.
  engine_ = physics::make_engine(world_.arena, world_.physics);
  engine_->work_with(loop_.pool());
  goal_progress_.assign(single_goals(world_.goals).size(), {});
  fields_ = std::make_shared<Fields>(world_);
  moving_.clear();
  for (std::size_t i = 0; i < world_.obstacles.size(); ++i) {
    add_obstacle(i);
  }
  add_charger_boxes();
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const world::Robot& d = world_.robots[i];
    engine_->add_robot(world::plan_of(d), {d.x, d.y, wrap_angle(radians(d.heading_deg))}, d.z);
    robots_[i]->reset(seed);
    robots_[i]->set_body(engine_->robot(i), engine_->joints(i), Arrival::started);
    robots_[i]->take_segments(*engine_, i);
  }
  take_stock();
  wall_s_ = 0.0;
  judgement_ = {};
  touches_ = {};
  hands_ = {};
  events_.clear();
  given_.clear();
  by_rules_.clear();
  obeyed_at_ = kNever;
  looked_at_ = 0;
  log_events();
  said_ = {};
  note_warnings(world_, said_.notes);
  for (const auto& robot : robots_) {
    robot->ask(said_);
  }
  measuring_->reset(seed);
  measuring_->ask(said_);
}

void Simulation::Impl::add_obstacle(std::size_t i) {
  engine_->add_obstacle(world_.obstacles[i]);
  if (world_.obstacles[i].kind == world::ObstacleKind::moving) {
    moving_.push_back({i, WaypointPath(world_.obstacles[i]), time_s()});
  }
}

void Simulation::Impl::add_charger_boxes() {
  for (const world::Charger& charger : world_.chargers) {
    if (charger.seen_by_range_sensors) {
      world::Obstacle obstacle;
      obstacle.x = charger.x;
      obstacle.y = charger.y;
      obstacle.length = obstacle.width = obstacle.height = world::Charger::kBoxEdge;
      engine_->add_obstacle(obstacle);
    }
  }
}

Simulation::Simulation(world::World world, const plugin::Host& host, const Options& options)
    : impl_(std::make_unique<Impl>(std::move(world), host, options)) {
  if (!options.begin_later) impl_->reset(options.seed);
}

Simulation::Simulation(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

void Simulation::reset(std::optional<std::uint64_t> seed) {
  const std::uint64_t next = seed.value_or(impl_->seed_);
  if (impl_->start_) impl_ = std::make_unique<Impl>(*impl_->start_, *impl_->host_, impl_->options_);
  impl_->reset(next);
}

void Simulation::step() { impl_->step(*this); }

RunResult Simulation::run(std::span<Observer* const> observers, std::span<const TimedEdit> edits,
                          const std::function<void(Simulation&)>& before_control) {
  Run run(*this, observers, edits, before_control);
  while (run.step()) {
  }
  return run.end();
}

std::vector<UnmadeEdits> Simulation::check(std::span<const TimedEdit> edits) const {
  std::vector<UnmadeEdits> unmade;
  impl_->checked(with_own(world(), edits), edits, unmade);
  return unmade;
}

void Simulation::edit(std::string_view path, std::string_view value) {
  const Edit one{std::string(path), std::string(value)};
  impl_->edit({&one, 1});
}
void Simulation::edit(std::span<const Edit> edits) { impl_->edit(edits); }

Replacement Simulation::replace_plugins(const plugin::Host& host) {
  return impl_->replace_plugins(host);
}

RunResult Simulation::result() const {
  RunResult result = impl_->figures();
  result.reason = impl_->judgement_.reason;
  result.seed = impl_->seed_;
  result.wall_s = impl_->wall_s_;
  result.steps = steps();
  result.state_hash = state_hash();
  result.events = impl_->events_;
  result.notes = impl_->said_.notes;
  for (const auto& robot : impl_->robots_) {
    robot->list_late_notes(result.notes);
  }
  impl_->measuring_->list_late_notes(result.notes);
  const physics::GiveUps give_ups = impl_->engine_->give_ups();
  result.solver = {give_ups.steps, give_ups.unsolved, give_ups.first_s};
  // A step that ended with a fault is not counted in steps().
  note_give_ups(world(), give_ups, std::max(steps(), give_ups.steps), result.notes);
  result.curves = impl_->said_.curves;
  impl_->measuring_->list_curves(result.curves);
  return result;
}

std::vector<MeasuredValue> Simulation::measures() const { return impl_->figures().measures; }

/// The numbers of a result.
RunResult Simulation::Impl::figures() const {
  RunResult result;
  result.outcome = judgement_.outcome;
  result.simulated_s = time_s();
  for (const auto& robot : robots_) {
    result.robots.push_back({robot->description().id, robot->description().team,
                             robot->tally().distance_m, robot->tally().collected,
                             robot->state().energy, robot->truth().pose, robot->tally().collisions,
                             robot->talk()});
  }
  measure_every_run(result, departed_);
  measuring_->report({result.outcome, result.simulated_s}, result.measures);
  return result;
}

const world::World& Simulation::world() const { return impl_->world_; }
bool Simulation::has_edits() const { return impl_->start_ || !impl_->given_.empty(); }
world::World Simulation::start() const {
  world::World start = impl_->start_ ? *impl_->start_ : impl_->world_;
  for (const TimedEdit& given : impl_->given_) {
    const auto& [path, value] = given.edit;
    world::TimedEdit& edit = start.edits.emplace_back(world::TimedEdit{given.time_s, path, {}, {}});
    (value.starts_with('<') ? edit.element : edit.value) = value;
  }
  return start;
}
std::uint64_t Simulation::seed() const { return impl_->seed_; }
double Simulation::time_s() const { return impl_->time_s(); }
double Simulation::time_limit_s() const { return impl_->time_limit_s_; }
std::uint64_t Simulation::steps() const { return impl_->steps_; }
bool Simulation::decided() const { return impl_->decided_; }
double Simulation::step_began_s() const { return impl_->step_began_s_; }
Outcome Simulation::outcome() const { return impl_->judgement_.outcome; }
std::uint64_t Simulation::state_hash() const {
  base::Fnv1a hash(impl_->engine_->hash_state());
  for (const auto& robot : impl_->robots_) {
    hash.add(robot->state().energy);
  }
  for (const auto& robot : impl_->robots_) robot->add_messages(hash);
  impl_->fields_->add_to(hash);
  return hash.value();
}
std::span<const Note> Simulation::notes() const { return impl_->said_.notes; }
std::span<const EventRecord> Simulation::events() const { return impl_->events_; }

std::size_t Simulation::robots() const { return impl_->robots_.size(); }
RobotView Simulation::robot(std::size_t index) const {
  const Robot& robot = *impl_->robots_[index];
  RobotView view{&robot.description(),     &robot.state(), robot.truth().pose,
                 robot.truth().moving,     robot.asked(),  robot.command(),
                 robot.members(),          robot.trace(),  robot.tally().distance_m,
                 robot.tally().collisions, robot.empty(),  robot.joints()};
  view.talk = robot.talk();
  return view;
}
std::size_t Simulation::sensors(std::size_t robot) const {
  return impl_->robots_[robot]->sensor_count();
}
SensorView Simulation::sensor(std::size_t robot, std::size_t index) const {
  return impl_->robots_[robot]->sensor(index);
}
void Simulation::visit_reading(std::size_t robot, std::size_t sensor,
                               const FieldVisit& visit) const {
  impl_->robots_[robot]->visit_reading(sensor, visit);
}
std::size_t Simulation::actuators(std::size_t robot) const {
  return impl_->robots_[robot]->actuator_count();
}
ActuatorView Simulation::actuator(std::size_t robot, std::size_t index) const {
  return impl_->robots_[robot]->actuator_view(index);
}
std::span<const HeardMessage> Simulation::heard(std::size_t robot) const {
  return impl_->robots_[robot]->heard();
}
void Simulation::visit_command(std::size_t robot, std::size_t actuator,
                               const FieldVisit& visit) const {
  impl_->robots_[robot]->visit_command(actuator, visit);
}
void Simulation::visit_published(std::size_t robot, const VisitPublished& visit) const {
  impl_->robots_[robot]->visit_published(visit);
}
void Simulation::visit_published(const VisitPublished& visit) const {
  impl_->measuring_->visit_published(visit);
}
std::vector<PluginSketch> Simulation::sketches(std::size_t robot) const {
  return impl_->robots_[robot]->sketches();
}
std::vector<PluginSketch> Simulation::sketches() const { return impl_->measuring_->sketches(); }
std::vector<LitGraph> Simulation::graphs(std::size_t robot) const {
  return impl_->robots_[robot]->graphs();
}
Component& Simulation::object(std::size_t robot, const world::PluginUse& use) {
  return impl_->robots_[robot]->object(use);
}
void Simulation::set_priority(std::size_t robot, std::size_t behavior, double priority) {
  impl_->robots_[robot]->set_priority(behavior, priority);
}
std::vector<MadeInference> Simulation::inferences(std::size_t robot) const {
  return impl_->robots_[robot]->inferences();
}
Frame Simulation::sensor_frame(std::size_t robot, std::size_t index) const {
  return impl_->robots_[robot]->sensor_frame(index);
}
std::size_t Simulation::segments(std::size_t robot) const {
  return impl_->engine_->segments(robot);
}
SegmentView Simulation::segment(std::size_t robot, std::size_t index) const {
  const physics::SegmentState state = impl_->engine_->segment(robot, index);
  const auto& own = world().robots[robot].segments;
  const std::size_t of_drive = segments(robot) - own.size();
  return {index < of_drive ? nullptr : &own[index - of_drive], state.frame, state.pose,
          state.yaw_rad, state.pitch_rad};
}
std::size_t Simulation::fields() const { return impl_->fields_->size(); }
FieldView Simulation::field(std::size_t index) const {
  const RunningField& field = (*impl_->fields_)[index];
  return {&world().fields[index], field.cells(), field.grid(), field.scale()};
}
std::optional<Pose> Simulation::obstacle(std::size_t index) const {
  if (!impl_->engine_->has_obstacle(index)) return std::nullopt;
  const Frame frame = impl_->engine_->obstacle(index);
  return Pose{frame.origin.x, frame.origin.y, std::atan2(frame.forward.y, frame.forward.x)};
}

}  // namespace elsie::simulation
