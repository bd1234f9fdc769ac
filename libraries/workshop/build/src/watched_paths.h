// The plugins that a watch follows: which files they are, and how their sources are compiled again.
#pragma once

#include <algorithm>
#include <exception>
#include <filesystem>
#include <map>
#include <set>
#include <stop_token>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "elsie/build/source_build.h"
#include "elsie/build/watch.h"
#include "elsie/plugin/file_fingerprint.h"
#include "elsie/plugin/script.h"

namespace elsie::build {

namespace fs = std::filesystem;

/// The fingerprints of the files that exist.
using Prints = std::map<fs::path, plugin::Fingerprint>;

inline void look_at(const fs::path& file, Prints& sight) {
  if (const auto fingerprint = plugin::fingerprint_of(file)) {
    sight.insert_or_assign(file, *fingerprint);
  }
}

inline bool is_header(const fs::path& file) {
  const std::string end = file.extension().string();
  return end.starts_with(".h") || end == ".inc" || end == ".ipp" || end == ".tpp";
}

/// The wanted files of a folder; empty when it cannot be read.
template <class Wanted>
std::vector<fs::path> files_in(const fs::path& folder, Wanted wanted) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (wanted(at->path())) {
      files.push_back(at->path());
    }
  }
  return files;
}

inline bool has_changed(const fs::path& file, const Prints& before, const Prints& now) {
  const auto old = before.find(file), fresh = now.find(file);
  return (old == before.end()) != (fresh == now.end()) ||
         (old != before.end() && old->second != fresh->second);
}

/// The directories of plugins, with sources that are compiled.
class WatchedPaths {
 public:
  explicit WatchedPaths(std::vector<plugin::SearchDirectory> directories) {
    for (plugin::SearchDirectory& directory : directories) {
      watched_.push_back({std::move(directory), {}, false});
      if (is_source(watched_.back().directory.path)) {
        watched_.back().build = build_source(watched_.back().directory.path);
      }
    }
  }

  /// Compiles the draft, if it is a source that compiles; otherwise it is refused for now. `seen`
  /// gets its files as they are before they are read, unless it has them: later changes are
  /// noticed.
  void add(const fs::path& draft, const std::stop_token& stop, Renewal& renewal, Prints& seen) {
    if (std::any_of(watched_.begin(), watched_.end(),
                    [&](const WatchedPath& watched) { return watched.directory.path == draft; })) {
      return;
    }
    watched_.push_back({{draft, "--plugin"}, {}, false});
    seen.merge(look());
    if (is_source(draft)) {
      build(watched_.back(), stop, renewal);
      seen.merge(look());  // with what it includes
    }
  }

  /// The sentence on a draft that compiles, if the host has no version of it; else "".
  std::string why_refused(const fs::path& draft, const plugin::Report& report) const {
    for (std::size_t i = 0; i < watched_.size(); ++i) {
      if (watched_[i].directory.path != draft || watched_[i].is_refused) continue;
      for (const plugin::FileReport& file : report.directories[i].files) {
        if (file.status != plugin::FileStatus::loaded && !file.is_former) {
          return "'" + draft.string() + "' " + file.sentence;
        }
      }
    }
    return "";
  }

  /// Compiles sources again that were saved since; the cache has the others.
  void refresh() {
    for (WatchedPath& watched : watched_) {
      if (watched.is_compiled()) {
        watched.build = build_source(watched.directory.path);
      }
    }
  }

  /// Libraries and directories for a host.
  std::vector<plugin::SearchDirectory> directories() const {
    std::vector<plugin::SearchDirectory> directories;
    for (const WatchedPath& watched : watched_) {
      directories.push_back(watched.directory);
      if (watched.is_compiled()) {
        directories.back().source = watched.directory.path;
        directories.back().path = watched.build.library;
      }
    }
    return directories;
  }

  /// The present state of the files.
  Prints look() const {
    Prints sight;
    for (const WatchedPath& watched : watched_) {
      for (const fs::path& file : files_of(watched)) {
        look_at(file, sight);
      }
    }
    return sight;
  }

  /// Compiles changed sources; adds those that fail to the kept files, and the compiler's messages
  /// to the problems.
  void rebuild(const Prints& before, const Prints& now, const std::stop_token& stop,
               Renewal& renewal) {
    for (WatchedPath& watched : watched_) {
      if (!is_source(watched.directory.path) || stop.stop_requested()) {
        continue;
      }
      // The includes of a source that does not compile are unknown: any header next to it may be at
      // fault.
      const auto inputs = watched.is_refused ? files_of(watched) : watched.build.inputs;
      if (std::none_of(inputs.begin(), inputs.end(),
                       [&](const fs::path& input) { return has_changed(input, before, now); })) {
        continue;
      }
      build(watched, stop, renewal);
    }
  }

  /// The file by which the user knows a library.
  fs::path known_as(const fs::path& library) const {
    for (const WatchedPath& watched : watched_) {
      if (watched.build.library == library) {
        return watched.directory.path;
      }
    }
    return library;
  }

  /// Whether the present version of the file, as the user names it, is not the host's.
  bool is_behind(const fs::path& file, const plugin::Report& report) const {
    for (std::size_t i = 0; i < watched_.size(); ++i) {
      if (watched_[i].directory.path == file && watched_[i].is_refused) return true;
      for (const plugin::FileReport& each : report.directories[i].files) {
        if (each.is_former && (each.path == file || watched_[i].directory.path == file)) {
          return true;
        }
      }
    }
    return false;
  }

  /// Adds the files, as the user names them, of which a host has older versions.
  void list_kept(const plugin::Report& report, const plugin::Report& before,
                 std::vector<fs::path>& kept) const {
    const auto former = [](const plugin::Report& of) {
      std::set<std::pair<std::size_t, fs::path>> files;
      for (std::size_t i = 0; i < of.directories.size(); ++i) {
        for (const plugin::FileReport& file : of.directories[i].files) {
          if (file.is_former) {
            files.emplace(i, file.path);
          }
        }
      }
      return files;
    };
    const auto known = former(before);
    for (const auto& [i, file] : former(report)) {
      if (!known.contains({i, file})) {
        kept.push_back(!watched_[i].is_compiled() ? file : watched_[i].directory.path);
      }
    }
  }

 private:
  struct WatchedPath {
    plugin::SearchDirectory directory;
    SourceBuild build;        // of a source: the last one that compiled
    bool is_refused = false;  // the present source does not compile

    bool is_compiled() const { return !build.library.empty(); }
  };

  static void build(WatchedPath& watched, const std::stop_token& stop, Renewal& renewal) {
    watched.is_refused = true;
    try {
      watched.build = build_source(watched.directory.path, cache_directory(), stop);
      watched.is_refused = false;
    } catch (const std::exception& error) {  // also the system's errors, such as a full disk
      renewal.problems.push_back(error.what());
      renewal.kept.push_back(watched.directory.path);
    }
  }

  static std::vector<fs::path> files_of(const WatchedPath& watched) {
    const fs::path& path = watched.directory.path;
    if (!is_source(path)) {
      return plugin::may_hold_plugins(path) ? std::vector{path}
                                            : files_in(path, plugin::may_hold_plugins);
    }
    std::vector<fs::path> files =
        files_in(path.parent_path().empty() ? "." : path.parent_path(), is_header);
    files.push_back(path);  // it is no input before it has compiled once
    files.insert(files.end(), watched.build.inputs.begin(), watched.build.inputs.end());
    return files;
  }

  std::vector<WatchedPath> watched_;
};

}  // namespace elsie::build
