// Groups of robots and boxes that are linked by contacts.
#pragma once

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace elsie::physics {

/// Members, some of which are linked. An island is a whole linked group.
class Islands {
 public:
  /// Starts with so many members, none linked. Each counts 1, unless count() says otherwise.
  void reset(std::size_t members) {
    parents_.resize(members);
    std::iota(parents_.begin(), parents_.end(), std::size_t{0});
    sizes_.assign(members, 1);
  }
  void count(std::size_t member, std::size_t as) { sizes_[member] = as; }
  void link(std::size_t a, std::size_t b) {
    a = island(a);
    b = island(b);
    if (a == b) return;
    if (b < a) std::swap(a, b);
    parents_[b] = a;
    sizes_[a] += sizes_[b];
  }
  /// The first member of this member's island.
  std::size_t island(std::size_t member) {
    while (parents_[member] != member) {
      parents_[member] = parents_[parents_[member]];
      member = parents_[member];
    }
    return member;
  }
  /// The sum of the counts of all members of its island.
  std::size_t size(std::size_t member) { return sizes_[island(member)]; }

 private:
  std::vector<std::size_t> parents_;
  std::vector<std::size_t> sizes_;
};

}  // namespace elsie::physics
