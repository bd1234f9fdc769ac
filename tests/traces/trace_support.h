// Traces made by hand.
#pragma once

#include <string>
#include <vector>

#include "elsie/traces/trace.h"

namespace elsie::test {

/// A robot with the members "a", "b", ... or of the given paths, without notes.
inline traces::TraceRobot traced_robot(const std::vector<std::string>& paths) {
  traces::TraceRobot robot;
  robot.id = "r1";
  robot.team = "red";
  robot.coordinator = "outer";
  for (const std::string& path : paths) {
    traces::TraceMember member;
    member.path = path;
    member.plugin = path;
    member.coordinator = "outer";
    if (const std::size_t slash = path.rfind('/'); slash != std::string::npos) {
      for (std::size_t i = 0; i < robot.members.size(); ++i) {
        if (robot.members[i].path == path.substr(0, slash)) {
          member.parent = static_cast<int>(i);
          member.depth = robot.members[i].depth + 1;
          member.coordinator = "inner";
        }
      }
    }
    robot.members.push_back(std::move(member));
  }
  return robot;
}

/// Notes that a member has this share from a time on; its weight is ten times that.
inline traces::TraceNote& note(traces::TraceRobot& robot, std::size_t member, double time_s,
                               double share) {
  traces::TraceNote note;
  note.time_s = time_s;
  note.asked = true;
  note.activation = 1.0;
  note.strength = 1.0;
  note.share = share;
  note.weight = 10.0 * share;
  return robot.members[member].notes.emplace_back(note);
}

inline traces::Trace trace_of(traces::TraceRobot robot, double end_s) {
  traces::Trace trace;
  trace.world = "made up";
  trace.step_s = trace.period_s = 0.01;
  trace.reasons = {"", "largest output"};
  trace.end_s = end_s;
  trace.outcome = "success";
  trace.robots.push_back(std::move(robot));
  return trace;
}

}  // namespace elsie::test
