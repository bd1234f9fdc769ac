#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/base/number_text.h"
#include "elsie/files/clean_text.h"
#include "elsie/files/rounded.h"
#include "elsie/recording/graph_json.h"
#include "elsie/recording/recorded_run.h"
#include "elsie/traces/trace_rows.h"

#include "reading.h"

namespace elsie::recording {
namespace {

using files::one_line;
using traces::Trace;
using traces::TraceMember;
using traces::TraceNote;
using traces::TraceRobot;

int place_of(const TraceRobot& robot, std::string_view path) {
  for (std::size_t i = 0; i < robot.members.size(); ++i) {
    if (robot.members[i].path == path) {
      return static_cast<int>(i);
    }
  }
  throw Unexpected("robot '" + robot.id + "' has no behaviour '" + one_line(path) + "'");
}

double number_or_zero(const Json& row, const char* name) { return row.value(name, 0.0); }

double degree(const Json& row, const char* name) {
  const double value = number_or_zero(row, name);
  if (!(value >= 0.0 && value <= 1.0)) {
    throw Unexpected(std::string(name) + " is " + base::number_text(value) +
                     "; expected a number from 0 to 1");
  }
  return value;
}

/// Builds the trace. Behaviours are named in the metadata of a robot's channel, which come before
/// its decisions.
class TraceBuilder final : public Visitor {
 public:
  explicit TraceBuilder(Trace& trace) : trace_(trace) { trace_.reasons = {""}; }

  void channel(const mcap::Channel& channel) override {
    const auto [id, kind] = robot_and_kind(channel);
    if (kind == kPublishedKind) {
      add_numbers(channel, id);
    }
    if (kind == kReadingsKind) readings_[channel.id] = id;
    if (kind == kHeardKind) hearers_[channel.id] = id;
    if (kind == kGraphsKind || kind == kLitKind) {
      (kind == kGraphsKind ? drawn_ : lit_)[channel.id] = last_of(id);
    }
    if (kind != kTraceKind) {
      return;
    }
    TraceRobot robot{id, text(channel, "team"), text(channel, kCoordinator), {}, {}};
    for (const Json& behavior : Json::parse(text(channel, kBehaviors))) {
      TraceMember member;
      member.path = behavior.at("path").get<std::string>();
      member.plugin = behavior.at("plugin").get<std::string>();
      member.coordinator = behavior.at("coordinator").get<std::string>();
      member.priority = behavior.at("priority").get<double>();
      if (const std::size_t slash = member.path.rfind('/'); slash != std::string::npos) {
        member.parent = place_of(robot, member.path.substr(0, slash));
        member.depth = robot.members[static_cast<std::size_t>(member.parent)].depth + 1;
      }
      if (std::any_of(robot.members.begin(), robot.members.end(),
                      [&](const TraceMember& other) { return other.path == member.path; })) {
        throw Unexpected("the behaviour '" + one_line(member.path) + "' is there twice");
      }
      robot.members.push_back(std::move(member));
    }
    // With other sensors a robot has other channels, but its trace goes on.
    std::vector<std::size_t>& namesakes = by_id_[id];
    const auto known =
        std::find_if(namesakes.begin(), namesakes.end(), [&](const std::size_t place) {
          return is_there(trace_.robots[place]) && same_cast(trace_.robots[place], robot);
        });
    places_[channel.id] = known == namesakes.end() ? trace_.robots.size() : *known;
    if (known == namesakes.end()) {
      namesakes.push_back(trace_.robots.size());
      trace_.robots.push_back(std::move(robot));
    }
  }

  void message(const mcap::Channel& channel, const mcap::Message& message) override {
    const double time_s = static_cast<double>(message.log_time_ns) / kSecondNs;
    if (channel.topic == kWorldTopic) {
      read_world(Json::parse(message.data), time_s);
    } else if (channel.topic == kEventsTopic) {
      read_event(Json::parse(message.data), time_s);
    } else if (const auto robot = places_.find(channel.id); robot != places_.end()) {
      if (time_s < decided_s_) {
        throw Unexpected("its time is before that of the decision before it");
      }
      decided_s_ = time_s;
      read_decision(trace_.robots[robot->second], Json::parse(message.data), time_s);
    } else if (const auto reader = readings_.find(channel.id); reader != readings_.end()) {
      const auto known = by_id_.find(reader->second);
      if (known == by_id_.end()) return;
      TraceRobot& actor = trace_.robots[known->second.back()];
      // Most robots have no actuators, and large readings.
      if (!actor.actuators.empty() || message.data.find("\"actuators\":") != std::string::npos) {
        read_acts(actor, Json::parse(message.data), time_s);
      }
    } else if (const auto hearer = hearers_.find(channel.id); hearer != hearers_.end()) {
      if (const auto known = by_id_.find(hearer->second); known != by_id_.end()) {
        read_heard(trace_.robots[known->second.back()], Json::parse(message.data), time_s);
      }
    } else if (const auto publisher = publishers_.find(channel.id);
               publisher != publishers_.end()) {
      read_numbers(trace_.robots[publisher->second], Json::parse(message.data), time_s);
    } else if (const auto drawn = drawn_.find(channel.id); drawn != drawn_.end()) {
      read_graphs(trace_.robots[drawn->second], Json::parse(message.data), time_s);
    } else if (const auto lit = lit_.find(channel.id); lit != lit_.end()) {
      read_lights(trace_.robots[lit->second], Json::parse(message.data), time_s);
    }
  }

  /// The time of the last decision, s; negative if there is none.
  double decided_s() const { return decided_s_; }

 private:
  static const std::string& text(const mcap::Channel& channel, const char* name) {
    const auto at = channel.metadata.find(name);
    if (at == channel.metadata.end()) {
      throw Unexpected("its metadata lack '" + std::string(name) +
                       "'; an older Elsie may have written it");
    }
    return at->second;
  }

  /// The place of the robot. The channel of its decisions comes before those of its plugins.
  std::size_t last_of(const std::string& id) const {
    const auto known = by_id_.find(id);
    if (known == by_id_.end()) {
      throw Unexpected("it is about a robot without decisions, '" + one_line(id) + "'");
    }
    return known->second.back();
  }

  void add_numbers(const mcap::Channel& channel, const std::string& id) {
    TraceRobot& robot = trace_.robots[last_of(id)];
    publishers_[channel.id] = last_of(id);
    for (const Json& number : Json::parse(text(channel, kPublishedNumbers))) {
      traces::TraceNumber added{number.at("path").get<std::string>(),
                                number.at("name").get<std::string>(),
                                one_line(number.at("unit").get<std::string>()),
                                {}};
      if (!number_of(robot, added.path, added.name)) robot.numbers.push_back(std::move(added));
    }
  }

  static traces::TraceNumber* number_of(TraceRobot& robot, std::string_view path,
                                        std::string_view name) {
    const auto found = std::find_if(
        robot.numbers.begin(), robot.numbers.end(),
        [&](const traces::TraceNumber& each) { return each.path == path && each.name == name; });
    return found == robot.numbers.end() ? nullptr : &*found;
  }

  static void read_numbers(TraceRobot& robot, const Json& message, double time_s) {
    for (traces::TraceNumber& number : robot.numbers) {
      number.samples.push_back({time_s, std::numeric_limits<double>::quiet_NaN()});
    }
    for (const auto& [path, numbers] : message.at("plugins").items()) {
      for (const auto& [name, value] : numbers.items()) {
        traces::TraceNumber* const number = number_of(robot, path, name);
        if (!number) throw Unexpected("it has an unknown number '" + one_line(name) + "'");
        number->samples.back().value = value.get<double>();
      }
    }
  }

  /// "red 255, green 0": the members of a command or a message, without the names in `but`.
  static std::string text_of(const Json& members, const char* but = "") {
    std::string text;
    for (const auto& [name, value] : members.items()) {
      if (name == but) continue;
      text += (text.empty() ? "" : ", ") + name + " " +
              (value.is_number() ? base::number_text(value.get<double>(), 6) : value.dump());
    }
    return one_line(text);
  }

  static void read_acts(TraceRobot& robot, const Json& readings, double time_s) {
    const Json now_there = readings.value("actuators", Json::object());
    const auto is_there = [](const traces::TraceActuator& each) { return std::isinf(each.to_s); };
    for (traces::TraceActuator& each : robot.actuators) {
      if (is_there(each) && !now_there.contains(each.id)) each.to_s = time_s;
    }
    for (const auto& [id, command] : now_there.items()) {
      auto known =
          std::find_if(robot.actuators.begin(), robot.actuators.end(),
                       [&, &id = id](const auto& each) { return each.id == id && is_there(each); });
      if (known == robot.actuators.end()) {
        known = robot.actuators.insert(known, traces::TraceActuator{id, {}});
      }
      traces::TraceCommand now{time_s, one_line(command.at("by").get<std::string>()),
                               text_of(command, "by")};
      auto& all = known->commands;
      if (all.empty() || all.back().by != now.by || all.back().text != now.text) {
        all.push_back(std::move(now));
      }
    }
  }

  static void read_heard(TraceRobot& robot, const Json& message, double time_s) {
    for (const Json& heard : message.at("heard")) {
      robot.heard.push_back({time_s, one_line(heard.at("by").get<std::string>()),
                             one_line(heard.at("from").get<std::string>()),
                             one_line(heard.at("kind").get<std::string>()),
                             text_of(heard.at("message"))});
    }
  }

  static void read_graphs(TraceRobot& robot, const Json& message, double time_s) {
    std::vector<traces::TraceGraph> now;
    for (const Json& graph : message.at("graphs")) {
      now.push_back({one_line(graph.at("path").get<std::string>()),
                     one_line(graph.at("plugin").get<std::string>()), graph_of(graph)});
    }
    const auto open = std::find_if(robot.graphs.begin(), robot.graphs.end(),
                                   [](const auto& graph) { return std::isinf(graph.to_s); });
    // With other sensors, a robot has other channels with the same graphs.
    if (std::equal(
            open, robot.graphs.end(), now.begin(), now.end(),
            [](const auto& a, const auto& b) { return a.path == b.path && a.graph == b.graph; })) {
      return;
    }
    std::for_each(open, robot.graphs.end(), [&](auto& graph) { graph.to_s = time_s; });
    std::move(now.begin(), now.end(), std::back_inserter(robot.graphs));
  }

  static void read_lights(TraceRobot& robot, const Json& message, double time_s) {
    const Json& all = message.at("graphs");
    if (all.size() > robot.graphs.size()) {
      throw Unexpected("it is about more graphs than there are");
    }
    auto graph = robot.graphs.end() - static_cast<std::ptrdiff_t>(all.size());  // the last ones
    for (const Json& lights : all) {
      graph->lights.push_back({time_s, lights_of(lights, graph->graph.nodes.size())});
      ++graph;
    }
  }

  static bool is_there(const TraceRobot& robot) { return std::isinf(robot.to_s); }

  /// This message comes with every edit that may add, remove or change robots.
  void read_world(const Json& world, double time_s) {
    const auto ids = world.at("robots").get<std::set<std::string>>();
    trace_.without_decisions.merge(world.value("crowd", std::set<std::string>()));
    for (std::size_t i = 0; i < trace_.robots.size(); ++i) {
      TraceRobot& robot = trace_.robots[i];
      if (i >= introduced_) {
        robot.from_s = time_s;
      } else if (is_there(robot) &&
                 (!ids.contains(robot.id) || by_id_.at(robot.id).back() >= introduced_)) {
        robot.to_s = time_s;
      }
    }
    introduced_ = trace_.robots.size();
  }

  void read_event(const Json& event, double time_s) {
    const std::string id = event.at("name").get<std::string>();
    if (id.empty()) {
      return;  // an edit of the world
    }
    const auto known = by_id_.find(id);
    if (known == by_id_.end() && trace_.without_decisions.contains(id)) {
      return;
    }
    if (known == by_id_.end()) {
      throw Unexpected("the recording has no robot '" + one_line(id) + "'");
    }
    const std::vector<std::size_t>& namesakes = known->second;  // each from a later time on
    const auto after =
        std::find_if(namesakes.begin(), namesakes.end(),
                     [&](const std::size_t place) { return trace_.robots[place].from_s > time_s; });
    const std::size_t place = after == namesakes.begin() ? namesakes.back() : *std::prev(after);
    trace_.robots[place].events.push_back({time_s, one_line(event.at("event").get<std::string>()),
                                           one_line(event.at("detail").get<std::string>()),
                                           edit_of(event)});
  }

  void read_decision(TraceRobot& robot, const Json& decision, double time_s) {
    for (const Json& row : decision.at("behaviors")) {
      const int place = place_of(robot, row.at("path").get<std::string>());
      TraceMember& member = robot.members[static_cast<std::size_t>(place)];
      const TraceNote note = note_of(robot, member, row, time_s);
      if (member.notes.empty() || !traces::same(note, member.notes.back())) {
        member.notes.push_back(note);
      }
      if (note.asked && row.contains("time_s")) {
        // The mean is a sum until the end of the file.
        ++member.times.answers;
        member.times.mean_s += number_or_zero(row, "time_s");
        member.times.longest_s = std::max(member.times.longest_s, number_or_zero(row, "time_s"));
      }
    }
  }

  TraceNote note_of(const TraceRobot& robot, const TraceMember& member, const Json& row,
                    double time_s) {
    TraceRow read;
    read.asked = row.at("asked").get<bool>();
    read.command = {row.at("forward_m_s").get<double>(), row.at("lateral_m_s").get<double>(),
                    row.at("turn_rad_s").get<double>()};
    read.activation = degree(row, "activation");
    read.strength = degree(row, "strength");
    read.weight = number_or_zero(row, "weight");
    read.share = degree(row, "share");
    const auto inhibitor = row.at("inhibited_by").get<std::string>();
    const int by = inhibitor.empty() ? -1 : place_of(robot, inhibitor);
    if (by >= 0 && robot.members[static_cast<std::size_t>(by)].parent != member.parent) {
      throw Unexpected("'" + member.path + "' is inhibited by '" + inhibitor +
                       "', which is not under the same coordinator");
    }
    return traces::note_of(read, time_s, reason(one_line(row.at("reason").get<std::string>())), by);
  }

  std::uint32_t reason(const std::string& text) {
    const auto [known, is_new] =
        reasons_.try_emplace(text, static_cast<std::uint32_t>(trace_.reasons.size()));
    if (is_new) {
      trace_.reasons.push_back(text);
    }
    return known->second;
  }

  Trace& trace_;
  double decided_s_ = -1.0;
  std::size_t introduced_ = 0;                     // robots of the world's last message
  std::map<std::uint16_t, std::size_t> places_;    // of robots, by the ids of their channels
  std::map<std::uint16_t, std::string> readings_;  // ids of robots, by those of their channels
  std::map<std::uint16_t, std::string> hearers_;   // likewise, by those of what they hear
  // Places of robots, by those of published numbers, of graphs, and of what is lit in these.
  std::map<std::uint16_t, std::size_t> publishers_, drawn_, lit_;
  std::map<std::string, std::vector<std::size_t>> by_id_;  // places of robots, ascending
  std::map<std::string, std::uint32_t> reasons_{{"", 0}};
};

}  // namespace

traces::Trace read_trace(const std::filesystem::path& file) {
  Trace trace;
  RecordedRun run;
  TraceBuilder builder(trace);
  read_file(file, run, builder);
  const std::string what = "recording '" + file.string() + "' ";
  if (!run.of_elsie && !run.library.starts_with("elsie ")) {
    throw mcap::McapError(what + "was not made by Elsie but by '" + run.library + "'");
  }
  if (!run.of_elsie || run.channels.empty()) {
    throw mcap::McapError(what + "breaks off before its first second was written");
  }
  trace.period_s = files::rounded(run.step_s * static_cast<double>(run.control_steps), 9);
  if (!(trace.period_s > 0.0)) {
    throw mcap::McapError(what + "does not say how often robots decide");
  }
  trace.world = one_line(run.world);
  trace.world_file = one_line(run.world_file);
  trace.seed = run.seed;
  trace.step_s = run.step_s;
  if (run.result) {
    trace.end_s = files::rounded(run.result->simulated_s, 9);
    trace.outcome = run.result->outcome;
    trace.outcome_reason = one_line(run.result->reason);
  } else {
    trace.end_s =
        std::max(run.end_s, builder.decided_s() < 0.0 ? 0.0 : builder.decided_s() + trace.period_s);
    trace.cut_off = run.missing_end;
  }
  for (TraceRobot& robot : trace.robots) {
    for (traces::TraceGraph& graph : robot.graphs) graph.to_s = std::min(graph.to_s, robot.to_s);
    for (TraceMember& member : robot.members) {
      auto& times = member.times;
      times.mean_s = times.answers > 0
                         ? traces::to_four_digits(times.mean_s / static_cast<double>(times.answers))
                         : 0.0;
      times.longest_s = traces::to_four_digits(times.longest_s);
    }
  }
  return trace;
}

}  // namespace elsie::recording
