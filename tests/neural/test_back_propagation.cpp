#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <catch2/catch.hpp>

#include "elsie/neural/back_propagation.h"

#include "support.h"

using namespace elsie;
using namespace elsie::neural;
using namespace elsie::test;

namespace {

double error(const Network& network, const std::vector<double>& inputs,
             const std::vector<double>& targets) {
  const std::vector<double> outputs = answers(network, inputs);
  double sum = 0.0;
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    sum += 0.5 * (targets[k] - outputs[k]) * (targets[k] - outputs[k]);
  }
  return sum;
}

}  // namespace

TEST_CASE("The first change of each weight is the learning rate times the slope of the error") {
  constexpr double kRate = 0.25, kStep = 1e-5;
  Random random(11);
  for (const std::vector<int>& sizes : test::various_sizes()) {
    const Network before = random_network(sizes, 2);
    const std::vector<double> inputs = test::random_numbers(before.inputs(), -1.5, 1.5, random);
    const std::vector<double> targets = test::random_numbers(before.outputs(), 0.0, 1.0, random);
    Network after = before;
    const double returned = BackPropagation(after, {kRate, 0.5}).present(inputs, targets);
    CHECK(returned == Approx(error(before, inputs, targets)).epsilon(1e-12));
    double largest = 0.0;
    each_weight(before, [&](std::size_t l, std::size_t n, std::size_t i) {
      Network moved = before;
      const double weight = get(before, l, n, i);
      set(moved, l, n, i, weight + kStep);
      const double above = error(moved, inputs, targets);
      set(moved, l, n, i, weight - kStep);
      const double slope = (above - error(moved, inputs, targets)) / (2.0 * kStep);
      const double change = get(after, l, n, i) - weight;
      largest = std::max(largest, std::abs(change / -kRate - slope));
    });
    INFO(sizes_text(sizes));
    CHECK(largest < 1e-10);
  }
}

TEST_CASE("Two presentations, computed by hand") {
  // One input, one hidden neuron, one output: every number can be written down.
  const double rate = 0.8, momentum = 0.3;
  double w1 = 0.5, b1 = -0.2, w2 = 0.7, b2 = 0.1;
  Network network({1, 1, 1});
  network.set_weight(0, 0, 0, w1);
  network.set_bias(0, 0, b1);
  network.set_weight(1, 0, 0, w2);
  network.set_bias(1, 0, b2);
  BackPropagation learner(network, {rate, momentum});
  double c1 = 0, cb1 = 0, c2 = 0, cb2 = 0;
  const double samples[][2] = {{0.6, 1.0}, {1.2, 0.0}};
  for (const auto& [x, t] : samples) {
    const double h = 1 / (1 + std::exp(-(w1 * x + b1)));
    const double o = 1 / (1 + std::exp(-(w2 * h + b2)));
    const double d2 = o * (1 - o) * (t - o);
    const double d1 = h * (1 - h) * d2 * w2;  // with the weight before its change
    c2 = rate * d2 * h + momentum * c2;
    cb2 = rate * d2 + momentum * cb2;
    c1 = rate * d1 * x + momentum * c1;
    cb1 = rate * d1 + momentum * cb1;
    w2 += c2, b2 += cb2, w1 += c1, b1 += cb1;
    CHECK(learner.present(std::span(&x, 1), std::span(&t, 1)) ==
          Approx(0.5 * (t - o) * (t - o)).epsilon(1e-14));
  }
  CHECK(network.weight(0, 0, 0) == Approx(w1).epsilon(1e-14));
  CHECK(network.bias(0, 0) == Approx(b1).epsilon(1e-14));
  CHECK(network.weight(1, 0, 0) == Approx(w2).epsilon(1e-14));
  CHECK(network.bias(1, 0) == Approx(b2).epsilon(1e-14));
}

TEST_CASE("A sample that is answered right changes nothing") {
  Network network = random_network({3, 4, 2});
  const Network before = network;
  const std::vector<double> inputs{0.1, -0.4, 0.9};
  const std::vector<double> targets = answers(network, inputs);
  CHECK(BackPropagation(network, {}).present(inputs, targets) == 0.0);
  CHECK(network == before);
}

TEST_CASE("Learning rate and momentum are in (0, 1)") {
  Network network({1, 1});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double wrong : {0.0, 1.0, -0.1, 1.5, nan}) {
    CHECK_THROWS_WITH(BackPropagation(network, {wrong, 0.3}),
                      Catch::Contains("learning rate") && Catch::Contains("below 1"));
    CHECK_THROWS_WITH(BackPropagation(network, {0.8, wrong}),
                      Catch::Contains("momentum") && Catch::Contains("above 0"));
  }
  CHECK_NOTHROW(BackPropagation(network, {0.999, 0.001}));
}

TEST_CASE("In the original's method momentum is that of the sample before, and no more") {
  constexpr double kRate = 0.25, kMomentum = 0.4;
  Random random(5);
  for (const std::vector<int>& sizes : test::various_sizes()) {
    Network network = random_network(sizes, 3);
    BackPropagation learner(network, {kRate, kMomentum, Method::original});
    Network slopes = network;  // in place of weights: delta x input of the sample before
    each_weight(slopes, [&](auto l, auto n, auto i) { set(slopes, l, n, i, 0.0); });
    for (int sample = 0; sample < 3; ++sample) {
      const std::vector<double> inputs = test::random_numbers(network.inputs(), -1.5, 1.5, random);
      const std::vector<double> targets = test::random_numbers(network.outputs(), 0.0, 1.0, random);
      const Network before = network;
      Network alone = network;  // learns this sample without any momentum
      BackPropagation(alone, {kRate, kMomentum}).present(inputs, targets);
      learner.present(inputs, targets);
      each_weight(network, [&](auto l, auto n, auto i) {
        const double learned = get(alone, l, n, i) - get(before, l, n, i);
        const double change = get(network, l, n, i) - get(before, l, n, i);
        CHECK(change == Approx(learned + kMomentum * get(slopes, l, n, i)).margin(1e-12));
        set(slopes, l, n, i, learned / kRate);
      });
    }
  }
}
