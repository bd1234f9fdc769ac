// Models in the style of the standard and of common tools.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <unistd.h>

#include "elsie/fuzzy/error.h"
#include "elsie/fuzzy/fcl.h"
#include "elsie/fuzzy/sets.h"

#include "places.h"

using elsie::FuzzySet;
using namespace elsie::fuzzy;

namespace {

std::string folder() { return elsie::test::source_path("tests/fuzzy/models/"); }

/// A model around one input x with the given FUZZIFY block.
Model with_input(const std::string& block, const std::string& condition = "x IS t") {
  return parse_fcl(
      "FUNCTION_BLOCK one VAR_INPUT x : REAL; END_VAR VAR_OUTPUT y : REAL; END_VAR "
      "FUZZIFY x " +
      block +
      " END_FUZZIFY DEFUZZIFY y TERM on := 1; DEFAULT := 0; END_DEFUZZIFY "
      "RULEBLOCK r RULE 1 : IF " +
      condition + " THEN y IS on; END_RULEBLOCK END_FUNCTION_BLOCK");
}

/// The membership function that a TERM statement makes.
FuzzySet term(const std::string& definition) {
  return with_input("TERM t := " + definition + ";").inputs()[0].terms[0].set;
}

double run(const Model& model, std::vector<double> inputs) {
  Workspace workspace;
  std::vector<double> outputs(model.outputs().size());
  model.evaluate(inputs, outputs, workspace);
  return outputs[0];
}

}  // namespace

TEST_CASE("A file that is read again has its new content") {
  const std::string name = (std::filesystem::temp_directory_path() /
                            ("elsie-fuzzy-" + std::to_string(getpid()) + ".fcl"))
                               .string();
  const auto file_with = [&](int on) {
    std::ofstream(name) << "FUNCTION_BLOCK one VAR_INPUT x : REAL; END_VAR VAR_OUTPUT y : REAL; "
                           "END_VAR FUZZIFY x TERM t := (0, 1) (1, 1); END_FUZZIFY DEFUZZIFY y "
                           "TERM on := "
                        << on
                        << "; DEFAULT := 0; END_DEFUZZIFY RULEBLOCK r RULE 1 : IF x IS t THEN y IS "
                           "on; END_RULEBLOCK END_FUNCTION_BLOCK";
    return name;
  };
  // More files than are cached, and the same ones again.
  for (int round = 0; round < 2; ++round) {
    for (int on = 1; on <= 20; ++on) {
      const Model first = read_fcl(file_with(on));
      const Model second = read_fcl(name);
      CHECK(run(first, {0.5}) == on);
      CHECK(run(second, {0.5}) == on);
    }
  }
  std::filesystem::remove(name);
}

TEST_CASE("A model in the manner of the standard") {
  const Model model = read_fcl(folder() + "standard.fcl");
  CHECK(model.name() == "boiler");
  CHECK(model.inputs().size() == 2);
  CHECK(model.outputs()[0].method == Defuzzification::centroid_of_singletons);
  CHECK(model.rules().size() == 3);
  CHECK(model.rules()[2].text ==
        "IF temp IS hot AND (pressure IS low OR pressure IS NOT high) "
        "THEN valve IS closed WITH 0.75");
  // temp 20: cold 1, other terms 0.
  CHECK(run(model, {20, 50}) == Approx(90.0));
}

TEST_CASE("A model in the manner of jFuzzyLogic") {
  const Model model = read_fcl(folder() + "jfuzzylogic.fcl");
  CHECK(model.name() == "waiter");
  CHECK(model.input_index("Kitchen") == 1u);
  CHECK(model.outputs()[0].default_value == 12.0);
  CHECK(model.outputs()[0].range == Range{0.0, 30.0});
  // Service and food are at their worst: poor 1, bland 1 -> small, a triangle about 5.
  CHECK(run(model, {0.0, 0.0}) == Approx(5.0).margin(0.01));
  CHECK(run(model, {9.0, 9.0}) == Approx(25.0).margin(0.01));
}

TEST_CASE("A model in the manner of fuzzylite, exported from a MATLAB file") {
  const Model model = read_fcl(folder() + "fuzzylite.fcl");
  CHECK(model.rules().size() == 3);
  CHECK(model.outputs()[0].method == Defuzzification::centroid);
  CHECK(model.outputs()[0].keeps_last);
  CHECK(model.outputs()[0].default_value == 0.5);
  CHECK(model.rules()[1].text ==
        "IF distance IS medium OR side IS NOT left THEN steer IS straight "
        "WITH 0.8");
  CHECK(run(model, {0.0, -1.0}) > 0.5);
}

TEST_CASE("Keywords and names in any letter case mean the same") {
  const Model model = parse_fcl(
      "function_block Mixed Var_Input Speed : Real; end_var VAR_OUTPUT out : REAL; END_VAR "
      "fuzzify SPEED term Slow := (0, 1) (1, 0); Term fast := (0, 0) (1, 1); End_Fuzzify "
      "defuzzify Out TERM a := 1; term B := 3; method : cogs; accu : max; end_defuzzify "
      "ruleblock r and : min; rule one : if speed is SLOW then OUT is A; "
      "Rule two : If Speed Is Fast Then out Is b; end_ruleblock End_Function_Block");
  CHECK(run(model, {0.5}) == Approx(2.0));
  CHECK(model.inputs()[0].name == "Speed");
  CHECK(model.inputs()[0].term("SLOW") == &model.inputs()[0].terms[0]);
  CHECK(model.output_index("OUT") == 0u);
  CHECK_FALSE(model.output_index("other"));
}

TEST_CASE("Words of the language may be names where they cannot be mistaken") {
  const Model model = parse_fcl(
      "FUNCTION_BLOCK VAR_INPUT range : REAL; END_VAR VAR_OUTPUT method : REAL; END_VAR "
      "FUZZIFY range RANGE := (0 .. 1); TERM term := Ramp 0 1; END_FUZZIFY "
      "DEFUZZIFY method TERM default := 1; DEFAULT := 0; END_DEFUZZIFY "
      "RULEBLOCK RULE 1 : IF range IS term THEN method IS default; END_RULEBLOCK "
      "END_FUNCTION_BLOCK");
  CHECK(model.rules()[0].text == "IF range IS term THEN method IS default");
}

TEST_CASE("Comments of every kind, nested or not, and letters of other scripts") {
  const Model model = parse_fcl(
      "\xEF\xBB\xBF(* first (* nested *) still *) FUNCTION_BLOCK (* a *) gerät // to the end\r\n"
      "VAR_INPUT größe : REAL; /* C (* */ END_VAR\r\n"
      "VAR_OUTPUT y : REAL; END_VAR (** stars **)\r\n"
      "FUZZIFY größe TERM t := (0, 0) (1, 1); END_FUZZIFY\r\n"
      "DEFUZZIFY y TERM on := 1; DEFAULT := 0; END_DEFUZZIFY\r\n"
      "RULEBLOCK RULE 1 : IF größe IS t THEN y IS on; END_RULEBLOCK END_FUNCTION_BLOCK");
  CHECK(model.name() == "gerät");
  SECTION("A comment that opens twice and closes once, as tools without nesting read it") {
    CHECK_NOTHROW(with_input("(* old: (* TERM a := 1; *) TERM t := (0, 0) (1, 1);"));
  }
}

TEST_CASE("Numbers in every form") {
  CHECK(term("(-1.5, 0) (+2., 1e0)") == FuzzySet{{{-1.5, 0}, {2, 1}}});
  CHECK(term("(.5,0)(1E+1,.25)") == FuzzySet{{{0.5, 0}, {10, 0.25}}});
  CHECK(with_input("RANGE := (0..1); TERM t := (0,0) (1,1);").inputs()[0].range == Range{0, 1});
  CHECK(with_input("RANGE := (-0.500 .. 1.500); TERM t := (0,0) (1,1);").inputs()[0].range ==
        Range{-0.5, 1.5});
}

TEST_CASE("RANGE may stand with the declaration") {
  const Model model = parse_fcl(
      "FUNCTION_BLOCK VAR_INPUT x : REAL RANGE := (0 .. 4); END_VAR "
      "VAR_OUTPUT y : REAL RANGE(0 .. 9); END_VAR FUZZIFY x TERM t := Ramp 0 4; END_FUZZIFY "
      "DEFUZZIFY y RANGE := (0 .. 9); TERM on := 1; DEFAULT := 0; END_DEFUZZIFY "
      "RULEBLOCK RULE 1 : IF x IS t THEN y IS on; END_RULEBLOCK END_FUNCTION_BLOCK");
  CHECK(model.inputs()[0].range == Range{0, 4});
  CHECK(model.inputs()[0].range_given);
  CHECK(model.outputs()[0].range == Range{0, 9});
}

TEST_CASE("Straight shapes are exact, whatever they are called") {
  const FuzzySet triangle{{{0, 0}, {1, 1}, {3, 0}}};
  CHECK(term("Triangle 0 1 3") == triangle);
  CHECK(term("trian 0 1 3") == triangle);
  CHECK(term("triangular 0 1 3") == triangle);
  CHECK(term("TRIMF 0, 1, 3") == triangle);
  CHECK(term("Triangle 0 1 3 0.5") == FuzzySet{{{0, 0}, {1, 0.5}, {3, 0}}});
  CHECK(term("Triangle 0 0 3") == FuzzySet{{{0, 0}, {0, 1}, {3, 0}}});
  CHECK(term("Triangle -inf 0 3") == FuzzySet{{{0, 1}, {3, 0}}});
  const FuzzySet trapezoid{{{0, 0}, {1, 1}, {3, 1}, {4, 0}}};
  CHECK(term("Trapezoid 0 1 3 4") == trapezoid);
  CHECK(term("trape 0 1 3 4") == trapezoid);
  CHECK(term("trapezoidal 0 1 3 4") == trapezoid);
  CHECK(term("trapmf 0 1 3 4") == trapezoid);
  CHECK(term("Trapezoid 0 1 inf inf") == FuzzySet{{{0, 0}, {1, 1}}});
  CHECK(term("Rectangle 1 2") == FuzzySet{{{1, 0}, {1, 1}, {2, 1}, {2, 0}}});
  CHECK(term("Ramp 1 2") == FuzzySet{{{1, 0}, {2, 1}}});
  CHECK(term("Ramp 2 1") == FuzzySet{{{1, 1}, {2, 0}}});
  CHECK(term("Discrete 0 0 1 0.5 2 1") == FuzzySet{{{0, 0}, {1, 0.5}, {2, 1}}});
  CHECK(term("Binary 1 inf") == FuzzySet{{{1, 0}, {1, 1}}});
  CHECK(term("Binary 1 -inf") == FuzzySet{{{1, 1}, {1, 0}}});
}

TEST_CASE("A singleton of an input is met at its place only") {
  const Model model = with_input("TERM t := 5;");
  CHECK(run(model, {5.0}) == 1.0);
  CHECK(run(model, {5.0 + 1e-9}) == 0.0);
  CHECK(run(with_input("TERM t := 5;", "x IS NOT t"), {5.0}) == 0.0);
  CHECK(run(with_input("TERM t := 5;", "x IS NOT t"), {4.0}) == 1.0);
}

TEST_CASE("Curved shapes become straight lines within the promised distance") {
  const auto sigmoid = [](double x, double centre, double slope) {
    return 1.0 / (1.0 + std::exp(-slope * (x - centre)));
  };
  const auto gauss = [](double x, double mean, double deviation) {
    return std::exp(-0.5 * std::pow((x - mean) / deviation, 2));
  };
  const auto rising = [](double x, double a, double b) {
    const double t = (x - a) / (b - a);
    return t <= 0 ? 0 : t >= 1 ? 1 : t < 0.5 ? 2 * t * t : 1 - 2 * (1 - t) * (1 - t);
  };
  struct Curve {
    const char* text;
    std::function<double(double)> function;
  };
  const std::vector<Curve> curves = {
      {"Gaussian 4 1.5", [&](double x) { return gauss(x, 4, 1.5); }},
      {"gauss 4 0.05", [&](double x) { return gauss(x, 4, 0.05); }},
      {"gaussmf 1.5 4", [&](double x) { return gauss(x, 4, 1.5); }},
      {"Gaussian 4 1.5 0.5", [&](double x) { return 0.5 * gauss(x, 4, 1.5); }},
      {"gauss2 3 1 5 2",
       [&](double x) { return (x < 3 ? gauss(x, 3, 1) : 1) * (x > 5 ? gauss(x, 5, 2) : 1); }},
      {"gauss2mf 1 3 2 5",
       [&](double x) { return (x < 3 ? gauss(x, 3, 1) : 1) * (x > 5 ? gauss(x, 5, 2) : 1); }},
      {"Bell 4 2 3", [&](double x) { return 1 / (1 + std::pow(std::abs((x - 4) / 2), 6)); }},
      {"gbell 2 3 4", [&](double x) { return 1 / (1 + std::pow(std::abs((x - 4) / 2), 6)); }},
      {"gbellmf 1 0.5 4", [&](double x) { return 1 / (1 + std::abs(x - 4)); }},
      {"Sigmoid 4 3", [&](double x) { return sigmoid(x, 4, 3); }},
      {"sigm -3 4", [&](double x) { return sigmoid(x, 4, -3); }},
      {"SigmoidDifference 2 3 5 7", [&](double x) { return sigmoid(x, 2, 3) - sigmoid(x, 7, 5); }},
      {"dsigm 3 2 5 7", [&](double x) { return sigmoid(x, 2, 3) - sigmoid(x, 7, 5); }},
      {"SigmoidProduct 2 3 -5 7", [&](double x) { return sigmoid(x, 2, 3) * sigmoid(x, 7, -5); }},
      {"psigmf 3 2 -5 7", [&](double x) { return sigmoid(x, 2, 3) * sigmoid(x, 7, -5); }},
      {"SShape 1 6", [&](double x) { return rising(x, 1, 6); }},
      {"zmf 1 6", [&](double x) { return 1 - rising(x, 1, 6); }},
      {"PiShape 1 3 4 9", [&](double x) { return rising(x, 1, 3) * (1 - rising(x, 4, 9)); }},
      {"Cosine 4 6",
       [&](double x) {
         return std::abs(x - 4) > 3 ? 0 : 0.5 * (1 + std::cos(2 * std::acos(-1.0) / 6 * (x - 4)));
       }},
      {"Spike 4 6", [&](double x) { return std::exp(-std::abs(10.0 / 6 * (x - 4))); }},
      {"Concave 4 7", [&](double x) { return x < 7 ? 3 / (10 - x) : 1; }},
      {"Concave 7 4", [&](double x) { return x > 4 ? 3 / (x - 1) : 1; }},
  };
  for (const Curve& curve : curves) {
    INFO(curve.text);
    const std::string text = std::string("TERM t := ") + curve.text + ";";
    const FuzzySet ranged = with_input("RANGE := (0 .. 10); " + text).inputs()[0].terms[0].set;
    const FuzzySet endless = with_input(text).inputs()[0].terms[0].set;
    double worst = 0.0;
    for (int i = 0; i <= 20000; ++i) {
      const double x = 10.0 * i / 20000;
      worst = std::max(worst, std::abs(ranged.degree(x) - curve.function(x)));
      worst = std::max(worst, std::abs(endless.degree(x) - curve.function(x)));
    }
    for (const double x : {-1e3, 1e3}) {
      worst = std::max(worst, std::abs(endless.degree(x) - curve.function(x)) - 1e-3);
    }
    CHECK(worst <= kCurveTolerance);
    CHECK(ranged.points.size() < 500);
  }
}

TEST_CASE("An output without RANGE spans its terms") {
  const Model model = parse_fcl(
      "FUNCTION_BLOCK VAR_INPUT x : REAL; END_VAR VAR_OUTPUT y : REAL; END_VAR "
      "FUZZIFY x TERM t := Ramp 0 1; END_FUZZIFY "
      "DEFUZZIFY y TERM a := (2, 0) (4, 1); TERM b := (1, 0) (3, 1) (3.5, 0); DEFAULT := 0; "
      "END_DEFUZZIFY RULEBLOCK RULE 1 : IF x IS t THEN y IS a; END_RULEBLOCK END_FUNCTION_BLOCK");
  CHECK(model.outputs()[0].range == Range{1, 4});
  CHECK_FALSE(model.outputs()[0].range_given);
}

// --- gaps ---

namespace {

/// Whether a model without DEFAULT loads; it has two inputs over 0 to 1.
bool covered(const std::string& x_terms, const std::string& y_terms, const std::string& rules,
             const std::string& range = "RANGE := (0 .. 1); ") {
  try {
    parse_fcl(
        "FUNCTION_BLOCK VAR_INPUT x, y : REAL; END_VAR VAR_OUTPUT z : REAL; END_VAR "
        "FUZZIFY x " +
        range + x_terms + " END_FUZZIFY FUZZIFY y " + range + y_terms +
        " END_FUZZIFY DEFUZZIFY z TERM on := 1; END_DEFUZZIFY RULEBLOCK " + rules +
        " END_RULEBLOCK END_FUNCTION_BLOCK");
    return true;
  } catch (const FclError& error) {
    REQUIRE(error.problems().size() == 1);
    const std::string& message = error.problems()[0].message;
    REQUIRE(message.find("has no DEFAULT") != std::string::npos);
    return false;
  }
}

const std::string kLowHigh = "TERM low := Ramp 1 0; TERM high := Ramp 0 1;";
const std::string kFour =
    "RULE 1 : IF x IS low AND y IS low THEN z IS on; RULE 2 : IF x IS low AND y IS high THEN z IS "
    "on; RULE 3 : IF x IS high AND y IS low THEN z IS on;";

}  // namespace

TEST_CASE("Without DEFAULT some rule must fire everywhere, or the file is refused") {
  const std::string last = "RULE 4 : IF x IS high AND y IS high THEN z IS on;";
  CHECK(covered(kLowHigh, kLowHigh, kFour + last));
  SECTION("a corner of the inputs left out") {
    CHECK_FALSE(covered(kLowHigh, kLowHigh, kFour));
    CHECK_FALSE(covered(kLowHigh, kLowHigh, kFour + last.substr(0, last.size() - 1) + " WITH 0;"));
  }
  SECTION("a single point between two terms") {
    const std::string touching = "TERM low := (0, 1) (0.5, 0); TERM high := (0.5, 0) (1, 1);";
    CHECK_FALSE(covered(touching, kLowHigh, kFour + last));
    const std::string stepping =
        "TERM low := (0, 1) (0.5, 0); TERM high := (0.5, 0) (0.5, 0.1) (1, 1);";
    CHECK(covered(stepping, kLowHigh, kFour + last));
  }
  SECTION("terms that end within the range, or continue") {
    const std::string triangles = "TERM low := Triangle -1 0 1; TERM high := Triangle 0 1 2;";
    CHECK(covered(triangles, triangles, kFour + last));
    CHECK_FALSE(covered(triangles, triangles, kFour + last, "RANGE := (0 .. 2); "));
    CHECK_FALSE(covered(triangles, triangles, kFour + last, ""));
    CHECK(covered(kLowHigh, kLowHigh, kFour + last, ""));
  }
  SECTION("negations") {
    CHECK(covered(kLowHigh, kLowHigh,
                  kFour + "RULE 4 : IF NOT (x IS low OR y IS low) THEN z IS "
                          "on;"));
    CHECK_FALSE(covered(kLowHigh, kLowHigh,
                        "RULE 1 : IF x IS NOT low THEN z IS on; RULE 2 : IF y IS NOT low THEN z "
                        "IS on;"));
    CHECK(covered(kLowHigh, kLowHigh,
                  "RULE 1 : IF x IS NOT low OR y IS low THEN z IS on;"
                  "RULE 2 : IF x IS NOT high OR y IS high THEN z IS on;"));
  }
}

TEST_CASE("With the bounded difference it depends on the degrees whether a rule fires") {
  const std::string norm = "AND : BDIF; ";
  const std::string last = "RULE 4 : IF x IS high AND y IS high THEN z IS on;";
  // At 0.5, 0.5 every pair adds up to 1, and no rule fires.
  CHECK_FALSE(covered(kLowHigh, kLowHigh, norm + kFour + last));
  const std::string wide = "TERM low := (0, 1) (0.6, 1) (1, 0); TERM high := (0, 0) (0.4, 1);";
  CHECK(covered(wide, wide, norm + kFour + last));
}

TEST_CASE("A gap is shown by an example") {
  CHECK_THROWS_WITH(
      parse_fcl("FUNCTION_BLOCK\nVAR_INPUT\nx : REAL;\nEND_VAR\nVAR_OUTPUT\nz : REAL;\nEND_VAR\n"
                "FUZZIFY x\nTERM low := (0, 1) (1, 0);\nTERM high := (3, 0) (4, 1);\nEND_FUZZIFY\n"
                "DEFUZZIFY z\nTERM on := 1;\nEND_DEFUZZIFY\nRULEBLOCK\n"
                "RULE 1 : IF x IS low OR x IS high THEN z IS on;\nEND_RULEBLOCK\n"
                "END_FUNCTION_BLOCK\n",
                "gap.fcl"),
      "gap.fcl:12: The output 'z' has no DEFAULT, but no rule decides it at x = 1. Add DEFAULT := "
      "value to its DEFUZZIFY block, or a rule for this case.");
}
