#include <limits>

#include <catch2/catch.hpp>

#include "elsie/world/error.h"

#include "wheels.h"
#include "world_builder.h"

using namespace elsie;
using namespace elsie::test;
using elsie::test::wheels;
using simulation::PluginFault;
using simulation::Simulation;

namespace {
/// Runs a behaviour that misbehaves in step 3.
void run(std::function<Response()> misbehave) {
  ScriptedHost scripted([&](const Perception& now) {
    return now.time_s() > 0.025 ? misbehave() : Response(wheels(1, 1));
  });
  world::World world = one_robot();
  Simulation(world, scripted.host).run();
}
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
}  // namespace

namespace {
struct Wordless final : std::exception {
  const char* what() const noexcept override { return nullptr; }
};

/// A response with one member that is set.
std::function<Response()> with(double Response::*member, double value) {
  return [=] {
    Response response;
    response.*member = value;
    return response;
  };
}
}  // namespace

TEST_CASE("A behaviour that throws or answers nonsense is named, with its robot and the step") {
  const std::string range = "which is not in [0, 1]";
  const std::pair<std::function<Response()>, std::string> wrong[] = {
      {[]() -> Response { throw std::runtime_error("out of ideas"); }, "out of ideas"},
      {[]() -> Response { throw Wordless(); }, "Wordless"},
      {[]() -> Response { throw std::runtime_error(""); },
       "an exception of type std::runtime_error"},
      {[]() -> Response { throw 42; }, "an exception of type int"},
      {[] { return Response(wheels(kNan, 0)); }, "its command is not a finite number"},
      {[] { return Response(wheels(0, std::numeric_limits<double>::infinity())); },
       "its command is not a finite number"},
      {with(&Response::activation, 1.5), "its activation is 1.5, " + range},
      {with(&Response::strength, kNan), "its strength is "},
      {[] {
         Response response;
         response.events.push_back({"surprise"});
         return response;
       },
       "raised the event 'surprise', which its declaration does not name"},
      {[]() -> Response {
         const Readings<RangeReading> none;
         return wheels(none[0]->distance_m, 0.0);
       },
       "it asks for reading number 0 of kind 'range'"}};
  for (const auto& [misbehave, sentence] : wrong) {
    CHECK_THROWS_WITH(
        run(misbehave),
        Catch::StartsWith("plugin 'scripted' of robot 'r1' failed in step 3 (at 0.03 s): ") &&
            Catch::Contains(sentence));
  }
  CHECK_THROWS_AS(run([]() -> Response { throw 42; }), PluginFault);
}

TEST_CASE("The strengths of speed and turn are looked at like the strength as a whole") {
  for (const double wrong : {kNan, 7.0, -0.1}) {
    CAPTURE(wrong);
    for (const auto& [part, name] : {std::pair(&Response::speed_strength, "speed"),
                                     std::pair(&Response::turn_strength, "turn")}) {
      const auto misbehave = [wrong, part = part] {
        Response response;
        response.*part = wrong;
        return response;
      };
      CHECK_THROWS_WITH(run(misbehave),
                        Catch::Contains("its " + std::string(name) + "_strength is ") &&
                            Catch::Contains("which is not in [0, 1]"));
    }
  }
}

TEST_CASE("The message names the id of a plugin that has one") {
  ScriptedHost scripted([](const Perception&) -> Response { throw std::runtime_error("no"); });
  world::World world;
  auto use = behavior("scripted");
  use.id = "second";
  world.robots.push_back(robot("r1", 0, 0, 0, use));
  CHECK_THROWS_WITH(Simulation(world, scripted.host).run(),
                    "plugin 'scripted' (id 'second') of robot 'r1' failed in step 0 (at 0 s): no");
}

namespace {

/// Catches everything that its members throw, and goes on.
class Careless final : public Coordinator {
 public:
  Motion coordinate(std::span<Member> members, const Perception&) override {
    try {
      return members[0].respond().command;
    } catch (...) {
      return {};
    }
  }
};

/// Asks for what it should not get: desirabilities out of range.
class Rater final : public Coordinator {
 public:
  Motion coordinate(std::span<Member> members, const Perception&) override {
    const Motion candidates[] = {{}};
    double desirability[1];
    members[0].rate(candidates, desirability);
    return {};
  }
};

/// Says of its one member what should not be said.
class Boaster final : public Coordinator {
 public:
  static inline double weight = 1.0, share = 1.0;
  Motion coordinate(std::span<Member> members, const Perception&) override {
    members[0].trace.weight = weight;
    members[0].trace.share = share;
    return members[0].respond().command;
  }
};

class Enthusiast final : public Behavior {
 public:
  Response respond(const Perception&) override { return Motion{}; }
  void rate(const Perception&, const Response&, std::span<const Motion>,
            std::span<double> d) const override {
    d[0] = 2.0;
  }
};

class Forgetful final : public Behavior {
 public:
  Response respond(const Perception&) override { return Motion{}; }
  void reset(Random&) override { throw std::runtime_error("cannot forget"); }
};

template <class Plugin>
void add(plugin::Host& host, PluginKind kind, const char* name) {
  host.add(declare<Plugin>(kind, name, "For a test"));
}

}  // namespace

TEST_CASE("A coordinator cannot swallow the fault of a member") {
  ScriptedHost scripted([](const Perception&) -> Response { throw std::runtime_error("ouch"); });
  add<Careless>(scripted.host, PluginKind::coordinator, "careless");
  world::World world = one_robot();
  world.robots[0].coordinator->plugin = "careless";
  Simulation simulation(world, scripted.host);
  CHECK_THROWS_WITH(simulation.step(),
                    Catch::Contains("plugin 'scripted'") && Catch::Contains("ouch"));
}

TEST_CASE("A coordinator whose trace has shares outside [0, 1] or weights below 0 is named") {
  ScriptedHost scripted([](const Perception&) { return Motion{}; });
  add<Boaster>(scripted.host, PluginKind::coordinator, "boaster");
  world::World world = one_robot();
  world.robots[0].coordinator->plugin = "boaster";
  const auto step = [&](double weight, double share, double priority = 1.0) {
    Boaster::weight = weight;
    Boaster::share = share;
    world.robots[0].behaviors[0].priority = priority;
    Simulation(world, scripted.host).step();
  };
  CHECK_NOTHROW(step(1.0, 1.0));
  CHECK_NOTHROW(step(5.0, 1.0 + 1e-12));  // a sum that was rounded
  CHECK_NOTHROW(step(1.0, -1e-12));       // likewise
  CHECK_NOTHROW(step(-2.0, 1.0, -2.0));   // as the user wants it
  CHECK_THROWS_AS(step(1.0, 1.5), PluginFault);
  CHECK_THROWS_WITH(step(1.0, 1.5),
                    Catch::Contains("plugin 'boaster' (id 'arbiter_suppression') of robot 'r1'") &&
                        Catch::Contains("the share of 'scripted' in its trace is "
                                        "1.5; expected a part of the whole"));
  CHECK_THROWS_WITH(step(1.0, -0.25),
                    Catch::Contains("the share of 'scripted' in its trace is -0.25; expected a "
                                    "part of the whole command, from 0 to 1"));
  CHECK_THROWS_WITH(step(-0.5, 1.0),
                    Catch::Contains("the weight of 'scripted' in its trace is -0.5; expected "
                                    "0 or more"));
}

namespace {

struct LightReading {
  static constexpr const char* kind = "light";
  double brightness = 0.0;
  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("brightness", brightness);
  }
};

/// Measures nonsense in step 3.
class LightMeter final : public SensorOf<LightReading> {
 public:
  LightReading sense(const SensorContext& now) override {
    return {now.time_s > 0.025 ? std::sqrt(-2.0) : 1.0};
  }
};

/// The same kind, as an older header had it.
struct OldLightReading {
  static constexpr const char* kind = "light";
  float brightness = 0.0F;
};

world::World with_light_meter(ScriptedHost& scripted) {
  Declaration declaration = declare<LightMeter>(PluginKind::sensor, "light_meter", "Measures light",
                                                produces<LightReading>());
  scripted.host.add(std::move(declaration));
  world::World world = one_robot();
  world::MountedUse sensor;
  sensor.plugin = sensor.id = "light_meter";
  world.robots[0].sensors.push_back(sensor);
  return world;
}

}  // namespace

TEST_CASE("A sensor whose reading is not finite is named, not a behaviour that uses it") {
  ScriptedHost scripted([](const Perception& now) {
    const double light = now.readings<LightReading>()[0]->brightness;
    return wheels(light, light);
  });
  const world::World world = with_light_meter(scripted);
  CHECK_THROWS_WITH(Simulation(world, scripted.host).run(),
                    Catch::StartsWith("plugin 'light_meter' of robot 'r1' failed in step 3 (at "
                                      "0.03 s): the number 'brightness' of its reading is ") &&
                        Catch::EndsWith("nan; expected a finite number"));
}

TEST_CASE("A behaviour that was compiled with another header of a reading is not blind") {
  ScriptedHost scripted([](const Perception& now) {
    return wheels(now.readings<OldLightReading>().empty() ? 1.0 : 2.0, 0.0);
  });
  const world::World world = with_light_meter(scripted);
  CHECK_THROWS_WITH(Simulation(world, scripted.host).run(),
                    Catch::Contains("its readings of the kind 'light' have 4 bytes, not the 8 of "
                                    "the sensor 'light_meter'; build both plugins with"));
}

namespace {
/// Gives reasons in texts of its own, as long as the call.
class Explainer final : public Coordinator {
 public:
  Motion coordinate(std::span<Member> members, const Perception& now) override {
    const std::string why = "activation " + std::to_string(now.time_s()) + " at beta 5";
    members[0].trace.reason = why;
    members[0].trace.share = 1.0;
    return members[0].respond().command;
  }
};
}  // namespace

TEST_CASE("A reason in the trace may be a text of the moment") {
  ScriptedHost scripted([](const Perception&) {
    Response response = wheels(1, 1);
    response.events.push_back({std::string("hello")});
    return response;
  });
  add<Explainer>(scripted.host, PluginKind::coordinator, "explainer");
  world::World world = one_robot();
  world.robots[0].coordinator->plugin = "explainer";
  Simulation simulation(world, scripted.host);
  simulation.reset();
  simulation.step();
  CHECK(simulation.robot(0).members[0].trace.reason == "activation 0.000000 at beta 5");
  simulation.step();
  CHECK(simulation.robot(0).members[0].trace.reason == "activation 0.010000 at beta 5");
}

TEST_CASE("A behaviour that rates out of range, or throws in reset(), is named") {
  ScriptedHost scripted([](const Perception&) { return Motion{}; });
  add<Rater>(scripted.host, PluginKind::coordinator, "rater");
  add<Enthusiast>(scripted.host, PluginKind::behavior, "enthusiast");
  add<Forgetful>(scripted.host, PluginKind::behavior, "forgetful");
  world::World world;
  world.robots.push_back(robot("r1", 0, 0, 0, behavior("enthusiast")));
  world.robots[0].coordinator->plugin = "rater";
  Simulation simulation(world, scripted.host);
  CHECK_THROWS_WITH(simulation.step(),
                    Catch::Contains("plugin 'enthusiast'") && Catch::Contains("rates a command 2"));
  world.robots[0] = robot("r1", 0, 0, 0, behavior("forgetful"));
  CHECK_THROWS_WITH(Simulation(world, scripted.host), Catch::Contains("cannot forget"));
}

TEST_CASE("Every observer hears the end of a run, whoever failed, and the first failure counts") {
  struct Failing : simulation::Observer {
    void ended(const Simulation&) override { throw std::runtime_error("disk full"); }
  } failing;
  struct Listener : simulation::Observer {
    int started_count = 0, steps = 0, ended_count = 0;
    void started(const Simulation&) override { ++started_count; }
    void stepped(const Simulation&) override { ++steps; }
    void ended(const Simulation&) override { ++ended_count; }
  } listener;
  ScriptedHost scripted([](const Perception& now) -> Response {
    if (now.time_s() > 0.045) {
      throw std::runtime_error("enough");
    }
    return Motion{};
  });
  Simulation simulation(one_robot(), scripted.host);
  simulation::Observer* const observers[] = {&failing, &listener};
  CHECK_THROWS_AS(simulation.run(observers), PluginFault);
  CHECK(listener.started_count == 1);
  CHECK(listener.steps == 5);
  CHECK(listener.ended_count == 1);
}

TEST_CASE("Plugins that refuse their parameters are faults of the world file, with their lines") {
  auto use = behavior("avoid_obstacle", 1, models("avoid_obstacle"));
  use.parameters["left_model"] = source_path("tests/plugins/one_input.fcl");
  use.location = {"my.xml", 17};
  world::World world = one_robot(use);
  world.robots.push_back(robot("r2", 1, 0, 0, behavior("braitenberg")));
  try {
    Simulation simulation(world, shipped());
    FAIL("was accepted");
  } catch (const world::WorldError& error) {
    REQUIRE(error.problems().size() == 2);
    CHECK(error.problems()[0].file == "my.xml");
    CHECK(error.problems()[0].line == 17);
    CHECK_THAT(error.problems()[0].message, Catch::Contains("must have the two inputs"));
  }
}
