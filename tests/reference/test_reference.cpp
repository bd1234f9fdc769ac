// The reference pages are made from the declarations.
#include <catch2/catch.hpp>

#include "elsie/reference/reference.h"
#include "elsie/world/vocabulary.h"

#include "fixture.h"

using namespace elsie;
using namespace elsie::test;
using Catch::Contains;

TEST_CASE("The world reference has every element and attribute") {
  const std::string page = reference::world_reference();
  CHECK_THAT(page, Contains("## world / arena"));
  CHECK_THAT(
      page,
      Contains("| `length` | a number at least 1e-04 and at most 10000 m | `10` | along x, between "
               "the walls |"));
  CHECK_THAT(page, Contains("## world / robots / robot / sensors / *any sensor plugin*"));
  CHECK_THAT(page, Contains("| `path` | one of 'round', 'to_and_fro' | `round` |"));
  CHECK_THAT(page, Contains("| `team` | the id of a team |"));
  CHECK_THAT(page, Contains("the `<wall>`s in it") && !Contains("&lt;"));
}

TEST_CASE("The world reference says what an edit costs") {
  const std::string page = reference::world_reference();
  CHECK_THAT(page, Contains("its middle is the origin.\n\nWhile the "
                            "world runs, an edit creates the physics engine again.\n"));
  CHECK_THAT(page, Contains("| steps in one control period; an edit costs nothing |"));
  CHECK_THAT(page, Contains("no wheel rolls faster than this; may change while the world runs |"));
  CHECK_THAT(page, Contains("While the world runs, an edit creates the robot's body again."));
  CHECK_THAT(page, Contains("While the world runs, an edit creates the plugin's object again."));
}

TEST_CASE("A plugin's page is its declaration") {
  const std::string page = reference::plugin_reference(*host().find(PluginKind::behavior, "roam"));
  CHECK_THAT(page, Catch::StartsWith("# roam\n\nDrives about.\n\nA behavior, version 1.0.\n"));
  CHECK_THAT(page, Contains("| `speed` | number | rad/s | `10` | 0 to 50 | mean wheel rate |"));
  CHECK_THAT(page, Contains("| `patience` | whole number |  | `3` | at least 1 | turns"));
  CHECK_THAT(page, Contains("| `mood` | text |  | `calm` | `calm`, `bold` | how it drives |"));
  CHECK_THAT(page, Contains("| `weights` | numbers |  | `1 2` | each -5 to 5 | of its wheels |"));
  CHECK_THAT(page, Contains("- `bored`: nothing has happened"));
  CHECK_THAT(reference::plugin_reference(*host().find(PluginKind::behavior, "avoid")),
             Contains("Needs a sensor that makes readings of the kind `range`."));
}

TEST_CASE("A plugin's page shows the elements inside of its own") {
  const std::string eye = reference::plugin_reference(*host().find(PluginKind::sensor, "eye"));
  CHECK_THAT(eye, Contains("It may hold any number of `<threshold>`: A band of brightness.\n"
                           "\n| parameter | type | unit | default | range | meaning |\n"
                           "|---|---|---|---|---|---|\n"
                           "| `low` | number | cd | `0` | 0 to 1 | from here |\n"));
  CHECK_THAT(eye, Contains("Without any `<threshold>` it is as with\n\n```xml\n"
                           "<threshold low=\"0.2\" high=\"0.4\"/>\n"
                           "<threshold high=\"0.9\" colour=\"blue\"/>\n```\n"));
  CHECK_THAT(eye, Contains("It may hold any number of `<mask>`: What it does not look at.\n"));
  CHECK_THAT(eye, !Contains("Without any `<mask>`"));
  const std::string layers =
      reference::plugin_reference(*host().find(PluginKind::coordinator, "layers"));
  CHECK_THAT(layers, Contains("| `by` | text |  | required |  | whose stands |"));
  CHECK_THAT(layers, Contains("It may hold any number of these elements, in an order that "
                              "counts:\n\n`<suppress>`: One behaviour's command replaces "
                              "another's.\n"));
  CHECK_THAT(layers, Contains("\n`<inhibit>`: One behaviour's command is taken away.\n"));
  CHECK_THAT(layers, !Contains("holds other behaviours"));
  CHECK_THAT(reference::plugin_reference(*host().find(PluginKind::behavior, "blend")),
             Contains("It holds other behaviours: `<behaviors>` and `<coordinator>` stand in its "
                      "element as in a robot's."));
  CHECK_THAT(reference::world_reference(),
             Contains("A behaviour that holds others has `<behaviors>`, `<coordinator>` in it, as "
                      "a robot has"));
}

TEST_CASE("A plugin's declaration is its page without the title") {
  const Declaration& roam = *host().find(PluginKind::behavior, "roam");
  CHECK("# roam\n\n" + reference::plugin_declaration(roam) == reference::plugin_reference(roam));
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
  const world::ElementSpec& robot = *world::vocabulary().child("robots")->child("robot");
  CHECK(robot.child("body")->attribute("axle") != nullptr);
  CHECK(robot.child("rover") == nullptr);
}
