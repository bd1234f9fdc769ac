// The processor's way of computing: how results are rounded, and what happens to very small ones.
#pragma once

#include <cstdint>

namespace elsie::plugin {

/// The control part of the floating-point environment of this thread: rounding, flushing of
/// denormal numbers to zero, precision, and which errors raise a signal. Flags that only report
/// what happened are not part of it.
class Arithmetic {
 public:
  /// As it is now. Takes about a nanosecond.
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

  /// Makes the thread compute so again.
  void restore() const noexcept;

  /// What was changed, to follow "it changed": "how results are rounded". A text that stays.
  const char* difference_from(const Arithmetic& usual) const noexcept;

  friend bool operator==(const Arithmetic&, const Arithmetic&) = default;

 private:
  static constexpr std::uint32_t kFlags = 0x3f;  // of x86's MXCSR

  std::uint64_t control_ = 0;
  std::uint16_t x87_ = 0;
};

}  // namespace elsie::plugin
