// The states that a learner tells apart.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "expression.h"

struct Feature {
  std::string of;
  std::string name;
  std::vector<double> at{0.5};
};

/// A state is a level for each feature: the number of its thresholds that the value reaches; 0 when
/// it has none.
class StateSpace {
 public:
  static constexpr std::size_t kMost = 65'536;  // states

  StateSpace() = default;
  /// Throws std::invalid_argument with a sentence.
  explicit StateSpace(std::vector<Feature> features);

  /// Finds what the features are on this robot. Throws std::invalid_argument with a sentence.
  void equip(std::span<const elsie::Member> members, const elsie::Perception& example);

  std::size_t size() const { return size_; }
  /// The index of the present state; the level of the first feature counts fastest.
  std::size_t state(std::span<const elsie::Member> members, const elsie::Perception& now);
  /// "hungry & not near & far 2".
  std::string text(std::size_t state) const;
  /// What a file of values must have been learned with: "battery at 0.3 0.8; resource_seen at 0.5".
  /// On one line, whatever white space the features have.
  std::string description() const;

 private:
  std::vector<Feature> features_;
  std::vector<Expression> expressions_;
  std::size_t size_ = 0;
};
