// The fields of a run: each stands in one place, and everything that names them follows from it.
#include <catch2/catch.hpp>

#include "elsie/results/database_file.h"
#include "elsie/results/run_fields.h"

#include "folder.h"

using Catch::Contains;
using Catch::Matchers::StartsWith;
namespace results = elsie::results;
namespace sqlite = elsie::results::sqlite;

namespace {

results::RunFields full() {
  results::RunFields run;
  run.state = results::RunState::done;
  run.outcome = results::Outcome::time_limit;
  run.message = "the time limit was met";
  run.steps = 12000;
  run.simulated_s = 120.5;
  run.state_hash = "0123456789abcdef";
  run.signal = "SIGSEGV";
  run.exit_code = 3;
  run.plugin = "wander";
  run.robot = "r1";
  run.step = 50;
  run.wall_s = 0.25;
  run.solver_gave_up = 12;
  run.solver_unsolved = 3;
  run.log = "two\nlines";
  return run;
}

/// The fields as text, "name=value;", and "name=-;" for those without a value.
std::string text_of(const results::RunFields& run) {
  elsie::test::Folder folder;
  sqlite::Connection memory(folder.file("one.sqlite"), sqlite::Connection::Mode::create);
  memory.run("CREATE TABLE one (" + results::field_columns() + ")");
  auto insert = sqlite::Statement::insert(memory, "one", results::field_names());
  const int next = results::bind_fields(insert, 1, run);
  insert.run();
  sqlite::Statement read(memory, "SELECT * FROM one");
  REQUIRE(read.next());
  REQUIRE(read.columns() == next - 1);
  std::string text;
  for (int i = 0; i < read.columns(); ++i) {
    text += (read.is_null(i) ? "-" : read.text(i)) + ";";
  }
  return text;
}

}  // namespace

TEST_CASE("The table of runs has a column for each field") {
  elsie::test::Folder folder;
  sqlite::Connection database = results::make_database(folder.file("r.sqlite"));
  results::make_schema(database);
  CHECK(database.text("SELECT group_concat(name, ' ') FROM pragma_table_info('runs')") ==
        "id cell_id seed repetition state outcome message steps simulated_s state_hash signal "
        "exit_code plugin robot step wall_s solver_gave_up solver_unsolved log ended");
}

TEST_CASE("The columns of the fields have the types of their values") {
  CHECK_THAT(results::field_columns(),
             StartsWith("state TEXT NOT NULL DEFAULT 'pending', outcome TEXT, message TEXT, "
                        "steps INTEGER, simulated_s REAL, state_hash TEXT, "));
  CHECK_THAT(results::field_columns(), Contains(", exit_code INTEGER, "));
}

TEST_CASE("A run has one of the known states and outcomes") {
  elsie::test::Folder folder;
  sqlite::Connection database = results::make_database(folder.file("r.sqlite"));
  results::make_schema(database);
  database.run("PRAGMA foreign_keys = OFF");
  const std::string insert =
      "INSERT INTO runs (id, cell_id, seed, repetition, state, outcome, ended) VALUES ";
  CHECK_NOTHROW(database.run(insert + "(1, 0, 1, 1, 'done', 'success', 'now')"));
  CHECK_THROWS_AS(database.run(insert + "(2, 0, 2, 1, 'lost', NULL, 'now')"), sqlite::Error);
  CHECK_THROWS_AS(database.run(insert + "(3, 0, 3, 1, 'done', 'draw', 'now')"), sqlite::Error);
}

TEST_CASE("Every field goes into a database and comes back") {
  elsie::test::Folder folder;
  sqlite::Connection database(folder.file("one.sqlite"), sqlite::Connection::Mode::create);
  database.run("CREATE TABLE one (" + results::field_columns() + ")");
  for (const results::RunFields& run : {full(), results::RunFields()}) {
    database.run("DELETE FROM one");
    auto insert = sqlite::Statement::insert(database, "one", results::field_names());
    CHECK(results::bind_fields(insert, 1, run) == 16);
    insert.run();
    sqlite::Statement read(database, "SELECT " + results::field_names() + " FROM one");
    REQUIRE(read.next());
    results::RunFields back;
    results::read_fields(read, 0, back);
    CHECK(text_of(back) == text_of(run));
  }
  CHECK(
      text_of(full()) ==
      "done;time_limit;the time limit was met;12000;120.5;0123456789abcdef;SIGSEGV;3;wander;r1;50;"
      "0.25;12;3;two\nlines;");
  CHECK(text_of({}) == "pending;-;;-;-;-;-;-;-;-;-;-;-;-;-;");
}

TEST_CASE("A word that is no outcome is none") {
  CHECK(results::outcome_of("failure") == results::Outcome::failure);
  CHECK(results::outcome_of("running") == std::nullopt);
  CHECK(results::outcome_of("") == std::nullopt);
}
