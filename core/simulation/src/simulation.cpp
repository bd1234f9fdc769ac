#include "elsie/simulation/simulation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <map>
#include <utility>

#include "elsie/physics/engine.h"
#include "elsie/simulation/sampling.h"
#include "elsie/world/error.h"

#include "box_path.h"
#include "cameras.h"
#include "carrier.h"
#include "changes.h"
#include "goals.h"
#include "measuring.h"
#include "swap.h"
#include "teams.h"

namespace elsie::simulation {
namespace {

/// Bodies that touch again within this time are still the same collision.
constexpr double kSameCollision = 0.2;  // s

/// FNV-1a, as physics::Engine::hash_state() continues it.
std::uint64_t hash_of(std::uint64_t hash, double value) {
  std::uint64_t bits = 0;
  static_assert(sizeof(bits) == sizeof(value));
  __builtin_memcpy(&bits, &value, sizeof(bits));
  for (int shift = 0; shift < 64; shift += 8) {
    hash = (hash ^ ((bits >> shift) & 0xff)) * 0x100000001b3ULL;
  }
  return hash;
}

/// An attribute of the robot of this index, as change.h speaks of it. What the path says of the
/// robot is its number in the file, so that it need not have an id of its own.
Change change_of(std::size_t robot, const char* attribute, const ParameterValue& value) {
  return {"robot[" + std::to_string(robot + 1) + "]/@" + attribute, world::text_of(value)};
}

RunEnd::Outcome to_run_end(Outcome outcome) {
  switch (outcome) {
    case Outcome::success:
      return RunEnd::Outcome::success;
    case Outcome::failure:
      return RunEnd::Outcome::failure;
    case Outcome::time_limit:
      return RunEnd::Outcome::time_limit;
    case Outcome::running:
      break;
  }
  return RunEnd::Outcome::running;
}

}  // namespace

const char* to_string(Outcome outcome) {
  switch (outcome) {
    case Outcome::success:
      return "success";
    case Outcome::failure:
      return "failure";
    case Outcome::time_limit:
      return "time_limit";
    case Outcome::running:
      break;
  }
  return "running";
}

std::string hash_text(std::uint64_t state_hash) {
  char digits[17];
  std::snprintf(digits, sizeof(digits), "%016llx", static_cast<unsigned long long>(state_hash));
  return digits;
}

class Simulation::Impl {
 public:
  Impl(world::World world, const plugin::Host& host, const Options& options)
      : world_(std::move(world)),
        time_limit_s_(options.time_limit_s.value_or(world_.limits.time)),
        seed_(options.seed),
        data_directories_(options.data_directories) {
    changes_.emplace(world_, host, data_directories_);
    std::vector<world::Problem> problems;
    for (std::size_t i = 0; i < world_.robots.size(); ++i) {
      try {
        robots_.push_back(
            std::make_unique<Robot>(world_.robots[i], Robot::membership(world_, i), host, options));
      } catch (const world::WorldError& error) {
        problems.insert(problems.end(), error.problems().begin(), error.problems().end());
      }
    }
    measuring_ = std::make_unique<Measuring>(world_, host, options.budget, problems);
    if (problems.empty()) {
      cameras_.emplace(world_, robots_, problems);
    }
    if (!problems.empty()) {
      throw world::WorldError(std::move(problems));
    }
    for (std::size_t i = 0; i < world_.boxes.size(); ++i) {
      if (world_.boxes[i].kind == world::BoxKind::moving) {
        moving_.push_back({i, BoxPath(world_.boxes[i])});
      }
    }
  }

  void reset(std::uint64_t seed) {
    seed_ = seed;
    // A new engine: ODE keeps nothing from the last run then.
    engine_ = physics::make_ode_engine(world_.arena, world_.physics);
    for (const world::Box& box : world_.boxes) {
      engine_->add_box(box);
    }
    for (const world::Charger& charger : world_.chargers) {
      if (charger.seen_by_range_sensors) {
        world::Box box;
        box.x = charger.x;
        box.y = charger.y;
        box.length = box.width = box.height = world::Charger::kBoxEdge;
        engine_->add_box(box);
      }
    }
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      const world::Robot& d = world_.robots[i];
      engine_->add_robot(d.body, {d.x, d.y, wrap_angle(radians(d.heading_deg))}, d.z, d.segments);
      robots_[i]->reset(seed);
      robots_[i]->set_body(engine_->robot(i));
    }
    steps_ = 0;
    wall_s_ = 0.0;
    verdict_ = {};
    last_touch_.clear();
    events_.clear();
    log_events();
    notes_.clear();
    curves_.clear();
    for (const auto& robot : robots_) {
      robot->list_notes(notes_);
      robot->list_curves(curves_);
    }
    measuring_->reset(seed);
    measuring_->list_notes(notes_);
    measuring_->list_curves(curves_);
  }

  void step(const Simulation& self) {
    const double h = world_.physics.step;
    const auto control_steps = static_cast<std::uint64_t>(world_.physics.control_steps);
    const bool decides = steps_ % control_steps == 0;
    if (!measuring_->empty() && !measuring_->has_begun()) {
      observe(false);
    }
    const double period = h * static_cast<double>(control_steps);
    try {
      if (decides) {
        control(period);
      }
      move();
    } catch (...) {
      log_events();
      throw;
    }
    handle_touches();
    if (decides) {
      for (const auto& robot : robots_) {
        const Pose& pose = robot->state().pose;
        robot->charge(period, charger_rate(world_, robot->description().team, {pose.x, pose.y}));
      }
    }
    log_events();
    if (verdict_.outcome == Outcome::running) {
      verdict_ = judge(self);
    }
    if (!measuring_->empty()) {
      observe(decides);
    }
  }

  void change(std::span<const Change> changes) {
    changes_->make(changes, stage(), events_);
    log_events();
  }
  void change(const DueChanges& due) {
    try {
      change(due.changes);
    } catch (const ChangeRefused& refused) {
      throw refused.at(due.time_s);
    }
  }
  std::vector<DueChanges> checked(std::span<const TimedChange> changes) {
    std::vector<DueChanges> schedule = by_step(changes, world_.physics.step, time_limit_s_);
    changes_->check(schedule, stage());
    return schedule;
  }

  Replacement replace_plugins(const plugin::Host& host) {
    Swap swap(host, seed_, data_directories_);
    for (const auto& robot : robots_) {
      robot->replace(swap, *cameras_);
    }
    swap.settle([this](const std::string& id) -> Tuning& {
      return (*std::find_if(robots_.begin(), robots_.end(),
                            [&](const auto& robot) { return robot->description().id == id; }))
          ->tuning();
    });
    changes_.emplace(world_, host, data_directories_);
    Replacement replacement = swap.result();
    measuring_->list_replaced(host, replacement.notes);
    for (const Replacement::Object& object : replacement.objects) {
      events_.push_back({time_s(), object.robot, "replaced", object.path + ": " + object.plugin});
    }
    ++replacements_;
    return replacement;
  }

  void stop(Outcome outcome, std::string reason) { verdict_ = {outcome, std::move(reason)}; }

  double time_s() const { return static_cast<double>(steps_) * world_.physics.step; }

  std::uint64_t state_hash() const {
    std::uint64_t hash = engine_->hash_state();
    for (const auto& robot : robots_) {
      hash = hash_of(hash, robot->state().energy);
    }
    return hash;
  }

  SegmentView segment(std::size_t robot, std::size_t index) const {
    const physics::SegmentState state = engine_->segment(robot, index);
    return {&world_.robots[robot].segments[index], state.frame, state.pose, state.yaw_rad,
            state.pitch_rad};
  }

  std::optional<Pose> box(std::size_t index) const {
    if (!engine_->has_box(index)) {
      return std::nullopt;
    }
    const Frame frame = engine_->box(index);
    return Pose{frame.origin.x, frame.origin.y, std::atan2(frame.forward.y, frame.forward.x)};
  }

  world::World world_;
  double time_limit_s_;
  std::uint64_t seed_;
  std::vector<std::unique_ptr<Robot>> robots_;
  std::uint64_t steps_ = 0;
  double wall_s_ = 0.0;
  Verdict verdict_;
  std::vector<EventRecord> events_;
  std::vector<Note> notes_;
  std::vector<LearningCurve> curves_;
  std::unique_ptr<Measuring> measuring_;
  std::uint64_t replacements_ = 0;

 private:
  struct MovingBox {
    std::size_t index;
    BoxPath path;
  };

  Changes::Stage stage() { return {robots_, *engine_, *cameras_, time_s()}; }

  /// Sense and decide, all robots from the same instant.
  void control(double period_s) {
    const Instant now{time_s(), period_s, steps_};
    cameras_->take(*engine_);
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      robots_[i]->sense(Carrier(*engine_, robots_, i), now);
      update_team(i);
    }
    for (const auto& robot : robots_) {
      robot->decide(now);
    }
    for (const auto& robot : robots_) {
      robot->use_energy(period_s);
    }
  }

  /// `decided`: in the step just made, if there was one.
  void observe(bool decided) {
    measuring_->observe(robots_, *engine_, time_s(), steps_ > 0 ? steps_ - 1 : 0, decided);
  }

  /// Motors, physics.
  void move() {
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      engine_->set_wheel_rates(i, robots_[i]->command());
    }
    drive_boxes();
    engine_->step();
    ++steps_;
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      robots_[i]->moved(engine_->robot(i));
    }
  }

  void log_events() {
    for (const auto& robot : robots_) {
      robot->take_log(time_s(), events_);
    }
  }

  void update_team(std::size_t index) {
    Robot& robot = *robots_[index];
    const Pose& pose = robot.state().pose;
    robot.mates().clear();
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      const Pose& other = robots_[i]->state().pose;
      // Who is heard is a matter of how far the other one calls. The rough test first: most are too
      // far away.
      const double reach = robots_[i]->state().coverage_m;
      if (i != index && std::abs(other.x - pose.x) <= reach &&
          std::abs(other.y - pose.y) <= reach && robots_[i]->team().name == robot.team().name &&
          distance(pose, other) <= reach) {
        robot.mates().push_back(seen_from(robots_, index, i));
      }
    }
    robot.team().charger = nearest_charger(world_, robot.description().team, {pose.x, pose.y});
  }

  void drive_boxes() {
    const double h = world_.physics.step;
    for (const MovingBox& box : moving_) {
      const Vector2 from = box.path.position(time_s());
      const Vector2 to = box.path.position(time_s() + h);
      engine_->drive_box(box.index, to, {(to.x - from.x) / h, (to.y - from.y) / h});
    }
  }

  void handle_touches() {
    for (const physics::Touch& touch : engine_->touches()) {
      if (touch.a.kind == physics::BodyKind::robot) {
        if (!collects(touch)) {
          collide(touch);
        }
      }
    }
  }

  /// Whether the touch is a robot's with a resource that it may take; then it does.
  bool collects(const physics::Touch& touch) {
    if (touch.b.kind != physics::BodyKind::box || touch.b.index >= world_.boxes.size()) {
      return false;
    }
    const world::Box& box = world_.boxes[touch.b.index];
    Robot& robot = *robots_[touch.a.index];
    if (!may_collect(robot.description().team, box)) {
      return false;
    }
    if (engine_->has_box(touch.b.index)) {  // else another robot took it in the same step
      engine_->remove_box(touch.b.index);
      robot.collect(box.energy);
      robot.raise("collected", box.id);
    }
    return true;
  }

  void collide(const physics::Touch& touch) {
    const auto [entry, is_new] = last_touch_.try_emplace({touch.a, touch.b}, time_s());
    if (is_new || time_s() - entry->second > kSameCollision) {
      robots_[touch.a.index]->count_collision();
      robots_[touch.a.index]->raise("collision", name_of(touch.b));
      if (touch.b.kind == physics::BodyKind::robot) {
        robots_[touch.b.index]->count_collision();
        robots_[touch.b.index]->raise("collision", name_of(touch.a));
      }
    }
    entry->second = time_s();
  }

  std::string name_of(const physics::Body& body) const {
    switch (body.kind) {
      case physics::BodyKind::robot:
        return world_.robots[body.index].id;
      case physics::BodyKind::box:
        return body.index < world_.boxes.size() ? world_.boxes[body.index].id : "charger";
      case physics::BodyKind::wall:
        break;
    }
    return "wall";
  }

  std::unique_ptr<physics::Engine> engine_;
  std::optional<Cameras> cameras_;
  std::vector<std::string> data_directories_;
  std::optional<Changes> changes_;
  std::vector<MovingBox> moving_;
  std::map<std::pair<physics::Body, physics::Body>, double> last_touch_;
};

Simulation::Simulation(world::World world, const plugin::Host& host, const Options& options)
    : impl_(std::make_unique<Impl>(std::move(world), host, options)) {
  impl_->reset(options.seed);
}

Simulation::Simulation(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

void Simulation::reset(std::optional<std::uint64_t> seed) {
  impl_->reset(seed.value_or(impl_->seed_));
}

void Simulation::step() { impl_->step(*this); }

RunResult Simulation::run(std::span<Observer* const> observers,
                          std::span<const TimedChange> changes,
                          const std::function<void(Simulation&)>& before_control) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const auto wall = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  const auto& limits = world().limits;
  const std::vector<DueChanges> schedule = impl_->checked(changes);
  auto next = schedule.begin();
  const auto change_what_is_due = [&] {
    for (; next != schedule.end() && next->step <= steps(); ++next) {
      impl_->change(*next);
    }
  };
  const auto control_steps = static_cast<std::uint64_t>(world().physics.control_steps);
  const auto let_user_act = [&] {
    const std::uint64_t before = impl_->replacements_;
    before_control(*this);
    for (Observer* observer : observers) {
      if (impl_->replacements_ != before) {
        observer->replaced(*this);
      }
    }
  };
  std::size_t watching = 0;  // observers that heard of the start, and will hear of the end
  std::exception_ptr failure;
  try {
    change_what_is_due();
    for (Observer* observer : observers) {
      observer->started(*this);
      ++watching;
    }
    while (outcome() == Outcome::running) {
      change_what_is_due();
      if (before_control && steps() % control_steps == 0) {
        let_user_act();
      }
      step();
      for (Observer* observer : observers) {
        observer->stepped(*this);
      }
      if (limits.wall_time && wall() >= *limits.wall_time && outcome() == Outcome::running) {
        impl_->stop(Outcome::time_limit, "the limit of time on the clock was met");
      }
    }
  } catch (...) {
    failure = std::current_exception();
  }
  impl_->wall_s_ = wall();
  for (Observer* observer : observers.first(watching)) {
    try {
      observer->ended(*this);
    } catch (...) {
      failure = failure ? failure : std::current_exception();  // the first one counts
    }
  }
  if (failure) {
    std::rethrow_exception(failure);
  }
  return result();
}

void Simulation::check(std::span<const TimedChange> changes) const { impl_->checked(changes); }

void Simulation::change(std::string_view path, std::string_view value) {
  const Change one{std::string(path), std::string(value)};
  impl_->change({&one, 1});
}
void Simulation::change(std::span<const Change> changes) { impl_->change(changes); }

void Simulation::place_robot(std::size_t robot, const Pose& pose, double z) {
  const Change place[] = {change_of(robot, "x", pose.x), change_of(robot, "y", pose.y),
                          change_of(robot, "z", z),
                          change_of(robot, "heading_deg", degrees(pose.heading_rad))};
  impl_->change(place);
}
void Simulation::set_max_speed(std::size_t robot, double metres_per_second) {
  const Change one = change_of(robot, "max_speed", metres_per_second);
  impl_->change({&one, 1});
}
void Simulation::set_coverage(std::size_t robot, double metres) {
  const Change one = change_of(robot, "coverage", metres);
  impl_->change({&one, 1});
}
void Simulation::set_leader(std::size_t robot, bool leader) {
  const Change one = change_of(robot, "leader", leader);
  impl_->change({&one, 1});
}
Replacement Simulation::replace_plugins(const plugin::Host& host) {
  return impl_->replace_plugins(host);
}

void Simulation::set_energy(std::size_t robot, double units) {
  const Change one = change_of(robot, "energy", units);
  impl_->change({&one, 1});
}

RunResult Simulation::result() const {
  RunResult result;
  result.outcome = outcome();
  result.reason = impl_->verdict_.reason;
  result.seed = impl_->seed_;
  result.simulated_s = time_s();
  result.wall_s = impl_->wall_s_;
  result.steps = steps();
  result.state_hash = state_hash();
  for (const auto& robot : impl_->robots_) {
    result.robots.push_back({robot->description().id, robot->description().team,
                             robot->distance_m(), robot->collected(), robot->state().energy,
                             robot->state().pose, robot->collisions()});
  }
  result.events = impl_->events_;
  result.notes = impl_->notes_;
  result.curves = impl_->curves_;
  measure_every_run(result);
  impl_->measuring_->report({to_run_end(outcome()), time_s()}, result.measures);
  return result;
}

const world::World& Simulation::world() const { return impl_->world_; }
std::uint64_t Simulation::seed() const { return impl_->seed_; }
double Simulation::time_s() const { return impl_->time_s(); }
double Simulation::time_limit_s() const { return impl_->time_limit_s_; }
std::uint64_t Simulation::steps() const { return impl_->steps_; }
Outcome Simulation::outcome() const { return impl_->verdict_.outcome; }
std::uint64_t Simulation::state_hash() const { return impl_->state_hash(); }
std::span<const Note> Simulation::notes() const { return impl_->notes_; }
std::span<const EventRecord> Simulation::events() const { return impl_->events_; }

std::size_t Simulation::robots() const { return impl_->robots_.size(); }
RobotView Simulation::robot(std::size_t index) const {
  const Robot& robot = *impl_->robots_[index];
  return {&robot.description(), &robot.state(),     robot.command(),    robot.members(),
          robot.trace(),        robot.distance_m(), robot.collisions(), robot.empty()};
}
std::size_t Simulation::sensors(std::size_t robot) const {
  return impl_->robots_[robot]->sensor_count();
}
SensorView Simulation::sensor(std::size_t robot, std::size_t index) const {
  return impl_->robots_[robot]->sensor(index);
}
void Simulation::list_values(std::size_t robot, std::size_t sensor,
                             std::vector<NamedValue>& values) const {
  impl_->robots_[robot]->list_values(sensor, values);
}
Frame Simulation::sensor_frame(std::size_t robot, std::size_t index) const {
  return impl_->robots_[robot]->sensor_frame(index);
}
SegmentView Simulation::segment(std::size_t robot, std::size_t index) const {
  return impl_->segment(robot, index);
}
std::optional<Pose> Simulation::box(std::size_t index) const { return impl_->box(index); }

}  // namespace elsie::simulation
