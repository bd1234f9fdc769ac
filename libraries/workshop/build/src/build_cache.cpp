#include "build_cache.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>

#include <unistd.h>

#include "elsie/files/write_whole.h"

#include "own_folder.h"

namespace elsie::build {
namespace {

namespace fs = std::filesystem;

/// The names of scratch files: "new.", the process that writes them, and a suffix.
constexpr std::string_view kScratch = "new.";

/// Whether the process that wrote a scratch file has ended.
bool is_left_behind(const std::string& name) {
  pid_t process = 0;
  const char* const number = name.data() + std::min(kScratch.size(), name.size());
  const auto read = std::from_chars(number, name.data() + name.size(), process);
  return name.starts_with(kScratch) && read.ec == std::errc() && process > 0 &&
         kill(process, 0) != 0 && errno == ESRCH;
}

/// The files of a folder of the cache, the last used first. None if it contains other files: then
/// it does not belong to the cache.
std::vector<fs::path> cached_files(const fs::path& folder) {
  std::vector<std::pair<fs::file_time_type, fs::path>> found;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    const bool known =
        name == "inputs" || name.starts_with(kScratch) || at->path().extension() == ".so";
    if (!known || !at->is_regular_file(error)) {
      return {};
    }
    found.emplace_back(at->last_write_time(error), at->path());
  }
  std::sort(found.rbegin(), found.rend());
  std::vector<fs::path> files;
  for (auto& [time, file] : found) {
    files.push_back(std::move(file));
  }
  return files;
}

/// Removes what was not used for a long time. Processes that use it keep it in memory.
void sweep(const fs::path& cache) {
  const auto limit = fs::file_time_type::clock::now() - std::chrono::hours(24 * kCacheDays);
  std::error_code error;
  std::vector<fs::path> folders;
  for (fs::directory_iterator at(cache, error), end; !error && at != end; at.increment(error)) {
    if (fs::exists(at->path() / "inputs", error) &&
        fs::last_write_time(at->path() / "inputs", error) < limit) {
      folders.push_back(at->path());
    }
  }
  for (const fs::path& folder : folders) {
    for (const fs::path& file : cached_files(folder)) {
      fs::remove(file, error);
    }
    fs::remove(folder, error);  // if it is empty
  }
}

}  // namespace

CacheEntry::CacheEntry(const fs::path& source, const std::string& compiler, const fs::path& cache)
    : cache_(own_folder(cache, kCompiledPlugins)),
      folder_(own_folder(cache_ / (source.stem().string() + '-' +
                                   Hash().add(source.string()).add(compiler).text()),
                         kCompiledPlugins)),
      stem_(source.stem().string()) {}

std::optional<SourceBuild> CacheEntry::find() const {
  std::ifstream record(folder_ / "inputs");
  SourceBuild build;
  build.from_cache = true;
  std::string library_hash, name;
  if (!is_own_file(folder_ / "inputs") || !(record >> library_hash) ||
      !std::getline(record >> std::ws, name)) {
    return std::nullopt;
  }
  build.library = folder_ / name;
  for (std::string hash, file; record >> hash && std::getline(record >> std::ws, file);) {
    const auto content = content_of(file);
    if (!content || Hash().add(*content).text() != hash) {
      return std::nullopt;
    }
    build.inputs.emplace_back(file);
  }
  // Nobody else can replace the library before it is loaded: see own_folder().
  const auto content = is_own_file(build.library) ? content_of(build.library) : std::nullopt;
  if (!content || Hash().add(*content).text() != library_hash) {
    return std::nullopt;
  }
  std::error_code ignored;  // the cache may be read-only
  const auto now = fs::file_time_type::clock::now();
  fs::last_write_time(folder_ / "inputs", now, ignored);
  return build;
}

fs::path CacheEntry::scratch(const char* suffix) const {
  return folder_ / (std::string(kScratch) + std::to_string(getpid()) + suffix);
}

std::vector<fs::path> CacheEntry::last_inputs() const {
  std::vector<fs::path> inputs;
  std::ifstream record(folder_ / "inputs");
  std::string name;
  std::getline(record, name);
  for (std::string hash, file; record >> hash && std::getline(record >> std::ws, file);) {
    inputs.emplace_back(file);
  }
  return inputs;
}

SourceBuild CacheEntry::keep(const fs::path& library, std::vector<fs::path> inputs,
                             const Sight& sight) const {
  Hash all;
  std::string record;
  for (const fs::path& file : inputs) {
    const std::string& hash = sight.at(file).hash;
    all.add(hash);
    record += hash + ' ' + file.string() + '\n';
  }
  const std::string name = stem_ + '-' + all.text() + ".so";
  const std::string library_hash = Hash().add(content_of(library).value_or("")).text();
  fs::rename(library, folder_ / name);
  files::write_whole_or_throw(folder_ / "inputs", library_hash + ' ' + name + '\n' + record);
  tidy(folder_ / name);
  return {folder_ / name, std::move(inputs), false, {}};
}

/// Removes surplus libraries, and files that killed compilers left behind.
void CacheEntry::tidy(const fs::path& newest) const {
  std::size_t libraries = 1;
  std::error_code ignored;
  for (const fs::path& file : cached_files(folder_)) {
    const std::string name = file.filename().string();
    const bool is_scratch = name.starts_with(kScratch);
    if (is_scratch ? is_left_behind(name)
                   : file.extension() == ".so" && file != newest && ++libraries > kMostBuilds) {
      fs::remove(file, ignored);
    }
  }
  sweep(cache_);
}

}  // namespace elsie::build
