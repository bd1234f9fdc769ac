// How much there is of a field.
#include "support.h"

using namespace elsie::test;

namespace {

// Cells of 5 m x 5 m.
Scene marked(double first) { return Scene().field("ink", 2, {first, 1.0, 2.0, 3.0}); }

}  // namespace

TEST_CASE("A field has a total, a largest value, and a mean in a disc") {
  Scene now = marked(0.0);
  Measure ink("field_amount", {{"field", "ink"}, {"x", -2.5}, {"y", 2.5}, {"radius", 1}});
  ink.observe(now);
  CHECK(ink.value("total") == Approx(25.0 * 6.0));
  CHECK(ink.value("largest") == 3.0);
  CHECK(ink.value("disc") == 2.0);
  now.field("ink", 2, {4.0, 1.0, 6.0, 3.0});
  ink.observe(now.step());
  now.field("ink", 2, {0.0, 0.0, 2.0, 0.0});
  ink.observe(now.step());
  CHECK(ink.value("total") == Approx(25.0 * 2.0));
  CHECK(ink.value("total_mean") == Approx(25.0 * 0.5 * (14.0 + 2.0)));
  CHECK(ink.value("largest") == 6.0);
  CHECK(ink.value("disc_mean") == Approx(4.0));
}

TEST_CASE("A disc without the middle of a cell has the value of the cell that it is in") {
  Measure ink("field_amount", {{"field", "ink"}, {"x", 0.1}, {"y", -0.1}, {"radius", 0.5}});
  ink.observe(marked(0.0));
  CHECK(ink.value("disc") == 1.0);
  Measure beyond("field_amount", {{"field", "ink"}, {"x", 100}, {"y", 100}, {"radius", 0.5}});
  beyond.observe(marked(0.0));
  CHECK(beyond.value("disc") == 3.0);
}

TEST_CASE("A field that the world does not have is refused with those that it has") {
  CHECK_THAT(refusal(Measure("field_amount", {{"field", "heat"}}), marked(0.0)),
             Catch::Contains("the field 'heat', which the world does not have") &&
                 Catch::Contains("it has: ink"));
  CHECK(refusal(Measure("field_amount"), Scene()) ==
        "it is about the field 'pheromone', which the world does not have; add <fields> with a "
        "<field id=\"pheromone\"/>");
}

TEST_CASE("In a run, a field is measured as it is") {
  elsie::testing::World world = elsie::testing::World::from_text(R"(
    <world format="1">
      <arena length="4" width="4"/>
      <fields><field id="ink" start="2"/></fields>
      <robots>
        <robot id="r1">
          <actuators><pen field="ink" rate="3"/></actuators>
          <behaviors><lay_trail/></behaviors>
          <coordinator><arbiter_suppression/></coordinator>
        </robot>
      </robots>
      <measures><field_amount id="there" field="ink" radius="1"/></measures>
    </world>)");
  world.run_for(1.0);
  CHECK(*world.measured("there.total") > 32.0);
  CHECK(*world.measured("there.total") <= 32.0 + 3.0 + 1e-6);
  CHECK(*world.measured("there.largest") > 2.0);
  CHECK(*world.measured("there.disc") > 2.0);
}
