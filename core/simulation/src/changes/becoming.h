// What a running world needs in order to become another one.
#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "elsie/base/problems.h"
#include "elsie/plugin/host.h"
#include "elsie/simulation/run_result.h"
#include "elsie/world/description.h"

#include "changes/undo.h"
#include "plugins/guard.h"
#include "plugins/statements.h"

namespace elsie::simulation {

/// One edit on its way: what it has made, what is wrong with it, and how to undo it.
class Becoming {
 public:
  Becoming(const plugin::Host& host, std::uint64_t seed) : host_(host), seed_(seed) {}

  const plugin::Host& host() const { return host_; }
  std::uint64_t seed() const { return seed_; }
  Undo& undo() { return undo_; }
  std::vector<base::Problem>& problems() { return problems_; }
  Statements& said() { return said_; }

  /// This object is new; it takes the place of another one if that had the same id.
  void note_new(const Component* object, const std::string& robot, const std::string& id,
                bool in_place_of_another) {
    new_.insert(object);
    if (in_place_of_another) {
      said_.notes.push_back({robot, id,
                             "it was made anew by an edit and has lost what it remembered of the "
                             "run"});
    }
  }
  bool is_new(const Component* object) const { return new_.contains(object); }

 private:
  const plugin::Host& host_;
  std::uint64_t seed_;
  Undo undo_;
  std::vector<base::Problem> problems_;
  Statements said_;
  std::set<const Component*> new_;
};

}  // namespace elsie::simulation
