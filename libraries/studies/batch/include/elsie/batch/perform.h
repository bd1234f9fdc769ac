// One run, in this process.
#pragma once

#include "elsie/batch/job.h"

namespace elsie::batch {

/// At most so many poses of a robot are kept; a longer way is thinned to every second, third...
/// one. Of the places where it collided the first so many are.
inline constexpr std::size_t kMostPoses = 2000;
/// At most so many points of a learning curve are kept, spread evenly; the first and the last
/// always.
inline constexpr std::size_t kMostCurvePoints = 500;
/// At most so many episodes tell who decided when.
inline constexpr std::size_t kMostEpisodes = 60;
/// At most so many events are kept, the first ones; a note says how many more there were.
inline constexpr std::size_t kMostEvents = 10'000;

/// Runs the world of a job from start to end. Never throws: what goes wrong is in the record. What
/// a plugin does to the process is another matter; see Worker.
RunRecord perform(const Job& job);

/// The step that perform() is at, for a handler of signals: counted from 0.
std::uint64_t step_at_work() noexcept;

}  // namespace elsie::batch
