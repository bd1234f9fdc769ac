#include "arithmetic.h"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <system_error>

#include <unistd.h>

#include "elsie/base/error.h"
#include "elsie/process/arithmetic.h"
#include "elsie/process/process_end.h"

namespace elsie::program {

#if defined(__x86_64__) && defined(__GLIBC__)
namespace {

/// The process that was started again, in case the system takes the settings away, as it does from
/// programs with special rights.
constexpr const char* kTried = "ELSIE_ARITHMETIC";

}  // namespace

void fix_arithmetic(char** arguments) {
  const char* const given = std::getenv(process::kArithmeticVariable);
  const std::string settings = process::with_fixed_arithmetic(given ? given : "");
  const std::string self_number = std::to_string(getpid());
  const char* const tried = std::getenv(kTried);
  const bool is_second = tried && tried == self_number;
  unsetenv(kTried);
  if ((given && given == settings) || is_second) {
    return;
  }
  setenv(process::kArithmeticVariable, settings.c_str(), 1);
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
