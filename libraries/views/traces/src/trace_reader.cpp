#include <algorithm>
#include <cerrno>
#include <fstream>
#include <map>
#include <string>
#include <string_view>
#include <system_error>

#include "elsie/base/read_whole.h"
#include "elsie/traces/trace.h"

#include "trace_format.h"
#include "trace_line.h"

namespace elsie::traces {
namespace {

/// Columns of the heading, in its order.
enum Column : std::size_t {
  kTime,
  kRobot,
  kBehavior,
  kAsked,
  kLeft,
  kRight,
  kActivation,
  kStrength,
  kWeight,
  kShare,
  kReason,
  kInhibitedBy,
  kEvent,
  kDetail,
};

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : file_(file.string()) {
    if (const std::string why = base::why_unreadable(file); !why.empty()) {
      throw TraceError("trace '" + file_ + "' " + why);
    }
    in_.open(file);
    if (!in_) {
      throw TraceError("trace '" + file_ +
                       "' cannot be opened: " + std::generic_category().message(errno));
    }
  }

  Trace read() {
    try {
      read_head();
      while (next_line()) {
        if (ended_) {
          throw TraceLineError("something follows after the end of the trace");
        }
        line_.starts_with('#') ? read_remark() : read_row();
      }
    } catch (const TraceLineError& error) {
      fail(error.problem());
    }
    if (in_.bad()) {
      throw TraceError("trace '" + file_ + "' could not be read to its end");
    }
    if (!ended_) {
      trace_.end_s = decided_ ? std::max(last_s_, last_decision_s_ + trace_.period_s) : last_s_;
    }
    return std::move(trace_);
  }

 private:
  struct RobotPlaces {
    std::map<std::string, std::size_t, std::less<>> members;
  };

  /// False at the end of the file. A last line without an end is no line: it may be cut off.
  bool next_line() {
    if (!std::getline(in_, line_)) {
      return false;
    }
    ++number_;
    if (in_.eof()) {
      trace_.cut_off = "line " + std::to_string(number_) +
                       " is cut off and was left out; everything before it was read";
      return false;
    }
    return true;
  }

  void read_head() {
    const bool any = next_line();
    const bool begun = std::string_view(line_).starts_with(trace_format::kMagic);
    if (!begun && (any || !trace_format::kMagic.starts_with(line_))) {
      throw TraceError("'" + file_ + "' is no trace: its first line does not begin with '" +
                       std::string(trace_format::kMagic) +
                       "'. Traces are written by `elsie run WORLD --explain FILE.trace`");
    }
    if (any) {
      const std::string version = line_.substr(trace_format::kMagic.size());
      if (version != std::to_string(trace_format::kVersion)) {
        throw TraceError("'" + file_ + "' is a trace of format " + shown(version) +
                         ", but this program reads format " +
                         std::to_string(trace_format::kVersion) +
                         " only; use the program that wrote it, or record the run anew");
      }
      bool introduced = false;
      while (next_line()) {
        if (line_ == trace_format::kHeading) {
          if (!introduced) {
            throw TraceLineError("the line '# run' is missing above the heading");
          }
          return;
        }
        if (!line_.starts_with("# ")) {
          throw TraceLineError("a line of the head or the heading '" +
                               std::string(trace_format::kHeading.substr(0, 30)) +
                               "...' was expected");
        }
        read_head_line(ParsedRemark(line_), introduced);
      }
    }
    throw TraceError("trace '" + file_ +
                     "' ends within its head: the program was stopped before the run began, and "
                     "there is nothing in it to read");
  }

  void read_head_line(const ParsedRemark& remark, bool& introduced) {
    if (remark.word() == "run" && !introduced) {
      introduced = true;
      trace_.world = remark["world"];
      trace_.world_file = remark["file"];
      trace_.seed = count_in(remark["seed"], "seed");
      trace_.step_s = positive(remark["step_s"], "step_s");
      trace_.period_s = positive(remark["period_s"], "period_s");
      trace_.reasons = {""};
      reasons_[""] = 0;
    } else if (remark.word() == "robot") {
      if (!robots_.try_emplace(remark["id"], trace_.robots.size()).second) {
        throw TraceLineError("the robot " + shown(remark["id"]) + " is there twice");
      }
      trace_.robots.push_back({remark["id"], remark["team"], remark["coordinator"], {}, {}, {}});
      places_.emplace_back();
    } else if (remark.word() == "behavior") {
      read_behavior(remark);
    } else {
      throw TraceLineError("'# " + remark.word() +
                           "' stands in the head, where only one '# run', " +
                           "then '# robot' and '# behavior' are expected");
    }
  }

  void read_behavior(const ParsedRemark& remark) {
    const std::size_t r = robot_at(remark["robot"]);
    TraceMember member;
    member.path = remark["path"];
    member.plugin = remark["plugin"];
    member.coordinator = remark["coordinator"];
    member.priority = number_in(remark["priority"], "priority");
    if (const std::size_t slash = member.path.rfind('/'); slash != std::string::npos) {
      member.parent = static_cast<int>(member_at(r, member.path.substr(0, slash)));
      member.depth = trace_.robots[r].members[static_cast<std::size_t>(member.parent)].depth + 1;
    }
    if (!places_[r].members.try_emplace(member.path, trace_.robots[r].members.size()).second) {
      throw TraceLineError("the behaviour " + shown(member.path) + " is there twice");
    }
    trace_.robots[r].members.push_back(std::move(member));
  }

  void read_remark() {
    if (!line_.starts_with("# ")) {
      throw TraceLineError("a line that begins with '#' goes on with a space and a word");
    }
    const ParsedRemark remark(line_);
    if (remark.word() == "until") {
      advance(number_in(remark["time_s"], "time_s"));
    } else if (remark.word() == "took") {
      const std::size_t r = robot_at(remark["robot"]);
      trace_.robots[r].members[member_at(r, remark["behavior"])].times = {
          count_in(remark["answers"], "answers"), number_in(remark["mean_s"], "mean_s"),
          number_in(remark["longest_s"], "longest_s")};
    } else if (remark.word() == "end") {
      advance(number_in(remark["time_s"], "time_s"));
      trace_.end_s = last_s_;
      trace_.outcome = remark["outcome"];
      trace_.outcome_reason = remark["reason"];
      ended_ = true;
    } else {
      throw TraceLineError(shown("# " + remark.word()) +
                           " is not known here; there are '# until', '# took' and '# end'");
    }
  }

  void read_row() {
    row_.parse(line_);
    const double time_s = number_in(row_[kTime], "time_s");
    advance(time_s);
    const std::size_t r = robot_at(row_[kRobot]);
    TraceRobot& robot = trace_.robots[r];
    if (!row_[kEvent].empty()) {
      expect_empty(kBehavior, kInhibitedBy, "an event");
      robot.events.push_back({time_s, std::string(row_[kEvent]), std::string(row_[kDetail])});
      return;
    }
    expect_empty(kDetail, kDetail, "anything but an event");
    last_decision_s_ = time_s;
    decided_ = true;
    if (row_[kBehavior].empty()) {
      expect_empty(kAsked, kAsked, "a command");
      expect_empty(kActivation, kInhibitedBy, "a command");
      robot.commands.push_back({time_s, command()});
      return;
    }
    const std::size_t place = member_at(r, row_[kBehavior]);
    TraceMember& member = robot.members[place];
    if (!member.notes.empty() && member.notes.back().time_s >= time_s) {
      throw TraceLineError("there is a second row for '" + member.path + "' of '" + robot.id +
                           "' at " + std::string(row_[kTime]) + " s");
    }
    member.notes.push_back(note(time_s, r, member));
  }

  TraceNote note(double time_s, std::size_t r, const TraceMember& member) {
    TraceNote note;
    note.time_s = time_s;
    if (row_[kAsked] != "0" && row_[kAsked] != "1") {
      throw TraceLineError(shown(row_[kAsked]) + " stands as asked, where 0 or 1 " +
                           "was expected");
    }
    note.asked = row_[kAsked] == "1";
    if (note.asked) {
      note.command = command();
      note.activation = degree_in(row_[kActivation], "activation");
      note.strength = degree_in(row_[kStrength], "strength");
    } else {
      expect_empty(kLeft, kStrength, "a behaviour that was not asked");
    }
    note.weight = number_in(row_[kWeight], "weight");
    note.share = number_in(row_[kShare], "share");
    note.reason = reason(row_[kReason]);
    if (!row_[kInhibitedBy].empty()) {
      const std::size_t by = member_at(r, row_[kInhibitedBy]);
      if (trace_.robots[r].members[by].parent != member.parent) {
        throw TraceLineError("'" + member.path + "' is inhibited by " + shown(row_[kInhibitedBy]) +
                             ", which is not under the same coordinator");
      }
      note.inhibited_by = static_cast<int>(by);
    }
    return note;
  }

  MotorCommand command() const {
    return {number_in(row_[kLeft], "left"), number_in(row_[kRight], "right")};
  }

  void expect_empty(std::size_t first, std::size_t last, const char* in) const {
    for (std::size_t column = first; column <= last; ++column) {
      if (!row_[column].empty()) {
        throw TraceLineError("there is " + shown(row_[column]) + " in cell " +
                             std::to_string(column + 1) + ", which is empty for " + in);
      }
    }
  }

  void advance(double time_s) {
    if (time_s < last_s_) {
      throw TraceLineError("the time goes back from " + std::to_string(last_s_) + " s to " +
                           std::to_string(time_s) + " s");
    }
    last_s_ = time_s;
  }

  std::uint32_t reason(std::string_view text) {
    const auto known = reasons_.find(text);
    if (known != reasons_.end()) {
      return known->second;
    }
    const auto place = static_cast<std::uint32_t>(trace_.reasons.size());
    trace_.reasons.emplace_back(text);
    reasons_.emplace(text, place);
    return place;
  }

  std::size_t robot_at(std::string_view id) const {
    const auto at = robots_.find(id);
    if (at == robots_.end()) {
      throw TraceLineError("the robot " + shown(id) + " is not in the head of the trace");
    }
    return at->second;
  }

  std::size_t member_at(std::size_t robot, std::string_view path) const {
    const auto at = places_[robot].members.find(path);
    if (at == places_[robot].members.end()) {
      throw TraceLineError("the behaviour " + shown(path) + " of the robot '" +
                           trace_.robots[robot].id + "' is not in the head of the trace");
    }
    return at->second;
  }

  static double positive(std::string_view text, const char* name) {
    const double value = number_in(text, name);
    if (!(value > 0.0)) {
      throw TraceLineError(shown(text) + " stands as " + name +
                           ", where a number above 0 was expected");
    }
    return value;
  }

  [[noreturn]] void fail(const std::string& problem) const {
    std::string sentence = file_ + ":" + std::to_string(number_) + ": " + problem;
    if (decided_) {
      sentence += "; the lines above it are whole: `head -n " + std::to_string(number_ - 1) +
                  "` takes them out";
    }
    throw TraceError(sentence);
  }

  std::string file_;
  std::ifstream in_;
  std::string line_;
  std::size_t number_ = 0;
  Trace trace_;
  ParsedRow row_;
  bool ended_ = false;
  bool decided_ = false;
  double last_s_ = 0.0;
  double last_decision_s_ = 0.0;
  std::map<std::string, std::size_t, std::less<>> robots_;
  std::vector<RobotPlaces> places_;
  std::map<std::string, std::uint32_t, std::less<>> reasons_;
};

}  // namespace

Trace read_trace(const std::filesystem::path& file) { return Reader(file).read(); }

bool may_be_trace(const std::filesystem::path& file) {
  if (!base::why_unreadable(file).empty()) {
    return false;
  }
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    return false;
  }
  std::string begin(trace_format::kMagic.size(), '\0');
  in.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(in.gcount()));
  return begin == trace_format::kMagic || begin.empty();
}

}  // namespace elsie::traces
