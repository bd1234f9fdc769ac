// What a plugin has inferred in the last decision, to look at: a window draws it.
#pragma once

#include <string>
#include <vector>

namespace elsie {

/// A model that was evaluated: the numbers that went in, and those that came out.
struct Inference {
  struct Value {
    std::string name;  // as in the model
    double value = 0.0;
  };

  std::string model;  // path of its file
  std::string block;  // of the file, if it has several; else ""
  std::vector<Value> inputs;
  std::vector<Value> outputs;
};

/// A behaviour or coordinator that infers by a model in a file may derive from this class besides
/// its own: `class Mine final : public elsie::Behavior, public elsie::Infers`.
class Infers {
 public:
  /// Appends what was inferred when it was asked last; nothing before that. Of a model that was
  /// evaluated several times, the evaluation that says most. Called only while somebody looks on:
  /// the run must not depend on it.
  virtual void list_inferences(std::vector<Inference>& list) const = 0;

 protected:
  ~Infers() = default;
};

}  // namespace elsie
