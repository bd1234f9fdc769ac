// Random edits of a world, drawn from the vocabulary and the declarations of plugins.
#pragma once

#include <random>
#include <string>

#include "elsie/plugin/host.h"
#include "elsie/world/description.h"

namespace elsie::test {

class RandomEdits {
 public:
  RandomEdits(unsigned seed, const plugin::Host& host) : random_(seed), host_(host) {}

  /// An edit of something in the world. Most are possible; some have values out of range, unknown
  /// names, or are nonsense.
  std::string next(const world::World& world);

  /// A number from 0 to `count` - 1.
  std::size_t below(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
  }
  bool happens(double probability) {
    return std::uniform_real_distribution<double>()(random_) < probability;
  }

 private:
  friend class Walk;

  std::mt19937 random_;
  const plugin::Host& host_;
};

}  // namespace elsie::test
