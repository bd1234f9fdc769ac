// A small model in parts, for tests that change one part.
#pragma once

#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/fuzzy/error.h"
#include "elsie/fuzzy/fcl.h"

namespace heating {

using elsie::fuzzy::Model;

struct Parts {
  std::string name = "heating";
  std::string inputs = "  cold : REAL;\n";
  std::string cold = "  TERM no := (0, 1) (10, 0);\n  TERM yes := (0, 0) (10, 1);\n";
  std::string power = "  TERM low := 0;\n  TERM high := 100;\n";
  std::string options = "  METHOD : COGS;\n  DEFAULT := 0;\n";
  std::string rules =
      "  RULE 1 : IF cold IS yes THEN power IS high;\n"
      "  RULE 2 : IF cold IS no THEN power IS low;\n";
  std::string end = "";
};

/// Line 3 declares inputs; the blocks follow.
inline std::string text(const Parts& parts) {
  return "FUNCTION_BLOCK " + parts.name + "\nVAR_INPUT\n" + parts.inputs +
         "END_VAR\nVAR_OUTPUT\n  power : REAL;\nEND_VAR\nFUZZIFY cold\n" + parts.cold +
         "END_FUZZIFY\nDEFUZZIFY power\n" + parts.power + parts.options +
         "END_DEFUZZIFY\nRULEBLOCK first\n" + parts.rules + "END_RULEBLOCK\nEND_FUNCTION_BLOCK\n" +
         parts.end;
}

inline double power(const Model& model, double cold) {
  elsie::fuzzy::Workspace workspace;
  std::vector<double> inputs(model.inputs().size(), 0.5);
  inputs[*model.input_index("cold")] = cold;
  double result = -1.0;
  model.evaluate(inputs, {&result, 1}, workspace);
  return result;
}

inline std::vector<std::string> notes(const Model& model) {
  std::vector<std::string> notes;
  for (const elsie::fuzzy::Problem& note : model.notes()) {
    CHECK(note.file == "heating.fcl");
    notes.push_back(std::to_string(note.line) + ": " + note.message);
  }
  return notes;
}

using Notes = std::vector<std::string>;

inline Model read(const Parts& parts, const std::string& block = "") {
  return elsie::fuzzy::parse_fcl(text(parts), "heating.fcl", block);
}

/// The error of a model with one mistake.
inline std::string refusal(const Parts& parts, const std::string& block = "") {
  try {
    read(parts, block);
  } catch (const elsie::fuzzy::FclError& error) {
    REQUIRE(error.problems().size() == 1);
    return error.what();
  }
  return "it was read";
}

}  // namespace heating
