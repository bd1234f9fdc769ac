#include <catch2/catch.hpp>

#include "elsie/plugin/error.h"
#include "elsie/simulation/simulation.h"
#include "elsie/world/reader.h"

#include "places.h"
#include "shipped.h"
#include "situation.h"

using namespace elsie;
using namespace elsie::test;

namespace {

plugin::Object<Behavior> commanded(const Parameters& parameters) {
  return test::make<Behavior>(PluginKind::behavior, "commanded", parameters);
}

constexpr const char* kWorld = R"(
<world format="1">
  <robots>
    <robot id="r1" team="red">
      <actuators><gripper id="grip"/><led id="lamp"/></actuators>
      <behaviors><commanded commands="lamp.red lamp.brightness grip.closed"/></behaviors>
      <coordinator><arbiter_suppression/></coordinator>
    </robot>
  </robots>
</world>)";

simulation::Simulation simulation_of(const std::string& text) {
  return {world::parse_world(text, "commanded.xml", test::shipped()), test::shipped()};
}

/// The number of the command that an actuator of the robot carries out.
double number(const simulation::Simulation& simulation, std::size_t actuator,
              const std::string& name) {
  double found = -1.0;
  simulation.visit_command(0, actuator, [&](const ReadingField& field) {
    if (field.name == name) found = field.number(0);
  });
  return found;
}

}  // namespace

TEST_CASE("It asks for the motion that is set, with the activation that is set") {
  const auto behavior =
      commanded({{"forward", 0.2}, {"lateral", 0.1}, {"turn", -1.0}, {"activation", 0.5}});
  const Response response = behavior->respond(Situation().perception());
  CHECK(response.command == Motion{0.2, 0.1, -1.0});
  CHECK(response.activation == 0.5);
  CHECK(response.acts.empty());
}

TEST_CASE("By default it stands still") {
  CHECK(commanded({})->respond(Situation().perception()).command == Motion{});
}

TEST_CASE("It gives each actuator one command with the values that are set") {
  const auto behavior = commanded({{"commands", std::string("lamp.red grip.closed lamp.green")},
                                   {"values", std::vector<double>{255.0, 1.0, 7.0}}});
  const Response response = behavior->respond(Situation().perception());
  REQUIRE(response.acts.size() == 2);
  CHECK(response.acts[0].actuator() == "lamp");
  CHECK(response.acts[0].numbers() == NamedNumbers{{"red", 255.0}, {"green", 7.0}});
  CHECK(response.acts[1].actuator() == "grip");
  CHECK(response.acts[1].numbers() == NamedNumbers{{"closed", 1.0}});
}

TEST_CASE("Without values it gives no commands") {
  const auto behavior = commanded({{"commands", std::string("grip.closed")}});
  CHECK(behavior->respond(Situation().perception()).acts.empty());
}

TEST_CASE("Names and values that do not fit together are refused") {
  CHECK_THROWS_WITH(
      commanded({{"commands", std::string("grip.closed")}, {"values", std::vector{1.0, 2.0}}}),
      Catch::Contains("`values` has 2 numbers, but `commands` names 1"));
  CHECK_THROWS_WITH(commanded({{"commands", std::string("gripper")}}),
                    Catch::Contains("'gripper'; expected the id of an actuator"));
  CHECK_THROWS_WITH(commanded({{"commands", std::string("grip.closed grip.closed")}}),
                    Catch::Contains("'grip.closed' twice"));
}

TEST_CASE("While a world runs, its parameters drive the robot and its actuators") {
  simulation::Simulation simulation = simulation_of(kWorld);
  simulation.step();
  CHECK(simulation.robot(0).asked == Motion{});
  simulation.edit("robot[r1]/behavior[commanded]/@forward", "0.2");
  simulation.edit("robot[r1]/behavior[commanded]/@values", "200 0.5 1");
  simulation.step();
  CHECK(simulation.robot(0).asked == Motion{0.2, 0.0, 0.0});
  CHECK(number(simulation, 0, "closed") == 1.0);
  CHECK(number(simulation, 1, "red") == 200.0);
  CHECK(number(simulation, 1, "brightness") == 0.5);
  simulation.edit("robot[r1]/behavior[commanded]/@values", "200 0.5 0");
  simulation.step();
  CHECK(number(simulation, 0, "closed") == 0.0);
}

TEST_CASE("An actuator or a number that the robot lacks ends the run with a sentence") {
  simulation::Simulation simulation = simulation_of(kWorld);
  simulation.edit("robot[r1]/behavior[commanded]/@values", "1 1 1");
  CHECK_NOTHROW(simulation.step());
  const std::string text = kWorld;
  std::string wrong = text;
  wrong.replace(wrong.find("grip.closed"), 11, "grip.opened\" values=\"1 1 1");
  simulation::Simulation faulty = simulation_of(wrong);
  CHECK_THROWS_WITH(faulty.step(), Catch::Contains("'opened'") && Catch::Contains("'closed'"));
}
