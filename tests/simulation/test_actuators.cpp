// What robots do besides moving: who commands an actuator, what it costs, and who sees it.
#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/api/actuator.h"
#include "elsie/commands/led.h"
#include "elsie/readings/light.h"
#include "elsie/readings/omnidirectional_camera.h"
#include "elsie/simulation/fault.h"
#include "elsie/simulation/simulation.h"

#include "lively.h"

using namespace elsie;
using namespace elsie::test;

namespace {

/// Commands a lamp: its brightness is the parameter `shows`; below 0 it commands nothing.
class Shows : public Behavior {
 public:
  double shows = -1.0;
  std::string lamp;
  Response respond(const Perception&) override {
    Response response(Motion{0.1, 0.0, 0.0});
    if (shows >= 0.0) response.act(lamp, LedCommand{{255, 0, 0}, shows});
    return response;
  }
};
class OnlyShows final : public Shows {};

/// Gives every actuator the weakest wish.
class Modest final : public Coordinator {
 public:
  Motion coordinate(std::span<Member> members, const Perception&) override {
    for (Member& member : members) member.respond();
    return {};
  }
  std::size_t resolve(std::string_view actuator, std::span<const ActuatorWish> wishes) override {
    CHECK(actuator == "led");
    std::size_t weakest = 0;
    for (std::size_t i = 0; i < wishes.size(); ++i) {
      if (wishes[i].member->priority() < wishes[weakest].member->priority()) weakest = i;
    }
    return nobody ? wishes.size() : weakest;
  }
  bool nobody = false;
};

class Holds final : public Behavior {
 public:
  Coordination* inside = nullptr;
  Response respond(const Perception& now) override { return inside->respond(now); }
};

const plugin::Host& host() {
  static const plugin::Host made = [] {
    plugin::Host host(shipped_directory());
    const auto add = [&](auto one, const char* name, auto... items) {
      using Class = decltype(one);
      host.add(declare<std::remove_pointer_t<Class>>(PluginKind::behavior, name, "shows a light",
                                                     parameter("shows", &Shows::shows),
                                                     parameter("lamp", &Shows::lamp), items...));
    };
    add(static_cast<Shows*>(nullptr), "shows");
    add(static_cast<OnlyShows*>(nullptr), "only_shows", only_acts());
    add(static_cast<Shows*>(nullptr), "needs_led", commands<LedCommand>());
    host.add(declare<Modest>(PluginKind::coordinator, "modest", "gives to the weakest",
                             parameter("nobody", &Modest::nobody)));
    host.add(declare<Holds>(PluginKind::behavior, "holds", "holds others",
                            holds_behaviors(&Holds::inside)));
    return host;
  }();
  return made;
}

const std::string kLed = R"(<actuators><led/></actuators>)";

std::string robot_of(const std::string& inside, const std::string& coordinator = "<modest/>") {
  return R"(<world format="1"><robots><robot id="r1">)" + inside + "<coordinator>" + coordinator +
         "</coordinator></robot></robots></world>";
}

simulation::Simulation simulated(const std::string& world) {
  return {world::parse_world(world, "acts.xml", host()), host()};
}

double brightness(const simulation::Simulation& simulation, std::size_t actuator = 0) {
  double value = -1.0;
  simulation.visit_command(0, actuator, [&](const ReadingField& field) {
    if (field.name == "brightness") value = field.number(0);
  });
  return value;
}

std::string fault_of(const std::string& world) {
  try {
    simulation::Simulation simulation = simulated(world);
    simulation.step();
  } catch (const simulation::PluginFault& fault) {
    return fault.what();
  } catch (const world::WorldError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("A command holds until the next one, and the one who gave it is known") {
  simulation::Simulation simulation =
      simulated(robot_of(kLed + R"(<behaviors><shows id="signal" shows="0.5"/></behaviors>)",
                         "<arbiter_suppression/>"));
  CHECK(brightness(simulation) == 0.0);
  CHECK(simulation.actuator(0, 0).by.empty());
  simulation.step();
  CHECK(brightness(simulation) == 0.5);
  CHECK(simulation.actuator(0, 0).by == "signal");
  REQUIRE(simulation.actuator(0, 0).shine);
  CHECK(*simulation.actuator(0, 0).shine == Colour{255, 0, 0});
  simulation.edit("robot[r1]/behavior[signal]/@shows", "-1");
  simulation.step();
  CHECK(brightness(simulation) == 0.5);
  simulation.edit("robot[r1]/behavior[signal]/@shows", "0");
  simulation.step();
  CHECK(brightness(simulation) == 0.0);
  CHECK_FALSE(simulation.actuator(0, 0).shine);
  simulation.reset();
  CHECK(simulation.actuator(0, 0).by.empty());
}

TEST_CASE("Of several that command an actuator, the greatest priority decides, then the file") {
  const auto with = [](const std::string& behaviors, const std::string& coordinator) {
    simulation::Simulation simulation =
        simulated(robot_of(kLed + "<behaviors>" + behaviors + "</behaviors>", coordinator));
    simulation.step();
    return std::string(simulation.actuator(0, 0).by);
  };
  const std::string all = "<fusion_vector_summation/>";
  CHECK(with(R"(<shows id="a" shows="0.1"/><shows id="b" shows="0.2" priority="2"/>)", all) == "b");
  CHECK(with(R"(<shows id="a" shows="0.1"/><shows id="b" shows="0.2"/>)", all) == "a");
  CHECK(with(R"(<shows id="a" shows="0.1"/><only_shows id="b" shows="0.2" priority="2"/>)", all) ==
        "b");
  CHECK(with(R"(<only_shows id="b" shows="0.2"/><shows id="a" shows="0.1"/>)", all) == "a");
  // A behaviour that is not asked, or silenced, commands nothing.
  CHECK(with(R"(<shows id="a" shows="0.1" priority="3"/><shows id="b" shows="0.2"/>)",
             "<arbiter_suppression/>") == "a");
  SECTION("a coordinator may decide otherwise") {
    const std::string two =
        R"(<shows id="a" shows="0.1"/><shows id="b" shows="0.2" priority="2"/>)";
    CHECK(with(two, "<modest/>") == "a");
    CHECK(with(two, R"(<modest nobody="true"/>)") == "");
  }
}

TEST_CASE("A behaviour that only acts is asked in every period, and moves nothing") {
  simulation::Simulation simulation = simulated(
      robot_of(kLed + R"(<behaviors><only_shows shows="1"/><shows id="drives"/></behaviors>)",
               "<fusion_vector_summation/>"));
  simulation.step();
  const simulation::RobotView robot = simulation.robot(0);
  CHECK(robot.asked.forward == Approx(0.1));  // of the other one alone
  REQUIRE(robot.members.size() == 2);
  CHECK(robot.members[0].name() == "drives");
  CHECK(robot.members[1].name() == "only_shows");
  CHECK(robot.members[1].trace.asked);
  CHECK(robot.members[1].trace.share == 0.0);
  CHECK(robot.members[1].trace.reason == "only acts");
  CHECK(brightness(simulation) == 1.0);
  // Without any coordinator, too.
  simulation::Simulation alone =
      simulated(R"(<world format="1"><robots><robot id="r1">)" + kLed +
                R"(<behaviors><only_shows shows="1"/></behaviors></robot></robots></world>)");
  alone.step();
  CHECK(brightness(alone) == 1.0);
  CHECK(alone.robot(0).asked == Motion{});
}

TEST_CASE("Behaviours inside of behaviours command by the priority of those that hold them") {
  simulation::Simulation simulation = simulated(robot_of(kLed + R"(<behaviors>
        <holds id="outer" priority="2"><behaviors><shows id="inner" shows="0.3"/>
          <only_shows id="lamp" shows="0.4" priority="5"/></behaviors>
          <coordinator><fusion_vector_summation/></coordinator></holds>
        <shows id="other" shows="0.1"/></behaviors>)",
                                                         "<fusion_vector_summation/>"));
  simulation.step();
  CHECK(simulation.actuator(0, 0).by == "outer/lamp");
  CHECK(brightness(simulation) == 0.4);
}

TEST_CASE("An actuator is named by its id, or found by the kind of its commands") {
  const std::string two = R"(<actuators><led id="front"/><led id="rear" x="-0.04"/></actuators>)";
  simulation::Simulation simulation =
      simulated(robot_of(two + R"(<behaviors><shows shows="0.5" lamp="rear"/></behaviors>)",
                         "<arbiter_suppression/>"));
  simulation.step();
  CHECK(brightness(simulation, 0) == 0.0);
  CHECK(brightness(simulation, 1) == 0.5);
  CHECK(simulation.actuator(0, 1).frame.origin.x == Approx(-0.04).margin(0.01));
  CHECK_THAT(fault_of(robot_of(two + R"(<behaviors><shows shows="0.5" lamp="top"/></behaviors>)")),
             Catch::Contains("gives a command of the kind 'led' to the actuator 'top'") &&
                 Catch::Contains("it has 'front', 'rear'"));
  CHECK_THAT(fault_of(robot_of(R"(<behaviors><shows shows="0.5"/></behaviors>)")),
             Catch::Contains("has none that takes it; it has no actuators"));
  CHECK_THAT(fault_of(robot_of(R"(<behaviors><needs_led/></behaviors>)")),
             Catch::Contains("'needs_led' gives commands of the kind 'led'") &&
                 Catch::Contains("has no actuator that takes them; add <led>"));
}

TEST_CASE("A command that is not finite ends the run and names the behaviour") {
  simulation::Simulation simulation = simulated(
      robot_of(kLed + R"(<behaviors><shows shows="1"/></behaviors>)", "<arbiter_suppression/>"));
  simulation.step();
  ScriptedHost scripted([](const Perception&) {
    Response response;
    response.act(LedCommand{{}, std::numeric_limits<double>::quiet_NaN()});
    return response;
  });
  simulation::Simulation wrong(
      world::parse_world(
          robot_of(kLed + "<behaviors><scripted/></behaviors>", "<arbiter_suppression/>"),
          "acts.xml", scripted.host),
      scripted.host);
  CHECK_THROWS_WITH(wrong.step(), Catch::Contains("scripted") &&
                                      Catch::Contains("'brightness' of its command is"));
}

TEST_CASE("An actuator uses energy, and does nothing with an empty battery") {
  const auto used = [](const std::string& led, const std::string& robot = "") {
    simulation::Simulation simulation = simulated(
        R"(<world format="1"><robots><robot id="r1" )" + robot + "><actuators>" + led +
        R"(</actuators><behaviors><only_shows shows="0.5"/></behaviors></robot></robots></world>)");
    const double before = simulation.robot(0).state->energy;
    for (int i = 0; i < 100; ++i) simulation.step();
    return std::pair(before - simulation.robot(0).state->energy,
                     simulation.actuator(0, 0).shine.has_value());
  };
  CHECK(used(R"(<led energy_cost="2"/>)").first == Approx(2.0));
  CHECK(used(R"(<led energy_cost="0" power="30"/>)").first == Approx(15.0));
  CHECK(used(R"(<led/>)").second);
  CHECK_FALSE(used(R"(<led energy_cost="100"/>)", R"(energy="1")").second);
  simulation::Simulation empty = simulated(
      robot_of(kLed + R"(<behaviors><shows shows="0.5"/></behaviors>)", "<arbiter_suppression/>"));
  empty.step();
  empty.edit("robot[r1]/@energy", "0");
  empty.step();
  CHECK(brightness(empty) == 0.0);  // it has forgotten its command
  CHECK(empty.actuator(0, 0).by.empty());
}

TEST_CASE("With an empty battery an actuator forgets commands that are late, too") {
  simulation::Simulation late = simulated(robot_of(
      "<actuators><led><failure latency=\"0.05\"/></led></actuators><behaviors><only_shows "
      "shows=\"0.5\"/></behaviors>",
      ""));
  late.step();
  late.edit("robot[r1]/@energy", "0");
  late.step();
  const std::vector<simulation::Edit> silent{{"robot[r1]/@energy", "100"},
                                             {"robot[r1]/behavior[only_shows]/@shows", "0"}};
  late.edit(silent);
  for (int i = 0; i < 10; ++i) {
    late.step();
    CHECK(brightness(late) == 0.0);
  }
}

TEST_CASE("Noise and failures of an actuator change what it is told") {
  const auto first = [](const std::string& inside) {
    simulation::Simulation simulation =
        simulated(robot_of("<actuators><led>" + inside +
                               R"(</led></actuators><behaviors><shows shows="0.5"/></behaviors>)",
                           "<arbiter_suppression/>"));
    std::vector<double> seen;
    for (int i = 0; i < 4; ++i) {
      simulation.step();
      seen.push_back(brightness(simulation));
    }
    return seen;
  };
  using Seen = std::vector<double>;
  CHECK(first("") == Seen{0.5, 0.5, 0.5, 0.5});
  CHECK(first(R"(<noise on="brightness" scale="0.5" bias="0.25"/>)") == Seen{0.5, 0.5, 0.5, 0.5});
  CHECK(first(R"(<noise on="brightness" scale="0.5"/>)") == Seen{0.25, 0.25, 0.25, 0.25});
  CHECK(first(R"(<failure latency="0.02"/>)") == Seen{0.0, 0.0, 0.5, 0.5});
  CHECK(first(R"(<failure dropout="1"/>)") == Seen{0.0, 0.0, 0.0, 0.0});
  CHECK_THAT(
      fault_of(robot_of(R"(<actuators><led><noise on="bright" bias="1"/></led></actuators>)")),
      Catch::Contains("names no number of its command") && Catch::Contains("brightness"));
}

TEST_CASE("An omnidirectional camera sees what range sensors do not see") {
  simulation::Simulation simulation = simulated(R"(<world format="1">
    <resources><resource x="1" seen_by_range_sensors="false"/></resources>
    <robots><robot id="watcher"><sensors><omnidirectional_camera/></sensors></robot></robots>
  </world>)");
  simulation.step();
  const auto& seen =
      *static_cast<const OmnidirectionalReading*>(simulation.sensor(0, 0).sensor->reading());
  REQUIRE(seen.blobs.size() == 1);
  CHECK(seen.blobs[0].distance_m == Approx(1.0 - 0.04));
}

TEST_CASE("Other robots see a light from the next control period on") {
  simulation::Simulation simulation = simulated(R"(<world format="1"><robots>
    <robot id="signaller"><actuators><led intensity="0.2"/></actuators>
      <behaviors><only_shows shows="1"/></behaviors></robot>
    <robot id="watcher" x="1" heading_deg="180">
      <sensors><light/><light id="short" led_range="0.3"/>
        <omnidirectional_camera max_range="3"/></sensors></robot>
  </robots></world>)");
  const auto light = [&](std::size_t sensor) {
    return static_cast<const LightReading*>(simulation.sensor(1, sensor).sensor->reading())
        ->values[0];
  };
  simulation.step();
  CHECK(light(0) == 0.0);
  simulation.step();
  const double distance = 1.0 - 0.04 - 0.04;  // both are at the front edge
  CHECK(light(0) == Approx(0.04 / (distance * distance)).epsilon(0.01));
  CHECK(light(1) == 0.0);
  std::vector<double> reds;
  simulation.visit_reading(1, 2, [&](const ReadingField& field) {
    if (field.name == "red" && field.in_list) reds.push_back(field.number(0));
  });
  CHECK(std::count(reds.begin(), reds.end(), 255.0) == 1);
}

TEST_CASE("An edit adds, changes and removes actuators while the world runs") {
  simulation::Simulation simulation = simulated(
      robot_of(kLed + R"(<behaviors><shows shows="0.5"/></behaviors>)", "<arbiter_suppression/>"));
  simulation.step();
  simulation.edit("robot[r1]/actuator[led]/@intensity", "0.7");
  simulation.edit("robot[r1]/actuator[+]", R"(<led id="rear" x="-0.04"/>)");
  simulation.step();
  REQUIRE(simulation.actuators(0) == 2);
  CHECK(simulation.actuator(0, 0).by == "shows");  // it has kept its command
  CHECK(brightness(simulation, 1) == 0.0);
  simulation.edit("robot[r1]/actuator[rear]/@remove", "true");
  simulation.step();
  CHECK(simulation.actuators(0) == 1);
  CHECK(brightness(simulation) == 0.5);
}
