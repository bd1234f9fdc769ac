// Sums over who decides when, computed while a run goes on.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "elsie/simulation/observer.h"
#include "elsie/traces/trace.h"
#include "elsie/traces/trace_account.h"

namespace elsie::traces {

/// Gives the same sums as account() for the whole trace of the run, to the last bit, without a file
/// and without the memory that a long trace takes. A recorder serves one run.
class AccountRecorder final : public simulation::Observer {
 public:
  AccountRecorder();
  ~AccountRecorder() override;

  void started(const simulation::Simulation& simulation) override;
  void stepped(const simulation::Simulation& simulation) override;
  void replaced(const simulation::Simulation& simulation) override;
  void ended(const simulation::Simulation& simulation) override;

  /// The robots and their members, as in Trace::robots, but without notes and events. Those that
  /// an edit removed or gave other behaviours stay in the list.
  const std::vector<TraceRobot>& robots() const;
  /// One for each of the robots, once the run has ended.
  const std::vector<RobotAccount>& accounts() const;
  /// The list that Episode::Part::reason indexes; its first entry is empty.
  const std::vector<std::string>& reasons() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace elsie::traces
