// From terms and conclusions to the form that inference works on.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model_data.h"

namespace elsie::fuzzy {

/// A rule's conclusion: the output is the term.
struct Conclusion {
  std::size_t rule = 0;
  std::size_t output = 0;
  std::size_t term = 0;
  bool scales = false;  // ACT: PROD
  std::string hedges;   // on its degree, as in "very" or "very very"
};

/// Fills in slots, cells and the rules' targets; everything else of the model is there.
void compile_outputs(std::vector<Conclusion> conclusions, ModelData& model);

}  // namespace elsie::fuzzy
