// How well a network fits its samples.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "elsie/neural/network.h"
#include "elsie/neural/training.h"
#include "elsie/neural/training_set.h"

namespace elsie::neural {

/// An output is flat when its answers range over less than this part of the range of its targets:
/// it does not distinguish its inputs.
inline constexpr double kFlat = 0.05;

/// A sample is missed when an answer differs from its target by more than this.
inline constexpr double kMissed = 0.25;

struct Assessment {
  double error = 0.0;           // mean over the samples of half the sum of (t - o)^2
  std::vector<double> answers;  // to all samples, one after the other
  /// For each output: it answers the same to every sample, although its targets differ.
  std::vector<bool> flat;

  std::size_t missed = 0;  // samples
  /// Every output whose targets differ is flat: back-propagation is on a plateau, where the network
  /// answers the mean of its targets to everything.
  bool untrained = false;

  std::span<const double> answer(std::size_t sample) const {
    return std::span(answers).subspan(sample * flat.size(), flat.size());
  }
};

/// Presents every sample once. Network and samples must have the same sizes.
Assessment assess(const Network& network, const TrainingSet& samples);

/// "mean error 8.7e-05 after 200000 presentations".
std::string summary(const Training& training, const Assessment& assessment);

/// Sentences for the user about a network that has not learned everything; empty if it has.
/// `outputs`: the names of all outputs.
std::string warning(const Assessment& assessment, std::span<const std::string> outputs);

}  // namespace elsie::neural
