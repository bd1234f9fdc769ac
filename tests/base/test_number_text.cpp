// Numbers as text.
#include <cmath>
#include <cstdlib>
#include <limits>

#include <catch2/catch.hpp>

#include "elsie/base/number_text.h"
#include "elsie/base/random.h"

using namespace elsie;

TEST_CASE("The shortest text of a number reads back as the same number") {
  CHECK(base::number_text(0.1) == "0.1");
  CHECK(base::number_text(-2.5e-7) == "-2.5e-07");
  CHECK(base::number_text(1e15) == "1e+15");
  CHECK(base::number_text(std::numeric_limits<double>::infinity()) == "inf");
  CHECK(base::number_text(std::nan("")) == "nan");
  Random random(1);
  for (int i = 0; i < 10000; ++i) {
    const double value = random.normal() * std::pow(10.0, random.uniform(-300.0, 300.0));
    const std::string text = base::number_text(value);
    REQUIRE(std::strtod(text.c_str(), nullptr) == value);
    REQUIRE(base::NumberText(value).view() == text);
  }
}

TEST_CASE("A number can be written with some significant digits or decimals") {
  CHECK(base::number_text(1234.5678, 6) == "1234.57");
  CHECK(base::number_text(0.1, 4) == "0.1");
  CHECK(base::number_text(1e10, 3) == "1e+10");
  CHECK(base::fixed_text(2.0, 2) == "2.00");
  CHECK(base::fixed_text(-0.001, 2) == "0.00");
  CHECK(base::fixed_text(-1.5, 0) == "-2");
  CHECK(base::fixed_text(1e300, 1).size() == 303);
  CHECK(base::seconds_text(0.25) == "0.25 s");
}
