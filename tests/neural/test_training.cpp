#include <array>
#include <stdexcept>

#include <catch2/catch.hpp>

#include "elsie/neural/assessment.h"
#include "elsie/neural/training.h"

#include "support.h"

using namespace elsie;
using namespace elsie::neural;
using elsie::test::random_network;

namespace {

TrainingSet exclusive_or() { return parse_training_set("0 0 0\n0 1 1\n1 0 1\n1 1 0\n", {2, 1}); }

/// The assessment of a network with these hidden layers after training on the samples.
Assessment outcome(const TrainingSet& samples, const char* hidden, std::uint64_t seed) {
  Network network = random_network(samples, hidden, seed);
  train(network, samples, {});
  return assess(network, samples);
}

}  // namespace

TEST_CASE("A network with a hidden layer learns exclusive or") {
  int learned = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Assessment after = outcome(exclusive_or(), "4", seed);
    if (after.error < 1e-3) {
      ++learned;
      CHECK(after.answers[0] < 0.1);
      CHECK(after.answers[1] > 0.9);
      CHECK(after.answers[2] > 0.9);
      CHECK(after.answers[3] < 0.1);
      CHECK_FALSE(after.untrained);
    }
  }
  CHECK(learned >= 9);
}

TEST_CASE("A network without a hidden layer cannot learn exclusive or, and is reported") {
  const Assessment after = outcome(exclusive_or(), "0", 1);
  CHECK(after.error > 0.12);
  CHECK(after.missed == 4);
  CHECK_THAT(warning(after, std::array<std::string, 1>{"either"}),
             Catch::StartsWith("The network has not learned 4 of 4 samples"));
}

TEST_CASE("The reference set is learned by '2 2' and '4 4'") {
  for (const char* hidden : {"2 2", "4 4"}) {
    int good = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      good += outcome(test::reference_set(), hidden, seed).error < 1e-4;
    }
    CAPTURE(hidden);
    CHECK(good >= 9);
  }
}

TEST_CASE("'2 2 2 2' sits on the plateau for most seeds, and that is reported in words") {
  const TrainingSet samples = test::reference_set();
  const std::vector<std::string> behaviors{"avoid_obstacle", "find_resource"};
  constexpr int kSeeds = 50;
  int on_plateau = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Assessment after = outcome(samples, "2 2 2 2", seed);
    const bool at_its_error = after.error > 0.113 && after.error < 0.1145;
    CHECK(after.untrained == at_its_error);
    if (!after.untrained) {
      continue;
    }
    ++on_plateau;
    CHECK(after.flat == std::vector<bool>{true, true});
    for (std::size_t s = 0; s < samples.size(); ++s) {
      CHECK(after.answer(s)[0] == Approx(0.755).margin(0.015));
      CHECK(after.answer(s)[1] == Approx(0.111).margin(0.007));
    }
    CHECK_THAT(warning(after, behaviors), Catch::Contains("untrained") &&
                                              Catch::Contains("plateau") &&
                                              Catch::Contains("(0.75"));
  }
  CHECK(on_plateau > kSeeds / 2);
}

TEST_CASE("A network that has learned gets no warning") {
  const Assessment after = outcome(test::reference_set(), "2 2", 1);
  CHECK_FALSE(after.untrained);
  CHECK(after.flat == std::vector<bool>{false, false});
  CHECK(warning(after, std::array<std::string, 2>{"a", "b"}).empty());
}

TEST_CASE("Samples that a network has not learned are counted") {
  Network network({1, 1});  // answers 0.5 to everything
  const TrainingSet samples = parse_training_set("0 0.5\n1 0.7\n2 0.8\n3 0.2\n", {1, 1});
  const Assessment after = assess(network, samples);
  CHECK(after.missed == 2);
  CHECK(after.error == Approx(0.5 * (0.04 + 0.09 + 0.09) / 4));

  const Assessment half = outcome(test::reference_set(), "4 4", 4);  // a local minimum
  REQUIRE(half.error > 0.05);
  CHECK_FALSE(half.untrained);
  CHECK(half.missed == 1);
  CHECK_THAT(warning(half, std::array<std::string, 2>{"a", "b"}),
             Catch::StartsWith("The network has not learned 1 of 9 samples"));
}

TEST_CASE("One output that is the same whatever the input is named") {
  // The first output follows the input; the second does not depend on it.
  const TrainingSet samples = parse_training_set("0 0 0\n0 0 1\n1 1 0\n1 1 1\n", {1, 2});
  Network network = random_network({1, 2, 2}, 1);
  train(network, samples, {{0.1, 0.1}, 0.0, 50'000});
  const Assessment after = assess(network, samples);
  CHECK_FALSE(after.untrained);
  CHECK(after.flat == std::vector<bool>{false, true});
  CHECK_THAT(warning(after, std::array<std::string, 2>{"one", "two"}),
             Catch::StartsWith("The output for 'two' is untrained"));
}

TEST_CASE("An output whose targets are all the same may answer the same") {
  const TrainingSet samples = parse_training_set("0 0.3\n1 0.3\n", {1, 1});
  const Assessment after = outcome(samples, "2", 1);
  CHECK_FALSE(after.untrained);
  CHECK(after.error < 1e-9);
}

TEST_CASE("Samples are presented in their order, and the error is the mean over an epoch") {
  const TrainingSet samples = test::reference_set();
  Network by_hand = random_network(samples, "4 4", 3);
  Network trained = by_hand;
  BackPropagation learner(by_hand, {0.8, 0.3});
  std::vector<CurvePoint> curve;
  for (std::uint64_t epoch = 1; epoch <= 100; ++epoch) {
    double sum = 0.0;
    for (std::size_t s = 0; s < 9; ++s) {
      sum += learner.present(samples.inputs(s), samples.targets(s));
    }
    curve.push_back({9 * epoch, sum / 9});
  }
  const Training training = train(trained, samples, {{0.8, 0.3}, 0.0, 900});
  CHECK(trained == by_hand);
  CHECK(training.curve == curve);
  CHECK(training.presentations == 900);
  CHECK(training.ending == Ending::presentations);
}

TEST_CASE("Training stops at the first epoch whose mean error is below the threshold") {
  const TrainingSet samples = test::reference_set();
  Network network = random_network(samples, "2 2", 1);
  const Training training = train(network, samples, {{}, 1e-3, 200'000});
  CHECK(training.ending == Ending::threshold);
  CHECK(training.presentations % 9 == 0);
  CHECK(training.presentations < 100'000);
  CHECK(training.curve.back().error < 1e-3);
  CHECK(training.curve.back().presentations == training.presentations);

  // One epoch earlier, it is not reached yet.
  Network again = random_network(samples, "2 2", 1);
  const Training shorter = train(again, samples, {{}, 1e-3, training.presentations - 9});
  CHECK(shorter.ending == Ending::presentations);
}

TEST_CASE("Training stops after as many presentations as are allowed, in the middle of an epoch") {
  const TrainingSet samples = test::reference_set();
  Network network = random_network(samples, "2 2", 1);
  CHECK(train(network, samples, {{}, 1e-11, 200'000}).presentations == 200'000);
  Network once = random_network(samples, "2 2", 1);
  Network by_hand = once;
  const Training one = train(once, samples, {{}, 1.0, 1});
  CHECK(one.presentations == 1);
  CHECK(one.ending ==
        Ending::presentations);  // the error of one sample says nothing about the others
  BackPropagation(by_hand, {}).present(samples.inputs(0), samples.targets(0));
  CHECK(once == by_hand);
}

TEST_CASE("The same seed gives the same weights, bit for bit") {
  const TrainingSet samples = test::reference_set();
  for (const char* hidden : {"2 2", "4 4", "3 5"}) {
    Network first = random_network(samples, hidden, 6), second = first;
    train(first, samples, {});
    train(second, samples, {});
    CHECK(first == second);
    Network other = random_network(samples, hidden, 7);
    train(other, samples, {});
    CHECK_FALSE(first == other);
  }
}

TEST_CASE("A long training has a curve that fits a picture, from its beginning to its end") {
  const TrainingSet samples = test::reference_set();
  Network network = random_network(samples, "2 2", 1);
  const Training training = train(network, samples, {});
  CHECK(training.curve.size() > 500);
  CHECK(training.curve.size() < 2048);
  CHECK(training.curve.front().presentations < 1000);
  CHECK(training.curve.back().presentations > 199'900);
  for (std::size_t i = 1; i < training.curve.size(); ++i) {
    CHECK(training.curve[i].presentations > training.curve[i - 1].presentations);
  }
}

TEST_CASE("A watch sees the progress and may stop the training") {
  const TrainingSet samples = test::reference_set();
  Network network = random_network(samples, "2 2", 1);
  std::vector<std::uint64_t> seen;
  const Training training = train(network, samples, {}, [&](const TrainingProgress& progress) {
    CHECK(progress.of == 200'000);
    CHECK(progress.error > 0.0);
    seen.push_back(progress.presentations);
    return seen.size() < 3;
  });
  CHECK(training.ending == Ending::stopped);
  REQUIRE(seen.size() == 3);
  CHECK(training.presentations == seen.back());
}

TEST_CASE("Training refuses what makes no sense") {
  const TrainingSet samples = test::reference_set();
  Network network = random_network(samples, "2 2", 1);
  const Network before = network;
  CHECK_THROWS_WITH(train(network, samples, {{1.0, 0.3}}), Catch::Contains("learning rate"));
  CHECK_THROWS_WITH(train(network, samples, {{0.8, 0.0}}), Catch::Contains("momentum"));
  CHECK_THROWS_WITH(train(network, samples, {{}, -1.0}), Catch::Contains("threshold"));
  CHECK_THROWS_WITH(train(network, samples, {{}, 0.0, 0}), Catch::Contains("presentation"));
  CHECK_THROWS_WITH(train(network, exclusive_or(), {}), Catch::Contains("2-2-2-2"));
  CHECK_THROWS_WITH(train(network, TrainingSet(2, 2), {}), Catch::Contains("without samples"));
  CHECK(network == before);

  const TrainingSet huge = parse_training_set("1e308 1e308 1 0\n-1e308 1e308 0 1\n", {2, 2});
  CHECK_THROWS_WITH(train(network, huge, {}), Catch::Contains("too large"));
}

TEST_CASE("In the original's method one sample that is right ends the training") {
  const TrainingSet samples = parse_training_set("0 0\n1 1\n", {1, 1});
  TrainingOptions options;
  options.threshold = 0.01;
  const auto trained = [&](Method method, Network& network) {
    options.rule.method = method;
    return train(network, samples, options);
  };
  Network standard({1, 1}), original({1, 1});
  CHECK(trained(Method::standard, standard).ending == Ending::threshold);
  CHECK(assess(standard, samples).error < 0.01);
  const Training training = trained(Method::original, original);
  CHECK(training.ending == Ending::threshold);
  CHECK(assess(original, samples).error > 0.01);  // the other sample is not right yet
}

TEST_CASE("The original's method learns '4 4 4 4' from every seed, '2 2 2 2' from some") {
  const auto learned = [](const char* hidden) {
    int count = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      std::vector<int> sizes = parse_hidden_layers(hidden);
      sizes.insert(sizes.begin(), 2);
      sizes.push_back(2);
      Network network(sizes);
      Random random(seed);
      network.randomize(random, Method::original);
      TrainingOptions options;
      options.rule.method = Method::original;
      train(network, test::reference_set(), options);
      count += !assess(network, test::reference_set()).untrained;
    }
    return count;
  };
  CHECK(learned("4 4 4 4") == 12);
  const int some = learned("2 2 2 2");
  CAPTURE(some);
  CHECK((some >= 1 && some <= 9));
}
