// The base of all errors that a user can meet.
#pragma once

#include <stdexcept>
#include <string>

namespace elsie::base {

/// The exit codes of the program.
enum ExitCode {
  kSuccess = 0,
  kGoalMissed = 1,    // the run ended without reaching its goal
  kBadInput = 2,      // bad input or usage
  kPluginFailed = 3,  // a plugin failed while running
  kOtherFailure = 4,  // anything else: a full disk, an interrupt
};

/// An error with a sentence for the user, and the program's exit code if nothing catches it.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& sentence, ExitCode exit_code = kOtherFailure)
      : std::runtime_error(sentence), exit_code_(exit_code) {}

  ExitCode exit_code() const { return exit_code_; }
  /// The message that the program prints: the sentence after the program's name, or lines that
  /// begin with the names of files.
  virtual std::string message() const;

 private:
  ExitCode exit_code_;
};

/// Input that the program cannot use.
class BadInput : public Error {
 public:
  explicit BadInput(const std::string& sentence) : Error(sentence, kBadInput) {}
};

}  // namespace elsie::base
