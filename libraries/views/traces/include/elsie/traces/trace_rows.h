// What a trace keeps of the rows that coordinators fill: how it rounds them, and when one has
// changed. Whoever records, reads or adds up a trace uses these functions, so that all agree.
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
double shortened(double value);

/// The text without line breaks and other control characters.
std::string one_line(std::string_view text);

/// A row as a trace keeps it: activation, strength and share to three decimals, the command to
/// five, the weight to four significant digits. The first three are zero if the behaviour was not
/// asked. Smaller changes are none.
TraceRow kept(TraceRow row);
Motion kept(const Motion& motion);

/// Whether two rows are equal, to the last bit. The time that the behaviour took does not count.
bool same(const TraceRow& a, const TraceRow& b);

/// The member that silenced this one in the last decision, or null. `all`: of the robot.
const simulation::TracedMember* inhibitor_of(const simulation::TracedMember& member,
                                             std::span<const simulation::TracedMember> all);

/// The note of a row. `reason` and `inhibited_by` are places in the trace and in the robot.
TraceNote note_of(const TraceRow& row, double time_s, std::uint32_t reason, int inhibited_by);

/// Whether two notes are equal, whenever they were made.
bool same(const TraceNote& a, const TraceNote& b);

/// The rows and the commands of one robot, as they were last looked at.
class TraceRows {
 public:
  /// Whether a trace keeps anything else of the robot now than at the last call. True at the first.
  bool changed(const simulation::RobotView& robot);

 private:
  std::vector<TraceRow> rows_, kept_;
  Motion asked_, command_;
  bool begun_ = false;
};

}  // namespace elsie::traces
