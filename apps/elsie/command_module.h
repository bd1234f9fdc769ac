// The library lib/elsie/elsie-commands.so: all subcommands but `elsie run`, and the views and
// cameras of a run. A run without these does not load it, nor what it links: OpenGL, cairo, SQLite.
#pragma once

#include <memory>

#include "elsie/api/abi.h"
#include "elsie/simulation/camera_renderer.h"

#include "command.h"
#include "run_views.h"

namespace elsie::program {

/// What the library exports.
struct CommandModule {
  /// Adds its subcommands.
  void (*add_commands)(CLI::App& program, Job& job);
  /// Throws BadInput for files that cannot be written.
  std::unique_ptr<RunViews> (*make_views)(const ViewOptions& options);
  /// Throws render::RenderError where no pictures can be taken.
  std::unique_ptr<simulation::CameraRenderer> (*make_cameras)(const world::World& world);
  /// Does the work of a process that `elsie batch` has started, and ends it.
  void (*work)();
  /// Does the work of one that is copied for runs, and ends it.
  void (*stand_by)();
};

/// Loads the library. Throws base::Error with a sentence when it is missing, damaged, or of another
/// build.
const CommandModule& command_module();

/// The function that the library exports by this name returns a const CommandModule*.
inline constexpr const char* kCommandModule = "elsie_command_module";

}  // namespace elsie::program
