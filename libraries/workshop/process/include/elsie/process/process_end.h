// Intended ends of this process.
#pragma once

namespace elsie::process {

/// Ends the process with this exit code at once, without destructors of globals or functions
/// registered with atexit(). May be called in a signal handler. If another thread is reporting a
/// crash, its report ends the process.
[[noreturn]] void end_with(int exit_code) noexcept;

}  // namespace elsie::process
