// Stack traces from within handlers of signals.
#pragma once

#include <string_view>

namespace elsie::plugin {

/// Loads what a trace needs; to be called before there is a fault.
void prepare_stack_trace();

/// Writes to standard error where the calling thread is: the calls from `at` (the address of the
/// instruction at fault; null: the nearest ones) outwards, as far as the code of libelsie, which
/// called the plugin. With the lines of the source where addr2line(1) knows them.
void write_stack_trace(const void* at) noexcept;

/// Writes to standard error, within handlers, too.
void write_error(std::string_view text) noexcept;

}  // namespace elsie::plugin
