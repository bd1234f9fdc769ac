#include "stages.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <map>
#include <set>
#include <system_error>
#include <utility>

#include "elsie/experiment/reader.h"
#include "elsie/results/database_file.h"
#include "elsie/results/hash.h"

namespace elsie::batch {

namespace {

/// Joins texts so that different lists give different results.
class Joined {
 public:
  void add(const std::string& text) { all_ += std::to_string(text.size()) + ':' + text + '\n'; }
  void end_list() { all_ += ";\n"; }
  std::string hash() const { return results::sha256(all_); }

 private:
  std::string all_;
};

std::set<std::uint64_t> as_set(const std::vector<std::uint64_t>& seeds) {
  return {seeds.begin(), seeds.end()};
}

/// The position of each cell by its levels.
std::map<std::vector<std::string>, std::size_t> places_of(const Plan& plan) {
  std::map<std::vector<std::string>, std::size_t> places;
  for (std::size_t i = 0; i < plan.cells.size(); ++i) {
    places[plan.cells[i].levels] = i;
  }
  return places;
}

}  // namespace

void number_runs(Plan& plan) {
  plan.runs.clear();
  plan.all_runs = 0;
  const Stage* before = nullptr;
  std::set<std::uint64_t> seeds_before;
  for (Stage& stage : plan.stages) {
    for (std::size_t cell = 0; cell < stage.cells; ++cell) {
      for (const std::uint64_t seed : stage.seeds) {
        const bool known = before && cell < before->cells && seeds_before.contains(seed);
        for (int repetition = known ? before->repeats + 1 : 1; repetition <= stage.repeats;
             ++repetition) {
          ++plan.all_runs;
          if (plan.shard.has(plan.all_runs)) {
            plan.runs.push_back({plan.all_runs, cell, seed, repetition});
          }
        }
      }
    }
    stage.runs = plan.all_runs;
    before = &stage;
    seeds_before = as_set(stage.seeds);
  }
}

std::string fingerprint_of(const Plan& plan, std::size_t stages) {
  Joined all;
  all.add(plan.elsie_version);
  all.add(plan.abi);
  all.add(std::to_string(plan.trajectory_period_s));
  for (const std::string& factor : plan.factors) {
    all.add(factor);
  }
  all.end_list();
  for (std::size_t i = 0; i < plan.stages[stages - 1].cells; ++i) {
    all.add(plan.cells[i].identity);
  }
  all.end_list();
  for (std::size_t i = 0; i < stages; ++i) {
    const Stage& stage = plan.stages[i];
    all.add(std::to_string(stage.cells));
    all.add(seeds_text(stage.seeds));
    all.add(std::to_string(stage.repeats));
    for (std::size_t cell = 0; cell < stage.cells; ++cell) {
      const auto& layouts = plan.cells[cell].layouts;
      for (const std::uint64_t seed :
           layouts.empty() ? std::vector<std::uint64_t>() : stage.seeds) {
        all.add(layouts.at(seed).sha256);
      }
    }
  }
  return all.hash();
}

StoredGrid stored_grid(sqlite::Connection& connection, const std::filesystem::path& file) {
  StoredGrid stored;
  sqlite::Statement factors(connection, "SELECT name FROM factors ORDER BY id");
  while (factors.next()) {
    stored.factors.push_back(factors.text(0));
  }
  std::map<std::int64_t, std::size_t> places;
  sqlite::Statement cells(connection, "SELECT id, label, sha256 FROM cells ORDER BY id");
  while (cells.next()) {
    places[cells.integer(0)] = stored.cells.size();
    stored.cells.push_back({{}, cells.text(1), cells.text(2)});
  }
  sqlite::Statement levels(connection,
                           "SELECT cell_id, label FROM cell_levels ORDER BY cell_id, factor_id");
  while (levels.next()) {
    stored.cells[places.at(levels.integer(0))].levels.push_back(levels.text(1));
  }
  sqlite::Statement stages(
      connection, "SELECT cells, seeds, repeats, runs, fingerprint FROM stages ORDER BY id");
  while (stages.next()) {
    const std::int64_t count = stages.integer(0);
    const auto seeds = seeds_in(stages.text(1));
    const std::int64_t repeats = stages.integer(2);
    const std::size_t before = stored.stages.empty() ? 1 : stored.stages.back().cells;
    if (count < static_cast<std::int64_t>(before) ||
        count > static_cast<std::int64_t>(stored.cells.size())) {
      throw results::damaged(file, "`stages` does not have the cells");
    }
    if (!seeds) {
      throw results::damaged(file, "the seeds of `stages` are '" + stages.text(1) + "'");
    }
    const auto runs = static_cast<std::uint64_t>(count) * seeds->size();
    if (repeats < 1 || static_cast<std::uint64_t>(repeats) > experiment::kMostRuns / runs) {
      throw results::damaged(file, "`stages` has " + std::to_string(runs) +
                                       " runs, each repeated " + std::to_string(repeats) +
                                       " times");
    }
    stored.stages.push_back({static_cast<std::size_t>(count), *seeds, static_cast<int>(repeats),
                             stages.integer(3), stages.text(4)});
  }
  if (stored.stages.empty() || stored.stages.back().cells != stored.cells.size()) {
    throw results::damaged(file, "`stages` does not have the cells");
  }
  return stored;
}

Gone gone_from(const StoredGrid& stored, const Plan& plan) {
  Gone gone;
  const auto places = places_of(plan);
  for (const StoredGrid::Cell& cell : stored.cells) {
    if (!places.contains(cell.levels)) {
      gone.cells.push_back(cell.label);
    }
  }
  const Stage& last = stored.stages.back();
  const Stage& now = plan.stages.back();
  const std::set<std::uint64_t> seeds = as_set(now.seeds);
  std::copy_if(last.seeds.begin(), last.seeds.end(), std::back_inserter(gone.seeds),
               [&](std::uint64_t seed) { return !seeds.contains(seed); });
  gone.repeats = std::max(last.repeats - now.repeats, 0);
  return gone;
}

Plan continued(const StoredGrid& stored, Plan plan) {
  const auto places = places_of(plan);
  std::vector<PlannedCell> cells;
  std::vector<bool> taken(plan.cells.size(), false);
  for (const StoredGrid::Cell& cell : stored.cells) {
    const std::size_t place = places.at(cell.levels);
    taken[place] = true;
    cells.push_back(std::move(plan.cells[place]));
  }
  for (std::size_t i = 0; i < taken.size(); ++i) {
    if (!taken[i]) {
      cells.push_back(std::move(plan.cells[i]));
    }
  }
  plan.cells = std::move(cells);
  const Stage now = plan.stages.back();
  const Stage& last = stored.stages.back();
  plan.stages = stored.stages;
  if (now.cells > last.cells || now.seeds.size() > last.seeds.size() ||
      now.repeats > last.repeats) {
    plan.stages.push_back(now);
  }
  number_runs(plan);
  for (std::size_t i = stored.stages.size(); i < plan.stages.size(); ++i) {
    plan.stages[i].fingerprint = fingerprint_of(plan, i + 1);
  }
  plan.fingerprint = plan.stages.back().fingerprint;
  return plan;
}

std::string seeds_text(const std::vector<std::uint64_t>& seeds) {
  std::string text;
  for (auto first = seeds.begin(); first != seeds.end();) {
    auto last = first;
    while (std::next(last) != seeds.end() && *std::next(last) == *last + 1 && *last + 1 != 0) {
      ++last;
    }
    text += (text.empty() ? "" : ",") + std::to_string(*first) +
            (last == first ? "" : '-' + std::to_string(*last));
    first = std::next(last);
  }
  return text;
}

std::optional<std::vector<std::uint64_t>> seeds_in(const std::string& text) {
  std::vector<std::uint64_t> seeds;
  const char* at = text.data();
  const char* const end = at + text.size();
  const auto number = [&](std::uint64_t& value) {
    const auto read = std::from_chars(at, end, value);
    at = read.ptr;
    return read.ec == std::errc();
  };
  for (bool ended = false; !ended; ++at) {
    std::uint64_t first = 0;
    if (!number(first)) {
      return std::nullopt;
    }
    std::uint64_t last = first;
    if (at < end && *at == '-' && (++at, !number(last))) {
      return std::nullopt;
    }
    if (last < first || last - first >= experiment::kMostRuns - seeds.size()) {
      return std::nullopt;
    }
    for (std::uint64_t more = 0; more <= last - first; ++more) {
      seeds.push_back(first + more);
    }
    ended = at == end;
    if (!ended && *at != ',') {
      return std::nullopt;
    }
  }
  return seeds;
}

}  // namespace elsie::batch
