// Stack traces from within handlers of signals.
#pragma once

#include <string_view>

namespace elsie::process {

/// Loads what a trace needs; to be called before there is a fault.
void prepare_stack_trace();

/// Where a signal came upon a thread.
struct Fault {
  const void* at = nullptr;            // the instruction; null: not known
  const void* const* stack = nullptr;  // the innermost word of the stack, where return addresses
                                       // are; or else, where a register has them,
  const void* back = nullptr;          // the address to return to
  bool is_after = false;               // `at` is where a call returns to: the call stands before
  const void* touched = nullptr;       // the memory that could not be read or written; null: none
};

/// Writes to standard error where the calling thread is: the calls from the fault (that of no
/// address: the nearest ones) outwards, as far as the code of libelsie, which called the plugin.
/// With the lines of the source where addr2line(1) knows them. Of a fault where there is no code,
/// as after a call through a wild pointer, the one place that made the call.
void write_stack_trace(const Fault& fault) noexcept;

/// Writes to standard error, within handlers, too.
void write_error(std::string_view text) noexcept;

}  // namespace elsie::process
