// Trains the network of a coordinator on samples, and writes its weights.
#include <algorithm>
#include <chrono>
#include <functional>
#include <map>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "elsie/base/number_text.h"
#include "elsie/files/outputs.h"
#include "elsie/process/text_table.h"
#include "elsie/world/error.h"

#include "command.h"
#include "interrupts.h"
#include "learning_curve.h"
#include "progress.h"
#include "streams.h"
#include "train_options.h"

namespace elsie::program {

namespace {

std::string rough(double value) { return base::number_text(value, 4); }

/// Shows the progress of a training, and stops it when the user interrupts.
class TrainingWatcher {
 public:
  explicit TrainingWatcher(Shown shown) : shown_(shown), bar_(shown == Shown::bar) {}

  bool operator()(const neural::TrainingProgress& progress) {
    constexpr auto kRedraw = std::chrono::milliseconds(100);
    const auto now = std::chrono::steady_clock::now();
    if (shown_ != Shown::nothing && now - last_ >= kRedraw) {
      last_ = now;
      shown_ == Shown::bar ? draw(progress) : print(progress);
    }
    return !InterruptGuard::is_interrupted();
  }

 private:
  void draw(const neural::TrainingProgress& progress) {
    const double part =
        static_cast<double>(progress.presentations) / static_cast<double>(progress.of);
    bar_.draw(bar_text(part) + "  mean error " + rough(progress.error));
  }
  static void print(const neural::TrainingProgress& progress) {
    data_out() << nlohmann::ordered_json{{"presentations", progress.presentations},
                                         {"of", progress.of},
                                         {"error", progress.error}}
                      .dump()
               << std::endl;
  }

  Shown shown_;
  StatusLine bar_;
  std::chrono::steady_clock::time_point last_;
};

struct Report {
  const Learner& learner;
  const neural::Lesson& lesson;
  std::uint64_t seed;
  double seconds;
  std::string warning;
};

std::string header(const Report& report) {
  return report.learner.robot + ", " + report.learner.plugin + ": network " +
         neural::sizes_text(report.lesson.weights.network.sizes()) + ", seed " +
         std::to_string(report.seed);
}

/// A row for each sample: its inputs, then for each output the target and the answer.
std::string answers(const neural::Lesson& lesson) {
  std::vector<std::vector<std::string>> rows(1);
  for (std::size_t i = 0; i < lesson.samples.inputs(); ++i) {
    rows[0].push_back(lesson.inputs[i]);
  }
  for (const std::string& output : lesson.outputs) {
    rows[0].push_back(output);
    rows[0].push_back("answer");
  }
  for (std::size_t s = 0; s < lesson.samples.size(); ++s) {
    std::vector<std::string>& row = rows.emplace_back();
    for (const double input : lesson.samples.inputs(s)) {
      row.push_back(rough(input));
    }
    for (std::size_t k = 0; k < lesson.outputs.size(); ++k) {
      row.push_back(rough(lesson.samples.targets(s)[k]));
      row.push_back(base::fixed_text(lesson.assessment.answer(s)[k], 4));
    }
  }
  return process::laid_out(rows, 0);
}

void print(const Report& report, const TrainOptions& options) {
  const neural::Lesson& lesson = report.lesson;
  out() << header(report) << '\n'
        << neural::summary(lesson.training, lesson.assessment) << ", in "
        << base::fixed_text(report.seconds, 2) << " s\n";
  if (!report.warning.empty()) {
    out() << report.warning << '\n';
  }
  out() << '\n' << answers(lesson);
  if (options.weights) {
    out() << "\nweights: " << *options.weights << '\n';
  }
}

void print_json(const Report& report) {
  const neural::Lesson& lesson = report.lesson;
  nlohmann::ordered_json object{
      {"robot", report.learner.robot},
      {"plugin", report.learner.plugin},
      {"seed", report.seed},
      {"error", lesson.assessment.error},
      {"presentations", lesson.training.presentations},
      {"below_threshold", lesson.training.ending == neural::Ending::threshold},
      {"untrained", lesson.assessment.untrained},
      {"warning", report.warning},
      {"inputs", lesson.inputs},
      {"outputs", lesson.outputs}};
  object["sizes"] = nlohmann::ordered_json::array();
  for (const int size : lesson.weights.network.sizes()) {
    object["sizes"].push_back(size);
  }
  const auto array = [](std::span<const double> numbers) {
    return nlohmann::ordered_json(std::vector<double>(numbers.begin(), numbers.end()));
  };
  object["samples"] = nlohmann::ordered_json::array();
  for (std::size_t s = 0; s < lesson.samples.size(); ++s) {
    object["samples"].push_back({{"inputs", array(lesson.samples.inputs(s))},
                                 {"targets", array(lesson.samples.targets(s))},
                                 {"answers", array(lesson.assessment.answer(s))}});
  }
  object["curve"] = nlohmann::ordered_json::array();
  for (const neural::CurvePoint& point : lesson.training.curve) {
    object["curve"].push_back({point.presentations, point.error});
  }
  data_out() << object.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)
             << '\n';
}

/// The stream of the network's first weights: that of a run with this seed, unless the coordinator
/// has its own seed.
elsie::Random stream_of(const Learner& learner, const TrainOptions& options, std::uint64_t& seed) {
  const std::int64_t fixed = learner.network->fixed_seed();
  if (fixed < 0) {
    seed = options.seed.value_or(1);
    return elsie::Random(seed, learner.path);
  }
  if (options.seed) {
    throw BadInput("--seed: the coordinator '" + learner.plugin + "' of the robot '" +
                   learner.robot + "' has the seed " + std::to_string(fixed) +
                   " of its own, which fixes its weights; take it out of the world first");
  }
  seed = static_cast<std::uint64_t>(fixed);
  return neural::stream_of_seed(seed);
}

using Parameters = std::map<std::string, std::string>;
using MakeLearner = std::function<Learner(const Parameters&)>;

/// Reports for an option, such as --learning-rate, what is wrong with it alone and not without it.
[[noreturn]] void blame_options(const Parameters& parameters, const MakeLearner& make,
                                const world::WorldError& error) {
  const auto problems_with = [&](const Parameters& some) -> std::vector<base::Problem> {
    try {
      make(some);
      return {};
    } catch (const world::WorldError& other) {
      return other.problems();
    }
  };
  const auto is_among = [](const std::vector<base::Problem>& all, const base::Problem& one) {
    return std::find(all.begin(), all.end(), one) != all.end();
  };
  std::vector<base::Problem> problems = error.problems();
  const std::vector<base::Problem> without = problems_with({});
  for (const auto& parameter : parameters) {
    const std::vector<base::Problem> with = problems_with({parameter});
    for (base::Problem& problem : problems) {
      if (is_among(with, problem) && !is_among(without, problem)) {
        problem.file = "--" + parameter.first;
        std::replace(problem.file.begin(), problem.file.end(), '_', '-');
        problem.line = 0;
      }
    }
  }
  throw world::WorldError(std::move(problems));
}

/// The coordinator with the options as its parameters. `found` gets the files that its world names.
Learner read_learner(const TrainOptions& options, const TrainingWorld& world,
                     const FoundCoordinator& place, const plugin::Host& host,
                     std::map<std::string, std::string>& found) {
  const auto make = [&](const Parameters& parameters) {
    return make_learner(
        world.read(host, options.seed.value_or(1),
                   learner_edits(place, "weights", {parameters.begin(), parameters.end()}), &found),
        host, options.place);
  };
  try {
    return make(options.parameters);
  } catch (const world::WorldError& error) {
    blame_options(options.parameters, make, error);
  }
}

}  // namespace

int train_network(const TrainOptions& options, const TrainingWorld& world,
                  const world::World& described, const plugin::Host& host) {
  std::map<std::string, std::string> found;
  const Learner learner =
      read_learner(options, world, find_coordinator(described, options.place), host, found);
  // The weights that the trained coordinator had are not among these files, and may be replaced.
  std::vector<files::Output> outputs;
  if (options.weights) outputs.push_back({"--weights", *options.weights});
  if (options.curve) outputs.push_back({"--curve", *options.curve});
  files::require_apart(outputs, read_files(options.world, found, options.plugins));

  std::uint64_t seed = 0;
  elsie::Random random = stream_of(learner, options, seed);
  const InterruptGuard interrupt;
  const auto start = std::chrono::steady_clock::now();
  neural::Lesson lesson = [&] {
    TrainingWatcher watcher(shown(options));
    try {
      return learner.network->learn(random, std::ref(watcher));
    } catch (const std::invalid_argument& problem) {
      throw BadInput(problem.what());
    }
  }();
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  if (lesson.training.ending == neural::Ending::stopped) {
    err() << "elsie: interrupted after " << lesson.training.presentations
          << " presentations; nothing was written\n";
    return kOtherFailure;
  }
  lesson.weights.about.push_back({"seed", std::to_string(seed)});
  const Report report{learner, lesson, seed, taken.count(),
                      neural::warning(lesson.assessment, lesson.outputs)};
  if (options.weights) {
    neural::write_weights(lesson.weights, *options.weights);
  }
  if (options.json) {
    print_json(report);
  } else if (!options.quiet) {
    print(report, options);
  }
  out().flush();
  if (options.curve) {
    std::vector<std::string> lines{neural::summary(lesson.training, lesson.assessment)};
    if (!report.warning.empty()) {
      lines.push_back(report.warning);
    }
    draw_learning_curve(lesson.training, header(report), lines, *options.curve);
  }
  return lesson.assessment.untrained ? kGoalMissed : kSuccess;
}

}  // namespace elsie::program
