// The command line that repeats a run.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "link.h"

namespace elsie::server {

class Repetition {
 public:
  /// Of a run of this text from the beginning.
  void begin(std::string file, std::string text, std::uint64_t seed);
  /// The world is in this file from now on, and the run began with this text of it.
  void move(std::string file, std::string text);
  const std::string& text() const { return text_; }
  /// Edits made together, between two steps; `step_s`: the length of a step.
  void add(double time_s, double step_s, std::vector<std::string> edits);

  /// `text`: the command. `saved`: whether the file has the text that the run began with.
  /// `options`: those of plugins.
  Json command(const std::vector<std::string>& options) const;

 private:
  struct Together {
    double time_s, step_s;
    std::vector<std::string> edits;
  };

  std::string file_, text_;
  std::uint64_t seed_ = 1;
  std::vector<Together> edits_;
};

}  // namespace elsie::server
