// The same bits on every x86-64 processor.
#pragma once

namespace elsie::program {

/// The GNU C library has several versions of sin(), exp(), pow() and others, which differ in the
/// last bit, and chooses one for the processor when a program starts: with or without fused
/// multiply-add. This function has it choose the versions that every x86-64 processor supports. The
/// program, its libraries and all plugins use these.
///
/// Sets GLIBC_TUNABLES, keeps its other settings, and replaces the process by the same program with
/// the same arguments, unless it was started in this way. Has no effect on other processors, which
/// have one version each, or with other C libraries. Ends the process with a sentence if that
/// fails.
void fix_arithmetic(char** arguments);

}  // namespace elsie::program
