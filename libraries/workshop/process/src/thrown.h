// Where plugins throw.
#pragma once

#include <string>

namespace elsie::process {

/// The place in a plugin's source where the exception that is being handled was thrown:
/// "Brake::respond(...) at brake.cpp:12"; "" if note_throw() did not see it, or if the library has
/// no line numbers.
std::string place_of_throw();

}  // namespace elsie::process
