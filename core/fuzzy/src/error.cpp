#include "elsie/fuzzy/error.h"

#include <utility>

namespace elsie::fuzzy {

namespace {

std::string joined(std::span<const Problem> problems) {
  std::string text;
  for (const Problem& problem : problems) {
    text += (text.empty() ? "" : "\n") + problem.text();
  }
  return text;
}

}  // namespace

std::string Problem::text() const {
  return file + (line > 0 ? ":" + std::to_string(line) : std::string()) + ": " + message;
}

FclError::FclError(std::vector<Problem> problems)
    : std::runtime_error(joined(problems)), problems_(std::move(problems)) {}

}  // namespace elsie::fuzzy
