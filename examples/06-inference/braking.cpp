// A fuzzy model without a robot: how hard to brake at a distance and a speed.
//   braking [DISTANCE_M] [SPEED_M_S]
#include <array>
#include <cstdio>
#include <cstdlib>

#include <elsie/base/error.h>
#include <elsie/fuzzy/fcl.h>

namespace fuzzy = elsie::fuzzy;

constexpr const char* kRules = R"(
FUNCTION_BLOCK braking
  VAR_INPUT distance : REAL; speed : REAL; END_VAR
  VAR_OUTPUT brake : REAL; END_VAR
  FUZZIFY distance
    RANGE := (0 .. 10);
    TERM near := (0, 1) (4, 0);
    TERM far := (2, 0) (6, 1);
  END_FUZZIFY
  FUZZIFY speed
    RANGE := (0 .. 5);
    TERM slow := (0, 1) (3, 0);
    TERM fast := (1, 0) (4, 1);
  END_FUZZIFY
  DEFUZZIFY brake
    RANGE := (0 .. 1);
    TERM gently := (0, 1) (0.6, 0);
    TERM hard := (0.4, 0) (1, 1);
    METHOD : COG;
    DEFAULT := 0;
  END_DEFUZZIFY
  RULEBLOCK rules
    RULE 1 : IF distance IS near AND speed IS fast THEN brake IS hard;
    RULE 2 : IF distance IS far OR speed IS slow THEN brake IS gently;
  END_RULEBLOCK
END_FUNCTION_BLOCK
)";

int main(int argc, char** argv) {
  const std::array inputs{argc > 1 ? std::atof(argv[1]) : 2.0, argc > 2 ? std::atof(argv[2]) : 3.0};
  try {
    const fuzzy::Model model = fuzzy::parse_fcl(kRules, "braking");
    std::array<double, 1> outputs{};
    fuzzy::Workspace workspace;
    model.evaluate(inputs, outputs, workspace);
    std::printf("%.1f m, %.1f m/s: brake %.3f\n", inputs[0], inputs[1], outputs[0]);
    return outputs[0] >= 0.0 && outputs[0] <= 1.0 ? 0 : 1;
  } catch (const elsie::base::Error& error) {  // a line for each mistake in the rules
    std::fprintf(stderr, "%s\n", error.what());
    return error.exit_code();
  }
}
