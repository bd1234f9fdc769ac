// The memory of an evaluation.
#pragma once

#include <vector>

#include "elsie/fuzzy/model.h"

#include "model_data.h"

namespace elsie::fuzzy {

/// A term's degrees in a stretch of x in which the conclusion's set is one straight line.
struct Edge {
  double y0 = 0.0;
  double y1 = 0.0;
};

/// A conclusion that is not zero in a cell.
struct Active {
  double y0 = 0.0;  // of the term, scaled if it scales
  double y1 = 0.0;
  double cut = 0.0;  // the degree at which it is cut off; without a cut, above both
};

struct Workspace::Memory {
  std::vector<double> inputs;   // within their ranges
  std::vector<double> leaves;   // degree of each leaf
  std::vector<double> stack;    // of conditions
  std::vector<double> degrees;  // of each rule
  std::vector<double> slots;    // of each slot
  std::vector<Active> active;
  std::vector<double> splits;
  std::vector<Edge> edges;
  std::vector<Edge> kept_edges;

  /// Makes room for a model.
  void fit(const ModelData& model);
};

}  // namespace elsie::fuzzy
