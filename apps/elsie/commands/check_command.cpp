// elsie check: reads world and experiment files and reports their mistakes, without running them.
#include <algorithm>
#include <map>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <spdlog/spdlog.h>

#include "elsie/base/words.h"
#include "elsie/check/doubts.h"
#include "elsie/experiment/reader.h"
#include "elsie/render/world_cameras.h"
#include "elsie/simulation/simulation.h"
#include "elsie/world/data_directories.h"
#include "elsie/world/markup.h"
#include "elsie/world/reader.h"
#include "elsie/world/warnings.h"
#include "elsie/world/writer.h"

#include "arguments.h"
#include "command.h"
#include "environment.h"
#include "progress.h"
#include "streams.h"

namespace elsie::program {

namespace {

struct CheckOptions {
  PluginOptions plugins;
  std::vector<std::string> files;
  std::vector<std::string> edits;
  std::uint64_t seed = 1;
  bool expand = false;
  bool quiet = false;
};

/// What plugins note before a run. Of robots that are alike, one stands for all.
void print_notes(const simulation::Simulation& simulation, const std::string& file) {
  std::map<std::pair<std::string, std::string>, std::vector<std::string>> robots;  // by note
  for (const simulation::Note& note : simulation.notes()) {
    if (note.plugin == simulation::kPhysicsNotes) continue;  // a warning of the world
    robots[{note.plugin, note.text}].push_back(note.robot);
  }
  for (const auto& [note, of] : robots) {
    const std::string more =
        of.size() > 1 ? " and " + base::counted(of.size() - 1, "more robot") : "";
    err() << file << ": note: " << (of[0].empty() ? "" : of[0] + more + ", ") << note.first << ": "
          << note.second << '\n';
  }
}

/// The line about a world without mistakes.
std::string check_world(const std::string& text, const std::string& file, const plugin::Host& host,
                        const CheckOptions& options) {
  // This asks the plugins whether they fit their robots.
  const simulation::Simulation simulation(
      world::parse_world(text, file, host, read_options(options.edits, options.seed)), host,
      {.seed = options.seed,
       .data_directories = data_directories(),
       .cameras = render::world_cameras});
  try {
    for (const simulation::UnmadeEdits& unmade : simulation.check({})) {
      err() << unmade.from << ": warning: " << unmade.sentence << '\n';
    }
  } catch (const simulation::EditRefused& refused) {
    throw BadInput(refused.report());
  }
  const world::World& world = simulation.world();
  for (const world::Warning& warning : world::warnings(world)) {
    err() << warning.text() << '\n';
  }
  for (base::Problem doubt : check::doubts(simulation)) {
    doubt.message = "warning: " + doubt.message;
    err() << doubt.text() << '\n';
  }
  if (!options.quiet) print_notes(simulation, file);
  if (options.expand) {
    data_out() << world::write_world(world);
  }
  const auto resources = static_cast<std::size_t>(std::count_if(
      world.obstacles.begin(), world.obstacles.end(),
      [](const world::Obstacle& box) { return box.kind == world::ObstacleKind::resource; }));
  return base::counted(world.robots.size(), "robot") + ", " +
         base::counted(world.obstacles.size() - resources, "obstacle") +
         (resources > 0 ? ", " + base::counted(resources, "resource") : "");
}

std::string check_experiment(const std::string& text, const std::string& file,
                             const plugin::Host& host, const CheckOptions& options) {
  if (!options.edits.empty()) {
    throw BadInput("--set is for worlds; '" + file +
                   "' is an experiment, which has elements <set> for that");
  }
  if (options.expand) {
    throw BadInput("--expand is for worlds; '" + file +
                   "' is an experiment, whose worlds are in "
                   "the database of its runs");
  }
  CheckProgress progress(!options.quiet);
  experiment::ReadOptions reading;
  reading.data_directories = data_directories();
  reading.progress = [&](std::size_t read, std::size_t all) { progress.draw(read, all); };
  const experiment::Experiment experiment = experiment::parse_experiment(text, file, host, reading);
  for (const std::string& warning : experiment.warnings) {
    err() << warning << '\n';
  }
  return base::counted(experiment::cells(experiment).size(), "cell") + ", " +
         base::counted(experiment::number_of_runs(experiment), "run") + ", " +
         base::counted(experiment.expectations.size(), "expectation");
}

/// A world may have a hundred thousand robots: it is not parsed twice.
bool is_experiment(const std::string& text, const std::string& path) {
  return text.find("<experiment") != text.npos &&
         world::parse_markup(text, path).name == "experiment";
}

int check(const CheckOptions& options) {
  if (options.expand && options.files.size() != 1) {
    throw BadInput("--expand writes one world; " + std::to_string(options.files.size()) +
                   " files are given");
  }
  if (options.quiet) {
    spdlog::set_level(spdlog::level::err);
  }
  const plugin::Host host = load_plugins(options.plugins);
  int wrong = 0;
  for (const std::string& file : options.files) {
    try {
      const std::string path = world::find_document(file, data_directories());
      const std::string text = world::read_text(path);
      const std::string found = is_experiment(text, path)
                                    ? check_experiment(text, path, host, options)
                                    : check_world(text, path, host, options);
      if (!options.quiet && !options.expand) {
        out() << file << ": in order: " << found << '\n';
      }
    } catch (const world::WorldError& error) {
      err() << error.what() << '\n';
      ++wrong;
    }
  }
  if (wrong > 0 && options.files.size() > 1) {
    err() << "elsie: " << wrong << " of " << options.files.size() << " files are wrong\n";
  }
  return wrong == 0 ? kSuccess : kBadInput;
}

}  // namespace

void add_check_command(CLI::App& program, Job& job) {
  CLI::App* command = program.add_subcommand(
      "check", "Read world and experiment files and report everything that is wrong");
  command->footer(
      "\nExamples:\n  elsie check worlds/*.xml experiments/*.xml\n"
      "  elsie check worlds/maze.xml --set physics/@step=0.02\n"
      "  elsie check worlds/scattered/clutter.xml --seed 7 --expand > clutter_7.xml\n");
  auto options = std::make_shared<CheckOptions>();
  command->add_option("FILE", options->files, "World and experiment files")->required();
  command
      ->add_option("--set", options->edits,
                   "Change an attribute of the worlds first, e.g. 'robot[r1]/@max_speed=0.3'; may "
                   "be repeated")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
  command->add_option("--seed", options->seed, "Seed from which the layouts of worlds are drawn")
      ->check(seed_number())
      ->capture_default_str();
  command->add_flag("--expand", options->expand,
                    "Write the world as it runs to standard output: templates merged, layouts "
                    "drawn, settings made");
  command->add_flag("--quiet", options->quiet, "Print nothing about files that are in order");
  options->plugins.add_to(*command);
  command->callback([&job, options] { job = [options] { return check(*options); }; });
}

}  // namespace elsie::program
