// Brings terms and conclusions into the form that inference uses.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model_data.h"

namespace elsie::fuzzy {

/// A rule's conclusion: an output is a term.
struct Conclusion {
  std::size_t rule = 0;
  std::size_t output = 0;
  std::size_t term = 0;
  bool scales = false;  // ACT: PROD
  std::string hedges;   // applied to its degree: "very", "very very"...
};

/// Fills in slots, cells and the rules' targets; the rest of the model must be complete.
void compile_outputs(std::vector<Conclusion> conclusions, ModelData& model);

}  // namespace elsie::fuzzy
