#include <cmath>

#include <catch2/catch.hpp>

#include "elsie/base/random.h"

using elsie::Random;

TEST_CASE("The same seed and path give the same stream; another seed or path another one") {
  Random a(7, "robot[r1]/sensor[left]"), b(7, "robot[r1]/sensor[left]");
  Random other_seed(8, "robot[r1]/sensor[left]"), other_path(7, "robot[r1]/sensor[right]");
  int equal_seed = 0, equal_path = 0;
  for (int i = 0; i < 100; ++i) {
    const auto bits = a.bits();
    REQUIRE(bits == b.bits());
    equal_seed += bits == other_seed.bits();
    equal_path += bits == other_path.bits();
  }
  CHECK(equal_seed == 0);
  CHECK(equal_path == 0);
}

TEST_CASE("Uniform numbers stay in [0, 1) with mean 1/2 and variance 1/12") {
  Random random(1);
  double sum = 0, squares = 0;
  const int n = 200000;
  for (int i = 0; i < n; ++i) {
    const double u = random.uniform();
    REQUIRE(u >= 0.0);
    REQUIRE(u < 1.0);
    sum += u;
    squares += u * u;
  }
  const double mean = sum / n;
  CHECK(mean == Approx(0.5).margin(0.003));
  CHECK(squares / n - mean * mean == Approx(1.0 / 12).margin(0.002));
}

TEST_CASE("Normal numbers have the mean and deviation asked for, and normal tails") {
  Random random(2);
  double sum = 0, squares = 0;
  int beyond_two = 0;
  const int n = 200000;
  for (int i = 0; i < n; ++i) {
    const double z = random.normal(3.0, 2.0);
    REQUIRE(std::isfinite(z));
    sum += z;
    squares += (z - 3) * (z - 3);
    beyond_two += std::abs(z - 3.0) > 4.0;
  }
  CHECK(sum / n == Approx(3.0).margin(0.03));
  CHECK(std::sqrt(squares / n) == Approx(2.0).margin(0.03));
  CHECK(static_cast<double>(beyond_two) / n == Approx(0.0455).margin(0.003));
}

TEST_CASE("Chance is never for 0 and always for 1") {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    REQUIRE_FALSE(random.chance(0.0));
    REQUIRE(random.chance(1.0));
  }
}
