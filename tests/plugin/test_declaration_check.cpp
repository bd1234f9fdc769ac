#include <array>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/api/behavior.h"
#include "elsie/api/rule.h"
#include "elsie/api/sensor.h"
#include "elsie/plugin/declaration_check.h"

using namespace elsie;
using Catch::Contains;
using elsie::plugin::check_declaration;
using elsie::plugin::check_declarations;

namespace {

class Plain final : public Behavior {
 public:
  double speed = 1.0;
  std::string mode = "low";
  Response respond(const Perception&) override { return Motion{}; }
};

class Ranger final : public SensorOf<RangeReading> {
 public:
  RangeReading sense(const SensorContext&) override { return {}; }
};

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Declaration behavior() {
  return declare<Plain>(PluginKind::behavior, "plain", "Stands still",
                        parameter("speed", &Plain::speed, {.unit = "m/s", .min = 0, .max = 2}),
                        parameter("mode", &Plain::mode, {.choices = {"low", "high"}}),
                        needs<RangeReading>(), raises("stuck", "it cannot go on"));
}

Declaration sensor() {
  return declare<Ranger>(PluginKind::sensor, "ranger", "Measures", produces<RangeReading>());
}

}  // namespace

TEST_CASE("Sound declarations have no faults") {
  CHECK(check_declaration(behavior()).empty());
  CHECK(check_declaration(sensor()).empty());
  Declaration reacting = behavior();
  reacting.reacts_to = {"collision", "stuck"};
  CHECK(check_declaration(reacting).empty());
  CHECK(check_declarations(std::vector{behavior(), sensor()}).empty());
  Declaration of_any_layout = behavior();
  of_any_layout.needs = {{.kind = "scan"}};
  CHECK(check_declaration(of_any_layout).empty());
}

namespace {

/// A reading with an array, whose length and names are made in one of several ways.
template <class List>
struct ScanReading {
  static constexpr const char* kind = "scan";
  List ranges_m{};
  template <class Visitor>
  void visit(Visitor&& visitor) const {
    static constexpr const char* kNames[] = {"right", "ahead", "left"};
    for (std::size_t i = 0; i < ranges_m.size(); ++i) {
      visitor(kNames[i], ranges_m[i]);
    }
  }
};
struct ThreeByDefault : std::vector<double> {
  ThreeByDefault() : std::vector<double>(3, 0.0) {}
};
struct NumberedReading {
  static constexpr const char* kind = "numbered";
  double ranges_m[2] = {};
  template <class Visitor>
  void visit(Visitor&& visitor) const {
    for (int i = 0; i < 2; ++i) {
      visitor(("range_" + std::to_string(i)).c_str(), ranges_m[i]);
    }
  }
};
struct RepeatedReading {
  static constexpr const char* kind = "repeated";
  double one = 0.0, two = 0.0;
  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("one", one);
    visitor("one", two);
  }
};
struct SpacedReading {
  static constexpr const char* kind = "spaced";
  double left = 0.0;
  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("to the left", left);
  }
};
/// Elsie's kind, as an older header had it.
struct OldRangeReading {
  static constexpr const char* kind = "range";
  double distance_m = 0.0;
  double max_range_m = 0.0;
};
/// The same size, and other places.
struct SwappedRangeReading {
  static constexpr const char* kind = "range";
  double max_range_m = 0.0;
  double distance_m = 0.0;
  bool hit = false;
  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("distance_m", distance_m);
    visitor("hit", hit);
  }
};

/// The faults of a sensor that makes such readings.
template <class Reading>
std::string faults_of_sensor() {
  class Scanner final : public SensorOf<Reading> {
   public:
    Reading sense(const SensorContext&) override { return {}; }
  };
  std::string all;
  for (const std::string& fault : check_declaration(
           declare<Scanner>(PluginKind::sensor, "scanner", "Scans", produces<Reading>()))) {
    all += fault + '\n';
  }
  return all;
}

}  // namespace

TEST_CASE(
    "The fields of a reading have plain names of their own, and are there from the beginning") {
  CHECK(faults_of_sensor<ScanReading<std::array<double, 3>>>().empty());
  CHECK(faults_of_sensor<ScanReading<ThreeByDefault>>().empty());
  CHECK(faults_of_sensor<NumberedReading>().empty());
  CHECK_THAT(faults_of_sensor<ScanReading<std::vector<double>>>(),
             Contains("sensor 'scanner': reading 'scan' lists nothing in visit() when it is new; "
                      "every reading must list the same names"));
  CHECK_THAT(faults_of_sensor<RepeatedReading>(), Contains("lists 'one' twice in visit()"));
  CHECK_THAT(faults_of_sensor<SpacedReading>(), Contains("the name of listed field 'to the left'"));
}

TEST_CASE("A reading with the name of one of Elsie's own has its layout") {
  CHECK(faults_of_sensor<RangeReading>().empty());
  for (const std::string& faults :
       {faults_of_sensor<OldRangeReading>(), faults_of_sensor<SwappedRangeReading>()}) {
    CHECK_THAT(faults, Contains("reading 'range' has another layout than Elsie's reading of that "
                                "name; include elsie/api/reading.h"));
  }
}

TEST_CASE("Each fault of a declaration is found and named") {
  struct Case {
    std::string words;
    std::function<void(Declaration&)> spoil;
  };
  const std::vector<Case> cases{
      {"the name of the plugin 'Plain' must be", [](Declaration& d) { d.name = "Plain"; }},
      {"the name of the plugin '' must be", [](Declaration& d) { d.name = ""; }},
      {"its version is empty", [](Declaration& d) { d.version = ""; }},
      {"it has no description", [](Declaration& d) { d.description = ""; }},
      {"it has no function that makes", [](Declaration& d) { d.create = nullptr; }},
      {"neither a sensor nor", [](Declaration& d) { d.kind = static_cast<PluginKind>(8); }},
      {"a drive only carries out motions, so it raises no events",
       [](Declaration& d) {
         d.kind = PluginKind::drive;
         d.needs.clear();
         d.events = {{"turned", "it has turned"}};
         d.reacts_to.clear();
       }},
      {"a drive is not given readings",
       [](Declaration& d) {
         d.kind = PluginKind::drive;
         d.events.clear();
         d.reacts_to.clear();
         d.needs = {ReadingDeclaration::of<RangeReading>()};
       }},
      {"the name of parameter 'max speed' must be",
       [](Declaration& d) { d.parameters[0].name = "max speed"; }},
      {"parameter 'speed' is declared twice",
       [](Declaration& d) { d.parameters[1].name = "speed"; }},
      {"parameter 'speed' is not bound", [](Declaration& d) { d.parameters[0].set = nullptr; }},
      {"parameter 'speed' is not bound", [](Declaration& d) { d.parameters[0].get = nullptr; }},
      {"parameter 'speed' has an empty range",
       [](Declaration& d) { d.parameters[0].facts.min = 3; }},
      {"parameter 'speed' has an empty range",
       [](Declaration& d) { d.parameters[0].facts.above = 2; }},
      {"parameter 'speed' has an empty range",
       [](Declaration& d) { d.parameters[0].facts.max = kNan; }},
      {"parameter 'speed' has choices",
       [](Declaration& d) { d.parameters[0].facts.choices = {"a"}; }},
      {"parameter 'mode' has a range", [](Declaration& d) { d.parameters[1].facts.max = 1; }},
      {"the default of speed is 3, but must be a number at least 0 and at most 2 m/s",
       [](Declaration& d) { d.parameters[0].default_value = 3.0; }},
      {"the default of speed is nan, but must be a number",
       [](Declaration& d) { d.parameters[0].default_value = kNan; }},
      {"the default of speed is 'fast', but must be a number",
       [](Declaration& d) { d.parameters[0].default_value = std::string("fast"); }},
      {"the default of mode is 'medium', but must be one of 'low', 'high'",
       [](Declaration& d) { d.parameters[1].default_value = std::string("medium"); }},
      {"the name of event 'is stuck' must be",
       [](Declaration& d) { d.events[0].name = "is stuck"; }},
      {"event 'battery_empty' is one that the simulator raises",
       [](Declaration& d) { d.events[0].name = "battery_empty"; }},
      {"it reacts to the event 'changed', which plugins do not perceive",
       [](Declaration& d) { d.reacts_to = {"changed"}; }},
      {"event 'stuck' is declared twice", [](Declaration& d) { d.events.push_back(d.events[0]); }},
      {"the name of reading '' must be", [](Declaration& d) { d.needs[0].kind = ""; }},
      {"reading 'range' has no size", [](Declaration& d) { d.needs[0].size = 0; }},
      {"needed reading 'range' is declared twice",
       [](Declaration& d) { d.needs.push_back(d.needs[0]); }},
      {"only a sensor produces readings", [](Declaration& d) { d.produces = d.needs; }},
  };
  for (const Case& c : cases) {
    INFO(c.words);
    Declaration declaration = behavior();
    c.spoil(declaration);
    const auto faults = check_declaration(declaration);
    REQUIRE(faults.size() == 1);
    CHECK_THAT(faults[0], Contains(c.words));
    CHECK_THAT(faults[0], Contains("'" + declaration.name + "'"));
  }
}

TEST_CASE("A sensor produces one kind of reading and needs none") {
  Declaration none = sensor();
  none.produces.clear();
  CHECK_THAT(check_declaration(none).at(0), Contains("must produce one kind of reading, not 0"));
  Declaration two = sensor();
  two.produces.push_back({"light", 8});
  CHECK_THAT(check_declaration(two).at(0), Contains("must produce one kind of reading, not 2"));
  Declaration needy = sensor();
  needy.needs.push_back({"light", 8});
  CHECK_THAT(check_declaration(needy).at(0), Contains("cannot need any"));
}

namespace {

struct Step {
  double size = 1.0;
  std::string way = "up";
  FilePath mask;
};

class Stepper final : public Behavior {
 public:
  std::vector<Step> steps{{0.5, "down", {}}};
  Response respond(const Perception&) override { return Motion{}; }
};

Declaration stepper() {
  return declare<Stepper>(
      PluginKind::behavior, "stepper", "Goes by steps",
      elements(
          &Stepper::steps,
          element<Step>("step", "One step", parameter("size", &Step::size, {.min = 0, .max = 2}),
                        parameter("way", &Step::way, {.choices = {"up", "down"}}),
                        parameter("mask", &Step::mask))));
}

}  // namespace

TEST_CASE("Each fault of nested elements is found and named") {
  CHECK(check_declaration(stepper()).empty());
  const auto fault = [](const std::function<void(Declaration&)>& spoil) {
    Declaration declaration = stepper();
    spoil(declaration);
    const auto faults = check_declaration(declaration);
    REQUIRE(faults.size() == 1);
    return faults[0];
  };
  CHECK_THAT(fault([](Declaration& d) { d.elements[0].append = nullptr; }),
             Contains("element 'step' is not bound to a list"));
  CHECK_THAT(fault([](Declaration& d) {
               d.default_elements.clear();
               d.elements[0].parameters[0].facts.min = 3;
             }),
             Contains("parameter 'size' has an empty range"));
  CHECK_THAT(fault([](Declaration& d) {
               d.default_elements.clear();
               d.elements[0].parameters[1].name = "size";
             }),
             Contains("parameter 'size' is declared twice"));
  for (const char* const held : {"behaviors", "coordinator"}) {
    CHECK_THAT(
        fault([&](Declaration& d) {
          d.default_elements.clear();
          d.elements[0].name = held;
        }),
        Contains("'" + std::string(held) + "' has a name that is reserved for nested behaviors"));
  }
  CHECK_THAT(fault([](Declaration& d) { d.default_elements[0].parameters["size"] = 3.0; }),
             Contains("in the default list of elements 'step' size is 3, but must be"));
  CHECK_THAT(
      fault([](Declaration& d) { d.default_elements[0].parameters["way"] = std::string("left"); }),
      Contains("in the default list of elements 'step' way is 'left'"));
  CHECK_THAT(fault([](Declaration& d) {
               d.default_elements[0].parameters["mask"] = std::string("m.png");
             }),
             Contains("the default list of elements 'step' names the file 'm.png'"));
}

TEST_CASE("Only behaviours and coordinators react to events") {
  Declaration declaration = sensor();
  declaration.reacts_to = {"collision"};
  const auto faults = check_declaration(declaration);
  REQUIRE(faults.size() == 1);
  CHECK_THAT(faults[0], Catch::Contains("only behaviors and coordinators perceive events"));
}

TEST_CASE("A field is named by a text that does not change while the world runs") {
  class Sniffer final : public SensorOf<RangeReading> {
   public:
    std::string field = "smoke";
    double least = 1.0;
    RangeReading sense(const SensorContext&) override { return {}; }
  };
  const auto faults = [](bool live, const char* named, PluginKind kind = PluginKind::sensor) {
    Declaration declaration =
        declare<Sniffer>(kind, "sniffer", "Smells", produces<RangeReading>(), names_field(named),
                         parameter("field", &Sniffer::field, {.live = live}),
                         parameter("least", &Sniffer::least, {.live = false}));
    if (kind != PluginKind::sensor) declaration.produces.clear();
    return check_declaration(declaration);
  };
  CHECK(faults(false, "field").empty());
  for (const auto& wrong :
       {faults(true, "field"), faults(false, "least"), faults(false, "smell")}) {
    REQUIRE(wrong.size() == 1);
    CHECK_THAT(wrong[0], Contains("needs a parameter of that name, a text that is not live"));
  }
  const auto measures = faults(false, "field", PluginKind::measure);
  REQUIRE(measures.size() == 1);
  CHECK_THAT(measures[0], Contains("only sensors and actuators use fields"));
}

TEST_CASE("An event is named by a text, also by one of a nested element") {
  struct Whistle {
    std::string name;
    int count = 1;
  };
  class Judge final : public Rule {
   public:
    std::string event;
    std::vector<Whistle> whistles;
    void apply(const Observation&, WorldChanges&) override {}
  };
  const auto faults = [](const char* named) {
    return check_declaration(declare<Judge>(
        PluginKind::rule, "judge", "Judges", names_event(named), parameter("event", &Judge::event),
        elements(&Judge::whistles,
                 element<Whistle>("whistle", "when", parameter("name", &Whistle::name),
                                  parameter("count", &Whistle::count)))));
  };
  CHECK(faults("event").empty());
  CHECK(faults("whistle/name").empty());
  for (const char* wrong : {"name", "whistle", "whistle/count", "flute/name"}) {
    REQUIRE(faults(wrong).size() == 1);
    CHECK_THAT(faults(wrong)[0], Contains("needs a text parameter of that name"));
  }
  Declaration smelling = sensor();
  smelling.event_parameters = {"smell"};
  REQUIRE(check_declaration(smelling).size() == 2);
  CHECK_THAT(check_declaration(smelling)[1], Contains("only behaviors, coordinators and rules"));
}

TEST_CASE("One library must not declare a plugin twice") {
  const auto faults = check_declarations(std::vector{behavior(), sensor(), behavior()});
  REQUIRE(faults.size() == 1);
  CHECK(faults[0] == "behavior 'plain' is declared twice");
}

TEST_CASE("All faults are reported at once") {
  Declaration declaration = behavior();
  declaration.version = "";
  declaration.events[0].name = "Stuck";
  declaration.parameters[0].default_value = -1.0;
  CHECK(check_declaration(declaration).size() == 3);
}

TEST_CASE("Plain names are small letters, digits and underscores") {
  Declaration declaration = behavior();
  for (const char* const name : {"a", "a1", "avoid_obstacle", "x_"}) {
    INFO(name);
    declaration.name = name;
    CHECK(check_declaration(declaration).empty());
  }
  for (const char* const name : {"", "A", "1a", "_a", "a-b", "a b", "a.b", "\xc3\xa4", "aB"}) {
    INFO(name);
    declaration.name = name;
    CHECK(check_declaration(declaration).size() == 1);
  }
}
