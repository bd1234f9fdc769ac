#include "elsie/traces/account_recorder.h"

#include <algorithm>
#include <deque>
#include <map>
#include <memory>
#include <utility>

#include "elsie/files/clean_text.h"
#include "elsie/files/csv_line.h"
#include "elsie/simulation/simulation.h"
#include "elsie/traces/trace_rows.h"

#include "trace_tally.h"

namespace elsie::traces {

class AccountRecorder::Impl {
 public:
  void start(const simulation::Simulation& simulation) { list_robots(simulation); }

  /// A robot whose behaviours have changed starts again.
  void list_robots(const simulation::Simulation& simulation) {
    const double now_s = files::tidy_time(simulation.time_s());
    std::map<std::string, std::size_t> before;
    for (const std::size_t place : std::exchange(present_, {})) {
      before.emplace(robots_[place].id, place);
    }
    for (std::size_t r = 0; r < simulation.robots(); ++r) {
      TraceRobot robot = introduced(simulation.robot(r));
      const auto known = before.find(robot.id);
      if (known != before.end() && same_cast(robots_[known->second], robot)) {
        present_.push_back(known->second);
        before.erase(known);
        continue;
      }
      present_.push_back(robots_.size());
      robot.from_s = now_s;
      watches_.emplace_back(robot);
      robots_.push_back(std::move(robot));
    }
    for (const auto& [id, place] : before) {  // what is left is gone, or begins again
      add_up(robots_[place], watches_[place], now_s);
      robots_[place].to_s = now_s;
    }
  }

  void step(const simulation::Simulation& simulation) {
    if (!simulation.decided()) {
      return;
    }
    const double now_s = files::tidy_time(simulation.step_began_s());
    for (std::size_t r = 0; r < present_.size(); ++r) {
      look(simulation.robot(r), robots_[present_[r]], watches_[present_[r]], now_s);
    }
  }

  void end(const simulation::Simulation& simulation) {
    const double end_s = files::tidy_time(simulation.time_s());
    double first_s = end_s;
    for (const Watch& watch : watches_) {
      if (watch.begun && watch.count() > 0) {
        first_s = std::min(first_s, watch.first_s);
      }
    }
    for (std::size_t r = 0; r < watches_.size(); ++r) {
      Watch& watch = watches_[r];
      const double to_s = std::min(end_s, robots_[r].to_s);
      add_up(robots_[r], watch, to_s);
      const double from_s =
          watch.begun && watch.count() > 0 ? watch.first_s : std::max(first_s, robots_[r].from_s);
      accounts_.push_back(watch.tally.finish({std::min(from_s, to_s), to_s}));
    }
  }

  std::vector<TraceRobot> robots_;
  std::vector<RobotAccount> accounts_;
  std::vector<std::string> reasons_{""};

 private:
  struct Watch {
    explicit Watch(const TraceRobot& described)
        : robot(std::make_unique<const TraceRobot>(described)),
          rows(robot->members.size()),
          notes(robot->members.size()),
          current(robot->members.size(), nullptr),
          shares(robot->members.size()),
          tally(*robot) {}
    std::size_t count() const { return rows.size(); }

    std::unique_ptr<const TraceRobot> robot;  // the robot of the tally
    std::vector<TraceRow> rows;               // at the last look
    std::vector<TraceNote> notes;             // the notes that hold now
    std::vector<const TraceNote*> current;    // pointers to those that exist
    std::vector<double> shares;
    RobotTally tally;
    bool begun = false;
    double first_s = 0.0;
    double since_s = 0.0;  // time of the last change
  };

  static TraceRobot introduced(const simulation::RobotView& view) {
    const world::Robot& description = *view.description;
    TraceRobot robot;
    robot.id = description.id;
    robot.team = description.team;
    robot.coordinator = description.coordinator ? description.coordinator->plugin : "";
    for (const simulation::TracedMember& member : view.trace) {
      TraceMember known;
      known.path = member.path;
      known.plugin = member.plugin;
      known.coordinator = member.coordinator;
      known.priority = member.member->priority();
      known.depth = member.depth;
      known.parent = member.parent;
      robot.members.push_back(std::move(known));
    }
    return robot;
  }

  void look(const simulation::RobotView& view, const TraceRobot& robot, Watch& watch,
            double now_s) {
    for (std::size_t i = 0; i < watch.count(); ++i) {
      const TraceRow& row = view.trace[i].member->trace;
      if (watch.begun && same(row, watch.rows[i])) {
        continue;
      }
      watch.rows[i] = row;
      const simulation::TracedMember* by = inhibitor_of(view.trace[i], view.trace);
      const TraceNote note = note_of(row, now_s, place_of(row.reason),
                                     by ? static_cast<int>(by - view.trace.data()) : -1);
      if (watch.begun && same(note, watch.notes[i])) {
        continue;
      }
      add_up(robot, watch, now_s);
      watch.notes[i] = note;
    }
    if (!watch.begun) {
      watch.begun = true;
      watch.first_s = watch.since_s = now_s;
      for (std::size_t i = 0; i < watch.count(); ++i) {
        watch.current[i] = &watch.notes[i];
      }
    }
  }

  /// Adds up the notes that held until now.
  static void add_up(const TraceRobot& robot, Watch& watch, double until_s) {
    if (watch.begun && watch.count() > 0 && until_s > watch.since_s) {
      find_shares(robot, watch.current, watch.shares);
      watch.tally.add({watch.since_s, until_s, watch.current, watch.shares});
      watch.since_s = until_s;
    }
  }

  std::uint32_t place_of(const std::string& reason) {
    std::string text = files::one_line(reason);
    if (text.empty()) {
      return 0;
    }
    const auto [known, is_new] =
        places_.try_emplace(std::move(text), static_cast<std::uint32_t>(reasons_.size()));
    if (is_new) {
      reasons_.push_back(known->first);
    }
    return known->second;
  }

  std::deque<Watch> watches_;         // parallel to robots_
  std::vector<std::size_t> present_;  // places of the world's robots, in their order
  std::map<std::string, std::uint32_t> places_;
};

AccountRecorder::AccountRecorder() : impl_(std::make_unique<Impl>()) {}
AccountRecorder::~AccountRecorder() = default;
void AccountRecorder::started(const simulation::Simulation& simulation) {
  impl_->start(simulation);
}
void AccountRecorder::stepped(const simulation::Simulation& simulation) { impl_->step(simulation); }
void AccountRecorder::replaced(const simulation::Simulation& simulation) {
  impl_->list_robots(simulation);
}
void AccountRecorder::ended(const simulation::Simulation& simulation) { impl_->end(simulation); }
const std::vector<TraceRobot>& AccountRecorder::robots() const { return impl_->robots_; }
const std::vector<RobotAccount>& AccountRecorder::accounts() const { return impl_->accounts_; }
const std::vector<std::string>& AccountRecorder::reasons() const { return impl_->reasons_; }

}  // namespace elsie::traces
