// Tables of learned values, and their files.
#include <bit>
#include <cstdint>
#include <fstream>
#include <limits>
#include <stdexcept>

#include <catch2/catch.hpp>

#include "elsie/learning/values.h"

#include "folder.h"

using namespace elsie::learning;
using elsie::test::Folder;

namespace {

std::vector<std::uint64_t> bits(const ValueTable& table) {
  std::vector<std::uint64_t> all;
  for (std::size_t row = 0; row < table.states(); ++row) {
    for (const double value : table.row(row)) all.push_back(std::bit_cast<std::uint64_t>(value));
  }
  return all;
}

/// A valid file: two tables.
const std::string kGood =
    "elsie values 1\n"
    "about method w\n"
    "# a comment\n"
    "table food 2 3\n"
    "row 1 0.5 -1 2\n"
    "row 2 0.25 3 -1e-3\n"
    "\n"
    "table W 2 1\n"
    "row 1 4\n"
    "row 2 5\n"
    "end\n";

std::string complaint(const std::string& text) {
  try {
    parse_values(text, "v");
    return "";
  } catch (const FileError& error) {
    return error.what();
  }
}

/// The valid file with one piece replaced.
std::string with(const std::string& piece, const std::string& other) {
  std::string text = kGood;
  const std::size_t at = text.find(piece);
  REQUIRE(at != std::string::npos);
  return text.replace(at, piece.size(), other);
}

}  // namespace

TEST_CASE("The best action is the first of those with the largest value") {
  ValueTable table(2, 3);
  CHECK(table.best(0) == 0);
  CHECK(table.most(1) == 0.0);
  table.at(0, 1) = table.at(0, 2) = 1.5;
  table.at(1, 0) = -1.0;
  CHECK(table.best(0) == 1);
  CHECK(table.most(0) == 1.5);
  CHECK(table.best(1) == 1);
}

TEST_CASE("Written and read again, no bit of a table is lost") {
  const Folder folder;
  ValueTable odd(4, 2);
  const double numbers[] = {-0.0,    5e-324, -2.2250738585072014e-308, 1.7976931348623157e308, 0.1,
                            1.0 / 3, 1e22,   -123456789.123456789};
  for (std::size_t i = 0; i < 8; ++i) odd.at(i / 2, i % 2) = numbers[i];
  const Values values{{{"food", odd}, {"W", ValueTable(4, 1)}},
                      {{"method", "w"}, {"behaviors", "a b"}, {"empty", ""}}};
  write_values(values, folder.file("v"));
  const Values read = read_values(folder.file("v"));
  CHECK(read == values);
  CHECK(bits(read.tables[0].values) == bits(odd));
  CHECK(read.remark("behaviors") == "a b");
  CHECK(read.remark("seed").empty());
  CHECK(values_text(read) == values_text(values));
}

TEST_CASE("A file of values is read as it stands") {
  const Values values = parse_values(kGood);
  REQUIRE(values.tables.size() == 2);
  CHECK(values.tables[0].name == "food");
  CHECK(values.tables[0].values.states() == 2);
  CHECK(values.tables[0].values.actions() == 3);
  CHECK(values.tables[0].values.at(1, 1) == 3.0);
  CHECK(values.tables[1].values.at(1, 0) == 5.0);
  CHECK(values.about == std::vector<Remark>{{"method", "w"}});
}

TEST_CASE("Anything else than a file of values is refused, with the line") {
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"", "v:1: this is no file of values: expected 'elsie values 1' as its first line"},
      {with("elsie values 1", "elsie network 1"), "v:1: this is no file of values"},
      {with("elsie values 1", "elsie values 2"), "v:1: the file has version '2'"},
      {with("about method w", "about"), "v:2: expected a word and a text"},
      {with("# a comment", "about method q"), "v:3: a second line about 'method'"},
      {with("# a comment", "a comment"), "v:3: expected 'table', its name"},
      {with("table food 2 3", "table food 2"), "v:4: expected 'table', its name"},
      {with("table food 2 3", "table food 0 3"), "v:4: the size '0' is not a whole number"},
      {with("table food 2 3", "table food 2 2.5"), "v:4: the size '2.5' is not a whole number"},
      {with("table food 2 3", "table food 9000000 9000"), "v:4: A table of 9000000 x 9000 values"},
      {with("table food 2 3", "table food 3 3"), "v:8: expected 'row 3' and its numbers"},
      {with("row 1 0.5 -1 2", "row 1 0.5 -1"), "v:5: row 1 has 2 numbers, expected 3"},
      {with("row 1 0.5 -1 2", "row 2 0.5 -1 2"), "v:5: expected 'row 1' and its numbers"},
      {with("row 1 0.5 -1 2", "row 1 0.5 nan 2"), "v:5: 'nan' is not a finite number"},
      {with("row 1 0.5 -1 2", "row 1 0,5 -1 2"), "v:5: '0,5' is not a number; write a decimal"},
      {with("row 1 0.5 -1 2", "row 1 1e999 -1 2"), "v:5: '1e999' is beyond"},
      {with("row 2 5\nend", "row 2 5\nrow 3 5\nend"), "v:11: expected 'end'"},
      {with("end", "end\nmore"), "v:12: expected nothing after 'end'"},
      {with("a comment", std::string("\0", 1)), "v:3: this is not a text file"}};
  for (const auto& [text, message] : wrong) {
    CAPTURE(text);
    CHECK_THAT(complaint(text), Catch::StartsWith(message));
  }
}

TEST_CASE("A file of values that was cut off anywhere is refused") {
  for (std::size_t length = 0; length + 1 < kGood.size(); ++length) {
    const std::string cut = kGood.substr(0, length);
    if (cut.ends_with("end")) continue;  // only the last line feed is missing
    CAPTURE(cut);
    CHECK_FALSE(complaint(cut).empty());
  }
}

TEST_CASE("Values that cannot be written are not, and what was there stays") {
  const Folder folder;
  const std::string file = folder.write("v", "precious");
  ValueTable table(1, 1);
  CHECK_THROWS_AS(write_values({{}, {}}, file), std::invalid_argument);
  CHECK_THROWS_AS(write_values({{{"two words", table}}, {}}, file), std::invalid_argument);
  CHECK_THROWS_AS(write_values({{{"t", ValueTable(3, 0)}}, {}}, file), std::invalid_argument);
  CHECK_THROWS_AS(write_values({{{"t", table}}, {{"a", "x\nend"}}}, file), std::invalid_argument);
  for (const char* text : {" x", "x\t", " "}) {  // would be read back without blanks
    CHECK_THROWS_AS(write_values({{{"t", table}}, {{"a", text}}}, file), std::invalid_argument);
  }
  table.at(0, 0) = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(write_values({{{"t", table}}, {}}, file), std::invalid_argument);
  CHECK_THROWS_AS(ValueTable(kMostValues, 2), std::invalid_argument);
  CHECK(folder.read("v") == "precious");
  CHECK_THROWS_WITH(write_values({{{"t", ValueTable(1, 1)}}, {}}, folder.file("no/such/v")),
                    Catch::StartsWith("Cannot write the values"));
  CHECK(folder.files() == 1);
}

TEST_CASE("A file of values is known by how it begins") {
  const Folder folder;
  CHECK(looks_like_values(folder.write("v", kGood)));
  CHECK_FALSE(looks_like_values(folder.write("w", "elsie network 1\n")));
  CHECK_FALSE(looks_like_values(folder.file("nothing")));
}
