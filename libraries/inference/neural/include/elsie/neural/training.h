// Trains a network on a set of samples.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "elsie/neural/back_propagation.h"
#include "elsie/neural/network.h"
#include "elsie/neural/training_set.h"

namespace elsie::neural {

struct TrainingOptions {
  LearningRule rule{};
  /// Training stops when the mean error of an epoch is below this; at least 0. In the original's
  /// method: when that of a single sample is.
  double threshold = 1e-11;
  /// Training also stops after so many presentations of samples; at least 1.
  std::uint64_t presentations = 200'000;
};

/// Throws std::invalid_argument with a sentence when a number is out of range.
void check(const TrainingOptions& options);

/// The progress of a training.
struct TrainingProgress {
  std::uint64_t presentations = 0;
  std::uint64_t of = 0;  // the most presentations
  double error = 0.0;    // mean of the last epoch; in the first one, mean so far
};

/// Called regularly during a training, which stops when it returns false.
using TrainingWatch = std::function<bool(const TrainingProgress&)>;

enum class Ending {
  threshold,      // the error fell below the threshold
  presentations,  // the allowed number was reached
  stopped         // the watch stopped it
};

/// A point of the learning curve: the mean error of some epochs, at the end of the last of them.
struct CurvePoint {
  std::uint64_t presentations = 0;
  double error = 0.0;

  friend bool operator==(const CurvePoint&, const CurvePoint&) = default;
};

struct Training {
  Ending ending = Ending::presentations;
  std::uint64_t presentations = 0;
  /// The learning curve: each epoch if there are few, else means over several, few enough for a
  /// picture.
  std::vector<CurvePoint> curve;
};

/// Trains `network` from its present weights on the samples in order, again and again. An epoch is
/// one pass over all samples; its error is the mean over its presentations of half the sum of (t -
/// o)^2, each before the weights changed. Throws std::invalid_argument for options out of range,
/// for a set that is empty or of other sizes, and for inputs so large that a weight becomes
/// infinite.
Training train(Network& network, const TrainingSet& samples, const TrainingOptions& options,
               const TrainingWatch& watch = {});

}  // namespace elsie::neural
