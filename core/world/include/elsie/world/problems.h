// Collecting problems, so that all of a file are reported in one go.
#pragma once

#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "elsie/world/description.h"
#include "elsie/world/error.h"

namespace elsie::world {

class Problems {
 public:
  void add(const Location& where, std::string message, bool plugin_failed = false);
  /// Takes over what a file that could not be parsed had to say.
  void add(const WorldError& error);
  void add(const Problems& others);
  bool empty() const { return problems_.empty(); }
  /// Throws them as a WorldError, sorted by line, those of `main_file` first; does nothing when
  /// there are none.
  void raise(const std::string& main_file) const;

 private:
  std::vector<Problem> problems_;
  std::set<std::tuple<std::string, int, std::string>> known_;  // to tell each only once
};

/// What something may be called instead of a wrong name, for the end of a sentence: "; did you mean
/// 'speed'?" when a name is near, else all of them: "; it may have: x, y" for "it may have".
std::string near_or_all(const std::string& wrong, const std::vector<std::string>& names,
                        const std::string& before_all);
/// "a, b, c"
std::string listed(const std::vector<std::string>& names);

}  // namespace elsie::world
