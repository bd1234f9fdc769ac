// The memory that the process uses.
#pragma once

#include <cstddef>

namespace elsie::testing {

/// Bytes allocated by the whole process and not freed yet.
std::size_t memory_in_use();

}  // namespace elsie::testing
