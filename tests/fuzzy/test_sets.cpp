#include <catch2/catch.hpp>

#include "elsie/fuzzy/sets.h"

using elsie::FuzzySet;
using namespace elsie::fuzzy;

namespace {

const FuzzySet kTriangle{{{0, 0}, {3, 1}, {6, 0}}};
const FuzzySet kStep{{{0, 0}, {2, 0}, {2, 1}, {4, 1}, {4, 0}}};

}  // namespace

TEST_CASE("Area and centre of gravity of plain shapes") {
  CHECK(area(kTriangle) == Approx(3.0));
  CHECK(centroid(kTriangle).value() == Approx(3.0));
  CHECK(area(kStep) == Approx(2.0));
  CHECK(centroid(kStep).value() == Approx(3.0));
  // The centroid of a right-angled triangle is at two thirds.
  CHECK(centroid(FuzzySet{{{0, 0}, {6, 1}}}).value() == Approx(4.0));
  // Trapezoid with parallel sides 1 (at x = 0) and 0.5 (at x = 3): h (a + 2 b) / (3 (a + b)).
  CHECK(centroid(FuzzySet{{{0, 1}, {3, 0.5}}}).value() == Approx(3.0 * 2.0 / 4.5));
  CHECK(height(kTriangle) == 1.0);
}

TEST_CASE("What has no area has no centre") {
  CHECK_FALSE(centroid(FuzzySet{}));
  CHECK_FALSE(bisector(FuzzySet{}));
  CHECK_FALSE(centroid(FuzzySet{{{0, 0}, {1, 0}}}));
  CHECK_FALSE(leftmost_maximum(FuzzySet{{{0, 0}, {1, 0}}}));
  CHECK_FALSE(mean_of_maxima(FuzzySet{}));
}

TEST_CASE("The bisector halves the area") {
  CHECK(bisector(kTriangle).value() == Approx(3.0));
  // The area left of x is x^2 / 12, of 3 in all: half of it is left of sqrt(18).
  CHECK(bisector(FuzzySet{{{0, 0}, {6, 1}}}).value() == Approx(std::sqrt(18.0)));
  SECTION("and lies in the middle of a gap that does") {
    CHECK(bisector(FuzzySet{{{0, 1}, {1, 1}, {1, 0}, {3, 0}, {3, 1}, {4, 1}}}).value() ==
          Approx(2.0));
  }
}

TEST_CASE("The places of the maximum") {
  const FuzzySet two_peaks{{{0, 0}, {1, 1}, {2, 0}, {5, 1}, {6, 0}}};
  CHECK(leftmost_maximum(two_peaks) == 1.0);
  CHECK(rightmost_maximum(two_peaks) == 5.0);
  CHECK(mean_of_maxima(two_peaks).value() == Approx(3.0));
  SECTION("A plateau outweighs a peak of the same height") {
    const FuzzySet plateau{{{0, 0}, {1, 1}, {2, 0}, {4, 1}, {6, 1}, {7, 0}}};
    CHECK(mean_of_maxima(plateau).value() == Approx(5.0));
    CHECK(leftmost_maximum(plateau) == 1.0);
    CHECK(rightmost_maximum(plateau) == 6.0);
  }
  SECTION("Plateaus count by their lengths") {
    const FuzzySet plateaus{{{0, 1}, {1, 1}, {1, 0}, {4, 0}, {4, 1}, {7, 1}}};
    CHECK(mean_of_maxima(plateaus).value() == Approx((0.5 * 1 + 5.5 * 3) / 4));
  }
}

TEST_CASE("Union and intersection take the larger and the smaller degree, crossings included") {
  const FuzzySet falling{{{0, 1}, {4, 0}}};
  const FuzzySet rising{{{0, 0}, {4, 1}}};
  CHECK(union_of(falling, rising) == FuzzySet{{{0, 1}, {2, 0.5}, {4, 1}}});
  CHECK(intersection_of(falling, rising) == FuzzySet{{{0, 0}, {2, 0.5}, {4, 0}}});
  const FuzzySet both = union_of(kTriangle, kStep);
  CHECK(both.degree(1) == Approx(1.0 / 3.0));
  CHECK(both.degree(2.5) == 1.0);
  CHECK(both.degree(5) == Approx(1.0 / 3.0));
  CHECK(area(both) + area(intersection_of(kTriangle, kStep)) ==
        Approx(area(kTriangle) + area(kStep)));
  CHECK(union_of(FuzzySet{}, kTriangle) == kTriangle);
  CHECK(area(intersection_of(FuzzySet{}, kTriangle)) == 0.0);
}

TEST_CASE("Sums and products") {
  const FuzzySet a{{{0, 0}, {4, 1}}};
  const FuzzySet b{{{0, 0.5}, {4, 0.5}}};
  CHECK(bounded_sum_of(a, b) == FuzzySet{{{0, 0.5}, {2, 1}, {4, 1}}});
  CHECK(weighted_sum_of(a, 0.5, b, 2.0).degree(2) == Approx(1.25));
  CHECK(product_of(a, b).degree(2) == Approx(0.25));
  const FuzzySet squared = product_of(a, a);
  const FuzzySet sum = algebraic_sum_of(a, a);
  for (double x = 0.0; x <= 4.0; x += 0.01) {
    CHECK(squared.degree(x) == Approx(x * x / 16).margin(2.5e-4));
    CHECK(sum.degree(x) == Approx(x / 2 - x * x / 16).margin(2.5e-4));
  }
}

TEST_CASE("Cutting, scaling, complement and restriction") {
  CHECK(clipped(kTriangle, 0.5) == FuzzySet{{{0, 0}, {1.5, 0.5}, {4.5, 0.5}, {6, 0}}});
  CHECK(clipped(kTriangle, 1.0) == kTriangle);
  CHECK(scaled(kTriangle, 0.5) == FuzzySet{{{0, 0}, {3, 0.5}, {6, 0}}});
  CHECK(complement_of(kTriangle) == FuzzySet{{{0, 1}, {3, 0}, {6, 1}}});
  CHECK(complement_of(FuzzySet{}).degree(7) == 1.0);
  CHECK(restricted(kTriangle, 1.5, 3.0) == FuzzySet{{{1.5, 0.5}, {3, 1}}});
  CHECK(restricted(kStep, 2.0, 3.0) == FuzzySet{{{2, 1}, {3, 1}}});
}

TEST_CASE("At a step the degree has two sides") {
  CHECK(degree_before(kStep, 2) == 0.0);
  CHECK(degree_after(kStep, 2) == 1.0);
  CHECK(degree_before(kStep, 4) == 1.0);
  CHECK(degree_after(kStep, 4) == 0.0);
  CHECK(degree_before(kStep, 3) == 1.0);
}

TEST_CASE("Defuzzifying by the name of the method") {
  CHECK(defuzzify(kTriangle, Defuzzification::centroid) == centroid(kTriangle));
  CHECK(defuzzify(kTriangle, Defuzzification::bisector) == bisector(kTriangle));
  CHECK(defuzzify(kTriangle, Defuzzification::mean_of_maxima) == 3.0);
  const FuzzySet singletons{{{1, 0}, {1, 0.25}, {1, 0}, {5, 0}, {5, 0.75}, {5, 0}}};
  CHECK(defuzzify(singletons, Defuzzification::centroid_of_singletons).value() == Approx(4.0));
}
