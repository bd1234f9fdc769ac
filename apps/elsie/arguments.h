// Checks of arguments on the command line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace CLI {
class App;
class Validator;
}  // namespace CLI

namespace elsie::program {

/// The whole text as a finite number; none for "1,5", "3abc" or "nan".
std::optional<double> parse_number(std::string_view text);

/// Validates options that take a finite number above zero, and at most this.
CLI::Validator positive_number(double most = std::numeric_limits<double>::infinity());

/// Validates options that take a finite number, zero or above.
CLI::Validator non_negative_number();

/// Validates options that take a number of this range, its ends included.
CLI::Validator number_between(double least, double most);

/// Validates options that take a signed whole number of 64 bits.
CLI::Validator whole_number();
/// The same, of this range, its ends included.
CLI::Validator whole_number(std::int64_t least, std::int64_t most);

/// Validates seeds: unsigned whole numbers of 64 bits.
CLI::Validator seed_number();

/// Adds the option that sets simulation::Options::threads.
void add_threads_option(CLI::App& command, std::size_t& threads);

}  // namespace elsie::program
