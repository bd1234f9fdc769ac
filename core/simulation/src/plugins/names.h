// Texts that outlive the plugins that gave them.
#pragma once

#include <functional>
#include <mutex>
#include <set>
#include <string>
#include <string_view>

namespace elsie::simulation {

/// Names of events and reasons in traces are literals of plugins, which vanish with their library.
/// This class keeps one copy of each while a robot that shares it lives. Their number is bounded by
/// the number of literals, so it only grows when new plugins bring new texts. Plugins must not
/// build such texts in each step (elsie/api/coordinator.h): they would be kept, too.
class Names {
 public:
  /// A copy of the text that lives as long as this object. Several threads may call it.
  const char* keep(std::string_view text) {
    const std::scoped_lock lock(keeping_);
    const auto known = names_.find(text);
    return (known == names_.end() ? names_.emplace(text).first : known)->c_str();
  }

 private:
  std::mutex keeping_;
  std::set<std::string, std::less<>> names_;
};

}  // namespace elsie::simulation
