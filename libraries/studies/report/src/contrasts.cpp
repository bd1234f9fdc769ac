#include "elsie/report/contrasts.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "elsie/base/words.h"
#include "elsie/experiment/where.h"
#include "elsie/files/clean_text.h"

#include "copies.h"
#include "numbers.h"

namespace elsie::report {

namespace {

// One seed's observations in matching cells, by group.
struct Match {
  std::vector<Observed> first, second;
  std::vector<std::size_t> originals_first, originals_second;
};

using Matches = std::map<std::uint64_t, std::map<std::vector<std::string>, Match>>;

Matches match(const Findings& findings, const std::vector<Observation>& first,
              const std::vector<Observation>& second, const std::vector<std::size_t>& named) {
  Matches matches;
  const auto add = [&](const std::vector<Observation>& all, std::vector<Observed> Match::*group,
                       std::vector<std::size_t> Match::*originals) {
    for (const Observation& one : all) {
      Match& match = matches[one.seed][levels_without(findings.results.cells[one.cell], named)];
      (match.*group).push_back(one.of);
      (match.*originals).push_back(one.original);
    }
  };
  add(first, &Match::first, &Match::originals_first);
  add(second, &Match::second, &Match::originals_second);
  return matches;
}

// Whether all matching runs are the same bit by bit, and their values too.
bool are_same(const Matches& matches) {
  for (const auto& [seed, by_levels] : matches) {
    for (const auto& entry : by_levels) {
      const Match& one = entry.second;
      std::vector<std::size_t> all = one.originals_first;
      all.insert(all.end(), one.originals_second.begin(), one.originals_second.end());
      const auto is_first = [&](const Observed& each) {
        return each.value == one.first.front().value && each.bound == one.first.front().bound;
      };
      if (one.first.empty() || one.second.empty() ||
          std::count(all.begin(), all.end(), all.front()) != std::ssize(all) ||
          !std::all_of(one.first.begin(), one.first.end(), is_first) ||
          !std::all_of(one.second.begin(), one.second.end(), is_first)) {
        return false;
      }
    }
  }
  return !matches.empty();
}

double mean_value(const std::vector<Observed>& all) {
  double sum = 0.0;
  for (const Observed& one : all) {
    sum += one.value;
  }
  return sum / static_cast<double>(all.size());
}

// A difference this small, relative to the largest value, comes from the rounding of means.
constexpr double kRoundingOfMeans = 1e-12;
constexpr const char* kRoundingNote =
    "differences of less than a millionth of the values come from rounding, and count as 0";

double largest_size(const Matches& matches) {
  double largest = 0.0;
  for (const auto& [seed, by_levels] : matches) {
    for (const auto& [levels, one] : by_levels) {
      for (const std::vector<Observed>* const group : {&one.first, &one.second}) {
        for (const Observed& each : *group) {
          largest = std::max(largest, std::abs(each.value));
        }
      }
    }
  }
  return largest;
}

// The difference of two means, without rounding; `rounded` becomes true where that is left out.
double difference_of(const Match& match, bool& rounded) {
  const double first = mean_value(match.first), second = mean_value(match.second);
  if (!are_equal(std::min(first, second), std::max(first, second))) {
    return first - second;
  }
  rounded |= std::abs(first - second) > kRoundingOfMeans * std::abs(first);
  return 0.0;
}

void pair_up(const Findings& findings, const Matches& matches, bool bounds, Contrast& contrast) {
  const double rounding = kRoundingOfMeans * (bounds ? 1.0 : largest_size(matches));
  std::vector<double> differences;
  bool rounded = false;
  for (const auto& [seed, by_levels] : matches) {
    double sum = 0.0, count = 0.0;
    for (const auto& [levels, one] : by_levels) {
      if (one.first.empty() || one.second.empty()) {
        continue;
      }
      // Of bounds, only the order is known.
      sum += bounds ? rank_test(one.first, one.second, kConfidence).delta.value
                    : difference_of(one, rounded);
      count += 1.0;
    }
    if (count > 0.0) {
      const double difference = sum / count;
      differences.push_back(std::abs(difference) <= rounding ? 0.0 : difference);
    }
  }
  if (rounded) {
    contrast.notes.emplace_back(kRoundingNote);
  }
  contrast.seeds = differences.size();
  contrast.paired = signed_rank_test(differences);
  if (!bounds && !differences.empty()) {
    contrast.difference = summary(differences)->mean;
    contrast.interval = mean_interval(differences, kConfidence, findings.results.seed(),
                                      "difference of " + contrast.response.name);
  }
}

[[noreturn]] void refuse(const std::string& sentence) { throw std::invalid_argument(sentence); }

/// Gives values that are_equal() one value, the least of them.
class Rounding {
 public:
  explicit Rounding(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    for (const double value : values) {
      if (least_.empty() || !are_equal(least_.back(), value)) least_.push_back(value);
    }
  }
  double operator()(double value) const {
    return *std::prev(std::upper_bound(least_.begin(), least_.end(), value));
  }
  bool leaves_one() const { return least_.size() == 1; }

 private:
  std::vector<double> least_;
};

std::string interval_text(const std::optional<Interval>& interval, int digits) {
  return interval ? brief(interval->low, digits) + " to " + brief(interval->high, digits) : "";
}

std::string effect_text(const std::optional<Effect>& effect) {
  return effect ? brief(effect->value, 3) + (effect->interval ? " (" : "") +
                      interval_text(effect->interval, 3) + (effect->interval ? ")" : "")
                : "-";
}

}  // namespace

std::optional<Contrast> contrast(const Findings& findings, const Response& response,
                                 const Group& first, const Group& second,
                                 const std::vector<std::size_t>& named) {
  const Balance balance = balanced(findings, response, {first.cells, second.cells}, named);
  const auto different = [&](std::size_t group) {
    return without_copies(observations(findings, response, balance, group, true));
  };
  const std::vector<Observation> of_first = different(0), of_second = different(1);
  if (of_first.empty() || of_second.empty()) {
    return std::nullopt;
  }
  Contrast found;
  found.response = response;
  found.first = first.name;
  found.second = second.name;
  found.of_first = margin_of(findings, response, balance, 0);
  found.of_second = margin_of(findings, response, balance, 1);
  found.certain = balance.certain();
  found.notes = notes_on(balance);
  bool bounds = false;
  std::vector<double> all_values;
  for (const std::vector<Observation>* const group : {&of_first, &of_second}) {
    for (const Observation& one : *group) {
      bounds |= one.of.bound;
      all_values.push_back(one.of.value);
    }
  }
  const Rounding rounded(std::move(all_values));
  found.equal = !bounds && rounded.leaves_one();
  std::vector<Observed> a, b;
  std::vector<double> values_a, values_b;
  const auto take = [&](const std::vector<Observation>& from, std::vector<Observed>& to,
                        std::vector<double>& values) {
    for (const Observation& one : from) {
      to.push_back({rounded(one.of.value), one.of.bound});
      values.push_back(to.back().value);
    }
  };
  take(of_first, a, values_a);
  take(of_second, b, values_b);
  if (!response.measure) {
    const auto frequency = [](const std::vector<double>& values) {
      return Frequency{static_cast<std::size_t>(std::count(values.begin(), values.end(), 1.0)),
                       values.size()};
    };
    found.effect = odds_ratio(frequency(values_a), frequency(values_b), kConfidence);
    found.pooled_p = fisher_test(frequency(values_a), frequency(values_b));
  } else {
    const RankTest test = rank_test(a, b, kConfidence);
    found.effect = test.delta;
    found.pooled_p = test.p;
    found.pooled_exact = test.exact;
    if (!bounds) {
      found.g = hedges_g(values_a, values_b, kConfidence);
    }
  }
  const auto all = [&](std::size_t group) {
    return observations(findings, response, balance, group, false);
  };
  const Matches matches = match(findings, all(0), all(1), named);
  found.same = are_same(matches);
  pair_up(findings, matches, bounds, found);
  if (found.certain) {
    found.effect.interval.reset();
    found.interval.reset();
    found.g.reset();
    found.pooled_p = found.paired.p = 1.0;
  }
  found.pooled_holm = found.pooled_p;
  found.paired_holm = found.paired.p;
  return found;
}

void correct(std::vector<Contrast*> contrasts) {
  std::erase_if(contrasts, [](const Contrast* one) { return !one->is_tested(); });
  std::vector<double> pooled, paired;
  for (const Contrast* one : contrasts) {
    pooled.push_back(one->pooled_p);
    paired.push_back(one->paired.p);
  }
  pooled = holm(pooled);
  paired = holm(paired);
  for (std::size_t i = 0; i < contrasts.size(); ++i) {
    contrasts[i]->pooled_holm = pooled[i];
    contrasts[i]->paired_holm = paired[i];
  }
}

std::vector<Contrast> level_contrasts(const Findings& findings, const Response& response) {
  std::vector<Contrast> all;
  for (const VariedFactor& factor : varied_factors(findings.results)) {
    if (factor.levels.size() > kMostLevels) {
      continue;
    }
    for (std::size_t i = 0; i < factor.levels.size(); ++i) {
      for (std::size_t j = i + 1; j < factor.levels.size(); ++j) {
        const Group first{factor.name + "=" + factor.levels[j], factor.cells_at(j)},
            second{factor.levels[i], factor.cells_at(i)};
        if (auto one = contrast(findings, response, first, second, {factor.factor})) {
          all.push_back(std::move(*one));
        }
      }
    }
  }
  std::vector<Contrast*> corrected;
  for (Contrast& one : all) {
    corrected.push_back(&one);
  }
  correct(std::move(corrected));
  return all;
}

Group group_of(const Findings& findings, const std::string& text, std::vector<std::size_t>& named) {
  const Results& results = findings.results;
  for (std::size_t i = 0; i < results.cells.size(); ++i) {
    if (results.cells[i].label == text) {
      for (std::size_t factor = 0; factor < results.factors.size(); ++factor) {
        named.push_back(factor);
      }
      return {text, {i}};
    }
  }
  if (text.find('=') == std::string::npos) {
    refuse("there is no cell '" + files::one_line(text) +
           "'; expected the name of a cell, or levels as in 'FACTOR=LEVEL|LEVEL; FACTOR=LEVEL'");
  }
  const experiment::Grid grid = grid_of(results);
  const std::vector<experiment::Where> where = experiment::parse_where(text, grid.labels());
  for (const experiment::Where& one : where) {
    named.push_back(*grid.place_of(one.factor));
  }
  Group group{text, grid.cells_of(where)};
  if (group.cells.empty()) {
    refuse("no cell has all the levels of '" + files::one_line(text) +
           "'; name a combination that was run");
  }
  return group;
}

std::vector<Contrast> compare(const Findings& findings, const std::string& first,
                              const std::string& second) {
  std::vector<std::size_t> named;
  const Group a = group_of(findings, first, named), b = group_of(findings, second, named);
  if (const auto both = common(a.cells, b.cells); !both.empty()) {
    refuse("'" + files::one_line(first) + "' and '" + files::one_line(second) +
           "' have the cell '" + files::one_line(findings.results.cells[both.front()].label) +
           "' in common, and a cell cannot be compared with itself; name groups without a common "
           "cell");
  }
  std::set<std::uint64_t> seeds;
  for (const Run& run : findings.results.runs) {
    if (run.ended()) {
      seeds.insert(run.seed);
    }
  }
  if (seeds.size() < 2) {
    refuse("there are runs of " + counted(seeds.size(), "seed") +
           " only, and a comparison needs at least two; run the experiment with more seeds");
  }
  std::vector<Contrast> all;
  bool equal = true, same = true;
  std::string incomplete;
  for (const Response& response : responses(findings)) {
    const Balance balance = balanced(findings, response, {a.cells, b.cells}, named);
    if (balance.seeds.size() < 2 && balance.dropped_seeds > 0) {
      incomplete = response.name;
      continue;
    }
    if (auto one = contrast(findings, response, a, b, named)) {
      equal &= one->equal || one->same;
      same &= one->same;
      all.push_back(std::move(*one));
    }
  }
  if (all.empty() && !incomplete.empty()) {
    refuse("fewer than two seeds have a value of '" + files::one_line(incomplete) +
           "' in each cell of '" + files::one_line(first) + "' and '" + files::one_line(second) +
           "', and a comparison needs at least two; do the runs that are missing, or compare fewer "
           "cells");
  }
  if (all.empty()) {
    refuse("no measure has a value in both '" + files::one_line(first) + "' and '" +
           files::one_line(second) + "'; compare cells with runs that ended normally");
  }
  if (same) {
    refuse("the runs of '" + files::one_line(first) + "' and '" + files::one_line(second) +
           "' are the same, bit by bit: what tells them apart had no effect, so there is nothing "
           "to compare");
  }
  if (equal) {
    refuse("all runs of '" + files::one_line(first) + "' and '" + files::one_line(second) +
           "' have equal values, up to rounding, so there is nothing to compare");
  }
  return all;
}

std::vector<std::string> contrast_notes(const std::vector<Contrast>& contrasts,
                                        bool with_response) {
  std::vector<std::pair<std::string, std::vector<std::string>>> notes;
  for (const Contrast& one : contrasts) {
    notes.emplace_back(
        files::one_line(with_response ? one.response.name : one.first + " against " + one.second),
        one.notes);
  }
  return gathered(notes);
}

std::vector<std::vector<std::string>> contrast_table(const std::vector<Contrast>& contrasts,
                                                     bool with_response) {
  // Success alone has no g.
  const bool with_g = std::any_of(contrasts.begin(), contrasts.end(),
                                  [](const Contrast& one) { return one.g.has_value(); });
  std::vector<std::vector<std::string>> rows{{"first", "second", "difference by seed", "effect"}};
  if (with_g) {
    rows[0].emplace_back("Hedges' g");
  }
  rows[0].insert(rows[0].end(), {"p by seed", "p pooled"});
  if (with_response) {
    rows[0].insert(rows[0].begin(), "measure");
  }
  for (const Contrast& one : contrasts) {
    std::vector<std::string> row{files::one_line(one.first), files::one_line(one.second)};
    if (with_response) {
      row.insert(row.begin(), files::one_line(one.response.name));
    }
    if (one.same || one.equal) {
      row.emplace_back(one.same ? "the same runs" : "equal");
    } else {
      row.push_back(one.difference
                        ? brief(*one.difference, 3) +
                              (one.interval ? " (" + interval_text(one.interval, 3) + ")" : "")
                        : "-");
      row.push_back((one.response.measure ? "delta " : "odds ") + effect_text(one.effect));
      if (with_g) {
        row.push_back(effect_text(one.g));
      }
      row.push_back(one.is_tested() ? p_text(one.paired_holm) : "-");
      row.push_back(one.is_tested() ? p_text(one.pooled_holm) : "-");
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace elsie::report
