#include "elsie/batch/results_database.h"

#include <optional>
#include <system_error>
#include <utility>

#include "difference.h"
#include "file_identity.h"
#include "lock_file.h"
#include "read_run.h"
#include "stages.h"
#include "write_plan.h"
#include "write_run.h"

namespace elsie::batch {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& file, sqlite::Connection& connection,
                         const StoredGrid& stored, const Plan& plan, bool extend) {
  const std::string why = difference(connection, stored, plan);
  throw DatabaseRefused(
      "the database '" + file.string() +
      (extend ? "' cannot be extended to '" + plan.file + "': " + why +
                    "; levels, worlds and seeds may be added, and all others must stay as they are"
              : "' belongs to another experiment than '" + plan.file + "' is now: " + why) +
      "; choose another --database");
}

/// The plan with the numbers of a database. Throws DatabaseRefused, with what differs, when that is
/// of another experiment or shard, or of a smaller experiment that is not to be extended.
Plan continued(const fs::path& file, sqlite::Connection& connection, const StoredGrid& stored,
               Plan plan, bool extend) {
  if (stored.factors != plan.factors || !losses(stored, plan).empty()) {
    refuse(file, connection, stored, plan, extend);
  }
  const std::string more = growth(stored, plan);
  plan = continued(stored, std::move(plan));
  if (fingerprint_of(plan, stored.stages.size()) != stored.stages.back().fingerprint) {
    refuse(file, connection, stored, plan, extend);
  }
  const std::string shard = connection.text("SELECT shard FROM about");
  if (shard != plan.shard.text()) {
    throw DatabaseRefused("the database '" + file.string() + "' has the shard " + shard +
                          " of the experiment, not " + plan.shard.text());
  }
  if (!extend && !more.empty()) {
    throw DatabaseRefused("the experiment '" + plan.file + "' has " + more +
                          " more than the database '" + file.string() +
                          "'; add them with --extend, or choose another --database");
  }
  return plan;
}

}  // namespace

class ResultsDatabase::Impl {
 public:
  Impl(fs::path file, std::optional<LockFile> lock, sqlite::Connection connection, Plan plan)
      : plan_(std::move(plan)),
        file_(std::move(file)),
        lock_(std::move(lock)),
        connection_(std::move(connection)),
        identity_(FileIdentity::of(file_)) {}

  ~Impl() {
    if (lock_) {
      // The finished database is one plain file, readable in folders without write permission.
      connection_.try_to_run("PRAGMA journal_mode = DELETE");
    }
  }

  template <class Action>
  auto reading(Action action) {
    return results::guarded(file_, "could not be read", action);
  }
  template <class Action>
  auto writing(Action action) {
    return results::guarded(file_, "could not be written", action);
  }

  /// The rows of a query, each made into one thing.
  template <class Make, class... Values>
  auto list(const std::string& query, Make make, Values... values) {
    return reading([&] {
      std::vector<decltype(make(std::declval<const sqlite::Statement&>()))> all;
      sqlite::Statement rows(connection_, query);
      [[maybe_unused]] int place = 1;
      (rows.bind(place++, values), ...);
      while (rows.next()) {
        all.push_back(make(rows));
      }
      return all;
    });
  }

  /// Throws DatabaseError if the file was moved or removed.
  void require_in_place() {
    const auto now = FileIdentity::of(file_);
    if (now == identity_) {
      return;
    }
    // While the file is open, the log's content goes into it, wherever it is now.
    connection_.try_to_run("PRAGMA wal_checkpoint(TRUNCATE)");
    const std::int64_t ended = reading(
        [&] { return connection_.integer("SELECT count(*) FROM runs WHERE state <> 'pending'"); });
    const std::string results = ended == 1
                                    ? "the result of 1 run is "
                                    : "the results of " + std::to_string(ended) + " runs are ";
    const auto elsewhere = identity_ ? name_of_open_file(*identity_) : std::nullopt;
    throw DatabaseError(
        (now ? "another file has taken the place of the database '" + file_.string() + "'"
             : "the database '" + file_.string() + "' was " + (elsewhere ? "renamed" : "removed")) +
        " while the batch wrote it; " +
        (elsewhere ? results + "in '" + elsewhere->string() +
                         "': put it back where it was before the batch continues"
                   : results + "lost; the batch must start again"));
  }

  const Plan plan_;
  std::int64_t added_runs_ = 0;
  fs::path file_;
  std::optional<LockFile> lock_;  // released after the connection is closed
  sqlite::Connection connection_;

 private:
  std::optional<FileIdentity> identity_;
};

ResultsDatabase::ResultsDatabase(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ResultsDatabase::ResultsDatabase(ResultsDatabase&&) noexcept = default;
ResultsDatabase::~ResultsDatabase() = default;

const fs::path& ResultsDatabase::file() const { return impl_->file_; }

const Plan& ResultsDatabase::plan() const { return impl_->plan_; }

std::int64_t ResultsDatabase::added_runs() const { return impl_->added_runs_; }

ResultsDatabase ResultsDatabase::create(const fs::path& file, Plan plan) {
  LockFile lock(file);
  if (!results::is_vacant(file)) {
    results::open_to_read(file);  // reports a file that is not a database
    throw DatabaseRefused("there is a database '" + file.string() +
                          "' already; continue it with --resume, or choose another --database");
  }
  try {
    sqlite::Connection connection = results::make_database(file);
    results::guarded(file, "could not be written", [&] {
      {
        sqlite::Transaction transaction(connection);
        write_plan(connection, plan);
        add_runs(connection, plan);
        transaction.commit();
      }
      results::prepare_for_writing(connection);
    });
    return ResultsDatabase(
        std::make_unique<Impl>(file, std::move(lock), std::move(connection), std::move(plan)));
  } catch (...) {
    std::error_code ignored;
    fs::remove(file, ignored);
    fs::remove(file.string() + "-journal", ignored);
    throw;
  }
}

ResultsDatabase ResultsDatabase::continue_in(const fs::path& file, Plan plan, bool extend) {
  LockFile lock(file);
  sqlite::Connection connection = results::open_to_write(file);
  return results::guarded(file, "could not be written", [&] {
    const StoredGrid stored = stored_grid(connection, file);
    plan = continued(file, connection, stored, std::move(plan), extend);
    results::prepare_for_writing(connection);
    sqlite::Transaction transaction(connection);
    renew_plan(connection, plan, stored.stages.size());
    add_runs(connection, plan);
    transaction.commit();
    auto impl =
        std::make_unique<Impl>(file, std::move(lock), std::move(connection), std::move(plan));
    impl->added_runs_ = impl->plan_.all_runs - stored.stages.back().runs;
    return ResultsDatabase(std::move(impl));
  });
}

ResultsDatabase ResultsDatabase::resume(const fs::path& file, Plan plan) {
  return continue_in(file, std::move(plan), false);
}

ResultsDatabase ResultsDatabase::extend(const fs::path& file, Plan plan) {
  return continue_in(file, std::move(plan), true);
}

ResultsDatabase ResultsDatabase::open(const fs::path& file) {
  return ResultsDatabase(
      std::make_unique<Impl>(file, std::nullopt, results::open_to_read(file), Plan{}));
}

std::vector<std::int64_t> ResultsDatabase::pending() {
  return impl_->list("SELECT id FROM runs WHERE state = 'pending' ORDER BY id",
                     [](const sqlite::Statement& row) { return row.integer(0); });
}

void ResultsDatabase::require_in_place() { impl_->require_in_place(); }

void ResultsDatabase::write(std::int64_t run, const RunRecord& record) {
  require_in_place();
  if (!impl_->writing([&] { return write_run(impl_->connection_, run, record); })) {
    throw DatabaseError("run " + std::to_string(run) + " is not pending in the database '" +
                        file().string() + "'; was it changed by another program?");
  }
}

std::int64_t ResultsDatabase::redo_failed() {
  return impl_->writing([&] {
    sqlite::Connection& connection = impl_->connection_;
    sqlite::Transaction transaction(connection);
    const std::string failed = "(SELECT id FROM runs WHERE state NOT IN ('pending', 'done'))";
    for (const char* table : {"run_measures", "run_robots", "run_events", "trajectories", "curves",
                              "timelines", "notes"}) {
      connection.run("DELETE FROM " + std::string(table) + " WHERE run_id IN " + failed);
    }
    // Of two assignments to `state`, SQLite uses the last.
    connection.run("UPDATE runs SET " + results::field_names(" = NULL") +
                   ", ended = NULL, state = 'pending' "
                   "WHERE state NOT IN ('pending', 'done')");
    const std::int64_t count = connection.changes();
    transaction.commit();
    return count;
  });
}

std::vector<CellCount> ResultsDatabase::cells() {
  return impl_->list(
      "SELECT label, sum(state = 'pending'), sum(state = 'done'), "
      "sum(coalesce(outcome = 'success', 0)), sum(state NOT IN ('pending', 'done')) "
      "FROM cells JOIN runs ON cells.id = runs.cell_id GROUP BY cells.id ORDER BY place, cells.id",
      [](const sqlite::Statement& row) {
        return CellCount{row.text(0), row.integer(1), row.integer(2), row.integer(3),
                         row.integer(4)};
      });
}

SeedCount ResultsDatabase::seeds() {
  return impl_
      ->list(
          "SELECT count(*), coalesce(sum(pending = 0), 0) FROM (SELECT sum(state = 'pending') AS "
          "pending FROM runs WHERE repetition = 1 GROUP BY seed)",
          [](const sqlite::Statement& row) {
            return SeedCount{row.integer(0), row.integer(1)};
          })
      .front();
}

std::vector<FailedRun> ResultsDatabase::failed(std::size_t most) {
  return impl_->list(
      "SELECT runs.id, state, label, seed, message FROM runs JOIN cells ON cells.id = "
      "runs.cell_id WHERE state NOT IN ('pending', 'done') ORDER BY runs.id LIMIT ?",
      [](const sqlite::Statement& row) {
        return FailedRun{row.integer(0), results::run_state(row.text(1)), row.text(2),
                         static_cast<std::uint64_t>(row.integer(3)), row.text(4)};
      },
      static_cast<std::int64_t>(most));
}

std::vector<Disagreement> ResultsDatabase::disagreements() {
  return impl_->reading([&] {
    std::vector<Disagreement> found;
    sqlite::Statement query(
        impl_->connection_,
        "SELECT label, seed, runs.id, cell_id FROM runs JOIN cells ON cells.id = runs.cell_id "
        "WHERE (cell_id, seed) IN (SELECT cell_id, seed FROM runs WHERE state = 'done' "
        "GROUP BY cell_id, seed HAVING count(DISTINCT state_hash) > 1) "
        "AND state = 'done' ORDER BY runs.id");
    std::map<std::pair<std::int64_t, std::int64_t>, std::size_t> places;
    while (query.next()) {
      const auto [at, is_new] =
          places.try_emplace({query.integer(3), query.integer(1)}, found.size());
      if (is_new) {
        found.push_back({query.text(0), static_cast<std::uint64_t>(query.integer(1)), {}});
      }
      found[at->second].runs.push_back(query.integer(2));
    }
    return found;
  });
}

std::optional<StoredRun> ResultsDatabase::run(std::int64_t id) {
  return impl_->reading([&] { return read_run(impl_->connection_, id); });
}

std::string ResultsDatabase::why_no_run(std::int64_t id) {
  return impl_->reading([&] {
    sqlite::Connection& connection = impl_->connection_;
    const std::int64_t all = connection.integer("SELECT runs FROM about");
    const std::string shard = connection.text("SELECT shard FROM about");
    const std::string none =
        "the database '" + file().string() + "' has no run " + std::to_string(id) + ": ";
    if (id < 1 || id > all) {
      return none + "the runs of its experiment have numbers from 1 to " + std::to_string(all);
    }
    if (const auto own = parse_shard(shard); own && !own->has(id)) {
      const Shard of_run{static_cast<std::size_t>(id - 1) % own->of + 1, own->of};
      return none + "it has the shard " + shard + " of the experiment, and this run is in shard " +
             of_run.text();
    }
    return none + "it was merged from databases that do not have it; do it with `elsie batch " +
           "EXPERIMENT --database " + file().string() + " --resume`";
  });
}

}  // namespace elsie::batch
