#include <catch2/catch.hpp>

#include "elsie/cluster/slurm.h"

using elsie::cluster::ranges;

TEST_CASE("Tasks are named in ranges") {
  CHECK(ranges({}).empty());
  CHECK(ranges({3}) == "3");
  CHECK(ranges({1, 2}) == "1-2");
  CHECK(ranges({1, 2, 3, 7, 9, 10}) == "1-3,7,9-10");
}
