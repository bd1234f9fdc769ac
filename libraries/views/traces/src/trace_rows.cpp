#include "elsie/traces/trace_rows.h"

#include <charconv>

#include "elsie/base/number_text.h"
#include "elsie/files/rounded.h"

namespace elsie::traces {
namespace {

constexpr int kDecimals = 3;
constexpr int kMotionDecimals = 5;  // 0.01 mm/s
constexpr int kWeightDigits = 4;

}  // namespace

Motion kept(const Motion& motion) {
  return {files::rounded(motion.forward, kMotionDecimals),
          files::rounded(motion.lateral, kMotionDecimals),
          files::rounded(motion.turn, kMotionDecimals)};
}

double to_four_digits(double value) {
  const std::string digits = base::number_text(value, kWeightDigits);
  double result = 0.0;
  std::from_chars(digits.data(), digits.data() + digits.size(), result);
  return result + 0.0;
}

TraceRow kept(TraceRow row) {
  row.command = row.asked ? kept(row.command) : Motion{};
  row.activation = row.asked ? files::rounded(row.activation, kDecimals) : 0.0;
  row.strength = row.asked ? files::rounded(row.strength, kDecimals) : 0.0;
  row.weight = to_four_digits(row.weight);
  row.share = files::rounded(row.share, kDecimals);
  return row;
}

bool same(const TraceRow& a, const TraceRow& b) {
  return a.asked == b.asked && a.command == b.command && a.activation == b.activation &&
         a.strength == b.strength && a.weight == b.weight && a.share == b.share &&
         a.inhibited_by == b.inhibited_by && a.reason == b.reason;
}

const simulation::TracedMember* inhibitor_of(const simulation::TracedMember& member,
                                             std::span<const simulation::TracedMember> all) {
  int place = member.member->trace.inhibited_by;
  for (const simulation::TracedMember& other : all) {
    if (other.parent == member.parent && place-- == 0) {
      return &other;
    }
  }
  return nullptr;
}

TraceNote note_of(const TraceRow& row, double time_s, std::uint32_t reason, int inhibited_by) {
  const TraceRow rounded = kept(row);
  return {time_s,           rounded.command, rounded.activation,
          rounded.strength, rounded.weight,  rounded.share,
          inhibited_by,     reason,          row.asked};
}

bool same(const TraceNote& a, const TraceNote& b) {
  return a.asked == b.asked && a.command == b.command && a.activation == b.activation &&
         a.strength == b.strength && a.weight == b.weight && a.share == b.share &&
         a.reason == b.reason && a.inhibited_by == b.inhibited_by;
}

bool TraceRows::changed(const simulation::RobotView& robot) {
  bool changed = !begun_;
  begun_ = true;
  rows_.resize(robot.trace.size());
  kept_.resize(robot.trace.size());
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const TraceRow& row = robot.trace[i].member->trace;
    if (same(row, rows_[i])) {
      continue;  // the usual case, and cheaper than rounding first
    }
    rows_[i] = row;
    const TraceRow rounded = kept(row);
    changed = changed || !same(rounded, kept_[i]);
    kept_[i] = rounded;
  }
  const Motion asked = kept(robot.asked);
  const Motion command = kept(robot.command);
  changed = changed || asked != asked_ || command != command_;
  asked_ = asked;
  command_ = command;
  return changed;
}

}  // namespace elsie::traces
