// Stack traces in signal handlers.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace elsie::process {

/// Loads what a trace needs; to be called before a fault.
void prepare_stack_trace();

/// The place at which a signal interrupted a thread.
struct Fault {
  const void* at = nullptr;            // the instruction; null: unknown
  const void* const* stack = nullptr;  // the innermost word of the stack, where return addresses
                                       // are; or else, where a register has them,
  const void* back = nullptr;          // the address to return to
  bool is_after = false;               // `at` is a return address: the call is before it
  const void* touched = nullptr;       // the memory that could not be accessed; null: none
};

/// Writes the calls of the calling thread to standard error, from the fault (without an address:
/// from here) outwards to the code of libelsie that called the plugin. With lines of the source if
/// addr2line(1) knows them. For a fault at an address without code, as after a call through a wild
/// pointer, writes the place of that call.
void write_stack_trace(const Fault& fault) noexcept;

/// The innermost of these return addresses that is in a plugin's own source, as "function at
/// file:line", or "". Not for signal handlers.
std::string own_line(std::span<void* const> frames);

/// Writes to standard error; also in signal handlers.
void write_error(std::string_view text) noexcept;

}  // namespace elsie::process
