#include "arithmetic.h"

#include <cstdlib>
#include <string>
#include <string_view>

namespace elsie::supervisor {
namespace {

constexpr const char* kTunables = "GLIBC_TUNABLES";

#if defined(__x86_64__) && defined(__GLIBC__)
/// The C library chooses versions of its mathematical functions by this setting.
constexpr std::string_view kFeatures = "glibc.cpu.hwcaps=";
constexpr std::string_view kSetting = "glibc.cpu.hwcaps=-AVX,-AVX2,-FMA,-FMA4";

/// The settings of the variable, NAME=VALUE:NAME=VALUE, without those of processor features.
std::string others(std::string_view all) {
  std::string kept;
  while (!all.empty()) {
    const std::string_view one = all.substr(0, all.find(':'));
    all.remove_prefix(one.size() < all.size() ? one.size() + 1 : all.size());
    if (!one.empty() && !one.starts_with(kFeatures)) {
      kept += one;
      kept += ':';
    }
  }
  return kept;
}
#endif

}  // namespace

void fix_arithmetic() {
#if defined(__x86_64__) && defined(__GLIBC__)
  const char* const given = std::getenv(kTunables);
  const std::string setting = others(given ? given : "") + std::string(kSetting);
  setenv(kTunables, setting.c_str(), 1);
#endif
}

}  // namespace elsie::supervisor
