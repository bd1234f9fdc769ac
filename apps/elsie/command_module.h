// The parts of the program that `elsie run` needs only for views, or if the world has cameras. Each
// is a library beside the program, which loads what the work needs: OpenGL, cairo, SQLite. A build
// may lack all but the first of them.
#pragma once

#include <memory>

#include "elsie/simulation/camera_renderer.h"

#include "command.h"
#include "run_views.h"

namespace elsie::program {

/// What such a library exports; functions that it does not have are null.
struct CommandModule {
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
inline constexpr const char* kViewsModule = "elsie-commands";
inline constexpr const char* kStudiesModule = "elsie-studies";
inline constexpr const char* kTestingModule = "elsie-testing";
inline constexpr const char* kSessionModule = "elsie-session";

/// Loads the library. Throws base::Error with a sentence when it is missing.
const CommandModule& command_module(const char* name);

/// Loads the libraries that are there, up to the one with the subcommand `chosen`, the first word
/// of the command line, and adds their subcommands. Throws BadInput if its library is missing.
void add_module_commands(CLI::App& program, Job& job, const std::string& chosen);

/// The function that each library exports by this name returns a const CommandModule*.
inline constexpr const char* kCommandModule = "elsie_command_module";

}  // namespace elsie::program
