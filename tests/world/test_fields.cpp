// The fields of a world file: what it says, their cells, and who may name them.
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/world/fields.h"
#include "elsie/world/world_tree.h"
#include "elsie/world/writer.h"

#include "equal.h"
#include "fixture.h"

using namespace elsie;
using namespace elsie::test;

namespace {

std::string fields(const std::string& markup) { return "<fields>" + markup + "</fields>"; }

/// A sensor that names a field.
class Nose final : public SensorOf<EchoReading> {
 public:
  std::string smells = "smoke";
  EchoReading sense(const SensorContext&) override { return {}; }
};

const plugin::Host& host_with_noses() {
  static const plugin::Host host = [] {
    plugin::Host made = make_host();
    made.add(declare<Nose>(PluginKind::sensor, "nose", "Smells", produces<EchoReading>(),
                           names_field("smells"),
                           parameter("smells", &Nose::smells, {.meaning = "what", .live = false})));
    return made;
  }();
  return host;
}

/// What is wrong with a world with this and a robot with a nose; "" if nothing is.
std::string problems_of_nose(const std::string& content, const std::string& nose,
                             std::vector<std::string> edits = {}) {
  try {
    const world::World world = world::parse_world(
        "<world format=\"1\">\n" + content + "\n<robots><robot id=\"r1\"><sensors>\n<nose " + nose +
            "/></sensors></robot></robots></world>",
        "nose.xml", host_with_noses(), options());
    if (!edits.empty()) {
      world::edited(world::WorldTree(world), host_with_noses(), options(std::move(edits)));
    }
    return "";
  } catch (const world::WorldError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("A field neither evaporates nor spreads, and is empty, unless the file says more") {
  const world::World w = read(fields(
      R"(<field id="ink"/><field id="pheromone" cell="0.1" half_life="30" spread="0.0005" start="2" full="9" colour="#ff0000"/>)"));
  REQUIRE(w.fields.size() == 2);
  const world::ScalarField &ink = w.fields[0], &pheromone = w.fields[1];
  CHECK(ink.id == "ink");
  CHECK(ink.cell == 0.05);
  CHECK_FALSE(ink.half_life);
  CHECK(ink.spread == 0.0);
  CHECK(ink.start == 0.0);
  CHECK_FALSE(ink.full);
  CHECK(pheromone.cell == 0.1);
  CHECK(pheromone.half_life == 30.0);
  CHECK(pheromone.spread == 0.0005);
  CHECK(pheromone.start == 2.0);
  CHECK(pheromone.full == 9.0);
  CHECK(pheromone.colour == Colour{255, 0, 0});
  CHECK(same(w, world::parse_world(world::write_world(w), w.file, host(), options())));
}

TEST_CASE("Cells divide the arena evenly, and are no larger than the file says") {
  world::Arena arena;
  arena.length = 1.0;
  arena.width = 0.35;
  world::ScalarField field;
  field.cell = 0.1;
  const world::FieldCells cells = world::cells_of(field, arena);
  CHECK(cells.columns == 10);
  CHECK(cells.rows == 4);
  CHECK(cells.length == Approx(0.1));
  CHECK(cells.width == Approx(0.0875));
  field.cell = 7.0;
  CHECK(world::cells_of(field, arena).count() == 1);
}

TEST_CASE("A million cells are fine, a thousand million are refused, with cells that would do") {
  const std::string arena = "<arena length=\"50\" width=\"50\"/>";
  CHECK(problems(arena + fields("<field id=\"heat\"/>")) == "");
  const std::string refused =
      problems("<arena length=\"1500\" width=\"1700\"/>\n" + fields("<field id=\"heat\"/>"));
  CHECK(refused ==
        "world.xml:2: the field 'heat' would have 30000 x 34000 cells of 0.05 m; expected at most "
        "4000000 cells, which cell=\"0.8\" gives in this arena");
  CHECK(problems("<arena length=\"1500\" width=\"1700\"/>" +
                 fields("<field id=\"heat\" cell=\"0.8\"/>")) == "");
}

TEST_CASE("A sensor or an actuator names a field of the world") {
  const std::string smoke = "<fields><field id=\"smoke\"/><field id=\"heat\"/></fields>";
  CHECK(problems_of_nose(smoke, "") == "");
  CHECK(problems_of_nose(smoke, "smells=\"heat\"") == "");
  CHECK(problems_of_nose("", "") ==
        "nose.xml:4: the sensor 'nose' is for the field 'smoke', which the world does not have; "
        "add <fields> with a <field id=\"smoke\"/>");
  CHECK(problems_of_nose(smoke, "smells=\"haet\"") ==
        "nose.xml:4: the sensor 'nose' is for the field 'haet', which the world does not have; "
        "did you mean 'heat'?");
  CHECK(problems_of_nose(smoke, "smells=\"roses\"") ==
        "nose.xml:4: the sensor 'nose' is for the field 'roses', which the world does not have; "
        "it has: smoke, heat");
}

TEST_CASE("In a running world, too, a field that is named cannot be removed") {
  const std::string smoke = "<fields><field id=\"smoke\"/><field id=\"heat\"/></fields>";
  CHECK(problems_of_nose(smoke, "", {"field[heat]/@remove=true"}) == "");
  CHECK_THAT(problems_of_nose(smoke, "", {"field[smoke]/@remove=true"}),
             Catch::Contains("the sensor 'nose' is for the field 'smoke', which the world does not "
                             "have; it has: heat"));
  CHECK_THAT(problems_of_nose(smoke, "", {"field[smoke]/@id=mist"}),
             Catch::Contains("the sensor 'nose' is for the field 'smoke'"));
  CHECK(problems_of_nose(smoke, "",
                         {"field[smoke]/@remove=true", "field[+]=<field id=\"smoke\"/>"}) == "");
}
