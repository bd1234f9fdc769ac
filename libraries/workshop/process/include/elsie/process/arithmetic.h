// The C library's variants of its mathematical functions.
//
// glibc chooses a variant of sin(), exp() and others by the processor, and their last bits differ.
// A process that is started with certain settings in its environment has the same variant on all
// processors, and so the same bits. They must be there when the process starts.
#pragma once

#include <string>
#include <string_view>

namespace elsie::process {

/// The variable of the environment.
inline constexpr const char* kArithmeticVariable = "GLIBC_TUNABLES";

/// The settings of the variable, NAME=VALUE:NAME=VALUE, with ours at the end of processor features.
std::string with_fixed_arithmetic(std::string_view settings);

/// Whether this process was started with such settings, or has no need of them: another processor
/// or C library than x86-64 and glibc.
bool has_fixed_arithmetic();

}  // namespace elsie::process
