// All mistakes of a file, each with its line.
#pragma once

#include <cstddef>
#include <limits>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "elsie/base/error.h"
#include "elsie/base/shared_text.h"

namespace elsie::base {

/// A line of a file, or an edit.
struct Location {
  SharedText file;  // as the user named it, or "--set PATH=VALUE"
  int line = 0;     // from 1; 0: the file as a whole, or an edit

  bool is_edit() const { return line == 0 && file.text().starts_with("--set "); }
};

/// One mistake and where it is.
struct Problem {
  std::string file;            // as the user named it, or "--set PATH=VALUE"
  int line = 0;                // from 1; 0: the file as a whole
  std::string message;         // a sentence: what was found, what was expected
  bool plugin_failed = false;  // the file is right, but a plugin's constructor throws

  /// "file:line: message"
  std::string text() const;
  friend bool operator==(const Problem&, const Problem&) = default;
};

/// All mistakes of a file and of the files that it includes. what() has one line for each.
class FileError : public Error {
 public:
  explicit FileError(std::vector<Problem> problems);

  const std::vector<Problem>& problems() const { return problems_; }
  /// Returns whether one of them is a plugin's fault.
  bool plugin_failed() const { return exit_code() == kPluginFailed; }
  std::string message() const override { return what(); }

 private:
  std::vector<Problem> problems_;
};

/// Collects problems while a file is read, so that all of them are reported together.
class Problems {
 public:
  /// `file` is the file of problems that are added without one. At most `most` problems are
  /// reported; the rest are counted.
  explicit Problems(std::string file = {},
                    std::size_t most = std::numeric_limits<std::size_t>::max());

  /// Ignores a problem that was added before: every robot with the same template finds its
  /// mistakes.
  void add(const Location& where, std::string message, bool plugin_failed = false);
  void add(int line, std::string message) { add({file_, line}, std::move(message)); }
  void add(std::span<const Problem> problems);
  void add(const FileError& error) { add(error.problems()); }
  void add(const Problems& others) {
    add(others.problems_);
    remarks_.insert(remarks_.end(), others.remarks_.begin(), others.remarks_.end());
    left_out_ += others.left_out_;
  }

  /// Adds a remark on something that has no effect; it is no problem.
  void remark(const Location& where, std::string message) {
    remarks_.push_back({where.file.text(), where.line, std::move(message)});
  }
  const std::vector<Problem>& remarks() const { return remarks_; }

  bool empty() const { return problems_.empty() && left_out_ == 0; }
  std::size_t size() const { return problems_.size(); }
  /// The problems by line: first those of the main file, then those of the other files in the order
  /// in which they were added. If there are too many, the last one says how many are left out.
  std::vector<Problem> sorted(const std::string& main_file) const;

  /// Throws the problems as an error of this type, if there are any.
  template <class FileErrorType>
  void raise(const std::string& main_file) const {
    if (!empty()) {
      throw FileErrorType(sorted(main_file));
    }
  }
  template <class FileErrorType>
  void raise() const {
    raise<FileErrorType>(file_);
  }

 protected:
  /// Forgets the problems of these lines.
  void forget(int first_line, int last_line);

 private:
  static constexpr std::size_t kMostKept = 100'000;

  std::string file_;
  std::size_t most_;
  std::size_t left_out_ = 0;  // problems beyond kMostKept
  std::vector<Problem> problems_, remarks_;
  std::set<std::tuple<std::string, int, std::string>> known_;
};

}  // namespace elsie::base
