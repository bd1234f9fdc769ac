// Events that behaviours and coordinators react to: somebody must raise them.
#include <catch2/catch.hpp>

#include "elsie/api/rule.h"

#include "fixture.h"

using namespace elsie;
using namespace elsie::test;
using Catch::Contains;

namespace {

class Idle final : public Behavior {
 public:
  Response respond(const Perception&) override { return Motion{}; }
};
class Crier final : public Behavior {
 public:
  std::string at;
  Response respond(const Perception&) override { return Motion{}; }
};
class First final : public Coordinator {
 public:
  Motion coordinate(std::span<Member>, const Perception&) override { return {}; }
};

/// What is wrong with a robot of these behaviours, under a coordinator that reacts to "alarm".
std::string problems_of(const std::string& behaviors, const std::string& coordinator = "first") {
  static const plugin::Host host = [] {
    plugin::Host made = make_host();
    made.add(declare<Idle>(PluginKind::behavior, "bruised", "Reacts to collisions",
                           reacts_to("collision")));
    made.add(declare<Idle>(PluginKind::behavior, "guard", "Raises the alarm",
                           raises("alarm", "something is wrong")));
    made.add(
        declare<Idle>(PluginKind::behavior, "runner", "Reacts to the alarm", reacts_to("alarm")));
    made.add(declare<Crier>(PluginKind::behavior, "crier", "Cries", names_event("at"),
                            parameter("at", &Crier::at)));
    made.add(declare<First>(PluginKind::coordinator, "first", "Takes the first"));
    made.add(declare<First>(PluginKind::coordinator, "chief", "Reacts to the alarm",
                            reacts_to("alarm")));
    return made;
  }();
  const std::string text = "<world format=\"1\"><robots><robot id=\"r1\">\n<behaviors>" +
                           behaviors + "</behaviors>\n<coordinator><" + coordinator +
                           "/></coordinator></robot></robots></world>";
  try {
    world::parse_world(text, "world.xml", host, options());
    return "";
  } catch (const world::WorldError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("An event of the simulator is raised on every robot") {
  CHECK(problems_of("<bruised/>").empty());
}

TEST_CASE("An event of a plugin is raised where a behaviour declares it, at any depth") {
  CHECK(problems_of("<runner/><guard/>").empty());
  CHECK(problems_of("<guard/>", "chief").empty());
  CHECK(problems_of("<runner/><blend><behaviors><guard/></behaviors><coordinator><first/>"
                    "</coordinator></blend>")
            .empty());
}

TEST_CASE("A robot is refused when nobody raises what one of its plugins reacts to") {
  CHECK_THAT(
      problems_of("<runner/>"),
      Contains("world.xml:2: 'runner' reacts to the event 'alarm', which neither the "
               "simulator nor a rule nor a behaviour of the robot 'r1' raises; there are: "));
  CHECK_THAT(problems_of("<bruised/>", "chief"), Contains("world.xml:3: 'chief' reacts to"));
  CHECK_THAT(problems_of("<blend><behaviors><runner/></behaviors><coordinator><first/>"
                         "</coordinator></blend>"),
             Contains("'runner' reacts to the event 'alarm'"));
}

TEST_CASE("An event that a parameter names must be one of the robot") {
  CHECK(problems_of("<crier/>").empty());
  CHECK(problems_of("<crier at=\"collision\"/>").empty());
  CHECK(problems_of("<crier at=\"alarm\"/><guard/>").empty());
  CHECK_THAT(problems_of("<crier at=\"alarm\"/>"),
             Contains("world.xml:2: 'crier' is for the event 'alarm', which neither the simulator "
                      "nor a rule nor a behaviour of the robot 'r1' raises"));
  CHECK_THAT(problems_of("<crier at=\"colision\"/>"), Contains("did you mean 'collision'?"));
}

TEST_CASE("An event that a rule names in a nested element must be one of the world") {
  struct Whistle {
    std::string name;
  };
  class Judge final : public elsie::Rule {
   public:
    std::vector<Whistle> whistles;
    void apply(const Observation&, WorldChanges&) override {}
  };
  plugin::Host judging = make_host();
  judging.add(declare<Judge>(
      PluginKind::rule, "judge", "Judges", names_event("whistle/name"),
      elements(&Judge::whistles, element<Whistle>("whistle", "when it whistles",
                                                  parameter("name", &Whistle::name)))));
  judging.add(declare<Idle>(PluginKind::behavior, "guard", "Raises the alarm",
                            raises("alarm", "something is wrong")));
  judging.add(declare<First>(PluginKind::coordinator, "first", "Takes the first"));
  const auto problems = [&](const std::string& event) -> std::string {
    const std::string text =
        "<world format=\"1\"><robots><robot id=\"r1\"><behaviors><guard/></behaviors>"
        "<coordinator><first/></coordinator></robot></robots>\n<rules><judge>\n<whistle name=\"" +
        event + "\"/></judge></rules></world>";
    try {
      world::parse_world(text, "world.xml", judging, options());
      return "";
    } catch (const world::WorldError& error) {
      return error.what();
    }
  };
  CHECK(problems("collision").empty());
  CHECK(problems("alarm").empty());
  CHECK_THAT(problems("alram"),
             Contains("world.xml:3: 'judge' is for the event 'alram', which neither the simulator "
                      "nor a rule nor a behaviour of this world raises; did you mean 'alarm'?"));
}
