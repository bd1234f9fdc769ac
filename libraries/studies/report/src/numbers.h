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

/// For reading: about so many significant digits, no exponent between 1e-4 and 1e7.
std::string brief(double value, int digits = 4);

/// How many decimals suit values that spread this much around `value`: two digits of the spread; of
/// the value four digits when nothing spreads. None: better with an exponent.
std::optional<int> decimals_for(double value, double spread);

/// A sample's mean and standard deviation with as many decimals as these deserve.
struct MeanText {
  std::string mean;
  std::string deviation;  // "" for a single value
  std::string low, high;  // of the interval; "" when there is none
};
MeanText mean_text(const Summary& summary, const std::optional<Interval>& interval,
                   std::optional<int> decimals);
MeanText mean_text(const Summary& summary, const std::optional<Interval>& interval);

/// A measure's name in words: "path_length_m" of unit "m" is "path length".
std::string in_words(const std::string& name, const std::string& unit);

/// "elsie replay DATABASE RUN"
std::string replay_command(const std::string& database, std::int64_t run);

}  // namespace elsie::report
