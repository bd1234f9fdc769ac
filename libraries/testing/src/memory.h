// How much memory the process has asked for.
#pragma once

#include <cstddef>

namespace elsie::testing {

/// Bytes that were allocated and not freed yet, by all of the process.
std::size_t memory_in_use();

}  // namespace elsie::testing
