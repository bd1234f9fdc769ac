// Following plugins on disk while a world runs.
//
//   build::Watch watch(places);              // libraries, directories, and sources to compile
//   simulation::Simulation simulation(world, watch.host());
//   while (...) {
//     if (auto renewal = watch.take()) {      // costs nothing while there is none
//       simulation.replace_plugins(*renewal->host);
//       watch.accept(std::move(*renewal));
//     }
//     simulation.step();
//   }
//
// A thread looks a few times a second at the files: libraries that were replaced, sources and
// headers that were edited. It compiles and loads what has changed and leaves a new host to be
// taken, in which the other plugins are the very same as in the old one. The thread takes no
// signals. A library that crashes while it is loaded brings the process down, as always; one that
// does not come to an end with it keeps the watch from ending, and from finding anything else.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "elsie/plugin/host.h"

namespace elsie::build {

/// What has changed on disk.
struct Renewal {
  /// All plugins, those that have changed in their new form; none when nothing of what has changed
  /// can be used.
  std::shared_ptr<const plugin::Host> host;
  std::vector<std::filesystem::path> files;  // what is new in it, as the user knows it
  /// What cannot be used and why: what the compiler says, an ABI that differs, a file that is no
  /// library any more. What was in use before is in `host` still.
  std::vector<std::string> problems;
  std::vector<std::filesystem::path> kept;  // of which what was there before goes on
};

/// For one thread, besides its own.
class Watch {
 public:
  static constexpr std::chrono::milliseconds kPeriod{200};

  /// Compiles and loads everything, as plugin::Host does; a place may be a source file, too
  /// (is_source()). Libraries are loaded as private copies: their files may be overwritten.
  /// `period`: from one look at the files to the next; a file is read when it was the same twice.
  /// Throws what build_source() throws.
  explicit Watch(std::vector<plugin::SearchDirectory> places,
                 std::chrono::milliseconds period = kPeriod);
  /// Ends a compiler that is at work; waits for a library that is being loaded.
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  /// The plugins as they are in use: at first, or as last accepted.
  const plugin::Host& host() const;
  /// What has changed since it was last taken, once: all of it, if it changed more than once.
  std::optional<Renewal> take();
  /// The plugins of this renewal are in use now, and host() is its host. One that is not accepted
  /// is forgotten: what has changed in it is looked at again when it changes again.
  void accept(Renewal renewal);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace elsie::build
