// Runs that the page plays: one viewer, and at most a dozen runs.
#include <algorithm>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "elsie/api/simulator_events.h"
#include "elsie/page/stored_run.h"
#include "elsie/plugin/host.h"
#include "elsie/world/error.h"

#include "markup.h"
#include "numbers.h"
#include "page.h"
#include "runs_to_watch.h"
#include "words.h"

namespace elsie::report {

namespace {

constexpr double kMegabyte = 1e6;

std::string megabytes(std::size_t bytes) {
  return fixed_text(static_cast<double>(bytes) / kMegabyte, 1) + " MB";
}

page::StoredRun stored_run(const PageContext& context, const Run& run) {
  const Findings& findings = context.findings;
  const CellInfo& cell = findings.results.cells[run.cell];
  RunDetails details = context.file.run_details(run.id);
  page::StoredRun stored;
  stored.title = cell.label;
  stored.world_xml = std::move(details.world_text);
  stored.world_file = cell.world_file;
  stored.library = "elsie " + findings.results.elsie_version;
  stored.seed = run.seed;
  stored.end_s = run.simulated_s.value_or(0.0);
  stored.facts = {{"run", std::to_string(run.id)}, {"cell", cell.label}};
  stored.result.outcome = run.outcome ? simulation::to_string(*run.outcome) : to_string(run.state);
  stored.result.reason = run.broken() ? circumstances(run) : run.message;
  stored.result.simulated_s = stored.end_s;
  stored.result.steps = run.steps.value_or(0);
  stored.result.state_hash = run.state_hash.value_or("");
  for (const std::size_t measure : findings.measures) {
    if (const auto value = run.values[measure]; value && is_usable(*value)) {
      stored.result.measures[findings.results.measures[measure].name] = *value;
    }
  }
  for (Trajectory& way : details.trajectories) {
    stored.robots.push_back({.id = std::move(way.robot),
                             .from_s = way.from_s,
                             .period_s = way.period_s,
                             .poses = std::move(way.poses),
                             .has_end = way.has_end});
  }
  for (Timeline& timeline : details.timelines) {
    const auto robot = std::find_if(stored.robots.begin(), stored.robots.end(),
                                    [&](const auto& each) { return each.id == timeline.robot; });
    if (robot == stored.robots.end()) continue;
    for (Timeline::Behavior& each : timeline.behaviors) {
      robot->behaviors.push_back(std::move(each.path));
    }
    for (Timeline::Episode& each : timeline.episodes) {
      robot->episodes.push_back(
          {each.from_s, each.to_s, std::move(each.decider), std::move(each.parts)});
    }
  }
  for (Event& event : details.events) {
    const events::Facts* const facts = events::find(event.name);
    stored.events.push_back({event.time_s, std::move(event.robot), std::move(event.name),
                             std::move(event.detail), facts && facts->is_warning});
  }
  return stored;
}

// A list of the first of these runs: "run 5 (a, seed 3), run 6 (a, seed 4) and 3 more".
std::string named(const Results& results, const std::vector<std::size_t>& runs) {
  constexpr std::size_t kNamed = 4;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(runs.size(), kNamed); ++i) {
    const Run& run = results.runs[runs[i]];
    names.push_back(name_of(results, run) + ": " + outcome_in_words(run));
  }
  return base::joined(names, "; ") +
         (runs.size() > kNamed ? "; and " + std::to_string(runs.size() - kNamed) + " more" : "");
}

// How the runs were chosen.
std::string choice_in_words(const PageContext& context, const RunsToWatch& chosen) {
  const Findings& findings = context.findings;
  std::string nearest = ", the first";
  if (!findings.measures.empty()) {
    const Measure& measure = findings.results.measures[findings.measures.front()];
    nearest =
        ", the one whose " + in_words(measure.name, measure.unit) + " is nearest to the median";
  }
  std::string text;
  if (chosen.typical > 0) {
    text += (chosen.typical == chosen.all_typical
                 ? "a typical run of " + std::string(chosen.typical == 1 ? "the cell" : "each cell")
                 : "typical runs of " + std::to_string(chosen.typical) + " of " +
                       counted(chosen.all_typical, "cell") + ", picked evenly") +
            " (of those with the commonest outcome" + nearest + ")";
  }
  if (chosen.unsuccessful > 0) {
    text += (text.empty() ? "" : ", and ") +
            (chosen.unsuccessful == chosen.all_unsuccessful
                 ? chosen.unsuccessful == 1 ? "the run"
                                            : "all " + std::to_string(chosen.unsuccessful) + " runs"
                 : std::to_string(chosen.unsuccessful) + " of " +
                       counted(chosen.all_unsuccessful, "run")) +
            " without success" +
            (chosen.unsuccessful == chosen.all_unsuccessful
                 ? ""
                 : ", at most " + std::to_string(kMostOfCell) +
                       " of a cell, in the order of the seeds");
  }
  return text;
}

std::string why(const PageContext& context, const WatchedRun& watched) {
  const Findings& findings = context.findings;
  const Run& run = findings.results.runs[watched.run];
  std::vector<std::string> reasons;
  if (watched.is_typical) {
    std::string text = "typical";
    if (!findings.measures.empty()) {
      const std::size_t place = findings.measures.front();
      const Measure& measure = findings.results.measures[place];
      if (const auto value = run.values[place]; value && is_usable(*value)) {
        text += ": " + in_words(measure.name, measure.unit) + " " + brief(*value) +
                (measure.unit.empty() ? "" : " " + measure.unit);
      }
    }
    reasons.push_back(text);
  }
  if (run.broken()) {
    reasons.push_back(circumstances(run));
  } else if (findings.missed(run)) {
    reasons.push_back(run.message.empty() ? "no reason is stored" : run.message);
  }
  return base::joined(reasons, "; ");
}

// A block of data in a page. Nothing in it can end the block.
std::string data_block(const Run& run, const page::PageRun& shown) {
  nlohmann::ordered_json json;
  shown.for_each_text([&](const char* name, const std::string& text) { json[name] = text; });
  std::string text;
  for (const char c : json.dump()) {
    c == '<' ? text += "\\u003c" : text += c;
  }
  return "<script type=\"application/json\" id=\"run-" + std::to_string(run.id) + "\">" + text +
         "</script>\n";
}

}  // namespace

std::string watch_section(const PageContext& context, std::size_t most_bytes) {
  const Findings& findings = context.findings;
  const Results& results = findings.results;
  const RunsToWatch chosen =
      runs_to_watch(findings, context.detailed, context.file.runs_with_trajectories());
  const std::string viewer = "<iframe title=\"The run\" data-viewer=\"" +
                             escaped_attribute(page::viewer_html()) + "\" hidden></iframe>\n";
  std::vector<std::string> notes;
  if (!chosen.untold.empty()) {
    notes.push_back((chosen.untold.size() == 1 ? "A run cannot"
                                               : counted(chosen.untold.size(), "run") + " cannot") +
                    " be played, because the database has no trajectory of " +
                    (chosen.untold.size() == 1 ? "it" : "them") + " (" +
                    escaped(named(results, chosen.untold)) +
                    "). Of a run that crashed or hung, none is stored.");
  }
  std::string rows, data;
  double every_s = 0.0;
  std::size_t left = most_bytes - std::min(viewer.size() + 16'384, most_bytes);
  for (std::size_t i = 0; i < chosen.runs.size(); ++i) {
    const Run& run = results.runs[chosen.runs[i].run];
    const std::size_t share = left / (chosen.runs.size() - i);
    const auto leave_out = [&](const std::string& reason) {
      notes.push_back("R" + escaped(name_of(results, run)).substr(1) +
                      " cannot be played: " + reason);
    };
    const page::StoredRun stored = stored_run(context, run);
    if (std::none_of(stored.robots.begin(), stored.robots.end(), page::has_poses)) {
      leave_out("its stored trajectory has no poses.");
      continue;
    }
    page::PageRun shown;
    try {
      shown = page::page_run(stored, plugin::Host(), {share});
    } catch (const world::WorldError& error) {
      leave_out("its world cannot be read: " +
                escaped(files::shortened(files::one_line(error.what()), 300)));
      continue;
    }
    const std::string block = data_block(run, shown);
    if (block.size() > share) {
      leave_out("its " + counted(stored.robots.size(), "robot") + " take " +
                megabytes(block.size()) + " even with a pose every " + brief(shown.poses_every_s) +
                " s, and the page may have " + megabytes(kMostPageBytes) +
                " in all. <code>--cells</code> chooses fewer runs.");
      continue;
    }
    left -= block.size();
    every_s = std::max(every_s, shown.poses_every_s);
    data += block;
    rows +=
        run_row(context, run,
                escaped(results.cells[run.cell].label) + " \xc2\xb7 " + ending_tag(findings, run),
                escaped(why(context, chosen.runs[i])));
  }
  if (rows.empty() && notes.empty()) {
    return "";
  }
  std::string text = "<section id=\"watch\"><h2>Runs to watch</h2>\n";
  if (!rows.empty()) {
    text +=
        "<p class=\"lead\">Chosen are " + escaped(choice_in_words(context, chosen)) +
        ". They are played from the stored trajectories: a pose of each robot every " +
        brief(every_s) + " s" +
        ", straight lines between them.</p>\n<noscript><p class=\"quiet\">They are played where "
        "scripts are allowed.</p></noscript>\n" +
        viewer + runs_table("cell", "why it is here", rows);
  }
  for (const std::string& note : notes) {
    text += "<p class=\"quiet\">" + note + "</p>\n";
  }
  return text + data + "</section>\n";
}

}  // namespace elsie::report
