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

/// Completes what the help of a subcommand says about `--record` by the formats that there are.
void describe_formats(CLI::App& command);

}  // namespace elsie::program
