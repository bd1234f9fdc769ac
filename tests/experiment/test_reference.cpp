// The reference page has every element and attribute of the vocabulary.
#include <catch2/catch.hpp>

#include "elsie/experiment/vocabulary.h"
#include "elsie/simulation/measures.h"

using namespace elsie;

namespace {

void check(const world::ElementSpec& spec, const std::string& page) {
  CAPTURE(spec.name);
  CHECK_THAT(page, Catch::Contains(spec.name));
  CHECK_FALSE(spec.meaning.empty());
  for (const world::AttributeSpec& attribute : spec.attributes) {
    CAPTURE(attribute.name);
    CHECK_THAT(page, Catch::Contains("| `" + attribute.name + "` |"));
    CHECK_FALSE(attribute.facts.meaning.empty());
  }
  for (const world::ElementSpec& child : spec.children) {
    check(child, page);
  }
}

}  // namespace

TEST_CASE("The reference of experiments is complete") {
  const std::string page = experiment::experiment_reference();
  check(experiment::vocabulary(), page);
  CHECK_THAT(page, Catch::StartsWith("# Experiment files"));
  CHECK_THAT(page, Catch::Contains("\n## experiment / worlds / world\n"));
  CHECK_THAT(page, Catch::Contains("\n## experiment / vary / level / set\n"));
  CHECK_THAT(page, Catch::Contains("Holds: an element of a world."));
  CHECK_THAT(page, Catch::Contains("Holds: `<set>`, `<at>`, an element of a world."));
  for (const Quantity& measure : simulation::measures_of_every_run()) {
    CHECK_THAT(page, Catch::Contains("| `" + measure.name + "` | "));
  }
}
