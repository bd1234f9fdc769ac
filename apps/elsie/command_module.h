// The part of the program that `elsie run` needs only for views, or if the world has cameras: all
// other subcommands, and the observers of a run. It is a library of its own,
// lib/elsie/elsie-commands.so, because it loads OpenGL, cairo and SQLite.
#pragma once

#include <memory>

#include "elsie/simulation/camera_renderer.h"

#include "command.h"
#include "run_views.h"

namespace elsie::program {

struct CommandModule {
  /// Adds all subcommands but `run`.
  void (*add_commands)(CLI::App& program, Job& job);
  /// Does the work of a process that `elsie batch` has started, and ends it.
  void (*work)();
  /// Does the work of one that is copied for runs, and ends it.
  void (*stand_by)();
  /// Throws BadInput for files that cannot be written.
  std::unique_ptr<RunViews> (*make_views)(const ViewOptions& options);
  /// Throws render::RenderError where no pictures can be taken.
  std::unique_ptr<simulation::CameraRenderer> (*make_cameras)(const world::World& world);
};

/// Loads the module at the first call. Throws base::Error with a sentence when it is missing.
const CommandModule& command_module();

/// The function that the module exports by this name returns a const CommandModule*.
inline constexpr const char* kCommandModule = "elsie_command_module";

}  // namespace elsie::program
