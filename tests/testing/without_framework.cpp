// The test library without a test framework: main() prints failures.
#include <cstdio>
#include <vector>

#include "elsie/testing/testing.h"

namespace testing = elsie::testing;

int main() {
  std::vector<testing::Verdict> verdicts;
  testing::Behavior avoid("avoid_obstacle");
  verdicts.push_back(testing::turns_left().check(
      avoid.respond(testing::Situation().beam(15, 1.0).beam(-15, 0.1))));
  verdicts.push_back(testing::turns_right().check(
      avoid.respond(testing::Situation().beam(15, 0.1).beam(-15, 1.0))));
  for (const std::string& finding :
       testing::check_plugin(elsie::PluginKind::behavior, "avoid_obstacle")) {
    verdicts.push_back(testing::Verdict::wrong(finding));
  }
  int wrong = 0;
  for (const testing::Verdict& verdict : verdicts) {
    if (!verdict) {
      std::puts(verdict.sentence.c_str());
      ++wrong;
    }
  }
  return wrong;
}
