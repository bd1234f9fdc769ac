// What is wrong with a world file.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace elsie::world {

/// One mistake and where it stands.
struct Problem {
  std::string file;            // or "--set PATH=VALUE" for a mistake in an override
  int line = 0;                // from 1; 0 when it is not a matter of a line
  std::string message;         // a sentence: what was found, what was expected
  bool plugin_failed = false;  // by no fault of the file: a constructor of a plugin throws

  /// "file:line: message"
  std::string text() const;
  friend bool operator==(const Problem&, const Problem&) = default;
};

/// All the mistakes of a world and of the templates that it includes, in the order of their lines.
/// what() has one line for each.
class WorldError : public std::runtime_error {
 public:
  explicit WorldError(std::vector<Problem> problems);

  const std::vector<Problem>& problems() const { return problems_; }
  /// Whether one of them is a plugin's own.
  bool plugin_failed() const;

 private:
  std::vector<Problem> problems_;
};

}  // namespace elsie::world
