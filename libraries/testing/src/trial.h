// One object of a plugin that the checker runs on random input.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "elsie/api/behavior.h"
#include "elsie/base/thrown.h"

#include "random_input.h"

namespace elsie::testing {

/// The result of one step, as numbers to be compared.
struct Answer {
  struct Number {
    std::string name;
    double value;
  };
  std::vector<Number> numbers;
  std::vector<std::string> events;

  void clear() {
    numbers.clear();
    events.clear();
  }
  void add(std::string name, double value) { numbers.push_back({std::move(name), value}); }
  void add(const CommandSets& sets);
  void add(const Motion& command);
};

/// The first difference of two answers; or none.
std::optional<std::string> difference(const Answer& one, const Answer& other);

/// Thrown for a wrong answer; what() continues "in step 3 ".
class Wrong : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Trial {
 public:
  virtual ~Trial() = default;
  /// Resets the object, as before a run.
  virtual void reset(std::uint64_t seed) = 0;
  /// Configures it again with the same values, as a user may.
  virtual void configure_again() = 0;
  /// Replaces `before`, another trial with the same setting, as a hot reload does. Returns whether
  /// the class remembers anything. Throws what the plugin throws.
  virtual bool take_over(Trial& before) = 0;
  /// Runs the next instant; `step` counts from 0, and the input repeats. Throws Wrong, and what the
  /// plugin throws.
  virtual void step(std::size_t step, Answer& answer) = 0;
  /// The object, to see what it draws.
  virtual Component& object() = 0;
  /// The number of steps in a run.
  virtual std::size_t run_length() const { return 150; }
};

/// The ingredients of a trial.
struct TrialSetting {
  const Plugins& plugins;
  const Declaration& declaration;
  const Settings& settings;
  const Elements& elements;
  const Input& input;
};

/// A robot that the plugin refuses in equipped(), or a sensor that cannot be tried. This is no
/// fault of the plugin.
class Refused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Throw Refused, and plugin::PluginError for parameters that configured() refuses.
std::unique_ptr<Trial> make_trial(const TrialSetting& setting);  // for any kind
std::unique_ptr<Trial> make_behavior_trial(const TrialSetting& setting);
std::unique_ptr<Trial> make_coordinator_trial(const TrialSetting& setting);
std::unique_ptr<Trial> make_sensor_trial(const TrialSetting& setting);
std::unique_ptr<Trial> make_measure_trial(const TrialSetting& setting);
std::unique_ptr<Trial> make_rule_trial(const TrialSetting& setting);
std::unique_ptr<Trial> make_drive_trial(const TrialSetting& setting);
std::unique_ptr<Trial> make_localisation_trial(const TrialSetting& setting);
std::unique_ptr<Trial> make_actuator_trial(const TrialSetting& setting);

/// Other sensors, behaviours and coordinators of the plugin's library; at most eight.
std::vector<const Declaration*> neighbours_of(const Declaration& declaration,
                                              const Plugins& plugins);
/// A trial of another plugin with its defaults on a robot with this id, which passes over its
/// faults; null if it cannot be made.
std::unique_ptr<Trial> make_neighbour_trial(const Declaration& neighbour, const std::string& id,
                                            const Plugins& plugins, std::uint64_t seed);

/// Runs equipped(); turns a std::exception into Refused.
template <class Action>
void equipping(Action action) {
  try {
    action();
  } catch (const std::exception&) {
    throw Refused(base::what_was_thrown());
  }
}

// Checks of answers; each throws Wrong.
void require_finite(const char* what, double value);
void require_degree(const char* what, double value);
void require_rating(std::span<const double> desirability);
void require_sets(const CommandSets& sets);
void require_finite(const Motion& command);
/// That it asked for no messages but those of its declaration.
void require_declared(const Declaration& declaration, const std::vector<ReadingKind>& listened);

/// Commands to be rated; the same for all trials.
std::span<const Motion> candidates();

}  // namespace elsie::testing
