// A trace cut into the columns of a picture.
#pragma once

#include <vector>

#include "elsie/traces/trace_account.h"

namespace elsie::picture {

/// A number over the time of a column.
struct Extent {
  double mean = 0.0;
  double low = 0.0;
  double high = 0.0;
  double time_s = 0.0;  // for how long there was one; 0: the others are unset

  void add(double value, double length_s);
};

struct MemberColumn {
  double robot_share = 0.0;  // mean part in the robot's command
  double inhibited = 0.0;    // part of the column's time
  Extent weight;
  Extent activation;  // while it was asked
};

/// How long one decider decided.
struct DeciderTime {
  traces::Decider decider = traces::kNobody;
  double part = 0.0;  // of the column's time
};

struct Column {
  std::vector<MemberColumn> members;  // in the order of the robot's members
  std::vector<DeciderTime> deciders;  // at the robot's own coordinator; none twice
  double known = 0.0;                 // part of the column's time that the trace covers
};

/// `count` columns of equal length over the span, which must not be empty.
std::vector<Column> columns_of(const traces::TraceRobot& robot, const traces::TimeSpan& span,
                               std::size_t count);

/// The part of a column's height for each of its deciders: its part of the time, but at least
/// `least` or, where several share a column, an equal part.
std::vector<DeciderTime> heights_of(const Column& column, double least);

}  // namespace elsie::picture
