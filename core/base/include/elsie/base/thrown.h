// The exception that is being handled, for messages. Call these functions in a catch block.
#pragma once

#include <string>

namespace elsie::base {

/// What the exception says, or its type if that is nothing: an exception of a plugin may have no
/// text. The copy may outlive the library that threw it.
std::string what_was_thrown();

/// The place in a plugin's source where it was thrown: "function at file:line". "" if that is not
/// known, as in programs without watch_throws().
std::string place_of_throw();

/// From now on, place_of_throw() calls this function. A program calls this once, early.
void watch_throws(std::string (*place)()) noexcept;

/// A mangled name of C++ as the source has it; others unchanged.
std::string demangled_name(const std::string& name);

}  // namespace elsie::base
