#include "difference.h"

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "elsie/base/number_text.h"
#include "elsie/base/words.h"
#include "elsie/results/hash.h"

namespace elsie::batch {
namespace {

constexpr std::size_t kMostNamed = 5;

// The changes, each in a few words.
using Changes = std::vector<std::string>;

// "1a2b3c4d, now 5e6f7a8b"
std::string hashes(const std::string& before, const std::string& now) {
  constexpr std::size_t kEnough = 8;
  return "SHA-256 " + before.substr(0, kEnough) + ", now " + now.substr(0, kEnough);
}

// "libode" of "/usr/lib/libode.so.8.1.0"
std::string stem(const std::string& path) {
  const std::string name = std::filesystem::path(path).filename().string();
  return name.substr(0, name.find(".so"));
}

using Hashes = std::map<std::string, std::string>;  // by path

Hashes known_files(sqlite::Connection& connection, const Plan& plan) {
  Hashes known;
  sqlite::Statement rows(connection, "SELECT path, sha256 FROM files WHERE kind <> 'world'");
  while (rows.next()) {
    known[rows.text(0)] = rows.text(1);
  }
  // A plugin's library may have another name now.
  sqlite::Statement plugins(connection,
                            "SELECT plugins.kind, name, sha256 FROM plugins "
                            "JOIN files ON files.id = file_id");
  while (plugins.next()) {
    for (const PlannedPlugin& plugin : plan.plugins) {
      if (plugin.file && plugin.kind == plugins.text(0) && plugin.name == plugins.text(1)) {
        known.try_emplace(plan.files[*plugin.file].path, plugins.text(2));
      }
    }
  }
  return known;
}

// The hash of this file before: of the same path, or else of one of the same name, preferably one
// with this content. None if it is new.
std::optional<std::string> hash_before(const Hashes& known, const PlannedFile& file) {
  if (const auto same = known.find(file.path); same != known.end()) {
    return same->second;
  }
  std::optional<std::string> before;
  for (const auto& [path, sha256] : known) {
    if (stem(path) == stem(file.path) && (!before || sha256 == file.sha256)) {
      before = sha256;
    }
  }
  return before;
}

void compare_files(sqlite::Connection& connection, const Plan& plan, Changes& changes) {
  const Hashes known = known_files(connection, plan);
  const std::set<std::size_t> program = plan.program();
  for (std::size_t i = 0; i < plan.files.size(); ++i) {
    const PlannedFile& file = plan.files[i];
    const auto before = hash_before(known, file);
    if (file.kind == FileKind::world || !before || *before == file.sha256) {
      continue;
    }
    const char* what = program.contains(i)              ? "the program's library "
                       : file.kind == FileKind::library ? "the plugin library "
                                                        : "the data file ";
    changes.push_back(what + base::name_in_quotes(file.path) + " (" + hashes(*before, file.sha256) +
                      ")");
  }
}

// Compares the worlds of the cells, with templates merged and settings made.
void compare_worlds(const StoredGrid& stored, const Plan& plan, Changes& changes) {
  std::map<std::vector<std::string>, std::string> known;  // hashes by levels
  for (const StoredGrid::Cell& cell : stored.cells) {
    known[cell.levels] = cell.sha256;
  }
  std::map<std::string, std::pair<std::string, std::size_t>>
      changed;  // by file: hashes, number of cells
  for (const PlannedCell& cell : plan.cells) {
    const auto before = known.find(cell.levels);
    if (before != known.end() && before->second != cell.sha256) {
      auto& [which, count] = changed[cell.world_file];
      which = count == 0 ? hashes(before->second, cell.sha256) : which;
      ++count;
    }
  }
  for (const auto& [file, what] : changed) {
    changes.push_back(
        "the world " + base::name_in_quotes(file) + " or what the experiment sets in it (" +
        what.first +
        (what.second > 1 ? ", in the first of " + std::to_string(what.second) + " cells" : "") +
        ")");
  }
}

}  // namespace

std::vector<std::string> losses(const StoredGrid& stored, const Plan& plan) {
  Changes changes;
  const Gone gone = gone_from(stored, plan);
  if (!gone.cells.empty()) {
    std::vector<std::string> quoted;
    for (const std::string& cell : gone.cells) {
      quoted.push_back(base::name_in_quotes(cell));
    }
    changes.push_back((quoted.size() == 1 ? "the cell " : "the cells ") + base::listed(quoted) +
                      " (removed)");
  }
  if (!gone.seeds.empty()) {
    changes.push_back((gone.seeds.size() == 1 ? "the seed " : "the seeds ") +
                      seeds_text(gone.seeds) + " (removed)");
  }
  if (gone.repeats > 0) {
    changes.push_back("the repetitions of each run (fewer)");
  }
  return changes;
}

std::string growth(const StoredGrid& stored, const Plan& plan) {
  const Stage& last = stored.stages.back();
  const Stage& now = plan.stages.back();
  Changes more;
  if (now.cells > last.cells) {
    more.push_back(base::counted(now.cells - last.cells, "cell"));
  }
  if (now.seeds.size() > last.seeds.size()) {
    more.push_back(base::counted(now.seeds.size() - last.seeds.size(), "seed"));
  }
  if (now.repeats > last.repeats) {
    more.push_back(
        base::counted(static_cast<std::uint64_t>(now.repeats - last.repeats), "repetition") +
        " of each run");
  }
  return base::enumerated(more);
}

std::string difference(sqlite::Connection& connection, const StoredGrid& stored, const Plan& plan) {
  const std::string version = connection.text("SELECT elsie_version FROM about");
  if (version != plan.elsie_version) {
    return "it was begun with Elsie " + version + ", and this is " + plan.elsie_version;
  }
  if (stored.factors != plan.factors) {
    return "its factors are " + base::enumerated(stored.factors) + ", and now " +
           base::enumerated(plan.factors);
  }
  Changes changes = losses(stored, plan);
  compare_worlds(stored, plan, changes);
  compare_files(connection, plan, changes);
  sqlite::Statement period(connection, "SELECT trajectory_period_s FROM about");
  period.next();
  if (period.number(0) != plan.trajectory_period_s) {
    changes.push_back("the period of the trajectories (" + base::seconds_text(period.number(0)) +
                      ", now " + base::seconds_text(plan.trajectory_period_s) + ")");
  }
  if (const std::string text = connection.text("SELECT text FROM about");
      changes.empty() && text != plan.text) {
    changes.push_back("the experiment file " + base::name_in_quotes(plan.file) + " (" +
                      hashes(results::sha256(text), results::sha256(plan.text)) + ")");
  }
  std::string list;
  for (std::size_t i = 0; i < changes.size() && i < kMostNamed; ++i) {
    list += (i > 0 ? "; " : "") + changes[i];
  }
  if (changes.size() > kMostNamed) {
    list += "; and " + std::to_string(changes.size() - kMostNamed) + " more";
  }
  return list.empty() ? "its plugins, their versions, or the libraries of Elsie or ODE differ"
                      : "changed since it was begun: " + list;
}

}  // namespace elsie::batch
