#include "elsie/experiment/reader.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "elsie/base/problems.h"
#include "elsie/base/words.h"
#include "elsie/experiment/vocabulary.h"
#include "elsie/world/error.h"
#include "elsie/world/files.h"
#include "elsie/world/markup.h"
#include "elsie/world/object_reader.h"

#include "cell_check.h"
#include "draft.h"
#include "exclusions.h"
#include "expectations.h"
#include "factors.h"
#include "measures.h"
#include "seeds.h"

namespace elsie::experiment {

namespace {

using base::Problems;
using world::Element;
using world::ElementSpec;

// Leaves out elements with errors: their attributes are defaults, which must not be checked.
class DraftReader {
 public:
  explicit DraftReader(Problems& problems) : problems_(problems) {}

  ExperimentDraft read(const Element& root) {
    ExperimentDraft draft;
    flawed_ = world::read_object(vocabulary(), root, &draft, problems_);
    drop(draft.worlds);
    drop(draft.settings);
    drop(draft.factors);
    drop(draft.exclusions);
    drop(draft.measures);
    drop(draft.expectations);
    return draft;
  }

  /// True if worlds, settings and factors could all be read.
  bool grid_is_sound() const {
    return std::all_of(flawed_.begin(), flawed_.end(), [](const world::Flawed& each) {
      const std::string& name = each.spec->name;
      return name == "measure" || name == "measures" || name == "expect" || name == "expectations";
    });
  }
  bool is_sound(const Location& where) const {
    return std::none_of(flawed_.begin(), flawed_.end(), [&](const world::Flawed& each) {
      return each.spec != &vocabulary() && each.where.file == where.file &&
             each.where.line == where.line;
    });
  }

 private:
  template <class Draft>
  void drop(std::vector<Draft>& drafts) const {
    std::erase_if(drafts, [&](const Draft& draft) { return !is_sound(draft.location); });
  }

  Problems& problems_;
  std::vector<world::Flawed> flawed_;
};

struct Worlds {
  std::vector<WorldUse> uses;
  std::vector<std::string> files;  // paths as found, for messages
};

// The line on which an experiment begins in a file; 0 if the file is something else: reading it as
// a world then finds the error. Large worlds are not parsed for this.
int line_of_experiment(const std::string& file) {
  try {
    const std::string text = world::read_text(file);
    if (text.find("<experiment") == text.npos) return 0;
    const Element root = world::parse_markup(text, file);
    return root.name == "experiment" ? root.where.line : 0;
  } catch (const world::WorldError&) {
    return 0;
  }
}

// Without `files`, the worlds need not exist.
Worlds worlds_from(const std::vector<WorldDraft>& drafts, const world::Files* files,
                   Problems& problems) {
  Worlds worlds;
  std::map<std::string, int> lines;
  for (const WorldDraft& draft : drafts) {
    WorldUse& use = worlds.uses.emplace_back();
    use.name = draft.file;
    use.location = draft.location;
    use.id = draft.id ? *draft.id : std::filesystem::path(draft.file).stem().string();
    use.settings = settings_from(draft.settings, draft.changes, problems);
    const auto found =
        draft.file.empty() || !files ? std::nullopt : files->find(draft.file, draft.location);
    if (draft.file.empty() || (files && !found)) {
      problems.add(draft.location,
                   "file=\"" + draft.file + "\" of <world>: " +
                       (draft.file.empty() ? "expected the path of a world file"
                                           : files->why_not(draft.location, "file", draft.file)));
    } else if (const int line = found ? line_of_experiment(*found) : 0; line > 0) {
      problems.add(draft.location, "file=\"" + draft.file + "\" of <world>: this file is an " +
                                       "experiment, which names worlds (" + *found + ":" +
                                       std::to_string(line) + "); expected a world");
    } else if (const std::string why = why_no_label(use.id); !why.empty()) {
      problems.add(draft.location, "the world's file gives it the id '" + use.id + "', but " + why +
                                       "; give it another one with id=\"...\"");
    } else if (const auto [known, is_new] = lines.emplace(use.id, draft.location.line); !is_new) {
      problems.add(draft.location, "the world on line " + std::to_string(known->second) +
                                       " has the id '" + use.id +
                                       "', too; give this one another with id=\"...\"");
    }
    use.file = found ? world::Files::absolute(*found) : "";
    worlds.files.push_back(found.value_or(""));
  }
  return worlds;
}

// Checks that the grid is not too large. Only numbers within bounds are multiplied.
void check_size(const Experiment& experiment, const Location& root, Problems& problems) {
  std::string product = base::counted(experiment.worlds.size(), "world");
  std::uint64_t cell_count = experiment.worlds.size();
  for (const Factor& factor : experiment.factors) {
    product += " x " + std::to_string(factor.levels.size()) + " of '" + factor.name + "'";
    cell_count = std::min(cell_count * factor.levels.size(), kMostCells + 1);
  }
  if (cell_count > kMostCells) {
    problems.add(root, "the grid has too many cells, " + product + "; an experiment has at most " +
                           std::to_string(kMostCells));
    return;
  }
  const std::uint64_t of_a_cell =
      experiment.seeds.size() * static_cast<std::uint64_t>(experiment.repeats);
  if (of_a_cell > 0 && cell_count > kMostRuns / of_a_cell) {
    problems.add(root, "the experiment has " + std::to_string(cell_count * of_a_cell) + " runs, " +
                           product + ", " + std::to_string(experiment.seeds.size()) + " seeds" +
                           (experiment.repeats == 1
                                ? ""
                                : ", each " + std::to_string(experiment.repeats) + " times") +
                           "; an experiment has at most " + std::to_string(kMostRuns));
  }
}

// Checks that the experiment has no more runs than its author wanted.
void check_max_runs(const ExperimentDraft& draft, const Experiment& experiment, std::size_t cells,
                    const Location& root, Problems& problems) {
  const std::uint64_t runs =
      cells * experiment.seeds.size() * static_cast<std::uint64_t>(experiment.repeats);
  if (draft.max_runs && runs > static_cast<std::uint64_t>(*draft.max_runs)) {
    problems.add(
        root,
        "the experiment has " + base::counted(runs, "run") + ", " + base::counted(cells, "cell") +
            " x " + base::counted(experiment.seeds.size(), "seed") +
            (experiment.repeats == 1 ? ""
                                     : ", each " + std::to_string(experiment.repeats) + " times") +
            ", but max_runs=\"" + std::to_string(*draft.max_runs) +
            "\"; expected fewer levels or seeds, or a larger max_runs");
  }
}

// Labels of cells must differ; they are joined from those of levels.
void check_labels(const std::vector<Cell>& grid, const Location& root, Problems& problems) {
  std::set<std::string> known;
  for (const Cell& cell : grid) {
    if (!known.insert(cell.label).second) {
      problems.add(root, "two cells are called '" + cell.label + "'; change the levels' labels");
      return;
    }
  }
}

// The factor of layouts, or that they follow the seeds.
void add_layouts(const LayoutsDraft& draft, Experiment& experiment, Problems& problems) {
  constexpr const char* kFactor = "layout_seed";
  experiment.layouts_location = draft.location;
  experiment.layouts_follow_seeds = draft.rule == "nested";
  if (experiment.layouts_follow_seeds) {
    if (draft.from || draft.to || draft.list) {
      problems.add(draft.location,
                   "rule=\"nested\" of <layouts>: the seeds of the runs are those of the layouts; "
                   "take from, to and list out, or write rule=\"crossed\"");
    }
    return;
  }
  Factor factor{kFactor, {}, draft.location};
  for (const std::uint64_t seed : seeds_from(draft, "<layouts>", kMostLevels, problems)) {
    const std::string text = std::to_string(seed);
    factor.levels.push_back({text, {{"layouts/@seed", text, draft.location}}, draft.location});
  }
  for (const Factor& other : experiment.factors) {
    if (other.name == kFactor) {
      problems.add(draft.location,
                   "<layouts> is the factor 'layout_seed', and there is another of "
                   "this name; rename that one");
    }
  }
  experiment.factors.push_back(std::move(factor));
}

// An experiment and what is known while it is read.
struct Parsed {
  Experiment experiment;
  std::vector<Cell> grid;          // empty if it has errors
  std::vector<std::string> files;  // of the worlds, as found
  std::set<std::size_t> lists;     // the factors whose levels are in values="A; B"
  Problems problems, grid_problems;
};

Parsed parsed(std::string_view text, const std::string& file, const world::Files* files) {
  Parsed result;
  Problems& problems = result.problems;
  Problems& grid_problems = result.grid_problems;
  Experiment& experiment = result.experiment;
  const Element root = world::parse_markup(text, file, "experiment");
  const std::string right = "expected <experiment format=\"" + std::to_string(kFormat) + "\">";
  world::check_root(
      root, "experiment", kFormat,
      {{"world", "this file is a world, which an experiment may name; " + right},
       {"robot_template", "this file is a template of a robot, which worlds use; " + right}},
      problems);

  DraftReader reader(problems);
  const ExperimentDraft draft = reader.read(root);
  experiment.file = file;
  if (draft.name && draft.name->find_first_not_of(" \t\r\n") == std::string::npos) {
    problems.add(root.where,
                 "name=\"" + *draft.name +
                     "\" of <experiment>: expected a title; without name= it is that of "
                     "the file");
  }
  experiment.name = draft.name ? *draft.name : std::filesystem::path(file).stem().string();
  experiment.description = draft.description;
  if (draft.limits) {
    experiment.time_limit = draft.limits->time;
    experiment.limits_location = draft.limits->location;
    experiment.wall_limit = draft.limits->wall_time;
  }
  experiment.trajectory_period = draft.trajectories.value_or(TrajectoriesDraft{}).period;

  Worlds worlds = worlds_from(draft.worlds, files, grid_problems);
  experiment.worlds = std::move(worlds.uses);
  result.files = std::move(worlds.files);
  experiment.settings = settings_from(draft.settings, draft.changes, grid_problems);
  experiment.factors = factors_from(draft.factors, grid_problems);
  for (std::size_t i = 0; i < draft.factors.size(); ++i) {
    if (draft.factors[i].values) {
      result.lists.insert(i);
    }
  }
  if (draft.layouts && reader.is_sound(draft.layouts->location)) {
    add_layouts(*draft.layouts, experiment, grid_problems);
  }
  experiment.measures = measures_from(draft.measures, experiment.factors, problems);
  if (draft.seeds && reader.is_sound(draft.seeds->location)) {
    experiment.seeds = seeds_from(*draft.seeds, "<seeds>", kMostRuns, problems);
    experiment.repeats = draft.seeds->repeats;
  }
  if (grid_problems.empty() && reader.grid_is_sound()) {
    check_size(experiment, root.where, grid_problems);
  }
  if (grid_problems.empty() && reader.grid_is_sound()) {
    experiment.exclusions = exclusions_from(draft.exclusions, experiment, grid_problems);
  }
  if (grid_problems.empty() && reader.grid_is_sound()) {
    std::vector<Cell> grid = cells(experiment);
    check_max_runs(draft, experiment, grid.size(), root.where, grid_problems);
    if (grid_problems.empty()) {
      result.grid = std::move(grid);
    }
  }
  if (!result.grid.empty()) {
    check_labels(result.grid, root.where, grid_problems);
    experiment.expectations = expectations_from(draft.expectations, experiment, problems);
  }
  return result;
}

Experiment checked(Parsed parsed, const std::string& file) {
  parsed.problems.add(parsed.grid_problems);
  parsed.problems.raise<world::WorldError>(file);
  return std::move(parsed.experiment);
}

}  // namespace

Experiment read_experiment(const std::string& file, const plugin::Host& host,
                           const ReadOptions& options) {
  return parse_experiment(world::read_text(file), file, host, options);
}

Experiment parse_experiment(std::string_view text, const std::string& file,
                            const plugin::Host& host, const ReadOptions& options) {
  const world::Files files(file, options.data_directories);
  Parsed result = parsed(text, file, &files);
  if (!result.grid.empty()) {
    CellMeasures measures = check_cells(result.experiment, result.grid, result.files, result.lists,
                                        host, options, result.grid_problems);
    result.experiment.warnings = std::move(measures.warnings);
    if (result.grid_problems.empty()) {
      add_formulas(result.experiment, measures, result.problems);
      check_measures(result.experiment, result.grid, measures, result.problems);
    }
  }
  return checked(std::move(result), file);
}

Experiment parse_outline(std::string_view text, const std::string& file) {
  return checked(parsed(text, file, nullptr), file);
}

}  // namespace elsie::experiment
