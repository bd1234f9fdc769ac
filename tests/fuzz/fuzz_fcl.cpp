// Fuzzy models: reading, and inference with what was read.
#include <cmath>
#include <stdexcept>
#include <vector>

#include "elsie/fuzzy/error.h"
#include "elsie/fuzzy/fcl.h"

#include "fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const elsie::fuzzy::Model model =
        elsie::fuzzy::parse_fcl(elsie::fuzz::text_of(data, size), "input");
    elsie::fuzzy::Workspace workspace;
    std::vector<double> outputs(model.outputs().size());
    for (const double value : {-1e9, -0.5, 0.0, 0.25, 1.0, 90.0, 1e9}) {
      const std::vector<double> inputs(model.inputs().size(), value);
      try {
        model.evaluate(inputs, outputs, workspace);
      } catch (const std::invalid_argument&) {  // a formula without a value
      }
    }
  } catch (const elsie::fuzzy::FclError&) {
  }
  return 0;
}
