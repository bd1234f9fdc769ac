// Fields: what is deposited, how it evaporates and spreads, who senses it, and what edits leave.
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/api/actuator.h"
#include "elsie/api/sensor.h"
#include "elsie/readings/antennae.h"
#include "elsie/simulation/fault.h"

#include "lively.h"

using namespace elsie;
using namespace elsie::test;
using simulation::FieldView;

namespace {

/// A robot in the middle of 2 x 2 m, with a pen there.
Simulation with_pen(const std::string& field, const std::string& pen = "",
                    const std::string& physics = "", const std::string& robot = "") {
  return of("<arena length=\"2\" width=\"2\"/><physics " + physics + "/><fields><field id=\"f\" " +
                field + "/></fields>",
            robot + "<actuators><pen field=\"f\" x=\"0.01\" y=\"0.01\" " + pen +
                "/></actuators><behaviors><lay_trail/></behaviors>");
}

double total(const FieldView& field) {
  double sum = 0.0;
  for (const double each : field.grid) sum += field.scale * each;
  return sum * field.cells.area();
}

/// The middle and the variance along x, or along y.
struct Spot {
  double middle = 0.0, variance = 0.0;
};
Spot spot(const FieldView& field, bool along_y) {
  double sum = 0.0, first = 0.0, second = 0.0;
  for (std::size_t row = 0; row < field.cells.rows; ++row) {
    for (std::size_t column = 0; column < field.cells.columns; ++column) {
      const double at = along_y ? field.cells.width * (static_cast<double>(row) + 0.5)
                                : field.cells.length * (static_cast<double>(column) + 0.5);
      const double there = field.value(column, row);
      sum += there, first += there * at, second += there * at * at;
    }
  }
  const double middle = first / sum;
  return {middle, second / sum - middle * middle};
}

std::vector<double> tips(const Simulation& simulation) {
  std::vector<double> values;
  simulation.visit_reading(0, 0, [&](const ReadingField& field) {
    for (std::size_t i = 0; i < field.count; ++i) values.push_back(field.number(i));
  });
  return values;
}

std::string refusal_of(Simulation& simulation, const std::string& path, const std::string& value) {
  try {
    simulation.edit(path, value);
  } catch (const simulation::EditRefused& refused) {
    return refused.what();
  }
  return "";
}

/// Deposits into, and senses, a field whose name it does not declare.
struct BlotCommand {
  static constexpr const char* kind = "blot";
  template <class Visitor>
  void visit(Visitor&&) const {}
};
class Blot final : public ActuatorOf<BlotCommand> {
 public:
  std::string field = "f";
  double amount = 1.0;
  void act(const BlotCommand&, const ActuatorContext& now) override {
    now.robot->deposit(field, amount);
  }
};

std::string fault_of_blot(const std::string& blot) {
  static const plugin::Host host = [] {
    plugin::Host made(shipped_directory());
    made.add(declare<Blot>(PluginKind::actuator, "blot", "deposits once a period",
                           takes<BlotCommand>(), parameter("field", &Blot::field),
                           parameter("amount", &Blot::amount)));
    return made;
  }();
  const std::string world = R"(<world format="1"><fields><field id="f"/><field id="heat"/></fields>
      <robots><robot id="r1"><actuators><blot )" +
                            blot + R"(/></actuators></robot></robots></world>)";
  try {
    Simulation simulation(world::parse_world(world, "blot.xml", host), host);
    simulation.step();
  } catch (const simulation::PluginFault& fault) {
    return fault.what();
  }
  return "";
}

}  // namespace

TEST_CASE("What a pen deposits is in the cell below it, and all of it stays while it spreads") {
  Simulation still = with_pen("cell=\"0.1\"", "rate=\"3\"");
  advance(still, 500);
  const FieldView field = still.field(0);
  CHECK(field.cells.columns == 20);
  CHECK(total(field) == Approx(15.0).epsilon(1e-12));
  CHECK(field.value(10, 10) == Approx(15.0 / 0.01).epsilon(1e-12));
  for (const std::string spread : {"1e-5", "0.01", "1", "10000"}) {
    CAPTURE(spread);
    Simulation spreading = with_pen("cell=\"0.1\" spread=\"" + spread + "\"", "rate=\"3\"");
    advance(spreading, 500);
    CHECK(total(spreading.field(0)) == Approx(15.0).epsilon(1e-10));
    for (const double each : spreading.field(0).grid) CHECK(each >= 0.0);
  }
}

TEST_CASE("A field that spreads without end is the same everywhere") {
  Simulation simulation = with_pen("cell=\"0.05\" spread=\"10000\"");
  advance(simulation, 100);
  for (const double each : simulation.field(0).grid) CHECK(each == Approx(0.25).epsilon(1e-3));
}

TEST_CASE("A field evaporates to half in its half-life, whatever the control period") {
  for (const std::string physics : {"", "control_steps=\"7\"", "step=\"0.001\""}) {
    CAPTURE(physics);
    Simulation simulation =
        of("<fields><field id=\"f\" half_life=\"0.35\" start=\"8\"/></fields><physics " + physics +
           "/>");
    while (simulation.time_s() < 0.7 - 1e-9) simulation.step();
    CHECK(simulation.field(0).value(3, 5) == Approx(2.0).epsilon(1e-12));
    while (simulation.time_s() < 70.0) simulation.step();  // 200 half-lives
    CHECK(simulation.field(0).value(3, 5) <= 8.0 * std::exp2(-199.0));
  }
}

TEST_CASE("A spot stays where it is, and its variance grows by 2 D t along each axis") {
  for (const std::string control_steps : {"1", "5", "20"}) {
    CAPTURE(control_steps);
    Simulation simulation =
        with_pen("cell=\"0.02\" spread=\"0.002\"", "", "control_steps=\"" + control_steps + "\"");
    advance(simulation, 20);
    simulation.edit("robot[r1]/behavior[lay_trail]/@flow", "0");
    advance(simulation, 20);
    const Spot before[] = {spot(simulation.field(0), false), spot(simulation.field(0), true)};
    advance(simulation, 300);
    for (const bool along_y : {false, true}) {
      const Spot after = spot(simulation.field(0), along_y);
      CHECK(after.middle == Approx(before[along_y].middle).epsilon(1e-9));
      CHECK(after.variance - before[along_y].variance == Approx(2 * 0.002 * 3.0).epsilon(1e-4));
    }
  }
}

TEST_CASE("A spot that spreads is close to the normal distribution of a diffusion") {
  Simulation simulation = with_pen("cell=\"0.02\" spread=\"0.002\"");
  simulation.step();
  simulation.edit("robot[r1]/behavior[lay_trail]/@flow", "0");
  advance(simulation, 999);
  const FieldView field = simulation.field(0);
  const double amount = 0.01, variance = 2 * 0.002 * 10.0;
  CHECK(field.value(50, 50) == Approx(amount / (2 * M_PI * variance)).epsilon(0.02));
  const double off = 10 * 0.02;
  CHECK(field.value(60, 50) ==
        Approx(field.value(50, 50) * std::exp(-0.5 * off * off / variance)).epsilon(0.02));
  CHECK(field.value(60, 50) == Approx(field.value(50, 60)).epsilon(1e-9));
}

TEST_CASE("A pen that takes away leaves no less than nothing") {
  Simulation simulation = with_pen("start=\"1\"", "rate=\"-1\"");
  simulation.step();
  CHECK(total(simulation.field(0)) == Approx(4.0 - 0.0025).epsilon(1e-12));
  advance(simulation, 100);
  CHECK(total(simulation.field(0)) == Approx(4.0 - 0.0025).epsilon(1e-12));
}

TEST_CASE("Antennae sense in the next control period what a pen has laid in this one") {
  Simulation simulation = with_pen(
      "cell=\"0.1\"", "rate=\"1\"", "",
      "<sensors><antennae field=\"f\" x=\"0.05\" y=\"0.05\" width=\"0.1\" tips=\"3\"/></sensors>");
  simulation.step();
  CHECK(tips(simulation) == std::vector<double>{0.0, 0.0, 0.0});
  simulation.step();
  // The middle of the cell with the deposit is at (0.05, 0.05).
  const double there = 0.01 / 0.01;
  REQUIRE(tips(simulation).size() == 3);
  CHECK(tips(simulation)[0] == Approx(0.5 * there));
  CHECK(tips(simulation)[1] == Approx(there));
  CHECK(tips(simulation)[2] == Approx(0.5 * there));
}

TEST_CASE("Beyond the walls antennae sense what is nearest to them in the arena") {
  Simulation simulation =
      of("<arena length=\"2\" width=\"2\"/><fields><field id=\"f\" start=\"3\"/></fields>",
         "<sensors><antennae field=\"f\" width=\"50\"/></sensors>");
  simulation.step();
  CHECK(tips(simulation) == std::vector<double>{3.0, 3.0});
}

TEST_CASE("What robots deposit does not depend on the number of threads") {
  std::string robots;
  for (int i = 0; i < 70; ++i) {
    robots += "<robot id=\"c" + std::to_string(i) + "\" x=\"" + std::to_string(i % 10 * 0.4 - 2) +
              "\" y=\"" + std::to_string(i / 10 * 0.4 - 1.2) +
              "\"><sensors><antennae/></sensors><actuators><pen/></actuators><behaviors>"
              "<lay_trail/><follow_gradient/><wander priority=\"0.5\"/></behaviors><coordinator>"
              "<fusion_vector_summation/></coordinator></robot>";
  }
  const world::World world = world::parse_world(
      "<world format=\"1\"><fields><field id=\"pheromone\" half_life=\"2\" spread=\"0.001\"/>"
      "</fields><robots>" +
          robots + "</robots></world>",
      "crowd.xml", shipped());
  const auto hash = [&](std::size_t threads) {
    simulation::Options options;
    options.threads = threads;
    Simulation simulation(world, shipped(), options);
    advance(simulation, 150);
    return simulation.state_hash();
  };
  CHECK(hash(1) == hash(3));
}

TEST_CASE("The hash of a state counts what is in its fields") {
  const auto hash = [](const std::string& rate) {
    Simulation simulation = with_pen("", "rate=\"" + rate + "\"");
    advance(simulation, 10);
    return simulation.state_hash();
  };
  CHECK(hash("1") == hash("1"));
  CHECK(hash("1") != hash("2"));
}

TEST_CASE("A reset empties fields") {
  Simulation simulation = with_pen("start=\"2\"");
  advance(simulation, 100);
  const std::uint64_t hash = simulation.state_hash();
  simulation.reset();
  CHECK(total(simulation.field(0)) == Approx(8.0));
  advance(simulation, 100);
  CHECK(simulation.state_hash() == hash);
}

TEST_CASE("An edit of a field keeps what is in it, unless its cells are others") {
  Simulation simulation = with_pen("cell=\"0.1\"");
  advance(simulation, 100);
  simulation.edit("field[f]/@spread", "0.01");
  simulation.edit("field[f]/@half_life", "1");
  simulation.edit("field[f]/@start", "100");
  simulation.edit("field[+]", "<field id=\"heat\" start=\"5\"/>");
  REQUIRE(simulation.fields() == 2);
  CHECK(total(simulation.field(0)) == Approx(1.0));
  CHECK(total(simulation.field(1)) == Approx(20.0));
  simulation.edit("robot[r1]/behavior[lay_trail]/@flow", "0");
  advance(simulation, 100);
  CHECK(total(simulation.field(0)) == Approx(0.5));
  simulation.edit("field[f]/@cell", "0.2");
  CHECK(simulation.field(0).cells.columns == 10);
  CHECK(total(simulation.field(0)) == Approx(400.0));
  simulation.edit("field[heat]/@remove", "true");
  CHECK(simulation.fields() == 1);
}

TEST_CASE("A field that a robot names stays") {
  Simulation simulation = with_pen("");
  CHECK(refusal_of(simulation, "field[f]/@remove", "true") ==
        "field[f]/@remove=true: the actuator 'pen' is for the field 'f', which the world does not "
        "have; add <fields> with a <field id=\"f\"/>");
  CHECK(refusal_of(simulation, "robot[r1]/actuator[pen]/@field", "g") ==
        "robot[r1]/actuator[pen]/@field=g: the actuator 'pen' is for the field 'g', which the "
        "world does not have; it has: f");
  advance(simulation, 10);
  CHECK(total(simulation.field(0)) == Approx(0.1));
}

TEST_CASE("A refused edit leaves fields as they were") {
  Simulation simulation = with_pen("");
  advance(simulation, 100);
  const std::vector<simulation::Edit> edits{{"field[f]/@cell", "0.5"},
                                            {"robot[+]", "<robot id=\"r2\"/>"}};
  CHECK_THROWS_AS(simulation.edit(edits), simulation::EditRefused);  // no room for r2
  CHECK(simulation.field(0).cells.columns == 40);
  CHECK(total(simulation.field(0)) == Approx(1.0));
}

TEST_CASE("An actuator that names no field of the world, or no amount, is at fault") {
  CHECK(fault_of_blot("") == "");
  CHECK_THAT(fault_of_blot("field=\"haet\""),
             Catch::Contains("it names the field 'haet', which the world does not have; did you "
                             "mean 'heat'?"));
  CHECK_THAT(fault_of_blot("field=\"smoke\""), Catch::Contains("; it has: f, heat"));
  CHECK_THAT(fault_of_blot("amount=\"2e12\""),
             Catch::Contains("it deposits an amount of 2e+12; expected a number from -1e12 "
                             "to 1e12"));
}
