#include "priority_network.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include <elsie/base/words.h>
#include <elsie/neural/training.h>

#include "learning_curve.h"

using namespace elsie::neural;
using elsie::base::joined;

namespace {

constexpr const char* kTrainedHidden = "2 2";
constexpr const char* kMetres = "metres";
constexpr const char* kNormalised = "parts of the maximum range";

std::string file_name(const elsie::FilePath& file) {
  return std::filesystem::path(file.path).filename().string();
}

}  // namespace

elsie::neural::Method PriorityNetwork::method() const {
  return rule == "original" ? elsie::neural::Method::original : elsie::neural::Method::standard;
}

TrainingOptions PriorityNetwork::options() const {
  return {
      {learning_rate, momentum, method()}, threshold, static_cast<std::uint64_t>(presentations)};
}

Columns PriorityNetwork::columns() const {
  return {sensors_.size(), behaviors_.size(),
          "one for each range sensor: " + joined(sensors_, ", "),
          "one for each behaviour: " + joined(behaviors_, ", ")};
}

/// The hidden layers of a network to be trained. Throws std::invalid_argument.
std::vector<int> PriorityNetwork::hidden_layers() const {
  return parse_hidden_layers(hidden == kOwnHidden ? kTrainedHidden : hidden);
}

std::vector<int> PriorityNetwork::sizes() const {
  std::vector<int> sizes{static_cast<int>(sensors_.size())};
  for (const int layer : hidden_layers()) {
    sizes.push_back(layer);
  }
  sizes.push_back(static_cast<int>(behaviors_.size()));
  return sizes;
}

TrainingSet PriorityNetwork::read_samples() const {
  if (training.path.empty()) {
    throw std::invalid_argument(
        "there is nothing that its network could learn from; give it samples, such as "
        "training=\"training_sets/two_sensors_two_behaviors.txt\" for two range sensors and the "
        "behaviours avoid_obstacle and find_resource, or weights that elsie train has written");
  }
  return read_training_set(training.path, columns());
}

void PriorityNetwork::check_parameters() {
  hidden_layers();
  check(options());
  if (equipped_) {
    prepare();
  }
}

void PriorityNetwork::equip(std::span<const elsie::Member> members,
                            const elsie::Perception& example) {
  sensors_.clear();
  behaviors_.clear();
  for (const auto& reading : example.readings<elsie::RangeReading>()) {
    sensors_.emplace_back(reading.sensor());
  }
  for (const elsie::Member& member : members) {
    behaviors_.emplace_back(member.name());
  }
  if (sensors_.empty()) {
    throw std::invalid_argument(
        "its network's inputs are the readings of range sensors, but the robot has none; add a "
        "sensor such as beam_range");
  }
  readings_.resize(sensors_.size());
  priorities_.resize(behaviors_.size());
  prepare();
  if (has_begun_ && !behaviors_.empty() && !fits_robot()) {
    throw std::invalid_argument(
        "its network would have to be trained for " + columns().text() +
        ", and it is trained before a run only; put a coordinator with another id in its place in "
        "the same edit, which trains a new network");
  }
  equipped_ = true;
}

/// True if the network in use has the inputs and outputs that the robot needs.
bool PriorityNetwork::fits_robot() const {
  return learned_ && learned_->network.inputs() == sensors_.size() &&
         learned_->network.outputs() == behaviors_.size();
}

/// Reads the files that the parameters name, and checks that they fit the robot. A network trained
/// in the last run stays in use until the next one begins, unless weights replace it.
void PriorityNetwork::prepare() {
  samples_.reset();
  fixed_ = false;
  if (behaviors_.empty()) {
    return;  // nothing to decide
  }
  if (weights.path.empty()) {
    const Network network(sizes());  // throws if it cannot be made
    samples_ = read_samples();
  } else {
    load_weights();
  }
}

void PriorityNetwork::load_weights() {
  Weights read = read_weights(weights.path);
  const Network& network = read.network;
  const auto refuse = [&](const std::string& problem) {
    throw std::invalid_argument(weights.path + ": " + problem);
  };
  if (network.inputs() != sensors_.size() || network.outputs() != behaviors_.size()) {
    refuse("its network has " + std::to_string(network.inputs()) + " inputs and " +
           std::to_string(network.outputs()) + " outputs, but this robot needs " +
           columns().text());
  }
  const std::span<const int> layers = network.sizes().subspan(1, network.sizes().size() - 2);
  const std::vector<int> wanted = hidden_layers();
  if (hidden != kOwnHidden &&
      !std::equal(wanted.begin(), wanted.end(), layers.begin(), layers.end())) {
    refuse("its network is " + sizes_text(network.sizes()) + ", but hidden is '" + hidden +
           "'; make it 'auto' or leave it out, or train a network with these layers");
  }
  const std::string_view inputs = read.remark("inputs");
  if (!inputs.empty() && inputs != (normalise ? kNormalised : kMetres)) {
    refuse("its network was trained with inputs in " + std::string(inputs) + ", but normalise is " +
           (normalise ? "true" : "false"));
  }
  curves_.clear();
  notes_.clear();
  notes_.push_back("Network " + sizes_text(network.sizes()) + " with the weights of " +
                   file_name(weights) + "; nothing is trained.");
  for (const auto& [key, names] : {std::pair("sensors", joined(sensors_, " ")),
                                   std::pair("behaviors", joined(behaviors_, " "))}) {
    if (const std::string_view trained = read.remark(key); !trained.empty() && trained != names) {
      notes_.push_back("It was trained for the " + std::string(key) + " " + std::string(trained) +
                       ", and works with " + names + " here.");
    }
  }
  use(std::move(read));
  fixed_ = true;
}

void PriorityNetwork::use(Weights found) {
  learned_ = std::move(found);
  workspace_.emplace(learned_->network);
}

Lesson PriorityNetwork::learn(elsie::Random& random, const TrainingWatch& watch) const {
  Lesson lesson{
      samples_ ? *samples_ : read_samples(), sensors_, behaviors_, {}, {Network(sizes()), {}}, {}};
  for (int attempt = 1; attempt <= attempts; ++attempt) {
    Network network(sizes());
    network.randomize(random, method());
    elsie::neural::Training training_now = train(network, lesson.samples, options(), watch);
    elsie::neural::Assessment assessment = assess(network, lesson.samples);
    const bool ends = assessment.missed == 0 || training_now.ending == Ending::stopped;
    if (attempt == 1 || assessment.error < lesson.assessment.error) {
      lesson.weights.network = std::move(network);
      lesson.training = std::move(training_now);
      lesson.assessment = std::move(assessment);
    }
    lesson.attempts = attempt;
    if (ends) {
      break;
    }
  }
  lesson.weights.about = {{"inputs", normalise ? kNormalised : kMetres},
                          {"sensors", joined(sensors_, " ")},
                          {"behaviors", joined(behaviors_, " ")},
                          {"samples", file_name(training)},
                          {"training", summary(lesson.training, lesson.assessment)}};
  return lesson;
}

void PriorityNetwork::prepare_run(elsie::Random& random) {
  has_begun_ = true;
  if (behaviors_.empty() || fixed_) {
    return;
  }
  elsie::Random own = stream_of_seed(static_cast<std::uint64_t>(seed));
  Lesson lesson = learn(seed >= 0 ? own : random, {});
  notes_.clear();
  notes_.push_back("Network " + sizes_text(lesson.weights.network.sizes()) + " trained on " +
                   file_name(training) + ": " + summary(lesson.training, lesson.assessment) +
                   (lesson.attempts > 1
                        ? ", the best of " + std::to_string(lesson.attempts) + " attempts."
                        : "."));
  if (std::string warned = warning(lesson.assessment, behaviors_); !warned.empty()) {
    notes_.push_back(std::move(warned));
  }
  curves_ = {learning_curve(lesson.training)};
  use(std::move(lesson.weights));
  fixed_ = seed >= 0;
}

std::vector<std::string> PriorityNetwork::tell() const { return notes_; }
std::vector<elsie::Curve> PriorityNetwork::show() const { return curves_; }

std::span<const double> PriorityNetwork::priorities(const elsie::Perception& now) {
  if (behaviors_.empty()) {
    return {};
  }
  const auto beams = now.readings<elsie::RangeReading>();
  if (!fits_robot() || beams.size() != readings_.size()) {
    throw std::logic_error(
        "its network has not been prepared for this robot: equipped() and reset() come first");
  }
  for (std::size_t i = 0; i < readings_.size(); ++i) {
    const elsie::RangeReading& beam = *beams[i];
    readings_[i] = normalise ? beam.distance_m / beam.max_range_m : beam.distance_m;
    if (!std::isfinite(readings_[i])) {
      throw std::runtime_error("the reading of the sensor '" + sensors_[i] +
                               "' is not a finite number");
    }
  }
  learned_->network.evaluate(readings_, priorities_, *workspace_);
  return priorities_;
}
