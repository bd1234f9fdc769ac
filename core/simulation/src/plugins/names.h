// Texts that outlive the plugins that they come from.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>

namespace elsie::simulation {

/// Names of events and reasons in traces are literals of plugins, which go with their library. Here
/// each is kept once, for as long as the robot lives: there are as many as there are literals, so
/// this grows only when plugins are replaced, by what the new ones say otherwise. A text that is
/// put together in each step has no place in a trace (elsie/api/coordinator.h), and would be kept
/// too.
class Names {
 public:
  /// The same text, for as long as this lives.
  const char* keep(std::string_view text) {
    const auto known = names_.find(text);
    return (known == names_.end() ? names_.emplace(text).first : known)->c_str();
  }

 private:
  std::set<std::string, std::less<>> names_;
};

}  // namespace elsie::simulation
