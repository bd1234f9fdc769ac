// Repeats a run that ended its process or exceeded its wall limit.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>

#include <time.h>

#include "elsie/batch/job.h"
#include "elsie/batch/perform.h"
#include "elsie/files/emergency.h"
#include "elsie/process/crash_report.h"
#include "elsie/simulation/observer.h"

namespace elsie::program {

/// Thrown when a run exceeds its wall limit but completes its step: it is slow and does not hang.
class WallLimitMet {};

/// Reports on standard output whether the run ends as before, if no other code can do that:
///
/// - A crash: "the same" when it is the same signal in the same plugin, robot and step. The crash
///   report and exit code 3 are as usual.
/// - The wall limit, when the same plugin of the same robot is at work in the same step: "the
///   same", a report, and exit code 0.
/// - Otherwise the run has two seconds to complete its step. If it does, WallLimitMet is thrown. If
///   not: the difference, a report, and exit code 1.
///
/// Must be made in the thread of the run; only one at a time.
class EndAgain final : public simulation::Observer, private files::EmergencyWriter {
 public:
  /// `before` must outlive this. `wall_limit_s`: from start_clock() on; 0: none.
  EndAgain(const batch::RunRecord& before, double wall_limit_s);
  ~EndAgain() override;

  /// To be called before the simulation is made, as in a batch: loading plugins is not part of the
  /// run.
  void start_clock() const noexcept;

  void started(const simulation::Simulation& simulation) override;
  void stepped(const simulation::Simulation& simulation) override;
  void ended(const simulation::Simulation& simulation) override;

  /// After WallLimitMet: the message about it.
  std::string slow() const;

 private:
  static void limit_is_met(int);
  bool write_now() noexcept override;
  bool is_same_place() const noexcept;
  void set_timer(double seconds) const noexcept;

  const batch::RunRecord& before_;
  const double wall_limit_s_;
  // For the signal handlers, which cannot build texts.
  const std::string same_, not_same_;
  timer_t timer_{};
  std::atomic<std::uint64_t> step_{0};
  std::atomic<double> time_s_{0.0};  // of the step
  double last_s_ = 0.0;              // of the step before
  std::atomic<bool> is_late_{false};
  std::atomic<bool> is_told_{false};
};

}  // namespace elsie::program
