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
  /// Begins a new run of this text.
  void begin(std::string file, std::string text, std::uint64_t seed);
  /// The world has moved to this file, and `text` is the text there with which the run began.
  void move(std::string file, std::string text);
  const std::string& text() const { return text_; }
  /// Adds edits that were made together between two steps. `step_s`: the length of a step.
  void add(double time_s, double step_s, std::vector<std::string> edits);

  /// An object with `text`, the command; `words`, those after "elsie", the world's file second;
  /// `world`, the text with which the run began; and `saved`, whether the file has that text.
  /// `options`: the options for plugins.
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
