#include <cmath>
#include <limits>
#include <stdexcept>

#include <Eigen/Core>
#include <catch2/catch.hpp>

#include "support.h"

using namespace elsie;
using namespace elsie::neural;
using namespace elsie::test;

namespace {

double logistic(double x) { return 1.0 / (1.0 + std::exp(-x)); }

/// One neuron with one input.
Network single(double weight, double bias) {
  Network network({1, 1});
  network.set_weight(0, 0, 0, weight);
  network.set_bias(0, 0, bias);
  return network;
}

}  // namespace

TEST_CASE("A neuron answers the logistic sigmoid of its bias and its weighted inputs") {
  CHECK(answers(single(0, 0), {3})[0] == 0.5);
  CHECK(answers(single(2, -1), {1})[0] == Approx(logistic(1)).epsilon(1e-15));

  Network network({2, 2});
  network.set_weight(0, 0, 0, 0.5);
  network.set_weight(0, 0, 1, -0.25);
  network.set_bias(0, 0, 0.1);
  network.set_weight(0, 1, 1, 3.0);
  const auto outputs = answers(network, {0.4, 0.8});
  CHECK(outputs[0] == Approx(logistic(0.1 + 0.5 * 0.4 - 0.25 * 0.8)).epsilon(1e-15));
  CHECK(outputs[1] == Approx(logistic(3.0 * 0.8)).epsilon(1e-15));
}

TEST_CASE("The sigmoid is right to the last digits, from one end to the other") {
  const Network network = single(1, 0);
  double before = 0.0;
  for (int i = -63 * 512; i <= 63 * 512; ++i) {
    const double x = i / 512.0 + 1e-4;
    const double y = answers(network, {x})[0];
    // It never falls, except in the last digit.
    if (std::abs(y / logistic(x) - 1.0) > 2e-15 || y < before * (1.0 - 1e-15)) {
      FAIL("at " << x << ": " << y << " after " << before << ", expected " << logistic(x));
    }
    before = y;
  }
  // 1 - s(x) = s(-x)
  for (const double x : {0.0, 1e-300, 1e-9, 0.3, 1.7, 20.0}) {
    CHECK(answers(network, {x})[0] + answers(network, {-x})[0] == Approx(1.0).epsilon(1e-15));
  }
}

TEST_CASE("Far out the sigmoid is 1, or next to 0, and never anything else") {
  const Network network = single(1, 0);
  for (const double x : {40.0, 63.0, 64.0, 700.0, 1e10, 1e308}) {
    CHECK(answers(network, {x})[0] == 1.0);
    CHECK(answers(network, {-x})[0] < 1e-17);
    CHECK(answers(network, {-x})[0] > 0.0);
  }
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(answers(single(1e308, 0), {1e308})[0] == 1.0);
  CHECK(answers(single(-1e308, infinity), {0.0})[0] == 1.0);
}

TEST_CASE("Every layer is fully connected to the next: as with matrices") {
  Random random(7);
  for (const std::vector<int>& sizes : test::various_sizes()) {
    const Network network = random_network(sizes);
    const std::vector<double> inputs = test::random_numbers(network.inputs(), -2.0, 2.0, random);
    Eigen::VectorXd x =
        Eigen::Map<const Eigen::VectorXd>(inputs.data(), static_cast<Eigen::Index>(inputs.size()));
    for (std::size_t l = 0; l < network.layers(); ++l) {
      Eigen::MatrixXd weights(network.neurons(l), network.inputs(l));
      Eigen::VectorXd biases(network.neurons(l));
      for (std::size_t n = 0; n < network.neurons(l); ++n) {
        biases[static_cast<Eigen::Index>(n)] = network.bias(l, n);
        for (std::size_t i = 0; i < network.inputs(l); ++i) {
          weights(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(i)) =
              network.weight(l, n, i);
        }
      }
      x = (weights * x + biases).unaryExpr(&logistic).eval();
    }
    const std::vector<double> outputs = answers(network, inputs);
    INFO(sizes_text(sizes));
    for (std::size_t k = 0; k < outputs.size(); ++k) {
      CHECK(outputs[k] == Approx(x[static_cast<Eigen::Index>(k)]).epsilon(1e-13));
    }
  }
}

TEST_CASE("First weights are uniform in [-1, 1), from the stream alone") {
  const Network network = random_network({10, 30, 20, 10}, 5);
  double sum = 0.0, squares = 0.0, least = 1.0, most = -1.0;
  int count = 0;
  const auto look = [&](double weight) {
    CHECK((weight >= -1.0 && weight < 1.0));
    sum += weight;
    squares += weight * weight;
    least = std::min(least, weight);
    most = std::max(most, weight);
    ++count;
  };
  each_weight(network, [&](auto l, auto n, auto i) { look(get(network, l, n, i)); });
  CHECK(count == 11 * 30 + 31 * 20 + 21 * 10);
  CHECK(sum / count == Approx(0.0).margin(0.05));
  CHECK(squares / count == Approx(1.0 / 3.0).margin(0.03));
  CHECK(least < -0.98);
  CHECK(most > 0.98);
  CHECK(network == random_network({10, 30, 20, 10}, 5));
  CHECK_FALSE(network == random_network({10, 30, 20, 10}, 6));
}

TEST_CASE("First weights are drawn neuron by neuron: its weights, then its bias") {
  Random random(3);
  const Network network = random_network({2, 3, 1}, 3);
  each_weight(network, [&](auto l, auto n, auto i) {
    CHECK(get(network, l, n, i) == random.uniform(-1.0, 1.0));
  });
}

TEST_CASE("Networks that cannot be are refused") {
  for (const std::vector<int>& sizes :
       {std::vector<int>{},
        {2},
        {2, 0},
        {0, 2},
        {2, -1, 2},
        {100'000, 100'000},
        {2'000'000'000, 2'000'000'000, 2'000'000'000, 2'000'000'000, 2'000'000'000}}) {
    CHECK_THROWS_AS(Network(sizes), std::invalid_argument);
  }
  CHECK_THROWS_AS(Network(std::vector<int>(66, 1)), std::invalid_argument);
  CHECK_NOTHROW(Network(std::vector<int>(65, 1)));
}

TEST_CASE("Hidden layers are written as numbers with spaces between") {
  CHECK(parse_hidden_layers("2 2") == std::vector<int>{2, 2});
  CHECK(parse_hidden_layers("  4\t8  ") == std::vector<int>{4, 8});
  CHECK(parse_hidden_layers("12") == std::vector<int>{12});
  CHECK(parse_hidden_layers("0").empty());
  CHECK(parse_hidden_layers("").empty());
  CHECK(parse_hidden_layers("  ").empty());
  for (const char* wrong : {"2,2", "2 0", "0 0", "-2", "+2", "2.0", "two", "2x", "2 2;",
                            "99999999999999999999", "100000000", "nan"}) {
    CAPTURE(wrong);
    CHECK_THROWS_WITH(parse_hidden_layers(wrong),
                      Catch::StartsWith("hidden is '") && Catch::Contains("such as '4 4'"));
  }
}

TEST_CASE("First weights of the original's method are -1 and 0, equally often, and rarely 1") {
  Network network({200, 200, 200});
  Random random(1);
  network.randomize(random, Method::original);
  int minus = 0, zero = 0, one = 0;
  each_weight(network, [&](auto l, auto n, auto i) {
    if (i == network.inputs(l)) return;  // a bias
    const double weight = network.weight(l, n, i);
    minus += weight == -1.0;
    zero += weight == 0.0;
    one += weight == 1.0;
  });
  CHECK(minus + zero + one == 80'000);
  CHECK(minus == Approx(40'000).margin(600));
  CHECK(one < 12);  // 80,000 / 32,768 are to be expected
}
