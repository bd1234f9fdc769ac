// Labels of levels.
#include <catch2/catch.hpp>

#include "elsie/experiment/formula_names.h"

TEST_CASE("A label is a number only as a whole") {
  using elsie::experiment::number_in;
  CHECK(number_in("0.25") == 0.25);
  CHECK(number_in("-3e2") == -300.0);
  for (const char* word : {"", "fast", "2 2", "3 m", "inf", "nan", "0x10", " 1"}) {
    CAPTURE(word);
    CHECK_FALSE(number_in(word));
  }
}
