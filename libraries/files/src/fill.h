#pragma once

#include <string_view>

#include "elsie/files/write_whole.h"

namespace elsie::files {

/// Writes and closes; returns zero or errno.
int fill(int descriptor, std::string_view content, Durable durable);

}  // namespace elsie::files
