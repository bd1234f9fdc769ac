// elsie check: reads world files, says what is wrong with them, runs nothing.
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>
#include <spdlog/spdlog.h>

#include "elsie/simulation/simulation.h"
#include "elsie/world/reader.h"

#include "command.h"
#include "environment.h"

namespace {

struct CheckOptions {
  PluginOptions plugins;
  std::vector<std::string> worlds;
  std::vector<std::string> overrides;
  bool quiet = false;
};

int check(const CheckOptions& options) {
  if (options.quiet) {
    spdlog::set_level(spdlog::level::err);
  }
  const elsie::plugin::Host host = load_plugins(options.plugins);
  int wrong = 0;
  for (const std::string& file : options.worlds) {
    try {
      const elsie::world::World world =
          elsie::world::read_world(file, host, read_options(options.overrides));
      // Putting it together asks the plugins whether they fit their robots.
      const elsie::simulation::Simulation simulation(world, host);
      if (!options.quiet) {
        std::cout << file << ": in order: " << world.robots.size()
                  << (world.robots.size() == 1 ? " robot, " : " robots, ") << world.boxes.size()
                  << (world.boxes.size() == 1 ? " box\n" : " boxes\n");
      }
    } catch (const elsie::world::WorldError& error) {
      std::cerr << error.what() << '\n';
      ++wrong;
    }
  }
  if (wrong > 0 && options.worlds.size() > 1) {
    std::cerr << "elsie: " << wrong << " of " << options.worlds.size() << " worlds are wrong\n";
  }
  return wrong == 0 ? kSuccess : kBadInput;
}

}  // namespace

void add_check_command(CLI::App& program, Job& job) {
  CLI::App* command =
      program.add_subcommand("check", "Read world files and report everything that is wrong");
  command->footer(
      "\nExamples:\n  elsie check worlds/*.xml\n"
      "  elsie check worlds/maze.xml --set physics/@step=0.02\n");
  auto options = std::make_shared<CheckOptions>();
  command->add_option("WORLD", options->worlds, "World files")->required();
  command
      ->add_option("--set", options->overrides,
                   "Change an attribute first, e.g. 'robot[r1]/@max_speed=0.3'; may be repeated")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
  command->add_flag("--quiet", options->quiet, "Say nothing of worlds that are in order");
  options->plugins.add_to(*command);
  command->callback([&job, options] { job = [options] { return check(*options); }; });
}
