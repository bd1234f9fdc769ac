// Measures, as a user meets them.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "program.h"

using Catch::Contains;
using elsie::test::Workplace;
using nlohmann::json;

namespace {

const char* const kWorld = R"(<world format="1">
  <robots>
    <robot id="r1">
      <behaviors><wander/></behaviors>
      <coordinator><arbiter_suppression/></coordinator>
    </robot>
  </robots>
  <measures>
    <path_length id="way" robot="r1"/>
    <place_reached robot="r1" x="4" y="4"/>
  </measures>
  <limits time="2"/>
</world>
)";

// Fails in step 9.
const char* const kForgetful = R"(#include <stdexcept>
#include <elsie/api/measure.h>

class Forgetful final : public elsie::Measure {
 public:
  std::vector<elsie::Quantity> quantities() const override { return {{"", "", "nothing"}}; }
  void observe(const elsie::Observation& now) override {
    if (now.time_s > 0.095) {
      throw std::runtime_error("what was it again");
    }
  }
  void report(const elsie::RunEnd&, std::span<std::optional<double>>) const override {}
};
ELSIE_MEASURE(Forgetful, "forgetful", "Forgets what it is about");
)";

}  // namespace

TEST_CASE("The result of every run has the six measures that all have, then those of the world") {
  Workplace here;
  here.write("world.xml", kWorld);
  const json result = json::parse(here.elsie("run world.xml --json").out);
  const json& measures = result.at("measures");
  std::vector<std::string> names;
  for (const json& measure : measures) {
    names.push_back(measure.at("name"));
    CHECK(measure.at("unit").is_string());
    CHECK_FALSE(measure.at("meaning").get<std::string>().empty());
  }
  CHECK(names == std::vector<std::string>{"success", "time_s", "path_length_m", "collected",
                                          "collisions", "energy_left", "way",
                                          "place_reached.time_s", "place_reached.nearest_m"});
  const double driven = result.at("robots")[0].at("distance_m");
  CHECK(measures[0].at("value") == 0.0);
  CHECK(measures[2].at("value") == driven);
  CHECK(measures[6].at("value") == driven);
  CHECK(measures[7].at("value").is_null());
  CHECK(measures[8].at("value").get<double>() > 4.0);
}

TEST_CASE("The table has the world's measures, and no section when there are none") {
  Workplace here;
  here.write("world.xml", kWorld);
  const std::string table = here.elsie("run world.xml").out;
  CHECK_THAT(table, Contains("\nmeasure                  meaning "));
  CHECK_THAT(table, Contains("\nway                      length of the path driven "));
  CHECK_THAT(table, Contains("\nplace_reached.time_s     when the robot first was at the place ") &&
                        Contains("  none "));
  CHECK_THAT(here.elsie("run worlds/open_arena.xml --duration 1").out, !Contains("measure"));
}

TEST_CASE("--set changes measures, and the names in it must exist") {
  Workplace here;
  here.write("world.xml", kWorld);
  const auto near = here.elsie(
      "run world.xml --json --set 'measure[place_reached]/@x=0' "
      "--set 'measure[place_reached]/@y=0'");
  CHECK(json::parse(near.out).at("measures")[7].at("value") == 0.0);
  const auto wrong = here.elsie("check world.xml --set 'measure[way]/@robot=r2'");
  CHECK(wrong.exit_code == 2);
  CHECK_THAT(wrong.err, Contains("world.xml:9: plugin 'path_length': there is no robot 'r2' in the "
                                 "world; there is 'r1'"));
  const auto late = here.elsie("run world.xml --json --at '1:measure[way]=<path_length/>'");
  CHECK(late.exit_code != 2);
  CHECK_THAT(late.out, Contains("it measures from an edit of the world at "));
}

TEST_CASE("A measure of one file is compiled and run; one that fails ends the run by its name") {
  Workplace here;
  here.write("forgetful.cpp", kForgetful);
  here.write("world.xml", R"(<world format="1">
    <measures><forgetful id="f"/></measures><limits time="1"/></world>)");
  const auto run =
      here.sh("ELSIE_CACHE=cache elsie run world.xml --plugin forgetful.cpp --record run.csv");
  CHECK(run.exit_code == 3);
  CHECK_THAT(run.err, Contains("plugin 'forgetful' (id 'f') of the world failed in "
                               "step 9 (at 0.1 s): what was it again"));
}

TEST_CASE("Measures are listed, described and tried like other plugins") {
  Workplace here;
  CHECK_THAT(here.elsie("plugins").out, Contains("\nmeasures\n  collected "));
  CHECK_THAT(here.elsie("describe measure place_reached").out, Contains("A measure, version 1.0."));
  CHECK_THAT(here.elsie("describe behavior place_reached").err,
             Contains("there is no behavior 'place_reached'"));
  const auto tried = here.elsie("test-plugin path_length place_reached --set robot=r1");
  CHECK(tried.exit_code == 0);
  CHECK_THAT(tried.out, Contains("measure 'place_reached': no faults found"));
  const auto refused = here.elsie("test-plugin place_reached --set robot=nobody");
  CHECK(refused.exit_code == 1);
  CHECK_THAT(refused.out, Contains("refused every world"));
}
