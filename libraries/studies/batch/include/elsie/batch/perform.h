// Does one run in this process.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "elsie/batch/job.h"
#include "elsie/plugin/host.h"
#include "elsie/simulation/simulation.h"

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

/// What a run has before it begins.
struct Preparation {
  /// Loads the libraries of the job. Never throws because of a file; see plugin::Host.
  explicit Preparation(const Job& job);
  /// Reads the world and makes its objects, if that has not been done. Throws as they do.
  void make(const Job& job, const simulation::MakeCameraRenderer& cameras);

  plugin::Host host;
  std::optional<simulation::Simulation> run{};
};

/// Runs the world of a job from start to end; `prepared`: what was done of it before, if anything,
/// for a job that differs in number and seed at most. Never throws: errors are in the record. A
/// plugin may still end the process; see work().
RunRecord perform(const Job& job, std::unique_ptr<Preparation> prepared = nullptr);

/// A step, counted from 0, and its simulated time.
struct Moment {
  std::uint64_t step = 0;
  double time_s = 0.0;
};
/// The current step of perform(); for signal handlers.
Moment moment_at_work() noexcept;

}  // namespace elsie::batch
