#include "timeline_columns.h"

#include <algorithm>
#include <cmath>

namespace elsie::picture {
namespace {

using traces::Decider;
using traces::TraceMoment;
using traces::TraceNote;
using traces::TraceRobot;

void add(Column& column, const TraceRobot& robot, const TraceMoment& moment, double part,
         double length_s) {
  column.known += part;
  const Decider decider = traces::decider(robot, -1, moment);
  const auto known =
      std::find_if(column.deciders.begin(), column.deciders.end(),
                   [&](const DeciderTime& entry) { return entry.decider == decider; });
  if (known == column.deciders.end()) {
    column.deciders.push_back({decider, part});
  } else {
    known->part += part;
  }
  for (std::size_t i = 0; i < column.members.size(); ++i) {
    const TraceNote* note = moment.notes[i];
    if (!note) continue;
    MemberColumn& member = column.members[i];
    member.robot_share += moment.shares[i] * part;
    if (note->inhibited_by >= 0) member.inhibited += part;
    member.weight.add(note->weight, length_s);
    if (note->asked) member.activation.add(note->activation, length_s);
  }
}

void finish(Column& column) {
  for (MemberColumn& member : column.members) {
    for (Extent* extent : {&member.weight, &member.activation}) {
      if (extent->time_s > 0.0) extent->mean /= extent->time_s;
    }
  }
}

}  // namespace

void Extent::add(double value, double length_s) {
  low = time_s > 0.0 ? std::min(low, value) : value;
  high = time_s > 0.0 ? std::max(high, value) : value;
  mean += value * length_s;
  time_s += length_s;
}

std::vector<Column> columns_of(const TraceRobot& robot, const traces::TimeSpan& span,
                               std::size_t count) {
  std::vector<Column> columns(count);
  for (Column& column : columns) column.members.resize(robot.members.size());
  const double length = (span.to_s - span.from_s) / static_cast<double>(count);
  const auto border = [&](std::size_t i) { return span.from_s + length * static_cast<double>(i); };
  std::size_t first = 0;  // the column in which the next moment begins
  traces::walk(robot, span, [&](const TraceMoment& moment) {
    while (first + 1 < count && border(first + 1) <= moment.from_s) ++first;
    for (std::size_t i = first; i < count && (i == first || border(i) < moment.to_s); ++i) {
      const double from = std::max(moment.from_s, border(i));
      const double to = i + 1 == count ? moment.to_s : std::min(moment.to_s, border(i + 1));
      if (to > from) add(columns[i], robot, moment, (to - from) / length, to - from);
    }
  });
  for (Column& column : columns) finish(column);
  return columns;
}

std::vector<Extent> columns_of(const traces::TraceNumber& number, const traces::TimeSpan& span,
                               std::size_t count) {
  std::vector<Extent> columns(count);
  const double length = (span.to_s - span.from_s) / static_cast<double>(count);
  for (std::size_t s = 0; s < number.samples.size(); ++s) {
    if (std::isnan(number.samples[s].value)) continue;
    const double begin = std::max(number.samples[s].time_s, span.from_s);
    double end = span.to_s;
    if (s + 1 < number.samples.size()) end = std::min(end, number.samples[s + 1].time_s);
    const auto first = static_cast<std::size_t>(std::max(0.0, (begin - span.from_s) / length));
    for (std::size_t i = first; i < count; ++i) {
      const double from = span.from_s + length * static_cast<double>(i);
      const double part = std::min(end, from + length) - std::max(begin, from);
      if (part <= 0.0) break;
      columns[i].add(number.samples[s].value, part);
    }
  }
  for (Extent& extent : columns) {
    if (extent.time_s > 0.0) extent.mean /= extent.time_s;
  }
  return columns;
}

std::vector<DeciderTime> heights_of(const Column& column, double least) {
  std::vector<DeciderTime> heights = column.deciders;
  std::sort(heights.begin(), heights.end(),
            [](const DeciderTime& a, const DeciderTime& b) { return a.decider < b.decider; });
  const double floor =
      std::min(least, 1.0 / static_cast<double>(std::max<std::size_t>(1, heights.size())));
  // Long parts give their surplus to short ones, in proportion.
  double missing = 0.0, spare = 0.0, all = 0.0;
  for (const DeciderTime& entry : heights) all += entry.part;
  for (DeciderTime& entry : heights) {
    entry.part = all > 0.0 ? entry.part / all : 0.0;
    missing += std::max(0.0, floor - entry.part);
    spare += std::max(0.0, entry.part - floor);
  }
  for (DeciderTime& entry : heights) {
    entry.part = entry.part < floor
                     ? floor
                     : entry.part - (spare > 0.0 ? missing * (entry.part - floor) / spare : 0.0);
  }
  return heights;
}

}  // namespace elsie::picture
