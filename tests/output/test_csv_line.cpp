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

TEST_CASE("A cell is quoted when readers would take it for something else") {
  CHECK(output::csv_cell("plain text") == "plain text");
  CHECK(output::csv_cell("a,b") == "\"a,b\"");
  CHECK(output::csv_cell("say \"so\"") == "\"say \"\"so\"\"\"");
  CHECK(output::csv_cell("two\nlines") == "\"two\nlines\"");
  CHECK(output::csv_cell("#1") == "\"#1\"");
  CHECK(output::csv_cell("") == "");
}
