// Networks and samples for the tests.
#pragma once

#include <string>
#include <vector>

#include "elsie/base/random.h"
#include "elsie/neural/network.h"
#include "elsie/neural/training_set.h"

#include "places.h"

namespace elsie::test {

inline neural::Network random_network(std::vector<int> sizes, std::uint64_t seed = 1) {
  neural::Network network(std::move(sizes));
  Random random(seed);
  network.randomize(random);
  return network;
}

/// A network with the inputs and outputs of a set.
inline neural::Network random_network(const neural::TrainingSet& samples, const char* hidden,
                                      std::uint64_t seed) {
  std::vector<int> sizes{static_cast<int>(samples.inputs())};
  for (const int layer : neural::parse_hidden_layers(hidden)) {
    sizes.push_back(layer);
  }
  sizes.push_back(static_cast<int>(samples.outputs()));
  return random_network(std::move(sizes), seed);
}

inline std::vector<double> answers(const neural::Network& network,
                                   const std::vector<double>& inputs) {
  neural::Workspace workspace(network);
  std::vector<double> outputs(network.outputs());
  network.evaluate(inputs, outputs, workspace);
  return outputs;
}

inline std::vector<double> random_numbers(std::size_t count, double low, double high,
                                          Random& random) {
  std::vector<double> numbers(count);
  for (double& number : numbers) {
    number = random.uniform(low, high);
  }
  return numbers;
}

/// Visits every weight and bias as (layer, neuron, row); the bias is the last row.
template <class Visit>
void each_weight(const neural::Network& network, Visit visit) {
  for (std::size_t l = 0; l < network.layers(); ++l) {
    for (std::size_t n = 0; n < network.neurons(l); ++n) {
      for (std::size_t i = 0; i <= network.inputs(l); ++i) {
        visit(l, n, i);
      }
    }
  }
}

inline double get(const neural::Network& network, std::size_t l, std::size_t n, std::size_t i) {
  return i < network.inputs(l) ? network.weight(l, n, i) : network.bias(l, n);
}
inline void set(neural::Network& network, std::size_t l, std::size_t n, std::size_t i,
                double value) {
  i < network.inputs(l) ? network.set_weight(l, n, i, value) : network.set_bias(l, n, value);
}

/// The reference set of two sensors and two behaviours.
inline neural::TrainingSet reference_set() {
  return neural::read_training_set(source_path("training_sets/two_sensors_two_behaviors.txt"),
                                   {2, 2});
}

/// Narrow and wide networks, with even and odd layers, with and without hidden ones.
inline const std::vector<std::vector<int>>& various_sizes() {
  static const std::vector<std::vector<int>> kSizes = {
      {1, 1},       {2, 2},       {2, 1},          {1, 2},         {2, 2, 1},
      {2, 2, 2, 2}, {2, 4, 4, 2}, {3, 2, 2},       {2, 3, 2},      {8, 6, 5},
      {5, 7, 3, 2}, {4, 8, 8, 4}, {9, 10, 11, 12}, {3, 20, 17, 13}};
  return kSizes;
}

}  // namespace elsie::test
