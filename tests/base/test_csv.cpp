// Cells of comma-separated values.
#include <catch2/catch.hpp>

#include "elsie/base/csv.h"
#include "elsie/output/csv_line.h"

using namespace elsie;

TEST_CASE("A cell is quoted when readers would take it for something else") {
  CHECK(base::csv_cell("plain text") == "plain text");
  CHECK(base::csv_cell("a,b") == "\"a,b\"");
  CHECK(base::csv_cell("say \"so\"") == "\"say \"\"so\"\"\"");
  CHECK(base::csv_cell("two\nlines") == "\"two\nlines\"");
  CHECK(base::csv_cell("#1") == "\"#1\"");
  CHECK(base::csv_cell("") == "");
}
