#include "set_fusion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <elsie/fuzzy/sets.h>

namespace fuzzy = elsie::fuzzy;
using elsie::CommandSets;
using elsie::FuzzySet;
using elsie::Member;
using elsie::Motion;
using elsie::Perception;
using elsie::WheelPair;

namespace {

/// The stretches of a set between zeros.
std::vector<FuzzySet> regions_of(const FuzzySet& set) {
  constexpr double kNothing = 1e-9;
  std::vector<FuzzySet> regions;
  FuzzySet region;
  const auto close = [&] {
    if (fuzzy::height(region) > kNothing) {
      regions.push_back(region);
    }
    region.points.clear();
  };
  for (const FuzzySet::Point& point : set.points) {
    region.points.push_back(point);
    if (point.degree <= kNothing) {
      close();
      region.points.push_back(point);
    }
  }
  close();
  return regions;
}

std::array<FuzzySet*, 3> sets_of(CommandSets& sets) {
  return {&sets.left, &sets.right, &sets.lateral};
}

Motion command_of(const WheelPair& wheels, double left, double right, double lateral) {
  Motion command = wheels.motion({left, right});
  command.lateral = lateral;
  return command;
}

/// The area of a set below a region of another.
double area_below(const FuzzySet& set, const FuzzySet& region) {
  return fuzzy::area(fuzzy::restricted(set, region.points.front().x, region.points.back().x));
}

/// The part of a set's area below a region of another; 1 for a set without area: no wish.
double part_below(const FuzzySet& set, const FuzzySet& region) {
  const double all = fuzzy::area(set);
  return all > 0.0 ? area_below(set, region) / all : 1.0;
}

}  // namespace

elsie::ParameterFacts combination_facts() {
  return {
      .choices = {"max", "probabilistic_sum", "bounded_sum", "min", "product", "bounded_product"},
      .meaning =
          "the operator on the sets: the first three unite wishes (OR), the others keep "
          "what all wish for (AND)"};
}

elsie::ParameterFacts weighting_facts() {
  return {.choices = {"scale", "clip"},
          .meaning =
              "what a weight below 1 does to a set: all degrees are scaled, or the top is "
              "cut off (the mirror image of this with AND)"};
}

elsie::ParameterFacts defuzzification_facts() {
  return {.choices = {"centre_of_gravity", "mean_of_maximum", "bisector", "centre_of_largest_area"},
          .meaning = "how the command is computed from the combined set"};
}

elsie::ParameterFacts conflict_facts() {
  return {.choices = {"stop", "unite"},
          .meaning = "the command when none suits all (AND): zero, or that of the union"};
}

void SetFusion::configured() {
  operator_ = set_operator_of(combination);
  clip_ = weighting == "clip";
  defuzzifier_ = defuzzification == "mean_of_maximum"          ? Defuzzifier::mean_of_maximum
                 : defuzzification == "bisector"               ? Defuzzifier::bisector
                 : defuzzification == "centre_of_largest_area" ? Defuzzifier::centre_of_largest_area
                                                               : Defuzzifier::centre_of_gravity;
  activation_rule_ = activation_rule_of(activation);
}

Motion SetFusion::fuse(std::span<Member> members, const Perception& now) {
  const WheelPair& wheels = now.self().wheels;
  collect(members);
  combine(members, operator_);
  std::optional<Motion> command = settle(wheels);
  const bool conflicting = !command && !unites(operator_);
  if (conflicting && conflict == "unite") {
    combine(members, SetOperator::maximum);
    command = settle(wheels);
  }
  const char* reason = !command            ? (conflicting ? "no command suits all" : "no wish")
                       : conflicting       ? "united: no command suits all"
                       : unites(operator_) ? "united"
                                           : "intersected";
  for (Member& member : members) {
    if (member.trace.weight > 0.0) {
      member.trace.reason = reason;
    }
  }
  if (!command) {
    return {};
  }
  trace(members, wheels, *command);
  return *command;
}

void SetFusion::collect(std::span<Member> members) {
  wishes_.resize(members.size());
  weighted_.resize(members.size());
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (members[i].trace.weight > 0.0) {
      wishes_[i] = members[i].command_sets();
    } else {
      for (FuzzySet* set : sets_of(wishes_[i])) {
        set->points.clear();
      }
    }
  }
}

void SetFusion::combine(std::span<const Member> members, SetOperator by) {
  used_ = by;
  // A set without points means no wish for its channel: with AND it must not forbid everything.
  const auto add = [&](FuzzySet& sum, const FuzzySet& wish, FuzzySet& weighted_wish,
                       double weight) {
    weighted_wish.points.clear();
    if (!wish.points.empty()) {
      weighted_wish = weighted(wish, weight, clip_, by);
      sum = sum.points.empty() ? weighted_wish : combined(sum, weighted_wish, by);
    }
  };
  const auto together = sets_of(together_);
  for (FuzzySet* set : together) {
    set->points.clear();
  }
  for (std::size_t i = 0; i < wishes_.size(); ++i) {
    const auto wishes = sets_of(wishes_[i]);
    const auto weighted_wishes = sets_of(weighted_[i]);
    for (std::size_t channel = 0; channel < together.size(); ++channel) {
      add(*together[channel], *wishes[channel], *weighted_wishes[channel], members[i].trace.weight);
    }
  }
  for (FuzzySet* set : together) {
    for (FuzzySet::Point& point : set->points) {
      point.degree = std::clamp(point.degree, 0.0, 1.0);  // rounding
    }
  }
}

std::optional<Motion> SetFusion::settle(const WheelPair& wheels) const {
  const auto number = [&](const FuzzySet& set) {
    switch (defuzzifier_) {
      case Defuzzifier::mean_of_maximum:
        return fuzzy::mean_of_maxima(set);
      case Defuzzifier::bisector: {
        const auto middle = fuzzy::bisector(set);
        return middle ? middle : centre_of_gravity(set);
      }
      case Defuzzifier::centre_of_gravity:
      case Defuzzifier::centre_of_largest_area:
        break;
    }
    return centre_of_gravity(set);
  };
  if (defuzzifier_ == Defuzzifier::centre_of_largest_area) {
    return centre_of_largest_area(wheels);
  }
  const auto left = number(together_.left);
  const auto right = number(together_.right);
  // Nobody has a lateral wish if the drive has no such channel.
  const auto lateral =
      together_.lateral.points.empty() ? std::optional(0.0) : number(together_.lateral);
  return left && right && lateral ? std::optional(command_of(wheels, *left, *right, *lateral))
                                  : std::nullopt;
}

std::optional<Motion> SetFusion::centre_of_largest_area(const WheelPair& wheels) const {
  // If they were computed separately, the wheels could pair one behaviour's left with another one's
  // right. So pairs of regions are weighted by the wishes for both, and by the part of the lateral
  // wish in a third.
  constexpr double kEqualAreas = 1e-9;
  std::optional<Motion> best;
  double most = 0.0;
  std::vector<double> support(weighted_.size());
  std::vector<double> best_support;
  const std::vector<FuzzySet> rights = regions_of(together_.right);
  std::vector<FuzzySet> laterals = regions_of(together_.lateral);
  if (together_.lateral.points.empty()) {
    laterals.push_back(FuzzySet::triangle(0.0, 1.0));  // the drive has no such channel
  }
  for (const FuzzySet& left : regions_of(together_.left)) {
    for (const FuzzySet& right : rights) {
      for (const FuzzySet& lateral : laterals) {
        double sum = 0.0;
        for (std::size_t i = 0; i < weighted_.size(); ++i) {
          support[i] = area_below(weighted_[i].left, left) * area_below(weighted_[i].right, right) *
                       part_below(weighted_[i].lateral, lateral);
          sum += support[i];
        }
        // In a tie, the region of the first behaviour in the file.
        const bool equal = best && std::abs(sum - most) <= kEqualAreas * most;
        if (!best || (equal ? support > best_support : sum > most)) {
          most = sum;
          best_support = support;
          best = command_of(wheels, *centre_of_gravity(left), *centre_of_gravity(right),
                            *centre_of_gravity(lateral));
        }
      }
    }
  }
  return best;
}

void SetFusion::trace(std::span<Member> members, const WheelPair& wheels,
                      const Motion& command) const {
  const elsie::WheelRates rates = wheels.wheel_rates(command);
  const bool by_area =
      defuzzifier_ == Defuzzifier::centre_of_gravity || defuzzifier_ == Defuzzifier::bisector;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const CommandSets& wish = weighted_[i];
    elsie::TraceRow& row = members[i].trace;
    if (!unites(used_)) {
      row.share = row.weight;
    } else if (by_area) {
      row.share = fuzzy::area(wish.left) + fuzzy::area(wish.right) +
                  fuzzy::area(wish.lateral) / wheels.radius;
    } else {
      row.share = wish.left.degree(rates.left) + wish.right.degree(rates.right) +
                  wish.lateral.degree(command.lateral);
    }
  }
  normalize_shares(members);
}

void SetFusion::rate(std::span<Member> members, const Perception& /*now*/, const Motion& /*given*/,
                     std::span<const Motion> candidates, std::span<double> desirability) {
  std::fill(desirability.begin(), desirability.end(), 0.0);
  if (ratings_.size() < candidates.size()) {
    ratings_.resize(candidates.size());
  }
  const std::span<double> ratings = std::span(ratings_).first(candidates.size());
  bool first = true;
  for (Member& member : members) {
    const double weight = member.trace.weight;
    if (weight > 0.0) {
      member.rate(candidates, ratings);
      for (std::size_t i = 0; i < ratings.size(); ++i) {
        const double wish = weighted(ratings[i], weight, clip_, used_);
        const double sum = first ? wish : combined(desirability[i], wish, used_);
        desirability[i] = std::clamp(sum, 0.0, 1.0);  // rounding
      }
      first = false;
    }
  }
}

CommandSets SetFusion::command_sets(std::span<Member> /*members*/, const Perception& /*now*/,
                                    const Motion& /*given*/) {
  return together_;
}
