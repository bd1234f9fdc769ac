// The Fast Artificial Neural Network library learns the same from the same samples.
#include <memory>

#include <catch2/catch.hpp>
#include <doublefann.h>

#include "elsie/neural/back_propagation.h"

#include "support.h"

using namespace elsie;
using namespace elsie::neural;

namespace {

using Fann = std::unique_ptr<fann, void (*)(fann*)>;

/// The same network in FANN. A bias neuron follows each layer's neurons.
Fann copy(const Network& network) {
  std::vector<unsigned> sizes(network.sizes().begin(), network.sizes().end());
  Fann ann(fann_create_standard_array(static_cast<unsigned>(sizes.size()), sizes.data()),
           &fann_destroy);
  fann_set_activation_function_hidden(ann.get(), FANN_SIGMOID);
  fann_set_activation_function_output(ann.get(), FANN_SIGMOID);
  fann_set_activation_steepness_hidden(ann.get(), 0.5);  // its sigmoid has a factor of two
  fann_set_activation_steepness_output(ann.get(), 0.5);
  fann_set_training_algorithm(ann.get(), FANN_TRAIN_INCREMENTAL);
  fann_set_train_error_function(ann.get(), FANN_ERRORFUNC_LINEAR);
  unsigned from = 0;
  for (std::size_t l = 0; l < network.layers(); ++l) {
    const auto inputs = static_cast<unsigned>(network.inputs(l));
    const unsigned to = from + inputs + 1;
    for (unsigned n = 0; n < network.neurons(l); ++n) {
      for (unsigned i = 0; i < inputs; ++i) {
        fann_set_weight(ann.get(), from + i, to + n, network.weight(l, n, i));
      }
      fann_set_weight(ann.get(), from + inputs, to + n, network.bias(l, n));
    }
    from = to;
  }
  return ann;
}

}  // namespace

TEST_CASE("Network and training do what FANN does, presentation by presentation") {
  const TrainingSet samples = test::reference_set();
  for (const char* hidden : {"2 2", "4 4", "3", "2 2 2 2", "5 6", "12 9", "0"}) {
    Network network = test::random_network(samples, hidden, 4);
    const Fann ann = copy(network);
    const float rate = 0.25F, momentum = 0.3F;  // FANN takes them in single precision
    fann_set_learning_rate(ann.get(), rate);
    fann_set_learning_momentum(ann.get(), momentum);
    BackPropagation learner(network, {double{rate}, double{momentum}});
    double largest = 0.0;
    for (std::size_t p = 0; p < 900; ++p) {
      std::vector<double> inputs(samples.inputs(p % 9).begin(), samples.inputs(p % 9).end());
      std::vector<double> targets(samples.targets(p % 9).begin(), samples.targets(p % 9).end());
      const std::vector<double> ours = test::answers(network, inputs);
      const double* theirs = fann_run(ann.get(), inputs.data());
      for (std::size_t k = 0; k < 2; ++k) {
        largest = std::max(largest, std::abs(ours[k] - theirs[k]));
        // Beyond this, FANN clamps the slope of the sigmoid.
        REQUIRE((ours[k] > 0.01 && ours[k] < 0.99));
      }
      learner.present(inputs, targets);
      fann_train(ann.get(), inputs.data(), targets.data());
    }
    INFO(hidden);
    CHECK(largest < 1e-11);
  }
}
