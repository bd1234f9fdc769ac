// Bad names for everything that users name.
#pragma once

#include <string>
#include <vector>

#include "fixture.h"

namespace elsie::test {

inline const std::string kHostile =
    "<script>alert(1)</script> \"'&, ]]> -- \xc3\xa4\xe2\x82\xac \xf0\x9f\x90\xa2 \xff\xfe \x01 "
    "=1+1";

inline MadeExperiment hostile() {
  MadeExperiment made_up = made_from({{1, 2, 3, 4, 5, 60}, {2, 3, 4, 5, 6, 7}});
  made_up.name = made_up.description = made_up.text = kHostile;
  made_up.factors[1] = kHostile;
  made_up.cells[0].label = made_up.cells[0].levels[1] = kHostile;
  made_up.cells[0].runs[0].message = kHostile;
  made_up.cells[0].runs[0].outcome = "failure";
  made_up.units.emplace_back(kHostile, kHostile);
  for (auto& cell : made_up.cells) {
    for (auto& run : cell.runs) {
      run.measures[kHostile] = 1.0;
      run.robots[0].id = kHostile;
      run.robots[0].episodes = {{0, 1, kHostile}};
      run.robots[0].shares = {{kHostile, 1.0}};
      run.robots[0].curve = {{0, 1}, {1, 0.5}};
    }
  }
  MadeRun& broken = made_up.cells[1].runs[0];
  broken.state = "error";
  broken.message = broken.log = broken.plugin = kHostile;
  broken.measures.clear();
  return made_up;
}

inline experiment::Expectation hostile_expectation() {
  experiment::Expectation expectation = expectation_of(kHostile, kHostile);
  expectation.at_least = 2.0;
  return expectation;
}

/// The rows of a table, read strictly by RFC 4180.
std::vector<std::vector<std::string>> parsed_csv(const std::string& text);

/// The messages of `xmllint OPTIONS` about a text; "" if there are none.
std::string xmllint(const std::string& text, const std::string& options);

}  // namespace elsie::test
