#include "explain_report.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "elsie/base/number_text.h"
#include "elsie/base/words.h"
#include "elsie/process/text_table.h"

namespace elsie::program {

namespace {

using traces::CoordinatorAccount;
using traces::Decider;
using traces::Episode;
using traces::MemberAccount;
using traces::Trace;
using traces::TraceEvent;
using traces::TraceMember;
using traces::TraceRobot;

constexpr double kShort = 0.05;  // s; from here on, two decimals are not enough

/// The number in as few digits as possible: 0.5, 0.125.
std::string short_number(double value) { return base::number_text(value, 3); }

/// True if one decider had so much of the episode that the others need no names.
bool is_nearly_all(const Episode& episode) {
  constexpr double kNearlyAll = 0.95;
  return episode.parts[0].time_s >= kNearlyAll * episode.length_s();
}

std::string name_of(const TraceRobot& robot, Decider decider) {
  switch (decider) {
    case traces::kNobody:
      return "(nobody)";
    case traces::kTogether:
      return "(several with the same share)";
    case traces::kIdle:
      return "(not asked)";
    default:
      return robot.members[index_of(decider)].path;
  }
}

std::string weights(const MemberAccount& member) {
  const std::string mean = short_number(member.weight);
  const std::string least = short_number(member.least_weight);
  const std::string largest = short_number(member.largest_weight);
  return least == largest ? mean : mean + " (" + least + " to " + largest + ")";
}

/// The coordinator that decides about a member.
const CoordinatorAccount& coordinator_of(const ExplainedRobot& explained,
                                         const TraceMember& member) {
  const auto& all = explained.account.coordinators;
  return *std::find_if(all.begin(), all.end(), [&](const CoordinatorAccount& coordinator) {
    return coordinator.parent == member.parent;
  });
}

/// "1" or, if it was changed, "1, 3, 0.5".
std::string priorities_of(const TraceRobot& robot, const TraceMember& member,
                          const traces::TimeSpan& span) {
  std::string text;
  for (const auto& from : traces::priorities(robot, member, span)) {
    text += (text.empty() ? "" : ", ") + short_number(from.priority);
  }
  return text;
}

std::string table(const ExplainedRobot& explained) {
  const TraceRobot& robot = *explained.robot;
  const auto& members = robot.members;
  const double length = explained.account.span.to_s - explained.account.span.from_s;
  const bool nested = std::any_of(members.begin(), members.end(),
                                  [](const TraceMember& member) { return member.depth > 0; });
  const bool measured = std::any_of(members.begin(), members.end(), [](const TraceMember& member) {
    return member.times.answers > 0;
  });
  std::vector<std::vector<std::string>> rows{{"behaviour", "priority", "decides", "share"}};
  if (nested) {
    rows[0].push_back("of the robot");
  }
  for (const char* name : {"weight", "activation", "asked", "turns", "longest"}) {
    rows[0].push_back(name);
  }
  if (measured) {
    rows[0].push_back("took us");
  }
  for (std::size_t i = 0; i < members.size(); ++i) {
    const MemberAccount& account = explained.account.members[i];
    const CoordinatorAccount& coordinator = coordinator_of(explained, members[i]);
    std::vector<std::string> row{std::string(2 * index_of(members[i].depth), ' ') +
                                     members[i].path.substr(members[i].path.rfind('/') + 1),
                                 priorities_of(robot, members[i], explained.account.span),
                                 per_cent(account.decided_s, coordinator.asked_s),
                                 coordinator.asked_s > 0.0 ? per_cent(account.share, 1.0) : "-"};
    if (nested) {
      row.push_back(per_cent(account.robot_share, 1.0));
    }
    row.push_back(coordinator.asked_s > 0.0 ? weights(account) : "-");
    row.push_back(account.asked_s > 0.0 ? short_number(account.activation) : "-");
    row.push_back(per_cent(account.asked_s, length));
    row.push_back(std::to_string(account.periods));
    row.push_back(account.periods > 0
                      ? seconds(account.longest_s) + " s at " + seconds(account.longest_at_s) + " s"
                      : "-");
    if (measured) {
      row.push_back(members[i].times.answers > 0 ? short_number(1e6 * members[i].times.mean_s)
                                                 : "-");
    }
    rows.push_back(std::move(row));
  }
  return process::laid_out(rows, 1);
}

std::string inhibitions(const ExplainedRobot& explained) {
  constexpr std::size_t kNamed = 4;  // of the behaviours that silence another one
  const TraceRobot& robot = *explained.robot;
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < robot.members.size(); ++i) {
    const auto& inhibited = explained.account.members[i].inhibited;
    const double asked_s = coordinator_of(explained, robot.members[i]).asked_s;
    for (std::size_t n = 0; n < std::min(inhibited.size(), kNamed); ++n) {
      rows.push_back({n == 0 ? "  " + robot.members[i].path : "",
                      "by " + robot.members[index_of(inhibited[n].by)].path,
                      base::counted(inhibited[n].times, "time"),
                      seconds(inhibited[n].time_s) + " s", per_cent(inhibited[n].time_s, asked_s)});
    }
    if (inhibited.size() > kNamed) {
      rows.push_back({"", "and by " + std::to_string(inhibited.size() - kNamed) + " more"});
    }
  }
  return rows.empty() ? "" : "\nsilenced\n" + process::laid_out(rows, 2);
}

std::string events(const ExplainedRobot& explained) {
  constexpr std::size_t kTimes = 8;  // shown for each event
  const auto& span = explained.account.span;
  std::vector<std::string> names;
  std::map<std::string, std::vector<double>> times;
  for (const TraceEvent& event : explained.robot->events) {
    if (event.time_s >= span.from_s && event.time_s <= span.to_s) {
      if (!times.contains(event.name)) {
        names.push_back(event.name);
      }
      times[event.name].push_back(event.time_s);
    }
  }
  std::string lines;
  for (const std::string& name : names) {
    const std::vector<double>& all = times[name];
    lines += "  " + name + ": " + base::counted(static_cast<int>(all.size()), "time") + ", at ";
    for (std::size_t i = 0; i < std::min(all.size(), kTimes); ++i) {
      lines += (i ? ", " : "") + seconds(all[i]);
    }
    lines += (all.size() > kTimes ? "... s\n" : " s\n");
  }
  return lines.empty() ? "" : "\nevents\n" + lines;
}

std::string numbers(const ExplainedRobot& explained) {
  std::vector<std::vector<std::string>> rows{{"  number", "mean", "least", "largest", "last", ""}};
  for (const traces::TraceNumber& number : explained.robot->numbers) {
    const NumberAccount account = program::account(number, explained.account.span);
    std::vector<std::string> row{"  " + number.path + "." + number.name};
    for (const double value : {account.mean, account.least, account.largest, account.last}) {
      row.push_back(account.samples > 0 ? short_number(value) : "-");
    }
    row.push_back(number.unit);
    rows.push_back(std::move(row));
  }
  return rows.size() == 1 ? "" : "\npublished numbers\n" + process::laid_out(rows, 1);
}

/// "avoid_obstacle"; "avoid_obstacle but for 0.12 s, 4 changes"; or "avoid_obstacle 62.0 %, wander
/// 38.0 %, 14 changes".
std::string who(const TraceRobot& robot, const Episode& episode) {
  const std::string main = name_of(robot, episode.parts[0].decider);
  if (episode.parts.size() == 1) {
    return main;
  }
  const std::string changes = ", " + base::counted(episode.switches, "change");
  if (is_nearly_all(episode)) {
    const double others_s = episode.length_s() - episode.parts[0].time_s;
    return main + " but for " + base::fixed_text(others_s, others_s < kShort ? 3 : 2) + " s" +
           changes;
  }
  constexpr std::size_t kNamed = 4;
  std::string text;
  for (std::size_t i = 0; i < std::min(episode.parts.size(), kNamed); ++i) {
    text += (i ? ", " : "") + name_of(robot, episode.parts[i].decider) + " " +
            per_cent(episode.parts[i].time_s, episode.length_s());
  }
  return text + (episode.parts.size() > kNamed ? "..." : "") + changes;
}

/// "share 0.93, weight 2: largest output; mostly no other is active": why the decider's time began,
/// and the reason that its coordinator gave for the longest time, if that is another one.
std::string why(const Trace& trace, const Episode& episode) {
  const Episode::Part& part = episode.parts[0];
  if (part.decider < 0 || !is_nearly_all(episode)) {
    return "";
  }
  const std::string& began = trace.reasons[part.first_reason];
  const std::string& mostly = trace.reasons[part.reason];
  std::string text = "share " + short_number(part.share) + ", weight " + short_number(part.weight);
  if (!began.empty()) {
    text += ": " + began;
  }
  if (!mostly.empty() && mostly != began) {
    text += (began.empty() ? ": mostly " : "; mostly ") + mostly;
  }
  return text;
}

std::string episodes(const Trace& trace, const TraceRobot& robot,
                     const CoordinatorAccount& coordinator, std::size_t most) {
  const std::vector<Episode> shown = traces::condensed(coordinator.episodes, most);
  std::string title = "\nwho decided";
  if (coordinator.parent >= 0) {
    title += " inside " + robot.members[index_of(coordinator.parent)].path + " (" +
             coordinator.coordinator + ")";
  }
  title += ": " + base::counted(coordinator.switches, "change");
  if (shown.size() < coordinator.episodes.size()) {
    title += ", " + std::to_string(coordinator.episodes.size()) + " episodes shown as " +
             std::to_string(shown.size()) + " (--all shows each)";
  }
  std::vector<std::vector<std::string>> rows;
  for (const Episode& episode : shown) {
    const bool is_short = episode.length_s() < kShort;
    rows.push_back({"  " + seconds(episode.from_s), "to", seconds(episode.to_s),
                    base::fixed_text(episode.length_s(), is_short ? 3 : 2) + " s",
                    " " + who(robot, episode), why(trace, episode)});
  }
  // Numbers are right-aligned, names and reasons left-aligned: two tables side by side.
  std::vector<std::vector<std::string>> names;
  for (auto& row : rows) {
    names.push_back({row[4], row[5]});
    row.resize(4);
  }
  std::string text = title + '\n';
  const std::string times = process::laid_out(rows, 0), reasons = process::laid_out(names, 2);
  std::size_t from = 0, name_from = 0;
  while (from < times.size()) {
    const std::size_t end = times.find('\n', from), name_end = reasons.find('\n', name_from);
    text +=
        times.substr(from, end - from) + ' ' + reasons.substr(name_from, name_end - name_from + 1);
    from = end + 1;
    name_from = name_end + 1;
  }
  return text;
}

}  // namespace

std::string seconds(double time_s) { return base::fixed_text(time_s, 2); }

std::string per_cent(double part, double whole) {
  if (!(whole > 0.0)) {
    return "-";
  }
  const double value = 100.0 * part / whole;
  // A value close to 0 or 100 is not rounded to it; sums of times have rounding errors.
  constexpr double kWhole = 100.0 - 1e-9;
  const bool at_border = (value > 0.0 && value < 0.1) || (value < kWhole && value > 99.9);
  return (!at_border     ? base::fixed_text(value, 1)
          : value > 50.0 ? "99.9"
                         : base::number_text(value, 2)) +
         " %";
}

NumberAccount account(const traces::TraceNumber& number, const traces::TimeSpan& span) {
  NumberAccount account;
  double sum = 0.0;
  for (const auto& [time_s, value] : number.samples) {
    if (time_s < span.from_s || time_s > span.to_s || std::isnan(value)) continue;
    account.least = account.samples == 0 ? value : std::min(account.least, value);
    account.largest = account.samples == 0 ? value : std::max(account.largest, value);
    account.last = value;
    sum += value;
    ++account.samples;
  }
  account.mean = account.samples > 0 ? sum / static_cast<double>(account.samples) : 0.0;
  return account;
}

std::string ending(const Trace& trace) {
  const std::string time = base::fixed_text(trace.end_s, 1) + " s";
  if (trace.outcome.empty()) {
    return "no end after " + time;
  }
  return trace.outcome + " after " + time +
         (trace.outcome_reason.empty() ? "" : ": " + trace.outcome_reason);
}

std::string headlines(const Trace& trace) {
  std::string lines = (trace.world.empty() ? "a world" : trace.world) + ", seed " +
                      std::to_string(trace.seed) + ": " + ending(trace) + '\n';
  if (trace.outcome.empty()) {
    lines += "The recording has no end: the run was killed, or is still going on.\n";
  }
  if (!trace.cut_off.empty()) {
    lines += trace.cut_off + '\n';
  }
  if (!trace.without_decisions.empty()) {
    lines += "Of " + base::counted(trace.without_decisions.size(), "robot") +
             " only the poses were recorded (see --record-robots of `elsie run`).\n";
  }
  return lines;
}

std::string report(const Trace& trace, const ExplainedRobot& explained, std::size_t most_episodes) {
  const TraceRobot& robot = *explained.robot;
  const auto& account = explained.account;
  std::string out = "robot " + robot.id + ", team " + robot.team + ", " +
                    (robot.coordinator.empty() ? "no coordinator" : robot.coordinator) + ", " +
                    seconds(account.span.from_s) + " to " + seconds(account.span.to_s) +
                    " s, a decision every " + short_number(trace.period_s) + " s\n\n";
  if (robot.members.empty()) {
    return out + "It has no behaviours.\n" + numbers(explained) + acts(explained) +
           events(explained);
  }
  out += table(explained);
  const CoordinatorAccount& own = account.coordinators.front();
  for (const auto& [time_s, what] : {std::pair(own.together_s, "several had the same share"),
                                     std::pair(own.nobody_s, "nobody had a share")}) {
    if (time_s > 0.0) {
      out += seconds(time_s) + " s (" + per_cent(time_s, own.asked_s) + "): " + what + '\n';
    }
  }
  out += inhibitions(explained) + graphs(explained) + numbers(explained) + acts(explained) +
         events(explained);
  for (const CoordinatorAccount& coordinator : account.coordinators) {
    out += episodes(trace, robot, coordinator, most_episodes);
  }
  return out;
}

}  // namespace elsie::program
