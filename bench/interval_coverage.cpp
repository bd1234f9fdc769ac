// interval_coverage [EXPERIMENTS]: how often intervals hold the true value, as a table for
// docs/research/statistics.md. Two thousand experiments take some minutes.
#include <charconv>
#include <cstdio>
#include <string_view>

#include "coverage.h"

int main(int count, char** words) {
  int experiments = 2000;
  if (count > 1) {
    const std::string_view word = words[1];
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), experiments);
    if (error != std::errc() || end != word.data() + word.size() || experiments < 1) {
      std::fprintf(stderr, "interval_coverage: expected a number of experiments from 1, not '%s'\n",
                   words[1]);
      return 2;
    }
  }
  std::fputs(elsie::test::coverage_table(elsie::test::simulate_coverage(experiments)).c_str(),
             stdout);
  return 0;
}
