// Intended ends of this process.
//
// A plugin can end its process at any time, with any exit code. A program may announce its own exit
// code, just before it ends, over a channel that plugins do not know, so that the two can be
// distinguished: set_announcer().
#pragma once

namespace elsie::process {

/// Called by end_with() with the exit code just before the process ends. Also called in signal
/// handlers: only functions like write(2) are allowed.
using Announcer = void (*)(int exit_code) noexcept;

/// To be called once, early, by a program, never by a library. Without one, nothing is announced.
void set_announcer(Announcer announcer);

/// Ends the process with this exit code at once, without destructors of globals or functions
/// registered with atexit(). May be called in a signal handler. If another thread is reporting a
/// crash, its report ends the process.
[[noreturn]] void end_with(int exit_code) noexcept;

/// Only announces the end: the process is about to end by a signal, and `exit_code` is what a shell
/// makes of it (128 and its number).
void announce_end(int exit_code) noexcept;

}  // namespace elsie::process
