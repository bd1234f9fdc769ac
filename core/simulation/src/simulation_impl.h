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

#include "edits/in_place.h"
#include "edits/transaction.h"
#include "measuring/measuring.h"
#include "physics_words.h"
#include "replacement/swap.h"
#include "robot/common_data.h"
#include "robot/robot_surroundings.h"
#include "step/cameras.h"
#include "step/fields.h"
#include "step/goals.h"
#include "step/hands.h"
#include "step/neighbours.h"
#include "step/robot_loop.h"
#include "step/teams.h"
#include "step/touches.h"
#include "step/waypoint_path.h"

namespace elsie::simulation {

class Simulation::Impl {
 public:
  Impl(world::World world, const plugin::Host& host, const Options& options);

  void reset(std::uint64_t seed);

  void step(const Simulation& self);

  void edit(std::span<const Edit> edits);
  void edit(const DueEdits& due) {
    try {
      edit(due.edits);
    } catch (const EditRefused& refused) {
      throw refused.at(due.time_s, due.from);
    }
  }
  /// The edits that are made, in their order; `unmade` gets the others. `given`: the edits that
  /// are not the world's own. Throws EditRefused.
  std::vector<DueEdits> checked(std::span<const TimedEdit> edits, std::span<const TimedEdit> given,
                                std::vector<UnmadeEdits>& unmade);

  /// Must be called before a step; once or more often.
  void obey_rules();

  Replacement replace_plugins(const plugin::Host& host);

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
  std::shared_ptr<RobotIds> robot_ids_ = std::make_shared<RobotIds>();
  std::shared_ptr<physics::Engine> engine_;
  std::shared_ptr<Fields> fields_;
  std::uint64_t steps_ = 0;
  bool decided_ = false;  // in the last step
  double step_began_s_ = 0.0;
  double wall_s_ = 0.0;
  Judgement judgement_;
  std::vector<EventRecord> events_;
  std::vector<TimedEdit> given_;  // to run()
  Statements said_;               // notes and curves so far
  std::shared_ptr<Measuring> measuring_;
  Tally departed_;                   // sums of robots that an edit removed
  std::uint64_t renewals_ = 0;       // how often objects were replaced or recreated
  std::uint64_t rebuilds_ = 0;       // how often an edit made objects or bodies again
  std::uint64_t new_schedules_ = 0;  // how often World::edits changed

 private:
  struct MovingObstacle {
    std::size_t index;
    WaypointPath path;
    double since_s;  // start of its motion
  };

  // Edits: see the folder edits.
  class Pairs;
  void set_in_place(std::span<const Edit> edits);
  void own_robot(std::size_t index);
  Note no_effect(const std::string& edit) const;
  void become(std::span<const Edit> edits, EditTransaction& transaction);
  void become(world::World next, EditTransaction& transaction);
  void become_robots(const Pairs& pairs, EditTransaction& transaction);
  void become_schedule(const world::World& was);
  void become_measures(const world::World& was, EditTransaction& transaction);
  std::vector<physics::Body> become_bodies(const Pairs& pairs, EditTransaction& transaction);
  void check_room(const world::World& was, std::span<const physics::Body> fresh) const;
  world::World tried(const world::World& from, std::span<const Edit> edits);
  world::World edited(world::WorldTree&& from, std::span<const Edit> edits, bool check_plugins);
  void become_goals(const world::World& was);
  void note_robot_ids() {
    for (const world::Robot& robot : world_.robots) robot_ids_->insert(robot.id);
  }
  void settle(EditTransaction& transaction);

  void add_obstacle(std::size_t i);
  void add_charger_boxes();

  InPlaceEdits::Stage stage() { return {robots_, *engine_, *cameras_, time_s()}; }

  /// All robots sense and decide at the same instant.
  void control(double period_s);

  /// What measures and rules see. `is_start`: before the first step.
  void look(bool decided, bool is_start);
  /// `was_running`: a rule may end the run.
  void ask_rules(bool was_running, bool is_start);

  /// A step of the physics.
  void move(bool decides);

  /// Must be called after anything but a step has changed robots.
  void take_stock() {
    attention_.assign(robots_.size(), true);
    knows_calls_ = false;
    things_.emplace(world_);
    has_actuators_ = false;
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      if (robots_[i]->feels_contacts()) engine_->watch_contacts(i);
      has_actuators_ = has_actuators_ || robots_[i]->actuator_count() > 0;
    }
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

  void update_team(std::size_t index, std::vector<base::Grid::Id>& memory);

  void drive_boxes();

  std::vector<RuleEdits> by_rules_;   // not made yet
  std::size_t looked_at_ = 0;         // how many events measures and rules have seen
  std::uint64_t obeyed_at_ = kNever;  // the step before which rules were obeyed last
  static constexpr std::uint64_t kNever = static_cast<std::uint64_t>(-1);
  std::shared_ptr<Cameras> cameras_;
  std::optional<InPlaceEdits> in_place_;
  // Worlds and robots that were changed: kept, because views of their texts may still exist.
  std::vector<std::shared_ptr<const void>> past_;
  // The last change of the length of a step or of a control period.
  std::uint64_t base_steps_ = 0;
  double base_time_s_ = 0.0;
  std::vector<MovingObstacle> moving_;
  std::vector<GoalProgress> goal_progress_;  // of the single_goals() of the world
  RobotLoop loop_;
  std::vector<SensingMemory> memory_;  // of each thread
  Touches touches_;
  Hands hands_;
  std::optional<world::Things> things_;  // of world_ as it is
  std::optional<Neighbours> neighbours_{std::in_place,
                                        world_.arena};  // positions at the last control step
  double farthest_call_m_ = 0.0;                        // the largest coverage of a robot
  bool knows_calls_ = false;                            // false: a coverage may have changed
  bool has_actuators_ = false;                          // a robot has some
  std::vector<char> attention_;  // of robots: may have events for the log, or be charging
};

}  // namespace elsie::simulation
