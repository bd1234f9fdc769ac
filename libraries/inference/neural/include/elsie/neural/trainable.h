// The interface of coordinators that learn, for programs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "elsie/base/random.h"
#include "elsie/neural/assessment.h"
#include "elsie/neural/training.h"
#include "elsie/neural/training_set.h"
#include "elsie/neural/weights.h"

namespace elsie::neural {

/// The result of a training.
struct Lesson {
  TrainingSet samples;
  std::vector<std::string> inputs;   // their names
  std::vector<std::string> outputs;  // their names
  Training training;
  Weights weights;  // what was learned, with remarks
  Assessment assessment;
  int attempts = 1;  // number of trainings, of which this is the best
};

/// The stream of first weights that follows from a seed, in any run and on any robot.
Random stream_of_seed(std::uint64_t seed);

/// Coordinator plugins whose network is trained from a file also derive from this class. Programs
/// find them by dynamic_cast, because neither the core nor the program knows a plugin by name:
///
///   if (auto* learner = dynamic_cast<neural::Trainable*>(coordinator)) ...
///
/// All of them have these parameters, with the same meanings: hidden, learning_rate, momentum,
/// rule, threshold, presentations, training, weights, seed, attempts.
class Trainable {
 public:
  virtual ~Trainable();

  /// Trains a fresh network by the parameters, with first weights from `random`; the coordinator
  /// itself does not change. To be called after equipped(). With the stream that reset() gets, the
  /// result is the network that the coordinator trains there. Throws FileError or
  /// std::invalid_argument when there are no usable samples.
  virtual Lesson learn(Random& random, const TrainingWatch& watch) const = 0;

  /// The seed of the first weights, if a parameter fixes it; -1: each run has its own.
  virtual std::int64_t fixed_seed() const = 0;
};

}  // namespace elsie::neural
