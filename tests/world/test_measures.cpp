// What a world measures.
#include <stdexcept>

#include <catch2/catch.hpp>

#include "elsie/reference/reference.h"
#include "elsie/reference/schema.h"
#include "elsie/world/attributes.h"
#include "elsie/world/writer.h"

#include "fixture.h"

using namespace elsie;
using namespace elsie::test;
using Catch::Contains;

namespace {

const char* const kMeasures = R"(<measures>
  <way robot="r1"/>
  <hits/>
  <way id="home" from_s="2"><gate x="1"/><gate y="2"/></way>
  <way/>
</measures>)";

}  // namespace

TEST_CASE(
    "A measure is called after its plugin, with a number if there are several, or as it says") {
  const world::World w = read(kMeasures);
  REQUIRE(w.measures.size() == 4);
  CHECK(w.measures[0].id == "way");
  CHECK(w.measures[1].id == "hits");
  CHECK(w.measures[2].id == "home");
  CHECK(w.measures[2].plugin == "way");
  CHECK(w.measures[3].id == "way_2");
  CHECK(std::get<std::string>(w.measures[0].parameters.at("robot")) == "r1");
  REQUIRE(w.measures[2].elements.size() == 2);
  CHECK(std::get<double>(w.measures[2].elements[1].parameters.at("y")) == 2.0);
  CHECK(w.measures[1].location.line == 3);
}

TEST_CASE("Measures are written with their ids; a world without any says nothing of them") {
  CHECK_THAT(world::write_world(read("")), !Contains("measure"));
  CHECK_THAT(world::write_world(read(kMeasures)),
             Contains("  <measures>\n    <way id=\"way\" robot=\"r1\"/>\n"
                      "    <hits id=\"hits\"/>\n    <way id=\"home\" from_s=\"2\">\n"
                      "      <gate x=\"1\"/>\n      <gate y=\"2\"/>\n    </way>\n"
                      "    <way id=\"way_2\"/>\n  </measures>\n"));
}

TEST_CASE("Paths lead to measures and to what is in them") {
  const auto with = [](std::vector<std::string> edits) {
    return read(kMeasures, std::move(edits));
  };
  CHECK(std::get<double>(with({"measure[home]/@from_s=3"}).measures[2].parameters.at("from_s")) ==
        3.0);
  CHECK(std::get<double>(
            with({"measure[home]/gate[2]/@y=3"}).measures[2].elements[1].parameters.at("y")) ==
        3.0);
  CHECK(std::get<std::string>(
            with({"measure[way_2]/@robot=r2"}).measures[3].parameters.at("robot")) == "r2");
  CHECK(std::get<double>(
            with({"hits=<way id=\"home2\" from_s=\"5\"/>"}).measures[1].parameters.at("from_s")) ==
        5.0);
  CHECK_THAT(problems(kMeasures, {"measure[hom]/@from_s=3"}),
             Contains("there is no measure[hom]; there are: way, hits, home, way_2"));
}

TEST_CASE("Parameters of a measure are fixed before a run") {
  const world::World w = read(kMeasures);
  const world::Attributes attributes(w, host(), {});
  for (const char* path : {"measure[home]/@from_s", "measure[home]/gate[1]/@x"}) {
    const world::AttributeTarget place = attributes.find(path).at(0);
    CHECK(place.path == path);
    CHECK(place.robot == nullptr);
    CHECK(place.use == &w.measures[2]);
    CHECK_FALSE(place.field.is_live());
    CHECK(place.live.empty());
  }
}

TEST_CASE("An unknown measure keeps no robot from being checked") {
  const std::string robot =
      "<robots><robot id='r1'><behaviors><roam/></behaviors></robot></robots>";
  const std::string all = problems("<measures><ways/></measures>" + robot);
  CHECK_THAT(all, Contains("there is no measure 'ways'"));
  CHECK_THAT(all, Contains("has behaviours but no coordinator"));
  CHECK_THAT(problems(robot + "<measures><ways/></measures>"),
             Contains("has behaviours but no coordinator"));
}

TEST_CASE("The schema and the reference page know measures") {
  const std::string schema = reference::world_schema(host());
  CHECK_THAT(schema, Contains("<xs:element name=\"way\" type=\"measure.way.type\">"));
  CHECK_THAT(
      schema,
      Contains("<xs:unique name=\"measure_id\"><xs:selector xpath=\"measures/*|rules/*\"/>"));
  CHECK_THAT(reference::world_reference(), Contains("## world / measures / *any measure plugin*"));
  const std::string page = reference::plugin_reference(*host().find(PluginKind::measure, "way"));
  CHECK_THAT(page, Contains("A measure, version 1.0."));
  CHECK_THAT(page, Contains("It may hold any number of `<gate>`: A place on the way."));
}
