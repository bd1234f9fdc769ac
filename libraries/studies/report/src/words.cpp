#include "words.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include "elsie/base/utf8.h"
#include "elsie/base/words.h"
#include "elsie/experiment/split.h"
#include "elsie/files/clean_text.h"

#include "numbers.h"

namespace elsie::report {

using experiment::split;

std::string size_in_words(const Findings& findings) {
  std::set<std::uint64_t> seeds, incomplete;
  int repeats = 1;
  for (const Run& run : findings.results.runs) {
    seeds.insert(run.seed);
    repeats = std::max(repeats, run.repetition);
    if (!run.ended() && run.repetition == 1) {
      incomplete.insert(run.seed);
    }
  }
  std::string text =
      counted(findings.runs(), "run") + ": " + counted(findings.cells.size(), "cell") + ", " +
      (incomplete.empty() ? "" : std::to_string(seeds.size() - incomplete.size()) + " of ") +
      counted(seeds.size(), "seed") + (incomplete.empty() ? "" : " complete");
  if (repeats > 1) {
    text += ", each " + std::to_string(repeats) + " times";
  }
  if (findings.partial()) {
    text += "; " + missing_in_words(findings);
  }
  return text;
}

std::string missing_in_words(const Findings& findings) {
  const std::size_t missing = findings.missing();
  return std::to_string(missing) + " of " + counted(findings.results.all_runs, "run") +
         (missing == 1 ? " is" : " are") + " not in this database" +
         (findings.results.shard == "1/1" ? "" : ", which is shard " + findings.results.shard);
}

namespace {

// Reservations about an answer, in addition to its expectations: "2 runs ended abnormally and 1 is
// still to be done"; "" for none.
std::string reservations(const Findings& findings) {
  std::vector<std::string> parts;
  if (const std::size_t broken = findings.broken(); broken > 0) {
    parts.push_back(counted(broken, "run") + " ended abnormally");
  }
  if (const std::size_t pending = findings.pending(); pending > 0) {
    parts.push_back(
        (parts.empty() ? counted(pending, "run is", "runs are") : counted(pending, "is", "are")) +
        " still to be done");
  }
  if (findings.partial()) {
    parts.push_back(missing_in_words(findings));
  }
  if (!findings.disagreements.empty()) {
    parts.push_back("equal seeds gave different runs");
  }
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  }
  return text;
}

}  // namespace

std::string answer_in_words(const Findings& findings) {
  const auto& verdicts = findings.verdicts;
  std::size_t met = 0, open = 0;
  for (const Verdict& verdict : verdicts) {
    met += verdict.met() ? 1 : 0;
    open += verdict.open() ? 1 : 0;
  }
  const std::size_t missed = verdicts.size() - met - open;
  const bool none_done = findings.runs() > 0 && findings.pending() == findings.runs();
  std::string words;
  if (none_done) {
    words = "No run is done yet";
  } else if (verdicts.empty()) {
    words = findings.pending() > 0                 ? "Not all runs are done"
            : findings.partial()                   ? "Not all runs are in this database"
            : findings.broken() == findings.runs() ? "No run ended normally"
            : findings.broken() > 0                ? "Not all runs ended normally"
            : findings.good()                      ? "Every run ended normally"
                                                   : "Equal seeds gave different runs";
  } else if (met == verdicts.size()) {
    words = verdicts.size() == 1 ? "The expectation is met"
                                 : "All " + std::to_string(met) + " expectations are met";
    if (!findings.good()) {
      words += ", but " + reservations(findings);
    }
  } else {
    const auto part = [](std::size_t count, const std::string& of, const char* what) {
      return std::to_string(count) + of + (count == 1 ? " is " : " are ") + what;
    };
    const std::string of = " of " + counted(verdicts.size(), "expectation");
    words = missed == 0 ? part(open, of, "not known yet")
                        : part(missed, of, "not met") +
                              (open > 0 ? ", and " + part(open, "", "not known yet") : "");
  }
  return words;
}

std::string give_ups_in_words(const Findings& findings) {
  std::size_t count = 0;
  const Run* worst = nullptr;
  for (const Run& run : findings.results.runs) {
    if (run.solver_gave_up.value_or(0) == 0) {
      continue;
    }
    ++count;
    if (!worst || *run.solver_gave_up > *worst->solver_gave_up) {
      worst = &run;
    }
  }
  if (!worst) {
    return "";
  }
  return "in " + std::to_string(count) + " of " + counted(findings.runs(), "run") +
         " the solver of the physics gave up in some steps, most often in " +
         name_of(findings.results, *worst) + ", in " + std::to_string(*worst->solver_gave_up) +
         " of " + std::to_string(worst->steps.value_or(0)) +
         ": contacts there are only roughly right; the notes of these runs say what may help";
}

std::string one_run_in_words(const Findings& findings) {
  constexpr std::size_t kNamed = 3;
  std::size_t count = 0;
  std::string names;
  for (std::size_t i = 0; i < findings.cells.size(); ++i) {
    if (findings.cells[i].one_run && ++count <= kNamed) {
      names += (names.empty() ? "" : "; ") + findings.results.cells[i].label;
    }
  }
  if (count == 0) {
    return "";
  }
  const bool all = count == findings.cells.size();
  return (all ? std::string("all")
              : "in " + std::to_string(count) + " of " + counted(findings.cells.size(), "cell") +
                    " all") +
         " seeds gave one and the same run" + (all && count > 1 ? " in every cell" : "") +
         ": nothing there is random" +
         (all ? "" : " (" + names + (count > kNamed ? "; ..." : "") + ")");
}

std::string short_label(const std::string& label, std::size_t most) {
  constexpr std::size_t kLeast = 6;  // characters of a level that say anything
  const std::string whole = files::one_line(label);
  std::vector<std::string> levels = split(whole, ',');
  const std::size_t separators = 2 * (levels.size() - 1);
  if (base::characters(whole) <= most || most < levels.size() * kLeast + separators) {
    return files::shortened(whole, most);
  }
  const auto length = [&](std::size_t share) {
    std::size_t sum = separators;
    for (const std::string& level : levels) {
      sum += std::min(base::characters(level), share);
    }
    return sum;
  };
  std::size_t share = kLeast;
  while (share < most && length(share + 1) <= most) {
    ++share;  // what short levels leave is for the long ones
  }
  for (std::string& level : levels) {
    level = files::shortened(level, share);
  }
  return base::joined(levels, ", ");
}

std::string success_in_words(const CellFindings& cell) {
  return cell.goals ? std::to_string(cell.successes) + "/" + std::to_string(cell.ended)
                    : "no goals";
}

std::string successes_in_words(const Findings& findings) {
  if (!findings.any_goals()) {
    return "no goals";
  }
  std::size_t successes = 0, ended = 0;
  for (const Run& run : findings.results.runs) {
    const bool counts = findings.cells[run.cell].goals;
    successes += counts && run.success() ? 1 : 0;
    ended += counts && run.ended() ? 1 : 0;
  }
  return std::to_string(successes) + " of " + std::to_string(ended);
}

std::string censored_in_words(const MeasureFindings& found, std::optional<int> decimals) {
  const auto number = [&](double value) {
    return decimals ? fixed_text(value, *decimals) : brief(value);
  };
  const Censoring& censoring = *found.censoring;
  const std::string all = std::to_string(found.values.size());
  const std::size_t stopped = censoring.count - censoring.failures;
  if (stopped == found.values.size()) {
    return "> " + number(*censoring.limit);
  }
  std::string text = censoring.median ? "median " + number(*censoring.median) + ", " : "";
  if (stopped > 0) {
    text += std::to_string(stopped) + " of " + all + " > " + number(*censoring.limit);
  }
  if (censoring.failures > 0) {
    text += (stopped > 0 ? ", " : "") + std::to_string(censoring.failures) +
            (stopped > 0 ? "" : " of " + all) + " failed";
  }
  return text;
}

std::optional<int> decimals_of(const Findings& findings, std::size_t measure) {
  std::optional<int> least, most;
  for (const CellFindings& cell : findings.cells) {
    const MeasureFindings& found = cell.measures[measure];
    // If not all times are known, those of the successful runs decide.
    const auto& all = found.censoring ? found.successes : found.all;
    if (!all) {
      continue;
    }
    const auto decimals = decimals_for(all->mean, all->standard_deviation.value_or(0.0));
    if (!decimals) {
      return std::nullopt;
    }
    least = std::min(least.value_or(*decimals), *decimals);
    most = std::max(most.value_or(*decimals), *decimals);
  }
  return most ? std::min(*most, *least + 3) : most;
}

namespace {

const char* verb_of(RunState state) {
  switch (state) {
    case RunState::fault:
      return "failed in a plugin";
    case RunState::crash:
      return "crashed";
    case RunState::hang:
      return "hung";
    case RunState::error:
      return "could not be done";
    default:
      return "ended";
  }
}

// Returns whether the message names the step: "step 50" does, "step 501" does not.
bool names_step(const std::string& message, std::int64_t step) {
  const std::string words = "step " + std::to_string(step);
  for (std::size_t at = 0; (at = message.find(words, at)) != std::string::npos; ++at) {
    const std::size_t end = at + words.size();
    if (end == message.size() || message[end] < '0' || message[end] > '9') {
      return true;
    }
  }
  return false;
}

}  // namespace

std::string circumstances(const Run& run) {
  const auto is_named = [&](const std::string& words) {
    return run.message.find(words) != std::string::npos;
  };
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : " ") + part; };
  if (run.signal && !is_named(*run.signal)) {
    add("by " + *run.signal);
  }
  if (run.plugin && !is_named("'" + *run.plugin + "'")) {
    add("in plugin '" + *run.plugin + "'");
  }
  if (run.robot && !is_named("robot '" + *run.robot + "'")) {
    add("of robot '" + *run.robot + "'");
  }
  if (run.step && !names_step(run.message, *run.step)) {
    add("at step " + std::to_string(*run.step));
  }
  if (!run.message.empty()) {
    text += (text.empty() ? "" : ": ") + run.message;
  }
  return text;
}

std::string ending_in_words(const Run& run) {
  const std::string how = circumstances(run);
  const bool message_only = how == run.message;
  return to_string(run.state) + std::string(how.empty() ? "" : message_only ? ": " : " ") + how;
}

std::string broken_in_words(const Findings& findings) {
  const std::size_t broken = findings.broken();
  if (broken == 0) {
    return "";
  }
  std::map<RunState, std::size_t> states;
  for (const Run& run : findings.results.runs) {
    if (run.broken()) {
      ++states[run.state];
    }
  }
  const bool all = broken == findings.runs();
  std::string text = !all ? std::to_string(broken) + " of " + counted(findings.runs(), "run")
                     : broken == 1 ? "the only run"
                                   : "all " + counted(broken, "run");
  if (states.size() == 1) {
    text += std::string(" ") + verb_of(states.begin()->first);
  } else {
    text += " ended abnormally (";
    for (const auto& [state, count] : states) {
      text += (text.ends_with('(') ? "" : ", ") + std::to_string(count) + " " + verb_of(state);
    }
    text += ")";
  }
  const auto first = std::find_if(findings.results.runs.begin(), findings.results.runs.end(),
                                  [](const Run& run) { return run.broken(); });
  return text + (broken > 1 ? ", the first of them " : ": ") + name_of(findings.results, *first);
}

std::string name_of(const Run& run) {
  return "run " + std::to_string(run.id) + ", seed " + std::to_string(run.seed);
}

std::string outcome_in_words(const Run& run) {
  return run.outcome == Outcome::time_limit ? "time limit"
         : run.outcome                      ? simulation::to_string(*run.outcome)
                                            : to_string(run.state);
}

std::string name_of(const Results& results, const Run& run) {
  const std::string& label = results.cells[run.cell].label;
  return "run " + std::to_string(run.id) + " (" + (label.empty() ? "" : label + ", ") + "seed " +
         std::to_string(run.seed) + ")";
}

std::string in_words(const Results& results, const Disagreement& disagreement) {
  std::string text = "runs ";
  for (std::size_t i = 0; i < disagreement.runs.size(); ++i) {
    text += i == 0 ? "" : i + 1 == disagreement.runs.size() ? " and " : ", ";
    text += std::to_string(results.runs[disagreement.runs[i]].id);
  }
  const Run& first = results.runs[disagreement.runs.front()];
  const std::string& label = results.cells[first.cell].label;
  return text + " (" + (label.empty() ? "" : label + ", ") + "seed " + std::to_string(first.seed) +
         ") ended in different states: a plugin depends on more than the seed";
}

}  // namespace elsie::report
