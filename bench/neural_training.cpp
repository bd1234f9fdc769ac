// Online training compared with FANN: the same networks with the same first weights, the same
// samples in the same order, the same number of presentations, in one process. Checks that both
// learn the same before it measures. Prints a table with the ratios in Markdown.
//
// FANN: fann_train(), its incremental training, in single precision, as Debian's libfann has it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <memory>
#include <string>
#include <vector>

#include <fann.h>

#include "elsie/base/random.h"
#include "elsie/neural/back_propagation.h"
#include "elsie/neural/training_set.h"

#include "statistics.h"

namespace {

namespace neural = elsie::neural;

constexpr int kPairs = 15;
constexpr std::size_t kPresentations = 20'000;  // of each of the two in a pair
constexpr float kRate = 0.8F, kMomentum = 0.3F;

/// The samples in both forms, with memory for one presentation.
struct Samples {
  neural::TrainingSet set;
  std::vector<std::vector<fann_type>> inputs, targets;

  explicit Samples(neural::TrainingSet samples) : set(std::move(samples)) {
    for (std::size_t s = 0; s < set.size(); ++s) {
      inputs.emplace_back(set.inputs(s).begin(), set.inputs(s).end());
      targets.emplace_back(set.targets(s).begin(), set.targets(s).end());
    }
  }
};

using Fann = std::unique_ptr<fann, void (*)(fann*)>;

/// The same network in FANN. A bias neuron follows each layer's neurons.
Fann copy(const neural::Network& network) {
  const std::vector<unsigned> sizes(network.sizes().begin(), network.sizes().end());
  Fann ann(fann_create_standard_array(static_cast<unsigned>(sizes.size()), sizes.data()),
           &fann_destroy);
  fann_set_activation_function_hidden(ann.get(), FANN_SIGMOID);
  fann_set_activation_function_output(ann.get(), FANN_SIGMOID);
  fann_set_activation_steepness_hidden(ann.get(), 0.5F);  // its sigmoid has a factor of two
  fann_set_activation_steepness_output(ann.get(), 0.5F);
  fann_set_training_algorithm(ann.get(), FANN_TRAIN_INCREMENTAL);
  fann_set_train_error_function(ann.get(), FANN_ERRORFUNC_LINEAR);
  fann_set_learning_rate(ann.get(), kRate);
  fann_set_learning_momentum(ann.get(), kMomentum);
  unsigned from = 0;
  for (std::size_t l = 0; l < network.layers(); ++l) {
    const auto inputs = static_cast<unsigned>(network.inputs(l));
    const unsigned to = from + inputs + 1;
    for (unsigned n = 0; n < network.neurons(l); ++n) {
      for (unsigned i = 0; i < inputs; ++i) {
        fann_set_weight(ann.get(), from + i, to + n,
                        static_cast<fann_type>(network.weight(l, n, i)));
      }
      fann_set_weight(ann.get(), from + inputs, to + n, static_cast<fann_type>(network.bias(l, n)));
    }
    from = to;
  }
  return ann;
}

/// Processor time of this thread, s.
double now_s() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void learn(neural::BackPropagation& learner, const Samples& samples, std::size_t presentations) {
  for (std::size_t p = 0, s = 0; p < presentations; ++p) {
    learner.present(samples.set.inputs(s), samples.set.targets(s));
    s = s + 1 < samples.set.size() ? s + 1 : 0;
  }
}
void learn(fann* ann, Samples& samples, std::size_t presentations) {
  for (std::size_t p = 0, s = 0; p < presentations; ++p) {
    fann_train(ann, samples.inputs[s].data(), samples.targets[s].data());
    s = s + 1 < samples.inputs.size() ? s + 1 : 0;
  }
}

/// The largest difference of their answers after `presentations`.
double disagreement(neural::Network network, Samples& samples, std::size_t presentations) {
  const Fann ann = copy(network);
  neural::BackPropagation learner(network, {double{kRate}, double{kMomentum}});
  learn(learner, samples, presentations);
  learn(ann.get(), samples, presentations);
  neural::Workspace workspace(network);
  std::vector<double> answers(network.outputs());
  double largest = 0.0;
  for (std::size_t s = 0; s < samples.set.size(); ++s) {
    network.evaluate(samples.set.inputs(s), answers, workspace);
    const fann_type* theirs = fann_run(ann.get(), samples.inputs[s].data());
    for (std::size_t k = 0; k < answers.size(); ++k) {
      largest = std::max(largest, std::abs(answers[k] - double{theirs[k]}));
    }
  }
  return largest;
}

/// Prints one line of the table. Returns false when the two do not learn the same.
bool compare(const std::string& hidden, Samples& samples) {
  std::vector<int> sizes{static_cast<int>(samples.set.inputs())};
  for (const int layer : neural::parse_hidden_layers(hidden)) {
    sizes.push_back(layer);
  }
  sizes.push_back(static_cast<int>(samples.set.outputs()));
  neural::Network first(sizes);
  elsie::Random random(1);
  first.randomize(random);
  // Checked early: later, single precision makes them diverge.
  if (const double apart = disagreement(first, samples, 10 * samples.set.size()); apart > 1e-3) {
    std::printf("%s: the two do not learn the same (%g apart): no comparison.\n",
                neural::sizes_text(sizes).c_str(), apart);
    return false;
  }
  std::vector<double> ours, theirs, ratios;
  for (int pair = 0; pair < kPairs; ++pair) {
    neural::Network network = first;
    const Fann ann = copy(first);
    neural::BackPropagation learner(network, {double{kRate}, double{kMomentum}});
    const double start = now_s();
    learn(learner, samples, kPresentations);
    const double between = now_s();
    learn(ann.get(), samples, kPresentations);
    const double end = now_s();
    ours.push_back(static_cast<double>(kPresentations) / (between - start));
    theirs.push_back(static_cast<double>(kPresentations) / (end - between));
    ratios.push_back(ours.back() / theirs.back());
  }
  const auto [least, most] = std::minmax_element(ratios.begin(), ratios.end());
  std::printf("| %s | %.2f | %.2f | %.2f | %.2f to %.2f |\n", neural::sizes_text(sizes).c_str(),
              1e-6 * elsie::bench::median(ours), 1e-6 * elsie::bench::median(theirs),
              elsie::bench::median(ratios), *least, *most);
  std::fflush(stdout);
  return true;
}

/// Samples for a larger robot: eight sensors, three behaviours.
neural::TrainingSet larger_set() {
  elsie::Random random(1, "samples");
  neural::TrainingSet set(8, 3);
  for (int s = 0; s < 30; ++s) {
    std::vector<double> inputs(8), targets(3);
    for (double& input : inputs) {
      input = random.uniform();
    }
    targets[0] = 0.5 * (inputs[0] + inputs[7]);
    targets[1] = *std::min_element(inputs.begin(), inputs.end());
    targets[2] = inputs[3] > 0.5 ? 0.9 : 0.1;
    set.add(inputs, targets);
  }
  return set;
}

}  // namespace

int main() try {
  Samples reference(neural::read_training_set(
      ELSIE_SOURCE_DIR "/training_sets/two_sensors_two_behaviors.txt", {2, 2}));
  Samples larger(larger_set());
  std::printf(
      "| network | Elsie, million presentations/s | FANN, million presentations/s | ratio | spread "
      "of the ratio |\n|---|---|---|---|---|\n");
  bool same = true;
  for (const char* hidden : {"2", "2 2", "4 4", "2 2 2 2", "4 4 4 4"}) {
    same &= compare(hidden, reference);
  }
  for (const char* hidden : {"6", "16 16"}) {
    same &= compare(hidden, larger);
  }
  return same ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
