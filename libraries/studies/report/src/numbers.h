// Numbers and counts as text, the same in every locale.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "elsie/base/number_text.h"
#include "elsie/base/words.h"
#include "elsie/report/statistics.h"

namespace elsie::report {

using base::counted;
using base::fixed_text;
using base::number_text;

/// A readable number with about `digits` significant digits, without an exponent from 1e-4 to 1e7.
std::string brief(double value, int digits = 4);

/// The number of decimals for values that spread this much around `value`: two digits of the
/// spread; four digits of the value if there is no spread. None if the value needs an exponent.
std::optional<int> decimals_for(double value, double spread);

/// A sample's mean and standard deviation with suitable decimals.
struct MeanText {
  std::string mean;
  std::string deviation;  // "" for a single value
  std::string low, high;  // of the interval; "" without one
};
MeanText mean_text(const Summary& summary, const std::optional<Interval>& interval,
                   std::optional<int> decimals);
MeanText mean_text(const Summary& summary, const std::optional<Interval>& interval);

/// A probability of a test: "0.034", "< 0.001".
std::string p_text(double p);

/// A measure's name in words: "path_length_m" of unit "m" is "path length".
std::string in_words(const std::string& name, const std::string& unit);

/// "elsie replay DATABASE RUN"
std::string replay_command(const std::string& database, std::int64_t run);

}  // namespace elsie::report
