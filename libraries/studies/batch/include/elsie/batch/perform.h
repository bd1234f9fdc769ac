// Does one run in this process.
#pragma once

#include <cstddef>
#include <cstdint>

#include "elsie/batch/job.h"
#include "elsie/plugin/host.h"

namespace elsie::batch {

/// The largest number of poses kept for a robot: of a longer path, every second, third... pose is
/// kept. The first collisions are kept, up to the same number.
inline constexpr std::size_t kMostPoses = 2000;
/// The largest number of points kept for a learning curve, spread evenly, including the first and
/// the last.
inline constexpr std::size_t kMostCurvePoints = 500;
/// The largest number of episodes kept in a timeline of deciding behaviours.
inline constexpr std::size_t kMostEpisodes = 60;
/// The largest number of events kept, the first ones; a note gives the number of the others.
inline constexpr std::size_t kMostEvents = 10'000;

/// Loads the libraries of a job. Never throws because of a file; see plugin::Host.
plugin::Host host_for(const Job& job);

/// Runs the world of a job from start to end; `host`: host_for(), if they are loaded already. Never
/// throws: errors are in the record. A plugin may still end the process; see work().
RunRecord perform(const Job& job, const plugin::Host* host = nullptr);

/// A step, counted from 0, and its simulated time.
struct Moment {
  std::uint64_t step = 0;
  double time_s = 0.0;
};
/// The current step of perform(); for signal handlers.
Moment moment_at_work() noexcept;

}  // namespace elsie::batch
