// Checks of what stands on the command line.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace CLI {
class Validator;
}

namespace elsie::program {

/// A whole text as a finite number, or none: no "1,5", "3abc" or "nan".
std::optional<double> parse_number(std::string_view text);

/// For options that take a finite number above zero.
CLI::Validator positive_number();

/// For options that take a finite number, zero or above.
CLI::Validator non_negative_number();

/// For options that take a whole number, of 64 bits with its sign.
CLI::Validator whole_number();

/// For seeds: a whole number of 64 bits, without a sign.
CLI::Validator seed_number();

}  // namespace elsie::program
