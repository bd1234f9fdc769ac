#include <algorithm>
#include <cmath>
#include <map>

#include "judging.h"
#include "numbers.h"
#include "words.h"

namespace elsie::report {

using experiment::Runs;

namespace {

// The values of both cells for each seed. Seeds with only one value are left out: those with which
// one cell fails may be the hard ones.
std::vector<Pair> pairs_of(const Judging& judging, std::size_t cell, std::size_t reference) {
  std::map<std::uint64_t, double> others;
  for (const std::size_t run : judging.findings.cells[reference].runs) {
    if (const auto value = judging.value_of(judging.results.runs[run])) {
      others[judging.results.runs[run].seed] = *value;
    }
  }
  std::map<std::uint64_t, Pair> pairs;
  for (const std::size_t run : judging.findings.cells[cell].runs) {
    const auto value = judging.value_of(judging.results.runs[run]);
    const auto other = others.find(judging.results.runs[run].seed);
    if (value && other != others.end()) {
      pairs[judging.results.runs[run].seed] = {*value, other->second};
    }
  }
  std::vector<Pair> all;
  for (const auto& [seed, pair] : pairs) {
    all.push_back(pair);
  }
  return all;
}

// Whether both cells gave the same runs, bit by bit: what tells them apart had no effect.
bool are_same(const Judging& judging, std::size_t cell, std::size_t reference) {
  const auto originals = [&](std::size_t of) {
    std::map<std::uint64_t, std::size_t> by_seed;
    for (const std::size_t run : judging.findings.cells[of].runs) {
      by_seed[judging.results.runs[run].seed] = judging.findings.originals[run];
    }
    return by_seed;
  };
  return originals(cell) == originals(reference);
}

std::string no_pair(const Judging& judging, std::size_t cell, std::size_t reference) {
  for (const std::size_t each : {cell, reference}) {
    if (const auto values = judging.values_of(each); values.empty()) {
      return judging.unknown(each, values);
    }
  }
  return "there is no seed with which " + judging.label(cell) + " and " + judging.label(reference) +
         (judging.expectation.runs == Runs::successes ? " both succeeded" : " both have a value");
}

// "; of the seeds with which both succeeded", or "" if these are all seeds.
std::string left_out(const Judging& judging, std::size_t cell, std::size_t reference,
                     std::size_t pairs) {
  const std::size_t most = std::max(judging.findings.cells[cell].runs.size(),
                                    judging.findings.cells[reference].runs.size());
  return pairs == most ? ""
         : judging.expectation.runs == Runs::successes
             ? "; of the seeds with which both succeeded"
             : "; of the seeds for which both have a value";
}

std::optional<Interval> interval_of(const Judging& judging, const std::vector<Pair>& pairs) {
  if (judging.expectation.statistic != Statistic::rate) {
    return paired_interval(judging.expectation.relation, judging.expectation.statistic, pairs,
                           *judging.expectation.confidence, judging.results.seed(),
                           judging.stream());
  }
  Frequency own{0, pairs.size()}, other{0, pairs.size()};
  for (const Pair& pair : pairs) {
    own.hits += pair.cell != 0.0 ? 1 : 0;
    other.hits += pair.reference != 0.0 ? 1 : 0;
  }
  return interval_of_rates(judging.expectation.relation, own, other,
                           *judging.expectation.confidence);
}

}  // namespace

Claim judge_pair(const Judging& judging, std::size_t cell, std::optional<std::size_t> reference) {
  if (!reference) {
    return judging.not_known(cell, "there is no cell to compare it with");
  }
  for (const std::size_t each : {cell, *reference}) {
    if (const auto claim = judging.obstacle(cell, each)) {
      return *claim;
    }
    if (judging.censored(each) > 0) {
      return judging.not_known(cell, "of " + judging.label(each) + " " + judging.stopped(each));
    }
  }
  const std::vector<Pair> pairs = pairs_of(judging, cell, *reference);
  if (pairs.empty()) {
    return judging.not_known(cell, no_pair(judging, cell, *reference));
  }
  std::vector<double> own, others;
  for (const Pair& pair : pairs) {
    own.push_back(pair.cell);
    others.push_back(pair.reference);
  }
  const auto mine = statistic_of(judging.expectation.statistic, own);
  const auto theirs = statistic_of(judging.expectation.statistic, others);
  const bool ratio = judging.expectation.relation == Relation::ratio;
  if (ratio && theirs == 0.0) {
    return judging.not_known(cell, "that of " + judging.label(*reference) + " is 0");
  }
  Claim claim;
  claim.cell = cell;
  claim.value = relation_of(judging.expectation.relation, judging.expectation.statistic, pairs);
  if (!claim.value || !mine || !theirs) {
    return judging.not_known(
        cell, "that of " + judging.label(*reference) + " has no value to compare it with");
  }
  claim.holds = judging.keeps(*claim.value);
  // Of the same runs, all pairs are equal: nothing about their difference is random.
  const bool same = are_same(judging, cell, *reference) &&
                    std::all_of(pairs.begin(), pairs.end(),
                                [](const Pair& pair) { return pair.cell == pair.reference; });
  if (judging.expectation.confidence) {
    claim.interval =
        same ? std::optional(Interval{*claim.value, *claim.value}) : interval_of(judging, pairs);
    claim.holds = judging.keeps(claim.interval);
  }
  claim.found = judging.subject.words + " of " + judging.label(cell) + " is " +
                (ratio ? judging.shown(*claim.value) + " times that of "
                       : judging.with_unit(std::abs(*claim.value)) +
                             (*claim.value < 0.0 ? " less" : " more") + " than that of ") +
                judging.label(*reference) + " (" + judging.with_unit(*mine) + ", " +
                judging.basis(own) + judging.reservations(cell) + ", against " +
                judging.with_unit(*theirs) + ", " + judging.basis(others) +
                judging.reservations(*reference) +
                left_out(judging, cell, *reference, pairs.size()) +
                (same ? "; the same runs, bit by bit" : "") +
                (ratio && pairs.size() > 1 && !claim.interval && judging.expectation.confidence
                     ? "; no interval, as that of " + judging.label(*reference) + " may be 0"
                     : judging.interval_in_words(claim.interval)) +
                ")";
  claim.sentence = claim.found + ", expected " + judging.limits();
  return claim;
}

}  // namespace elsie::report
