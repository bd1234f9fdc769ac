// The processor's floating-point settings: rounding, and the treatment of very small numbers.
#pragma once

#include <cstdint>

namespace elsie::plugin {

/// The control part of this thread's floating-point environment: rounding, flushing of denormal
/// numbers to zero, precision, and which errors raise a signal. Status flags are not part of it.
class Arithmetic {
 public:
  /// The present settings. Takes about a nanosecond.
  static Arithmetic now() noexcept {
    Arithmetic found;
#if defined(__x86_64__)
    found.control_ = __builtin_ia32_stmxcsr() & ~kFlags;
    asm volatile("fnstcw %0" : "=m"(found.x87_));
#elif defined(__aarch64__)
    asm volatile("mrs %0, fpcr" : "=r"(found.control_));
#endif
    return found;
  }

  /// Makes these the thread's settings.
  void restore() const noexcept;

  /// The difference, to follow "it changed": "how results are rounded". The text is static.
  const char* difference_from(const Arithmetic& usual) const noexcept;

  friend bool operator==(const Arithmetic&, const Arithmetic&) = default;

 private:
  static constexpr std::uint32_t kFlags = 0x3f;  // of x86's MXCSR

  std::uint64_t control_ = 0;
  std::uint16_t x87_ = 0;
};

}  // namespace elsie::plugin
