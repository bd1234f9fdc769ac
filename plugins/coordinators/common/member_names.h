// The members that nested elements name.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <elsie/api/coordinator.h>
#include <elsie/base/near_name.h>

/// The names of a coordinator's members, and what is wrong with the elements that use them: all of
/// it is told at once.
class MemberNames {
 public:
  void read(std::span<const elsie::Member> members) {
    names_.clear();
    for (const elsie::Member& member : members) {
      names_.emplace_back(member.name());
    }
  }
  std::size_t size() const { return names_.size(); }
  const std::string& operator[](std::size_t i) const { return names_[i]; }

  /// The index of the member that `attribute` of `element` names. Without one: none, and a problem.
  std::optional<std::size_t> find(const char* element, const char* attribute,
                                  const std::string& name) {
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found != names_.end()) {
      return static_cast<std::size_t>(found - names_.begin());
    }
    refuse(text(element, attribute, name) + " names no behaviour of this coordinator" +
           elsie::base::near_or_all(name, names_, "it has"));
    return std::nullopt;
  }

  void refuse(const std::string& problem) {
    problems_ += (problems_.empty() ? "" : "; ") + problem;
  }

  /// Throws all problems since the last call, if there are any.
  void throw_problems() {
    if (!problems_.empty()) {
      const std::string all = std::move(problems_);
      problems_.clear();
      throw std::invalid_argument(all);
    }
  }

  static std::string text(const char* element, const char* attribute, const std::string& value) {
    return "<" + std::string(element) + " " + attribute + "=\"" + value + "\">";
  }

 private:
  std::vector<std::string> names_;
  std::string problems_;
};
