#include "elsie/recording/csv_recorder.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "elsie/files/csv_line.h"
#include "elsie/files/record_file.h"
#include "elsie/simulation/simulation.h"
#include "elsie/traces/sampling.h"
#include "elsie/traces/trace_rows.h"

namespace elsie::recording {
namespace {

constexpr const char* kBodyColumns =
    "time_s,robot,x_m,y_m,heading_rad,forward_m_s,lateral_m_s,turn_rad_s,distance_m,energy,"
    "asked_forward_m_s,asked_lateral_m_s,asked_turn_rad_s,"
    "command_forward_m_s,command_lateral_m_s,command_turn_rad_s";
constexpr const char* kBeliefColumns = ",believed_x_m,believed_y_m,believed_heading_rad";
constexpr double kFlushEvery = 1.0;  // s, simulated: the time that a killed program may lose
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kTraceColumns = 10;
constexpr const char* kTraceNames[kTraceColumns] = {
    "asked",    "forward_m_s", "lateral_m_s", "turn_rad_s",   "activation",
    "strength", "weight",      "share",       "inhibited_by", "reason"};

std::size_t place_of(std::vector<std::string>& columns, const std::string& name) {
  const auto at = std::find(columns.begin(), columns.end(), name);
  if (at != columns.end()) {
    return static_cast<std::size_t>(at - columns.begin());
  }
  columns.push_back(name);
  return columns.size() - 1;
}

class CsvRecorder final : public simulation::Observer {
 public:
  CsvRecorder(const std::filesystem::path& file, const RecorderOptions& options)
      : out_("recording '" + file.string() + "'"),
        rate_hz_(options.rate_hz),
        with_times_(options.with_times),
        robots_(options.robots.begin(), options.robots.end()) {
    if (!(rate_hz_ > 0.0) || !std::isfinite(rate_hz_)) {
      throw std::runtime_error("a recording needs a positive number of samples a second");
    }
    out_.create(file);
  }

  void started(const simulation::Simulation& simulation) override {
    const double step = simulation.world().physics.step;
    sampling_ =
        traces::Sampling(static_cast<double>(traces::steps_in(1.0 / rate_hz_, step)) * step);
    sampling_.is_due(simulation.time_s());
    lay_out(simulation);
    believes_ = believes(simulation);
    std::string all = kBodyColumns;
    if (believes_) all += kBeliefColumns;
    for (const std::string& name : reading_columns_) {
      all += ',' + quoted(name);
    }
    for (const std::string& behavior : behaviors_) {
      for (const char* name : kTraceNames) {
        all += ',' + quoted("behavior[" + behavior + "]." + name);
      }
      if (with_times_) {
        all += ',' + quoted("behavior[" + behavior + "].time_s");
      }
    }
    for (const std::string& name : published_columns_) {
      all += ',' + quoted(name);
    }
    out_.line(all);
    sample(simulation);
  }

  void stepped(const simulation::Simulation& simulation) override {
    if (sampling_.is_due(simulation.time_s())) {
      sample(simulation);
      if (simulation.time_s() - flushed_at_s_ >= kFlushEvery) {
        out_.flush();
        flushed_at_s_ = simulation.time_s();
      }
    }
  }

  void ended(const simulation::Simulation&) override { out_.close(); }

  /// The heading line is written already: new numbers get no column.
  void replaced(const simulation::Simulation& simulation) override {
    const auto readings = reading_columns_, behaviors = behaviors_, published = published_columns_;
    lay_out(simulation);
    const auto find_again = [](std::vector<std::size_t>& places,
                               const std::vector<std::string>& now,
                               const std::vector<std::string>& columns) {
      for (std::size_t& place : places) {
        const auto known = std::find(columns.begin(), columns.end(), now[place]);
        place = static_cast<std::size_t>(known - columns.begin());
      }
    };
    for (Places& places : places_) {
      find_again(places.readings, reading_columns_, readings);
      find_again(places.behaviors, behaviors_, behaviors);
      find_again(places.published, published_columns_, published);
    }
    reading_columns_ = readings;
    behaviors_ = behaviors;
    published_columns_ = published;
  }

 private:
  /// The places of each robot's readings and behaviours in a row.
  struct Places {
    std::size_t robot = 0;               // its own place in the simulation
    std::vector<std::size_t> readings;   // of each number, sensors in order; then of messages
    std::vector<std::size_t> behaviors;  // of each member
    std::vector<std::size_t> published;  // of each number of the robot, then of measures
  };

  static bool believes(const simulation::Simulation& simulation) {
    const auto& robots = simulation.world().robots;
    return std::any_of(robots.begin(), robots.end(),
                       [](const world::Robot& robot) { return robot.localisation.has_value(); });
  }

  /// The readings of sensors and the commands of actuators.
  template <class Visit>
  static void visit_values(const simulation::Simulation& simulation, std::size_t robot,
                           const Visit& visit) {
    for (std::size_t s = 0; s < simulation.sensors(robot); ++s) {
      const std::string of = "sensor[" + std::string(simulation.sensor(robot, s).id) + "]";
      simulation.visit_reading(robot, s, [&](const ReadingField& field) { visit(of, field); });
    }
    for (std::size_t a = 0; a < simulation.actuators(robot); ++a) {
      const std::string of = "actuator[" + std::string(simulation.actuator(robot, a).id) + "]";
      simulation.visit_command(robot, a, [&](const ReadingField& field) { visit(of, field); });
    }
  }

  /// The numbers that the plugins of a robot publish, then those of measures.
  static void visit_published(const simulation::Simulation& simulation, std::size_t robot,
                              const simulation::VisitPublished& visit) {
    simulation.visit_published(robot, visit);
    simulation.visit_published(visit);
  }

  static std::string quoted(const std::string& name) {
    files::CsvLine line;
    line.text(name);
    return line.take();
  }

  void lay_out(const simulation::Simulation& simulation) {
    places_.clear();
    reading_columns_.clear();
    behaviors_.clear();
    published_columns_.clear();
    for (std::size_t r = 0; r < simulation.robots(); ++r) {
      if (!robots_.empty() && !robots_.contains(simulation.robot(r).description->id)) {
        continue;
      }
      Places places;
      places.robot = r;
      visit_values(simulation, r, [&](const std::string& of, const ReadingField& field) {
        for (std::size_t i = 0; field.is_number() && i < field.size; ++i) {
          places.readings.push_back(place_of(reading_columns_, of + "." + field.column(i)));
        }
      });
      if (simulation.robot(r).talk) {
        for (const char* name : {"talk.sent", "talk.heard"}) {
          places.readings.push_back(place_of(reading_columns_, name));
        }
      }
      for (const simulation::TracedMember& member : simulation.robot(r).trace) {
        places.behaviors.push_back(place_of(behaviors_, member.path));
      }
      visit_published(simulation, r, [&](const simulation::PublishedValue& each) {
        places.published.push_back(
            place_of(published_columns_, std::string(each.path) + "." + each.number.name));
      });
      places_.push_back(std::move(places));
    }
  }

  void sample(const simulation::Simulation& simulation) {
    for (const Places& places : places_) {
      const simulation::RobotView robot = simulation.robot(places.robot);
      line_.number(files::tidy_time(simulation.time_s()));
      line_.text(robot.description->id);
      for (const double value :
           {robot.pose.x, robot.pose.y, robot.pose.heading_rad, robot.moving.forward,
            robot.moving.lateral, robot.moving.turn, robot.distance_m, robot.state->energy,
            robot.asked.forward, robot.asked.lateral, robot.asked.turn, robot.command.forward,
            robot.command.lateral, robot.command.turn}) {
        line_.number(value);
      }
      if (believes_) write_belief(robot);
      write_readings(simulation, robot, places);
      write_trace(robot, places, simulation.steps() > 0);
      write_published(simulation, places);
      out_.line(line_.take());
    }
  }

  void write_belief(const simulation::RobotView& robot) {
    const Pose& pose = robot.state->pose;
    for (const double value : {pose.x, pose.y, pose.heading_rad}) {
      robot.description->localisation ? line_.number(value) : line_.empty();
    }
  }

  void write_readings(const simulation::Simulation& simulation, const simulation::RobotView& robot,
                      const Places& places) {
    row_.assign(reading_columns_.size() + 1, kNone);  // the last: numbers without a column
    const bool measured = simulation.steps() > 0;
    auto place = places.readings.begin();
    const auto take = [&](const std::string&, const ReadingField& field) {
      for (std::size_t i = 0; field.is_number() && i < field.size; ++i) {
        row_[*place++] = i < field.count ? field.number(i) : kNone;
      }
    };
    if (measured) visit_values(simulation, places.robot, take);
    if (measured && robot.talk) {
      row_[*place++] = robot.talk->sent;
      row_[*place++] = robot.talk->heard;
    }
    write_row();
  }

  void write_published(const simulation::Simulation& simulation, const Places& places) {
    row_.assign(published_columns_.size() + 1, kNone);  // the last: numbers without a column
    const bool decided = simulation.steps() > 0;
    auto place = places.published.begin();
    const auto take = [&](const simulation::PublishedValue& each) {
      row_[*place++] = decided ? each.value : kNone;
    };
    if (!places.published.empty()) visit_published(simulation, places.robot, take);
    write_row();
  }

  /// Writes all numbers of the row but the last.
  void write_row() {
    row_.pop_back();
    for (const double value : row_) {
      std::isnan(value) ? line_.empty() : line_.number(value);
    }
  }

  void write_trace(const simulation::RobotView& robot, const Places& places, bool decided) {
    std::vector<const simulation::TracedMember*>& rows = trace_;
    rows.assign(behaviors_.size() + 1, nullptr);  // the last: behaviours without a column
    for (std::size_t i = 0; decided && i < robot.trace.size(); ++i) {
      rows[places.behaviors[i]] = &robot.trace[i];
    }
    rows.pop_back();
    for (const simulation::TracedMember* member : rows) {
      if (!member) {
        for (std::size_t i = 0; i < kTraceColumns + (with_times_ ? 1 : 0); ++i) {
          line_.empty();
        }
        continue;
      }
      const TraceRow* trace = &member->member->trace;
      for (const double value :
           {trace->asked ? 1.0 : 0.0, trace->command.forward, trace->command.lateral,
            trace->command.turn, trace->activation, trace->strength, trace->weight, trace->share}) {
        line_.number(value);
      }
      const simulation::TracedMember* inhibitor = traces::inhibitor_of(*member, robot.trace);
      inhibitor ? line_.text(inhibitor->path) : line_.empty();
      line_.text(trace->reason);
      if (with_times_) {
        line_.number(trace->time_s);
      }
    }
  }

  files::RecordFile out_;
  double rate_hz_;
  bool with_times_;
  bool believes_ = false;         // a robot had a localisation at the start
  std::set<std::string> robots_;  // ids; empty: all
  double flushed_at_s_ = 0.0;
  traces::Sampling sampling_;
  std::vector<std::string> reading_columns_;
  std::vector<std::string> behaviors_;
  std::vector<std::string> published_columns_;
  std::vector<Places> places_;
  std::vector<double> row_;  // numbers; kNone: there is none
  std::vector<const simulation::TracedMember*> trace_;
  files::CsvLine line_;
};

}  // namespace

std::unique_ptr<simulation::Observer> csv_recorder(const std::filesystem::path& file,
                                                   const RecorderOptions& options) {
  return std::make_unique<CsvRecorder>(file, options);
}

Format csv_format() {
  return {
      .suffix = ".csv", .description = "a table", .mark = kBodyColumns, .recorder = csv_recorder};
}

}  // namespace elsie::recording
