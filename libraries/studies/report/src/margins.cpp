#include "elsie/report/margins.h"

#include <algorithm>
#include <map>

#include "elsie/base/words.h"
#include "elsie/files/clean_text.h"

#include "copies.h"
#include "numbers.h"

namespace elsie::report {

namespace {

using Levels = std::vector<std::string>;

std::set<Levels> rests_of(const Findings& findings, const std::vector<std::size_t>& cells,
                          const std::vector<std::size_t>& named) {
  std::set<Levels> rests;
  for (const std::size_t cell : cells) {
    rests.insert(levels_without(findings.results.cells[cell], named));
  }
  return rests;
}

// Leaves the cells of which every group with values has a match.
void keep_matches(const Findings& findings, const std::vector<std::size_t>& named,
                  Balance& balance) {
  std::optional<std::set<Levels>> in_all;
  for (const std::vector<std::size_t>& group : balance.groups) {
    if (group.empty()) {
      continue;
    }
    const std::set<Levels> rests = rests_of(findings, group, named);
    if (!in_all) {
      in_all = rests;
      continue;
    }
    std::erase_if(*in_all, [&](const Levels& levels) { return !rests.contains(levels); });
  }
  balance.confounded = in_all && in_all->empty();
  if (!in_all || balance.confounded) {
    return;
  }
  for (std::vector<std::size_t>& group : balance.groups) {
    balance.dropped_cells += std::erase_if(group, [&](std::size_t cell) {
      return !in_all->contains(levels_without(findings.results.cells[cell], named));
    });
  }
}

// Cells whose seeds all gave one run add no uncertainty.
std::optional<Interval> rate_interval(const Findings& findings,
                                      const std::vector<Observation>& all) {
  double known = 0.0, hits = 0.0;
  std::vector<Observation> others;
  for (const Observation& one : all) {
    if (findings.cells[one.cell].one_run) {
      known += one.of.value;
    } else {
      hits += one.of.value;
      others.push_back(one);
    }
  }
  if (others.empty()) {
    return std::nullopt;
  }
  const auto trials = static_cast<double>(others.size());
  const Interval own = wilson_interval_of_rate(hits / trials, effective_count(others), kConfidence);
  const auto count = static_cast<double>(all.size());
  const double part = trials / count;
  return Interval{known / count + part * own.low, known / count + part * own.high};
}

}  // namespace

Balance balanced(const Findings& findings, const Response& response,
                 const std::vector<std::vector<std::size_t>>& groups,
                 const std::vector<std::size_t>& named) {
  std::map<std::size_t, std::set<std::uint64_t>> seeds_of;
  Balance balance;
  for (const Observation& one : observations(findings, response, all_cells(findings))) {
    seeds_of[one.cell].insert(one.seed);
    balance.medians |= one.of.bound;
  }
  for (const std::vector<std::size_t>& group : groups) {
    std::vector<std::size_t>& cells = balance.groups.emplace_back();
    std::copy_if(group.begin(), group.end(), std::back_inserter(cells),
                 [&](std::size_t cell) { return seeds_of.contains(cell); });
  }
  keep_matches(findings, named, balance);
  std::map<std::uint64_t, std::size_t> values_of;  // how many cells have a value, by seed
  for (const std::vector<std::size_t>& group : balance.groups) {
    for (const std::size_t cell : group) {
      ++balance.cells;
      balance.one_run += findings.cells[cell].one_run ? 1 : 0;
      for (const std::uint64_t seed : seeds_of[cell]) {
        ++values_of[seed];
      }
    }
  }
  for (const auto& [seed, count] : values_of) {
    if (count == balance.cells) {
      balance.seeds.insert(seed);
    } else {
      ++balance.dropped_seeds;
    }
  }
  return balance;
}

std::vector<Observation> observations(const Findings& findings, const Response& response,
                                      const Balance& balance, std::size_t group, bool once) {
  std::vector<Observation> all = observations(findings, response, balance.groups[group]);
  std::erase_if(all, [&](const Observation& one) {
    const bool is_copy = once && findings.cells[one.cell].one_run && !balance.seeds.empty() &&
                         one.seed != *balance.seeds.begin();
    return is_copy || !balance.seeds.contains(one.seed);
  });
  return all;
}

std::vector<std::string> notes_on(const Balance& balance) {
  std::vector<std::string> notes;
  if (balance.cells > 0 && balance.seeds.empty()) {
    notes.emplace_back("no seed has a value in each of the cells, so there is no number");
  } else if (balance.dropped_seeds > 0) {
    notes.push_back(counted(balance.dropped_seeds, "seed is", "seeds are") +
                    " left out, without a value in some of the cells; " +
                    counted(balance.seeds.size(), "seed") + " left");
  }
  if (balance.confounded) {
    notes.emplace_back(
        "no cells match in all other factors, so the difference may come from these instead");
  } else if (balance.dropped_cells > 0) {
    notes.push_back(counted(balance.dropped_cells, "cell is", "cells are") +
                    " left out, without a match in all other factors");
  }
  if (balance.certain()) {
    notes.emplace_back(
        "all seeds of each cell gave one and the same run: nothing is random, so there are no "
        "intervals and no tests");
  } else if (balance.one_run > 0) {
    notes.push_back("all seeds of " + counted(balance.one_run, "cell") +
                    " gave one and the same run, which counts once in a pooled test");
  }
  return notes;
}

std::vector<std::string> gathered(
    const std::vector<std::pair<std::string, std::vector<std::string>>>& notes) {
  constexpr std::size_t kNamed = 4;
  std::vector<std::string> order;
  std::map<std::string, std::vector<std::string>> names;
  for (const auto& [name, sentences] : notes) {
    for (const std::string& sentence : sentences) {
      if (names[sentence].empty()) {
        order.push_back(sentence);
      }
      names[sentence].push_back(name);
    }
  }
  for (std::string& sentence : order) {
    std::vector<std::string>& of = names[sentence];
    if (of.size() == notes.size()) {
      continue;
    }
    if (of.size() > kNamed) {
      of.erase(of.begin() + kNamed, of.end());
      of.emplace_back("...");
    }
    sentence = base::joined(of, "; ") + ": " + sentence;
  }
  return order;
}

std::vector<std::string> notes_on_effects(const Findings& findings, const Response& response) {
  std::vector<std::pair<std::string, std::vector<std::string>>> notes;
  for (const VariedFactor& factor : varied_factors(findings.results)) {
    notes.emplace_back(files::one_line(factor.name),
                       notes_on(balanced(findings, response, factor.groups(), {factor.factor})));
  }
  return gathered(notes);
}

Margin margin_of(const Findings& findings, const Response& response, const Balance& balance,
                 std::size_t group, bool with_interval) {
  const std::vector<Observation> all = observations(findings, response, balance, group, false);
  Margin margin;
  margin.runs = all.size();
  margin.seeds = balance.seeds.size();
  margin.dropped_seeds = balance.dropped_seeds;
  margin.dropped_cells = balance.dropped_cells;
  margin.median = balance.medians;
  if (all.empty()) {
    return margin;
  }
  margin.effective = effective_count(all);
  const auto& cells = balance.groups[group];
  const auto fixed = std::count_if(cells.begin(), cells.end(),
                                   [&](std::size_t cell) { return findings.cells[cell].one_run; });
  std::map<std::uint64_t, std::vector<double>> by_seed;
  std::vector<Observed> observed;
  double sum = 0.0;
  for (const Observation& one : all) {
    margin.cut_off += one.of.bound ? 1 : 0;
    by_seed[one.seed].push_back(one.of.value);
    observed.push_back(one.of);
    sum += one.of.value;
  }
  if (!response.measure) {
    margin.centre = sum / static_cast<double>(all.size());
    margin.interval = rate_interval(findings, all);
    return margin;
  }
  if (balance.medians) {
    const SurvivalCurve curve =
        survival_of(observed, kConfidence, static_cast<double>(all.size()) / margin.effective);
    margin.centre = curve.median;
    margin.interval = fixed > 0 ? std::nullopt : curve.median_interval;
    if (!margin.centre && !margin.interval) {
      for (const Observed& one : observed) {
        if (one.bound) margin.at_least = std::min(one.value, margin.at_least.value_or(one.value));
      }
    }
    return margin;
  }
  std::vector<double> means;
  for (const auto& [seed, values] : by_seed) {
    means.push_back(*statistic_of(Statistic::mean, values));
  }
  margin.centre = summary(means)->mean;
  if (with_interval && fixed < std::ssize(cells)) {
    margin.interval = mean_interval(means, kConfidence, findings.results.seed(), response.name);
  }
  return margin;
}

}  // namespace elsie::report
