#include "elsie/batch/merge.h"

#include <algorithm>
#include <iterator>
#include <string>

#include "elsie/batch/results_database.h"
#include "elsie/files/outputs.h"
#include "elsie/results/database_file.h"

#include "lock_file.h"
#include "write_plan.h"

namespace elsie::batch {
namespace {

namespace fs = std::filesystem;
namespace sqlite = results::sqlite;
using sqlite::Connection;
using sqlite::Statement;

constexpr const char* kOfExperiment[] = {"about",      "factors", "stages",      "files",
                                         "plugins",    "cells",   "cell_levels", "cell_plugins",
                                         "cell_files", "layouts"};
constexpr const char* kOfRun[] = {"run_measures", "run_robots", "run_events", "trajectories",
                                  "curves",       "timelines",  "notes"};

/// The states of a run, in ascending order of precedence.
constexpr const char* kByWeight[] = {"pending", "error", "hang", "crash", "fault", "done"};

/// Copies rows of a table with any columns, in whatever order the two databases have them.
class Copier {
 public:
  Copier(Connection& from, Connection& to, const std::string& table, const std::string& where = "")
      : select_(from, "SELECT * FROM " + table + where),
        insert_(Statement::insert(to, table, select_.column_names())) {}

  void copy() {
    while (select_.next()) {
      for (int column = 0; column < select_.columns(); ++column) {
        insert_.bind_value(column + 1, select_, column);
      }
      insert_.run();
    }
  }
  void copy(std::int64_t key) {
    select_.bind(1, key);
    copy();
  }

 private:
  Statement select_;
  Statement insert_;
};

std::string runs_query() {
  return "SELECT id, state, state_hash, outcome, json_array(" + results::field_names() +
         ", ended) FROM runs";
}

/// If two databases have a run, the state with the greater weight wins.
int weight(const std::string& state) {
  const auto* const begin = std::begin(kByWeight);
  return static_cast<int>(std::find(begin, std::end(kByWeight), state) - begin);
}

/// Copies the runs of one database into the merged one.
class Merger {
 public:
  Merger(const fs::path& file, Connection& from, Connection& to)
      : file_(file),
        from_(from),
        to_(to),
        run_(from, to, "runs", " WHERE id = ?"),
        known_(to, runs_query() + " WHERE id = ?"),
        forget_(to, "DELETE FROM runs WHERE id = ?") {
    for (const char* table : kOfRun) {
      of_run_.emplace_back(from, to, table, " WHERE run_id = ?");
    }
  }

  /// Returns how many runs have ended both here and in an earlier database.
  std::int64_t add() {
    std::int64_t duplicates = 0;
    add_measures();
    Statement runs(from_, runs_query() + " ORDER BY id");
    while (runs.next()) {
      duplicates += add(runs) ? 1 : 0;
    }
    return duplicates;
  }

 private:
  void add_measures() {
    Statement insert(to_,
                     "INSERT INTO measures (name, unit, meaning) VALUES (?, ?, ?) ON CONFLICT "
                     "(name) DO UPDATE SET unit = min(unit, excluded.unit), meaning = "
                     "min(meaning, excluded.meaning)");
    Statement measures(from_, "SELECT name, unit, meaning FROM measures");
    while (measures.next()) {
      insert.run(measures.text(0), measures.text(1), measures.text(2));
    }
  }

  /// Returns whether the run has ended both here and in an earlier database.
  bool add(const Statement& run) {
    const std::int64_t id = run.integer(0);
    known_.bind(1, id);
    bool twice = false;
    if (known_.next()) {
      const int before = weight(known_.text(1)), here = weight(run.text(1));
      const bool same_end = known_.text(2) == run.text(2) && known_.text(3) == run.text(3);
      // With equal weights the lesser text wins, so that the order of databases does not matter.
      const bool better = here > before || (here == before && run.text(4) < known_.text(4));
      while (known_.next()) {
      }
      if (here == before && !same_end) {
        throw DatabaseRefused(
            "run " + std::to_string(id) + " has another result in '" + file_.string() +
            "' than in an earlier database; the same run must have the same result "
            "everywhere. Were they made on machines that compute differently?");
      }
      twice = before > 0 && here > 0;
      if (!better) {
        return twice;
      }
      forget_.run(id);  // including its rows in other tables
    }
    run_.copy(id);
    for (Copier& table : of_run_) {
      table.copy(id);
    }
    return twice;
  }

  const fs::path& file_;
  Connection& from_;
  Connection& to_;
  Copier run_;
  std::vector<Copier> of_run_;
  Statement known_;
  Statement forget_;
};

/// Refuses invalid names before anything is locked or created, and what is no file before anything
/// is opened: a reader of a pipe would wait.
void require_databases(const fs::path& into, const std::vector<fs::path>& databases) {
  files::require_apart({{"OUT", into}}, databases);
  for (auto file = databases.begin(); file != databases.end(); ++file) {
    results::require_file(*file);
    const auto same = std::find_if(databases.begin(), file, [&](const fs::path& other) {
      return files::is_same_file(other, *file);
    });
    if (same != file) {
      throw DatabaseRefused(*same == *file ? "the database '" + file->string() +
                                                 "' is named twice; name it once"
                                           : "'" + same->string() + "' and '" + file->string() +
                                                 "' are the same database; name it once");
    }
  }
}

Connection opened(const fs::path& file) {
  if (const auto holder = LockFile::holder(file)) {
    throw DatabaseRefused("the database '" + file.string() + "' is being written by a batch (" +
                          *holder + "); wait until it has ended");
  }
  return results::open_to_read(file);
}

/// The number of stages of a database; 0 if it cannot be read, which opened() reports.
std::int64_t stages_in(const fs::path& file) {
  try {
    return Connection(file, Connection::Mode::read).integer("SELECT count(*) FROM stages");
  } catch (const sqlite::Error&) {
    return 0;
  }
}

/// Whether one experiment is the other one, or was extended to it.
bool is_part_of(Connection& from, Connection& to) {
  Statement last(from, "SELECT id, fingerprint FROM stages ORDER BY id DESC LIMIT 1");
  Statement same(to, "SELECT 1 FROM stages WHERE id = ? AND fingerprint = ?");
  return last.next() && same.bind(1, last.integer(0)).bind(2, last.text(1)).next();
}

/// Adds one database. Returns how many of its runs have also ended in earlier ones.
std::int64_t add(const fs::path& file, const fs::path& first, Connection& to) {
  Connection from = opened(file);
  if (file == first) {
    for (const char* table : kOfExperiment) {
      Copier(from, to, table).copy();
    }
  } else if (!is_part_of(from, to)) {
    throw DatabaseRefused("'" + file.string() + "' belongs to another experiment than '" +
                          first.string() +
                          "': their worlds, settings, seeds, files or plugins differ, or the "
                          "versions of Elsie");
  }
  return Merger(file, from, to).add();
}

Merged merge_into(Connection& to, const std::vector<fs::path>& databases) {
  Merged merged;
  sqlite::Transaction transaction(to);
  to.run("PRAGMA defer_foreign_keys = ON");
  results::make_schema(to);
  // First the one that was extended the most: it has the cells of all others.
  std::vector<std::int64_t> stages;
  std::transform(databases.begin(), databases.end(), std::back_inserter(stages), stages_in);
  const auto most = std::max_element(stages.begin(), stages.end()) - stages.begin();
  std::vector<fs::path> ordered = databases;
  std::rotate(ordered.begin(), ordered.begin() + most, ordered.begin() + most + 1);
  for (const fs::path& file : ordered) {
    try {
      merged.duplicates += add(file, ordered.front(), to);
    } catch (const sqlite::Error& error) {
      if (error.is_damage()) {  // the merged file is new, so the source is damaged
        throw results::damaged(file, error.what());
      }
      throw;
    }
  }
  to.run("UPDATE about SET shard = '1/1'");
  merged.all_runs = to.integer("SELECT runs FROM about");
  merged.pending = to.integer("SELECT count(*) FROM runs WHERE state = 'pending'");
  merged.missing = merged.all_runs - to.integer("SELECT count(*) FROM runs");
  transaction.commit();
  return merged;
}

}  // namespace

Merged merge(const fs::path& into, const std::vector<fs::path>& databases) {
  require_databases(into, databases);
  const LockFile lock(into);
  if (!results::is_vacant(into)) {
    std::error_code ignored;
    throw DatabaseRefused(fs::is_regular_file(into, ignored)
                              ? "there is a file '" + into.string() +
                                    "' already; remove it or choose another name"
                              : "'" + into.string() + "' is no file; choose another name");
  }
  try {
    Connection to = results::make_database(into);
    return results::guarded(into, "could not be written",
                            [&] { return merge_into(to, databases); });
  } catch (...) {
    std::error_code ignored;
    fs::remove(into, ignored);
    fs::remove(into.string() + "-journal", ignored);
    throw;
  }
}

}  // namespace elsie::batch
