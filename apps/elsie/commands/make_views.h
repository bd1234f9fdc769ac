// The views of one run, with the libraries that they need.
#pragma once

#include <memory>

#include "run_views.h"

namespace CLI {
class App;
}

namespace elsie::program {

/// Throws BadInput for files that cannot be written.
std::unique_ptr<RunViews> make_views(const ViewOptions& options);

/// Adds the available formats to the help of a subcommand about `--record`.
void describe_formats(CLI::App& command);

}  // namespace elsie::program
