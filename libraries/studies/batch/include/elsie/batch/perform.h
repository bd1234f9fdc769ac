// Does one run in this process.
#pragma once

#include "elsie/batch/job.h"

namespace elsie::batch {

/// The greatest number of poses kept of a robot: of a longer path every second, third... pose is
/// kept. Of its collisions, the first ones are kept, up to the same number.
inline constexpr std::size_t kMostPoses = 2000;
/// The greatest number of points kept of a learning curve, spread evenly, with the first and the
/// last.
inline constexpr std::size_t kMostCurvePoints = 500;
/// The greatest number of episodes kept of who decided when.
inline constexpr std::size_t kMostEpisodes = 60;
/// The greatest number of events kept, the first ones; a note gives the number of the others.
inline constexpr std::size_t kMostEvents = 10'000;

/// Runs the world of a job from start to end. Never throws: errors are in the record. A plugin may
/// still end the process; see Worker.
RunRecord perform(const Job& job);

/// The step that perform() is in, counted from 0; for signal handlers.
std::uint64_t step_at_work() noexcept;

}  // namespace elsie::batch
