// write(2), to the end.
#pragma once

#include <string_view>

namespace elsie::base {

/// Writes all bytes to a descriptor. Returns zero or errno. Signal handlers may use it.
int write_all(int descriptor, std::string_view bytes) noexcept;

}  // namespace elsie::base
