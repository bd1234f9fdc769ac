#include "beam_steering.h"

#include <algorithm>
#include <stdexcept>

#include <elsie/fuzzy/fcl.h>
#include <elsie/fuzzy/sets.h>

namespace {

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
      azimuth_(input_of(model_, "azimuth", file)) {}

void BeamController::list_notes(std::vector<std::string>& notes) const {
  for (const elsie::base::Problem& note : model_.notes()) {
    notes.push_back(note.text());
  }
}

std::array<double, 2> BeamController::inputs(double range_m, double azimuth_deg) const {
  std::array<double, 2> values{};
  values[range_] = range_m;
  values[azimuth_] = azimuth_deg;
  return values;
}

double BeamController::speed(double range_m, double azimuth_deg) const {
  double speed = 0.0;
  model_.evaluate(inputs(range_m, azimuth_deg), {&speed, 1}, workspace_);
  return speed;
}

elsie::FuzzySet BeamController::wish(double range_m, double azimuth_deg) const {
  return model_.output_set(0, inputs(range_m, azimuth_deg), workspace_);
}

void BeamSteering::configured() {
  left_.emplace(left_model.path, left_block);
  right_.emplace(right_model.path, right_block);
}

std::vector<std::string> BeamSteering::notes() const {
  std::vector<std::string> notes;
  left_->list_notes(notes);
  right_->list_notes(notes);
  return notes;
}

elsie::Response BeamSteering::respond(const elsie::Perception& now) {
  beams_.clear();
  elsie::WheelRates sum, nearest;
  double nearest_m = 0.0;
  double activation = 0.0;
  for (const auto& beam : now.readings<elsie::RangeReading>()) {
    const elsie::Vector2 seen{beam->distance_m, elsie::degrees(beam.azimuth_rad())};
    const elsie::WheelRates wish{left_->speed(seen.x, seen.y), right_->speed(seen.x, seen.y)};
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
    const double beams = static_cast<double>(beams_.size());
    response.command = now.self().wheels.motion(
        nearest_counts_twice_ ? (sum + nearest) / (beams + 1.0) : sum / beams);
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
  const auto add = [&](const BeamController& controller, const elsie::FilePath& model,
                       const std::string& block) {
    list.push_back({model.path,
                    block,
                    {{"range", nearest->x}, {"azimuth", nearest->y}},
                    {{controller.output(), controller.speed(nearest->x, nearest->y)}}});
  };
  add(*left_, left_model, left_block);
  add(*right_, right_model, right_block);
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
