// Numbers and counts as text, the same in every locale.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "elsie/report/statistics.h"

namespace elsie::report {

/// As few digits as give the same number again; "inf", "-inf", "nan".
std::string exact(double value);

/// With so many decimals; no "-0".
std::string fixed(double value, int decimals);

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

/// "1 run", "2 runs".
std::string counted(std::size_t count, const std::string& what);
std::string counted(std::size_t count, const std::string& one, const std::string& several);

/// A measure's name in words: "path_length_m" of unit "m" is "path length".
std::string in_words(const std::string& name, const std::string& unit);

/// "elsie replay DATABASE RUN"
std::string replay_command(const std::string& database, std::int64_t run);

}  // namespace elsie::report
