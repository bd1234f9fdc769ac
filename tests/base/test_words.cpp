// Pieces of sentences.
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/base/words.h"

using namespace elsie;

TEST_CASE("Things are counted in words") {
  CHECK(base::counted(1, "run") == "1 run");
  CHECK(base::counted(0, "run") == "0 runs");
  CHECK(base::counted(2, "box", "boxes") == "2 boxes");
}

TEST_CASE("Items are joined, listed and enumerated") {
  CHECK(base::joined({}) == "");
  CHECK(base::joined({"a", "", "c"}, "|") == "a||c");
  CHECK(base::enumerated({"a"}) == "a");
  CHECK(base::enumerated({"a", "b"}) == "a and b");
  CHECK(base::enumerated({"a", "b", "c"}, "or") == "a, b or c");
  const std::vector<std::string> many(23, "x");
  CHECK(base::listed({many.begin(), many.begin() + 20}) ==
        base::joined({many.begin(), many.begin() + 20}));
  CHECK(base::listed(many).ends_with(", x and 3 more"));
}

TEST_CASE("A word from a file is quoted so that it can be printed") {
  CHECK(base::in_quotes("a\tb") == "'a?b'");
  CHECK(base::in_quotes(std::string(40, 'x')) == "'" + std::string(40, 'x') + "'");
  CHECK(base::in_quotes("na\xc3\xafve", 3) == "'na...'");
  CHECK(base::in_quotes(std::string(41, 'x')) == "'" + std::string(40, 'x') + "...'");
}
