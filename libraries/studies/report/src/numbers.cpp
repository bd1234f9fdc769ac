#include "numbers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "elsie/base/number_text.h"
#include "elsie/picture/svg.h"
#include "elsie/process/shell_word.h"

namespace elsie::report {

std::string brief(double value, int digits) {
  if (value == 0.0) {
    return "0";
  }
  if (!std::isfinite(value)) {
    return base::number_text(value);
  }
  const double size = std::abs(value);
  if (size < 1e-4 || size >= 1e7) {
    std::array<char, 40> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                   std::chars_format::scientific, std::max(0, digits - 2));
    return {text.data(), end.ptr};
  }
  const int before = static_cast<int>(std::floor(std::log10(size))) + 1;
  return picture::short_number(value, std::max(0, digits - before));
}

std::optional<int> decimals_for(double value, double spread) {
  constexpr int kMost = 6;
  const double size = std::abs(value);
  if (size >= 1e9 || spread >= 1e9) {
    return std::nullopt;
  }
  // A spread from rounding counts as no spread.
  if (spread > 1e-12 * size && spread > 0.0) {
    const int decimals = 1 - static_cast<int>(std::floor(std::log10(spread)));
    return decimals > kMost ? std::nullopt : std::optional(std::max(0, decimals));
  }
  if (size == 0.0) {
    return 0;
  }
  // Without a spread: no more decimals than the value has.
  const std::string text = brief(value);
  if (text.find('e') != std::string::npos) {
    return std::nullopt;
  }
  const std::size_t point = text.find('.');
  return point == std::string::npos ? 0 : static_cast<int>(text.size() - point - 1);
}

MeanText mean_text(const Summary& summary, const std::optional<Interval>& interval) {
  return mean_text(summary, interval,
                   decimals_for(summary.mean, summary.standard_deviation.value_or(0.0)));
}

MeanText mean_text(const Summary& summary, const std::optional<Interval>& interval,
                   std::optional<int> decimals) {
  const auto text = [&](double value) {
    return decimals ? base::fixed_text(value, *decimals) : brief(value);
  };
  MeanText result;
  result.mean = text(summary.mean);
  if (summary.standard_deviation) {
    result.deviation = text(*summary.standard_deviation);
  }
  if (interval) {
    result.low = text(interval->low);
    result.high = text(interval->high);
  }
  return result;
}

std::string p_text(double p) { return p < 0.001 ? "< 0.001" : fixed_text(p, 3); }

std::string in_words(const std::string& name, const std::string& unit) {
  std::string words = name;
  const std::string suffix = '_' + unit;
  if (!unit.empty() && words.size() > suffix.size() && words.ends_with(suffix)) {
    words.erase(words.size() - suffix.size());
  }
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

std::string replay_command(const std::string& database, std::int64_t run) {
  return "elsie replay " + process::shell_word(database) + ' ' + std::to_string(run);
}

}  // namespace elsie::report
