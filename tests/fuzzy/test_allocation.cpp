// An evaluation allocates nothing once its workspace has met the model.
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/base/random.h"
#include "elsie/fuzzy/fcl.h"

#include "allocations.h"

using namespace elsie::fuzzy;

TEST_CASE("Nothing is allocated for hedges and formulas") {
  const Model model = parse_fcl(
      "FUNCTION_BLOCK VAR_INPUT x : REAL; END_VAR VAR_OUTPUT z : REAL; END_VAR FUZZIFY x TERM low "
      ":= Ramp 1 0; TERM high := Ramp 0 1; END_FUZZIFY DEFUZZIFY z TERM a := FUNCTION x * 2 + "
      "SIN(x); TERM b := 4; END_DEFUZZIFY RULEBLOCK RULE 1 : IF x IS low THEN z IS very extremely "
      "a; RULE 2 : IF x IS high THEN z IS b; END_RULEBLOCK END_FUNCTION_BLOCK");
  Workspace workspace;
  double z = 0.0;
  double x = 0.5;
  model.evaluate({&x, 1}, {&z, 1}, workspace);
  const long before = elsie::test::allocations();
  for (x = 0.0; x < 1.0; x += 0.01) {
    model.evaluate({&x, 1}, {&z, 1}, workspace);
  }
  CHECK(elsie::test::allocations() == before);
}

TEST_CASE("Nothing is allocated in an evaluation after the first") {
  const std::string methods[] = {"COG", "COA", "LM", "RM", "MM"};
  for (const char* accumulation : {"MAX", "BSUM", "NSUM", "ASUM"}) {
    for (const std::string& method : methods) {
      const Model model = parse_fcl(
          "FUNCTION_BLOCK VAR_INPUT x, y : REAL; END_VAR VAR_OUTPUT z : REAL; END_VAR "
          "FUZZIFY x RANGE := (0 .. 1); TERM low := Ramp 1 0; TERM high := Gaussian 1 0.4; "
          "END_FUZZIFY FUZZIFY y RANGE := (0 .. 1); TERM low := Ramp 1 0; TERM high := Ramp 0 1; "
          "END_FUZZIFY DEFUZZIFY z RANGE := (0 .. 6); TERM a := Triangle 0 2 4; TERM b := Triangle "
          "2 4 6; TERM c := Trapezoid 1 2 4 6; METHOD : " +
          method + "; ACCU : " + accumulation +
          "; END_DEFUZZIFY RULEBLOCK RULE 1 : IF NOT (x IS high AND y IS low) THEN z IS a;"
          "RULE 2 : IF x IS low OR y IS high THEN z IS b;"
          "RULE 3 : IF (x IS high OR y IS low) AND (x IS low OR y IS high) THEN z IS c WITH 0.7;"
          "RULE 4 : IF x IS high THEN z IS c; END_RULEBLOCK END_FUNCTION_BLOCK");
      Workspace workspace;
      double inputs[] = {0.5, 0.5};
      double z = 0.0;
      model.evaluate(inputs, {&z, 1}, workspace);
      elsie::Random random(1);
      const long before = elsie::test::allocations();
      double sum = 0.0;
      for (int i = 0; i < 200; ++i) {
        inputs[0] = random.uniform();
        inputs[1] = random.uniform();
        model.evaluate(inputs, {&z, 1}, workspace);
        sum += z;
      }
      const long during = elsie::test::allocations() - before;
      INFO(accumulation << " " << method);
      CHECK(during == 0);
      CHECK(sum > 0.0);
    }
  }
}
