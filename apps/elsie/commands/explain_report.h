// A coordination trace in words and numbers.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "elsie/traces/trace_account.h"

namespace elsie::program {

/// An index that is not negative, as traces hold them.
inline std::size_t index_of(int number) { return static_cast<std::size_t>(number); }

/// A robot of the trace, and its sums.
struct ExplainedRobot {
  const traces::TraceRobot* robot;
  traces::RobotAccount account;
};

/// What a published number was during a time.
struct NumberAccount {
  std::size_t samples = 0;  // in which there was one; if 0, the rest means nothing
  double mean = 0.0, least = 0.0, largest = 0.0;
  double last = 0.0;
};
NumberAccount account(const traces::TraceNumber& number, const traces::TimeSpan& span);

/// What commanded an actuator during a time: a behaviour or, with an empty path, none.
struct Commander {
  std::string by;
  double time_s = 0.0;
  const traces::TraceCommand* last = nullptr;  // of its commands; never null
};
/// The part of a time during which the recording has an actuator; it begins with a sample.
traces::TimeSpan presence(const traces::TraceActuator& actuator, const traces::TimeSpan& span);
/// In the order of their first commands. Their times add up to the actuator's presence.
std::vector<Commander> commanders(const traces::TraceActuator& actuator,
                                  const traces::TimeSpan& span);
/// The actuators of a robot and what they heard, in words; empty if it has none.
std::string acts(const ExplainedRobot& explained);

/// The part of a time during which the recording has a graph.
traces::TimeSpan presence(const traces::TraceGraph& graph, const traces::TimeSpan& span);
/// Where the robot's coordinators were in their graphs, in words; empty if none shows one.
std::string graphs(const ExplainedRobot& explained);

/// "12.30"
std::string seconds(double time_s);
/// "38.2 %"
std::string per_cent(double part, double whole);

/// The run and the length of its trace: one line, and more when the end is missing.
std::string headlines(const traces::Trace& trace);

/// "success after 12.3 s", or the time at which the trace ends.
std::string ending(const traces::Trace& trace);

/// One robot: a table of its behaviours, who silenced them, and who decided when, in at most
/// `most_episodes` lines for each coordinator.
std::string report(const traces::Trace& trace, const ExplainedRobot& explained,
                   std::size_t most_episodes);

/// All of it, episodes unabridged, as one JSON object on one line; docs/explaining-a-run.md lists
/// its members.
std::string json(const traces::Trace& trace, const traces::TimeSpan& span,
                 const std::vector<ExplainedRobot>& robots);

}  // namespace elsie::program
