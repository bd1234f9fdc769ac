// Estimates of the remaining time from made-up times: nothing here has a clock.
#include <catch2/catch.hpp>

#include "elsie/batch/estimate.h"

using namespace elsie;
using batch::Estimate;

TEST_CASE("A cell without runs is expected to take the mean time of the others") {
  Estimate estimate({1, 1, 2}, 1);
  estimate.add_known(0, 2.0, 3);
  CHECK(estimate.left_s() == Approx(2.0 * 4));
  estimate.add_ended(1, 6.0);
  CHECK(estimate.left_s() == Approx(2.0 + 4.0 * 2));
  estimate.add_ended(2, 10.0);
  CHECK(estimate.left_s() == Approx(2.0 + 10.0));
}

TEST_CASE("The last runs do not become faster by more workers") {
  Estimate estimate({1, 1}, 16);
  estimate.add_known(0, 30.0, 4);
  estimate.add_known(1, 10.0, 4);
  CHECK(estimate.left_s() == 30.0);
  estimate.add_ended(0, 30.0);
  CHECK(estimate.left_s() == 10.0);
}

TEST_CASE("Without any time, or without pending runs, there is no estimate") {
  Estimate estimate({1, 0}, 2);
  CHECK_FALSE(estimate.left_s());
  estimate.add_known(1, 2.0, 3);  // of an earlier batch
  CHECK(estimate.left_s() == Approx(2.0));
  estimate.add_ended(0, 5.0);
  CHECK_FALSE(estimate.left_s());
  CHECK_FALSE(Estimate({}, 1).left_s());
}
