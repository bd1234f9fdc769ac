// A coordination trace in words and numbers.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "elsie/simulation/trace_account.h"

/// A robot of the trace, and what came of it.
struct ExplainedRobot {
  const elsie::simulation::TraceRobot* robot;
  elsie::simulation::RobotAccount account;
};

/// What a trace is of and how far it goes: one line, and another one when it has no end or its last
/// line is cut off.
std::string headlines(const elsie::simulation::Trace& trace);

/// "success after 12.3 s", or how far the trace goes.
std::string ending(const elsie::simulation::Trace& trace);

/// One robot: a table of its behaviours, what silenced them, and who decided when, in at most
/// `most_episodes` lines for each coordinator.
std::string report(const elsie::simulation::Trace& trace, const ExplainedRobot& explained,
                   std::size_t most_episodes);

/// All of it, episodes unabridged, as one JSON object on one line; docs/explaining-a-run.md lists
/// its members.
std::string json(const elsie::simulation::Trace& trace, const elsie::simulation::TimeSpan& span,
                 const std::vector<ExplainedRobot>& robots);
