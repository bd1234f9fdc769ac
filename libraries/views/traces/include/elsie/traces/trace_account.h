// Sums over a coordination trace: who decided when, how often that changed, who silenced whom.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "elsie/traces/trace.h"

namespace elsie::traces {

/// A part of a run, s. By default all of it.
struct TimeSpan {
  double from_s = 0.0;
  double to_s = std::numeric_limits<double>::infinity();
};

/// The part of the span that is in the trace; may be empty (from_s == to_s). It begins with the
/// first decision at the earliest.
TimeSpan within(const TimeSpan& span, const Trace& trace);
/// The part of the span during which the robot is there, likewise.
TimeSpan within(const TimeSpan& span, const TraceRobot& robot);

/// Who decides: a place among the members of a robot, or one of the following.
using Decider = int;
inline constexpr Decider kNobody = -1;    // no behaviour has a share
inline constexpr Decider kTogether = -2;  // several have the largest share, to three decimals
inline constexpr Decider kIdle = -3;      // the behaviour around them was not asked

/// An interval of time in which the notes about no member of a robot change.
struct TraceMoment {
  double from_s = 0.0;
  double to_s = 0.0;
  /// The note about each member; null before the first one.
  std::span<const TraceNote* const> notes;
  /// Each member's share in the robot's command: its own times those of the behaviours around it.
  std::span<const double> shares;
};

/// Calls `see` for the moments of the span while the robot is there, in order and without gaps.
void walk(const TraceRobot& robot, const TimeSpan& span,
          const std::function<void(const TraceMoment&)>& see);

/// The member inside `parent` (-1: of the robot itself) whose share is the largest at a moment.
Decider decider(const TraceRobot& robot, int parent, const TraceMoment& moment);

/// A member's priority from some time on.
struct PriorityFrom {
  double time_s = 0.0;
  double priority = 1.0;
};

/// The member's priority at the beginning of the span, then each change of it in the span, from the
/// robot's events "changed" (see change.h). Never empty.
std::vector<PriorityFrom> priorities(const TraceRobot& robot, const TraceMember& member,
                                     const TimeSpan& span);

/// The time during which one member silenced another.
struct Inhibition {
  int by = -1;
  int times = 0;        // number of times that it began
  double time_s = 0.0;  // in total
};

/// One behaviour over a span. Means are over time.
struct MemberAccount {
  double decided_s = 0.0;     // time during which it was the decider among its neighbours
  int periods = 0;            // number of times that it became the decider
  double longest_s = 0.0;     // the longest of these
  double longest_at_s = 0.0;  // when that began
  double asked_s = 0.0;
  double share = 0.0;           // mean, in the command of its own coordinator, while that was asked
  double robot_share = 0.0;     // mean, in the command of the robot
  double weight = 0.0;          // mean, while its coordinator was asked
  double least_weight = 0.0;    // likewise
  double largest_weight = 0.0;  // likewise
  double activation = 0.0;      // mean, while asked
  double strength = 0.0;        // likewise
  std::vector<Inhibition> inhibited;  // by whom, the longest first
};

/// A stretch of time with one decider, or several in quick turns.
struct Episode {
  /// The part of one decider in it.
  struct Part {
    Decider decider = kNobody;
    double time_s = 0.0;
    double share = 0.0;              // mean
    double weight = 0.0;             // mean; zero when it is no single member
    std::uint32_t reason = 0;        // that of its longest stretch; place in Trace::reasons
    std::uint32_t first_reason = 0;  // why it began; likewise
  };

  double from_s = 0.0;
  double to_s = 0.0;
  int switches = 0;         // of the decider, within it
  std::vector<Part> parts;  // the longest first; never empty

  double length_s() const { return to_s - from_s; }
};

/// One coordinator over a span.
struct CoordinatorAccount {
  int parent = -1;  // index of the behaviour around it; -1: the robot's own coordinator
  std::string coordinator;
  double asked_s = 0.0;  // time during which it ran
  double nobody_s = 0.0;
  double together_s = 0.0;
  int switches = 0;               // number of changes of the decider while it ran
  std::vector<Episode> episodes;  // all of them, without gaps: none has a switch within it
};

struct RobotAccount {
  TimeSpan span;
  std::vector<MemberAccount> members;            // in the robot's order
  std::vector<CoordinatorAccount> coordinators;  // the robot's own first, then in order of members
};

/// The sums over a robot's part of the trace. `span` should be a result of within().
RobotAccount account(const TraceRobot& robot, const TimeSpan& span);

/// The episodes condensed to at most `most` (at least 1). Where there are more, episodes shorter
/// than some length count as flicker; the length is chosen so that enough of them do. Successive
/// flicker becomes one episode of several parts. If that is still short, it is joined with both
/// neighbours when they have the same decider, else with the longer one.
std::vector<Episode> condensed(std::vector<Episode> episodes, std::size_t most);

}  // namespace elsie::traces
