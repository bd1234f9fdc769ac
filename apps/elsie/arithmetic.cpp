#include "arithmetic.h"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <string_view>
#include <system_error>

#include <unistd.h>

#include "elsie/base/error.h"
#include "elsie/process/process_end.h"

namespace elsie::program {

#if defined(__x86_64__) && defined(__GLIBC__)
namespace {

constexpr const char* kTunables = "GLIBC_TUNABLES";
/// The process that was started again, in case the system takes the settings away, as it does from
/// programs with special rights.
constexpr const char* kTried = "ELSIE_ARITHMETIC";
constexpr std::string_view kFeatures = "glibc.cpu.hwcaps=";
constexpr std::string_view kOurs = "-AVX,-AVX2,-FMA,-FMA4";

/// The settings of the variable, NAME=VALUE:NAME=VALUE, with ours at the end of processor features.
std::string with_ours(std::string_view all) {
  std::string others;
  std::string features(kFeatures);
  while (!all.empty()) {
    const std::string_view one = all.substr(0, all.find(':'));
    all.remove_prefix(one.size() < all.size() ? one.size() + 1 : all.size());
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

}  // namespace

void fix_arithmetic(char** arguments) {
  const char* const given = std::getenv(kTunables);
  const std::string settings = with_ours(given ? given : "");
  const std::string self_number = std::to_string(getpid());
  const char* const tried = std::getenv(kTried);
  const bool is_second = tried && tried == self_number;
  unsetenv(kTried);
  if ((given && given == settings) || is_second) {
    return;
  }
  setenv(kTunables, settings.c_str(), 1);
  setenv(kTried, self_number.c_str(), 1);
  const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
  execv(self.c_str(), arguments);
  std::cerr << "elsie: '" << self
            << "' cannot be started: " << std::generic_category().message(errno) << '\n';
  process::end_with(base::kOtherFailure);
}
#else
void fix_arithmetic(char**) {}
#endif

}  // namespace elsie::program
