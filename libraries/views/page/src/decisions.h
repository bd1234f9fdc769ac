// Who decided when, published numbers and events, from the trace of a run.
#pragma once

#include "elsie/traces/trace.h"

#include "layer.h"

namespace elsie::page {

/// In columns of time, each as long as a control period at first: who decided in most of it, and
/// the mean share of each behaviour in the robot's command. Columns like the one before are left
/// out.
class Decisions final : public Layer {
 public:
  /// The trace must outlive it.
  explicit Decisions(const traces::Trace& trace);

  std::string text() const override;
  bool thin() override;

 private:
  std::string robot_text(const traces::TraceRobot& robot) const;

  const traces::Trace& trace_;
  double column_s_;
};

/// Numbers that plugins of robots published, as whole parts of their range.
class Numbers final : public Layer {
 public:
  explicit Numbers(const traces::Trace& trace) : trace_(trace) {}

  std::string text() const override;
  bool thin() override;

 private:
  const traces::Trace& trace_;
  std::size_t every_ = 1;
};

}  // namespace elsie::page
