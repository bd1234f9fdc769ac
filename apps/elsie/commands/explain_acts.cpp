// The commands that actuators carried out, and the messages that robots heard.
#include <algorithm>
#include <map>
#include <tuple>

#include "elsie/base/words.h"
#include "elsie/process/text_table.h"

#include "explain_report.h"

namespace elsie::program {

namespace {

using traces::TraceActuator;
using traces::TraceCommand;
using traces::TraceHeard;

std::string commanded(const ExplainedRobot& explained) {
  const traces::TimeSpan& span = explained.account.span;
  std::vector<std::vector<std::string>> rows;
  for (const TraceActuator& actuator : explained.robot->actuators) {
    const std::vector<Commander> all = commanders(actuator, span);
    const traces::TimeSpan there = presence(actuator, span);
    for (const Commander& each : all) {
      const TraceCommand& last = *each.last;
      rows.push_back(
          {"  " + (&each == &all.front() ? actuator.id : std::string()),
           each.by.empty() ? "by nobody" : "by " + each.by,
           per_cent(each.time_s, there.to_s - there.from_s),
           each.by.empty() ? "" : "last " + last.text + ", from " + seconds(last.time_s) + " s"});
    }
  }
  return rows.empty() ? "" : "\nactuators\n" + process::laid_out(rows, 2);
}

std::string heard(const ExplainedRobot& explained) {
  const traces::TimeSpan& span = explained.account.span;
  std::map<std::tuple<std::string, std::string, std::string>, std::vector<const TraceHeard*>> all;
  for (const TraceHeard& each : explained.robot->heard) {
    if (each.time_s >= span.from_s && each.time_s <= span.to_s) {
      all[{each.kind, each.from, each.device}].push_back(&each);
    }
  }
  std::vector<std::vector<std::string>> rows;
  for (const auto& [of, messages] : all) {
    const auto& [kind, from, device] = of;
    const TraceHeard& last = *messages.back();
    rows.push_back({"  " + kind, from.empty() ? "" : "from " + from, "by " + device,
                    base::counted(messages.size(), "time"),
                    "at " + seconds(messages.front()->time_s) +
                        (messages.size() > 1 ? " to " + seconds(last.time_s) : "") + " s",
                    last.text.empty() ? "" : "last " + last.text});
  }
  return rows.empty() ? "" : "\nheard\n" + process::laid_out(rows, 3);
}

}  // namespace

traces::TimeSpan presence(const TraceActuator& actuator, const traces::TimeSpan& span) {
  return {std::max(actuator.commands.front().time_s, span.from_s),
          std::min(actuator.to_s, span.to_s)};
}

std::vector<Commander> commanders(const TraceActuator& actuator, const traces::TimeSpan& span) {
  std::vector<Commander> all;
  const traces::TimeSpan there = presence(actuator, span);
  const auto& commands = actuator.commands;
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const double from = std::max(commands[i].time_s, there.from_s);
    const double to =
        i + 1 < commands.size() ? std::min(commands[i + 1].time_s, there.to_s) : there.to_s;
    if (!(from < to)) continue;
    auto known = std::find_if(all.begin(), all.end(),
                              [&](const Commander& each) { return each.by == commands[i].by; });
    if (known == all.end()) known = all.insert(known, Commander{commands[i].by, 0.0, nullptr});
    known->time_s += to - from;
    known->last = &commands[i];
  }
  return all;
}

std::string acts(const ExplainedRobot& explained) {
  return commanded(explained) + heard(explained);
}

}  // namespace elsie::program
