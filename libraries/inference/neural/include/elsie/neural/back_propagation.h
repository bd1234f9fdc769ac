// Online back-propagation with momentum (Rumelhart, Hinton and Williams, 1986): the weights change
// after each sample.
//
// For an output o with its target t, delta = o (1 - o)(t - o). For a hidden neuron that answers o,
// delta = o (1 - o) x sum over the next layer of (its delta x the weight to it), with the weights
// as they were when the sample was presented. Then each weight changes by
// learning rate x delta x input + momentum x its previous change, where the input of a bias is 1.
#pragma once

#include <span>
#include <vector>

#include "elsie/neural/network.h"

namespace elsie::neural {

struct LearningRule {
  double learning_rate = 0.8;  // in (0, 1)
  double momentum = 0.3;       // in (0, 1)
};

/// Throws std::invalid_argument, with a sentence, when the rule's numbers are out of their range.
void check(const LearningRule& rule);

class BackPropagation {
 public:
  /// Trains `network`, which must outlive it and keep its sizes. The previous changes are zero.
  /// Throws as check() does.
  BackPropagation(Network& network, const LearningRule& rule);

  /// Presents one sample; the spans have the sizes of the network. Returns the sample's error, half
  /// the sum of (t - o)^2, before the weights changed.
  double present(std::span<const double> inputs, std::span<const double> targets);

 private:
  using Layer = Network::Layer;

  double present_two_wide(const double* inputs, const double* targets);
  double output_deltas(const double* targets);
  template <bool First>
  void change(const Layer& layer);

  Network& network_;
  LearningRule rule_;
  bool two_wide_;  // every layer has two inputs, and one or two neurons
  Workspace workspace_;
  std::vector<double> deltas_;   // of the neurons, where their answers are among the activations
  std::vector<double> changes_;  // the last ones, where the weights are
};

}  // namespace elsie::neural
