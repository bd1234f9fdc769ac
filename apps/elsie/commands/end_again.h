// A run that brought its process down, or did not come to its end, done once more.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>

#include <time.h>

#include "elsie/base/emergency.h"
#include "elsie/batch/job.h"
#include "elsie/process/crash_report.h"
#include "elsie/simulation/observer.h"

namespace elsie::program {

/// The run had not ended at its wall limit, but goes on by itself: it is slow.
class WallLimitMet {};

/// Says on standard output whether the run ends as it did before, where nothing else can any more:
///
/// - A crash: "the same" when it is the same signal in the same plugin, robot and step. The report
///   on the crash and exit code 3 are as always.
/// - The wall limit, when the plugin at work then is the one that was before, of the same robot in
///   the same step: "the same", a report, and exit code 0.
/// - Otherwise the run is left two seconds to come to the end of its step. If it does, WallLimitMet
///   is thrown. If not: what differs, a report, and exit code 1.
///
/// In the thread that makes it, which must be the one that runs; one at a time.
class EndAgain final : public simulation::Observer, private base::EmergencyWriter {
 public:
  /// `before`: must outlive this. `wall_limit_s`: from now on; 0: none.
  EndAgain(const batch::RunRecord& before, double wall_limit_s);
  ~EndAgain() override;

  void started(const simulation::Simulation& simulation) override;
  void stepped(const simulation::Simulation& simulation) override;
  void ended(const simulation::Simulation& simulation) override;

  /// After WallLimitMet: the sentence about it.
  std::string slow() const;

 private:
  static void limit_is_met(int);
  bool write_now() noexcept override;
  bool is_same_place() const noexcept;
  void set_timer(double seconds) const noexcept;

  const batch::RunRecord& before_;
  const double wall_limit_s_;
  // For the handlers, which cannot put texts together.
  const std::string same_, not_same_;
  timer_t timer_{};
  std::atomic<std::uint64_t> step_{0};
  std::atomic<bool> is_late_{false};
  std::atomic<bool> is_told_{false};
};

}  // namespace elsie::program
