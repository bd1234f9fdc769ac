// Opening files that are databases of results, and others.
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>

#include <catch2/catch.hpp>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support.h"

using namespace elsie;
using Catch::Contains;
using test::refusal;
namespace fs = std::filesystem;

TEST_CASE("A database is opened to read and to write") {
  const test::Folder folder;
  const std::string file = test::made_database(folder);
  CHECK(results::open_to_read(file).integer("SELECT count(*) FROM runs") == 10);
  auto connection = results::open_to_write(file);
  connection.run("UPDATE about SET experiment = 'other'");
  CHECK(results::open_to_read(file).text("SELECT experiment FROM about") == "other");
  CHECK_THROWS_AS(results::open_to_read(file).run("DELETE FROM notes"), results::sqlite::Error);
}

TEST_CASE("Files that are no database of results are refused in a sentence, and left alone") {
  const test::Folder folder;
  const auto refused = [&](const std::string& file, const std::string& why) {
    CAPTURE(file);
    CHECK_THAT(refusal(file), Contains("'" + file + "'" + why));
    CHECK_THROWS_AS(results::open_to_write(file), results::DatabaseRefused);
    CHECK_FALSE(fs::exists(file + "-journal"));
  };
  refused(folder.file("none.sqlite"), "; `elsie batch EXPERIMENT --database FILE` writes one");
  CHECK_FALSE(fs::exists(folder.file("none.sqlite")));
  fs::create_directory(folder.file("folder"));
  refused(folder.file("folder"), " is a directory; expected a database that `elsie batch` has");
  REQUIRE(mkfifo(folder.file("pipe").c_str(), 0600) == 0);
  refused(folder.file("pipe"), " is a pipe, not a file; expected");
  refused(folder.write("empty", ""), " is empty; expected");
  const std::string text(5000, 'x');
  refused(folder.write("text", text), " is not an SQLite database; expected");
  CHECK(folder.read("text") == text);
  test::rows(folder.file("other"), "CREATE TABLE about (id INTEGER)");
  refused(folder.file("other"), " is a database of another program; expected");
  const std::string newer = test::made_database(folder, "newer");
  test::rows(newer, "PRAGMA user_version = 7");
  refused(newer, " has version 7 of the schema, and this program reads version 6; use the program");
  const std::string unplanned = test::made_database(folder, "unplanned");
  test::rows(unplanned, "DELETE FROM about");
  refused(unplanned, " was not begun: its batch ended before the runs were planned; remove it and");
}

TEST_CASE("A database can be begun in a new or empty file") {
  const test::Folder folder;
  CHECK(results::is_vacant(folder.file("none")));
  CHECK(results::is_vacant(folder.write("empty", "")));
  CHECK_FALSE(results::is_vacant(folder.write("text", "text")));
  CHECK_FALSE(results::is_vacant(test::made_database(folder)));
  CHECK_FALSE(results::is_vacant(folder.file("")));
  CHECK_FALSE(results::is_vacant("/dev/null"));  // SQLite takes it for an empty database
}

TEST_CASE("Names may contain characters that are special in URIs") {
  const test::Folder folder;
  for (const char* name : {"a?immutable=1", "50%41.sqlite", "#1.sqlite"}) {
    const std::string file = test::made_database(folder, name);
    CHECK(fs::exists(file));
    CHECK(refusal(file).empty());
    const results::sqlite::Connection immutable(file, results::sqlite::Connection::Mode::immutable);
  }
}

namespace {

/// The result of `look` for a user without write permission in `folder`.
template <class Look>
int where_nothing_can_be_written(const std::string& folder, Look look) {
  fs::permissions(folder, fs::perms(0555));
  const pid_t child = fork();
  if (child == 0) {
    const bool other = geteuid() != 0 || setuid(65534) == 0;  // root may write everywhere
    _exit(other ? look() : 99);
  }
  int status = 0;
  waitpid(child, &status, 0);
  fs::permissions(folder, fs::perms::owner_all);
  return WEXITSTATUS(status);
}

}  // namespace

TEST_CASE("A database in WAL mode can be read in a read-only folder") {
  const test::Folder folder;
  const std::string file = test::made_database(folder);
  test::rows(file, "PRAGMA journal_mode = WAL");
  fs::permissions(file, fs::perms(0444));
  const auto read = [&] {
    try {
      return results::open_to_read(file).integer("SELECT count(*) FROM runs") == 10 ? 42 : 1;
    } catch (const results::DatabaseRefused& error) {
      const std::string why = error.what();
      return why.find("its log '" + file + "-wal' is not written back") != std::string::npos ? 43
                                                                                             : 2;
    }
  };
  CHECK(where_nothing_can_be_written(folder.file(""), read) == 42);
  std::ofstream(file + "-wal") << "what is not written back yet";
  CHECK(where_nothing_can_be_written(folder.file(""), read) == 43);
}

TEST_CASE("What a killed process left incomplete is undone, and is no damage") {
  const test::Folder folder;
  const std::string file = test::made_database(folder);
  const pid_t child = fork();
  if (child == 0) {
    auto connection = results::open_to_write(file);
    connection.run(
        "PRAGMA cache_size = 1; BEGIN; UPDATE runs SET message = 'half'; "
        "UPDATE trajectories SET poses = '[]'");
    kill(getpid(), SIGKILL);
  }
  int status = 0;
  waitpid(child, &status, 0);
  REQUIRE(fs::exists(file + "-journal"));
  CHECK(results::open_to_read(file).integer("SELECT count(message) FROM runs") == 0);
}

TEST_CASE("A database is a file, also where its name looks like a URI") {
  const test::Folder folder;
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  for (const char* name : {"file:abc.db", ":memory:", "file:x?mode=memory"}) {
    CAPTURE(name);
    results::make_database(name).run("CREATE TABLE a (b INTEGER)");
    CHECK(fs::exists(name));
  }
  fs::current_path(before);
}
