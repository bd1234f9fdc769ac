// What is wrong with a model's file, or untidy.
#include <catch2/catch.hpp>

#include "problems.h"

using namespace elsie;

TEST_CASE("Problems and notes of some lines can be forgotten, and be met again") {
  fuzzy::Problems problems("model.fcl", 200);
  problems.add(1, "one");
  problems.add(5, "five");
  problems.add_note(6, "untidy");
  problems.add_note(2, "untidy");
  problems.forget(4, 6);
  CHECK(problems.size() == 1);
  CHECK(problems.notes() == std::vector<base::Problem>{{"model.fcl", 2, "untidy"}});
  problems.add(5, "five");
  CHECK(problems.size() == 2);
}
