#include "copies.h"

#include <algorithm>
#include <bit>
#include <map>
#include <set>
#include <tuple>

#include "elsie/base/words.h"
#include "elsie/files/clean_text.h"

#include "numbers.h"

namespace elsie::report {

namespace {

// Where only the measure is varied, and not the run, the same run has different values.
using CopyKey = std::tuple<std::size_t, std::uint64_t, bool>;

CopyKey key_of(const Observation& one) {
  return {one.original, std::bit_cast<std::uint64_t>(one.of.value), one.of.bound};
}

std::map<CopyKey, double> numbers_of_copies(const std::vector<Observation>& all) {
  std::map<CopyKey, double> numbers;
  for (const Observation& one : all) {
    numbers[key_of(one)] += 1.0;
  }
  return numbers;
}

}  // namespace

std::vector<Observation> without_copies(const std::vector<Observation>& all) {
  std::set<CopyKey> known;
  std::vector<Observation> different;
  std::copy_if(all.begin(), all.end(), std::back_inserter(different),
               [&](const Observation& one) { return known.insert(key_of(one)).second; });
  return different;
}

std::vector<double> shares_of(const std::vector<Observation>& all) {
  const std::map<CopyKey, double> numbers = numbers_of_copies(all);
  std::vector<double> shares;
  for (const Observation& one : all) {
    shares.push_back(1.0 / numbers.at(key_of(one)));
  }
  return shares;
}

double effective_count(const std::vector<Observation>& all) {
  double count = 0.0, squares = 0.0;
  for (const auto& [key, number] : numbers_of_copies(all)) {
    count += number;
    squares += number * number;
  }
  return squares > 0.0 ? count * count / squares : 0.0;
}

std::vector<Copies> copies_by_factor(const Findings& findings) {
  const Results& results = findings.results;
  std::vector<Copies> all;
  for (const VariedFactor& factor : varied_factors(results)) {
    std::map<std::pair<std::vector<std::string>, std::uint64_t>, std::vector<std::size_t>> cases;
    for (std::size_t i = 0; i < findings.cells.size(); ++i) {
      const auto others = levels_without(results.cells[i], {factor.factor});
      for (const std::size_t place : findings.cells[i].runs) {
        if (results.runs[place].state == RunState::done) {
          cases[{others, results.runs[place].seed}].push_back(findings.originals[place]);
        }
      }
    }
    Copies& copies = all.emplace_back();
    copies.factor = factor.name;
    for (const auto& [key, originals] : cases) {
      const std::size_t different = std::set(originals.begin(), originals.end()).size();
      copies.cases += originals.size() > 1 ? 1 : 0;
      copies.all_same += originals.size() > 1 && different == 1 ? 1 : 0;
      copies.some_same += different < originals.size() ? 1 : 0;
    }
  }
  return all;
}

std::size_t count_copies(const Findings& findings) {
  std::size_t copies = 0;
  for (const CellFindings& cell : findings.cells) {
    for (const std::size_t place : cell.runs) {
      copies += findings.originals[place] != place ? 1 : 0;
    }
  }
  return copies;
}

std::string copies_in_words(const Findings& findings) {
  const std::size_t copies = count_copies(findings);
  if (copies == 0) {
    return "";
  }
  const std::vector<Run>& runs = findings.results.runs;
  const bool all_ended = std::all_of(runs.begin(), runs.end(),
                                     [](const auto& run) { return run.state == RunState::done; });
  const std::string any_run = all_ended ? "any run" : "any run that ended normally";
  std::vector<std::string> parts;
  for (const Copies& one : copies_by_factor(findings)) {
    const std::string name = "'" + files::one_line(one.factor) + "'";
    if (one.some_same == 0) {
      continue;
    }
    parts.push_back(one.all_same == one.cases
                        ? name + " had no effect on " + any_run
                        : "levels of " + name + " gave the same run in " +
                              std::to_string(one.some_same) + " of " +
                              counted(one.cases, "combination") + " of seed and other levels");
  }
  return std::to_string(copies) + " of " + counted(findings.runs(), "run") +
         (copies == 1 ? " repeats" : " repeat") + " another one, bit by bit" +
         (parts.empty() ? "" : ": " + base::joined(parts, "; ")) +
         "; a run counts once in tests, models and intervals, however often it is repeated";
}

}  // namespace elsie::report
