#include "desirability.h"

#include <algorithm>

#include <elsie/fuzzy/sets.h>

#include "weighing.h"

namespace {

double weight_of_all(std::span<const elsie::Member> members) {
  double sum = 0.0;
  for (const elsie::Member& member : members) {
    sum += member.trace.weight;
  }
  return sum;
}

}  // namespace

void Desirability::rate_one(elsie::Member& member, std::span<const elsie::Motion> candidates,
                            std::span<double> ratings) {
  const elsie::Motion wish = member.respond().command;
  if (space_.fastest(wish) <= limit_) {
    member.rate(candidates, ratings);
    return;
  }
  stretched_.assign(candidates.begin(), candidates.end());
  for (elsie::Motion& candidate : stretched_) {
    const double fastest = space_.fastest(candidate);
    if (fastest > 0.0 && fastest >= limit_ * (1.0 - kEqual)) {
      // The point of the ray nearest to the wish.
      const double along = space_.dot(candidate, wish) / space_.dot(candidate, candidate);
      candidate = std::max(along, limit_ / fastest) * candidate;
    }
  }
  member.rate(stretched_, ratings);
}

void Desirability::rate(std::span<elsie::Member> members, std::span<const elsie::Motion> candidates,
                        std::span<double> mean) {
  std::fill(mean.begin(), mean.end(), 0.0);
  const double all = weight_of_all(members);
  if (ratings_.size() < candidates.size()) {
    ratings_.resize(candidates.size());
  }
  const std::span<double> ratings = std::span(ratings_).first(candidates.size());
  for (elsie::Member& member : members) {
    if (member.trace.weight > 0.0) {
      rate_one(member, candidates, ratings);
      const double part = member.trace.weight / all;
      for (std::size_t i = 0; i < ratings.size(); ++i) {
        mean[i] += part * ratings[i];
      }
    }
  }
  for (double& value : mean) {
    value = std::min(value, 1.0);  // rounding may make the sum exceed one
  }
}

void Desirability::trace_shares(std::span<elsie::Member> members, const elsie::Motion& command) {
  for (elsie::Member& member : members) {
    if (member.trace.weight > 0.0) {
      double rating = 0.0;
      rate_one(member, {&command, 1}, {&rating, 1});
      member.trace.share = member.trace.weight * rating;
    }
  }
  normalize_shares(members);
}

elsie::CommandSets Desirability::sets(std::span<elsie::Member> members) {
  const double all = weight_of_all(members);
  elsie::CommandSets mean;
  for (elsie::Member& member : members) {
    if (member.trace.weight > 0.0) {
      const double part = member.trace.weight / all;
      const elsie::CommandSets wish = member.command_sets();
      mean.left = elsie::fuzzy::weighted_sum_of(mean.left, 1.0, wish.left, part);
      mean.right = elsie::fuzzy::weighted_sum_of(mean.right, 1.0, wish.right, part);
      mean.lateral = elsie::fuzzy::weighted_sum_of(mean.lateral, 1.0, wish.lateral, part);
    }
  }
  for (elsie::FuzzySet* set : {&mean.left, &mean.right, &mean.lateral}) {
    for (elsie::FuzzySet::Point& point : set->points) {
      point.degree = std::min(point.degree, 1.0);
    }
  }
  return mean;
}
