#include "difference.h"

#include <filesystem>
#include <map>
#include <set>
#include <utility>
#include <vector>

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

std::string in_quotes(const std::string& name) { return "'" + name + "'"; }

// Rows of a query, as a map from first to second column.
std::map<std::string, std::string> pairs(sqlite::Connection& connection, const std::string& query) {
  std::map<std::string, std::string> found;
  sqlite::Statement rows(connection, query);
  while (rows.next()) {
    found[rows.text(0)] = rows.text(1);
  }
  return found;
}

// Compares data files and libraries, then the plugins' files.
void compare_files(sqlite::Connection& connection, const Plan& plan, Changes& changes) {
  const auto known =
      pairs(connection, "SELECT path, sha256 FROM files WHERE kind <> 'world' ORDER BY id");
  std::set<std::string> named;
  for (std::size_t i = 0; i < plan.files.size(); ++i) {
    const PlannedFile& file = plan.files[i];
    const auto before = known.find(file.path);
    if (file.kind == FileKind::world || before == known.end() || before->second == file.sha256) {
      continue;
    }
    const char* what = i < plan.program_files           ? "the program's library "
                       : file.kind == FileKind::library ? "the plugin library "
                                                        : "the data file ";
    changes.push_back(what + in_quotes(file.path) + " (" + hashes(before->second, file.sha256) +
                      ")");
    named.insert(file.path);
  }
  // Libraries that have another path now.
  const auto stem = [](const std::string& path) {
    const std::string name = std::filesystem::path(path).filename().string();
    return name.substr(0, name.find(".so"));
  };
  for (std::size_t i = 0; i < plan.program_files; ++i) {
    const PlannedFile& file = plan.files[i];
    for (const auto& [path, sha256] : known) {
      if (path != file.path && stem(path) == stem(file.path) && sha256 != file.sha256 &&
          named.insert(file.path).second) {
        changes.push_back("the program's library " + in_quotes(file.path) + " (" +
                          hashes(sha256, file.sha256) + ")");
      }
    }
  }
  const auto plugins =
      pairs(connection,
            "SELECT plugins.kind || ' ' || name, coalesce(sha256, '') FROM plugins "
            "LEFT JOIN files ON files.id = file_id");
  for (const PlannedPlugin& plugin : plan.plugins) {
    const auto before = plugins.find(plugin.kind + " " + plugin.name);
    if (before == plugins.end() || !plugin.file) {
      continue;
    }
    const PlannedFile& file = plan.files[*plugin.file];
    if (before->second != file.sha256 && named.insert(file.path).second) {
      changes.push_back("the " + plugin.kind + " " + in_quotes(plugin.name) + ", which is from " +
                        in_quotes(file.path) + " (" + hashes(before->second, file.sha256) + ")");
    }
  }
  const auto data = pairs(connection,
                          "SELECT cells.label || char(10) || name, files.sha256 FROM cell_files "
                          "JOIN cells ON cells.id = cell_id JOIN files ON files.id = file_id");
  for (const PlannedCell& cell : plan.cells) {
    for (const PlannedCell::Data& one : cell.data) {
      const PlannedFile& file = plan.files[one.file];
      const auto before = data.find(cell.label + '\n' + one.name);
      if (before != data.end() && before->second != file.sha256 && named.insert(file.path).second) {
        changes.push_back("the data file " + in_quotes(file.path) + " (" +
                          hashes(before->second, file.sha256) + ")");
      }
    }
  }
}

// Compares the worlds of the cells, with templates merged and settings made.
void compare_worlds(sqlite::Connection& connection, const Plan& plan, Changes& changes) {
  const auto cells = pairs(connection, "SELECT label, sha256 FROM cells");
  std::map<std::string, std::pair<std::string, std::size_t>>
      changed;  // by file: hashes, number of cells
  std::size_t added = 0;
  for (const PlannedCell& cell : plan.cells) {
    const auto before = cells.find(cell.label);
    if (before == cells.end()) {
      ++added;
    } else if (before->second != cell.sha256) {
      auto& [which, count] = changed[cell.world_file];
      which = count == 0 ? hashes(before->second, cell.sha256) : which;
      ++count;
    }
  }
  for (const auto& [file, what] : changed) {
    changes.push_back(
        "the world " + in_quotes(file) + " or what the experiment sets in it (" + what.first +
        (what.second > 1 ? ", in the first of " + std::to_string(what.second) + " cells" : "") +
        ")");
  }
  const std::size_t removed = cells.size() + added - plan.cells.size();
  if (added > 0 || removed > 0) {
    changes.push_back("the cells (" + std::to_string(cells.size()) + ", now " +
                      std::to_string(plan.cells.size()) + "; new: " + std::to_string(added) +
                      ", gone: " + std::to_string(removed) + ")");
  }
}

}  // namespace

std::string difference(sqlite::Connection& connection, const Plan& plan) {
  const std::string version = connection.text("SELECT elsie_version FROM about");
  if (version != plan.elsie_version) {
    return "it was begun with Elsie " + version + ", and this is " + plan.elsie_version;
  }
  Changes changes;
  compare_worlds(connection, plan, changes);
  compare_files(connection, plan, changes);
  const std::int64_t runs = connection.integer("SELECT runs FROM about");
  if (runs != plan.all_runs) {
    changes.push_back("the number of runs (" + std::to_string(runs) + ", now " +
                      std::to_string(plan.all_runs) + ")");
  }
  std::set<std::int64_t> before, now;
  sqlite::Statement seeds(connection, "SELECT DISTINCT seed FROM runs");
  while (seeds.next()) {
    before.insert(seeds.integer(0));
  }
  for (const PlannedRun& run : plan.runs) {
    now.insert(static_cast<std::int64_t>(run.seed));
  }
  if (before != now && connection.text("SELECT shard FROM about") == plan.shard.text()) {
    changes.push_back("the seeds (" + std::to_string(before.size()) + ", now " +
                      std::to_string(now.size()) + ")");
  }
  if (const std::string text = connection.text("SELECT text FROM about"); text != plan.text) {
    changes.push_back("the experiment file " + in_quotes(plan.file) + " (" +
                      hashes(results::sha256(text), results::sha256(plan.text)) + ")");
  }
  std::string list;
  for (std::size_t i = 0; i < changes.size() && i < kMostNamed; ++i) {
    list += (i > 0 ? "; " : "") + changes[i];
  }
  if (changes.size() > kMostNamed) {
    list += "; and " + std::to_string(changes.size() - kMostNamed) + " more";
  }
  return list.empty()
             ? "its plugins, their versions, its seeds, or the libraries of Elsie or ODE differ"
             : "changed since it was begun: " + list;
}

}  // namespace elsie::batch
