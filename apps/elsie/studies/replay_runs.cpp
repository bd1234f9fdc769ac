#include <algorithm>
#include <atomic>
#include <filesystem>
#include <mutex>
#include <ostream>
#include <set>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <vector>

#include <poll.h>

#include "elsie/base/number_text.h"
#include "elsie/base/words.h"
#include "elsie/experiment/grid.h"
#include "elsie/experiment/where.h"
#include "elsie/process/run_process.h"
#include "elsie/report/results.h"

#include "batch_options.h"
#include "command.h"
#include "interrupts.h"
#include "replay.h"
#include "streams.h"

namespace elsie::program {

namespace fs = std::filesystem;
using report::Results;
using report::Run;
using report::RunState;

namespace {

constexpr int kPause_ms = 100;

/// One run and what is made of it.
struct Repeated {
  const Run* run = nullptr;
  std::string name;  // "fusion, 2 2, seed 3"
  std::vector<fs::path> recordings;
  int exit_code = 0;
  std::string verdict;  // "the same: state hash ..."
};

/// What `--where` may name: the factors, and what distinguishes runs. A factor of the same name
/// comes first.
class Choice {
 public:
  explicit Choice(const Results& results) : results_(results) {
    for (std::size_t i = 0; i < results.factors.size(); ++i) {
      add(results.factors[i].name,
          [&, i](const Run& run) { return results.cells[run.cell].levels[i]; });
    }
    add("state", [](const Run& run) { return std::string(to_string(run.state)); });
    add("outcome", [](const Run& run) {
      return std::string(run.outcome ? simulation::to_string(*run.outcome) : "none");
    });
    add("seed", [](const Run& run) { return std::to_string(run.seed); });
  }

  std::vector<const Run*> matching(const std::string& where) const {
    const experiment::Grid grid(names_, rows_);
    const auto parsed = [&] {
      try {
        return experiment::parse_where(where, grid.labels());
      } catch (const std::invalid_argument& error) {
        throw BadInput("--where: " + std::string(error.what()));
      }
    }();
    std::vector<const Run*> found;
    for (const std::size_t place : grid.cells_of(parsed)) {
      found.push_back(&results_.runs[place]);
    }
    return found;
  }

 private:
  template <class LabelOf>
  void add(const std::string& name, LabelOf label_of) {
    if (std::find(names_.begin(), names_.end(), name) != names_.end()) {
      return;
    }
    names_.push_back(name);
    rows_.resize(results_.runs.size());
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      rows_[i].push_back(label_of(results_.runs[i]));
    }
  }

  const Results& results_;
  std::vector<std::string> names_;
  std::vector<std::vector<std::string>> rows_;  // of each run, parallel to names_
};

/// A label as a part of a file's name.
std::string file_part(const std::string& label) {
  std::string text;
  for (const char c : label) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '.' || c == '-' || c == '+' ||
                       static_cast<unsigned char>(c) >= 0x80;  // other letters in UTF-8
    if (plain || (!text.empty() && text.back() != '_')) {
      text += plain ? c : '_';
    }
  }
  return text;
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directory(folder, error);
  if (!fs::is_directory(folder)) {
    throw BadInput("--record: '" + folder.string() +
                   (error ? "' cannot be made: " + error.message()
                          : "' is no folder, and there are many recordings") +
                   "; expected a folder, or a new name in one");
  }
}

std::vector<Repeated> repeated(const Results& results, const ReplayOptions& options) {
  std::vector<Repeated> all;
  std::set<std::string> names;
  for (const Run* const run : Choice(results).matching(*options.where)) {
    if (!run->ended()) {
      continue;
    }
    Repeated& one = all.emplace_back(Repeated{run, {}, {}, 0, {}});
    const std::string& cell = results.cells[run->cell].label;
    one.name = cell + ", seed " + std::to_string(run->seed) +
               (run->repetition > 1 ? ", repetition " + std::to_string(run->repetition) : "");
    std::string file =
        file_part(cell) + "_seed-" + std::to_string(run->seed) +
        (run->repetition > 1 ? "_repetition-" + std::to_string(run->repetition) : "");
    if (!names.insert(file).second) {
      file += "_run-" + std::to_string(run->id);
      names.insert(file);
    }
    for (const std::string& folder : options.views.record.files) {
      one.recordings.push_back(fs::path(folder) / (file + ".mcap"));
      if (options.table) {
        one.recordings.push_back(fs::path(folder) / (file + ".csv"));
      }
    }
  }
  if (all.empty()) {
    throw BadInput("--where: no run of '" + options.file + "' that has ended matches all of '" +
                   *options.where + "'");
  }
  return all;
}

std::vector<std::string> command_for(const Repeated& one, const ReplayOptions& options) {
  std::vector<std::string> words{program_path(), "replay", options.file,
                                 std::to_string(one.run->id), "--quiet"};
  const std::vector<std::string> plugins = options.plugins.words();
  words.insert(words.end(), plugins.begin(), plugins.end());
  for (const fs::path& recording : one.recordings) {
    words.insert(words.end(), {"--record", recording.string()});
  }
  if (!one.recordings.empty()) {
    words.insert(words.end(), {"--record-rate", base::number_text(options.views.record.rate_hz)});
    if (options.views.record.times) {
      words.emplace_back("--record-times");
    }
    if (options.views.record.images) {
      words.emplace_back("--record-images");
    }
    for (const std::string& robot : options.views.record.robots) {
      words.insert(words.end(), {"--record-robots", robot});
    }
  }
  if (options.wall_limit_s) {
    words.insert(words.end(), {"--wall-limit", base::number_text(*options.wall_limit_s)});
  }
  return words;
}

/// Whether a run that crashed or hung was reported to do so again: in the same step of the same
/// plugin, by the same signal. The replay itself cannot compare, because its process ended.
bool fails_again(const Run& run, const std::string& output) {
  const auto says = [&](const std::string& text) { return output.find(text) != output.npos; };
  return run.plugin && (run.state == RunState::crash || run.state == RunState::hang) &&
         says("elsie: plugin '" + *run.plugin + "'") &&
         (!run.robot || says(" of robot '" + *run.robot + "'")) &&
         (!run.step || says(" in step " + std::to_string(*run.step) + " (")) &&
         (!run.signal || says("(" + *run.signal + ")"));
}

/// The line of a replay's output that says whether the result is the same; else its first line.
std::string verdict_in(const std::string& output) {
  for (const char* const begin : {"the same: ", "not the same"}) {
    for (std::size_t at = output.find(begin); at != std::string::npos;
         at = output.find(begin, at + 1)) {
      if (at == 0 || output[at - 1] == '\n') {
        return output.substr(at, output.find('\n', at) - at);
      }
    }
  }
  return output.substr(0, output.find('\n'));
}

bool ended_the_same(const Repeated& one) { return one.verdict.starts_with("the same: "); }

/// Returns false when it was interrupted.
bool repeat(std::vector<Repeated>& all, const ReplayOptions& options) {
  const InterruptGuard interrupt;
  std::stop_source stop;
  std::atomic<std::size_t> next{0}, ended{0};
  std::mutex printing;
  const auto work = [&] {
    for (std::size_t i = next++; i < all.size() && !stop.stop_requested(); i = next++) {
      Repeated& one = all[i];
      const auto result = process::run_process(command_for(one, options), stop.get_token());
      one.exit_code = result ? result->exit_code : kOtherFailure;
      one.verdict = !result                                 ? "the program cannot be started again"
                    : fails_again(*one.run, result->output) ? "the same: " + one.run->message
                                                            : verdict_in(result->output);
      if (!options.quiet && !stop.stop_requested()) {
        const std::lock_guard<std::mutex> lock(printing);
        out() << "run " << one.run->id << ", " << one.name << ": " << one.verdict << '\n'
              << std::flush;
      }
      ++ended;
    }
  };
  {
    std::vector<std::jthread> threads;
    const std::size_t count = std::min(options.workers.value_or(processors()), all.size());
    for (std::size_t i = 0; i < count; ++i) {
      threads.emplace_back(work);
    }
    while (ended < all.size() && !stop.stop_requested()) {
      pollfd signal{.fd = interrupt.descriptor(), .events = POLLIN, .revents = 0};
      if (poll(&signal, 1, kPause_ms) > 0) {
        stop.request_stop();
      }
    }
  }
  return !stop.stop_requested();
}

}  // namespace

int replay_runs(const ReplayOptions& options) {
  if (options.views.record.files.size() > 1) {
    throw BadInput("--record: expected one folder for the recordings of --where");
  }
  if (options.table && options.views.record.files.empty()) {
    throw BadInput("--table writes tables next to recordings; expected --record FOLDER, too");
  }
  const report::ResultsFile file(options.file);
  const Results results = file.results();
  std::vector<Repeated> all = repeated(results, options);
  for (const std::string& folder : options.views.record.files) {
    make_folder(folder);
  }
  if (!repeat(all, options)) {
    err() << "elsie: interrupted; recordings that are complete are kept\n";
    return kOtherFailure;
  }
  const auto same = std::count_if(all.begin(), all.end(), ended_the_same);
  int exit_code = kSuccess;
  for (const Repeated& one : all) {
    if (!ended_the_same(one)) {
      exit_code = std::max<int>({exit_code, one.exit_code, kGoalMissed});
    }
  }
  out() << same << " of " << base::counted(all.size(), "run is", "runs are") << " the same"
        << (options.views.record.files.empty()
                ? ""
                : "; recordings: " + options.views.record.files.front())
        << '\n';
  return exit_code;
}

}  // namespace elsie::program
