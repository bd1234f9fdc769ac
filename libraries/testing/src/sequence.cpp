#include "elsie/testing/sequence.h"

#include <cmath>

namespace elsie::testing {

Sequence& Sequence::hold(double seconds, const Situation& now) {
  return change(seconds, [&](double) { return now; });
}

Sequence& Sequence::change(double seconds, const std::function<Situation(double elapsed_s)>& at) {
  const auto steps = static_cast<std::size_t>(std::lround(seconds / period_s_));
  for (std::size_t i = 0; i < steps; ++i) {
    Situation& now = instants_.emplace_back(at(static_cast<double>(i) * period_s_));
    now.time(static_cast<double>(instants_.size() - 1) * period_s_).period(period_s_);
  }
  return *this;
}

}  // namespace elsie::testing
