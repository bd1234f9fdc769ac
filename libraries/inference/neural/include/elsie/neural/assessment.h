// How well a network does what its samples say.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "elsie/neural/network.h"
#include "elsie/neural/training.h"
#include "elsie/neural/training_set.h"

namespace elsie::neural {

/// An output whose answers range over less than this part of the range of its targets has not
/// learned to tell its inputs apart.
inline constexpr double kFlat = 0.05;

/// A sample is missed when an answer is further than this from its target.
inline constexpr double kMissed = 0.25;

struct Assessment {
  double error = 0.0;           // mean over the samples of half the sum of (t - o)^2
  std::vector<double> answers;  // to each sample, one after the other
  /// For each output, whether it answers the same whatever the sample, although it should not.
  std::vector<bool> flat;

  std::size_t missed = 0;  // samples
  /// Whether no output that should tell its inputs apart does so: back-propagation sits on a
  /// plateau, where the network answers the mean of its targets to everything.
  bool untrained = false;

  std::span<const double> answer(std::size_t sample) const {
    return std::span(answers).subspan(sample * flat.size(), flat.size());
  }
};

/// Presents every sample once. The sizes of network and samples must be the same.
Assessment assess(const Network& network, const TrainingSet& samples);

/// "mean error 8.7e-05 after 200000 presentations".
std::string summary(const Training& training, const Assessment& assessment);

/// What a user should know of a network that has not learned everything, in sentences; empty when
/// there is nothing. `outputs`: names of the outputs, as many as there are.
std::string warning(const Assessment& assessment, std::span<const std::string> outputs);

}  // namespace elsie::neural
