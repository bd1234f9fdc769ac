// Lets a coordinator learn from rewards, in one episode after the other, and writes its values.
#include <algorithm>
#include <chrono>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "elsie/base/number_text.h"
#include "elsie/base/words.h"
#include "elsie/files/outputs.h"
#include "elsie/learning/reward_learner.h"
#include "elsie/render/world_cameras.h"
#include "elsie/simulation/simulation.h"

#include "command.h"
#include "interrupts.h"
#include "learning_curve.h"
#include "progress.h"
#include "rewards.h"
#include "streams.h"
#include "train_options.h"

namespace elsie::program {

namespace {

using simulation::Outcome;
using simulation::Simulation;

/// The run of each episode: like `elsie run` with its seed.
class EpisodeWorld {
 public:
  EpisodeWorld(const TrainOptions& options, const TrainingWorld& world,
               std::vector<std::string> edits, std::string plugin, const plugin::Host& host)
      : options_(options),
        world_(world),
        edits_(std::move(edits)),
        plugin_(std::move(plugin)),
        host_(host) {}

  /// At time zero. A world with layouts is drawn again.
  Simulation& begin(std::uint64_t seed) {
    if (!simulation_ || simulation_->world().drawn) {
      world::World world = world_.read(host_, seed, edits_);
      world.limits.wall_time.reset();  // or what is learned would depend on the clock
      simulation_.emplace(std::move(world), host_,
                          simulation::Options{.seed = seed,
                                              .data_directories = data_directories(),
                                              .cameras = render::world_cameras,
                                              .begin_later = true});
    }
    simulation_->reset(seed);
    return *simulation_;
  }
  /// Lets `call` use the learner. What that refuses, also when an edit of the world put another
  /// coordinator in its place, becomes BadInput.
  template <class Call>
  void ask(const Call& call) {
    const FoundCoordinator place = find_coordinator(simulation_->world(), options_.place);
    auto* const learner =
        dynamic_cast<learning::RewardLearner*>(&simulation_->object(place.robot, *place.use));
    try {
      if (!learner) throw std::logic_error("an edit in the run put another one in its place");
      call(*learner);
    } catch (const std::logic_error& problem) {
      throw BadInput("the coordinator '" + plugin_ + "' of the " + place.owner + ": " +
                     problem.what());
    }
  }

 private:
  const TrainOptions& options_;
  const TrainingWorld& world_;
  std::vector<std::string> edits_;
  std::string plugin_;  // that learns
  const plugin::Host& host_;
  std::optional<Simulation> simulation_;
};

struct Episode {
  std::vector<double> rewards;  // the sum of each
  Outcome outcome = Outcome::running;
  double time_s = 0.0;

  double reward() const {
    double sum = 0.0;
    for (const double each : rewards) sum += each;
    return sum;
  }
};

/// The training as a whole.
struct RewardTraining {
  std::string robot, plugin;
  std::vector<std::string> rewards;  // their ids
  std::uint64_t seed = 1;
  std::size_t planned = 0;  // episodes
  double explore = 0.0;
  std::vector<Episode> episodes;
  learning::Values values;

  /// Falls in a line to 0 at the last tenth of the episodes.
  double exploration() const {
    const double part = static_cast<double>(episodes.size()) / static_cast<double>(planned);
    return explore * std::max(0.0, 1.0 - part / 0.9);
  }
  /// The number of episodes in a mean: a tenth.
  std::size_t tenth() const { return std::max<std::size_t>(1, episodes.size() / 10); }
};

/// Throws std::logic_error when values of a plugin cannot be used here.
void require_tables(const learning::Values& values) {
  if (values.tables.empty()) {
    throw std::logic_error("what it has learned has no table of values; expected at least one");
  }
  for (const learning::NamedTable& table : values.tables) {
    if (table.values.states() == values.tables.front().values.states()) continue;
    throw std::logic_error("its table '" + table.name + "' has " +
                           base::counted(table.values.states(), "state") + ", but '" +
                           values.tables.front().name + "' has " +
                           std::to_string(values.tables.front().values.states()) +
                           "; expected the same states in all tables");
  }
}

/// Fails before the first episode when nothing could be written after the last one.
void rehearse(EpisodeWorld& world, const RewardTraining& training) {
  world.begin(training.seed);
  world.ask([&](learning::RewardLearner& learner) {
    learner.begin(training.rewards, {}, 0.0, Random(training.seed));
    const learning::Values values = learner.finish(learning::Ending::cut_off);
    require_tables(values);
    learning::values_text(values);
  });
}

/// Runs the next episode, in which the coordinator learns.
Episode run_episode(EpisodeWorld& world, RewardTraining& training,
                    std::span<simulation::Observer* const> observers, const std::string& path) {
  const std::uint64_t seed = training.seed + training.episodes.size();
  Simulation& simulation = world.begin(seed);
  Episode episode;
  episode.rewards.assign(training.rewards.size(), 0.0);
  std::vector<double> rewards(training.rewards.size());
  world.ask([&](learning::RewardLearner& learner) {
    learner.begin(training.rewards, std::move(training.values), training.exploration(),
                  Random(seed, path + "/explore"));
  });
  bool has_decided = false;
  const auto reward = [&] {
    if (!has_decided) return;
    read_rewards(simulation, training.rewards, rewards);
    for (std::size_t i = 0; i < rewards.size(); ++i) episode.rewards[i] += rewards[i];
    world.ask([&](learning::RewardLearner& learner) { learner.learned(rewards); });
  };
  simulation.run(observers, {}, [&](Simulation&) {
    reward();
    has_decided = true;
  });
  reward();  // of the last period, which a goal may have cut short
  episode.outcome = simulation.outcome();
  episode.time_s = simulation.time_s();
  world.ask([&](learning::RewardLearner& learner) {
    training.values =
        learner.finish(episode.outcome == Outcome::time_limit ? learning::Ending::cut_off
                                                              : learning::Ending::goal);
    require_tables(training.values);
  });
  return episode;
}

/// Shows the episodes.
class EpisodeWatcher {
 public:
  explicit EpisodeWatcher(Shown shown) : shown_(shown), bar_(shown == Shown::bar) {}

  void show(const RewardTraining& training) {
    constexpr auto kRedraw = std::chrono::milliseconds(100);
    const auto now = std::chrono::steady_clock::now();
    if (shown_ == Shown::nothing || now - last_ < kRedraw) return;
    last_ = now;
    const std::size_t done = training.episodes.size();
    const double reward = training.episodes.back().reward();
    if (shown_ == Shown::bar) {
      bar_.draw(bar_text(static_cast<double>(done) / static_cast<double>(training.planned)) +
                "  reward " + base::number_text(reward, 4));
    } else {
      data_out() << nlohmann::ordered_json{{"episode", done},
                                           {"of", training.planned},
                                           {"reward", reward}}
                        .dump()
                 << std::endl;
    }
  }

 private:
  Shown shown_;
  StatusLine bar_;
  std::chrono::steady_clock::time_point last_;
};

std::string training_header(const RewardTraining& training) {
  return training.robot + ", " + training.plugin + ": " + base::joined(training.rewards) + "; " +
         base::counted(training.planned, "episode") + " from seed " + std::to_string(training.seed);
}

/// "the first 20: mean reward -3.2, success in 2 of 20".
std::string mean_text(const std::string& name, std::span<const Episode> episodes) {
  double sum = 0.0;
  std::size_t reached = 0;
  for (const Episode& each : episodes) {
    sum += each.reward();
    reached += each.outcome == Outcome::success ? 1 : 0;
  }
  const std::string count = std::to_string(episodes.size());
  return name + " " + count + ": mean reward " +
         base::number_text(sum / static_cast<double>(episodes.size()), 4) + ", success in " +
         std::to_string(reached) + " of " + count;
}

std::vector<std::string> means(const RewardTraining& training) {
  const std::span<const Episode> all = training.episodes;
  return {mean_text("the first", all.first(training.tenth())),
          mean_text("the last", all.last(training.tenth()))};
}

/// The number of states in which no table has a value; the states are `of`.
std::size_t unseen_states(const learning::Values& values, std::size_t of) {
  std::size_t unseen = 0;
  for (std::size_t state = 0; state < of; ++state) {
    unseen += std::all_of(values.tables.begin(), values.tables.end(), [&](const auto& table) {
      const auto row = table.values.row(state);
      return std::all_of(row.begin(), row.end(), [](double value) { return value == 0.0; });
    });
  }
  return unseen;
}

std::size_t states_of(const RewardTraining& training) {
  return training.values.tables.front().values.states();
}

bool is_untrained(const RewardTraining& training) {
  return unseen_states(training.values, states_of(training)) == states_of(training);
}

/// The rewards that were 0 in every episode: their ids.
std::vector<std::string> absent_rewards(const RewardTraining& training) {
  std::vector<std::string> absent;
  for (std::size_t i = 0; i < training.rewards.size(); ++i) {
    const bool is_absent =
        std::all_of(training.episodes.begin(), training.episodes.end(),
                    [&](const Episode& episode) { return episode.rewards[i] == 0.0; });
    if (is_absent) absent.push_back(training.rewards[i]);
  }
  return absent;
}

/// What is to be said of the values; "" if nothing.
std::string warning_of(const RewardTraining& training) {
  std::string text;
  const std::size_t unseen = unseen_states(training.values, states_of(training));
  if (is_untrained(training)) {
    text = "It is untrained: all values are 0.";
  } else if (unseen > 0) {
    text = "In " + std::to_string(unseen) + " of " + base::counted(states_of(training), "state") +
           " nothing was learned: they did not occur, or had no reward.";
  }
  if (const auto absent = absent_rewards(training); !absent.empty()) {
    text += std::string(text.empty() ? "" : " ") + "In no episode was there a reward of " +
            base::joined(absent) + ".";
  }
  return text;
}

void print_training(const RewardTraining& training, double seconds, const TrainOptions& options) {
  out() << training_header(training) << ", in " << base::fixed_text(seconds, 2) << " s\n";
  for (const std::string& line : means(training)) out() << line << '\n';
  if (const std::string warning = warning_of(training); !warning.empty()) out() << warning << '\n';
  if (options.values) out() << "\nvalues: " << *options.values << '\n';
}

void print_training_json(const RewardTraining& training) {
  nlohmann::ordered_json object{
      {"robot", training.robot},        {"plugin", training.plugin},
      {"seed", training.seed},          {"explore", training.explore},
      {"rewards", training.rewards},    {"untrained", is_untrained(training)},
      {"warning", warning_of(training)}};
  object["episodes"] = nlohmann::ordered_json::array();
  for (const Episode& each : training.episodes) {
    object["episodes"].push_back({{"reward", each.reward()},
                                  {"rewards", each.rewards},
                                  {"outcome", simulation::to_string(each.outcome)},
                                  {"time_s", each.time_s}});
  }
  data_out() << object.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)
             << '\n';
}

void draw_training(const RewardTraining& training, const std::string& file) {
  std::vector<double> rewards;
  for (const Episode& each : training.episodes) rewards.push_back(each.reward());
  std::vector<std::string> lines = means(training);
  if (std::string warning = warning_of(training); !warning.empty()) lines.push_back(warning);
  draw_rewards(rewards, training.tenth(), training_header(training), lines, file);
}

/// Refuses to overwrite a file that the world still names in a training: another robot's.
void require_apart_from_world(const TrainOptions& options, const TrainingWorld& world,
                              const std::vector<std::string>& edits, const plugin::Host& host) {
  std::vector<files::Output> outputs;
  if (options.values) outputs.push_back({"--values", *options.values});
  if (options.curve) outputs.push_back({"--curve", *options.curve});
  if (outputs.empty()) return;
  std::map<std::string, std::string> found;
  world.read(host, options.seed.value_or(1), edits, &found);
  files::require_apart(outputs, read_files(options.world, found, options.plugins));
}

/// The training without its episodes. Throws BadInput when the robot has no reward.
RewardTraining planned_training(const TrainOptions& options, const world::World& world,
                                const FoundCoordinator& place, const plugin::Host& host) {
  RewardTraining training;
  training.robot = world.robots[place.robot].id;
  training.plugin = place.use->plugin;
  training.rewards = rewards_of(world, place.robot, host);
  training.seed = options.seed.value_or(1);
  training.planned = static_cast<std::size_t>(options.episodes.value_or(kEpisodes));
  training.explore = options.explore.value_or(kExplore);
  if (training.rewards.empty()) {
    throw BadInput("nothing rewards the robot '" + training.robot +
                   "': no measure of this world publishes a number 'reward' for it; add one to "
                   "<measures>, such as <reward robot=\"" +
                   training.robot + "\" of=\"collected - collisions\"/>");
  }
  return training;
}

}  // namespace

int train_from_rewards(const TrainOptions& options, const TrainingWorld& world,
                       const world::World& described, const plugin::Host& host) {
  const FoundCoordinator place = find_coordinator(described, options.place);
  RewardTraining training = planned_training(options, described, place, host);
  const std::vector<std::string> edits = learner_edits(place, "values", {{"untrained", "true"}});
  require_apart_from_world(options, world, edits, host);
  EpisodeWorld episodes(options, world, edits, training.plugin, host);
  const auto start = std::chrono::steady_clock::now();
  InterruptGuard interrupt;
  simulation::Observer* const observers[] = {&interrupt};
  EpisodeWatcher watcher(shown(options));
  try {
    rehearse(episodes, training);
    while (training.episodes.size() < training.planned) {
      training.episodes.push_back(run_episode(episodes, training, observers, place.path));
      watcher.show(training);
    }
  } catch (const Interrupted&) {
    err() << "elsie: interrupted after " << base::counted(training.episodes.size(), "episode")
          << "; nothing was written\n";
    return kOtherFailure;
  } catch (const simulation::EditRefused& refused) {
    throw BadInput(refused.report());
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  training.values.about.push_back({"training", base::counted(training.planned, "episode") +
                                                   " from seed " + std::to_string(training.seed) +
                                                   ", exploration " +
                                                   base::number_text(training.explore)});
  if (options.values) learning::write_values(training.values, *options.values);
  if (options.json) {
    print_training_json(training);
  } else if (!options.quiet) {
    print_training(training, taken.count(), options);
  }
  out().flush();
  if (options.curve) draw_training(training, *options.curve);
  return is_untrained(training) ? kGoalMissed : kSuccess;
}

}  // namespace elsie::program
