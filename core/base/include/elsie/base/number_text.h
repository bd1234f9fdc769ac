// Numbers as text, the same in every locale.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace elsie::base {

/// The shortest decimal text that reads back as the same number, bit for bit; "inf", "-inf", "nan".
std::string number_text(double value);

/// The number to `digits` significant digits (1 to 17), as printf's %g writes it.
std::string number_text(double value, int digits);

/// The number with `decimals` digits (0 to 17) after the point; never "-0".
std::string fixed_text(double value, int decimals);

/// A time in seconds to six significant digits: "0.25 s".
std::string seconds_text(double seconds);

/// A step with its simulated time: "step 101 (at 1.01 s)".
std::string step_text(std::uint64_t step, double time_s);

/// number_text(value) without allocating memory, for long tables and signal handlers.
class NumberText {
 public:
  explicit NumberText(double value) noexcept;
  std::string_view view() const noexcept { return {digits_, size_}; }

 private:
  char digits_[32];
  std::size_t size_;
};

}  // namespace elsie::base
