// How a trace keeps the rows that coordinators fill: how it rounds them, and when a row has
// changed. Code that records, reads or adds up a trace uses these functions, so that all agree.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/api/coordinator.h"
#include "elsie/simulation/simulation.h"
#include "elsie/traces/trace.h"

namespace elsie::traces {

/// The number to four significant digits.
double to_four_digits(double value);

/// A row as a trace keeps it: activation, strength and share to three decimals, the command to
/// five, the weight to four significant digits. The first three are zero if the behaviour was not
/// asked. Smaller changes do not count.
TraceRow kept(TraceRow row);
Motion kept(const Motion& motion);

/// True if two rows are equal, to the last bit. The time that the behaviour took does not count.
bool same(const TraceRow& a, const TraceRow& b);

/// The member that silenced this one in the last decision, or null. `all`: of the robot.
const simulation::TracedMember* inhibitor_of(const simulation::TracedMember& member,
                                             std::span<const simulation::TracedMember> all);

/// The note of a row. `reason` and `inhibited_by` are places in the trace and in the robot.
TraceNote note_of(const TraceRow& row, double time_s, std::uint32_t reason, int inhibited_by);

/// True if two notes are equal, whenever they were made.
bool same(const TraceNote& a, const TraceNote& b);

/// The rows and the commands of one robot at the last call of changed().
class TraceRows {
 public:
  /// True if a trace keeps something different now than at the last call; true at the first call.
  bool changed(const simulation::RobotView& robot);

 private:
  std::vector<TraceRow> rows_, kept_;
  Motion asked_, command_;
  bool begun_ = false;
};

}  // namespace elsie::traces
