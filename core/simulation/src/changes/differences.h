// What an edit changes in the description of a running world.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/sharing/list.h"
#include "elsie/world/same.h"
#include "elsie/world/vocabulary.h"

#include "simulation_impl.h"

namespace elsie::simulation {

inline bool same_part(const char* part, const world::World& a, const world::World& b) {
  return world::same_part(world::vocabulary(), part, &a, &b);
}

inline bool same_changes(const world::World& a, const world::World& b) {
  return a.changes.is(b.changes) || same_part("changes", a, b);
}

/// The robots of a world before and after an edit.
class Simulation::Impl::Pairs {
 public:
  Pairs(const world::World& was, const world::World& next)
      : was_(was), next_(next), commons_(was), next_commons_(next) {
    std::map<std::string_view, std::size_t> known;  // made only if robots were added or removed
    for (std::size_t i = 0; i < next.robots.size(); ++i) {
      const std::string& id = next.robots[i].id;
      std::size_t place = places_.empty() ? 0 : places_.back() + 1;
      if (place >= was.robots.size() || was.robots[place].id != id) {
        for (std::size_t k = known.size(); k < was.robots.size(); ++k) {
          known.emplace(was.robots[k].id, k);
        }
        const auto found = known.find(id);
        place = found == known.end() ? was.robots.size() : found->second;
      }
      places_.push_back(place);
    }
  }

  const world::World& was() const { return was_; }
  /// The index before the edit; the number of robots then for a new one.
  std::size_t place(std::size_t robot) const { return places_[robot]; }
  bool is_new(std::size_t robot) const { return places_[robot] == was_.robots.size(); }
  /// Whether the edit leads to nothing that its objects could see when they are equipped.
  bool stays(std::size_t robot) const {
    return same_around_ && !is_new(robot) && &was_.robots[places_[robot]] == &next_.robots[robot] &&
           commons_.number_of(places_[robot]) == next_commons_.number_of(robot);
  }
  /// The robots of the world before that are not in the next one as they were.
  sharing::List<world::Robot> gone() const {
    std::vector<bool> is_gone(was_.robots.size(), true);
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (!is_new(i)) is_gone[places_[i]] = &was_.robots[places_[i]] != &next_.robots[i];
    }
    sharing::List<world::Robot> gone;
    for (std::size_t k = 0; k < is_gone.size(); ++k) {
      if (is_gone[k]) gone.share(was_.robots, k);
    }
    return gone;
  }

 private:
  const world::World &was_, &next_;
  const Commons commons_, next_commons_;
  const bool same_around_ = same_part("teams", was_, next_) &&
                            same_part("resources", was_, next_) &&
                            same_part("chargers", was_, next_);
  std::vector<std::size_t> places_;
};

}  // namespace elsie::simulation
