// Condenses many short episodes to a few.
#include <algorithm>
#include <cmath>
#include <vector>

#include "elsie/traces/trace_account.h"

namespace elsie::traces {
namespace {

using Part = Episode::Part;

void add_part(std::vector<Part>& parts, const Part& part) {
  const auto known = std::find_if(parts.begin(), parts.end(),
                                  [&](const Part& other) { return other.decider == part.decider; });
  if (known == parts.end()) {
    parts.push_back(part);
    return;
  }
  const double time = known->time_s + part.time_s;
  const auto mean = [&](double a, double b) {
    return time > 0.0 ? (a * known->time_s + b * part.time_s) / time : a;
  };
  known->share = mean(known->share, part.share);
  known->weight = mean(known->weight, part.weight);
  if (part.time_s > known->time_s) {
    known->reason = part.reason;
  }
  known->time_s = time;
}

/// Adds the later episode to the earlier one.
void join(Episode& earlier, const Episode& later) {
  earlier.to_s = later.to_s;
  earlier.switches += later.switches + 1;
  for (const Part& part : later.parts) {
    add_part(earlier.parts, part);
  }
  std::stable_sort(earlier.parts.begin(), earlier.parts.end(),
                   [](const Part& a, const Part& b) { return a.time_s > b.time_s; });
}

Decider main_decider(const Episode& episode) { return episode.parts[0].decider; }

/// The episodes; each run of episodes shorter than `least_s` is joined into one.
std::vector<Episode> with_flicker_joined(const std::vector<Episode>& episodes, double least_s) {
  std::vector<Episode> result;
  bool flickering = false;  // the last one is such a run
  for (const Episode& episode : episodes) {
    const bool is_short = episode.length_s() < least_s;
    if (is_short && flickering) {
      join(result.back(), episode);
    } else {
      result.push_back(episode);
    }
    flickering = is_short;
  }
  return result;
}

/// Gives episodes that are still shorter than `least_s` to a neighbour: between two of one decider,
/// to both; otherwise to the longer one, which it changes less.
std::vector<Episode> with_short_ones_given_away(const std::vector<Episode>& episodes,
                                                double least_s) {
  std::vector<Episode> result;
  bool take_next = false;  // the next one belongs to the last one of the result
  for (std::size_t i = 0; i < episodes.size(); ++i) {
    const Episode& episode = episodes[i];
    const bool is_short = episode.length_s() < least_s;
    const bool has_next = i + 1 < episodes.size();
    if (take_next) {
      join(result.back(), episode);
      take_next = false;
    } else if (!is_short) {
      result.push_back(episode);
    } else if (result.empty()) {
      result.push_back(episode);
      take_next = has_next;
    } else if (has_next && main_decider(result.back()) != main_decider(episodes[i + 1]) &&
               episodes[i + 1].length_s() > result.back().length_s()) {
      result.push_back(episode);
      take_next = true;
    } else {
      take_next = has_next && main_decider(result.back()) == main_decider(episodes[i + 1]);
      join(result.back(), episode);
    }
  }
  return result;
}

/// The episodes when everything shorter than `least_s` counts as flicker.
std::vector<Episode> simplified(const std::vector<Episode>& episodes, double least_s) {
  return with_short_ones_given_away(with_flicker_joined(episodes, least_s), least_s);
}

}  // namespace

std::vector<Episode> condensed(std::vector<Episode> episodes, std::size_t most) {
  most = std::max<std::size_t>(most, 1);
  if (episodes.size() <= most) {
    return episodes;
  }
  // The limit is searched between almost zero and more than all episodes together, which is enough.
  // A longer limit does not always give fewer episodes; any limit that is found will do.
  double enough = 2.0 * (episodes.back().to_s - episodes.front().from_s);
  double too_short = 1e-9 * enough;
  constexpr double kNearEnough = 1.02;
  while (enough > kNearEnough * too_short) {
    const double middle = std::sqrt(too_short * enough);
    (simplified(episodes, middle).size() <= most ? enough : too_short) = middle;
  }
  return simplified(episodes, enough);
}

}  // namespace elsie::traces
