#include <cmath>
#include <fstream>
#include <string>
#include <utility>

#include "support.h"
#include "wheels.h"
#include "world_builder.h"

using namespace elsie;
using Catch::Contains;
using namespace elsie::test;

namespace {

const std::string kContexts = test::source_path("tests/plugins/coordinators/contexts.fcl");

plugin::Object<Coordinator> blending(const std::string& model, test::Parameters parameters = {}) {
  parameters["model"] = model;
  return test::make<Coordinator>(PluginKind::coordinator, "fusion_context_blending", parameters);
}

/// A team whose robot looks ahead.
struct Scene {
  explicit Scene(test::Parameters parameters = {}) : coordinator(blending(kContexts, parameters)) {
    team.member("avoid", 1, wheels(-10, 10)).member("go", 1, wheels(20, 20));
  }
  Motion decide(double front_m) {
    Situation now;
    now.beam(0, front_m);
    coordinator->equipped(team.members(), now.perception());
    Random random;
    coordinator->reset(random);
    team.next_step();
    return coordinator->coordinate(team.members(), now.perception());
  }
  Team team;
  plugin::Object<Coordinator> coordinator;
};

/// A model with one input and one output, in its own file.
class ModelFile {
 public:
  ModelFile(const std::string& input, const std::string& output,
            const std::string& output_terms = "TERM no := 0; TERM yes := 1;")
      : ModelFile(input, output, output_terms, "TERM all := (0, 1) (1, 1);",
                  "RULE 1 : IF " + input + " IS all THEN " + output + " IS yes;") {}
  ModelFile(const std::string& input, const std::string& output, const std::string& output_terms,
            const std::string& input_terms, const std::string& rules,
            const std::string& otherwise = "0") {
    std::ofstream(file_.path) << "FUNCTION_BLOCK f\nVAR_INPUT " << input
                              << " : REAL; END_VAR\nVAR_OUTPUT " << output
                              << " : REAL; END_VAR\nFUZZIFY " << input << "\n"
                              << input_terms << "\nEND_FUZZIFY\nDEFUZZIFY " << output << "\n"
                              << output_terms << "\nMETHOD : COGS; DEFAULT := " << otherwise
                              << ";\nEND_DEFUZZIFY\n"
                              << "RULEBLOCK r\n"
                              << rules << "\nEND_RULEBLOCK\nEND_FUNCTION_BLOCK\n";
  }

 private:
  test::TemporaryFile file_;

 public:
  const std::string path = file_.path.string();
};

std::string refusal(const std::string& model, Situation& now) {
  Team team;
  team.member("avoid", 1, Motion{}).member("go", 1, Motion{});
  try {
    blending(model)->equipped(team.members(), now.perception());
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

/// The value of an input, read from a weight that grows linearly with it: 0 at -1000, 1 at 5000.
Approx word_value(Situation& now, const std::string& word) {
  const ModelFile file(word, "go", "TERM no := 0; TERM yes := 1;",
                       "TERM low := (-1000, 1) (5000, 0); TERM high := (-1000, 0) (5000, 1);",
                       "RULE 1 : IF " + word + " IS low THEN go IS no;\nRULE 2 : IF " + word +
                           " IS high THEN go IS yes;");
  Team team;
  team.member("go", 1, Motion{});
  const auto coordinator = blending(file.path);
  coordinator->equipped(team.members(), now.perception());
  coordinator->coordinate(team.members(), now.perception());
  return Approx(-1000.0 + 6000.0 * team.trace(0).weight).margin(1e-6);
}

}  // namespace

TEST_CASE("A behaviour counts as far as its context holds") {
  Scene scene;
  check_near(scene.decide(0.2), wheels(-10, 10));
  CHECK(scene.team.trace(0).weight == 1.0);
  CHECK(scene.team.trace(0).share == 1.0);
  CHECK(scene.team.asked(1) == 0);  // a behaviour that does not apply does not run
  CHECK(scene.team.reason(1) == "not in this context");
  check_near(scene.decide(1.0), wheels(20, 20));
  CHECK(scene.team.trace(1).share == 1.0);
}

TEST_CASE("In between, the sets are cut off at the degrees and defuzzified last") {
  Scene scene;
  // near 1/4, far 3/4. Triangles of half width 5 cut at d have an area of 5 (1 - (1 - d)^2).
  const double near = 5 * (1 - 0.75 * 0.75), far = 5 * (1 - 0.25 * 0.25);
  const WheelRates command = rates(scene.decide(0.8));
  CHECK(scene.team.trace(0).weight == Approx(0.25));
  CHECK(scene.team.trace(1).weight == Approx(0.75));
  CHECK(command.left == Approx((near * -10 + far * 20) / (near + far)));
  // The right wheel's sets, around 10 and 20, touch only.
  CHECK(command.right == Approx((near * 10 + far * 20) / (near + far)));
  CHECK(command.left != Approx(0.25 * -10 + 0.75 * 20));  // averaging would give this

  Scene scaling({{"weighting", std::string("scale")}});
  check_near(scaling.decide(0.8), wheels(0.25 * -10 + 0.75 * 20, 0.25 * 10 + 0.75 * 20));
}

TEST_CASE("A behaviour that is not active is left out, however well its context holds") {
  Scene scene;
  scene.team.answer(0).activation = 0.0;
  check_near(scene.decide(0.6), wheels(20, 20));
  CHECK(scene.team.reason(0) == "not active");
  scene.team.answer(0).activation = 0.01;  // otherwise only its context decides its weight
  scene.decide(0.6);
  CHECK(scene.team.trace(0).weight == Approx(0.5));
}

TEST_CASE("The combined sets are passed outwards before defuzzification") {
  Scene scene;
  scene.decide(0.8);
  const CommandSets sets =
      scene.coordinator->command_sets(scene.team.members(), Situation().perception(), {});
  CHECK(sets.left.degree(-10) == Approx(0.25));
  CHECK(sets.left.degree(20) == Approx(0.75));
  CHECK(sets.left.degree(5) == 0.0);
}

TEST_CASE("A behaviour that the model does not name always applies, which a note says") {
  ModelFile file("battery", "go");
  Team team;
  team.member("avoid", 1, Motion{}).member("go", 1, Motion{});
  Situation now;
  const auto coordinator = blending(file.path);
  coordinator->equipped(team.members(), now.perception());
  coordinator->coordinate(team.members(), now.perception());
  CHECK(team.trace(0).weight == 1.0);
  REQUIRE(coordinator->notes().size() == 1);
  CHECK_THAT(coordinator->notes()[0],
             Contains("has no output 'avoid': this behaviour always applies"));
}

TEST_CASE("Degrees beyond 0 and 1 count as these") {
  ModelFile file("battery", "go", "TERM no := 0; TERM yes := 7;");
  Team team;
  team.member("go", 1, wheels(1, 1));
  Situation now;
  const auto coordinator = blending(file.path);
  coordinator->equipped(team.members(), now.perception());
  coordinator->coordinate(team.members(), now.perception());
  CHECK(team.trace(0).weight == 1.0);
}

TEST_CASE("A model that does not fit the robot is refused with everything that is wrong") {
  Situation blind;
  CHECK_THAT(refusal(kContexts, blind),
             Contains("contexts.fcl' does not fit") &&
                 Contains("its input 'front_range' needs a beam-range sensor within 45 degrees"));
  ModelFile typing("frontrange", "avoyd");
  CHECK_THAT(refusal(typing.path, blind),
             Contains("its input 'frontrange' is nothing that a robot perceives; did you mean "
                      "'front_range'?") &&
                 Contains("its output 'avoyd' is the id of no behaviour") &&
                 Contains("did you mean 'avoid'?"));
  ModelFile single("battery", "go", "TERM yes := 1;");
  Team team;
  team.member("go", 1, Motion{});
  const auto coordinator = blending(single.path);
  coordinator->equipped(team.members(), blind.perception());
  REQUIRE(coordinator->notes().size() == 1);
  CHECK_THAT(coordinator->notes()[0], Contains("has one term only"));
}

TEST_CASE("The inputs of contexts have the values that their names say") {
  Situation now;
  now.beam(10, 0.5).beam(-60, 0.3).beam(90, 0.7).beam(180, 0.9).proximity(-30, true);
  now.proximity(50, false).blob(75, 30).at(1, 2, 90);
  now.self.energy = 1000;
  now.self.capacity = 4000;
  now.self.charging = true;
  now.self.coverage_m = 2;
  now.self.moving.forward = 0.25;
  now.self.moving.turn = radians(30);
  now.mate("m", 1, 2.5).mate("boss", 2, 2, true).time(12);
  now.team.charger = Vector2{1, 5};

  CHECK(0.3 == word_value(now, "nearest_range"));
  CHECK(0.5 == word_value(now, "front_range"));
  CHECK(0.5 == word_value(now, "left_range"));
  CHECK(0.3 == word_value(now, "right_range"));
  CHECK(0.7 == word_value(now, "left_side_range"));
  CHECK(0.3 == word_value(now, "right_side_range"));
  CHECK(0.9 == word_value(now, "rear_range"));
  CHECK(1.0 == word_value(now, "proximity"));
  CHECK(1.0 == word_value(now, "front_proximity"));
  CHECK(0.0 == word_value(now, "left_proximity"));
  CHECK(1.0 == word_value(now, "right_proximity"));
  CHECK(1.0 == word_value(now, "resource_seen"));
  // Half-way from the middle to the right edge of a picture of 30 degrees.
  CHECK(-degrees(std::atan(0.5 * std::tan(radians(15)))) == word_value(now, "resource_bearing"));
  CHECK(0.01 == word_value(now, "resource_area"));  // 100 of 100 x 100 pixels
  CHECK(1000.0 == word_value(now, "energy"));
  CHECK(0.25 == word_value(now, "battery"));
  CHECK(1.0 == word_value(now, "charging"));
  CHECK(3.0 == word_value(now, "charger_distance"));
  CHECK(0.0 == word_value(now, "charger_bearing"));
  CHECK(1.0 == word_value(now, "leader_seen"));
  CHECK(1.0 == word_value(now, "leader_distance"));
  CHECK(-90.0 == word_value(now, "leader_bearing"));
  CHECK(2.0 == word_value(now, "mates"));
  CHECK(0.5 == word_value(now, "mate_distance"));
  CHECK(1.0 == word_value(now, "x"));
  CHECK(2.0 == word_value(now, "y"));
  CHECK(90.0 == word_value(now, "heading"));
  CHECK(0.25 == word_value(now, "speed"));
  CHECK(30.0 == word_value(now, "turn_rate"));
  CHECK(12.0 == word_value(now, "time"));
}

TEST_CASE("Without a leader, a mate or a resource in sight the inputs have values, too") {
  Situation now;
  now.camera();
  now.self.coverage_m = 2;
  CHECK(0.0 == word_value(now, "leader_seen"));
  CHECK(2.0 == word_value(now, "leader_distance"));  // the limit of coverage
  CHECK(0.0 == word_value(now, "leader_bearing"));
  CHECK(0.0 == word_value(now, "mates"));
  CHECK(2.0 == word_value(now, "mate_distance"));
  CHECK(0.0 == word_value(now, "resource_seen"));
  CHECK(0.0 == word_value(now, "resource_bearing"));
  CHECK(0.0 == word_value(now, "resource_area"));
}

TEST_CASE("With several cameras all inputs are about the resource most nearly straight ahead") {
  const auto sees = [](double column, double area_px, double fov_deg) {
    VisionReading view;
    view.found = true;
    view.column = column;
    view.area_px = area_px;
    view.horizontal_fov_rad = radians(fov_deg);
    return view;
  };
  Situation now;
  // 40 degrees to the left and large; 9 to the right, at the edge of a narrow picture; 17 to the
  // right, nearer to the middle of a wide one.
  now.camera().view(sees(50, 2000, 30), 40).view(sees(95, 100, 20)).view(sees(65, 300, 90));
  const double bearing = -degrees(std::atan(0.9 * std::tan(radians(10))));
  CHECK(1.0 == word_value(now, "resource_seen"));
  CHECK(bearing == word_value(now, "resource_bearing"));
  CHECK(0.01 == word_value(now, "resource_area"));
  // find_resource chooses the same one.
  const auto finder = test::make<Behavior>(PluginKind::behavior, "find_resource");
  check_near(finder->respond(now.perception()).command, wheels(45.0 / 20, -45.0 / 20));
  // Of two at equal angles the first camera's counts, in both plugins.
  Situation even;
  even.view(sees(50, 100, 30), 20).view(sees(50, 400, 30), -20);
  CHECK(20.0 == word_value(even, "resource_bearing"));
  CHECK(0.01 == word_value(even, "resource_area"));
  const WheelRates left = rates(finder->respond(even.perception()).command);
  CHECK(left.right > left.left);
}

namespace {

/// A model without a rule for 'go' between 0.4 and 0.6 m ahead.
ModelFile with_a_gap(const std::string& otherwise) {
  return {"front_range",
          "go",
          "TERM no := 0; TERM yes := 1;",
          "TERM near := (0.3, 1) (0.4, 0); TERM far := (0.6, 0) (0.7, 1);",
          "RULE 1 : IF front_range IS near THEN go IS no;\n"
          "RULE 2 : IF front_range IS far THEN go IS yes;",
          otherwise};
}

/// The weight of 'go' at each of these distances, in consecutive steps.
std::vector<double> weights(const ModelFile& file, const std::vector<double>& distances,
                            std::vector<std::string>* reasons = nullptr) {
  Team team;
  team.member("go", 1, wheels(20, 20));
  const auto coordinator = blending(file.path);
  std::vector<double> all;
  for (const double distance : distances) {
    Situation now;
    now.beam(0, distance);
    if (all.empty()) {
      coordinator->equipped(team.members(), now.perception());
      Random random;
      coordinator->reset(random);
    }
    team.next_step();
    coordinator->coordinate(team.members(), now.perception());
    all.push_back(team.trace(0).weight);
    if (reasons) {
      reasons->push_back(team.reason(0));
    }
  }
  return all;
}

std::vector<std::string> notes_of(const ModelFile& file) {
  Team team;
  team.member("go", 1, Motion{});
  Situation now;
  now.beam(0, 0.5);
  const auto coordinator = blending(file.path);
  coordinator->equipped(team.members(), now.perception());
  return coordinator->notes();
}

}  // namespace

TEST_CASE("A context without a rule keeps its degree with NC; without one, the trace says so") {
  std::vector<std::string> reasons;
  CHECK(weights(with_a_gap("NC"), {0.5, 0.2, 0.5, 1.0, 0.5}, &reasons) ==
        std::vector<double>{0, 0, 0, 1, 1});
  CHECK(reasons[0] == "no context known yet");
  CHECK(reasons[1] == "not in this context");
  CHECK(reasons[2] == "not in this context");
  // A first degree in front of NC.
  CHECK(weights(with_a_gap("1 | NC"), {0.5, 0.2, 0.5, 1.0, 0.5}, &reasons) ==
        std::vector<double>{1, 0, 0, 1, 1});
}

TEST_CASE("A note names a context that may start without a degree, and where") {
  const auto notes = notes_of(with_a_gap("NC"));
  REQUIRE(notes.size() == 1);
  CHECK_THAT(notes[0], Contains("the output 'go' of the fuzzy model") &&
                           Contains("has DEFAULT := NC and no first value") &&
                           Contains("no rule decides it at front_range = 0.4") &&
                           Contains("write, for example, DEFAULT := 0 | NC"));
  CHECK(notes_of(with_a_gap("0 | NC")).empty());
  CHECK(notes_of(with_a_gap("0")).empty());
  // Where some rule always fires no value is kept.
  const ModelFile complete("front_range", "go", "TERM no := 0; TERM yes := 1;",
                           "TERM near := (0.3, 1) (0.7, 0); TERM far := (0.3, 0) (0.7, 1);",
                           "RULE 1 : IF front_range IS near THEN go IS no;\n"
                           "RULE 2 : IF front_range IS far THEN go IS yes;",
                           "NC");
  CHECK(notes_of(complete).empty());
}

TEST_CASE("An input needs the sensor that it is about") {
  Situation bare;
  const std::pair<const char*, const char*> needs[] = {
      {"nearest_range", "needs a beam-range sensor"},
      {"left_range", "a beam-range sensor that looks to the left"},
      {"rear_proximity", "a proximity sensor 135 degrees or more"},
      {"resource_bearing", "a vision sensor"},
      {"charger_distance", "a charger of the robot's team in the world"}};
  for (const auto& [word, missing] : needs) {
    const ModelFile file(word, "go");
    CHECK_THAT(refusal(file.path, bare), Contains(missing) && Contains("and there is none"));
  }
}
