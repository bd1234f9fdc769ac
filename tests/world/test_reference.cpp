// The reference pages are made of the declarations.
#include <catch2/catch.hpp>

#include "elsie/world/reference.h"
#include "elsie/world/vocabulary.h"

#include "fixture.h"

using namespace elsie;
using namespace elsie::test;
using Catch::Matchers::Contains;

TEST_CASE("The world reference has every element and attribute") {
  const std::string page = world::world_reference();
  CHECK_THAT(page, Contains("## world / arena"));
  CHECK_THAT(page,
             Contains("| `length` | a number above 0 and at most 10000 m | `10` | along x, between "
                      "the walls |"));
  CHECK_THAT(page, Contains("## world / robots / robot / sensors / *any sensor plugin*"));
  CHECK_THAT(page, Contains("| `path` | one of 'round', 'to_and_fro' | `round` |"));
  CHECK_THAT(page, Contains("| `team` | the id of a team |"));
}

TEST_CASE("A plugin's page is its declaration") {
  const std::string page = world::plugin_reference(*host().find(PluginKind::behavior, "roam"));
  CHECK_THAT(page, Catch::StartsWith("# roam\n\nDrives about.\n\nA behavior, version 1.0.\n"));
  CHECK_THAT(page, Contains("| `speed` | a number at least 0 and at most 50 rad/s | `10` | mean "
                            "wheel rate |"));
  CHECK_THAT(page, Contains("- `bored`: nothing has happened"));
  CHECK_THAT(world::plugin_reference(*host().find(PluginKind::behavior, "avoid")),
             Contains("Needs a sensor that makes readings of the kind `range`."));
}

TEST_CASE("Every attribute of the vocabulary has a meaning") {
  const std::function<void(const world::ElementSpec&)> check = [&](const world::ElementSpec& spec) {
    CAPTURE(spec.name);
    CHECK_FALSE(spec.meaning.empty());
    for (const world::AttributeSpec& attribute : spec.attributes) {
      CAPTURE(attribute.name);
      CHECK_FALSE(attribute.facts.meaning.empty());
    }
    for (const world::ElementSpec& child : spec.children) {
      check(child);
    }
  };
  check(world::vocabulary());
  check(world::template_vocabulary());
  CHECK(world::vocabulary_at({"robots", "robot", "body"}).attribute("axle") != nullptr);
  CHECK_THROWS_AS(world::vocabulary_at({"robots", "rover"}), std::out_of_range);
}
