// The same bits on every x86-64 processor.
#pragma once

namespace elsie::supervisor {

/// The GNU C library has several versions of sin(), exp(), pow() and their like, which differ in
/// the last bit, and takes the one that suits the processor: with or without fused multiply-add.
/// From now on the programs that this process starts take those that every x86-64 processor has. It
/// covers the program, its libraries and all plugins, because it is the C library that chooses.
///
/// Sets GLIBC_TUNABLES in the environment; what it says already about other things stays.
/// Does nothing for other processors, which have one version each, nor for another C library.
void fix_arithmetic();

}  // namespace elsie::supervisor
