// Medians, means and spreads.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

namespace elsie::bench {

/// The upper one of two; not of none.
inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

inline double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// The sample standard deviation; 0 for a single value.
inline double deviation(const std::vector<double>& values) {
  const double middle = mean(values);
  double squares = 0.0;
  for (const double value : values) {
    squares += (value - middle) * (value - middle);
  }
  return values.size() < 2 ? 0.0 : std::sqrt(squares / static_cast<double>(values.size() - 1));
}

/// "12.3 +- 0.4"; "-" without values.
inline std::string mean_and_deviation(const std::vector<double>& values, int decimals) {
  if (values.empty()) {
    return "-";
  }
  char text[64];
  std::snprintf(text, sizeof(text), "%.*f +- %.*f", decimals, mean(values), decimals,
                deviation(values));
  return text;
}

}  // namespace elsie::bench
