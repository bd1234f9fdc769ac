// The parts of a simulation and the order of work in a step. The run from start to end and the
// functions of the public interface are in simulation.cpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "elsie/physics/engine.h"
#include "elsie/simulation/simulation.h"
#include "elsie/world/error.h"
#include "elsie/world/parts.h"
#include "elsie/world/reader.h"

#include "changes/becoming.h"
#include "changes/changes.h"
#include "measuring/measuring.h"
#include "physics_words.h"
#include "replacement/swap.h"
#include "step/box_path.h"
#include "step/cameras.h"
#include "step/carrier.h"
#include "step/goals.h"
#include "step/neighbours.h"
#include "step/robot_loop.h"
#include "step/teams.h"
#include "step/touches.h"

namespace elsie::simulation {

class Simulation::Impl {
 public:
  Impl(world::World world, const plugin::Host& host, const Options& options)
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
    changes_.emplace(world_, host, options_);
    std::vector<base::Problem> problems;
    Commons commons(world_);
    for (std::size_t i = 0; i < world_.robots.size(); ++i) {
      try {
        // Not shared any more, before the object refers to it.
        world::Robot* const own = world_.robots[i].drive ? &own_world_.robots[i] : nullptr;
        robots_.push_back(std::make_shared<Robot>(world_, i, commons, host, options));
        if (own) own->driven = robots_.back()->take_driven();
      } catch (const world::WorldError& error) {
        problems.insert(problems.end(), error.problems().begin(), error.problems().end());
      }
    }
    measuring_ = std::make_shared<Measuring>(world_, host, options.budget, problems);
    if (problems.empty()) {
      cameras_ = std::make_shared<Cameras>(world_, robots_, options.cameras, problems);
    }
    if (!problems.empty()) {
      throw world::WorldError(std::move(problems));
    }
  }

  void reset(std::uint64_t seed) {
    seed_ = seed;
    steps_ = base_steps_ = 0;
    decided_ = false;
    step_began_s_ = 0.0;
    base_time_s_ = 0.0;
    // A new engine, so that ODE keeps no state of the last run.
    engine_ = physics::make_engine(world_.arena, world_.physics);
    engine_->work_with(loop_.crew());
    goal_starts_.assign(world_.goals.size(), {});
    moving_.clear();
    for (std::size_t i = 0; i < world_.boxes.size(); ++i) {
      add_box(i);
    }
    add_charger_boxes();
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      const world::Robot& d = world_.robots[i];
      engine_->add_robot(world::plan_of(d), {d.x, d.y, wrap_angle(radians(d.heading_deg))}, d.z);
      robots_[i]->reset(seed);
      robots_[i]->set_body(engine_->robot(i), engine_->joints(i));
    }
    take_stock();
    wall_s_ = 0.0;
    judgement_ = {};
    touches_ = {};
    events_.clear();
    given_.clear();
    log_events();
    said_ = {};
    note_warnings(world_, said_.notes);
    for (const auto& robot : robots_) {
      robot->ask(said_);
    }
    measuring_->reset(seed);
    measuring_->ask(said_);
  }

  void step(const Simulation& self) {
    const double h = world_.physics.step;
    const auto control_steps = static_cast<std::uint64_t>(world_.physics.control_steps);
    const bool decides = is_control_instant();
    step_began_s_ = time_s();
    if (!measuring_->has_begun()) {
      observe(false, true);
    }
    const double period = h * static_cast<double>(control_steps);
    try {
      if (decides) {
        control(period);
      }
      move(decides);
    } catch (...) {
      // Robots after the failed one may have raised events in other threads.
      const std::size_t failed = loop_.failed_at();
      log_events(failed == RobotLoop::kNone ? robots_.size() : failed + 1);
      throw;
    }
    decided_ = decides;
    touches_.handle(world_, robots_, *engine_, time_s());
    for (const physics::Touch& touch : engine_->touches()) {
      for (const physics::Body& body : {touch.a, touch.b}) {
        if (body.kind == physics::BodyKind::robot) attention_[body.index] = true;
      }
    }
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      if (!attention_[i]) continue;
      Robot& robot = *robots_[i];
      if (decides) {
        const Pose& pose = robot.state().pose;
        robot.charge(period, charger_rate(world_, robot.description().team, {pose.x, pose.y}));
      }
      robot.take_log(time_s(), events_);
      attention_[i] = false;
    }
    if (judgement_.outcome == Outcome::running) {
      judgement_ = judge(self, goal_starts_);
    }
    if (!measuring_->empty()) {
      observe(decides, false);
    }
  }

  void change(std::span<const Change> changes);
  void change(const DueChanges& due) {
    try {
      change(due.changes);
    } catch (const ChangeRefused& refused) {
      throw refused.at(due.time_s, due.from);
    }
  }
  /// The changes that are made, in their order; `unmade` gets the others. `given`: the changes that
  /// are not the world's own. Throws ChangeRefused.
  std::vector<DueChanges> checked(std::span<const TimedChange> changes,
                                  std::span<const TimedChange> given,
                                  std::vector<UnmadeChanges>& unmade);

  Replacement replace_plugins(const plugin::Host& host) {
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      own_robot(i);  // its description is adapted
    }
    Swap swap(host, seed_, options_.data_directories);
    for (const auto& robot : robots_) {
      robot->replace(swap, *cameras_);
    }
    if (start_) start_ = std::make_shared<const world::World>(swap.adapted(*start_));
    Replacement replacement = swap.settle();
    changes_.emplace(world_, host, options_);
    host_ = &host;
    measuring_->list_replaced(host, replacement.notes);
    for (const Replacement::Object& object : replacement.objects) {
      events_.push_back({time_s(), object.robot, events::Replaced{object.path, object.plugin}});
    }
    ++renewals_;
    take_stock();
    return replacement;
  }

  double time_s() const {
    return base_time_s_ + static_cast<double>(steps_ - base_steps_) * world_.physics.step;
  }
  /// Returns whether robots sense and decide in the next step.
  bool is_control_instant() const {
    return (steps_ - base_steps_) % static_cast<std::uint64_t>(world_.physics.control_steps) == 0;
  }

  RunResult figures() const;

  world::World own_world_;
  const world::World& world_ = own_world_;  // reading must not copy robots that others share
  double time_limit_s_;
  std::uint64_t seed_;
  const plugin::Host* host_;
  Options options_;
  std::shared_ptr<const world::World> start_;  // null: the world is unchanged since the start
  std::vector<std::shared_ptr<Robot>> robots_;
  std::shared_ptr<physics::Engine> engine_;
  std::uint64_t steps_ = 0;
  bool decided_ = false;  // in the last step
  double step_began_s_ = 0.0;
  double wall_s_ = 0.0;
  Judgement judgement_;
  std::vector<EventRecord> events_;
  std::vector<TimedChange> given_;  // to run()
  Statements said_;                 // notes and curves so far
  std::shared_ptr<Measuring> measuring_;
  Tally departed_;                 // sums of robots that an edit removed
  std::uint64_t renewals_ = 0;     // how often objects were replaced or recreated
  std::uint64_t own_changes_ = 0;  // how often World::changes was edited

 private:
  struct MovingBox {
    std::size_t index;
    BoxPath path;
    double since_s;  // start of its motion
  };

  // Edits: see changes/edits.cpp and become_world.cpp.
  class Pairs;
  void set_in_place(std::span<const Change> edits);
  void own_robot(std::size_t index);
  void become(std::span<const Change> edits, Becoming& becoming);
  void become(world::World next, Becoming& becoming);
  void become_robots(const Pairs& pairs, Becoming& becoming);
  void become_changes(const world::World& was);
  void become_measures(const world::World& was, Becoming& becoming);
  std::vector<std::size_t> become_bodies(const Pairs& pairs, Becoming& becoming);
  void check_room(const world::World& was, std::span<const std::size_t> new_robots) const;
  world::World tried(const world::World& from, std::span<const Change> edits);
  world::World edited(const world::World& from, std::span<const Change> edits, bool check_plugins);
  void become_goals(const world::World& was);
  void settle(Becoming& becoming);

  void add_box(std::size_t i) {
    engine_->add_box(world_.boxes[i]);
    if (world_.boxes[i].kind == world::BoxKind::moving) {
      moving_.push_back({i, BoxPath(world_.boxes[i]), time_s()});
    }
  }
  void add_charger_boxes() {
    for (const world::Charger& charger : world_.chargers) {
      if (charger.seen_by_range_sensors) {
        world::Box box;
        box.x = charger.x;
        box.y = charger.y;
        box.length = box.width = box.height = world::Charger::kBoxEdge;
        engine_->add_box(box);
      }
    }
  }

  Changes::Stage stage() { return {robots_, *engine_, *cameras_, time_s()}; }

  /// All robots sense and decide at the same instant.
  void control(double period_s) {
    const Instant now{time_s(), period_s, steps_};
    cameras_->take(*engine_);
    neighbours_->begin(robots_, options_.budget.memory > 0);
    if (!knows_calls_) {
      farthest_call_m_ = 0.0;
      for (const auto& robot : robots_) {
        farthest_call_m_ = std::max(farthest_call_m_, robot->state().coverage_m);
      }
      knows_calls_ = true;
    }
    // The other robots perceive what a robot decides now only in the next step.
    loop_.each(robots_, [&](std::size_t i, std::size_t thread) {
      Robot& robot = *robots_[i];
      robot.sense(Carrier(*engine_, robots_, *neighbours_, i, memory_[thread]), now);
      update_team(i, memory_[thread].near);
      robot.decide(now);
      robot.use_energy(period_s);
      engine_->set_joints(i, robot.wanted_joints());
      attention_[i] = robot.needs_attention();
    });
  }

  /// `is_start`: only measures that have not begun observe. See Measuring::observe().
  void observe(bool decided, bool is_start) {
    const std::uint64_t last_step = steps_ > 0 ? steps_ - 1 : 0;
    measuring_->observe(robots_, *engine_, time_s(), last_step, decided, is_start);
  }

  /// A step of the physics.
  void move(bool decides) {
    if (!decides) set_joints();
    drive_boxes();
    try {
      engine_->step();
    } catch (const physics::PhysicsFailure& failure) {
      throw fault_of(world_, failure.failure, steps_);
    }
    ++steps_;
    loop_.each(robots_, [&](std::size_t i, std::size_t) {
      robots_[i]->moved(engine_->robot(i), engine_->joints(i));
    });
  }

  /// Must be called after anything but a step has changed robots.
  void take_stock() {
    attention_.assign(robots_.size(), true);
    knows_calls_ = false;
  }

  void set_joints() {
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      engine_->set_joints(i, robots_[i]->wanted_joints());
    }
  }

  void log_events() { log_events(robots_.size()); }
  /// Logs the events of the first robots only.
  void log_events(std::size_t robots) {
    for (std::size_t i = 0; i < robots; ++i) {
      robots_[i]->take_log(time_s(), events_);
    }
  }

  void update_team(std::size_t index, std::vector<space::Grid::Id>& memory) {
    Robot& robot = *robots_[index];
    const Pose& pose = robot.state().pose;
    robot.mates().clear();
    robot.team().charger = nearest_charger(world_, robot.description().team, {pose.x, pose.y});
    if (!(farthest_call_m_ > 0.0)) return;
    // A mate is perceived if the mate's own coverage reaches this robot.
    for (const std::size_t i : neighbours_->near({pose.x, pose.y}, farthest_call_m_, memory)) {
      const Pose& other = robots_[i]->state().pose;
      // A rough test first, because most are too far away.
      const double reach = robots_[i]->state().coverage_m;
      if (i != index && std::abs(other.x - pose.x) <= reach &&
          std::abs(other.y - pose.y) <= reach && robots_[i]->team().name == robot.team().name &&
          distance(pose, other) <= reach) {
        robot.mates().push_back(seen_from(robots_, index, i));
      }
    }
  }

  void drive_boxes() {
    const double h = world_.physics.step;
    for (const MovingBox& box : moving_) {
      const double since_s = time_s() - box.since_s;
      const Vector2 from = box.path.position(since_s);
      const Vector2 to = box.path.position(since_s + h);
      engine_->drive_box(box.index, to, {(to.x - from.x) / h, (to.y - from.y) / h});
    }
  }

  std::shared_ptr<Cameras> cameras_;
  std::optional<Changes> changes_;
  // Worlds and robots that were changed: kept, because views of their texts may still exist.
  std::vector<std::shared_ptr<const void>> past_;
  // The last change of the length of a step or of a control period.
  std::uint64_t base_steps_ = 0;
  double base_time_s_ = 0.0;
  std::vector<MovingBox> moving_;
  std::vector<GoalStart> goal_starts_;  // of the world's goals
  RobotLoop loop_;
  std::vector<SensingMemory> memory_;  // of each thread
  Touches touches_;
  std::optional<Neighbours> neighbours_{std::in_place,
                                        world_.arena};  // positions at the last control step
  double farthest_call_m_ = 0.0;                        // the largest coverage of a robot
  bool knows_calls_ = false;                            // false: a coverage may have changed
  std::vector<char> attention_;  // of robots: may have events for the log, or be charging
};

}  // namespace elsie::simulation
