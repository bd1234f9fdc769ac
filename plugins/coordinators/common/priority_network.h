// A neural network that sets the priorities of behaviours; shared by coordinators.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <elsie/api/coordinator.h>
#include <elsie/neural/assessment.h>
#include <elsie/neural/network.h>
#include <elsie/neural/trainable.h>

/// Inputs: the readings of the range sensors in file order, in metres. Outputs: the priorities of
/// the behaviours in file order, each in (0, 1). The first weights come from the run's random
/// stream, so that each run trains its own network, unless a seed or a file of weights fixes them.
class PriorityNetwork : public elsie::neural::Trainable {
 public:
  /// The value of `hidden` for the layers of the weights or, in a network to be trained, "2 2".
  static constexpr const char* kOwnHidden = "auto";

  std::string hidden = kOwnHidden;
  double learning_rate = 0.8;
  double momentum = 0.3;
  std::string rule = "standard";
  double threshold = 1e-11;
  std::int64_t presentations = 200'000;
  elsie::FilePath training;
  elsie::FilePath weights;
  std::int64_t seed = -1;
  int attempts = 1;
  bool normalise = false;

  elsie::neural::Lesson learn(elsie::Random& random,
                              const elsie::neural::TrainingWatch& watch) const override;
  std::int64_t fixed_seed() const override { return seed; }

 protected:
  PriorityNetwork() = default;

  void check_parameters();
  void equip(std::span<const elsie::Member> members, const elsie::Perception& example);
  void prepare_run(elsie::Random& random);
  std::vector<std::string> tell() const;
  std::vector<elsie::Curve> show() const;

  /// The current priorities of all members. Valid until the next call. Does not allocate.
  std::span<const double> priorities(const elsie::Perception& now);

 private:
  elsie::neural::TrainingOptions options() const;
  elsie::neural::Method method() const;
  elsie::neural::Columns columns() const;
  std::vector<int> hidden_layers() const;
  std::vector<int> sizes() const;
  elsie::neural::TrainingSet read_samples() const;
  void prepare();
  void load_weights();
  bool fits_robot() const;
  void use(elsie::neural::Weights weights);

  std::vector<std::string> sensors_;    // the names of the inputs
  std::vector<std::string> behaviors_;  // the names of the outputs
  bool equipped_ = false;
  bool has_begun_ = false;                             // true once a run has begun
  std::optional<elsie::neural::TrainingSet> samples_;  // none if weights are given
  std::optional<elsie::neural::Weights> learned_;
  std::optional<elsie::neural::Workspace> workspace_;
  bool fixed_ = false;  // true if every run uses the same network
  std::vector<std::string> notes_;
  std::vector<elsie::Curve> curves_;  // of the training of the network in use
  std::vector<double> readings_;
  std::vector<double> priorities_;
};

/// A coordinator of the kind `Base` with this network.
template <class Base>
class WithPriorityNetwork : public Base, public PriorityNetwork {
 public:
  void configured() override { check_parameters(); }
  void equipped(std::span<const elsie::Member> members, const elsie::Perception& example) override {
    equip(members, example);
  }
  void reset(elsie::Random& random) override { prepare_run(random); }
  std::vector<std::string> notes() const override { return tell(); }
  std::vector<elsie::Curve> curves() const override { return show(); }
};

/// The parameters of such a coordinator, for its declaration.
#define PRIORITY_NETWORK_PARAMETERS                                                               \
  elsie::parameter(                                                                               \
      "hidden", &PriorityNetwork::hidden,                                                         \
      {.meaning = "neurons in each hidden layer, such as '4 4'; '0' for no hidden layer; 'auto' " \
                  "for those of the weights or, where a network is trained, '2 2'",               \
       .live = false}),                                                                           \
      elsie::parameter("training", &PriorityNetwork::training,                                    \
                       {.meaning = "file of samples to learn from: on each line a number for "    \
                                   "each range sensor, then one for each behaviour",              \
                        .live = false}),                                                          \
      elsie::parameter("weights", &PriorityNetwork::weights,                                      \
                       {.meaning = "file of weights, as elsie train writes it: then nothing is "  \
                                   "trained; hidden must be that of the file, or 'auto'"}),       \
      elsie::parameter(                                                                           \
          "learning_rate", &PriorityNetwork::learning_rate,                                       \
          {.above = 0, .max = 1, .meaning = "of back-propagation; below 1", .live = false}),      \
      elsie::parameter(                                                                           \
          "momentum", &PriorityNetwork::momentum,                                                 \
          {.above = 0, .max = 1, .meaning = "of back-propagation; below 1", .live = false}),      \
      elsie::parameter("rule", &PriorityNetwork::rule,                                            \
                       {.choices = {"standard", "original"},                                      \
                        .meaning = "how it learns; 'original': first weights -1, 0 or rarely 1, " \
                                   "momentum of the previous sample only, and training ends "     \
                                   "when the error of one sample is below the threshold",         \
                        .live = false}),                                                          \
      elsie::parameter("threshold", &PriorityNetwork::threshold,                                  \
                       {.min = 0,                                                                 \
                        .meaning = "training ends when the mean error of an epoch is below it, "  \
                                   "or with rule='original' that of one sample",                  \
                        .live = false}),                                                          \
      elsie::parameter("presentations", &PriorityNetwork::presentations,                          \
                       {.min = 1,                                                                 \
                        .meaning = "training ends after so many samples at the latest",           \
                        .live = false}),                                                          \
      elsie::parameter("seed", &PriorityNetwork::seed,                                            \
                       {.min = -1,                                                                \
                        .meaning = "fixes the first weights for all runs; -1: each run has its "  \
                                   "own, which its seed decides",                                 \
                        .live = false}),                                                          \
      elsie::parameter("attempts", &PriorityNetwork::attempts,                                    \
                       {.min = 1,                                                                 \
                        .max = 1000,                                                              \
                        .meaning = "a training that misses a sample is tried again from other "   \
                                   "first weights, up to so many times; the best one counts",     \
                        .live = false}),                                                          \
      elsie::parameter("normalise", &PriorityNetwork::normalise,                                  \
                       {.meaning = "whether readings are divided by the sensor's maximum range "  \
                                   "before the network gets them",                                \
                        .live = false})
