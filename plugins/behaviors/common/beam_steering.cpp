#include "beam_steering.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <stdexcept>

#include <elsie/fuzzy/fcl.h>
#include <elsie/fuzzy/sets.h>

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Without a last output, the wheel stands.
double or_zero(double speed) { return std::isnan(speed) ? 0.0 : speed; }

std::size_t input_of(const elsie::fuzzy::Model& model, const char* name, const std::string& file) {
  const auto index = model.input_index(name);
  if (!index || model.inputs().size() != 2 || model.outputs().size() != 1) {
    throw std::invalid_argument("the fuzzy model '" + file +
                                "' must have the two inputs 'range' (m) and 'azimuth' (deg) and "
                                "one output, the wheel's speed (rad/s)");
  }
  return *index;
}

}  // namespace

BeamController::BeamController(const std::string& file, const std::string& block)
    : model_(elsie::fuzzy::read_fcl(file, block)),
      range_(input_of(model_, "range", file)),
      azimuth_(input_of(model_, "azimuth", file)) {
  const elsie::fuzzy::OutputVariable& speed = model_.outputs().front();
  if (speed.keeps_last && !speed.default_value) {
    undecided_ = model_.undecided_at(0);
  }
}

void BeamController::list_notes(std::vector<std::string>& notes) const {
  for (const elsie::base::Problem& note : model_.notes()) {
    notes.push_back(note.text());
  }
  if (undecided_) {
    notes.push_back("the output '" + output() + "' of the fuzzy model '" + model_.name() +
                    "' has DEFAULT := NC and no first value, and no rule decides it at " +
                    *undecided_ +
                    ": until a rule has, it is 0 for that beam; write, for example, "
                    "DEFAULT := 0 | NC if that is meant");
  }
}

std::array<double, 2> BeamController::inputs(double range_m, double azimuth_deg) const {
  std::array<double, 2> values{};
  values[range_] = range_m;
  values[azimuth_] = azimuth_deg;
  return values;
}

void BeamController::evaluate(double range_m, double azimuth_deg, double& speed) const {
  model_.evaluate(inputs(range_m, azimuth_deg), {&speed, 1}, workspace_);
}

elsie::FuzzySet BeamController::wish(double range_m, double azimuth_deg) const {
  return model_.output_set(0, inputs(range_m, azimuth_deg), workspace_);
}

void BeamSteering::configured() {
  left_.emplace(left_model.path, left_block);
  right_.emplace(right_model.path, right_block);
}

void BeamSteering::reset(elsie::Random&) {
  beams_.clear();
  left_speeds_.clear();
  right_speeds_.clear();
}

void BeamSteering::remember(elsie::Memory& memory) {
  memory("left_speeds", left_speeds_);
  memory("right_speeds", right_speeds_);
}

std::vector<std::string> BeamSteering::notes() const {
  std::vector<std::string> notes, of_right;
  left_->list_notes(notes);
  right_->list_notes(of_right);
  // Both wheels may have one model.
  std::copy_if(of_right.begin(), of_right.end(), std::back_inserter(notes),
               [&, end = notes.size()](const std::string& note) {
                 const auto last = notes.begin() + static_cast<std::ptrdiff_t>(end);
                 return std::find(notes.begin(), last, note) == last;
               });
  return notes;
}

elsie::Response BeamSteering::respond(const elsie::Perception& now) {
  const auto beams = now.readings<elsie::RangeReading>();
  beams_.clear();
  left_speeds_.resize(beams.size(), kNone);
  right_speeds_.resize(beams.size(), kNone);
  elsie::WheelRates sum, nearest;
  double nearest_m = 0.0;
  double activation = 0.0;
  for (const auto& beam : beams) {
    const elsie::Vector2 seen{beam->distance_m, elsie::degrees(beam.azimuth_rad())};
    double& left = left_speeds_[beams_.size()];
    double& right = right_speeds_[beams_.size()];
    left_->evaluate(seen.x, seen.y, left);
    right_->evaluate(seen.x, seen.y, right);
    const elsie::WheelRates wish{or_zero(left), or_zero(right)};
    sum += wish;
    if (concerns(beam.azimuth_rad()) && beam->hit && beam->max_range_m > 0.0) {
      activation = std::max(activation, 1.0 - beam->distance_m / beam->max_range_m);
    }
    if (beams_.empty() || seen.x < nearest_m) {
      nearest_m = seen.x;
      nearest = wish;
    }
    beams_.push_back(seen);
  }
  elsie::Response response;
  response.activation = std::clamp(activation, 0.0, 1.0);  // noise may give negative readings
  if (!beams_.empty()) {
    const double count = static_cast<double>(beams.size());
    response.command = now.self().wheels.motion(
        nearest_counts_twice_ ? (sum + nearest) / (count + 1.0) : sum / count);
  }
  return response;
}

void BeamSteering::list_inferences(std::vector<elsie::Inference>& list) const {
  const auto nearest =
      std::min_element(beams_.begin(), beams_.end(),
                       [](const elsie::Vector2& a, const elsie::Vector2& b) { return a.x < b.x; });
  if (nearest == beams_.end()) {
    return;
  }
  const auto index = static_cast<std::size_t>(nearest - beams_.begin());
  const auto add = [&](const BeamController& controller, const elsie::FilePath& model,
                       const std::string& block, double speed) {
    list.push_back({model.path,
                    block,
                    {{"range", nearest->x}, {"azimuth", nearest->y}},
                    {{controller.output(), speed}}});
  };
  add(*left_, left_model, left_block, left_speeds_[index]);
  add(*right_, right_model, right_block, right_speeds_[index]);
}

elsie::CommandSets BeamSteering::command_sets(const elsie::Perception& now,
                                              const elsie::Response& given) const {
  if (beams_.empty()) {
    return Behavior::command_sets(now, given);
  }
  elsie::CommandSets sets;
  for (const elsie::Vector2& beam : beams_) {
    sets.left = elsie::fuzzy::union_of(sets.left, left_->wish(beam.x, beam.y));
    sets.right = elsie::fuzzy::union_of(sets.right, right_->wish(beam.x, beam.y));
  }
  return sets;
}
