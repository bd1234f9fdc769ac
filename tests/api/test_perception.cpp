#include <array>
#include <stdexcept>

#include <catch2/catch.hpp>

#include "elsie/api/perception.h"

using namespace elsie;

TEST_CASE("A reading that is not there is a sentence, not a crash") {
  CHECK_THROWS_AS(Readings<RangeReading>()[0], std::out_of_range);
  CHECK_THROWS_WITH(Readings<RangeReading>()[0],
                    Catch::Contains("it asks for reading number 0 of kind 'range', but no sensor "
                                    "of the robot makes readings of this kind"));
  const RangeReading value{0.5, 1.0, true};
  const Mounting mounting;
  const std::array<SensedReading, 2> two{SensedReading{&value, &mounting, "left"},
                                         SensedReading{&value, &mounting, "right"}};
  const Readings<RangeReading> readings(two);
  CHECK(readings[1].sensor() == "right");
  CHECK_THROWS_WITH(readings[2], Catch::Contains("number 2 of kind 'range'") &&
                                     Catch::Contains("the robot has 2, numbers 0 to 1"));
}
