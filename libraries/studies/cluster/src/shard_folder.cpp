#include "elsie/cluster/shard_folder.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <unistd.h>

#include "elsie/batch/merge.h"
#include "elsie/batch/results_database.h"
#include "elsie/files/write_whole.h"
#include "elsie/process/shell_word.h"
#include "elsie/results/hash.h"

namespace fs = std::filesystem;

namespace elsie::cluster {
namespace {

using batch::DatabaseRefused;
using Json = nlohmann::ordered_json;

Json read_json(const fs::path& file) {
  std::ifstream in(file);
  return in ? Json::parse(in, nullptr, false) : Json(Json::value_t::discarded);
}

/// A number in a JSON object; 0 if it is missing.
std::int64_t number(const Json& object, const char* key) {
  return object.is_object() && object.contains(key) && object[key].is_number_integer()
             ? object[key].get<std::int64_t>()
             : 0;
}

// Different from that of any other process that sees the folder.
std::string this_process() {
  std::array<char, 256> host{};
  gethostname(host.data(), host.size() - 1);
  return std::string(host.data()) + "-" + std::to_string(getpid());
}

std::string script_text(const ShardFolder& folder, const std::vector<std::string>& command) {
  const std::string task = "\"$SLURM_ARRAY_TASK_ID\"";
  const std::string part = process::shell_word((folder.path() / "shard-").string()) + task;
  return "#!/bin/sh\n"
         "# A task of a job array does one shard, and continues when it is requeued.\n"
         "exec " +
         process::shell_line(command) + " --shard " + task + "/" + std::to_string(folder.shards()) +
         " \\\n  --database " + part + ".sqlite --progress " + part + ".json --resume --quiet\n";
}

}  // namespace

void write_count(const fs::path& file, const Count& count) {
  files::write_whole_or_throw(
      file,
      Json{{"runs", count.runs}, {"ended", count.ended}, {"failed", count.failed}}.dump() + "\n");
}

fs::path ShardFolder::path_for(const fs::path& database) {
  return fs::absolute(database).lexically_normal().string() + "-shards";
}

ShardFolder::ShardFolder(fs::path path, std::string fingerprint, std::size_t shards,
                         std::int64_t all_runs)
    : path_(std::move(path)),
      fingerprint_(std::move(fingerprint)),
      shards_(shards),
      all_runs_(all_runs),
      name_("elsie-" + results::sha256(path_.string() + '\n' + fingerprint_).substr(0, 16)) {}

ShardFolder ShardFolder::create(const fs::path& database, const batch::Plan& plan,
                                std::size_t shards, const std::vector<std::string>& command) {
  ShardFolder folder(path_for(database), plan.fingerprint, shards, plan.all_runs);
  const fs::path begun = folder.path_.string() + "-begun-" + this_process();
  const auto refuse = [&](const std::error_code& error) {
    const std::string name = "'" + folder.path_.string() + "'";
    throw DatabaseRefused(error == std::errc::directory_not_empty || error == std::errc::file_exists
                              ? "there is a folder " + name +
                                    " already, of a batch that is not complete; continue it with "
                                    "--resume, or choose another --database"
                              : "the folder " + name + " cannot be made: " + error.message());
  };
  std::error_code error;
  fs::create_directory(begun, error);
  if (error) {
    refuse(error);
  }
  try {
    files::write_whole_or_throw(begun / folder.script().filename(), script_text(folder, command));
    folder.write(begun);
    fs::rename(begun, folder.path_, error);
    if (error) {
      refuse(error);
    }
  } catch (...) {
    fs::remove_all(begun, error);
    throw;
  }
  return folder;
}

std::optional<ShardFolder> ShardFolder::find(const fs::path& database, const batch::Plan& plan) {
  const fs::path path = path_for(database);
  Json stored = read_json(path / "cluster.json");
  if (stored.is_discarded()) {
    std::error_code error;
    if (!fs::exists(path, error)) {
      return std::nullopt;
    }
    stored = read_json(path / "cluster.json");  // another command may have made it just now
  }
  std::string fingerprint, job;
  std::size_t shards = 0;
  try {
    stored.at("fingerprint").get_to(fingerprint);
    stored.at("job").get_to(job);
    stored.at("shards").get_to(shards);
  } catch (const Json::exception&) {
    shards = 0;
  }
  if (shards < 1) {
    throw DatabaseRefused("'" + (path / "cluster.json").string() +
                          "' is missing or damaged; remove the folder to start again");
  }
  if (fingerprint != plan.fingerprint) {
    throw DatabaseRefused(
        "'" + path.string() +
        "' was begun with another experiment: a world, a model, a plugin, a seed "
        "or Elsie itself has changed since; put it back, or remove the folder to start again");
  }
  ShardFolder folder(path, fingerprint, shards, plan.all_runs);
  folder.job_ = job;
  return folder;
}

fs::path ShardFolder::database(std::size_t shard) const {
  return path_ / ("shard-" + std::to_string(shard) + ".sqlite");
}

fs::path ShardFolder::log(const std::string& shard) const {
  return path_ / ("shard-" + shard + ".log");
}

void ShardFolder::set_job(const std::string& job) {
  job_ = job;
  write(path_);
}

void ShardFolder::write(const fs::path& folder) const {
  files::write_whole_or_throw(
      folder / "cluster.json",
      Json{{"shards", shards_}, {"fingerprint", fingerprint_}, {"job", job_}}.dump() + "\n");
}

std::int64_t ShardFolder::runs(std::size_t shard) const {
  // Every shards_-th run, starting at the shard-th.
  const auto all = static_cast<std::size_t>(all_runs_);
  return static_cast<std::int64_t>((all + shards_ - shard) / shards_);
}

Count ShardFolder::count() const {
  Count sum{.runs = all_runs_};
  for (std::size_t shard = 1; shard <= shards_; ++shard) {
    const Json progress = read_json(path_ / ("shard-" + std::to_string(shard) + ".json"));
    sum.ended += number(progress, "ended");
    sum.failed += number(progress, "failed");
  }
  return sum;
}

std::int64_t ShardFolder::pending(std::size_t shard) const {
  const fs::path file = database(shard);
  if (results::is_vacant(file)) {
    return runs(shard);
  }
  return static_cast<std::int64_t>(batch::ResultsDatabase::open(file).pending().size());
}

std::vector<std::size_t> ShardFolder::unfinished(const std::vector<std::size_t>& except) const {
  std::vector<std::size_t> found;
  for (std::size_t shard = 1; shard <= shards_; ++shard) {
    if (!std::binary_search(except.begin(), except.end(), shard) && pending(shard) > 0) {
      found.push_back(shard);
    }
  }
  return found;
}

void ShardFolder::merge_into(const fs::path& database) const {
  std::vector<fs::path> parts;
  for (std::size_t shard = 1; shard <= shards_; ++shard) {
    parts.push_back(this->database(shard));
  }
  batch::merge(database, parts);
}

ShardFolder::Turn::Turn(const ShardFolder& folder)
    : descriptor_(::open((folder.path_ / "turn").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0 && !folder.exists()) {
    return;  // the folder was removed: there is nothing to lock
  }
  while (descriptor_ < 0 || flock(descriptor_, LOCK_EX) != 0) {
    if (descriptor_ >= 0 && errno == EINTR) {
      continue;
    }
    const std::string why = std::generic_category().message(errno);
    if (descriptor_ >= 0) {
      close(descriptor_);
    }
    throw std::runtime_error("'" + (folder.path_ / "turn").string() +
                             "' cannot be locked, as several commands that follow one batch have "
                             "to: " +
                             why);
  }
}

ShardFolder::Turn::~Turn() {
  if (descriptor_ >= 0) {
    close(descriptor_);
  }
}

bool ShardFolder::exists() const {
  std::error_code ignored;
  return fs::exists(path_ / "cluster.json", ignored);
}

void ShardFolder::remove() const {
  // Other commands see the whole folder or none.
  const fs::path removed = path_.string() + "-removed";
  std::error_code error;
  fs::remove_all(removed, error);  // of a command that was killed while it removed one
  fs::rename(path_, removed, error);
  const fs::path& gone = error ? path_ : removed;
  fs::remove_all(gone, error);
}

}  // namespace elsie::cluster
