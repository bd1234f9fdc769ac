#include "candidates.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "desirability.h"

Candidates Candidates::wheel_rates(double limit, int steps) {
  Candidates made;
  made.rows_ = made.columns_ = static_cast<std::size_t>(steps);
  // Symmetric to the last bit, so that no side is preferred.
  const auto rate = [&](int i) { return limit * (2 * i - (steps - 1)) / (steps - 1); };
  for (int left = 0; left < steps; ++left) {
    for (int right = 0; right < steps; ++right) {
      made.commands_.push_back({rate(left), rate(right)});
    }
  }
  return made;
}

Candidates Candidates::arcs(double limit, int speeds, int arcs) {
  Candidates made;
  made.rows_ = static_cast<std::size_t>(speeds);
  made.columns_ = static_cast<std::size_t>(arcs);
  for (int s = 1; s <= speeds; ++s) {
    const double outer = limit * s / speeds;
    for (int a = 0; a < arcs; ++a) {
      // -1: in place to the right; 0: straight on; 1: in place to the left.
      const double turn = static_cast<double>(2 * a - (arcs - 1)) / (arcs - 1);
      const double inner = outer * (1.0 - 2.0 * std::abs(turn));
      made.commands_.push_back(turn < 0.0 ? elsie::MotorCommand{outer, inner}
                                          : elsie::MotorCommand{inner, outer});
    }
  }
  made.commands_.push_back({});
  return made;
}

Candidates Candidates::list(std::vector<elsie::MotorCommand> commands) {
  Candidates made;
  made.commands_ = std::move(commands);
  return made;
}

elsie::MotorCommand Candidates::interpolated(std::size_t index,
                                             std::span<const double> values) const {
  elsie::MotorCommand result = commands_[index];
  if (index >= rows_ * columns_) {
    return result;
  }
  const auto towards_top = [&](std::size_t before, std::size_t after) {
    const double rise = values[index] - values[before];
    const double fall = values[index] - values[after];
    if (rise < 0.0 || fall < 0.0 || rise + fall <= 0.0) {
      return;
    }
    const double offset = 0.5 * (rise - fall) / (rise + fall);  // steps, in [-1/2, 1/2]
    const elsie::MotorCommand& next = commands_[offset > 0.0 ? after : before];
    result += std::abs(offset) * (next + -1.0 * commands_[index]);
  };
  const std::size_t row = index / columns_;
  const std::size_t column = index % columns_;
  if (row > 0 && row + 1 < rows_) {
    towards_top(index - columns_, index + columns_);
  }
  if (column > 0 && column + 1 < columns_) {
    towards_top(index - 1, index + 1);
  }
  return result;
}

void Smoothing::prepare(std::span<const elsie::MotorCommand> commands, double width) {
  neighbours_.clear();
  ends_.clear();
  if (width <= 0.0) {
    return;
  }
  // Beyond three standard deviations, a Gaussian is almost zero.
  const double reach_squared = 9.0 * width * width;
  raw_.resize(commands.size());
  for (const elsie::MotorCommand& command : commands) {
    const std::size_t first = neighbours_.size();
    double sum = 0.0;
    for (std::size_t i = 0; i < commands.size(); ++i) {
      const double squared = distance_squared(command, commands[i]);
      if (squared <= reach_squared) {
        neighbours_.push_back({i, std::exp(-0.5 * squared / (width * width))});
        sum += neighbours_.back().weight;
      }
    }
    for (std::size_t n = first; n < neighbours_.size(); ++n) {
      neighbours_[n].weight /= sum;
    }
    ends_.push_back(neighbours_.size());
  }
}

void Smoothing::apply(std::span<double> values) {
  if (ends_.empty()) {
    return;
  }
  std::copy(values.begin(), values.end(), raw_.begin());
  std::size_t n = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = 0.0;
    for (; n < ends_[i]; ++n) {
      values[i] += neighbours_[n].weight * raw_[neighbours_[n].index];
    }
  }
}
