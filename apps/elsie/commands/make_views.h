// The views of one run, with the libraries that they need.
#pragma once

#include <memory>

#include "run_views.h"

namespace elsie::program {

/// Throws BadInput for files that cannot be written.
std::unique_ptr<RunViews> make_views(const ViewOptions& options);

}  // namespace elsie::program
