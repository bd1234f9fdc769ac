// Lines of comma-separated values.
#include <catch2/catch.hpp>

#include "elsie/output/csv_line.h"

using namespace elsie;

TEST_CASE("A line is put together cell by cell") {
  output::CsvLine line;
  line.text("r1");
  line.number(0.1);
  line.empty();
  line.text("a,b");
  CHECK(line.take() == "r1,0.1,,\"a,b\"");
  line.number(2.0);
  CHECK(line.take() == "2");
}
