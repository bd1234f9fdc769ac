// The libraries of subcommands beside the program, which load what the work needs: OpenGL, cairo,
// SQLite. `elsie run` needs only the first, and only for views and for cameras. A build may lack
// the others.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "elsie/api/abi.h"
#include "elsie/simulation/camera_renderer.h"

#include "command.h"
#include "run_views.h"

namespace elsie::program {

/// What such a library exports; functions that it does not have are null.
struct CommandModule {
  const char* name;
  /// Adds the subcommands of the library.
  void (*add_commands)(CLI::App& program, Job& job) = nullptr;
  /// Throws BadInput for files that cannot be written.
  std::unique_ptr<RunViews> (*make_views)(const ViewOptions& options) = nullptr;
  /// Throws render::RenderError where no pictures can be taken.
  std::unique_ptr<simulation::CameraRenderer> (*make_cameras)(const world::World& world) = nullptr;
  /// Does the work of a process that `elsie batch` has started, and ends it.
  void (*work)() = nullptr;
  /// Does the work of one that is copied for runs, and ends it.
  void (*stand_by)() = nullptr;
};

/// The libraries, in the order in which the help lists their subcommands: lib/elsie/NAME.so.
inline constexpr const char* kCommandsModule = "elsie-commands";
inline constexpr const char* kStudiesModule = "elsie-studies";
inline constexpr const char* kTestingModule = "elsie-testing";
inline constexpr const char* kSessionModule = "elsie-session";

/// Loads the library. Throws base::Error with a sentence when it is missing, damaged, or another.
const CommandModule& command_module(const char* name);

/// Loads the library with the subcommand `chosen`, the first word of the command line, and adds its
/// subcommands; throws BadInput if it is missing. Without a subcommand, and for one that describes
/// all, it loads every library that can be loaded, and returns the subcommands of the others.
std::vector<std::string> add_module_commands(CLI::App& program, Job& job,
                                             const std::string& chosen);

/// The function that each library exports by this name returns a const CommandModule*.
inline constexpr const char* kCommandModule = "elsie_command_module";

}  // namespace elsie::program

// Exports a CommandModule with these members, and the ABI word that is compared before the library
// is loaded.
#define ELSIE_EXPORT_COMMANDS(...)                                               \
  ELSIE_EMIT_ABI_NOTE_(ELSIE_ABI_WORD);                                          \
  extern "C" [[gnu::visibility("default")]] const elsie::program::CommandModule* \
  elsie_command_module() {                                                       \
    static const elsie::program::CommandModule module{__VA_ARGS__};              \
    return &module;                                                              \
  }                                                                              \
  static_assert(true, "a semicolon may follow")
