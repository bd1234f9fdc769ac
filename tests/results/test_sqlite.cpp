#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

#include <catch2/catch.hpp>

#include "elsie/results/sqlite.h"

#include "support.h"

using elsie::test::Folder;
namespace sqlite = elsie::results::sqlite;

namespace {

struct Table {
  Folder folder;
  sqlite::Connection connection{folder.file("t.sqlite"), sqlite::Connection::Mode::create};

  Table() { connection.run("CREATE TABLE t (a PRIMARY KEY, b, c)"); }
  std::string rows() {
    return connection.text(
        "SELECT group_concat(typeof(a) || ' ' || quote(a) || ' ' || quote(b) || ' ' || "
        "quote(c), '; ') FROM (SELECT * FROM t ORDER BY rowid)");
  }
};

}  // namespace

TEST_CASE("A row is inserted with values of every kind") {
  Table table;
  auto insert = sqlite::Statement::insert(table.connection, "t", "a, b, c");
  insert.run(1, std::string("one"), 0.5);
  insert.run("x", std::optional<double>(), std::optional<int>(7));
  insert.run(sqlite::Bytes{"m"}, std::optional<sqlite::Bytes>(), "");
  CHECK(table.rows() == "integer 1 'one' 0.5; text 'x' NULL 7; blob X'6D' NULL ''");
}

TEST_CASE("The 64 bits of an unsigned number come back") {
  Table table;
  constexpr std::uint64_t kSeed = std::numeric_limits<std::uint64_t>::max() - 1;
  sqlite::Statement::insert(table.connection, "t", "a").run(kSeed);
  CHECK(static_cast<std::uint64_t>(table.connection.integer("SELECT a FROM t")) == kSeed);
}

TEST_CASE("A row that is there already is refused or ignored") {
  Table table;
  auto insert = sqlite::Statement::insert(table.connection, "t", "a, b");
  insert.run(1, "first");
  CHECK_THROWS_AS(insert.run(1, "second"), sqlite::Error);
  sqlite::Statement::insert_or_ignore(table.connection, "t", "a, b").run(1, "third");
  CHECK(table.rows() == "integer 1 'first' NULL");
}

TEST_CASE("A statement takes exactly as many values as it has") {
  Table table;
  auto insert = sqlite::Statement::insert(table.connection, "t", "a, b");
  insert.run(1, 2);
  CHECK_THROWS_AS(insert.run(3), std::logic_error);
  CHECK_THROWS_AS(insert.run(3, 4, 5), std::logic_error);
  CHECK(table.rows() == "integer 1 2 NULL");
}
