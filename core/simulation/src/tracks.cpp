#include "elsie/simulation/tracks.h"

#include "elsie/simulation/simulation.h"

#include "sampling.h"

namespace elsie::simulation {

void TrackRecorder::started(const Simulation& simulation) {
  const double step = simulation.world().physics.step;
  every_ = steps_in(asked_period_s_, step);
  period_s_ = static_cast<double>(every_) * step;
  tracks_.assign(simulation.robots(), {});
  collisions_.assign(simulation.robots(), 0);
  sample(simulation);
}

void TrackRecorder::stepped(const Simulation& simulation) {
  if (simulation.steps() % every_ == 0) {
    sample(simulation);
  }
  for (std::size_t i = 0; i < simulation.robots(); ++i) {
    const RobotView robot = simulation.robot(i);
    if (robot.collisions != collisions_[i]) {
      collisions_[i] = robot.collisions;
      tracks_[i].touches.push_back({robot.state->pose.x, robot.state->pose.y});
    }
  }
}

void TrackRecorder::sample(const Simulation& simulation) {
  for (std::size_t i = 0; i < simulation.robots(); ++i) {
    tracks_[i].path.push_back(simulation.robot(i).state->pose);
  }
}

}  // namespace elsie::simulation
