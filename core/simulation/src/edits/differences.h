// What an edit changes in the description of a running world.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/base/list.h"
#include "elsie/world/same.h"
#include "elsie/world/vocabulary.h"

#include "simulation_impl.h"

namespace elsie::simulation {

inline bool same_part(const char* part, const world::World& a, const world::World& b) {
  return world::same_part(world::vocabulary(), part, &a, &b);
}

inline bool same_schedule(const world::World& a, const world::World& b) {
  return a.edits.is(b.edits) || same_part("changes", a, b);
}

/// The robots of a world before and after an edit.
class Simulation::Impl::Pairs {
 public:
  Pairs(const world::World& was, const world::World& next) : was_(was), next_(next) {
    std::map<std::string_view, std::size_t> known;  // made only if robots were added or removed
    bool same_numbers = was.robots.size() == next.robots.size();
    for (std::size_t i = 0; i < next.robots.size(); ++i) {
      if (i < was.robots.size() && &was.robots[i] == &next.robots[i]) {
        formers_.push_back(i);
        continue;
      }
      const std::string& id = next.robots[i].id;
      std::size_t former = formers_.empty() ? 0 : formers_.back() + 1;
      if (former >= was.robots.size() || was.robots[former].id != id) {
        for (std::size_t k = known.size(); k < was.robots.size(); ++k) {
          known.emplace(was.robots[k].id, k);
        }
        const auto found = known.find(id);
        former = found == known.end() ? was.robots.size() : found->second;
      }
      formers_.push_back(former);
      same_numbers = same_numbers && former == i && was.robots[i].team == next.robots[i].team;
    }
    if (!same_numbers) {
      common_.emplace(was);
      next_common_.emplace(next);
    }
  }

  const world::World& was() const { return was_; }
  /// The index before the edit; the number of robots then for a new one.
  std::size_t former(std::size_t robot) const { return formers_[robot]; }
  bool is_new(std::size_t robot) const { return formers_[robot] == was_.robots.size(); }
  /// Whether the edit leads to nothing that its objects could see when they are equipped.
  bool stays(std::size_t robot) const {
    return same_around_ && !is_new(robot) &&
           &was_.robots[formers_[robot]] == &next_.robots[robot] &&
           (!common_ || common_->number_of(formers_[robot]) == next_common_->number_of(robot));
  }
  /// The robots of the world before that are not in the next one as they were.
  base::List<world::Robot> gone() const {
    std::vector<bool> is_gone(was_.robots.size(), true);
    for (std::size_t i = 0; i < formers_.size(); ++i) {
      if (!is_new(i)) is_gone[formers_[i]] = &was_.robots[formers_[i]] != &next_.robots[i];
    }
    base::List<world::Robot> gone;
    for (std::size_t k = 0; k < is_gone.size(); ++k) {
      if (is_gone[k]) gone.share(was_.robots, k);
    }
    return gone;
  }

 private:
  const world::World &was_, &next_;
  std::optional<CommonData> common_, next_common_;  // none: all robots keep their team numbers
  const bool same_around_ = same_part("teams", was_, next_) &&
                            same_part("resources", was_, next_) &&
                            same_part("chargers", was_, next_) && same_part("nests", was_, next_);
  std::vector<std::size_t> formers_;
};

}  // namespace elsie::simulation
