// Ends a run that takes too long on the clock.
#pragma once

#include <cstdint>
#include <string>

#include "elsie/simulation/observer.h"

namespace elsie::program {

/// Thrown when a run exceeds its wall limit but completes its step: it is slow and does not hang.
class WallLimitMet {};

/// After the limit, the run has two seconds to complete its step. If it does, throws WallLimitMet.
/// If not, ends the process like a crash, with the name of the plugin at work. Must be made in the
/// thread of the run; only one at a time.
class WallLimit final : public simulation::Observer {
 public:
  /// `limit_s`: from start_clock() on; 0: none.
  explicit WallLimit(double limit_s) : limit_s_(limit_s) {}
  ~WallLimit() override;
  WallLimit(const WallLimit&) = delete;
  WallLimit& operator=(const WallLimit&) = delete;

  /// To be called before the simulation is made, as in a batch: loading plugins is not part of the
  /// run.
  void start_clock() const;

  void stepped(const simulation::Simulation& simulation) override;
  void ended(const simulation::Simulation& simulation) override;

  /// After WallLimitMet: "after 1.5 s on the clock it was in step 52 (at 0.52 s) and went on".
  std::string what_happened() const;

 private:
  const double limit_s_;
  std::uint64_t step_ = 0;  // the last one that was completed
  double time_s_ = 0.0;     // at its beginning
  double next_s_ = 0.0;     // at its end
};

}  // namespace elsie::program
