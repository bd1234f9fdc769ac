// elsie picture: draws a world file at the start of a run.
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include <CLI/CLI.hpp>
#include <spdlog/spdlog.h>

#include "elsie/files/outputs.h"
#include "elsie/recording/run_picture.h"
#include "elsie/render/world_cameras.h"
#include "elsie/simulation/simulation.h"
#include "elsie/world/reader.h"

#include "arguments.h"
#include "command.h"
#include "environment.h"
#include "output_files.h"
#include "streams.h"

namespace elsie::program {

namespace {

struct PictureOptions {
  PluginOptions plugins;
  std::string world;
  std::optional<std::string> picture;  // PICTURE, equivalent to --output
  std::optional<std::string> output;
  std::vector<std::string> edits;
  std::uint64_t seed = 1;
  int width = 1000;
  bool bare = false;
};

int picture(const PictureOptions& options) {
  const std::filesystem::path file = options.output.value_or(
      options.picture.value_or(std::filesystem::path(options.world).stem().string() + ".png"));
  const char* const option = options.picture ? "PICTURE" : "--output";
  require_picture(file, option);
  const plugin::Host host = load_plugins(options.plugins);
  std::map<std::string, std::string> found;
  world::ReadOptions reading = read_options(options.edits, options.seed);
  reading.found = &found;
  world::World world = world::read_world(options.world, host, reading);
  files::require_apart({{option, file}}, read_files(options.world, found, options.plugins));
  simulation::Simulation simulation(std::move(world), host,
                                    {.seed = options.seed, .cameras = render::world_cameras});
  simulation.step();  // lets the sensors look once
  picture::TopView view = recording::view_of(
      simulation, nullptr, [](const std::string& sentence) { spdlog::warn(sentence); });
  view.bare = options.bare;
  picture::save_top_view(view, file, {options.width, 0});
  out() << "wrote " << file.string() << '\n';
  return kSuccess;
}

}  // namespace

void add_picture_command(CLI::App& program, Job& job) {
  CLI::App* command = program.add_subcommand("picture", "Draw a world from above");
  command->footer(
      "\nExamples:\n  elsie picture worlds/maze.xml\n"
      "  elsie picture worlds/maze.xml maze.svg\n"
      "  elsie picture worlds/maze.xml --output maze.svg --width 2000\n");
  auto options = std::make_shared<PictureOptions>();
  command->add_option("WORLD", options->world, "World file")->required();
  CLI::Option* second =
      command
          ->add_option("PICTURE", options->picture,
                       "Picture file, .png or .svg; default: the world's name with .png, here")
          ->type_name("FILE");
  command->add_option("-o,--output", options->output, "The same as PICTURE, as an option")
      ->excludes(second)
      ->type_name("FILE");
  command->add_option("--set", options->edits, "Change an attribute first; may be repeated")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
  command->add_option("--seed", options->seed, "Seed of layouts, and of sensors' noise")
      ->check(seed_number())
      ->capture_default_str();
  command->add_option("--width", options->width, "Width in pixels")
      ->check(whole_number(200, 8000))
      ->capture_default_str();
  command->add_flag("--bare", options->bare,
                    "Draw the arena alone, without title, axes, legend and names");
  options->plugins.add_to(*command);
  command->callback([&job, options] { job = [options] { return picture(*options); }; });
}

}  // namespace elsie::program
