#include <catch2/catch.hpp>

#include "elsie/cluster/shell_word.h"
#include "elsie/cluster/slurm.h"

using elsie::cluster::ranges;
using elsie::cluster::shell_line;
using elsie::cluster::shell_word;

TEST_CASE("Tasks are named in ranges") {
  CHECK(ranges({}).empty());
  CHECK(ranges({3}) == "3");
  CHECK(ranges({1, 2}) == "1-2");
  CHECK(ranges({1, 2, 3, 7, 9, 10}) == "1-3,7,9-10");
}

TEST_CASE("Words are quoted where a shell would take them apart") {
  CHECK(shell_word("worlds/a-b_c.xml") == "worlds/a-b_c.xml");
  CHECK(shell_word("") == "''");
  CHECK(shell_word("a b") == "'a b'");
  CHECK(shell_word("it's") == "'it'\\''s'");
  CHECK(shell_line({"elsie", "batch", "a b", "$x"}) == "elsie batch 'a b' '$x'");
}
