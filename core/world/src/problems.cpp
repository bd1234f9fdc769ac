#include "elsie/world/problems.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

#include "elsie/plugin/near_name.h"

namespace elsie::world {

namespace {

std::string joined(const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& problem : problems) {
    text += (text.empty() ? "" : "\n") + problem.text();
  }
  return text;
}

}  // namespace

std::string Problem::text() const {
  return line > 0 ? file + ":" + std::to_string(line) + ": " + message : file + ": " + message;
}

WorldError::WorldError(std::vector<Problem> problems)
    : std::runtime_error(joined(problems)), problems_(std::move(problems)) {}

bool WorldError::plugin_failed() const {
  return std::any_of(problems_.begin(), problems_.end(),
                     [](const Problem& problem) { return problem.plugin_failed; });
}

void Problems::add(const Location& where, std::string message, bool plugin_failed) {
  Problem problem{where.file, where.line, std::move(message), plugin_failed};
  // A mistake in a template is met once for every robot that uses it.
  if (known_.emplace(problem.file, problem.line, problem.message).second) {
    problems_.push_back(std::move(problem));
  }
}

void Problems::add(const WorldError& error) {
  for (const Problem& problem : error.problems()) {
    add({problem.file, problem.line}, problem.message, problem.plugin_failed);
  }
}

void Problems::add(const Problems& others) {
  for (const Problem& problem : others.problems_) {
    add({problem.file, problem.line}, problem.message);
  }
}

void Problems::raise(const std::string& main_file) const {
  if (problems_.empty()) {
    return;
  }
  std::map<std::string, std::size_t> order{{main_file, 0}};
  for (const Problem& problem : problems_) {
    order.emplace(problem.file, order.size());
  }
  std::vector<Problem> sorted = problems_;
  std::stable_sort(sorted.begin(), sorted.end(), [&](const Problem& a, const Problem& b) {
    return std::pair(order.at(a.file), a.line) < std::pair(order.at(b.file), b.line);
  });
  throw WorldError(std::move(sorted));
}

std::string near_or_all(const std::string& wrong, const std::vector<std::string>& names,
                        const std::string& before_all) {
  const std::string near = plugin::did_you_mean(wrong, names);
  return !near.empty() || names.empty() ? near : "; " + before_all + ": " + listed(names);
}

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 20;
  std::string list;
  for (std::size_t i = 0; i < names.size() && i < kMost; ++i) {
    list += (list.empty() ? "" : ", ") + names[i];
  }
  return names.size() > kMost ? list + " and " + std::to_string(names.size() - kMost) + " more"
                              : list;
}

}  // namespace elsie::world
