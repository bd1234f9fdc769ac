#include "elsie/plugin/arithmetic.h"

namespace elsie::plugin {

void Arithmetic::restore() const noexcept {
#if defined(__x86_64__)
  __builtin_ia32_ldmxcsr(static_cast<std::uint32_t>(control_));
  asm volatile("fldcw %0" : : "m"(x87_));
#elif defined(__aarch64__)
  asm volatile("msr fpcr, %0" : : "r"(control_));
#endif
}

const char* Arithmetic::difference_from(const Arithmetic& usual) const noexcept {
#if defined(__x86_64__)
  constexpr std::uint64_t kRounding = 0x6000;
  constexpr std::uint64_t kSmall = 0x8040;  // flush to zero, denormals are zero
#elif defined(__aarch64__)
  constexpr std::uint64_t kRounding = 3ULL << 22U;
  constexpr std::uint64_t kSmall = 1ULL << 24U;
#else  // unknown processor
  constexpr std::uint64_t kRounding = 0, kSmall = 0;
#endif
  constexpr unsigned kX87Rounding = 0x0c00;  // x87_ is always zero on other processors
  const std::uint64_t changed = control_ ^ usual.control_;
  if ((changed & kRounding) != 0 || ((x87_ ^ usual.x87_) & kX87Rounding) != 0) {
    return "how results are rounded";
  }
  if ((changed & kSmall) != 0) {
    return "how very small numbers are treated (it may be compiled with -ffast-math)";
  }
  return "the precision of results, or which errors in them raise a signal";
}

}  // namespace elsie::plugin
