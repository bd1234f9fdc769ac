// Pieces of sentences.
#pragma once

#include <string>

namespace elsie::testing {

/// The shortest decimal text that reads back as the same number.
std::string number_text(double value);

/// To be called in a catch block: what() of the exception, or that it is no std::exception.
std::string caught_text();

}  // namespace elsie::testing
