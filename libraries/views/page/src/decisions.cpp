#include "decisions.h"

#include <cmath>
#include <limits>
#include <map>
#include <span>

#include <nlohmann/json.hpp>

#include "elsie/files/clean_text.h"
#include "elsie/page/viewer.h"
#include "elsie/picture/svg.h"
#include "elsie/picture/timeline.h"
#include "elsie/traces/trace_account.h"

namespace elsie::page {
namespace {

using nlohmann::json;
using traces::Decider;
using traces::TraceMoment;
using traces::TraceRobot;

constexpr double kHundred = 100.0;  // shares are whole parts of it

/// The decisions of one coordinator.
struct Band {
  int parent = -1;
  std::string coordinator;
  std::vector<std::int64_t> times, deciders, reasons;

  void add(std::int64_t time, Decider decider, std::uint32_t reason) {
    if (!deciders.empty() && deciders.back() == decider && reasons.back() == reason) return;
    times.push_back(time);
    deciders.push_back(decider);
    reasons.push_back(reason);
  }
};

/// The robot's coordinators: its own, and those of behaviours that contain others.
std::vector<Band> bands_of(const TraceRobot& robot) {
  std::vector<Band> bands;
  for (const traces::TraceMember& member : robot.members) {
    const auto same = [&](const Band& band) { return band.parent == member.parent; };
    if (std::none_of(bands.begin(), bands.end(), same)) {
      bands.push_back({member.parent, member.coordinator, {}, {}, {}});
    }
  }
  return bands;
}

/// Sums over one column of time.
class Column {
 public:
  Column(const TraceRobot& robot, std::vector<Band>& bands)
      : robot_(robot), bands_(bands), who_(bands.size()), shares_(robot.members.size()) {}

  void add(const TraceMoment& moment, double length_s) {
    for (std::size_t i = 0; i < bands_.size(); ++i) {
      const Decider decider = traces::decider(robot_, bands_[i].parent, moment);
      const auto member = static_cast<std::size_t>(std::max(decider, 0));
      const std::uint32_t reason = decider < 0 ? 0 : moment.notes[member]->reason;
      who_[i][{decider, reason}] += length_s;
    }
    for (std::size_t i = 0; i < shares_.size(); ++i) shares_[i] += length_s * moment.shares[i];
    length_s_ += length_s;
  }

  /// Ends the column that began then, and begins another one.
  void flush(double from_s, std::vector<std::int64_t>& times,
             std::vector<std::vector<std::int64_t>>& shares) {
    if (length_s_ <= 0.0) return;
    for (std::size_t i = 0; i < bands_.size(); ++i) {
      const auto longest =
          std::max_element(who_[i].begin(), who_[i].end(),
                           [](const auto& a, const auto& b) { return a.second < b.second; });
      bands_[i].add(fine(from_s), longest->first.first, longest->first.second);
      who_[i].clear();
    }
    bool differ = times.empty();
    std::vector<std::int64_t> parts;
    for (std::size_t i = 0; i < shares_.size(); ++i) {
      parts.push_back(std::llround(kHundred * shares_[i] / length_s_));
      differ = differ || parts[i] != shares[i].back();
      shares_[i] = 0.0;
    }
    for (std::size_t i = 0; differ && i < parts.size(); ++i) shares[i].push_back(parts[i]);
    if (differ) times.push_back(fine(from_s));
    length_s_ = 0.0;
  }

 private:
  const TraceRobot& robot_;
  std::vector<Band>& bands_;
  std::vector<std::map<std::pair<Decider, std::uint32_t>, double>> who_;
  std::vector<double> shares_;
  double length_s_ = 0.0;
};

}  // namespace

Decisions::Decisions(const traces::Trace& trace)
    : trace_(trace), column_s_(std::max(trace.period_s, 1e-3)) {}

bool Decisions::thin() {
  if (trace_.end_s / column_s_ <= kFewestSamples) return false;
  column_s_ *= 2.0;
  return true;
}

std::string Decisions::robot_text(const TraceRobot& robot) const {
  std::vector<Band> bands = bands_of(robot);
  Column column(robot, bands);
  std::vector<std::int64_t> times;
  std::vector<std::vector<std::int64_t>> shares(robot.members.size());
  const traces::TimeSpan span = traces::within(traces::within({}, trace_), robot);
  constexpr double kHair = 1e-6;  // of a column
  double began_s = span.from_s, number = std::floor(span.from_s / column_s_ + kHair);
  traces::walk(robot, span, [&](const TraceMoment& moment) {
    double from_s = moment.from_s;
    while (from_s < moment.to_s) {
      double end_s = (number + 1.0) * column_s_;
      // Whole columns in one moment are all alike: a few of them will do.
      const double last = std::floor(moment.to_s / column_s_ + kHair);
      const bool is_whole = from_s <= began_s && last > number + 2.0;
      if (is_whole) end_s = last * column_s_;
      const double to_s = std::min(end_s, moment.to_s);
      column.add(moment, to_s - from_s);
      if (end_s <= moment.to_s + kHair * column_s_) {
        column.flush(began_s, times, shares);
        number = is_whole ? last : number + 1.0;
        began_s = to_s;
      }
      from_s = to_s;
    }
  });
  column.flush(began_s, times, shares);

  const auto colours = picture::behavior_colours(trace_);
  json members = json::array();
  for (const traces::TraceMember& member : robot.members) {
    members.push_back({{"path", files::one_line(member.path)},
                       {"plugin", files::one_line(member.plugin)},
                       {"parent", member.parent},
                       {"depth", member.depth},
                       {"colour", picture::hex_text(colours.at(member.path))}});
  }
  std::string out = "{\"robot\":" + json(files::one_line(robot.id)).dump() +
                    ",\"from\":" + std::to_string(fine(span.from_s)) +
                    ",\"to\":" + std::to_string(fine(span.to_s)) +
                    ",\"members\":" + members.dump() + ",\"bands\":[";
  for (std::size_t i = 0; i < bands.size(); ++i) {
    const Band& band = bands[i];
    out += (i > 0 ? ",{\"parent\":" : "{\"parent\":") + std::to_string(band.parent) +
           ",\"coordinator\":" + json(files::one_line(band.coordinator)).dump() + ",\"t\":";
    append_differences(out, band.times);
    append_list(out += ",\"who\":", band.deciders);
    append_list(out += ",\"why\":", band.reasons);
    out += '}';
  }
  append_differences(out += "],\"t\":", times);
  out += ",\"shares\":[";
  for (std::size_t i = 0; i < shares.size(); ++i) {
    append_differences(out += i > 0 ? "," : "", shares[i]);
  }
  return out += "]}";
}

std::string Decisions::text() const {
  json reasons = json::array();
  for (const std::string& reason : trace_.reasons) reasons.push_back(files::one_line(reason));
  std::string out = "\"reasons\":" + reasons.dump() + ",\"decisions\":[";
  char separator = ' ';
  for (const TraceRobot& robot : trace_.robots) {
    if (robot.members.empty()) continue;
    (out += std::exchange(separator, ',')) += robot_text(robot);
  }
  return out += ']';
}

bool Numbers::thin() {
  std::size_t most = 0;
  for (const TraceRobot& robot : trace_.robots) {
    for (const traces::TraceNumber& number : robot.numbers) {
      most = std::max(most, number.samples.size());
    }
  }
  if (most / every_ <= kFewestSamples) return false;
  every_ *= 2;
  return true;
}

std::string Numbers::text() const {
  constexpr double kSteps = 2000.0;  // of a curve's height: finer than a pixel
  std::string out = "\"numbers\":[";
  char separator = ' ';
  for (const TraceRobot& robot : trace_.robots) {
    for (const traces::TraceNumber& number : robot.numbers) {
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (const auto& sample : number.samples) {
        if (!std::isfinite(sample.value)) continue;
        low = std::min(low, sample.value);
        high = std::max(high, sample.value);
      }
      if (!(low <= high)) continue;  // it never had a value
      const double step = high > low ? (high - low) / kSteps : 1.0;
      std::vector<std::int64_t> times, values, missing;
      for (std::size_t i = 0; i < number.samples.size(); i += every_) {
        const auto& sample = number.samples[i];
        const bool is_there = std::isfinite(sample.value);
        if (!is_there) missing.push_back(static_cast<std::int64_t>(times.size()));
        times.push_back(fine(sample.time_s));
        values.push_back(is_there         ? std::llround((sample.value - low) / step)
                         : values.empty() ? 0
                                          : values.back());
      }
      (out += std::exchange(separator, ',')) += json{
          {"robot", files::one_line(robot.id)},
          {"name", files::one_line(number.path + "." + number.name)},
          {"unit", number.unit},
          {"low", low},
          {"step", step}}.dump();
      out.pop_back();
      append_differences(out += ",\"t\":", times);
      append_differences(out += ",\"v\":", values);
      append_list(out += ",\"none\":", missing);
      out += '}';
    }
  }
  return out += ']';
}

}  // namespace elsie::page
