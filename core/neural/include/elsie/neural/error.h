// What is wrong with a training file or a weight file.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace elsie::neural {

/// One mistake, where it stands and in a sentence.
struct Problem {
  std::string file;  // as the caller named it
  int line = 0;      // from 1; 0 when the file as a whole is meant
  std::string message;

  /// "file:line: message".
  std::string text() const;

  friend bool operator==(const Problem&, const Problem&) = default;
};

/// Everything that is wrong with a file, in the order of its lines. what() has one problem a line.
class FileError : public std::runtime_error {
 public:
  explicit FileError(std::vector<Problem> problems);
  std::span<const Problem> problems() const { return problems_; }

 private:
  std::vector<Problem> problems_;
};

}  // namespace elsie::neural
