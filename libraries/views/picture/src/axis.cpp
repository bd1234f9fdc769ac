#include "elsie/picture/axis.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "elsie/base/number_text.h"

namespace elsie::picture {

void Interval::include(double value) {
  if (!std::isfinite(value)) return;
  low = std::min(low, value);
  high = std::max(high, value);
}

Interval Interval::widened() const {
  // Numbers that differ by rounding count as one.
  constexpr double kRounding = 1e-12, kTiniest = 1e-290;
  const double size = std::max(std::abs(low), std::abs(high));
  if (low < high && span() > std::max(kRounding * size, kTiniest)) return *this;
  if (empty() || std::abs(low) < kTiniest) return {-1.0, 1.0};
  return {low - 0.1 * std::abs(low), low + 0.1 * std::abs(low)};
}

double nice_step(double span, int about) {
  if (!(span > 0.0) || !std::isfinite(span) || about < 1) return 1.0;
  const double wanted = span / about;
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  // Nearest by ratio: the limits are the geometric means of neighbours.
  const double ratio = wanted / power;
  if (ratio < std::sqrt(2.0)) return power;
  if (ratio < std::sqrt(10.0)) return 2.0 * power;
  if (ratio < std::sqrt(50.0)) return 5.0 * power;
  return 10.0 * power;
}

Ticks nice_ticks(double low, double high, int about) {
  return multiples(low, high, nice_step(high - low, about));
}

Ticks multiples(double low, double high, double step) {
  Ticks ticks;
  if (!std::isfinite(low) || !std::isfinite(high) || !(low < high)) return ticks;
  if (!std::isfinite(high - low)) return ticks;
  ticks.step = step;
  // Rounding may put a tick slightly beyond the interval.
  constexpr double kHair = 1e-9;
  const double first = std::ceil(low / ticks.step - kHair);
  const double last = std::floor(high / ticks.step + kHair);
  // If the step is below the resolution of the numbers, counting would not end.
  constexpr double kMostSteps = 1e15;
  if (!(last - first < 1000.0) || !(std::max(std::abs(first), std::abs(last)) < kMostSteps)) {
    return ticks;
  }
  for (double i = first; i <= last; i += 1.0) {
    ticks.at.push_back(std::clamp(i == 0.0 ? 0.0 : i * ticks.step, low, high));
  }
  return ticks;
}

std::string Ticks::label(double tick) const {
  if (!names.empty()) {
    const auto place = std::find(at.begin(), at.end(), tick) - at.begin();
    return place < std::ssize(names) ? names[static_cast<std::size_t>(place)] : "";
  }
  if (!powers) return tick_label(tick, step);
  static constexpr std::array<const char*, 10> kDigits = {"⁰", "¹", "²", "³", "⁴",
                                                          "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = tick < 0.0 ? "10⁻" : "10";
  for (const char digit : base::fixed_text(std::abs(tick), 0)) {
    text += kDigits[static_cast<std::size_t>(digit - '0')];
  }
  return text;
}

std::string tick_label(double value, double step) {
  const double magnitude = std::max(std::abs(value), step);
  std::string text;
  if (magnitude >= 1e6 || step < 1e-5) {
    text = base::number_text(value, 6);
  } else {
    const double exponent = std::floor(std::log10(step) + 1e-9);
    text = base::fixed_text(value, static_cast<int>(std::max(0.0, -exponent)));
  }
  if (!text.empty() && text.front() == '-') text.replace(0, 1, "\xE2\x88\x92");
  return text;
}

}  // namespace elsie::picture
