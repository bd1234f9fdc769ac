// elsie train: trains the coordinator of a robot, and writes what it has learned.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <memory>
#include <utility>

#include <CLI/CLI.hpp>
#include <spdlog/spdlog.h>

#include "elsie/base/number_text.h"
#include "elsie/files/outputs.h"
#include "elsie/learning/values.h"
#include "elsie/neural/weights.h"
#include "elsie/world/reader.h"

#include "arguments.h"
#include "command.h"
#include "output_files.h"
#include "train_options.h"

namespace elsie::program {

namespace {

constexpr const char* kTrainExamples = R"(
Examples:
  elsie train worlds/learned_priorities.xml --robot r1 --weights r1.weights
  elsie train worlds/learned_priorities.xml --hidden '4 4' --seed 3 --curve curve.png
  elsie run worlds/learned_priorities.xml --set 'robot[r1]/coordinator/@weights=r1.weights'
  elsie train worlds/learned_arbitration.xml --values r1.values --curve rewards.png
  elsie run worlds/learned_arbitration.xml --set 'robot[r1]/coordinator/@values=r1.values'

A network is the one that `elsie run` trains with the same seed. From rewards a coordinator learns in
episodes: runs with one seed after the other. Exit code 1: it is untrained: a network gives the same
output for every input, or all values are 0. What it has is written nevertheless.
)";

/// A file of what was learned may be replaced, but no other file that was named by mistake.
void require_learned(const std::string& file, const char* option, const char* what,
                     bool (*is_one)(const std::string&)) {
  require_writable(file, option);
  std::error_code error;
  if (std::filesystem::exists(file, error) &&
      (!std::filesystem::is_regular_file(file, error) || !is_one(file))) {
    throw BadInput(std::string(option) + ": '" + file + "' already exists and is not a " + what +
                   "; give another name, or remove it");
  }
}

/// The beginning of edits of the coordinator at this place, before the world is known.
std::string path_of(const LearnerPlace& place) {
  std::string path = "robot[" + place.robot.value_or("1") + "]/";
  for (std::size_t at = 0; at < place.behavior.size();) {
    const std::size_t end = std::min(place.behavior.find('/', at), place.behavior.size());
    path += "behavior[" + place.behavior.substr(at, end - at) + "]/";
    at = end + 1;
  }
  return path + "coordinator/@";
}

/// Checks the files that will be written.
void require_outputs(const TrainOptions& options) {
  std::vector<files::Output> outputs;
  if (options.weights) {
    require_learned(*options.weights, "--weights", "weight file", neural::looks_like_weights);
    outputs.push_back({"--weights", *options.weights});
  }
  if (options.values) {
    require_learned(*options.values, "--values", "file of values", learning::looks_like_values);
    outputs.push_back({"--values", *options.values});
  }
  if (options.curve) {
    require_picture(*options.curve, "--curve");
    outputs.push_back({"--curve", *options.curve});
  }
  files::require_apart(outputs, {});
}

/// Refuses the options of the other way to learn.
void require_options_of(Lessons lessons, const TrainOptions& options, const std::string& plugin) {
  const auto refuse = [&](const std::string& option, const char* how) {
    throw BadInput(option + ": the coordinator '" + plugin + "' " + how);
  };
  if (lessons == Lessons::rewards) {
    constexpr const char* kHow =
        "has no network: it learns from rewards; see --episodes, --explore and --values";
    if (options.weights) refuse("--weights", kHow);
    if (!options.parameters.empty()) {
      std::string option = "--" + options.parameters.begin()->first;
      std::replace(option.begin(), option.end(), '_', '-');
      refuse(option, kHow);
    }
  } else {
    constexpr const char* kHow =
        "learns from samples, not from rewards; see --presentations, --weights";
    if (options.values) refuse("--values", kHow);
    if (options.episodes) refuse("--episodes", kHow);
    if (options.explore) refuse("--explore", kHow);
  }
}

int train(const TrainOptions& options) {
  require_outputs(options);
  if (options.quiet) {
    spdlog::set_level(spdlog::level::err);
  }
  const plugin::Host host = load_plugins(options.plugins);
  TrainingWorld world(options);
  const world::World described = world.described(host, options.seed.value_or(1));
  const FoundCoordinator found = find_coordinator(described, options.place);
  const Lessons lessons = lessons_of(found, host);
  require_options_of(lessons, options, found.use->plugin);
  const auto train_it = lessons == Lessons::rewards ? train_from_rewards : train_network;
  return train_it(options, world, described, host);
}

}  // namespace

TrainingWorld::TrainingWorld(const TrainOptions& options)
    : options_(options),
      text_(options.from_input ? std::string{std::istreambuf_iterator<char>(std::cin), {}} : "") {}

world::World TrainingWorld::described(const plugin::Host& host, std::uint64_t seed) {
  try {
    return read(host, seed);
  } catch (const world::WorldError&) {
    for (const char* const learned : {"values", "weights"}) {
      removal_ = {path_of(options_.place) + learned + "/@remove=true"};
      try {
        return read(host, seed);
      } catch (const world::WorldError&) {  // that file is not what is wrong
      }
    }
    throw;
  }
}

world::World TrainingWorld::read(const plugin::Host& host, std::uint64_t seed,
                                 const std::vector<std::string>& edits,
                                 std::map<std::string, std::string>* found) const {
  world::ReadOptions reading = read_options(options_.edits, seed);
  reading.edits.insert(reading.edits.end(), removal_.begin(), removal_.end());
  reading.edits.insert(reading.edits.end(), edits.begin(), edits.end());
  reading.found = found;
  return options_.from_input ? world::parse_world(text_, options_.world, host, reading)
                             : world::read_world(options_.world, host, reading);
}

Shown shown(const TrainOptions& options) {
  if (options.progress) return Shown::lines;
  return options.quiet || options.json ? Shown::nothing : Shown::bar;
}

void add_train_command(CLI::App& program, Job& job) {
  CLI::App* command = program.add_subcommand(
      "train", "Train the coordinator of a robot and write what it has learned");
  command->footer(kTrainExamples);
  auto options = std::make_shared<TrainOptions>();
  command->add_option("WORLD", options->world, "World file")->required();
  command->add_flag("--stdin", options->from_input,
                    "Read the text of the world from standard input; WORLD is its name, next to "
                    "which its files are searched");
  command->add_option("--robot", options->place.robot,
                      "Robot of the coordinator; optional if the world has only one robot");
  command->add_option("--behavior", options->place.behavior,
                      "The coordinator inside this behaviour of the robot, such as blend/inner");
  command
      ->add_option("--weights", options->weights,
                   "File to write the weights of a network to; whole or not at all")
      ->type_name("FILE");
  command
      ->add_option(
          "--values", options->values,
          "File to write the values to that were learned from rewards; whole or not at all")
      ->type_name("FILE");
  command->add_option("--curve", options->curve, "Draw the learning curve")
      ->type_name("FILE.png|FILE.svg");
  command
      ->add_option("--seed", options->seed,
                   "Seed of the first weights, as of a run; or of the first episode, of which the "
                   "next has the next seed (1)")
      ->check(seed_number());
  command
      ->add_option("--episodes", options->episodes,
                   "Runs in which it learns from rewards (" + std::to_string(kEpisodes) + ")")
      ->check(whole_number(1, 10'000'000));
  command
      ->add_option("--explore", options->explore,
                   "Probability that a choice is drawn, in the first episode; it falls in a line, "
                   "and is 0 in the last tenth (" +
                       base::number_text(kExplore) + ")")
      ->check(number_between(0, 1));
  const auto parameter = [&](const char* option, const char* name, const char* about) {
    return command->add_option_function<std::string>(
        option, [options, name](const std::string& value) { options->parameters[name] = value; },
        about);
  };
  parameter("--hidden", "hidden", "Neurons in each hidden layer, such as '4 4'");
  parameter("--learning-rate", "learning_rate", "Learning rate, in (0, 1)")
      ->check(positive_number());
  parameter("--momentum", "momentum", "Momentum, in (0, 1)")->check(positive_number());
  parameter("--rule", "rule", "How it learns: 'standard' or 'original'")->type_name("RULE");
  parameter("--threshold", "threshold", "Mean error that is good enough");
  parameter("--presentations", "presentations", "Largest number of presentations of samples")
      ->check(whole_number());
  parameter("--attempts", "attempts", "How often training may restart after it missed a sample")
      ->check(whole_number());
  parameter("--training", "training", "File of samples")->type_name("FILE");
  command
      ->add_option("--set", options->edits,
                   "Change an attribute of the world first, as with elsie run; may be repeated")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
  options->plugins.add_to(*command);
  CLI::Option* json =
      command->add_flag("--json", options->json, "Print one JSON object, and nothing else");
  command
      ->add_flag("--progress", options->progress,
                 "Before it, print a line of JSON about ten times a second: presentations or "
                 "episode, of how many at most, error or reward")
      ->needs(json);
  command->add_flag("--quiet", options->quiet, "Print nothing but errors");
  command->callback([&job, options] { job = [options] { return train(*options); }; });
}

}  // namespace elsie::program
