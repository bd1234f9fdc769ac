#include "batch_report.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "elsie/base/number_text.h"
#include "elsie/base/utf8.h"
#include "elsie/base/words.h"
#include "elsie/files/clean_text.h"
#include "elsie/process/shell_word.h"
#include "elsie/process/text_table.h"

#include "command.h"
#include "progress.h"

namespace elsie::program {

using batch::CellCount;
using batch::RunState;
using files::one_line;
using process::shell_word;

namespace {

constexpr std::size_t kShownFailures = 10;
constexpr std::size_t kAllFailures = 1'000'000'000;

struct Total {
  std::int64_t runs = 0;
  std::int64_t pending = 0;
  std::int64_t done = 0;
  std::int64_t failed = 0;
  std::int64_t successes = 0;
  std::int64_t with_goals = 0;  // runs in worlds with goals that ended
};

Total total(const std::vector<CellCount>& cells, const std::set<std::string>& without_goals) {
  Total sum;
  for (const CellCount& cell : cells) {
    sum.with_goals += without_goals.contains(cell.label) ? 0 : cell.done + cell.failed;
    sum.runs += cell.pending + cell.done + cell.failed;
    sum.pending += cell.pending;
    sum.done += cell.done;
    sum.failed += cell.failed;
    sum.successes += cell.successes;
  }
  return sum;
}

/// The success rate of the runs that ended; a failed run is not a success. In a world without goals
/// a run can neither succeed nor fail.
std::string rate(const Total& of) {
  if (of.with_goals > 0) {
    return base::fixed_text(
               100.0 * static_cast<double>(of.successes) / static_cast<double>(of.with_goals), 0) +
           " %";
  }
  return of.done + of.failed > 0 ? "no goals" : "";
}

std::vector<std::string> row(const std::string& label, const Total& of) {
  return {label,
          std::to_string(of.runs),
          std::to_string(of.done),
          std::to_string(of.failed),
          std::to_string(of.pending),
          rate(of)};
}

/// The first line of a message, cut to fit.
std::string first_line(const std::string& message) {
  constexpr std::size_t kMost = 160;
  std::string line = message.substr(0, message.find('\n'));
  if (line.size() > kMost) {
    line = line.substr(0, base::cut_before(line, kMost)) + "...";
  }
  return line;
}

}  // namespace

std::string duration_text(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  const long hours = whole / 3600;
  const long minutes = whole / 60 % 60;
  if (hours > 0) {
    return std::to_string(hours) + " h " + std::to_string(minutes) + " min";
  }
  if (minutes > 0) {
    return std::to_string(minutes) + " min " + std::to_string(whole % 60) + " s";
  }
  return std::to_string(whole) + " s";
}

std::string progress_line(const batch::Progress& progress) {
  // On a cluster, all runs may be done before all tasks have ended.
  const double part = progress.runs > 0
                          ? static_cast<double>(progress.ended) / static_cast<double>(progress.runs)
                          : 1.0;
  std::string line = bar_text(part) + "  " + std::to_string(progress.ended) + " of " +
                     base::counted(progress.runs, "run");
  if (progress.failed > 0) {
    line += ", " + std::to_string(progress.failed) + " failed";
  }
  if (const auto left_s = progress.left_s()) {
    line += ", " + duration_text(*left_s) + " left";
  }
  return line;
}

BatchReport::BatchReport(const batch::Plan& plan, batch::ResultsDatabase& database,
                         std::string resume)
    : plan_(plan), database_(database), resume_(std::move(resume)) {}

void BatchReport::begin(bool bar) { bar_.emplace(bar); }

void BatchReport::progress(const batch::Progress& progress) {
  last_ = progress;
  if (bar_ && progress.runs > 0) {
    bar_->draw(progress_line(progress));
  }
}

void BatchReport::end(bool interrupted) {
  interrupted_ = interrupted;
  bar_.reset();
}

std::set<std::string> BatchReport::without_goals() const {
  std::set<std::string> labels;
  for (const batch::PlannedCell& cell : plan_.cells) {
    if (!cell.goals) {
      labels.insert(cell.label);
    }
  }
  return labels;
}

std::string BatchReport::complete_seeds() {
  const batch::SeedCount seeds = database_.seeds();
  return std::to_string(seeds.complete) + " of " +
         base::counted(static_cast<std::uint64_t>(seeds.all), "seed") + " complete";
}

std::string BatchReport::table() {
  const std::vector<CellCount> cells = database_.cells();
  const std::set<std::string> aimless = without_goals();
  const Total sum = total(cells, aimless);
  const std::string name = database_.file().string();
  std::string out = one_line(plan_.experiment) + ": ";
  if (done_already_) {
    out += sum.runs == 1 ? "the only run is done already"
                         : "all " + base::counted(sum.runs, "run") + " are done already";
  } else {
    out += base::counted(last_.ended, "run") + " in " + duration_text(last_.elapsed_s);
  }
  if (sum.pending > 0) {
    out += "; " + complete_seeds();
  }
  if (plan_.shard.of > 1) {
    out += "; shard " + plan_.shard.text() + " of " + base::counted(plan_.all_runs, "run");
  }
  out += "\n\n";
  std::vector<std::vector<std::string>> rows{
      {"cell", "runs", "done", "failed", "to do", "success"}};
  for (const CellCount& cell : cells) {
    rows.push_back(row(cell.label, total({cell}, aimless)));
  }
  if (cells.size() > 1) {
    rows.push_back(row("all", sum));
  }
  out += process::laid_out(rows, 1);
  const auto failed = database_.failed(kShownFailures);
  if (!failed.empty()) {
    out += "\nfailed:\n";
    for (const auto& run : failed) {
      out += "  run " + std::to_string(run.id) + " (" + one_line(run.cell) + ", seed " +
             std::to_string(run.seed) + "), " + to_string(run.state) + ": " +
             first_line(run.message) + '\n';
    }
    if (sum.failed > static_cast<std::int64_t>(failed.size())) {
      out += "  and " + std::to_string(sum.failed - static_cast<std::int64_t>(failed.size())) +
             " more\n";
    }
    out += "\nlook at one again with\n  elsie replay " + shell_word(name) + " " +
           std::to_string(failed.front().id) + '\n';
  }
  for (const auto& found : database_.disagreements()) {
    out += "\nthe same seed gave different runs: " + one_line(found.cell) + ", seed " +
           std::to_string(found.seed) + ", runs";
    for (const std::int64_t run : found.runs) {
      out += " " + std::to_string(run);
    }
    out += "; a plugin of this cell depends on more than its random stream\n";
  }
  out += "\nresults: " + name + '\n';
  return out;
}

std::string BatchReport::json() {
  using Json = nlohmann::ordered_json;
  const std::vector<CellCount> cells = database_.cells();
  const std::set<std::string> aimless = without_goals();
  const Total sum = total(cells, aimless);
  Json object;
  object["experiment"] = plan_.experiment;
  object["database"] = database_.file().string();
  object["fingerprint"] = plan_.fingerprint;
  object["shard"] = plan_.shard.text();
  object["runs"] = sum.runs;
  object["done"] = sum.done;
  object["failed"] = sum.failed;
  object["to_do"] = sum.pending;
  const batch::SeedCount seeds = database_.seeds();
  object["seeds"] = seeds.all;
  object["seeds_complete"] = seeds.complete;
  object["successes"] = aimless.size() == cells.size() ? Json(nullptr) : Json(sum.successes);
  object["interrupted"] = interrupted_;
  object["wall_s"] = last_.elapsed_s;
  object["cells"] = Json::array();
  for (const CellCount& cell : cells) {
    object["cells"].push_back(
        {{"cell", cell.label},
         {"done", cell.done},
         {"failed", cell.failed},
         {"to_do", cell.pending},
         {"successes", aimless.contains(cell.label) ? Json(nullptr) : Json(cell.successes)}});
  }
  object["failures"] = Json::array();
  for (const auto& run : database_.failed(kAllFailures)) {
    object["failures"].push_back({{"run", run.id},
                                  {"state", to_string(run.state)},
                                  {"cell", run.cell},
                                  {"seed", run.seed},
                                  {"message", run.message}});
  }
  object["disagreements"] = Json::array();
  for (const auto& found : database_.disagreements()) {
    object["disagreements"].push_back(
        {{"cell", found.cell}, {"seed", found.seed}, {"runs", found.runs}});
  }
  return object.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string BatchReport::interruption() {
  const Total sum = total(database_.cells(), {});
  return "elsie: interrupted; " + std::to_string(sum.pending) + " of " +
         base::counted(sum.runs, "run is", "runs are") + " still to be done, " + complete_seeds() +
         ". Continue with\n  " + resume_ + '\n';
}

int BatchReport::exit_code() {
  if (interrupted_) {
    return kOtherFailure;
  }
  bool error = false;
  for (const auto& run : database_.failed(kAllFailures)) {
    if (run.state != RunState::error) {
      return kPluginFailed;
    }
    error = true;
  }
  return !database_.disagreements().empty() ? kPluginFailed : error ? kOtherFailure : kSuccess;
}

}  // namespace elsie::program
