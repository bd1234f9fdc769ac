// Online back-propagation with momentum (Rumelhart, Hinton and Williams, 1986): the weights change
// after each sample.
//
// For an output o with target t, delta = o (1 - o)(t - o). For a hidden neuron with answer o, delta
// = o (1 - o) x sum over the next layer of (its delta x the weight to it), with the weights before
// the sample was presented. Then each weight changes by learning rate x delta x input + momentum x
// its previous change, where the input of a bias is 1. In the original's method (Method), momentum
// x the delta x input of the previous sample is added instead.
#pragma once

#include <span>
#include <vector>

#include "elsie/neural/network.h"

namespace elsie::neural {

struct LearningRule {
  double learning_rate = 0.8;  // in (0, 1)
  double momentum = 0.3;       // in (0, 1)
  Method method = Method::standard;
};

/// Throws std::invalid_argument with a sentence when a number is out of range.
void check(const LearningRule& rule);

class BackPropagation {
 public:
  /// Trains `network`, which must outlive it and keep its sizes. Before the first sample there is
  /// no change. Throws as check() does.
  BackPropagation(Network& network, const LearningRule& rule);

  /// Presents one sample; the spans must have the sizes of the network. Returns the sample's error
  /// before the weights changed, half the sum of (t - o)^2.
  double present(std::span<const double> inputs, std::span<const double> targets);

 private:
  using Layer = Network::Layer;

  double output_deltas(const double* targets);
  template <bool First>
  void change(const Layer& layer);
  struct Factors;
  Factors factors() const;

  Network& network_;
  LearningRule rule_;
  Workspace workspace_;
  std::vector<double> deltas_;   // of the neurons, at the indices of their activations
  std::vector<double> changes_;  // what momentum carries on, at the indices of the weights
};

}  // namespace elsie::neural
