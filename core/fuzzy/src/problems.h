// Collects what is wrong with a file while it is read.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "elsie/fuzzy/error.h"

namespace elsie::fuzzy {

class Problems {
 public:
  explicit Problems(std::string file) : file_(std::move(file)) {}

  void add(int line, std::string message) { all_.push_back({file_, line, std::move(message)}); }
  /// What does no harm; see Model::notes().
  void add_note(int line, std::string message) {
    notes_.push_back({file_, line, std::move(message)});
  }
  /// Forgets what was added about these lines.
  void forget(int first_line, int last_line) {
    for (std::vector<Problem>* list : {&all_, &notes_}) {
      std::erase_if(*list, [&](const Problem& problem) {
        return problem.line >= first_line && problem.line <= last_line;
      });
    }
  }
  /// In the order of their lines.
  std::vector<Problem> notes() const {
    std::vector<Problem> sorted = notes_;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Problem& a, const Problem& b) { return a.line < b.line; });
    return sorted;
  }
  bool empty() const { return all_.empty(); }
  std::size_t size() const { return all_.size(); }

  /// Throws FclError when there is any.
  void throw_if_any() {
    if (all_.empty()) {
      return;
    }
    std::stable_sort(all_.begin(), all_.end(),
                     [](const Problem& a, const Problem& b) { return a.line < b.line; });
    if (all_.size() > kMost) {
      const std::string more = "... and " + std::to_string(all_.size() - kMost) + " more mistakes.";
      all_.resize(kMost);
      add(all_.back().line, more);
    }
    throw FclError(std::move(all_));
  }

 private:
  static constexpr std::size_t kMost = 200;  // reported; more help nobody

  std::string file_;
  std::vector<Problem> all_;
  std::vector<Problem> notes_;
};

}  // namespace elsie::fuzzy
