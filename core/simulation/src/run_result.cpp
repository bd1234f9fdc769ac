#include "elsie/simulation/run_result.h"

#include <cstdio>

namespace elsie::simulation {

std::string hash_text(std::uint64_t state_hash) {
  char digits[17];
  std::snprintf(digits, sizeof(digits), "%016llx", static_cast<unsigned long long>(state_hash));
  return digits;
}

}  // namespace elsie::simulation
