#include "cell_check.h"

#include <algorithm>
#include <exception>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "elsie/experiment/plugin_uses.h"
#include "elsie/plugin/host.h"
#include "elsie/render/world_cameras.h"
#include "elsie/simulation/measures.h"
#include "elsie/simulation/simulation.h"
#include "elsie/world/edited_worlds.h"
#include "elsie/world/reader.h"
#include "elsie/world/same.h"
#include "elsie/world/warnings.h"
#include "elsie/world/writer.h"

#include "factors.h"
#include "grid.h"

namespace elsie::experiment {

namespace {

world::World read(const Experiment& experiment, const Cell& cell, const std::string& file,
                  const plugin::Host& host, const ReadOptions& options, std::uint64_t seed,
                  bool check_plugins = true) {
  world::ReadOptions reading;
  reading.seed = seed;
  reading.edits = cell.edits;
  reading.edits_from = experiment.file;
  reading.data_directories = options.data_directories;
  reading.check_plugins = check_plugins;
  world::World world = world::read_world(file, host, reading);
  for (const Setting& change : cell.changes) {
    world.edits.push_back({*change.at_s, change.path, change.value, {}, change.location});
  }
  return world;
}

// Returns the problem of an edit that cannot be made, with the line of the edit.
base::Problem problem_of(const world::World& world, const simulation::EditRefused& refused) {
  for (const world::TimedEdit& edit : world.edits) {
    const Location& where = edit.location;
    if (where.file.text() + ":" + std::to_string(where.line) == refused.from()) {
      return {where.file, where.line, refused.what()};
    }
  }
  return {world.file, 0, refused.what()};
}

// A problem that one or several cells have.
struct Complaint {
  Location where;
  std::string message;
  base::Problem problem;  // as it was found, with this seed
  std::uint64_t seed = 1;
  bool is_setting = false;         // in this experiment; else in a world's file
  std::vector<std::size_t> cells;  // the cells that have it
};

class CellCheck {
 public:
  CellCheck(const Experiment& experiment, const std::vector<Cell>& grid,
            const std::vector<std::string>& files, const std::set<std::size_t>& lists,
            const plugin::Host& host, const ReadOptions& options)
      : experiment_(experiment),
        grid_(grid),
        files_(files),
        lists_(lists),
        host_(host),
        options_(options) {}

  CellMeasures check() {
    for (const Cell& cell : grid_) {
      try {
        check(cell);
      } catch (const world::WorldError& error) {
        for (const base::Problem& problem : error.problems()) {
          complain(cell, problem);
        }
      }
      if (options_.progress) {
        options_.progress(cell.index + 1, grid_.size());
      }
    }
    return std::move(measures_);
  }

  void report(base::Problems& problems) const {
    constexpr std::size_t kMost = 20;
    std::map<std::pair<std::string, int>, std::size_t> on_line;
    for (const auto& [key, complaint] : complaints_) {
      const std::size_t count = ++on_line[{complaint.where.file.text(), complaint.where.line}];
      if (count <= kMost) {
        problems.add(complaint.where,
                     complaint.message + circumstances(complaint) + limit_behind(complaint));
      }
    }
    for (const auto& [place, count] : on_line) {
      if (count > kMost) {
        problems.add({place.first, place.second},
                     "... and " + std::to_string(count - kMost) + " more problems on this line");
      }
    }
    for (const auto& [where, message] : twins_) {
      problems.add(where, message);
    }
  }

 private:
  // The result of a cell without problems.
  struct Found {
    std::vector<Quantity> measures;
    std::string text;  // of the cell's world
    std::vector<std::string> warnings;
    std::optional<world::Drawn> drawn;
  };

  void check(const Cell& cell) {
    Found found = look(cell);
    note_measures(std::move(found.measures));
    for (std::string& warning : found.warnings) {
      if (warned_.insert(warning).second) {
        measures_.warnings.push_back(std::move(warning));
      }
    }
    compare(cell, found);
    check_layouts(cell, found.drawn);
  }

  // An experiment without seeds has that problem already.
  std::uint64_t first_seed() const {
    return experiment_.seeds.empty() ? 1 : experiment_.seeds.front();
  }

  // That there is room for what every seed draws.
  void check_layouts(const Cell& cell, const std::optional<world::Drawn>& drawn) {
    if (experiment_.layouts_follow_seeds && !(drawn && drawn->by_run)) {
      complain(cell, {experiment_.layouts_location.file, experiment_.layouts_location.line,
                      "rule=\"nested\" of <layouts>: the layouts of '" +
                          experiment_.worlds[cell.world].name + "' " +
                          (drawn ? "have a seed of their own; take it out"
                                 : "are none: the world has no <layouts>")});
    }
    if (!drawn || !drawn->by_run) {
      return;
    }
    layouts_ += experiment_.seeds.size();
    if (layouts_ > kMostLayouts) {
      complain(cell, {experiment_.file, 0,
                      "the layouts follow the seeds, which makes more than " +
                          std::to_string(kMostLayouts) +
                          " worlds; give fewer seeds, or the layouts a seed of their own"});
      return;
    }
    for (const std::uint64_t seed : experiment_.seeds) {
      try {
        if (seed != first_seed()) {
          read(experiment_, cell, files_[cell.world], host_, options_, seed, false);
        }
      } catch (const world::WorldError& error) {
        for (const base::Problem& problem : error.problems()) {
          complain(cell, problem, seed);
        }
        return;
      }
    }
  }

  Found look(const Cell& cell) {
    // Building the world checks every plugin, but stops at the first error. Checking each plugin
    // before takes twice the time, but finds all errors.
    try {
      return look(cell, false);
    } catch (const std::exception&) {
      return look(cell, true);
    }
  }

  Found look(const Cell& cell, bool plugins_before) {
    const world::World world =
        read(experiment_, cell, files_[cell.world], host_, options_, first_seed(), plugins_before);
    simulation::Options running{.cameras = render::world_cameras};
    if (!world.edits.empty()) {
      world::ReadOptions reading;
      reading.data_directories = running.data_directories = options_.data_directories;
      reading.check_plugins = true;
      reading.found = &running.files;
      world::visit_edited_worlds(world, host_, reading);
    }
    // This asks the plugins whether they fit their robots, and whether they can begin a run: once
    // for the same parameters, because some train a network for it.
    const std::vector<world::PluginUse> fresh = new_plugins(world);
    running.begin_later = world.edits.empty() && fresh.empty();
    const simulation::Simulation simulation(world, host_, running);
    begun_.insert(begun_.end(), fresh.begin(), fresh.end());
    Found found{
        simulation::measure_names(world, host_), world::write_world(world), {}, world.drawn};
    // What may harm a run is in its notes; a study may want it.
    for (const world::Warning& warning : world::warnings(world)) {
      if (warning.about == world::Warning::About::no_effect) {
        found.warnings.push_back(warning.text());
      }
    }
    if (running.begin_later) {
      return found;
    }
    try {
      for (const simulation::UnmadeEdits& unmade : simulation.check({})) {
        found.warnings.push_back(unmade.from + ": warning: " + unmade.sentence);
      }
    } catch (const simulation::EditRefused& refused) {
      std::vector<base::Problem> problems{problem_of(world, refused)};
      for (const simulation::EditRefused& other : refused.others()) {
        problems.push_back(problem_of(world, other));
      }
      throw world::WorldError(std::move(problems));
    }
    return found;
  }

  /// The plugins of the world, with their parameters, with which no cell has begun yet.
  std::vector<world::PluginUse> new_plugins(const world::World& world) const {
    std::vector<world::PluginUse> found;
    for_each_use(world, [&](PluginKind, const world::PluginUse& use) {
      const bool is_known = std::any_of(begun_.begin(), begun_.end(),
                                        [&](const auto& other) { return world::same(use, other); });
      if (!is_known) {
        found.push_back(use);
      }
    });
    return found;
  }

  void note_measures(std::vector<Quantity> quantities) {
    auto& lists = measures_.lists;
    const auto known = std::find(lists.begin(), lists.end(), quantities);
    measures_.of_cell.push_back(static_cast<std::size_t>(known - lists.begin()));
    if (known == lists.end()) {
      lists.push_back(std::move(quantities));
    }
  }

  // Two cells with the same worlds are an error: a level changes nothing, or a later setting undoes
  // it.
  void compare(const Cell& cell, const Found& found) {
    const bool by_run = found.drawn && found.drawn->by_run;
    std::vector<std::size_t>& alike = cells_by_text_[std::hash<std::string>()(found.text)];
    const auto twin = std::find_if(alike.begin(), alike.end(), [&](std::size_t index) {
      return text_of(grid_[index], first_seed()) == found.text &&
             (!by_run || are_same(cell, grid_[index]));
    });
    if (twin == alike.end()) {
      alike.push_back(cell.index);
    } else {
      report_twins(cell, grid_[*twin]);
    }
  }

  // Whether two cells have the same world with every seed.
  bool are_same(const Cell& one, const Cell& other) const {
    return std::all_of(experiment_.seeds.begin(), experiment_.seeds.end(), [&](std::uint64_t seed) {
      return seed == first_seed() || text_of(one, seed) == text_of(other, seed);
    });
  }

  // "" if the world cannot be read.
  std::string text_of(const Cell& cell, std::uint64_t seed) const {
    try {
      return world::write_world(
          read(experiment_, cell, files_[cell.world], host_, options_, seed, false));
    } catch (const world::WorldError&) {
      return "";
    }
  }

  void report_twins(const Cell& cell, const Cell& other) {
    Location where = experiment_.worlds[cell.world].location;
    std::string what = "'" + experiment_.worlds[cell.world].id + "'";
    std::string of = experiment_.worlds[other.world].id;
    for (std::size_t i = 0; i < experiment_.factors.size(); ++i) {
      const Factor& factor = experiment_.factors[i];
      if (cell.levels[i] != other.levels[i]) {
        where = factor.levels[cell.levels[i]].location;
        what = "the level '" + factor.levels[cell.levels[i]].label + "' of '" + factor.name + "'";
        of = factor.levels[other.levels[i]].label;
      }
    }
    // Each pair of levels is reported once.
    if (reported_.insert(what + of).second) {
      twins_.emplace_back(where, what + " is the same as '" + of + "': the cells '" + other.label +
                                     "' and '" + cell.label +
                                     "' do not differ in anything; a later setting may undo it");
    }
  }

  void complain(const Cell& cell, const base::Problem& problem) {
    complain(cell, problem, first_seed());
  }

  void complain(const Cell& cell, const base::Problem& problem, std::uint64_t seed) {
    Complaint complaint{{problem.file, problem.line}, problem.message, problem, seed, false, {}};
    if (seed != first_seed()) {
      complaint.message += " (with the seed " + std::to_string(seed) + ")";
    }
    for (const Setting& setting : settings_of(experiment_, cell)) {
      if (setting.at_s
              ? problem.file == setting.location.file && problem.line == setting.location.line
              : problem.file == "--set " + override_of(setting)) {
        complaint.where = setting.location;
        complaint.is_setting = true;
      }
    }
    for (const std::size_t list : lists_) {
      const Factor& factor = experiment_.factors[list];
      if (problem.file == "--set " + override_of(factor.levels.front().settings.front())) {
        complaint.message += how_to_separate(factor);
      }
    }
    auto& known =
        complaints_[{complaint.where.file.text(), complaint.where.line, complaint.message}];
    if (known.cells.empty()) {
      known = std::move(complaint);
    }
    if (known.cells.empty() || known.cells.back() != cell.index) {
      known.cells.push_back(cell.index);
    }
  }

  // The cells that could have this problem: those with a setting on that line, or all of the world.
  std::vector<std::size_t> could_be(const Complaint& complaint) const {
    std::set<std::size_t> worlds;
    for (const std::size_t index : complaint.cells) {
      worlds.insert(grid_[index].world);
    }
    std::vector<std::size_t> found;
    for (const Cell& cell : grid_) {
      const auto settings = settings_of(experiment_, cell);
      if (complaint.is_setting ? std::any_of(settings.begin(), settings.end(),
                                             [&](const Setting& setting) {
                                               return setting.location.line == complaint.where.line;
                                             })
                               : worlds.contains(cell.world)) {
        found.push_back(cell.index);
      }
    }
    return found;
  }

  // The level with which cells have the problem, " (with coordinator=fusion)"; "" if all have it.
  std::string circumstances(const Complaint& complaint) const {
    const std::vector<std::size_t> all = could_be(complaint);
    if (all == complaint.cells) {
      return "";
    }
    const std::vector<std::string> factors = factor_names(experiment_);
    const Cell& first = grid_[complaint.cells.front()];
    for (std::size_t i = 0; i < factors.size(); ++i) {
      std::vector<std::size_t> with_it;
      std::copy_if(all.begin(), all.end(), std::back_inserter(with_it),
                   [&](std::size_t index) { return grid_[index].labels[i] == first.labels[i]; });
      if (with_it == complaint.cells) {
        return " (with " + factors[i] + "=" + first.labels[i] + ")";
      }
    }
    const std::size_t count = complaint.cells.size();
    return count == 1 ? " (in the cell '" + first.label + "')"
                      : " (in " + std::to_string(count) + " cells, the first of them '" +
                            first.label + "')";
  }

  // The place where the time limit is set, if only the limit makes the world wrong; else "".
  std::string limit_behind(const Complaint& complaint) const {
    if (complaint.is_setting || !experiment_.time_limit) {
      return "";
    }
    Cell cell = grid_[complaint.cells.front()];
    const bool with_limit = has_problem(cell, complaint);
    cell.edits.erase(cell.edits.begin());  // the time limit is the first one
    if (!with_limit || has_problem(cell, complaint)) {
      return "";
    }
    const Location& limits = experiment_.limits_location;
    return "; that time limit is set in " + limits.file.text() + ":" + std::to_string(limits.line);
  }

  // Whether the problem is found when the world is read; else a plugin or the experiment has it.
  bool has_problem(const Cell& cell, const Complaint& complaint) const {
    try {
      read(experiment_, cell, files_[cell.world], host_, options_, complaint.seed);
    } catch (const world::WorldError& error) {
      return std::any_of(error.problems().begin(), error.problems().end(),
                         [&](const base::Problem& problem) {
                           return problem.file == complaint.problem.file &&
                                  problem.line == complaint.problem.line &&
                                  problem.message == complaint.problem.message;
                         });
    }
    return false;
  }

  const Experiment& experiment_;
  const std::vector<Cell>& grid_;
  const std::vector<std::string>& files_;
  const std::set<std::size_t>& lists_;
  const plugin::Host& host_;
  const ReadOptions& options_;
  CellMeasures measures_;
  std::map<std::tuple<std::string, int, std::string>, Complaint> complaints_;
  std::map<std::size_t, std::vector<std::size_t>> cells_by_text_;  // by the hash of the text
  std::vector<world::PluginUse> begun_;
  std::uint64_t layouts_ = 0;  // that follow the seeds
  std::set<std::string> reported_;
  std::set<std::string> warned_;
  std::vector<std::pair<Location, std::string>> twins_;
};

}  // namespace

CellMeasures check_cells(const Experiment& experiment, const std::vector<Cell>& grid,
                         const std::vector<std::string>& files, const std::set<std::size_t>& lists,
                         const plugin::Host& host, const ReadOptions& options,
                         base::Problems& problems) {
  CellCheck check(experiment, grid, files, lists, host, options);
  CellMeasures measures = check.check();
  check.report(problems);
  return measures;
}

world::World read_cell(const Experiment& experiment, const Cell& cell, const plugin::Host& host,
                       const ReadOptions& options, std::uint64_t seed) {
  return read(experiment, cell, experiment.worlds[cell.world].file, host, options, seed);
}

}  // namespace elsie::experiment
