// A trace divided into the columns of a picture.
#pragma once

#include <vector>

#include "elsie/traces/trace_account.h"

namespace elsie::picture {

/// A number in a column.
struct Extent {
  double mean = 0.0;
  double low = 0.0;
  double high = 0.0;
  double time_s = 0.0;  // time during which it existed; 0: the others have no meaning

  void add(double value, double length_s);
};

struct MemberColumn {
  double robot_share = 0.0;  // mean share in the robot's command
  double inhibited = 0.0;    // share of the column's time
  Extent weight;
  Extent activation;  // while it was asked
};

/// The time during which somebody decided.
struct DeciderTime {
  traces::Decider decider = traces::kNobody;
  double part = 0.0;  // share of the column's time
};

struct Column {
  std::vector<MemberColumn> members;  // parallel to the robot's members
  std::vector<DeciderTime> deciders;  // at the robot's own coordinator; without repetitions
  double known = 0.0;                 // share of the column's time that the trace covers
};

/// `count` columns of equal length over the span, which must not be empty.
std::vector<Column> columns_of(const traces::TraceRobot& robot, const traces::TimeSpan& span,
                               std::size_t count);

/// A published number in such columns. A sample holds until the next one of the recording; where
/// that one is missing, the number did not exist, and the columns are empty.
std::vector<Extent> columns_of(const traces::TraceNumber& number, const traces::TimeSpan& span,
                               std::size_t count);

/// The share of each decider in a column's height: its share of the time, but at least `least` or,
/// if several share a column, an equal part.
std::vector<DeciderTime> heights_of(const Column& column, double least);

}  // namespace elsie::picture
