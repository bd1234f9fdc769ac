// Watches plugins on disk while a world runs.
//
//   build::Watch watch(places);              // libraries, directories, and sources to compile
//   simulation::Simulation simulation(world, watch.host());
//   while (...) {
//     if (auto renewal = watch.take()) {     // costs nothing if there is none
//       simulation.replace_plugins(*renewal->host);
//       watch.accept(std::move(*renewal));
//     }
//     simulation.step();
//   }
//
// A thread checks the files a few times a second for replaced libraries and edited sources and
// headers. It compiles and loads what has changed, and provides a new host that shares the other
// plugins with the old one. The thread takes no signals. A library that crashes while it is loaded
// ends the process, and one that never finishes loading blocks the watcher, and its end: therefore
// a program may have changed files tried in another process first (Trial).
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "elsie/plugin/host.h"

namespace elsie::build {

/// Changes on disk.
struct Renewal {
  /// All plugins, with changed ones in their new form; none when no change is usable.
  std::shared_ptr<const plugin::Host> host;
  std::vector<std::filesystem::path> files;  // new in it, as the user names them
  /// Why changes are not usable: the compiler's messages, a different ABI, a file that is no
  /// library any more. `host` still has the old versions.
  std::vector<std::string> problems;
  std::vector<std::filesystem::path> kept;  // files whose old version stays in use
  /// Files that were among the kept ones, and are again as the version in use.
  std::vector<std::filesystem::path> restored = {};
};

/// A watcher, to be used by one thread in addition to its own.
class Watch {
 public:
  static constexpr std::chrono::milliseconds kPeriod{200};

  /// Loads a library or script in a process of its own. Returns "" if that ends, else what
  /// happened: the first line follows the file's name, others may give details. `known_as`: the
  /// file as the user names it. `stop` ends the process: the watch ends, or a file has changed
  /// again.
  using Trial = std::function<std::string(const std::filesystem::path& file,
                                          const std::filesystem::path& known_as,
                                          const std::stop_token& stop)>;

  /// Compiles and loads all places, as plugin::Host does; a place may also be a source file
  /// (is_source()). Libraries are loaded as private copies, so that their files may be overwritten.
  /// `period` is the time between checks; a changed file is read once two checks find it the same.
  /// Throws what build_source() throws.
  ///
  /// `drafts`: sources and scripts that somebody is writing. What is wrong with one is in the first
  /// renewal instead of an exception, and it is used from the first version on that is right.
  ///
  /// `trial`: every file that has changed, or is new, is tried by it before it is loaded.
  explicit Watch(std::vector<plugin::SearchDirectory> places,
                 std::chrono::milliseconds period = kPeriod,
                 const std::vector<std::filesystem::path>& drafts = {}, Trial trial = {});
  /// Ends a running compiler or trial; waits for a library that is being loaded.
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  /// The plugins in use: the first ones, or those of the renewal accepted last.
  const plugin::Host& host() const;
  /// Adds a draft, after all other places. The next renewal that names it in `files` or in `kept`
  /// says whether it is used. A file that is watched already is not added again.
  void add(const std::filesystem::path& draft);
  /// All changes since the last call; none if there are none.
  std::optional<Renewal> take();
  /// Makes the renewal's host the one in use. A renewal that is not accepted is dropped; its files
  /// are checked again after their next change.
  void accept(Renewal renewal);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace elsie::build
