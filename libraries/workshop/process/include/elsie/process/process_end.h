// The ends of this process that are meant.
//
// A plugin can end its process at any time, with any exit code. So that its exit code is not taken
// for that of the program, a program may announce its own over a channel that plugins do not know,
// in the moment before it ends: set_announcer().
#pragma once

namespace elsie::process {

/// Called by end_with() right before the process ends, with the exit code. Also from handlers of
/// signals: write(2) and the like, nothing else.
using Announcer = void (*)(int exit_code) noexcept;

/// To be called once, early, by a program; a library never does. Without one, nothing is announced.
void set_announcer(Announcer announcer);

/// Ends the process with this exit code: at once, without the destructors of globals and without
/// what was registered with atexit(). May be called in a handler of a signal. A crash that another
/// thread is reporting meanwhile comes first: its report ends the process.
[[noreturn]] void end_with(int exit_code) noexcept;

/// Only announces it: the process is about to end by a signal, and `exit_code` is what a shell
/// makes of that (128 and its number).
void announce_end(int exit_code) noexcept;

}  // namespace elsie::process
