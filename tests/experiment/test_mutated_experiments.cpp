// Experiments with random damage are read or refused; nothing else happens.
#include <catch2/catch.hpp>

#include "elsie/experiment/grid.h"

#include "damage.h"
#include "fixture.h"

using namespace elsie;
using namespace elsie::test;

namespace {

const std::vector<std::string> kPieces = xml_pieces(
    R"(; | * e9 <pick/> <level> </level> value=" </vary> from="1" to="1e18" step="1e-9" list="1")"
    R"( where="a=b" ratio_to="coordinator=layers" robot[*])",
    {"<set path=\"", "<vary name=\"x\">", "<experiment format=\"1\">"});
const std::vector<std::string> kNames = {"<vary",   "<level",   "<set",   "<seeds",
                                         "<world",  "<expect",  "<pick",  "<sum",
                                         "<layers", "<measure", "<limits"};

}  // namespace

TEST_CASE("A damaged experiment is read or refused") {
  const std::string original = text_of(kFolder + "data/everything.xml");
  int accepted = 0;
  for (unsigned seed = 0; seed < 3000; ++seed) {
    const std::string text = Damage(seed, kPieces, kNames).to(original);
    CAPTURE(seed);
    try {
      const experiment::Experiment e =
          experiment::parse_experiment(text, kFolder + "data/damaged.xml", host(), options());
      ++accepted;
      // The grid of an accepted experiment is usable.
      const auto grid = experiment::cells(e);
      REQUIRE(grid.size() * e.seeds.size() * static_cast<std::size_t>(e.repeats) ==
              experiment::number_of_runs(e));
      const experiment::Grid by_levels(e, grid);
      for (const experiment::Expectation& expectation : e.expectations) {
        const auto concerned = by_levels.cells_of(expectation);
        REQUIRE_FALSE(concerned.empty());
        for (const std::size_t index : concerned) {
          REQUIRE(by_levels.reference_of(expectation, index).value_or(0) < grid.size());
        }
      }
      experiment::read_cell(e, grid.back(), host(), options());
    } catch (const world::WorldError& error) {
      REQUIRE_FALSE(error.problems().empty());
    }
  }
  CHECK(accepted > 20);
  CHECK(accepted < 2000);
}
