#include <catch2/catch.hpp>

#include "elsie/process/text_table.h"

using namespace elsie;

TEST_CASE("Texts stand to the left, numbers to the right") {
  CHECK(process::laid_out({{"cell", "of", "n"}, {"a", "both", "10"}, {"long one", "x", "5"}}, 2) ==
        "cell      of     n\n"
        "a         both  10\n"
        "long one  x      5\n");
  CHECK(process::laid_out({{"a", "1"}, {"b", "20"}}, 1, 3) == "a    1\nb   20\n");
}

TEST_CASE("Width counts characters, and no line ends in blanks") {
  CHECK(process::laid_out({{"\xc3\xa4\xc3\xb6", "x"}, {"abc", "y"}}, 2) ==
        "\xc3\xa4\xc3\xb6   x\nabc  y\n");
  CHECK(process::laid_out({{"a", "long"}, {"b", ""}, {"c"}}, 2) == "a  long\nb\nc\n");
  CHECK(process::laid_out({}, 1).empty());
}
