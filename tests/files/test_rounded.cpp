// Numbers as recordings keep them.
#include <cmath>

#include <catch2/catch.hpp>

#include "elsie/files/rounded.h"

using namespace elsie;

TEST_CASE("A number is rounded to decimals, without a negative zero") {
  CHECK(files::rounded(0.7000000000000001, 9) == 0.7);
  CHECK(files::rounded(2.5, 0) == 3.0);
  CHECK_FALSE(std::signbit(files::rounded(-0.0001, 2)));
  CHECK(files::rounded(1.25e300, 2) == 1.25e300);
}
