// One object of a plugin at work on random input, for the checker.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "elsie/api/behavior.h"

#include "random_input.h"

namespace elsie::testing {

/// What came of one step, as numbers that can be compared.
struct Answer {
  struct Number {
    const char* name;
    double value;
  };
  std::vector<Number> numbers;
  std::vector<std::string> events;

  void clear() {
    numbers.clear();
    events.clear();
  }
  void add(const char* name, double value) { numbers.push_back({name, value}); }
  void add(const FuzzySet& set);
};

/// An answer that must not be; what() goes on after "in step 3 ".
class Wrong : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Trial {
 public:
  virtual ~Trial() = default;
  /// As before a run.
  virtual void reset(std::uint64_t seed) = 0;
  /// As when a user sets a parameter to the value that it has.
  virtual void configure_again() = 0;
  /// As when it is put in the place of `before`, another trial of the same setting, by a hot
  /// reload. Whether it remembers anything of what that did. Throws what the plugin throws.
  virtual bool take_over(Trial& before) = 0;
  /// The next instant; `step` counts from 0 and goes round the input. Throws Wrong, and what the
  /// plugin throws.
  virtual void step(std::size_t step, Answer& answer) = 0;
  /// How many steps there are time for.
  virtual std::size_t run_length() const { return 150; }
};

/// What a trial is made of.
struct TrialSetting {
  const Plugins& plugins;
  const Declaration& declaration;
  const Settings& settings;
  const Elements& elements;
  const Input& input;
};

/// A robot that the plugin refuses: what equipped() threw, or a sensor that cannot be tried. No
/// fault of the plugin's.
class Refused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throw Refused, and plugin::PluginError for parameters that configured() refuses.
std::unique_ptr<Trial> make_behavior_trial(const TrialSetting& setting);
std::unique_ptr<Trial> make_coordinator_trial(const TrialSetting& setting);
std::unique_ptr<Trial> make_sensor_trial(const TrialSetting& setting);
std::unique_ptr<Trial> make_measure_trial(const TrialSetting& setting);

/// Runs equipped(); a std::exception becomes Refused.
template <class Action>
void equipping(Action action) {
  try {
    action();
  } catch (const std::exception& refusal) {
    throw Refused(refusal.what());
  }
}

// What must be so of each answer; each throws Wrong.
void require_finite(const char* what, double value);
void require_degree(const char* what, double value);
void require_rating(std::span<const double> desirability);
void require_sets(const CommandSets& sets);

/// Commands to be rated, in one place for all.
std::span<const MotorCommand> candidates();

}  // namespace elsie::testing
