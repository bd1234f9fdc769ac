#include "elsie/traces/trace_account.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "trace_tally.h"

namespace elsie::traces {
namespace {

/// The new priority of the behaviour at `path`, which starts at the robot; none if the event is
/// about something else.
std::optional<double> new_priority(const TraceEvent& event, const std::string& path) {
  const std::optional<events::Changed>& changed = event.changed;
  if (!changed || changed->attribute != "priority" ||
      changed->element.substr(std::min(changed->element.find('/'), changed->element.size())) !=
          path) {
    return std::nullopt;
  }
  const char* const end = changed->value.data() + changed->value.size();
  double value = 0.0;
  const auto read = std::from_chars(changed->value.data(), end, value);
  return read.ec == std::errc() && read.ptr == end ? std::optional(value) : std::nullopt;
}

}  // namespace

std::vector<PriorityFrom> priorities(const TraceRobot& robot, const TraceMember& member,
                                     const TimeSpan& span) {
  // "explore/wander" is behavior[explore]/behavior[wander] in the world.
  std::string path;
  for (std::size_t at = 0; at <= member.path.size();) {
    const std::size_t end = std::min(member.path.find('/', at), member.path.size());
    path += "/behavior[" + member.path.substr(at, end - at) + "]";
    at = end + 1;
  }
  std::vector<PriorityFrom> found{{span.from_s, member.priority}};
  for (const TraceEvent& event : robot.events) {
    if (event.time_s > span.to_s) break;
    if (const auto priority = new_priority(event, path)) {
      if (event.time_s <= span.from_s) {
        found.front().priority = *priority;
      } else {
        found.push_back({event.time_s, *priority});
      }
    }
  }
  return found;
}

TimeSpan within(const TimeSpan& span, const Trace& trace) {
  double first = trace.end_s;
  for (const TraceRobot& robot : trace.robots) {
    for (const TraceMember& member : robot.members) {
      if (!member.notes.empty()) {
        first = std::min(first, member.notes.front().time_s);
      }
    }
  }
  const double from = std::clamp(span.from_s, first, trace.end_s);
  return {from, std::clamp(span.to_s, from, trace.end_s)};
}

TimeSpan within(const TimeSpan& span, const TraceRobot& robot) {
  double first = std::numeric_limits<double>::infinity();
  for (const TraceMember& member : robot.members) {
    if (!member.notes.empty()) {
      first = std::min(first, member.notes.front().time_s);
    }
  }
  const double to = std::max(span.from_s, std::min(span.to_s, robot.to_s));
  const double begin = std::isfinite(first) ? first : robot.from_s;
  return {std::min(to, std::max(span.from_s, begin)), to};
}

bool same_cast(const TraceRobot& a, const TraceRobot& b) {
  return a.id == b.id && a.coordinator == b.coordinator &&
         std::equal(a.members.begin(), a.members.end(), b.members.begin(), b.members.end(),
                    [](const TraceMember& one, const TraceMember& other) {
                      return one.path == other.path && one.plugin == other.plugin &&
                             one.coordinator == other.coordinator;
                    });
}

void walk(const TraceRobot& robot, const TimeSpan& asked,
          const std::function<void(const TraceMoment&)>& see) {
  const TimeSpan span = within(asked, robot);
  const std::size_t count = robot.members.size();
  std::vector<std::size_t> next(count, 0);  // note of each member that comes next
  std::vector<const TraceNote*> notes(count, nullptr);
  std::vector<double> shares(count, 0.0);
  double now = span.from_s;
  while (count > 0 && now < span.to_s) {
    double until = span.to_s;
    for (std::size_t i = 0; i < count; ++i) {
      const std::vector<TraceNote>& all = robot.members[i].notes;
      while (next[i] < all.size() && all[next[i]].time_s <= now) {
        notes[i] = &all[next[i]++];
      }
      if (next[i] < all.size()) {
        until = std::min(until, all[next[i]].time_s);
      }
    }
    find_shares(robot, notes, shares);
    see({now, until, notes, shares});
    now = until;
  }
}

Decider decider(const TraceRobot& robot, int parent, const TraceMoment& moment) {
  if (!at_work(parent, moment)) {
    return kIdle;
  }
  Decider best = kNobody;
  double largest = 0.0;
  for (std::size_t i = 0; i < robot.members.size(); ++i) {
    if (robot.members[i].parent != parent || !moment.notes[i]) {
      continue;
    }
    const double share = moment.notes[i]->share;
    if (share > largest) {
      largest = share;
      best = static_cast<Decider>(i);
    } else if (share == largest && largest > 0.0) {
      best = kTogether;
    }
  }
  return best;
}

RobotAccount account(const TraceRobot& robot, const TimeSpan& span) {
  RobotTally tally(robot);
  walk(robot, span, [&](const TraceMoment& moment) { tally.add(moment); });
  return tally.finish(within(span, robot));
}

}  // namespace elsie::traces
