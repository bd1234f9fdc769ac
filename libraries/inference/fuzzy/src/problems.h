// Errors and untidy statements in a model's file.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "elsie/base/problems.h"

namespace elsie::fuzzy {

/// Collects notes in addition to problems.
class Problems : public base::Problems {
 public:
  Problems(const std::string& file, std::size_t most) : base::Problems(file, most), file_(file) {}

  /// Adds a remark on something that is allowed, but untidy.
  void add_note(int line, std::string message) {
    notes_.push_back({file_, line, std::move(message)});
  }
  /// The notes, by line.
  std::vector<base::Problem> notes() const {
    std::vector<base::Problem> sorted = notes_;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const auto& a, const auto& b) { return a.line < b.line; });
    return sorted;
  }
  /// Forgets the problems and notes of these lines.
  void forget(int first_line, int last_line) {
    base::Problems::forget(first_line, last_line);
    std::erase_if(notes_, [&](const base::Problem& note) {
      return note.line >= first_line && note.line <= last_line;
    });
  }

 private:
  std::string file_;
  std::vector<base::Problem> notes_;
};

}  // namespace elsie::fuzzy
