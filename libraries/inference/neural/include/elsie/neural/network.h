// A fully connected feed-forward network: the logistic sigmoid in every layer, a bias for each
// neuron.
//
//   neural::Network network({2, 4, 4, 2});      // 2 inputs, two hidden layers of 4, 2 outputs
//   network.randomize(random);
//   neural::Workspace workspace(network);
//   network.evaluate(inputs, outputs, workspace);
//
// A neuron answers 1 / (1 + exp(-(bias + sum of weight x input))), in (0, 1). Layers of neurons are
// counted from 0, without the inputs.
//
// The same weights and inputs give the same bits on every machine with IEEE 754 arithmetic: the
// exponential is our own (src/logistic.h), and sums are taken in a fixed order.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/base/random.h"

namespace elsie::neural {

/// The greatest numbers of layers of neurons, and of weights and biases together.
inline constexpr std::size_t kMostLayers = 64;
inline constexpr std::size_t kMostWeights = 10'000'000;

/// The method of drawing first weights and of learning.
enum class Method {
  standard,
  /// The method of the thesis with the published experiments, inferred from its figures and text.
  /// First weights result from an integer division: they are -1 or 0, each in about half of the
  /// draws, and 1 in one of 32,768. The momentum of a weight is the momentum times delta x
  /// input of the sample before, and does not accumulate. Training stops at the first sample whose
  /// own error is below the threshold.
  original
};

class Network;

/// Memory for the answers of all neurons, so that evaluation does not allocate. For one network, or
/// others of the same sizes.
class Workspace {
 public:
  explicit Workspace(const Network& network);

 private:
  friend class Network;
  friend class BackPropagation;
  std::vector<double> activations_;
};

class Network {
 public:
  /// `sizes`: the number of inputs, of neurons in each hidden layer, and of outputs. All weights
  /// are zero. Throws std::invalid_argument for fewer than two numbers, a number below 1, or a
  /// network beyond the limits above.
  explicit Network(std::vector<int> sizes);

  /// Draws weights and biases uniformly from [-1, 1): layer by layer, neuron by neuron, first the
  /// weights of its inputs, then its bias. In the original's method: from -1, 0 and 1.
  void randomize(Random& random, Method method = Method::standard);

  std::span<const int> sizes() const { return sizes_; }
  std::size_t inputs() const { return static_cast<std::size_t>(sizes_.front()); }
  std::size_t outputs() const { return static_cast<std::size_t>(sizes_.back()); }
  /// Layers of neurons: hidden ones and the output layer.
  std::size_t layers() const { return layers_.size(); }
  std::size_t neurons(std::size_t layer) const { return layers_[layer].outputs; }
  /// Inputs of each neuron in a layer.
  std::size_t inputs(std::size_t layer) const { return layers_[layer].inputs; }

  double weight(std::size_t layer, std::size_t neuron, std::size_t input) const {
    return weights_[place(layer, neuron, input)];
  }
  double bias(std::size_t layer, std::size_t neuron) const {
    return weights_[place(layer, neuron, inputs(layer))];
  }
  void set_weight(std::size_t layer, std::size_t neuron, std::size_t input, double weight) {
    weights_[place(layer, neuron, input)] = weight;
  }
  void set_bias(std::size_t layer, std::size_t neuron, double bias) {
    weights_[place(layer, neuron, inputs(layer))] = bias;
  }
  /// Whether every weight and bias is a finite number.
  bool is_finite() const;

  /// The answers to `inputs`, which must be finite; the spans must have the sizes of the network.
  void evaluate(std::span<const double> inputs, std::span<double> outputs,
                Workspace& workspace) const;

  /// The same sizes, weights and biases.
  friend bool operator==(const Network& a, const Network& b) {
    return a.sizes_ == b.sizes_ && a.weights_ == b.weights_;
  }

 private:
  friend class Workspace;
  friend class BackPropagation;

  /// The memory of one layer. Its weights are a matrix with a row for each input and one for the
  /// biases; a row has one number for each neuron, padded to an even count by a zero.
  struct Layer {
    std::size_t inputs;
    std::size_t outputs;
    std::size_t stride;     // length of a row; even
    std::size_t weights;    // index of its matrix
    std::size_t inputs_at;  // indices of its inputs and answers among the activations
    std::size_t outputs_at;
  };

  std::size_t place(std::size_t layer, std::size_t neuron, std::size_t row) const {
    return layers_[layer].weights + row * layers_[layer].stride + neuron;
  }
  /// Computes all activations from the first ones, which are the inputs.
  void propagate(double* activations) const;

  std::vector<int> sizes_;
  std::vector<Layer> layers_;
  std::vector<double> weights_;
  std::size_t activations_ = 0;  // their number, padding included
};

/// Hidden layers as a user writes them: "4 4" are two of four neurons, "0" or "" is none. Throws
/// std::invalid_argument with a sentence.
std::vector<int> parse_hidden_layers(std::string_view text);

/// "2-4-4-2".
std::string sizes_text(std::span<const int> sizes);

}  // namespace elsie::neural
