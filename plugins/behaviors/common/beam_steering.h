// A pair of fuzzy controllers, one for each wheel, that are evaluated for every beam of a robot;
// shared by avoid_obstacle, turn_left and turn_right.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <elsie/api/behavior.h>
#include <elsie/api/inference.h>
#include <elsie/api/remember.h>
#include <elsie/fuzzy/model.h>

/// One wheel: a model with inputs `range` (m) and `azimuth` (deg, positive to the left) and the
/// output `speed` (rad/s).
class BeamController {
 public:
  /// `block`: a function block of the file, see fuzzy::read_fcl(). Throws fuzzy::FclError, or
  /// std::invalid_argument when the model has other inputs and outputs.
  explicit BeamController(const std::string& file, const std::string& block = "");

  /// Irregularities of the file, a sentence each.
  void list_notes(std::vector<std::string>& notes) const;

  /// Updates `speed`, the last one for this beam; NaN if there is none yet. It stays where no rule
  /// decides it and the model has DEFAULT := NC.
  void evaluate(double range_m, double azimuth_deg, double& speed) const;
  /// The name of its output.
  const std::string& output() const { return model_.outputs().front().name; }
  /// The output set before defuzzification.
  elsie::FuzzySet wish(double range_m, double azimuth_deg) const;

 private:
  std::array<double, 2> inputs(double range_m, double azimuth_deg) const;

  elsie::fuzzy::Model model_;
  mutable elsie::fuzzy::Workspace workspace_;
  std::size_t range_;
  std::size_t azimuth_;
  std::optional<std::string> undecided_;  // inputs at which it may need a last speed without one
};

/// A behaviour that sums the outputs of both controllers over all beams. Its activation is the
/// nearness of the nearest relevant object: 0 at a beam's maximum range and beyond, 1 at contact.
/// Each beam has a last output of its own, for models with DEFAULT := NC.
class BeamSteering : public elsie::Behavior, public elsie::Infers, public elsie::Remembers {
 public:
  elsie::FilePath left_model;
  elsie::FilePath right_model;
  std::string left_block;
  std::string right_block;

  void configured() override;
  void reset(elsie::Random& random) override;
  void remember(elsie::Memory& memory) override;
  std::vector<std::string> notes() const override;
  elsie::Response respond(const elsie::Perception& now) override;
  /// For each wheel, the union of its controller's output sets over all beams.
  elsie::CommandSets command_sets(const elsie::Perception& now,
                                  const elsie::Response& given) const override;
  /// Lists the inferences of both controllers at the nearest beam.
  void list_inferences(std::vector<elsie::Inference>& list) const override;

 protected:
  BeamSteering(const char* left, const char* right, bool nearest_counts_twice)
      : left_model{left}, right_model{right}, nearest_counts_twice_(nearest_counts_twice) {}

  /// True if obstacles in this direction are relevant; others do not change the activation.
  virtual bool concerns(double /*azimuth_rad*/) const { return true; }

 private:
  bool nearest_counts_twice_;
  std::optional<BeamController> left_;
  std::optional<BeamController> right_;
  std::vector<elsie::Vector2> beams_;  // range and azimuth of each beam in this step
  std::vector<double> left_speeds_;    // for each beam, the last output, rad/s; NaN if none yet
  std::vector<double> right_speeds_;
};
