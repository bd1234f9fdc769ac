// One step: sense, decide, move; then what follows from where the robots are.
#include <cmath>
#include <cstdint>

#include "elsie/physics/failure.h"

#include "simulation_impl.h"

namespace elsie::simulation {

void Simulation::Impl::step(const Simulation& self) {
  const double h = world_.physics.step;
  const auto control_steps = static_cast<std::uint64_t>(world_.physics.control_steps);
  const bool decides = is_control_instant();
  step_began_s_ = time_s();
  obey_rules();
  if (!measuring_->has_begun(PluginKind::measure)) {
    look(false, true);
    measuring_->observe(true);
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
      const Pose& pose = robot.truth().pose;
      robot.charge(period, charger_rate(world_, robot.description().team, {pose.x, pose.y}));
    }
    robot.take_log(time_s(), events_);
    attention_[i] = false;
  }
  const bool was_running = judgement_.outcome == Outcome::running;
  if (was_running) {
    judgement_ = judge(self, goal_progress_);
  }
  if (!measuring_->empty()) {
    look(decides, false);
    measuring_->observe(false);
    if (measuring_->has_rules()) ask_rules(was_running, false);
  }
}

void Simulation::Impl::control(double period_s) {
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
  double loudest_m = 0.0;
  if (has_actuators_) {
    for (const auto& robot : robots_) loudest_m = std::max(loudest_m, robot->loudest_m());
  }
  // The other robots perceive what a robot decides and does now only in the next step.
  loop_.each(robots_, [&](std::size_t i, std::size_t thread) {
    Robot& robot = *robots_[i];
    if (i + 2 < robots_.size()) {  // their memory comes while this one decides
      robots_[i + 2]->fetch(false);
      robots_[i + 1]->fetch(true);
    }
    const RobotSurroundings surroundings(*engine_, *things_, *fields_, robots_, *neighbours_, i,
                                         memory_[thread]);
    robot.sense(surroundings, now);
    if (robot.actuator_count() > 0 || !robot.heard().empty()) {
      robot.listen(surroundings, loudest_m, now);
    }
    update_team(i, memory_[thread].near);
    robot.decide(now);
    if (robot.actuator_count() > 0) robot.act(now, *fields_);
    robot.use_energy(period_s);
    engine_->set_joints(i, robot.wanted_joints());
    attention_[i] = robot.needs_attention();
  });
  if (has_actuators_) hands_.act(world_, robots_, engine_);
  for (std::size_t i = 0; has_actuators_ && i < robots_.size(); ++i) {
    robots_[i]->show_effects(now.time_s + period_s);
    robots_[i]->deposit_into(*fields_);
    attention_[i] = robots_[i]->needs_attention();
  }
  fields_->advance(period_s);
}

void Simulation::Impl::look(bool decided, bool is_start) {
  const std::uint64_t last_step = steps_ > 0 ? steps_ - 1 : 0;
  // At a start nothing has happened yet; what raised events before is seen after the first step.
  const auto events =
      std::span<const EventRecord>(events_).subspan(is_start ? events_.size() : looked_at_);
  measuring_->look(robots_, *engine_, *fields_, events, time_s(), last_step, decided, is_start);
  if (!is_start) looked_at_ = events_.size();
}

void Simulation::Impl::ask_rules(bool was_running, bool is_start) {
  RuleAnswers answers(world_, *engine_, robots_);
  measuring_->apply(answers, is_start);
  for (RuleEdits& edits : answers.edits()) by_rules_.push_back(std::move(edits));
  if (answers.has_raised()) log_events();
  if (was_running) answers.decide(judgement_);
}

void Simulation::Impl::move(bool decides) {
  if (!decides) set_joints();
  drive_boxes();
  try {
    engine_->step();
  } catch (const physics::PhysicsFailure& failure) {
    throw fault_of(world_, failure.failure, steps_);
  }
  ++steps_;
  loop_.each(robots_, [&](std::size_t i, std::size_t) {
    Robot& robot = *robots_[i];
    robot.moved(engine_->robot(i), engine_->joints(i), time_s(), world_.physics.step);
    robot.take_segments(*engine_, i);
    if (robot.feels_contacts()) robot.touched(engine_->contacts(i));
  });
}

void Simulation::Impl::update_team(std::size_t index, std::vector<base::Grid::Id>& memory) {
  Robot& robot = *robots_[index];
  const Pose& pose = robot.truth().pose;
  robot.mates().clear();
  robot.team().charger = nearest_charger(world_, robot.description().team, {pose.x, pose.y});
  robot.team().nest = nearest_nest(world_, robot.description().team, {pose.x, pose.y});
  if (!(farthest_call_m_ > 0.0)) return;
  // A mate is perceived if the mate's own coverage reaches this robot.
  for (const std::size_t i : neighbours_->near({pose.x, pose.y}, farthest_call_m_, memory)) {
    const Pose& other = robots_[i]->truth().pose;
    // A rough test first, because most are too far away.
    const double reach = robots_[i]->state().coverage_m;
    if (i != index && std::abs(other.x - pose.x) <= reach && std::abs(other.y - pose.y) <= reach &&
        robots_[i]->team().name == robot.team().name && distance(pose, other) <= reach) {
      robot.mates().push_back(believed_by(*robots_[index], *robots_[i]));
    }
  }
}

void Simulation::Impl::drive_boxes() {
  const double h = world_.physics.step;
  for (const MovingObstacle& obstacle : moving_) {
    const double since_s = time_s() - obstacle.since_s;
    const Vector2 from = obstacle.path.position(since_s);
    const Vector2 to = obstacle.path.position(since_s + h);
    engine_->drive_obstacle(obstacle.index, to, {(to.x - from.x) / h, (to.y - from.y) / h});
  }
}

}  // namespace elsie::simulation
