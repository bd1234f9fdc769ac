// Training a network on a set of samples.
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
  /// Training stops when the mean error of a whole epoch is below this; at least 0.
  double threshold = 1e-11;
  /// Or after so many presentations of a sample; at least 1.
  std::uint64_t presentations = 200'000;
};

/// Throws std::invalid_argument, with a sentence, when a number is out of its range.
void check(const TrainingOptions& options);

/// How far a training has come.
struct TrainingProgress {
  std::uint64_t presentations = 0;
  std::uint64_t of = 0;  // at most
  double error = 0.0;    // mean of the last epoch; of what there is of the first one
};

/// Called now and then during a training; it goes on as long as this returns true.
using TrainingWatch = std::function<bool(const TrainingProgress&)>;

enum class Ending {
  threshold,      // the error came below the threshold
  presentations,  // there were as many as were allowed
  stopped         // the watch had it stopped
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
  /// The learning curve: each epoch while there are few, means over as many as make it fit for a
  /// picture when there are more.
  std::vector<CurvePoint> curve;
};

/// Trains `network` from the weights that it has: the samples one after another, in their order,
/// over and over. An epoch is once through all of them; its error is the mean over its
/// presentations of half the sum of (t - o)^2, each taken when the sample was presented. Throws
/// std::invalid_argument for options out of range, for an empty set or one of other sizes, and for
/// one with inputs so large that a weight is no longer finite.
Training train(Network& network, const TrainingSet& samples, const TrainingOptions& options,
               const TrainingWatch& watch = {});

}  // namespace elsie::neural
