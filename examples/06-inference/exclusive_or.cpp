// A network without a robot: it learns "one or the other, but not both" by back-propagation.
//   exclusive_or [SEED]
#include <array>
#include <cstdio>
#include <cstdlib>

#include <elsie/base/random.h>
#include <elsie/neural/training.h>

namespace neural = elsie::neural;

int main(int argc, char** argv) {
  neural::TrainingSet samples(2, 1);
  for (const double a : {0.0, 1.0}) {
    for (const double b : {0.0, 1.0}) {
      samples.add(std::array{a, b}, std::array{a == b ? 0.0 : 1.0});
    }
  }
  elsie::Random random(argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1);
  neural::Network network({2, 3, 1});  // two inputs, three hidden neurons, one output
  network.randomize(random);
  const neural::Training training = neural::train(network, samples, {.threshold = 1e-3});
  std::printf("%llu presentations\n", static_cast<unsigned long long>(training.presentations));

  neural::Workspace workspace(network);
  bool learned = true;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    std::array<double, 1> answer{};
    network.evaluate(samples.inputs(i), answer, workspace);
    std::printf("%g %g: %.3f\n", samples.inputs(i)[0], samples.inputs(i)[1], answer[0]);
    learned = learned && (answer[0] > 0.5) == (samples.targets(i)[0] > 0.5);
  }
  return learned ? 0 : 1;
}
