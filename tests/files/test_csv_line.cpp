// Lines of comma-separated values.
#include <catch2/catch.hpp>

#include "elsie/files/csv_line.h"

using namespace elsie;

TEST_CASE("A line is put together cell by cell") {
  files::CsvLine line;
  line.text("r1");
  line.number(0.1);
  line.empty();
  line.text("a,b");
  CHECK(line.take() == "r1,0.1,,\"a,b\"");
  line.number(2.0);
  CHECK(line.take() == "2");
}

TEST_CASE("A cell is quoted when readers would take it for something else") {
  CHECK(files::csv_cell("plain text") == "plain text");
  CHECK(files::csv_cell("a,b") == "\"a,b\"");
  CHECK(files::csv_cell("say \"so\"") == "\"say \"\"so\"\"\"");
  CHECK(files::csv_cell("two\nlines") == "\"two\nlines\"");
  CHECK(files::csv_cell("#1") == "\"#1\"");
  CHECK(files::csv_cell("") == "");
}

TEST_CASE("A text is no formula for a spreadsheet, and a number stays one") {
  CHECK(files::csv_cell("=cmd|' /C calc'!A0") == "'=cmd|' /C calc'!A0");
  CHECK(files::csv_cell("@SUM(1,2)") == "\"'@SUM(1,2)\"");
  CHECK(files::csv_cell("+1+1") == "'+1+1");
  CHECK(files::csv_cell("-x") == "'-x");
  CHECK(files::csv_cell("-") == "'-");
  for (const char* number : {"-0.5", "-1e-300", "-1e999", "-inf", "7", "1 = 2", "a@b"}) {
    CHECK(files::csv_cell(number) == number);
  }
}

TEST_CASE("A cell has no character that commands a terminal or turns the text round") {
  CHECK(files::csv_cell("a\x1b[31mb") == "a\xef\xbf\xbd[31mb");
  CHECK(files::csv_cell("\xc2\x9b"
                        "31m") ==
        "\xef\xbf\xbd"
        "31m");
  CHECK(files::csv_cell("\xe2\x80\xae"
                        "txt") ==
        "\xef\xbf\xbd"
        "txt");
  CHECK(files::csv_cell("caf\xc3\xa9") == "caf\xc3\xa9");
}
