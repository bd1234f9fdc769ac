// Files by other tools: untidy ones are read with notes, and extensions are refused.
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fl/Headers.h>

#include "elsie/fuzzy/error.h"
#include "elsie/fuzzy/fcl.h"

#include "heating.h"

using Catch::Contains;
using elsie::fuzzy::FclError;
using elsie::fuzzy::Model;
using elsie::fuzzy::parse_fcl;
using elsie::fuzzy::Workspace;
using namespace heating;

TEST_CASE("A tidy file has no notes") {
  const Model model = read({});
  CHECK(notes(model).empty());
  CHECK(power(model, 2.5) == Approx(25.0));
}

TEST_CASE("Untidy statements are noted with their lines, and change nothing") {
  Parts parts;
  SECTION("an input that no rule asks for, with and without a block") {
    parts.inputs += "  wind : REAL;\n";
    CHECK(notes(read(parts)) == Notes{"4: The variable 'wind' has no FUZZIFY block, and no rule "
                                      "asks for it. Remove the variable."});
    parts.cold += "END_FUZZIFY\nFUZZIFY wind\n  TERM strong := (0, 0) (9, 1);\n";
    CHECK(notes(read(parts)) ==
          Notes{"4: No rule asks for the variable 'wind'. Write one, or remove the variable."});
  }
  SECTION("a repeated rule number") {
    parts.rules.replace(parts.rules.find("RULE 2"), 6, "RULE 1");
    CHECK(notes(read(parts)) == Notes{"20: A second rule 1 in this block; the first is in line "
                                      "19. Both count: give it another number."});
  }
  SECTION("a repeated point, and a third one on a step") {
    parts.cold =
        "  TERM no := (0, 1) (10, 0) (10, 0);\n"
        "  TERM yes := (0, 0) (0, 0) (10, 1) (20, 1) (20, 0.5) (20, 0);\n";
    CHECK(notes(read(parts)) ==
          Notes{"9: The term 'no' repeats points of one x. Write each once; a step has two.",
                "10: The term 'yes' repeats points of one x. Write each once; a step has two."});
  }
  SECTION("terms of one point, which are singletons") {
    parts.power = "  TERM low := (0, 1);\n  TERM high := (100, 1) (100, 1);\n";
    const Model model = read(parts);
    CHECK(power(model, 2.5) == Approx(25.0));
    CHECK(notes(model) ==
          Notes{"13: The term 'low' has one point only and is read as the singleton := 0.",
                "14: The term 'high' has one point only and is read as the singleton := 100."});
    return;
  }
  SECTION("triangles and trapezoids whose corners are at one place, which are singletons, too") {
    parts.power = "  TERM low := TRIAN 0 0 0;\n  TERM high := trape 100 100 100 100;\n";
    const Model model = read(parts);
    CHECK(power(model, 2.5) == Approx(25.0));
    CHECK_THAT(notes(model).at(0),
               Contains("The term 'low' has one point only and is read as the singleton := 0."));
    return;
  }
  SECTION("an output that always has its default") {
    parts.power += "END_DEFUZZIFY\nDEFUZZIFY lamp\n  TERM on := 1;\n";
    parts.inputs += "END_VAR\nVAR_OUTPUT\n  lamp : REAL;\n";
    const std::string lamp = text(parts);
    const Model model = parse_fcl(lamp, "heating.fcl");
    CHECK_THAT(notes(model).at(0), Contains("No rule decides the variable 'lamp': it always has "
                                            "its DEFAULT"));
    return;
  }
  SECTION("a rule block without rules") {
    parts.rules += "END_RULEBLOCK\nRULEBLOCK second\n  AND : MIN;\n";
    CHECK(notes(read(parts)) ==
          Notes{"22: The rule block has no rules. Write one, or remove the block."});
  }
  SECTION("a name of several words") {
    parts.name = "the heating-of house 5";
    const Model model = read(parts);
    CHECK(model.name() == "the heating-of house 5");
    CHECK(notes(model) == Notes{"1: The name of the function block, 'the heating-of house 5', is "
                                "not one word. Write '_' between its parts."});
  }
  SECTION("statements that end with their line") {
    parts.cold = "  TERM no := (0, 1) (10, 0)\n  TERM yes := (0, 0) (10, 1)\n";
    parts.options = "  METHOD : COGS\n  DEFAULT := 0 // in the end\n";
    const auto missing = [](const std::string& statement, const std::string& after) {
      return "The " + statement + " statement has no ';' at its end, after '" + after +
             "'. Write one.";
    };
    CHECK(notes(read(parts)) == Notes{"9: " + missing("TERM", ")"), "10: " + missing("TERM", ")"),
                                      "15: " + missing("METHOD", "COGS"),
                                      "16: " + missing("DEFAULT", "0")});
  }
  SECTION("the centre of gravity of singletons") {
    parts.options = "  METHOD : COG;\n  DEFAULT := 0;\n";
    CHECK(notes(read(parts)) == Notes{"15: The terms of 'power' are singletons, whose centre of "
                                      "gravity is that of COGS. Write METHOD : COGS."});
  }
  SECTION("names with a '-'") {
    parts.inputs += "  wind-speed : REAL;\n";
    parts.cold += "END_FUZZIFY\nFUZZIFY wind-speed\n  TERM rather-low := (0, 1) (9, 1);\n";
    parts.rules.replace(parts.rules.find("cold IS no"), 10,
                        "cold IS no AND wind-speed IS rather-low");
    const auto untidy = [](const std::string& name) {
      return "The name '" + name + "' has a '-', which is no part of names in FCL. Write '_'.";
    };
    const Model model = read(parts);
    CHECK(notes(model) == Notes{"4: " + untidy("wind-speed"), "14: " + untidy("rather-low")});
    CHECK(model.input_index("Wind-Speed") == 1);
  }
  SECTION("an input without terms that no rule asks for") {
    parts.inputs += "  wind : REAL;\n";
    parts.cold += "END_FUZZIFY\nFUZZIFY wind\n  RANGE := (0 .. 9);\n";
    CHECK(notes(read(parts)) ==
          Notes{"4: No rule asks for the variable 'wind'. Write one, or remove the variable."});
  }
  SECTION("the terms of an output in a FUZZIFY block") {
    parts.cold += "END_FUZZIFY\nFUZZIFY power\n" + parts.power;
    parts.power = "";
    CHECK(notes(read(parts)) == Notes{"12: 'power' is an output, whose terms belong into its "
                                      "DEFUZZIFY block. Write them there."});
  }
  SECTION("a name with a '-'") {
    parts.name = "heating-of";
    const Model model = read(parts);
    CHECK(model.name() == "heating-of");
    CHECK(notes(model) == Notes{"1: The name of the function block, 'heating-of', is not one "
                                "word. Write '_' between its parts."});
  }
  SECTION("a name with signs in it") {
    parts.name = "heat of sin(x)/x";
    CHECK(read(parts).name() == "heat of sin(x)/x");
  }
  SECTION("text after the end") {
    parts.end = "see readme.txt = 5\n";
    CHECK(notes(read(parts)) == Notes{"23: Found 'see' after END_FUNCTION_BLOCK. Nothing from here "
                                      "on is read: remove it."});
  }
  CHECK(power(read(parts), 2.5) == Approx(25.0));
}

TEST_CASE("Statements of other tools with one meaning are read without a note") {
  Parts parts;
  SECTION("the range of a variable as a statement of its own") {
    parts.inputs = "  cold : REAL; RANGE := (0 .. 5);\n";
    CHECK(power(read(parts), 8.0) == Approx(50.0));
  }
  SECTION("an input that is called range") {
    parts.inputs += "  range : REAL;\n";
    parts.cold += "END_FUZZIFY\nFUZZIFY range\n  TERM any_range := (0, 1) (9, 1);\n";
    parts.rules.replace(parts.rules.find("cold IS no"), 10, "cold IS no AND range IS any_range");
  }
  SECTION("a conclusion in parentheses") {
    parts.rules.replace(parts.rules.find("power IS high"), 13, "(power IS high)");
  }
  SECTION("that nothing is switched off") {
    parts.cold = "  ENABLED : TRUE;\n" + parts.cold;
    parts.options += "  ENABLED : TRUE;\n";
    parts.rules = "  ENABLED : TRUE;\n" + parts.rules;
  }
  SECTION("a shape with its numbers in parentheses") {
    parts.cold = "  TERM no := Ramp (10, 0);\n  TERM yes := Ramp (0, 10);\n";
  }
  const Model model = read(parts);
  CHECK(notes(model).empty());
  CHECK(power(model, 2.5) == Approx(25.0));
}

TEST_CASE("A RANGE that stands alone holds for all variables of the declaration before it") {
  Parts parts;
  parts.inputs =
      "  wet : REAL;\n  cold, warm : REAL; RANGE := (0 .. 5);\n  dry : REAL RANGE := (1 .. 2);\n";
  const Model model = read(parts);
  CHECK(power(model, 8.0) == Approx(50.0));  // cold is taken as 5
  const auto variable = [&](const char* name) { return model.inputs()[*model.input_index(name)]; };
  for (const char* name : {"cold", "warm"}) {
    CAPTURE(name);
    CHECK(variable(name).range_given);
    CHECK(variable(name).range.low == 0.0);
    CHECK(variable(name).range.high == 5.0);
  }
  CHECK_FALSE(variable("wet").range_given);
  parts.inputs = "  cold, warm : REAL; RANGE := (0 .. 5); RANGE := (0 .. 6);\n";
  CHECK_THAT(refusal(parts), Contains("heating.fcl:3: RANGE is set a second time"));
  // It belongs to the declaration with the error, not to the one before.
  parts.inputs = "  cold : REAL RANGE := (0 .. 5);\n  warm : BOOL; RANGE := (0 .. 6);\n";
  CHECK_THAT(refusal(parts), Contains("heating.fcl:4: ") && Contains("expected the type REAL"));
}

TEST_CASE("A block after too many mistakes is not reported as missing") {
  Parts parts;
  for (int i = 0; i < 150; ++i) {
    parts.rules += "  RULE : nonsense;\n";
  }
  Parts other;
  other.name = "cooling";
  parts.end = text(other);
  for (const char* block : {"cooling", "heating"}) {
    CAPTURE(block);
    try {
      read(parts, block);
      FAIL("it was read");
    } catch (const FclError& error) {
      CHECK(error.problems().size() == 100);
      CHECK_THAT(error.what(), Contains("heating.fcl:21: ") && !Contains("There is no"));
    }
  }
}

TEST_CASE("Of several function blocks one is chosen by its name") {
  Parts parts;
  Parts other;
  other.name = "cooling";
  other.power = "  TERM low := 0;\n  TERM high := -100;\n";
  other.inputs += "  wind : REAL;\n";
  parts.end = text(other);
  CHECK(power(read(parts, "heating"), 2.5) == Approx(25.0));
  CHECK(power(read(parts, "Cooling"), 2.5) == Approx(-25.0));
  // Notes and mistakes are those of the chosen one only.
  CHECK(notes(read(parts, "heating")).empty());
  CHECK(notes(read(parts, "cooling")).size() == 1);
  CHECK_THAT(refusal(parts), Contains("heating.fcl:23: A second FUNCTION_BLOCK begins here") &&
                                 Contains("'heating' or 'cooling'") && Contains("--block NAME"));
  CHECK_THAT(
      refusal(parts, "freezing"),
      Contains("There is no function block 'freezing'. The file has 'heating' or 'cooling'."));
  other.rules = "  RULE 1 : IF cold IS nothing THEN power IS high;\n";
  parts.end = text(other);
  CHECK(power(read(parts, "heating"), 2.5) == Approx(25.0));
  CHECK_THAT(refusal(parts, "cooling"), Contains("has no term 'nothing'"));
  parts.end = text(Parts{});
  CHECK_THAT(
      refusal(parts, "heating"),
      Contains("heating.fcl:23: A second function block 'heating'; the first is in line 1."));
  CHECK_THAT(refusal(Parts{}, "cooling"), Contains("There is no function block 'cooling'."));
  CHECK_THAT(refusal(parts),
             Contains("heating.fcl:23: A second function block 'heating'; the first "
                      "is in line 1. Give each a name of its own"));
  parts.end += text(other);
  CHECK_THAT(refusal(parts),
             Contains("'heating' or 'cooling'") && !Contains("'heating', 'heating'"));
}

TEST_CASE("Without DEFAULT an output may lack a value if its model is only viewed") {
  Parts parts;
  for (const char* otherwise : {"", "  DEFAULT := nan;\n"}) {
    CAPTURE(otherwise);
    parts.options = std::string("  METHOD : COGS;\n") + otherwise;
    parts.rules = "  RULE 1 : IF cold IS yes THEN power IS high;\n";
    CHECK_THAT(refusal(parts), Contains("heating.fcl:12: The output 'power' has no DEFAULT, but no "
                                        "rule decides it at cold = -0.5. Add DEFAULT"));
    const Model model =
        elsie::fuzzy::parse_fcl(text(parts), "heating.fcl", "", elsie::fuzzy::Gaps::noted);
    CHECK_THAT(notes(model).at(0), Contains("12: The output 'power' has no DEFAULT") &&
                                       Contains("it is nan there, so that no robot can use"));
    CHECK(model.outputs()[0].gap == "cold = -0.5");
    CHECK(std::isnan(power(model, -1.0)));
    CHECK(power(model, 1.0) == 100.0);
  }
  CHECK_FALSE(read({}).outputs()[0].gap);
}

TEST_CASE("Without ACCU a note says where tools differ about singletons") {
  Parts parts;
  parts.rules += "  RULE 3 : IF cold IS NOT no THEN power IS high;\n";
  CHECK(notes(read(parts)) ==
        Notes{"12: Several rules conclude 'power IS high', and there is no ACCU. The strongest "
              "counts, where fuzzylite adds them up. Write ACCU : MAX or ACCU : NSUM."});
  CHECK(power(read(parts), 2.5) == Approx(25.0));
  parts.options += "  ACCU : NSUM;\n";
  CHECK(notes(read(parts)).empty());
  CHECK(power(read(parts), 2.5) == Approx(100.0 * 0.5 / 1.25));
}

TEST_CASE("Extensions of other tools are named as such") {
  Parts parts;
  SECTION("a hedge that stands alone") {
    parts.rules.replace(parts.rules.find("cold IS yes"), 11, "cold IS any");
    CHECK_THAT(refusal(parts), Contains("heating.fcl:19: The input 'cold' has no term 'any'") &&
                                   Contains("The hedge 'any' is a fuzzylite extension"));
  }
  SECTION("a shape that moves") {
    parts.cold = "  TERM no := gauss wind 2;\n  TERM yes := (0, 0) (10, 1);\n";
    CHECK_THAT(refusal(parts), Contains("heating.fcl:9: Found 'wind' among the numbers of gauss") &&
                                   Contains("a jFuzzyLogic extension"));
  }
  SECTION("what is switched off") {
    parts.options += "  ENABLED : FALSE;\n";
    CHECK_THAT(refusal(parts), Contains("heating.fcl:17: Found 'FALSE' for ENABLED") &&
                                   Contains("a fuzzylite extension"));
  }
  SECTION("locks") {
    parts.options += "  LOCK : PREVIOUS;\n";
    CHECK_THAT(refusal(parts), Contains("heating.fcl:17: LOCK is a fuzzylite extension"));
  }
  SECTION("points that move") {
    parts.cold = "  TERM no := (0, 1) (wind, 0);\n  TERM yes := (0, 0) (10, 1);\n";
    CHECK_THAT(refusal(parts), Contains("heating.fcl:9: Found 'wind' for the x of a point") &&
                                   Contains("a jFuzzyLogic extension"));
  }
  SECTION("an operator") {
    parts.rules = "  AND : EPROD;\n" + parts.rules;
    CHECK_THAT(refusal(parts), Contains("heating.fcl:19: Found 'EPROD' for AND") &&
                                   Contains("a fuzzylite extension"));
  }
}

TEST_CASE("Hedges in conditions are those of fuzzylite") {
  struct Case {
    const char* words;
    std::function<double(double)> degree;
  };
  const Case cases[] = {
      {"very", [](double d) { return fl::Very().hedge(d); }},
      {"Extremely", [](double d) { return fl::Extremely().hedge(d); }},
      {"somewhat", [](double d) { return fl::Somewhat().hedge(d); }},
      {"seldom", [](double d) { return fl::Seldom().hedge(d); }},
      {"very extremely", [](double d) { return fl::Very().hedge(fl::Extremely().hedge(d)); }},
      {"NOT very", [](double d) { return 1.0 - fl::Very().hedge(d); }},
  };
  for (const Case& one : cases) {
    CAPTURE(one.words);
    Parts parts;
    parts.rules = std::string("  RULE 1 : IF cold IS ") + one.words + " yes THEN power IS high;\n";
    const Model model = read(parts);
    Workspace workspace;
    for (const double cold : {0.0, 0.3, 2.0, 4.9, 5.0, 5.1, 9.0, 10.0}) {
      CAPTURE(cold);
      double degree = -1.0;
      model.rule_degrees({&cold, 1}, {&degree, 1}, workspace);
      CHECK(degree == Approx(one.degree(cold / 10.0)).margin(1e-3));
    }
  }
  Parts parts;
  parts.rules = "  RULE 1 : IF cold IS very yes THEN power IS high;\n";
  CHECK(read(parts).rules()[0].text == "IF cold IS very yes THEN power IS high");
}

TEST_CASE("A function block without any output is refused, but for viewing") {
  const std::string text =
      "FUNCTION_BLOCK nothing\nVAR_INPUT\n  a : REAL;\nEND_VAR\n"
      "FUZZIFY a\n  TERM x := (0, 0) (1, 1);\nEND_FUZZIFY\nEND_FUNCTION_BLOCK\n";
  CHECK_THROWS_WITH(parse_fcl(text), Contains("The function block has no output"));
  const Model shown = parse_fcl(text, "heating.fcl", "", elsie::fuzzy::Gaps::noted);
  CHECK(shown.outputs().empty());
  CHECK(shown.inputs()[0].terms.at(0).set.degree(0.5) == Approx(0.5));
  CHECK_THAT(notes(shown).at(0),
             Contains("The function block has no output, so that no robot can use the model."));
}

TEST_CASE("A point among terms with an area adds nothing to the centre of gravity") {
  Parts parts;
  parts.power = "  TERM low := TRIAN 0 0 0;\n  TERM high := Triangle 40 60 80;\n";
  parts.options = "  METHOD : COG;\n  DEFAULT := 7;\n";
  const Model model = read(parts);
  CHECK(power(model, 2.5) == Approx(60.0));
  CHECK(power(model, 0.0) == 7.0);  // only 'low' is concluded
  CHECK_THAT(notes(model).back(), Contains("The term 'low' of 'power' has no area, so that it has "
                                           "no effect among terms with an area."));
  parts.options = "  METHOD : COG;\n";
  CHECK_THROWS_WITH(read(parts), Contains("no rule decides it at cold = "));
  parts.options = "  METHOD : MM;\n  DEFAULT := 7;\n";
  CHECK_THROWS_WITH(read(parts), Contains("has both singletons and terms with an area"));
  parts.options = "  METHOD : COG;\n  DEFAULT := 7;\n";
  parts.power = "  TERM low := 0;\n  TERM high := Triangle 40 60 80;\n";
  CHECK_THROWS_WITH(read(parts), Contains("has both singletons and terms with an area"));
}

TEST_CASE("COSINE, whose numbers two tools order differently, is written as in one of them") {
  Parts parts;
  parts.cold = "  TERM no := COSINE 5 2;\n  TERM yes := (0, 0) (10, 1);\n";
  CHECK_THROWS_WITH(read(parts), Contains("half the width and the centre in jFuzzyLogic. Write "
                                          "Cosine, the centre and the width."));
}

TEST_CASE("DSIGM of jFuzzyLogic is cut off at 0, where others take the absolute value") {
  const auto degree = [](const std::string& shape) {
    const Model model = parse_fcl(
        "FUNCTION_BLOCK one\nVAR_INPUT\n  x : REAL;\nEND_VAR\nFUZZIFY x\n  TERM t := " + shape +
            " 1 8 5 9;\n  RANGE := (0 .. 20);\nEND_FUZZIFY\nEND_FUNCTION_BLOCK\n",
        "heating.fcl", "", elsie::fuzzy::Gaps::noted);
    return model.inputs()[0].terms.at(0).set.degree(10.0);
  };
  CHECK(degree("DSIGM") == 0.0);
  CHECK(degree("dsigmf") == Approx(0.112).margin(1e-3));
}
