#include "elsie/neural/training.h"

#include <cmath>
#include <stdexcept>

#include "text.h"

namespace elsie::neural {
namespace {

constexpr std::uint64_t kBetweenLooks = 4096;  // least number of presentations

/// Collects the errors of epochs; if there are too many points, merges pairs of them.
class Curve {
 public:
  explicit Curve(std::vector<CurvePoint>& points) : points_(points) {}

  void add(std::uint64_t presentations, double error) {
    sum_ += error;
    presentations_ = presentations;
    if (++gathered_ < epochs_in_point_) {
      return;
    }
    finish();
    if (points_.size() == kMostPoints) {
      for (std::size_t i = 0; i < kMostPoints / 2; ++i) {
        points_[i] = {points_[2 * i + 1].presentations,
                      0.5 * (points_[2 * i].error + points_[2 * i + 1].error)};
      }
      points_.resize(kMostPoints / 2);
      epochs_in_point_ *= 2;
    }
  }

  /// Makes a point of the collected errors.
  void finish() {
    if (gathered_ > 0) {
      points_.push_back({presentations_, sum_ / static_cast<double>(gathered_)});
      sum_ = 0.0;
      gathered_ = 0;
    }
  }

 private:
  static constexpr std::size_t kMostPoints = 2048;

  std::vector<CurvePoint>& points_;
  std::uint64_t epochs_in_point_ = 1;
  std::uint64_t gathered_ = 0;
  std::uint64_t presentations_ = 0;  // at the end of the last epoch
  double sum_ = 0.0;
};

void check_fit(const Network& network, const TrainingSet& samples) {
  if (samples.inputs() != network.inputs() || samples.outputs() != network.outputs()) {
    throw std::invalid_argument(
        "A network " + sizes_text(network.sizes()) + " cannot learn from samples with " +
        counted(samples.inputs(), "input") + " and " + counted(samples.outputs(), "output") + ".");
  }
  if (samples.size() == 0) {
    throw std::invalid_argument("A network cannot learn from a set without samples.");
  }
}

}  // namespace

void check(const TrainingOptions& options) {
  check(options.rule);
  if (!(options.threshold >= 0.0) || !std::isfinite(options.threshold)) {
    throw std::invalid_argument("the threshold is " + number_text(options.threshold) +
                                ", but must be a number of at least 0");
  }
  if (options.presentations < 1) {
    throw std::invalid_argument("there must be at least 1 presentation of a sample");
  }
}

Training train(Network& network, const TrainingSet& samples, const TrainingOptions& options,
               const TrainingWatch& watch) {
  check(options);
  check_fit(network, samples);
  Training training;
  training.ending = Ending::presentations;
  BackPropagation learner(network, options.rule);
  Curve curve(training.curve);
  const std::uint64_t most = options.presentations;
  const bool by_sample = options.rule.method == Method::original;
  std::uint64_t done = 0, next_look = kBetweenLooks;
  while (done < most) {
    double sum = 0.0;
    std::size_t s = 0;
    bool is_good_enough = false;
    for (; s < samples.size() && done < most && !is_good_enough; ++s, ++done) {
      const double error_now = learner.present(samples.inputs(s), samples.targets(s));
      sum += error_now;
      is_good_enough = by_sample && error_now < options.threshold;
    }
    const double error = sum / static_cast<double>(s);
    // An incomplete last epoch says nothing about the set.
    if (s == samples.size() || training.curve.empty()) {
      curve.add(done, error);
    }
    if (is_good_enough || (!by_sample && s == samples.size() && error < options.threshold)) {
      training.ending = Ending::threshold;
      break;
    }
    if (done >= next_look && done < most) {
      next_look = done + kBetweenLooks;
      if (watch && !watch({done, most, error})) {
        training.ending = Ending::stopped;
        break;
      }
    }
  }
  curve.finish();
  training.presentations = done;
  if (!network.is_finite()) {
    throw std::invalid_argument(
        "The network's weights have grown beyond all bounds in training; the inputs of its samples "
        "are too large.");
  }
  return training;
}

}  // namespace elsie::neural
