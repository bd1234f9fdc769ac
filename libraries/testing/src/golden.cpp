#include "elsie/testing/golden.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "elsie/base/words.h"
#include "elsie/files/write_whole.h"

#include "text.h"

namespace elsie::testing {
namespace {

constexpr std::string_view kTitle = "# A golden trace of Elsie's test library.";
constexpr std::string_view kNoEvents = "-";

/// Its events, then its acts: "arrived,act:grip,act:radio:say:offer".
std::string joined(const Response& response) {
  std::vector<std::string> names;
  for (const Event& event : response.events) {
    names.emplace_back(event.name);
  }
  for (const Act& act : response.acts) {
    std::string& name = names.emplace_back("act:");
    if (!act.actuator().empty()) name += act.actuator() + ":";
    name += act.kind().name;
    if (!(act.kind() == ReadingKind::of<SayCommand>())) continue;
    const auto& said = *static_cast<const SayCommand*>(act.command());
    name += std::string(":") + (said.message ? said.message->kind().name : "silence");
    if (!said.to.empty()) name += ":" + said.to;
  }
  return base::joined(names, ",");
}

/// Calls `visit(column, value)` for each number of the commands that a robot's actuators carry out;
/// NaN: a list is shorter now.
template <class Visit>
void visit_commands(const simulation::Simulation& simulation, std::size_t robot, Visit visit) {
  for (std::size_t i = 0; i < simulation.actuators(robot); ++i) {
    const std::string id(simulation.actuator(robot, i).id);
    simulation.visit_command(robot, i, [&](const ReadingField& field) {
      for (std::size_t k = 0; field.is_number() && k < field.size; ++k) {
        visit(id + "." + field.column(k), k < field.count ? field.number(k) : std::nan(""));
      }
    });
  }
}

/// Numbers that differ by rounding have the same text.
std::string short_text(double value) { return number_text(value, 10); }

bool is_same(double value, double expected, double tolerance) {
  if (std::isnan(value) || std::isnan(expected)) {
    return std::isnan(value) == std::isnan(expected);
  }
  if (value == expected) {
    return true;  // also for equal infinities
  }
  // The file has ten digits.
  const double size = std::max(std::abs(value), std::abs(expected));
  return std::abs(value - expected) <= std::max(tolerance, 1e-9) * std::max(1.0, size);
}

std::string step_text(std::size_t step, double time_s) {
  return "step " + std::to_string(step) + " (" + number_text(time_s) + " s)";
}

std::string events_text(const std::string& events) {
  return events.empty() ? "none" : "'" + events + "'";
}

/// All differences of a row, as clauses.
void compare_rows(const Trace& now, const Trace& then, std::size_t step, double tolerance,
                  std::vector<std::string>& differences) {
  const Trace::Row& is = now.rows[step];
  const Trace::Row& was = then.rows[step];
  const std::string where = "in " + step_text(step, was.time_s) + " ";
  if (!is_same(is.time_s, was.time_s, tolerance)) {
    differences.push_back(where + "the time is " + number_text(is.time_s) + " s");
  }
  for (std::size_t i = 0; i < then.columns.size(); ++i) {
    if (!is_same(is.values[i], was.values[i], tolerance)) {
      differences.push_back(where + then.columns[i] + " is " + number_text(is.values[i]) +
                            ", expected " + number_text(was.values[i]) + " within " +
                            number_text(tolerance));
    }
  }
  if (is.events != was.events) {
    differences.push_back(where + "the events are " + events_text(is.events) + ", expected " +
                          events_text(was.events));
  }
}

Verdict compare(const Trace& now, const Trace& then, double tolerance) {
  if (now.columns != then.columns) {
    return Verdict::wrong("it has the columns " + base::joined(now.columns) + ", expected " +
                          base::joined(then.columns));
  }
  std::vector<std::string> differences;
  const std::size_t both = std::min(now.rows.size(), then.rows.size());
  for (std::size_t step = 0; step < both; ++step) {
    compare_rows(now, then, step, tolerance, differences);
  }
  if (now.rows.size() != then.rows.size()) {
    differences.push_back("it has " + std::to_string(now.rows.size()) + " steps, expected " +
                          std::to_string(then.rows.size()));
  }
  if (differences.empty()) {
    return {};
  }
  const std::size_t more = differences.size() - 1;
  return Verdict::wrong(differences.front() +
                        (more > 0 ? "; and " + std::to_string(more) + " more differences" : ""));
}

/// The words of a line.
std::vector<std::string> words(const std::string& line) {
  std::istringstream in(line);
  return {std::istream_iterator<std::string>(in), {}};
}

}  // namespace

Trace record(Behavior& behavior, const Sequence& sequence) {
  Trace trace{{"forward", "lateral", "turn", "activation", "strength"}, {}};
  for (const Situation& now : sequence.instants()) {
    const Response r = behavior.respond(now);
    trace.rows.push_back(
        {now.time_s(),
         {r.command.forward, r.command.lateral, r.command.turn, r.activation, r.strength},
         joined(r)});
  }
  return trace;
}

Trace record(Coordinator& coordinator, Team& team, const Sequence& sequence) {
  Trace trace{{"forward", "lateral", "turn"}, {}};
  for (const Member& member : team.members()) {
    trace.columns.push_back("share." + std::string(member.name()));
  }
  for (const Situation& now : sequence.instants()) {
    const Motion command = coordinator.decide(now);
    Trace::Row& row = trace.rows.emplace_back();
    row.time_s = now.time_s();
    row.values = {command.forward, command.lateral, command.turn};
    for (const Member& member : team.members()) {
      row.values.push_back(member.trace.share);
    }
  }
  return trace;
}

Trace record(World& world, double seconds, double interval_s) {
  const simulation::Simulation& simulation = world.simulation();
  Trace trace;
  for (std::size_t i = 0; i < simulation.robots(); ++i) {
    for (const char* what : {".x", ".y", ".heading", ".forward", ".lateral", ".turn"}) {
      trace.columns.push_back(simulation.robot(i).description->id + what);
    }
    visit_commands(simulation, i, [&](const std::string& column, double) {
      trace.columns.push_back(simulation.robot(i).description->id + "." + column);
    });
  }
  const double step_s = simulation.world().physics.step;
  const auto every = static_cast<int>(std::max(1L, std::lround(interval_s / step_s)));
  const auto rows = std::lround(seconds / (step_s * every));
  std::size_t recorded = simulation.events().size();
  for (long row = 0; row <= rows; ++row) {
    if (row > 0) {
      world.step(every);
    }
    Trace::Row& now = trace.rows.emplace_back();
    now.time_s = simulation.time_s();
    for (std::size_t i = 0; i < simulation.robots(); ++i) {
      const simulation::RobotView robot = simulation.robot(i);
      const Pose& pose = robot.pose;
      now.values.insert(now.values.end(), {pose.x, pose.y, pose.heading_rad, robot.command.forward,
                                           robot.command.lateral, robot.command.turn});
      visit_commands(simulation, i,
                     [&](const std::string&, double value) { now.values.push_back(value); });
    }
    for (; recorded < simulation.events().size(); ++recorded) {
      const simulation::EventRecord& event = simulation.events()[recorded];
      now.events += (now.events.empty() ? "" : ",") + event.robot + ":" + event.name();
    }
  }
  return trace;
}

std::string write_trace(const Trace& trace) {
  std::string text = std::string(kTitle) + " Rewritten with " + kUpdateVariable + "=1.\ntime_s";
  for (const std::string& column : trace.columns) {
    text += ' ' + column;
  }
  text += " events\n";
  for (const Trace::Row& row : trace.rows) {
    text += short_text(row.time_s);
    for (const double value : row.values) {
      text += ' ' + short_text(value);
    }
    text += ' ' + (row.events.empty() ? std::string(kNoEvents) : row.events) + '\n';
  }
  return text;
}

Trace read_trace(const std::string& text, const std::string& file) {
  std::istringstream in(text);
  Trace trace;
  int number = 0;
  const auto fail = [&](const std::string& problem) {
    throw std::runtime_error(file + ":" + std::to_string(number) + ": " + problem +
                             "; it is no golden trace, or was changed by hand");
  };
  std::string line;
  bool has_columns = false;
  while (std::getline(in, line)) {
    ++number;
    if (line.starts_with('#')) {
      continue;
    }
    std::vector<std::string> fields = words(line);
    if (!has_columns) {
      if (fields.size() < 2 || fields.front() != "time_s" || fields.back() != "events") {
        fail("expected a line 'time_s ... events'");
      }
      trace.columns.assign(fields.begin() + 1, fields.end() - 1);
      has_columns = true;
      continue;
    }
    if (fields.size() != trace.columns.size() + 2) {
      fail("expected " + std::to_string(trace.columns.size() + 2) + " fields, found " +
           std::to_string(fields.size()));
    }
    Trace::Row& row = trace.rows.emplace_back();
    row.events = fields.back() == kNoEvents ? "" : fields.back();
    fields.pop_back();
    for (const std::string& field : fields) {
      double value = 0.0;
      const char* const end = field.data() + field.size();
      const auto read = std::from_chars(field.data(), end, value);
      if (read.ec != std::errc() || read.ptr != end) {
        fail("'" + field + "' is no number");
      }
      row.values.push_back(value);
    }
    row.time_s = row.values.front();
    row.values.erase(row.values.begin());
  }
  if (!has_columns) {
    fail("it has no columns");
  }
  return trace;
}

Verdict compare_with_golden(const Trace& trace, const std::string& file, double tolerance) {
  const char* const update = std::getenv(kUpdateVariable);
  if (update && std::string_view(update) == "1") {
    files::write_whole_or_throw(file, write_trace(trace));
    return {};
  }
  std::ifstream in(file);
  if (!in) {
    return Verdict::wrong("there is no golden trace " + file + "; run the test once with " +
                          kUpdateVariable + "=1 to have it written");
  }
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  Verdict verdict;
  try {
    verdict = compare(trace, read_trace(text, file), tolerance);
  } catch (const std::runtime_error& error) {
    return Verdict::wrong(error.what());
  }
  if (!verdict) {
    verdict.sentence =
        file + ": " + verdict.sentence + " (" + kUpdateVariable + "=1 writes the file again)";
  }
  return verdict;
}

}  // namespace elsie::testing
