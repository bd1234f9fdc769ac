// The inferences of a plugin in the last decision, for display.
#pragma once

#include <string>
#include <vector>

namespace elsie {

/// One evaluation of a model: its inputs and outputs.
struct Inference {
  struct Value {
    std::string name;  // as in the model
    double value = 0.0;
  };

  std::string model;  // the path of its file
  std::string block;  // the block of the file, if it has several; else ""
  std::vector<Value> inputs;
  std::vector<Value> outputs;
};

/// A behaviour or coordinator that evaluates a model from a file may also derive from this class:
/// `class Mine final : public elsie::Behavior, public elsie::Infers`.
class Infers {
 public:
  /// Appends the inferences of the last decision; none before the first. For a model that was
  /// evaluated several times, append the most informative evaluation. Called only while a user
  /// watches: the run must not depend on it.
  virtual void list_inferences(std::vector<Inference>& list) const = 0;

 protected:
  ~Infers() = default;
};

}  // namespace elsie
