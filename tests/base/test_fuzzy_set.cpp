#include <catch2/catch.hpp>

#include "elsie/base/fuzzy_set.h"

using elsie::FuzzySet;

TEST_CASE("A triangle is 1 at its centre and 0 from its feet on") {
  const FuzzySet set = FuzzySet::triangle(10, 5);
  CHECK(set.degree(10) == 1.0);
  CHECK(set.degree(7.5) == Approx(0.5));
  CHECK(set.degree(14) == Approx(0.2));
  CHECK(set.degree(5) == 0.0);
  CHECK(set.degree(-100) == 0.0);
  CHECK(set.degree(100) == 0.0);
}

TEST_CASE("Outside its points a set goes on as it ends, and at a step it takes the larger degree") {
  const FuzzySet set{{{0, 1}, {1, 0.25}, {1, 0.75}, {2, 0.5}}};
  CHECK(set.degree(-3) == 1.0);
  CHECK(set.degree(1) == 0.75);
  CHECK(set.degree(0.5) == Approx(0.625));
  CHECK(set.degree(9) == 0.5);
}

TEST_CASE("The empty set is zero everywhere") { CHECK(FuzzySet{}.degree(0) == 0.0); }
