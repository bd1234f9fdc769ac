// A check of an experiment and a report agree on the cells of an expectation.
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/experiment/grid.h"
#include "elsie/experiment/reader.h"

#include "fixture.h"

using namespace elsie;
using namespace elsie::test;

namespace {

const std::string kExperiment = R"(<experiment format="1">
  <worlds><world file="arena.xml"/><world file="clutter.xml"/></worlds>
  <vary name="scheme" path="robot[r1]/coordinator/@x" values="pick; pack; layers"/>
  <vary name="speed" path="robot[r1]/@max_speed" values="0.1; 0.2; 0.31"/>
  <seeds from="1" to="1"/>
  <expectations>
    <expect name="all" measure="time_s" at_least="0"/>
    <expect name="a star alone" measure="time_s" at_least="0" where="scheme=*"/>
    <expect name="a star within" measure="time_s" at_least="0" where="scheme=p*k; speed=0*1"/>
    <expect name="one of several" measure="time_s" at_least="0" where="speed=0.1|0.31; world=arena"/>
    <expect name="ratio" measure="time_s" at_least="0" ratio_to="scheme=pick"/>
    <expect name="ratio of some" measure="time_s" at_least="0" where="world=*tt*; speed=*2*"
            ratio_to="scheme=layers; speed=0.1"/>
    <expect name="difference" measure="time_s" at_most="0" where="scheme=p*"
            difference_from="world=arena; speed=0.2"/>
  </expectations>
</experiment>)";

// The grid of the experiment, with a run in each cell.
MadeExperiment runs_of(const experiment::Experiment& experiment) {
  MadeExperiment made;
  made.text = kExperiment;
  made.factors = experiment::factor_names(experiment);
  for (const experiment::Cell& cell : experiment::cells(experiment)) {
    MadeCell& in = made.cells.emplace_back();
    in.label = cell.label;
    in.levels = cell.labels;
    in.world_text = made_world();
    in.runs.emplace_back().measures = {{"time_s", 1.0 + static_cast<double>(cell.index)}};
  }
  return made;
}

}  // namespace

TEST_CASE("The cells of an expectation are the same in the check and in the report") {
  const experiment::Experiment experiment = experiment::parse_outline(kExperiment, "e.xml");
  const std::vector<experiment::Cell> cells = experiment::cells(experiment);
  REQUIRE(cells.size() == 18);
  const experiment::Grid grid(experiment, cells);
  report::Questions questions;
  questions.expectations = experiment.expectations;
  const report::Findings findings = Made(runs_of(experiment), questions).findings();

  REQUIRE(findings.verdicts.size() == 7);
  std::vector<std::size_t> sizes;
  for (std::size_t i = 0; i < findings.verdicts.size(); ++i) {
    const experiment::Expectation& expectation = experiment.expectations[i];
    CAPTURE(expectation.name);
    const std::vector<std::size_t> expected = grid.cells_of(expectation);
    const auto& claims = findings.verdicts[i].claims;
    sizes.push_back(claims.size());
    REQUIRE(claims.size() == expected.size());
    for (std::size_t j = 0; j < claims.size(); ++j) {
      CHECK(findings.results.cells[claims[j].cell].label == cells[expected[j]].label);
      const auto other = grid.reference_of(expectation, expected[j]);
      CHECK(other.has_value() == (expectation.relation != experiment::Relation::none));
      if (other) {
        CHECK_THAT(claims[j].found, Catch::Contains("that of " + cells[*other].label + " ("));
      }
    }
  }
  CHECK(sizes == std::vector<std::size_t>{18, 18, 8, 6, 12, 3, 10});
}

TEST_CASE("A cell that the results do not have is no reference, and no factor matches nothing") {
  const experiment::Grid grid({"world", "scheme"}, {{"w", "a"}, {"w", "b"}});
  experiment::Expectation expectation;
  expectation.relation = experiment::Relation::ratio;
  expectation.reference = {{"scheme", "c"}};
  CHECK(grid.cells_of(expectation) == std::vector<std::size_t>{0, 1});
  CHECK_FALSE(grid.reference_of(expectation, 0));
  expectation.reference = {{"speed", "1"}};
  CHECK_FALSE(grid.reference_of(expectation, 0));
  expectation.reference = {{"scheme", "a"}};
  CHECK(grid.reference_of(expectation, 1) == 0);
  CHECK(grid.cells_of(expectation) == std::vector<std::size_t>{1});
  expectation.where = {{"speed", {"*"}}};
  CHECK(grid.cells_of(expectation).empty());
  CHECK_THROWS_WITH(experiment::Grid({"world"}, {{"w", "a"}}),
                    "cell 0 has 2 labels; expected 1, one for each factor");
}
