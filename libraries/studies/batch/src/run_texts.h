// The parts of a run that are stored as JSON.
#pragma once

#include <cstddef>
#include <string>

#include "elsie/batch/job.h"
#include "elsie/simulation/run_result.h"
#include "elsie/traces/account_recorder.h"
#include "elsie/traces/tracks.h"

namespace elsie::batch {

/// The robot's poses, thinned to at most `most`, and its first `most` touches.
Trajectory trajectory_of(const std::string& robot, const traces::Track& track, double period_s,
                         std::size_t most);

/// A learning curve, thinned to at most `most` >= 2 points.
Curve curve_of(const simulation::LearningCurve& curve, std::size_t most);

/// The deciding behaviours over time, for each robot that was ever in the run: at most `most`
/// episodes for each set of behaviours that it had.
std::vector<Timeline> timelines_of(const traces::AccountRecorder& recorder, std::size_t most);

}  // namespace elsie::batch
