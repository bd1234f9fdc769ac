#include "elsie/traces/trace_recorder.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "elsie/output/csv_line.h"
#include "elsie/base/number_text.h"
#include "elsie/output/record_file.h"
#include "elsie/simulation/simulation.h"
#include "elsie/traces/trace.h"

#include "trace_format.h"
#include "trace_row.h"

namespace elsie::traces {
namespace {

using trace_format::Remark;

constexpr double kFlushEvery = 1.0;   // s, simulated
constexpr double kStillEvery = 10.0;  // s, simulated, after which a trace says that it goes on

}  // namespace

class TraceRecorder::Impl {
 public:
  Impl(const std::filesystem::path& file, bool with_times)
      : out_("trace '" + file.string() + "'"), with_times_(with_times) {
    std::error_code error;
    if (std::filesystem::is_regular_file(file, error) && !may_be_trace(file)) {
      throw std::runtime_error("trace '" + file.string() +
                               "' cannot be written: there is a file of that name that is no "
                               "trace; remove it or choose another name");
    }
    out_.create(file);
  }

  void start(const simulation::Simulation& simulation) {
    const world::World& world = simulation.world();
    period_steps_ = static_cast<std::uint64_t>(world.physics.control_steps);
    add(std::string(trace_format::kMagic) + std::to_string(trace_format::kVersion));
    add(Remark("run")
            .add("world", world.name)
            .add("file", world.file)
            .add("seed", std::to_string(simulation.result().seed))
            .add("step_s", base::number_text(world.physics.step))
            .add("period_s", base::number_text(output::tidy_time(world.physics.step *
                                                               static_cast<double>(period_steps_))))
            .line());
    for (std::size_t r = 0; r < simulation.robots(); ++r) {
      introduce(simulation.robot(r));
    }
    add(std::string(trace_format::kHeading));
    out_.set_last_words("# end time_s=\"",
                        Remark("\"")
                                .add("outcome", trace_format::kStopped)
                                .add("reason", "the program was brought down in the step after it")
                                .line()
                                .substr(2) +
                            "\n");
    write_events(simulation);
    out_.flush();
  }

  void step(const simulation::Simulation& simulation) {
    if ((simulation.steps() - 1) % period_steps_ == 0) {
      const double decided_s = output::tidy_time(static_cast<double>(simulation.steps() - 1) *
                                               simulation.world().physics.step);
      for (std::size_t r = 0; r < robots_.size(); ++r) {
        write_decision(decided_s, simulation.robot(r), robots_[r]);
      }
    }
    write_events(simulation);
    const double now_s = output::tidy_time(simulation.time_s());
    out_.at(now_s);
    if (now_s - written_until_s_ >= kStillEvery) {
      add(Remark("until").add("time_s", base::number_text(now_s)).line());
      written_until_s_ = now_s;
    }
    if (now_s - flushed_at_s_ >= kFlushEvery) {
      out_.flush();
      flushed_at_s_ = now_s;
    }
  }

  void end(const simulation::Simulation& simulation) {
    write_events(simulation);
    for (const RobotNotes& robot : robots_) {
      for (const MemberNotes& member : robot.members) {
        if (with_times_ && member.answers > 0) {
          add(Remark("took")
                  .add("robot", robot.id)
                  .add("behavior", member.path)
                  .add("answers", std::to_string(member.answers))
                  .add("mean_s", base::number_text(shortened(member.took_s /
                                                             static_cast<double>(member.answers))))
                  .add("longest_s", base::number_text(shortened(member.longest_s)))
                  .line());
        }
      }
    }
    const simulation::RunResult result = simulation.result();
    const bool stopped = result.outcome == simulation::Outcome::running;
    add(Remark("end")
            .add("time_s", base::number_text(output::tidy_time(result.simulated_s)))
            .add("outcome",
                 stopped ? trace_format::kStopped : simulation::to_string(result.outcome))
            .add("reason", result.reason)
            .line());
    out_.close();
  }

 private:
  struct MemberNotes {
    std::string path;
    TraceRow row;       // as it was last looked at
    std::string cells;  // as they were last written; empty: never
    std::uint64_t answers = 0;
    double took_s = 0.0;
    double longest_s = 0.0;
  };
  struct RobotNotes {
    std::string id;
    std::vector<MemberNotes> members;
    std::string command;  // the cells that were last written
  };

  void introduce(const simulation::RobotView& robot) {
    const world::Robot& description = *robot.description;
    add(Remark("robot")
            .add("id", description.id)
            .add("team", description.team)
            .add("coordinator", description.coordinator ? description.coordinator->plugin : "")
            .line());
    RobotNotes notes;
    notes.id = description.id;
    for (const simulation::TracedMember& member : robot.trace) {
      add(Remark("behavior")
              .add("robot", description.id)
              .add("path", member.path)
              .add("plugin", member.plugin)
              .add("coordinator", member.coordinator)
              .add("priority", base::number_text(member.member->priority()))
              .line());
      notes.members.push_back({member.path, {}, {}});
    }
    robots_.push_back(std::move(notes));
  }

  void write_decision(double time_s, const simulation::RobotView& robot, RobotNotes& notes) {
    for (std::size_t i = 0; i < notes.members.size(); ++i) {
      MemberNotes& last = notes.members[i];
      const TraceRow& row = robot.trace[i].member->trace;
      if (with_times_ && row.asked) {
        ++last.answers;
        last.took_s += row.time_s;
        last.longest_s = std::max(last.longest_s, row.time_s);
      }
      if (!last.cells.empty() && same(row, last.row)) {
        continue;  // most of the time, and cheaper than writing it to find out
      }
      last.row = row;
      std::string cells = cells_of(row, simulation::inhibitor_of(robot.trace[i], robot.trace));
      if (cells != last.cells) {
        last.cells = std::move(cells);
        begin_row(time_s, notes.id);
        line_.text(last.path);
        line_.cells(last.cells);
        add(line_.take());
      }
    }
    cells_.number(base::rounded(robot.command.left, kDecimals));
    cells_.number(base::rounded(robot.command.right, kDecimals));
    std::string command = cells_.take();
    if (command != notes.command) {
      notes.command = std::move(command);
      begin_row(time_s, notes.id);
      line_.empty();
      line_.empty();
      line_.cells(notes.command);
      add(line_.take());
    }
  }

  std::string cells_of(const TraceRow& row, const simulation::TracedMember* inhibitor) {
    cells_.number(row.asked ? 1 : 0);
    for (const double value : {row.command.left, row.command.right, row.activation, row.strength}) {
      row.asked ? cells_.number(base::rounded(value, kDecimals)) : cells_.empty();
    }
    cells_.number(shortened(row.weight));
    cells_.number(base::rounded(row.share, kDecimals));
    cells_.text(trace_format::one_line(row.reason));
    if (inhibitor) {
      cells_.text(inhibitor->path);
    }
    return cells_.take_short();
  }

  void write_events(const simulation::Simulation& simulation) {
    const std::span<const simulation::EventRecord> events = simulation.events();
    for (; events_ < events.size(); ++events_) {
      const simulation::EventRecord& event = events[events_];
      begin_row(output::tidy_time(event.time_s), event.robot);
      for (std::size_t i = 2; i < trace_format::kColumns - 2; ++i) {
        line_.empty();
      }
      line_.text(trace_format::one_line(event.name));
      line_.text(trace_format::one_line(event.detail));
      add(line_.take_short());
    }
  }

  void begin_row(double time_s, const std::string& robot) {
    line_.number(time_s);
    line_.text(robot);
    written_until_s_ = time_s;
  }

  void add(const std::string& line) { out_.line(line); }

  output::RecordFile out_;
  bool with_times_;
  std::uint64_t period_steps_ = 1;
  std::vector<RobotNotes> robots_;
  std::size_t events_ = 0;  // how many are written
  double written_until_s_ = 0.0;
  double flushed_at_s_ = 0.0;
  output::CsvLine line_;
  output::CsvLine cells_;
};

TraceRecorder::TraceRecorder(const std::filesystem::path& file, bool with_times)
    : impl_(std::make_unique<Impl>(file, with_times)) {}
TraceRecorder::~TraceRecorder() = default;
void TraceRecorder::started(const simulation::Simulation& simulation) { impl_->start(simulation); }
void TraceRecorder::stepped(const simulation::Simulation& simulation) { impl_->step(simulation); }
void TraceRecorder::ended(const simulation::Simulation& simulation) { impl_->end(simulation); }

}  // namespace elsie::traces
