#include "elsie/process/arithmetic.h"

#include <cstdlib>
#include <fstream>

namespace elsie::process {
namespace {

constexpr std::string_view kFeatures = "glibc.cpu.hwcaps=";
constexpr std::string_view kOurs = "-AVX,-AVX2,-FMA,-FMA4";

/// The variable as it was when the process started.
std::string initial_settings() {
  const std::string start = std::string(kArithmeticVariable) + '=';
  std::ifstream environment("/proc/self/environ", std::ios::binary);
  for (std::string variable; std::getline(environment, variable, '\0');) {
    if (variable.starts_with(start)) return variable.substr(start.size());
  }
  return "";
}

}  // namespace

std::string with_fixed_arithmetic(std::string_view settings) {
  std::string others;
  std::string features(kFeatures);
  while (!settings.empty()) {
    const std::string_view one = settings.substr(0, settings.find(':'));
    settings.remove_prefix(one.size() < settings.size() ? one.size() + 1 : settings.size());
    if (one.ends_with(kOurs)) {
      features = one.substr(0, one.size() - kOurs.size());
    } else if (one.starts_with(kFeatures)) {
      features = std::string(one) + ',';
    } else if (!one.empty()) {
      others += std::string(one) + ':';
    }
  }
  return others + features + std::string(kOurs);
}

bool has_fixed_arithmetic() {
#if defined(__x86_64__) && defined(__GLIBC__)
  const std::string settings = initial_settings();
  return settings == with_fixed_arithmetic(settings);
#else
  return true;
#endif
}

}  // namespace elsie::process
