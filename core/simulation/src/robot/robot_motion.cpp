// How a robot moves: what its drive is told to do, and where its body and its beliefs then are.
#include <algorithm>
#include <cmath>
#include <string>

#include "robot/robot.h"

namespace elsie::simulation {

void Robot::command(const Motion& asked) {
  asked_ = asked;
  carry_out(asked);
}

void Robot::carry_out(const Motion& motion) {
  const std::span<JointSetting> wanted = std::span(joints_).subspan(joint_count_);
  const auto command = [&] {
    state_.commanded = driver_->command(
        motion, {joints(), state_.max_speed_m_s, period_s_, &drive_->random}, wanted);
  };
  if (has_default_drive_) {  // the core's own drive needs no guard
    command();
    if (!state_.commanded.is_finite()) {
      guard_.fail(drive_use(), "command() gives numbers that are not finite");
    }
    return;
  }
  const std::string problem = guard_.run(drive_use(), [&] {
    command();
    return drive_check_.problem(*driver_, state_.commanded, state_.max_speed_m_s, wanted);
  });
  if (!problem.empty()) guard_.fail(drive_use(), problem);
}

void Robot::set_max_speed(double max_speed) {
  state_.max_speed_m_s = max_speed;
  if (!has_default_drive_ && drive_->disturbed && drive_->disturbed->has_begun()) return;
  carry_out(state_.commanded);
}

void Robot::moved(const physics::RobotState& state, std::span<const JointSetting> joints,
                  double time_s, double step_s) {
  tally_.distance_m += distance(truth_.pose, state.pose);
  take_body(state, joints);
  rolled_ += step_s * state_.odometry;
  if (!localiser_) {
    state_.pose = truth_.pose;
    state_.moving = truth_.moving;
    return;
  }
  believe(guard_.run(*localiser_->use, [&] {
    return localiser_->object().update({state_.pose, state_.moving},
                                       {time_s, step_s, truth_, state_.odometry, this->joints(),
                                        state_.wheels, &localiser_->random});
  }));
}

void Robot::set_body(const physics::RobotState& state, std::span<const JointSetting> joints,
                     Arrival arrival) {
  take_body(state, joints);
  if (!localiser_) {
    state_.pose = truth_.pose;
    state_.moving = truth_.moving;
  } else if (arrival != Arrival::stayed) {
    believe(guard_.run(*localiser_->use, [&] {
      Localisation& localisation = localiser_->object();
      return arrival == Arrival::placed ? localisation.placed({state_.pose, state_.moving}, truth_)
                                        : localisation.start(truth_, localiser_->random);
    }));
  }
}

void Robot::believe(const Belief& belief) {
  const Pose& pose = belief.pose;
  if (!belief.moving.is_finite() || !std::isfinite(pose.x + pose.y + pose.heading_rad)) {
    guard_.fail(*localiser_->use, "it believes numbers that are not finite");
  }
  state_.pose = {pose.x, pose.y, wrap_angle(pose.heading_rad)};
  state_.moving = belief.moving;
}

void Robot::take_body(const physics::RobotState& state, std::span<const JointSetting> joints) {
  std::copy(joints.begin(), joints.end(), joints_.begin());
  Turret turret;
  if (!has_default_drive_) {
    guard_.run(drive_use(), [&] {
      turret = driver_->turret(this->joints());
      state_.odometry = driver_->odometry(this->joints());
    });
    if (!state_.odometry.is_finite() || !std::isfinite(turret.angle_rad + turret.turn_rad_s)) {
      guard_.fail(drive_use(), "odometry() or turret() gives numbers that are not finite");
    }
  } else {  // the core's own drive needs no guard
    state_.odometry = driver_->odometry(this->joints());
  }
  body_frame_ = state.frame;
  truth_.pose = state.pose;
  truth_.moving = {state.speed, state.lateral, state.turn_rate + turret.turn_rad_s};
  if (turret.angle_rad != 0.0) {
    const double c = std::cos(turret.angle_rad), s = std::sin(turret.angle_rad);
    body_frame_ = state.frame.frame(Frame::turned({}, turret.angle_rad, 0.0));
    truth_.pose.heading_rad = wrap_angle(state.pose.heading_rad + turret.angle_rad);
    truth_.moving.forward = c * state.speed + s * state.lateral;
    truth_.moving.lateral = c * state.lateral - s * state.speed;
  }
}

void Robot::look_at_segments(const physics::Engine& engine, std::size_t index) {
  const std::size_t of_drive = engine.segments(index) - segments_.size();
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    segments_[i] = engine.segment(index, of_drive + i).frame;
  }
}

}  // namespace elsie::simulation
