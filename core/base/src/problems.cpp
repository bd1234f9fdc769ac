#include "elsie/base/problems.h"

#include <algorithm>
#include <map>
#include <utility>

#include "elsie/base/words.h"

namespace elsie::base {
namespace {

std::string lines_of(const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& problem : problems) {
    text += (text.empty() ? "" : "\n") + problem.text();
  }
  return text;
}

ExitCode exit_code_of(const std::vector<Problem>& problems) {
  const bool plugin_failed = std::any_of(problems.begin(), problems.end(),
                                         [](const Problem& each) { return each.plugin_failed; });
  return plugin_failed ? kPluginFailed : kBadInput;
}

}  // namespace

std::string Problem::text() const {
  return file + (line > 0 ? ":" + std::to_string(line) : "") + ": " + message;
}

FileError::FileError(std::vector<Problem> problems)
    : Error(lines_of(problems), exit_code_of(problems)), problems_(std::move(problems)) {}

Problems::Problems(std::string file, std::size_t most) : file_(std::move(file)), most_(most) {}

void Problems::add(const Location& where, std::string message, bool plugin_failed) {
  if (problems_.size() >= kMostKept && !plugin_failed) {
    ++left_out_;
  } else if (known_.emplace(where.file.text(), where.line, message).second) {
    problems_.push_back({where.file, where.line, std::move(message), plugin_failed});
  }
}

void Problems::add(std::span<const Problem> problems) {
  for (const Problem& problem : problems) {
    add({problem.file, problem.line}, problem.message, problem.plugin_failed);
  }
}

void Problems::forget(int first_line, int last_line) {
  const auto is_there = [&](int line) { return line >= first_line && line <= last_line; };
  std::erase_if(problems_, [&](const Problem& problem) { return is_there(problem.line); });
  std::erase_if(known_, [&](const auto& each) { return is_there(std::get<1>(each)); });
}

std::vector<Problem> Problems::sorted(const std::string& main_file) const {
  std::map<std::string, std::size_t> order{{main_file, 0}};
  for (const Problem& problem : problems_) {
    order.emplace(problem.file, order.size());
  }
  std::vector<Problem> sorted = problems_;
  std::stable_sort(sorted.begin(), sorted.end(), [&](const Problem& a, const Problem& b) {
    return std::pair(order.at(a.file), a.line) < std::pair(order.at(b.file), b.line);
  });
  std::size_t left_out = left_out_;
  if (sorted.size() > most_) {
    left_out += sorted.size() - most_;
    sorted.resize(most_);
  }
  if (left_out > 0) {
    sorted.push_back({main_file, 0, "and " + counted(left_out, "more mistake")});
  }
  return sorted;
}

}  // namespace elsie::base
