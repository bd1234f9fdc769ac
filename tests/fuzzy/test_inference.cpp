// Results computed by hand.
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/fuzzy/error.h"
#include "elsie/fuzzy/fcl.h"
#include "elsie/fuzzy/sets.h"

using elsie::FuzzySet;
using namespace elsie::fuzzy;

namespace {

/// Two inputs, each with a rising term and the falling term `low`; one output with two triangles.
/// `block` and `rules` are inserted.
Model model(const std::string& block, const std::string& rules,
            const std::string& terms = "TERM a := Triangle 0 2 4; TERM b := Triangle 2 4 6;") {
  return parse_fcl(
      "FUNCTION_BLOCK VAR_INPUT x, y : REAL; END_VAR VAR_OUTPUT z : REAL; END_VAR "
      "FUZZIFY x RANGE := (0 .. 1); TERM high := Ramp 0 1; TERM low := Ramp 1 0; "
      "END_FUZZIFY "
      "FUZZIFY y RANGE := (0 .. 1); TERM high := Ramp 0 1; TERM low := Ramp 1 0; "
      "END_FUZZIFY "
      "DEFUZZIFY z RANGE := (0 .. 6); DEFAULT := 5; " +
      terms + block + " END_DEFUZZIFY RULEBLOCK " + rules + " END_RULEBLOCK END_FUNCTION_BLOCK");
}

double evaluate(const Model& model, double x, double y) {
  Workspace workspace;
  const double inputs[] = {x, y};
  double z = 0.0;
  model.evaluate(inputs, {&z, 1}, workspace);
  return z;
}

FuzzySet set_of(const Model& model, double x, double y) {
  Workspace workspace;
  const double inputs[] = {x, y};
  return model.output_set(0, inputs, workspace);
}

std::vector<double> degrees(const Model& model, double x, double y) {
  Workspace workspace;
  std::vector<double> result(model.rules().size());
  const double inputs[] = {x, y};
  model.rule_degrees(inputs, result, workspace);
  return result;
}

/// The degree of one condition on x and y.
double degree(const std::string& operators, const std::string& condition, double x, double y) {
  return degrees(model("", operators + " RULE 1 : IF " + condition +
                               " THEN z IS a; RULE 2 : IF x IS low AND y IS low THEN z IS b;"),
                 x, y)[0];
}

const char* const kBoth = "RULE 1 : IF x IS high THEN z IS a; RULE 2 : IF y IS high THEN z IS b;";

}  // namespace

TEST_CASE("The norms of AND and OR") {
  const std::string both = "x IS high AND y IS high";
  const std::string either = "x IS high OR y IS high";
  CHECK(degree("AND : MIN;", both, 0.7, 0.6) == Approx(0.6));
  CHECK(degree("AND : PROD;", both, 0.7, 0.6) == Approx(0.42));
  CHECK(degree("AND : BDIF;", both, 0.7, 0.6) == Approx(0.3));
  CHECK(degree("AND : BDIF;", both, 0.3, 0.6) == 0.0);
  CHECK(degree("OR : MAX;", either, 0.7, 0.6) == Approx(0.7));
  CHECK(degree("OR : ASUM;", either, 0.7, 0.6) == Approx(0.88));
  CHECK(degree("OR : BSUM;", either, 0.3, 0.6) == Approx(0.9));
  CHECK(degree("OR : BSUM;", either, 0.7, 0.6) == 1.0);
}

TEST_CASE("One of AND and OR brings its pair") {
  const std::string both = "x IS high AND y IS high";
  const std::string either = "x IS high OR y IS high";
  CHECK(degree("", both, 0.7, 0.6) == Approx(0.6));
  CHECK(degree("", either, 0.7, 0.6) == Approx(0.7));
  CHECK(degree("OR : ASUM;", both, 0.7, 0.6) == Approx(0.42));
  CHECK(degree("OR : BSUM;", both, 0.7, 0.6) == Approx(0.3));
  CHECK(degree("AND : PROD;", either, 0.7, 0.6) == Approx(0.88));
  CHECK(degree("AND : BDIF;", either, 0.3, 0.6) == Approx(0.9));
  CHECK(degree("AND : PROD; OR : MAX;", either, 0.7, 0.6) == Approx(0.7));
}

TEST_CASE("NOT binds closer than AND, AND closer than OR") {
  CHECK(degree("", "NOT x IS high AND y IS high", 0.8, 0.5) == Approx(0.2));
  CHECK(degree("", "NOT (x IS high AND y IS high)", 0.8, 0.5) == Approx(0.5));
  CHECK(degree("", "x IS NOT high", 0.8, 0.5) == Approx(0.2));
  CHECK(degree("", "NOT x IS NOT high", 0.8, 0.5) == Approx(0.8));
  CHECK(degree("", "NOT NOT (x IS high)", 0.8, 0.5) == Approx(0.8));
  CHECK(degree("", "x IS high OR x IS low AND y IS low", 0.8, 0.1) == Approx(0.8));
  CHECK(degree("", "(x IS high OR x IS low) AND y IS high", 0.8, 0.1) == Approx(0.1));
  CHECK(degree("", "x IS low AND y IS low OR x IS high AND y IS high", 0.8, 0.9) == Approx(0.8));
}

TEST_CASE("NOT of a composed condition is one minus its degree, for every norm") {
  for (const char* operators :
       {"AND : MIN; OR : MAX;", "AND : PROD; OR : MAX;", "AND : BDIF; OR : ASUM;",
        "AND : MIN; OR : BSUM;", "AND : PROD; OR : ASUM;", "AND : BDIF; OR : BSUM;"}) {
    for (const char* condition : {"x IS high AND y IS low", "x IS high OR y IS low",
                                  "x IS high AND (y IS high OR NOT x IS low)"}) {
      for (const double x : {0.0, 0.3, 0.8, 1.0}) {
        CHECK(degree(operators, "NOT (" + std::string(condition) + ")", x, 0.45) ==
              Approx(1.0 - degree(operators, condition, x, 0.45)));
      }
    }
  }
}

TEST_CASE("The weight scales the degree") {
  const Model weighted = model("",
                               "RULE 1 : IF x IS high THEN z IS a WITH 0.5;"
                               "RULE 2 : IF y IS high THEN z IS b WITH 0;");
  CHECK(degrees(weighted, 0.8, 1.0) == std::vector<double>{0.4, 0.0});
  CHECK(weighted.rules()[0].weight == 0.5);
}

TEST_CASE("The sets before defuzzification") {
  SECTION("A cut term") {
    CHECK(set_of(model("", kBoth), 0.5, 0.0) ==
          FuzzySet{{{0, 0}, {1, 0.5}, {3, 0.5}, {4, 0}, {6, 0}}});
  }
  SECTION("A scaled term") {
    CHECK(set_of(model("", std::string("ACT : PROD;") + kBoth), 0.5, 0.0) ==
          FuzzySet{{{0, 0}, {2, 0.5}, {4, 0}, {6, 0}}});
  }
  SECTION("The higher of two cut terms, with their crossing at 3") {
    CHECK(set_of(model("", kBoth), 1.0, 1.0) ==
          FuzzySet{{{0, 0}, {2, 1}, {3, 0.5}, {4, 1}, {6, 0}}});
  }
  SECTION("The bounded sum of two") {
    CHECK(set_of(model("ACCU : BSUM;", kBoth), 1.0, 1.0) ==
          FuzzySet{{{0, 0}, {2, 1}, {4, 1}, {6, 0}}});
  }
  SECTION("The normalised sum has the height 1") {
    const FuzzySet set = set_of(model("ACCU : NSUM;",
                                      "RULE 1 : IF x IS high THEN z IS a;"
                                      "RULE 2 : IF y IS high THEN z IS a;"),
                                1.0, 1.0);
    CHECK(set == FuzzySet{{{0, 0}, {2, 1}, {4, 0}, {6, 0}}});
  }
  SECTION("The algebraic sum of two") {
    const FuzzySet set = set_of(model("ACCU : ASUM;", kBoth), 1.0, 1.0);
    for (double z = 2.0; z <= 4.0; z += 0.05) {
      const double a = (4 - z) / 2;
      const double b = (z - 2) / 2;
      CHECK(set.degree(z) == Approx(a + b - a * b).margin(2.5e-4));
    }
  }
  SECTION("Nothing fires: the empty set") {
    CHECK(set_of(model("", kBoth), 0.0, 0.0) == FuzzySet{});
  }
}

TEST_CASE("Centres of gravity by hand") {
  SECTION("Symmetric terms have it in their middle, at every degree") {
    for (const double x : {1e-300, 1e-12, 0.1, 0.5, 1.0}) {
      CHECK(evaluate(model("", kBoth), x, 0.0) == Approx(2.0));
      CHECK(evaluate(model("", std::string("ACT : PROD;") + kBoth), x, 0.0) == Approx(2.0));
    }
  }
  SECTION("A cut ramp: (0, 0) (3, 0.5) (6, 0.5)") {
    const Model ramp =
        model("", "RULE 1 : IF x IS high AND y IS high THEN z IS a;", "TERM a := Ramp 0 6;");
    // Triangle of area 0.75 at 2 and rectangle of area 1.5 at 4.5.
    CHECK(evaluate(ramp, 0.5, 1.0) == Approx((0.75 * 2 + 1.5 * 4.5) / 2.25));
  }
  SECTION("Two terms at different degrees") {
    // a cut at 1, b at 0.5: areas of (0,0) (2,1) (3,.5) (5,.5) (6,0) in four pieces.
    const double areas[] = {1.0, 0.75, 1.0, 0.25};
    const double places[] = {4.0 / 3, 2.0 + (1.0 + 2 * 0.5) / (3 * 1.5), 4.0, 5.0 + 1.0 / 3};
    double area = 0.0;
    double moment = 0.0;
    for (int i = 0; i < 4; ++i) {
      area += areas[i];
      moment += areas[i] * places[i];
    }
    CHECK(evaluate(model("", kBoth), 1.0, 0.5) == Approx(moment / area).epsilon(1e-12));
  }
  SECTION("The sum of scaled terms weighs their own centres") {
    CHECK(evaluate(model("ACCU : NSUM;", std::string("ACT : PROD;") + kBoth), 0.9, 0.3) ==
          Approx((0.9 * 2 + 0.3 * 4) / 1.2).epsilon(1e-12));
  }
  SECTION("The algebraic sum of two full triangles") {
    // In 2..4 it is 1 - t (1 - t) for t from 0 to 1: area 2 (1 - 1/6). Symmetric about 3.
    CHECK(evaluate(model("ACCU : ASUM;", kBoth), 1.0, 1.0) == Approx(3.0));
    // a + a - a a with a = t rising over 0..2 and falling over 2..4; b = 0.
    const Model twice = model("ACCU : ASUM;",
                              "RULE 1 : IF x IS high THEN z IS a;"
                              "RULE 2 : IF y IS high THEN z IS a;",
                              "TERM a := Ramp 0 6;");
    // 2 t - t^2 over t in 0..1 (z = 6 t): area 2/3, moment 2/3 - 1/4.
    CHECK(evaluate(twice, 1.0, 1.0) == Approx(6 * (2.0 / 3 - 1.0 / 4) / (2.0 / 3)).epsilon(1e-12));
  }
  SECTION("The range cuts terms off") {
    const Model half =
        model("", "RULE 1 : IF x IS high AND y IS high THEN z IS a;", "TERM a := Triangle -6 0 6;");
    CHECK(evaluate(half, 1.0, 1.0) == Approx(2.0));
  }
}

TEST_CASE("The other methods by hand") {
  CHECK(evaluate(model("METHOD : LM;", kBoth), 0.5, 0.25) == Approx(1.0));
  CHECK(evaluate(model("METHOD : RM;", kBoth), 0.5, 0.25) == Approx(3.0));
  CHECK(evaluate(model("METHOD : MM;", kBoth), 0.5, 0.25) == Approx(2.0));
  CHECK(evaluate(model("METHOD : MOM;", kBoth), 0.25, 0.5) == Approx(4.0));
  CHECK(evaluate(model("METHOD : COA;", kBoth), 1.0, 1.0) == Approx(3.0));
  CHECK(evaluate(model("METHOD : COA; ACCU : ASUM;", kBoth), 1.0, 1.0) == Approx(3.0));
  const Model ramp = model("METHOD : COA;", "RULE 1 : IF x IS high AND y IS high THEN z IS a;",
                           "TERM a := Ramp 0 6;");
  CHECK(evaluate(ramp, 1.0, 1.0) == Approx(std::sqrt(18.0)));
}

TEST_CASE("Singletons") {
  const std::string terms = "TERM a := 1; TERM b := 4;";
  CHECK(evaluate(model("METHOD : COGS;", kBoth, terms), 0.25, 0.75) == Approx(3.25));
  SECTION("COGS is the default") {
    CHECK(evaluate(model("", kBoth, terms), 0.25, 0.75) == Approx(3.25));
  }
  SECTION("Two conclusions on one singleton are accumulated") {
    const char* rules =
        "RULE 1 : IF x IS high THEN z IS a; RULE 2 : IF y IS high THEN z IS a;"
        "RULE 3 : IF x IS low THEN z IS b;";
    // Degrees 0.5 and 0.25 on a, 0.5 on b.
    const double a[] = {0.5, 0.625, 0.75, 0.75};
    const char* accumulations[] = {"MAX", "ASUM", "BSUM", "NSUM"};
    for (int i = 0; i < 4; ++i) {
      CHECK(evaluate(model(std::string("ACCU : ") + accumulations[i] + ";", rules, terms), 0.5,
                     0.25) == Approx((a[i] * 1 + 0.5 * 4) / (a[i] + 0.5)));
    }
  }
  SECTION("Maxima") {
    CHECK(evaluate(model("METHOD : LM;", kBoth, terms), 0.5, 0.5) == 1.0);
    CHECK(evaluate(model("METHOD : RM;", kBoth, terms), 0.5, 0.5) == 4.0);
    CHECK(evaluate(model("METHOD : MM;", kBoth, terms), 0.5, 0.5) == 2.5);
    CHECK(evaluate(model("METHOD : RM;", kBoth, terms), 0.5, 0.25) == 1.0);
  }
  SECTION("As a set") {
    CHECK(set_of(model("", kBoth, terms), 0.25, 0.75) ==
          FuzzySet{{{1, 0}, {1, 0.25}, {1, 0}, {4, 0}, {4, 0.75}, {4, 0}}});
  }
}

TEST_CASE("Rule blocks may cut and scale the same output") {
  const Model mixed = model("",
                            "ACT : MIN; RULE 1 : IF x IS high THEN z IS a; END_RULEBLOCK "
                            "RULEBLOCK second ACT : PROD; RULE 1 : IF y IS high THEN z IS b;");
  const FuzzySet cut{{{0, 0}, {1, 0.5}, {3, 0.5}, {4, 0}, {6, 0}}};
  const FuzzySet scaled_down{{{0, 0}, {2, 0}, {4, 0.5}, {6, 0}}};
  CHECK(set_of(mixed, 0.5, 0.5) == union_of(cut, scaled_down));
  CHECK(mixed.rules()[1].block == "second");
}

TEST_CASE("Where no rule fires the default is taken") {
  CHECK(evaluate(model("", kBoth), 0.0, 0.0) == 5.0);
}

TEST_CASE("DEFAULT := NC keeps what the caller passes in") {
  std::string text =
      "FUNCTION_BLOCK VAR_INPUT x : REAL; END_VAR VAR_OUTPUT z : REAL; END_VAR "
      "FUZZIFY x TERM high := Ramp 0 1; END_FUZZIFY "
      "DEFUZZIFY z TERM a := Triangle 0 1 2; DEFAULT := NC; END_DEFUZZIFY "
      "RULEBLOCK RULE 1 : IF x IS high THEN z IS a; END_RULEBLOCK END_FUNCTION_BLOCK";
  Workspace workspace;
  const double inputs[] = {-1.0};
  double z = 7.0;
  parse_fcl(text).evaluate(inputs, {&z, 1}, workspace);
  CHECK(z == 7.0);
  SECTION("or the given value when there is no last one") {
    text.replace(text.find("NC;"), 2, "0.5 | NC");
    const Model model = parse_fcl(text);
    model.evaluate(inputs, {&z, 1}, workspace);
    CHECK(z == 7.0);
    z = std::numeric_limits<double>::quiet_NaN();
    model.evaluate(inputs, {&z, 1}, workspace);
    CHECK(z == 0.5);
  }
}

TEST_CASE("A model reports inputs for which no rule decides an output") {
  // For x the interval from 0.4 to 0.6 is open, for y nothing.
  const auto with = [](const std::string& rule) {
    return parse_fcl(
        "FUNCTION_BLOCK VAR_INPUT x : REAL; y : REAL; END_VAR "
        "VAR_OUTPUT z : REAL; w : REAL; END_VAR "
        "FUZZIFY x TERM low := (0.3, 1) (0.4, 0); TERM high := (0.6, 0) (0.7, 1); END_FUZZIFY "
        "FUZZIFY y TERM low := (0, 1) (1, 0); TERM high := (0, 0) (1, 1); END_FUZZIFY "
        "DEFUZZIFY z TERM a := Triangle 0 1 2; DEFAULT := NC; END_DEFUZZIFY "
        "DEFUZZIFY w TERM a := Triangle 0 1 2; DEFAULT := NC; END_DEFUZZIFY "
        "RULEBLOCK RULE 1 : IF x IS low THEN z IS a; RULE 2 : IF x IS high THEN z IS a; "
        "RULE 3 : IF y IS low OR y IS high THEN w IS a; " +
        rule + " END_RULEBLOCK END_FUNCTION_BLOCK");
  };
  const Model model = with("");
  const auto where = model.undecided_at(0);
  REQUIRE(where);
  REQUIRE(where->substr(0, 4) == "x = ");
  // The example is correct.
  Workspace workspace;
  const double inputs[] = {std::stod(where->substr(4)), 0.3};
  double outputs[] = {7.0, 7.0};
  model.evaluate(inputs, outputs, workspace);
  CHECK(outputs[0] == 7.0);
  CHECK(outputs[1] == Approx(1.0));
  CHECK_FALSE(model.undecided_at(1));
  CHECK(with("RULE 4 : IF y IS low THEN z IS a;").undecided_at(0));  // not where y is 1
  CHECK_FALSE(with("RULE 4 : IF y IS low OR y IS high THEN z IS a;").undecided_at(0));
}

TEST_CASE("An input beyond its RANGE counts as its end; without RANGE terms continue") {
  const Model ranged = model("", kBoth);
  CHECK(evaluate(ranged, 17.0, 0.0) == evaluate(ranged, 1.0, 0.0));
  CHECK(evaluate(ranged, 0.5, -3.0) == evaluate(ranged, 0.5, 0.0));
  const Model free = parse_fcl(
      "FUNCTION_BLOCK VAR_INPUT x : REAL; END_VAR VAR_OUTPUT z : REAL; END_VAR "
      "FUZZIFY x TERM high := (0, 0.25) (1, 1); END_FUZZIFY "
      "DEFUZZIFY z TERM a := Triangle 0 1 2; END_DEFUZZIFY "
      "RULEBLOCK RULE 1 : IF x IS high THEN z IS a; END_RULEBLOCK END_FUNCTION_BLOCK");
  Workspace workspace;
  double fired = 0.0;
  const double far_left[] = {-1e9};
  free.rule_degrees(far_left, {&fired, 1}, workspace);
  CHECK(fired == 0.25);
  CHECK(free.inputs()[0].range == Range{0.0, 1.0});
  CHECK_FALSE(free.inputs()[0].range_given);
}

TEST_CASE("An input that is not finite is an error, and so is a wrong number of inputs") {
  const Model two = model("", kBoth);
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()}) {
    CHECK_THROWS_AS(evaluate(two, 0.5, bad), std::invalid_argument);
  }
  CHECK_THROWS_WITH(evaluate(two, std::numeric_limits<double>::quiet_NaN(), 0),
                    "The input 'x' of the fuzzy model '' is nan; expected a finite number.");
  Workspace workspace;
  double z = 0.0;
  const double one[] = {0.5};
  CHECK_THROWS_WITH(two.evaluate(one, {&z, 1}, workspace),
                    "Found 1 input values, but the fuzzy model '' has 2.");
  const double inputs[] = {0.5, 0.5};
  CHECK_THROWS_WITH(two.evaluate(inputs, {}, workspace),
                    "Found 0 places for outputs, but the fuzzy model '' has 1.");
  CHECK_THROWS_AS(two.output_set(1, inputs, workspace), std::invalid_argument);
}

TEST_CASE("Several outputs, and rules with several conclusions") {
  const Model steering = parse_fcl(
      "FUNCTION_BLOCK VAR_INPUT x : REAL; END_VAR VAR_OUTPUT l, r : REAL; END_VAR "
      "FUZZIFY x RANGE := (-1 .. 1); TERM left := Ramp 1 -1; TERM right := Ramp -1 1; END_FUZZIFY "
      "DEFUZZIFY l RANGE := (0 .. 10); TERM slow := 2; TERM fast := 8; END_DEFUZZIFY "
      "DEFUZZIFY r RANGE := (0 .. 10); TERM slow := 2; TERM fast := 8; END_DEFUZZIFY "
      "RULEBLOCK RULE 1 : IF x IS left THEN l IS slow, r IS fast;"
      "RULE 2 : IF x IS right THEN l IS fast AND r IS slow; END_RULEBLOCK END_FUNCTION_BLOCK");
  Workspace workspace;
  double out[2] = {};
  const double inputs[] = {-0.5};
  steering.evaluate(inputs, out, workspace);
  CHECK(out[0] == Approx(0.75 * 2 + 0.25 * 8));
  CHECK(out[1] == Approx(0.75 * 8 + 0.25 * 2));
}

TEST_CASE("The number is the method applied to the set") {
  for (const char* accumulation : {"MAX", "BSUM", "NSUM", "ASUM"}) {
    for (const auto& [name, method] : {std::pair{"COG", Defuzzification::centroid},
                                       {"COA", Defuzzification::bisector},
                                       {"LM", Defuzzification::leftmost_maximum},
                                       {"RM", Defuzzification::rightmost_maximum},
                                       {"MM", Defuzzification::mean_of_maxima}}) {
      const Model tested =
          model(std::string("ACCU : ") + accumulation + "; METHOD : " + name + ";", kBoth);
      INFO(accumulation << " " << name);
      CHECK(evaluate(tested, 0.6, 0.35) ==
            Approx(defuzzify(set_of(tested, 0.6, 0.35), method).value()).margin(1e-3));
    }
  }
}

TEST_CASE("A workspace serves several models in turn") {
  const Model small = model("", kBoth, "TERM a := 1; TERM b := 4;");
  const Model large = model("", std::string(kBoth) +
                                    "RULE 3 : IF NOT (x IS low OR y IS low) "
                                    "THEN z IS b;");
  Workspace workspace;
  const double inputs[] = {0.4, 0.7};
  double first = 0.0;
  double again = 0.0;
  large.evaluate(inputs, {&first, 1}, workspace);
  small.evaluate(inputs, {&again, 1}, workspace);
  large.evaluate(inputs, {&again, 1}, workspace);
  CHECK(first == again);
}
