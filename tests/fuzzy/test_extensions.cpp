// Extensions of FCL by other tools that Elsie reads: terms that follow the inputs (Takagi and
// Sugeno, 1985), as in fuzzylite (Linear) and jFuzzyLogic (FUNCTION), and hedges in conclusions.
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fl/Headers.h>

#include "elsie/fuzzy/fcl.h"

#include "heating.h"

using Catch::Contains;
using elsie::fuzzy::Workspace;
using namespace heating;

namespace {

/// A model with the inputs cold and wind (0.5 in power()) whose only term is the formula.
Parts with_formula(const std::string& formula) {
  Parts parts;
  parts.inputs += "  wind : REAL;\n";
  parts.power = "  TERM low := FUNCTION " + formula + ";\n";
  parts.rules = "  RULE 1 : IF cold IS yes OR cold IS no THEN power IS low;\n";
  return parts;
}

/// The same text for fuzzylite, which needs "power: REAL" and does not know ACCU : NSUM.
std::unique_ptr<fl::Engine> theirs(const Parts& parts) {
  std::string fcl = text(parts);
  fcl.replace(fcl.find("power : REAL"), 12, "power: REAL");
  if (const std::size_t accu = fcl.find("  ACCU : NSUM;\n"); accu != std::string::npos) {
    fcl.erase(accu, 15);
  }
  return std::unique_ptr<fl::Engine>(fl::FclImporter().fromString(fcl));
}

/// The degree after fuzzylite's hedges, the last word first.
double hedged(const std::vector<std::string>& words, double degree) {
  for (auto word = words.rbegin(); word != words.rend(); ++word) {
    const std::unique_ptr<fl::Hedge> hedge(
        fl::FactoryManager::instance()->hedge()->constructObject(*word));
    degree = hedge->hedge(degree);
  }
  return degree;
}

double value(const std::string& formula, double cold) {
  CAPTURE(formula, cold);
  return power(read(with_formula(formula)), cold);
}

}  // namespace

TEST_CASE("Linear terms follow the inputs, as Takagi and Sugeno's do") {
  Parts parts;
  parts.inputs += "  wind : REAL;\n";
  parts.cold += "END_FUZZIFY\nFUZZIFY wind\n  TERM weak := (0, 1) (1, 0);\n";
  parts.power = "  TERM low := Linear 2 0 1;\n  TERM high := Linear 0 40 10;\n";
  parts.rules =
      "  RULE 1 : IF cold IS yes THEN power IS high;\n"
      "  RULE 2 : IF cold IS no THEN power IS low;\n";
  // At cold = 2.5, wind = 0.5: low is at 6 to the degree 0.75, high at 30 to 0.25.
  CHECK(power(read(parts), 2.5) == Approx(0.75 * 6.0 + 0.25 * 30.0));
  CHECK(power(read(parts), 10.0) == Approx(30.0));
  parts.power = "  TERM low := Linear 2 0 1;\n  TERM high := Linear 0 40;\n";
  CHECK_THAT(refusal(parts),
             Contains("heating.fcl:18: Linear needs a number for each input and one more, 3 in "
                      "all, but the term 'high' of 'power' has 2."));
}

TEST_CASE("Every rule has its weight in the mean of Linear terms, as in fuzzylite") {
  Parts parts;
  parts.inputs = "  cold: REAL;\n";
  parts.cold = "  RANGE := (0.000 .. 10.000);\n" + parts.cold;
  parts.power =
      "  RANGE := (0.000 .. 50.000);\n  TERM low := Linear 2 1;\n  TERM high := Linear 0 40;\n";
  parts.rules =
      "  RULE 1 : if cold is yes then power is high\n"
      "  RULE 2 : if cold is no then power is low\n"
      "  RULE 3 : if cold is not yes then power is low with 0.5\n";
  for (const char* accu : {"", "  ACCU : MAX;\n"}) {
    parts.options = "  METHOD : COGS;\n" + std::string(accu) + "  DEFAULT := 0;\n";
    const Model model = read(parts);
    CHECK(notes(model).size() == std::string(accu).size() / 14);
    const std::unique_ptr<fl::Engine> engine = theirs(parts);
    for (const double cold : {0.5, 2.0, 5.0, 9.5}) {
      engine->setInputValue("cold", cold);
      engine->process();
      CHECK(power(model, cold) == Approx(engine->getOutputValue("power")));
    }
  }
}

TEST_CASE("An input that only a term of an output uses is not noted") {
  Parts parts = with_formula("wind * 4");
  CHECK(notes(read(parts)).empty());
  parts.power = "  TERM low := Linear 0 4 0;\n";
  CHECK(notes(read(parts)).empty());
  CHECK(power(read(parts), 1.0) == Approx(2.0));
  parts.power = "  TERM low := Linear 4 0 0;\n";
  CHECK(notes(read(parts)).size() == 1);
}

TEST_CASE("Formulas have the precedence that all tools agree on") {
  CHECK(value("3", 0.0) == Approx(3.0));
  CHECK(value("cold", 7.0) == Approx(7.0));
  CHECK(value("COLD * 2 + wind", 7.0) == Approx(14.5));
  CHECK(value("1 - 2 - 3", 0.0) == Approx(-4.0));
  CHECK(value("12 / 3 / 2 * 5", 0.0) == Approx(10.0));
  CHECK(value("2 * 3 ^ 2", 0.0) == Approx(18.0));
  CHECK(value("2 ^ -1", 0.0) == Approx(0.5));
  CHECK(value("-cold + 2 * -3", 1.0) == Approx(-7.0));
  CHECK(value("(1 + cold) * (1 - (cold - 2))", 4.0) == Approx(-5.0));
  CHECK(value("cold-wind", 4.0) == Approx(3.5));
  CHECK(value("SIN(cold) + cos(cold / 2) * Tan(1)", 2.0) ==
        Approx(std::sin(2.0) + std::cos(1.0) * std::tan(1.0)));
  CHECK(value("EXP(LN(cold)) + SQRT(ABS(-4)) + fabs(wind)", 3.0) == Approx(5.5));
  CHECK(read(with_formula("cold * 2 +\n 1")).outputs()[0].terms[0].formula == "cold * 2 +  1");
}

TEST_CASE("A formula is a place; the rules' degrees are its weights") {
  Parts parts = with_formula("cold * 2");
  parts.power += "  TERM high := 100;\n";
  parts.options = "  METHOD : COGF;\n  DEFAULT := 0;\n";
  parts.rules =
      "  RULE 1 : IF cold IS yes THEN power IS high;\n"
      "  RULE 2 : IF cold IS no THEN power IS low WITH 0.5;\n";
  CHECK(power(read(parts), 2.0) == Approx((0.2 * 100.0 + 0.4 * 4.0) / 0.6));
}

TEST_CASE("Formulas are those of fuzzylite's Function") {
  const std::string formulas[] = {"x * 0.6 + 1.2 - y / 3", "sin(x) / (x + 1) - cos(y) * tan(0.5)",
                                  "x ^ 2 * 3 - 2 * y ^ (1 + x)",
                                  "exp(x / 4) + sqrt(y) * fabs(x - y)",
                                  "(x - y) * (x + y) / (1 + x * y)"};
  for (const std::string& formula : formulas) {
    CAPTURE(formula);
    const Model model = elsie::fuzzy::parse_fcl(
        "FUNCTION_BLOCK VAR_INPUT x, y : REAL; END_VAR VAR_OUTPUT z : REAL; END_VAR FUZZIFY x TERM "
        "any_x := (0, 1) (9, 1); END_FUZZIFY DEFUZZIFY z TERM there := FUNCTION " +
        formula +
        "; END_DEFUZZIFY RULEBLOCK RULE 1 : IF x IS any_x THEN z IS there; "
        "END_RULEBLOCK END_FUNCTION_BLOCK");
    fl::Engine engine;
    engine.addInputVariable(new fl::InputVariable("x", 0.0, 9.0));
    engine.addInputVariable(new fl::InputVariable("y", 0.0, 9.0));
    const std::unique_ptr<fl::Function> theirs(fl::Function::create("there", formula, &engine));
    Workspace workspace;
    for (const double x : {0.1, 1.0, 2.5, 7.0}) {
      for (const double y : {0.2, 1.0, 3.0}) {
        const double inputs[] = {x, y};
        double z = 0.0;
        model.evaluate(inputs, {&z, 1}, workspace);
        std::map<std::string, fl::scalar> values{{"x", x}, {"y", y}};
        CHECK(z == Approx(theirs->evaluate(&values)));
      }
    }
  }
}

TEST_CASE("Where tools differ, and where they mean nothing, formulas are refused") {
  const auto why = [](const std::string& formula) { return refusal(with_formula(formula)); };
  CHECK_THAT(why("log(cold)"), Contains("heating.fcl:14: Found LOG, which has the base 10"));
  CHECK_THAT(why("cold % 2"), Contains("Found '%', which comes before '*' in jFuzzyLogic"));
  CHECK_THAT(why("-cold ^ 2"), Contains("Found '^' after a sign or another '^'"));
  CHECK_THAT(why("2 ^ 3 ^ 2"), Contains("Found '^' after a sign or another '^'"));
  CHECK_THAT(why("sinus(cold)"), Contains("Found the function 'sinus', expected SIN, COS"));
  CHECK_THAT(why("rain * 2"), Contains("There is no input 'rain'."));
  CHECK_THAT(why("power * 2"), Contains("'power' is an output. A formula works on inputs") &&
                                   Contains("a fuzzylite extension"));
  CHECK_THAT(why("(cold * 2"), Contains("Found ';', expected ')' in the formula."));
  CHECK_THAT(why("cold * "), Contains("Found ';', expected a number, an input or a function"));
  CHECK_THAT(why(""), Contains("Found ';', expected a number, an input or a function"));
  CHECK_THAT(why("cold 2"), Contains("Expected ';' at the end of the TERM statement"));
  CHECK_THAT(why(std::string(100'000, '(') + "1"), Contains("Parentheses are nested more than 32"));
  std::string many = "1";
  for (int i = 0; i < 30; ++i) {
    many = "2 - (1 - (" + many + "))";
  }
  CHECK_THAT(why(many), Contains("more than 32"));
  Parts parts;
  parts.cold = "  TERM no := FUNCTION cold;\n  TERM yes := (0, 0) (10, 1);\n";
  CHECK_THAT(refusal(parts),
             Contains("heating.fcl:9: The term 'no' of the input 'cold' is a formula"));
}

TEST_CASE("A formula without a value is an error, never a number") {
  const Model model = read(with_formula("1 / cold"));
  CHECK(power(model, 4.0) == Approx(0.25));
  CHECK_THROWS_WITH(power(model, 0.0), Contains("The term 'low' of the output 'power'") &&
                                           Contains("'1 / cold', is inf for these inputs"));
  CHECK_THROWS_AS(power(read(with_formula("LN(cold)")), -1.0), std::invalid_argument);
}

TEST_CASE("Hedges in conclusions are those of fuzzylite, for the conclusions after them too") {
  Parts parts;
  parts.options = "  METHOD : COGS;\n  ACCU : NSUM;\n  DEFAULT := 0;\n";
  const auto with = [&](const std::string& conclusions) {
    parts.rules = "  RULE 1 : IF cold IS yes THEN " + conclusions +
                  ";\n  RULE 2 : IF cold IS no THEN power IS low;\n";
    return read(parts);
  };
  for (const double cold : {0.0, 0.5, 3.0, 8.0, 10.0}) {
    const double yes = 0.1 * cold;
    const auto mean = [&](double high, double also_low) {
      return Approx(100.0 * high / (high + also_low + 1.0 - yes));
    };
    for (const char* hedge : {"very", "somewhat", "extremely", "seldom"}) {
      CAPTURE(cold, hedge);
      const Model model = with("power IS " + std::string(hedge) + " high");
      CHECK(notes(model).empty());
      CHECK(power(model, cold) == mean(hedged({hedge}, yes), 0.0));
    }
    const double high = hedged({"very", "extremely"}, yes);
    CHECK(power(with("power IS very extremely high"), cold) == mean(high, 0.0));
    CHECK(power(with("power IS very extremely high, power IS low"), cold) == mean(high, high));
    const Model model = with("power IS very extremely high, power IS seldom low");
    CHECK(power(model, cold) == mean(high, hedged({"seldom"}, high)));
    CHECK(notes(model) == Notes{"20: The hedge before 'high' holds for the conclusions after it "
                                "too, as in fuzzylite. Write a rule for each conclusion if that "
                                "is not meant."});
    CHECK(model.rules()[0].text ==
          "IF cold IS yes THEN power IS very extremely high, power IS seldom low");
  }
}

TEST_CASE("fuzzylite itself computes the same of hedges in conclusions") {
  Parts parts;
  parts.inputs = "  cold: REAL;\n";
  parts.cold = "  RANGE := (0.000 .. 10.000);\n" + parts.cold;
  parts.options = "  METHOD : COGS;\n  ACCU : NSUM;\n  DEFAULT := 0;\n";
  parts.rules =
      "  RULE 1 : if cold is yes then power is extremely high and power is very low\n"
      "  RULE 2 : if cold is no then power is low\n";
  const Model model = read(parts);
  const std::unique_ptr<fl::Engine> engine = theirs(parts);
  for (const double cold : {0.5, 3.0, 5.0, 8.0}) {
    engine->setInputValue("cold", cold);
    engine->process();
    CHECK(power(model, cold) == Approx(engine->getOutputValue("power")));
  }
}
