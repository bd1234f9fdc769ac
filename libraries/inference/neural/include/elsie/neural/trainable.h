// What programs ask of a coordinator that learns.
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

/// A training and everything that belongs to it.
struct Lesson {
  TrainingSet samples;
  std::vector<std::string> inputs;   // what they are called
  std::vector<std::string> outputs;  // likewise
  Training training;
  Weights weights;  // what was learned, and about it
  Assessment assessment;
  int attempts = 1;  // how many trainings it took; this is the best of them
};

/// The stream of first weights that a seed fixes, whatever the run and the robot.
Random stream_of_seed(std::uint64_t seed);

/// Coordinator plugins whose network is trained from a file derive from this class too. Programs
/// find them by dynamic_cast, as neither the core nor the program knows a plugin by name:
///
///   if (auto* learner = dynamic_cast<neural::Trainable*>(coordinator)) ...
///
/// Parameters that all of them have, with the same names and meanings: hidden, learning_rate,
/// momentum, threshold, presentations, training, weights, seed,
/// attempts.
class Trainable {
 public:
  virtual ~Trainable();

  /// Trains a fresh network as the parameters say, with first weights from `random`; the
  /// coordinator itself stays as it is. To be called when the coordinator was equipped. Given
  /// the stream that reset() is called with, it is the network that the coordinator trains there.
  /// Throws FileError or std::invalid_argument when there is nothing to learn from.
  virtual Lesson learn(Random& random, const TrainingWatch& watch) const = 0;

  /// The seed of the first weights when a parameter fixes it; -1: each run has its own.
  virtual std::int64_t fixed_seed() const = 0;
};

}  // namespace elsie::neural
