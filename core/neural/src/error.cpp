#include "elsie/neural/error.h"

#include <utility>

namespace elsie::neural {
namespace {

std::string all(const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& problem : problems) {
    text += (text.empty() ? "" : "\n") + problem.text();
  }
  return text;
}

}  // namespace

std::string Problem::text() const {
  return file + (line > 0 ? ":" + std::to_string(line) : "") + ": " + message;
}

FileError::FileError(std::vector<Problem> problems)
    : std::runtime_error(all(problems)), problems_(std::move(problems)) {}

}  // namespace elsie::neural
