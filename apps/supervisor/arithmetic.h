// The same bits on every x86-64 processor.
#pragma once

namespace elsie::supervisor {

/// The GNU C library has several versions of sin(), exp(), pow() and others, which differ in the
/// last bit, and chooses one for the processor: with or without fused multiply-add. After this
/// call, programs that this process starts use the versions that every x86-64 processor supports.
/// This covers the program, its libraries and all plugins, because the C library chooses.
///
/// Sets GLIBC_TUNABLES in the environment and keeps its other settings. Has no effect on other
/// processors, which have one version each, or with other C libraries.
void fix_arithmetic();

}  // namespace elsie::supervisor
