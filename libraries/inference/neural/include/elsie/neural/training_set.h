// Samples to learn from.
//
// A training file is plain text with one sample on each line: the inputs, then the wanted outputs,
// separated by tabs or spaces. Every line has the same, known count of numbers; the file holds
// nothing else but empty lines at its end. All mistakes are reported at once, with their lines.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace elsie::neural {

/// The numbers of a line, and their names in messages.
struct Columns {
  std::size_t inputs = 0;
  std::size_t outputs = 0;
  std::string inputs_are{};   // "one for each range sensor: left, right"; may be empty
  std::string outputs_are{};  // likewise

  /// "2 inputs (one for each range sensor: left, right), then 2 outputs".
  std::string text() const;
};

class TrainingSet {
 public:
  TrainingSet(std::size_t inputs, std::size_t outputs) : inputs_(inputs), outputs_(outputs) {}

  /// Appends a sample. Throws std::invalid_argument for a wrong count of numbers, a number that is
  /// not finite, or a target outside of [0, 1], which no logistic neuron can reach.
  void add(std::span<const double> inputs, std::span<const double> targets);

  std::size_t size() const { return numbers_.size() / (inputs_ + outputs_); }
  std::size_t inputs() const { return inputs_; }
  std::size_t outputs() const { return outputs_; }
  std::span<const double> inputs(std::size_t sample) const {
    return std::span(numbers_).subspan(sample * (inputs_ + outputs_), inputs_);
  }
  std::span<const double> targets(std::size_t sample) const {
    return std::span(numbers_).subspan(sample * (inputs_ + outputs_) + inputs_, outputs_);
  }

 private:
  std::size_t inputs_;
  std::size_t outputs_;
  std::vector<double> numbers_;  // sample by sample
};

/// Reads a training file. Throws FileError.
TrainingSet read_training_set(const std::string& path, const Columns& columns);

/// Reads samples from text; `name` is its name in messages. Throws FileError.
TrainingSet parse_training_set(std::string_view text, const Columns& columns,
                               const std::string& name = "training set");

}  // namespace elsie::neural
