#include "candidates.h"

#include <algorithm>
#include <cmath>
#include <utility>

Candidates Candidates::wheel_rates(const CommandSpace& space, double limit, int steps,
                                   int laterals) {
  Candidates made;
  const int layers = space.dimensions() > 2 ? laterals : 1;
  made.layers_ = static_cast<std::size_t>(layers);
  made.rows_ = made.columns_ = static_cast<std::size_t>(steps);
  // Symmetric to the last bit, so that no side is preferred.
  const auto rate = [&](int i, int of) {
    return of > 1 ? limit * (2 * i - (of - 1)) / (of - 1) : 0.0;
  };
  for (int layer = 0; layer < layers; ++layer) {
    for (int left = 0; left < steps; ++left) {
      for (int right = 0; right < steps; ++right) {
        made.commands_.push_back(
            space.motion({rate(left, steps), rate(right, steps), rate(layer, layers)}));
      }
    }
  }
  return made;
}

Candidates Candidates::arcs(const CommandSpace& space, double limit, int speeds, int arcs) {
  Candidates made;
  made.rows_ = static_cast<std::size_t>(speeds);
  made.columns_ = static_cast<std::size_t>(arcs);
  for (int s = 1; s <= speeds; ++s) {
    const double outer = limit * s / speeds;
    for (int a = 0; a < arcs; ++a) {
      // -1: in place to the right; 0: straight on; 1: in place to the left.
      const double turn = static_cast<double>(2 * a - (arcs - 1)) / (arcs - 1);
      const double inner = outer * (1.0 - 2.0 * std::abs(turn));
      made.commands_.push_back(turn < 0.0 ? space.motion({outer, inner, 0.0})
                                          : space.motion({inner, outer, 0.0}));
    }
  }
  made.commands_.push_back({});
  return made;
}

Candidates Candidates::list(std::vector<elsie::Motion> commands) {
  Candidates made;
  made.commands_ = std::move(commands);
  return made;
}

elsie::Motion Candidates::interpolated(std::size_t index, std::span<const double> values) const {
  elsie::Motion result = commands_[index];
  if (index >= layers_ * rows_ * columns_) {
    return result;
  }
  const auto towards_top = [&](std::size_t before, std::size_t after) {
    const double rise = values[index] - values[before];
    const double fall = values[index] - values[after];
    if (rise < 0.0 || fall < 0.0 || rise + fall <= 0.0) {
      return;
    }
    const double offset = 0.5 * (rise - fall) / (rise + fall);  // steps, in [-1/2, 1/2]
    const elsie::Motion& next = commands_[offset > 0.0 ? after : before];
    result += std::abs(offset) * (next - commands_[index]);
  };
  const std::size_t layer = index / (rows_ * columns_);
  const std::size_t row = index / columns_ % rows_;
  const std::size_t column = index % columns_;
  if (layer > 0 && layer + 1 < layers_) {
    towards_top(index - rows_ * columns_, index + rows_ * columns_);
  }
  if (row > 0 && row + 1 < rows_) {
    towards_top(index - columns_, index + columns_);
  }
  if (column > 0 && column + 1 < columns_) {
    towards_top(index - 1, index + 1);
  }
  return result;
}

void Smoothing::prepare(const CommandSpace& space, std::span<const elsie::Motion> commands,
                        double width) {
  neighbours_.clear();
  ends_.clear();
  if (width <= 0.0) {
    return;
  }
  // Beyond three standard deviations, a Gaussian is almost zero.
  const double reach_squared = 9.0 * width * width;
  raw_.resize(commands.size());
  for (const elsie::Motion& command : commands) {
    const std::size_t first = neighbours_.size();
    double sum = 0.0;
    for (std::size_t i = 0; i < commands.size(); ++i) {
      const double squared = space.distance_squared(command, commands[i]);
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
