// write(2), to the end.
#pragma once

#include <string_view>

namespace elsie::base {

/// Writes all of it to a descriptor. Zero, or the error number (errno) of what went wrong. For
/// handlers of signals, too.
int write_all(int descriptor, std::string_view bytes) noexcept;

}  // namespace elsie::base
