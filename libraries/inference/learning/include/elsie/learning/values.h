// Files of learned values: tables of numbers as text.
//
//   elsie values 1
//   about method q
//   about behaviors collect recharge
//   table value 6 2
//   row 1 0.31 2.5
//   ...
//   end
//
// The first line names the version of the format. `about`: a word and a text, for the user of the
// values. `table`: its name, how many rows and how many numbers in each; then its rows, each with
// its number, from 1. Numbers are the shortest decimals that read back as the same: writing and
// reading keeps every bit.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/neural/data_file.h"

namespace elsie::learning {

using neural::FileError;
using neural::Remark;

inline constexpr int kValuesVersion = 1;
/// The most numbers in a table.
inline constexpr std::size_t kMostValues = 16'000'000;

/// How good each action is in each state.
class ValueTable {
 public:
  /// All values are 0. Throws std::invalid_argument beyond kMostValues.
  ValueTable(std::size_t states, std::size_t actions);

  std::size_t states() const { return states_; }
  std::size_t actions() const { return actions_; }
  double& at(std::size_t state, std::size_t action) { return values_[state * actions_ + action]; }
  double at(std::size_t state, std::size_t action) const {
    return values_[state * actions_ + action];
  }
  std::span<const double> row(std::size_t state) const {
    return std::span(values_).subspan(state * actions_, actions_);
  }
  /// The action of the largest value, of equal ones the first. There must be an action.
  std::size_t best(std::size_t state) const;
  /// Its value.
  double most(std::size_t state) const { return at(state, best(state)); }

  friend bool operator==(const ValueTable&, const ValueTable&) = default;

 private:
  std::size_t states_, actions_;
  std::vector<double> values_;
};

struct NamedTable {
  std::string name;  // a word
  ValueTable values;

  friend bool operator==(const NamedTable&, const NamedTable&) = default;
};

struct Values {
  std::vector<NamedTable> tables{};
  std::vector<Remark> about{};

  /// The text of a remark, or "".
  std::string_view remark(std::string_view key) const { return neural::remark(about, key); }

  friend bool operator==(const Values&, const Values&) = default;
};

/// The content of a file. Throws std::invalid_argument for a value that is not finite, a table that
/// is empty or whose name is no word, no table at all, and a remark that cannot be written.
std::string values_text(const Values& values);

/// Reads a file of values. Lines that it does not understand are errors. Throws FileError.
Values read_values(const std::string& path);

/// Reads values from text; `name` is its name in messages. Throws FileError.
Values parse_values(std::string_view text, const std::string& name = "values");

/// Whether the file begins like a file of values.
bool looks_like_values(const std::string& path);

/// Writes a file in one piece, through a new file next to it. Throws as values_text() does, and
/// std::runtime_error with file and reason when it cannot be written; an existing file is then
/// unchanged.
void write_values(const Values& values, const std::string& path);

}  // namespace elsie::learning
