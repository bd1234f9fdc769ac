// Databases of results that were damaged.
#include <algorithm>
#include <string>

#include <catch2/catch.hpp>

#include "elsie/base/random.h"

#include "support.h"

using namespace elsie;
using Catch::Contains;
using test::refusal;

namespace {

constexpr std::size_t kPage = 4096;

std::string random_bytes(Random& random, std::size_t size) {
  std::string bytes;
  while (bytes.size() < size) {
    bytes += static_cast<char>(random.bits() & 0xffU);
  }
  return bytes;
}

}  // namespace

TEST_CASE("A database with any page overwritten, lost or misplaced is refused") {
  const test::Folder folder;
  const std::string whole = folder.read(test::made_database(folder, "whole.sqlite"));
  const std::size_t pages = whole.size() / kPage;
  REQUIRE(pages > 60);
  Random random(1, "damage");
  const auto refused = [&](const std::string& content, const char* how, std::size_t page) {
    CAPTURE(how, page);
    const std::string file = folder.write("r.sqlite", content);
    const std::string why = refusal(file);
    CHECK_THAT(why, Contains("the database '" + file + "' is damaged (") &&
                        Contains("with another --database"));
    CHECK_THROWS_AS(results::open_to_write(file), results::DatabaseRefused);
    CHECK(folder.read("r.sqlite") == content);
  };
  for (std::size_t page = 1; page < pages; ++page) {
    const std::size_t at = page * kPage;
    refused(std::string(whole).replace(at, kPage, random_bytes(random, kPage)), "random", page);
    refused(std::string(whole).replace(at, kPage, std::string(kPage, '\0')), "zeros", page);
    refused(whole.substr(0, at), "cut off", page);
    refused(whole.substr(0, at + 100), "cut off in a page", page);
    if (page + 1 < pages && whole.substr(at, kPage) != whole.substr(at + kPage, kPage)) {
      refused(whole.substr(0, at) + whole.substr(at + kPage, kPage) + whole.substr(at, kPage) +
                  whole.substr(at + 2 * kPage),
              "swapped with the next", page);
    }
  }
}

TEST_CASE("Bytes that are overwritten within a list, a world or a data file are found") {
  const test::Folder folder;
  const std::string whole = folder.read(test::made_database(folder, "whole.sqlite"));
  const auto refused = [&](std::size_t at, const std::string& bytes, const std::string& why) {
    REQUIRE(at != std::string::npos);
    const std::string file =
        folder.write("r.sqlite", std::string(whole).replace(at, bytes.size(), bytes));
    CHECK_THAT(refusal(file), Contains("is damaged (" + why));
  };
  const std::string list = "in `trajectories` of run 4 a text is not a JSON list";
  refused(whole.find("[4.300,"), "abc", list);
  refused(whole.find("[4.300,"), "\xff\xff", list);
  refused(whole.find("[4.300,"), std::string(3, '\0'), list);
  refused(whole.find("\"wander\"") + 2, "\x01", "in `timelines` of run ");
  refused(whole.find("          </world>"), "x", "the world of cell 'cell ");
  refused(whole.find("a model"), "A", "the content of '/model' does not match its hash");
  CHECK(refusal(folder.write("r.sqlite", whole)).empty());
}

TEST_CASE("Rows with missing references, and missing tables, are damage") {
  const test::Folder folder;
  const std::string file = test::made_database(folder);
  SECTION("a cell is missing") {
    test::rows(file, "PRAGMA foreign_keys = OFF; DELETE FROM cells WHERE id = 0");
    CHECK_THAT(refusal(file),
               Contains("is damaged (a row of `runs` names one of `cells` that is not there)"));
  }
  SECTION("a table is missing") {
    test::rows(file, "DROP TABLE timelines");
    CHECK_THAT(refusal(file), Contains("is damaged (no such table: timelines)"));
  }
  SECTION("an index is not of its table") {
    test::rows(file,
               "PRAGMA writable_schema = ON; UPDATE sqlite_schema SET rootpage = (SELECT rootpage "
               "FROM sqlite_schema WHERE name = 'sqlite_autoindex_cells_1') WHERE name = "
               "'runs_by_state'");
    CHECK_THAT(refusal(file), Contains("is damaged ("));
  }
}

TEST_CASE("Damage that is found later is reported as such, errors of the system are not") {
  using results::sqlite::Error;
  const auto fails = [](int code) {
    results::guarded("r.sqlite", "could not be written", [&] { throw Error(code, "why"); });
  };
  CHECK_THROWS_AS(fails(11), results::DatabaseRefused);  // SQLITE_CORRUPT
  CHECK_THROWS_AS(fails(26), results::DatabaseRefused);  // SQLITE_NOTADB
  CHECK_THROWS_AS(fails(13), results::DatabaseError);    // SQLITE_FULL
  CHECK_THROWS_AS(fails(10), results::DatabaseError);    // SQLITE_IOERR
  CHECK_THROWS_WITH(fails(11), Contains("the database 'r.sqlite' is damaged (why)"));
  CHECK_THROWS_WITH(fails(13), Contains("'r.sqlite' could not be written: the disk is full"));
}
