#include "runs_to_watch.h"

#include <algorithm>
#include <tuple>

#include "figures.h"

namespace elsie::report {

namespace {

// The runs of a cell without success, by seed.
std::vector<std::size_t> unsuccessful_runs(const Findings& findings, std::size_t cell) {
  const CellFindings& found = findings.cells[cell];
  std::vector<std::size_t> runs = found.broken;
  for (const std::size_t run : found.runs) {
    if (findings.missed(findings.results.runs[run])) {
      runs.push_back(run);
    }
  }
  std::sort(runs.begin(), runs.end(), [&](std::size_t a, std::size_t b) {
    const Run &first = findings.results.runs[a], &second = findings.results.runs[b];
    return std::tie(first.seed, first.repetition) < std::tie(second.seed, second.repetition);
  });
  return runs;
}

// The first of each list, then the second of each...
std::vector<std::size_t> in_turns(const std::vector<std::vector<std::size_t>>& lists) {
  std::vector<std::size_t> all;
  for (std::size_t turn = 0; turn < kMostOfCell; ++turn) {
    for (const std::vector<std::size_t>& list : lists) {
      if (turn < list.size()) {
        all.push_back(list[turn]);
      }
    }
  }
  return all;
}

}  // namespace

RunsToWatch runs_to_watch(const Findings& findings, const std::vector<std::size_t>& cells,
                          const std::vector<std::int64_t>& stored) {
  RunsToWatch chosen;
  const auto is_stored = [&](std::size_t run) {
    return std::binary_search(stored.begin(), stored.end(), findings.results.runs[run].id);
  };
  const auto leave_stored = [&](std::vector<std::size_t>& runs) {
    const auto untold = std::stable_partition(runs.begin(), runs.end(), is_stored);
    chosen.untold.insert(chosen.untold.end(), untold, runs.end());
    runs.erase(untold, runs.end());
  };
  std::vector<std::size_t> typical;
  std::vector<std::vector<std::size_t>> failed;  // by cell
  for (const std::size_t cell : cells) {
    std::vector<std::size_t> of_cell;
    if (const auto run = typical_run(findings, cell)) {
      of_cell = {*run};
      leave_stored(of_cell);
      typical.insert(typical.end(), of_cell.begin(), of_cell.end());
    }
    leave_stored(failed.emplace_back(unsuccessful_runs(findings, cell)));
    chosen.all_unsuccessful += failed.back().size();
  }
  const std::vector<std::size_t> failures = in_turns(failed);
  std::sort(chosen.untold.begin(), chosen.untold.end());
  chosen.untold.erase(std::unique(chosen.untold.begin(), chosen.untold.end()), chosen.untold.end());
  chosen.all_typical = typical.size();

  chosen.typical =
      std::min(typical.size(), kMostWatched - std::min(failures.size(), kMostWatched / 2));
  const auto is_chosen = [&](std::size_t run) {
    return std::any_of(chosen.runs.begin(), chosen.runs.end(),
                       [&](const WatchedRun& each) { return each.run == run; });
  };
  for (std::size_t i = 0; i < chosen.typical; ++i) {
    chosen.runs.push_back({typical[i * typical.size() / chosen.typical], true});
  }
  for (const std::size_t run : failures) {
    if (chosen.runs.size() < kMostWatched && !is_chosen(run)) {
      chosen.runs.push_back({run, false});
    }
  }
  for (const std::vector<std::size_t>& runs : failed) {
    chosen.unsuccessful +=
        static_cast<std::size_t>(std::count_if(runs.begin(), runs.end(), is_chosen));
  }
  const auto order = [&](const WatchedRun& each) {
    const Run& run = findings.results.runs[each.run];
    return std::tuple(run.cell, !each.is_typical, run.seed, run.repetition);
  };
  std::sort(chosen.runs.begin(), chosen.runs.end(),
            [&](const WatchedRun& a, const WatchedRun& b) { return order(a) < order(b); });
  return chosen;
}

}  // namespace elsie::report
