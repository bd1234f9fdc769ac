// A measure under test.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "elsie/api/measure.h"
#include "elsie/testing/plugins.h"
#include "elsie/testing/scene.h"

namespace elsie::testing {

///   Scene now;
///   now.robot("r1");
///   Measure length("path_length", {{"robot", "r1"}});
///   length.observe(now);
///   now["r1"].distance_m = 0.5;
///   length.observe(now.step());
///   CHECK(length.value() == 0.5);
///
/// Any measure by its name. The first observe() calls equipped() and reset(), as before a run.
class Measure {
 public:
  /// Throws plugin::PluginError with a sentence for an unknown plugin, wrong names or values of
  /// parameters, and what configured() refuses.
  explicit Measure(const std::string& name, const Settings& settings = {},
                   const Elements& elements = {});
  Measure(const Plugins& plugins, const std::string& name, const Settings& settings = {},
          const Elements& elements = {});

  /// Shows the measure an instant. Throws what the plugin throws.
  void observe(const Scene& now);

  /// A value that it reports so far. Throws std::invalid_argument for a name that is not in its
  /// quantities(), and std::logic_error before it was equipped.
  std::optional<double> value(const std::string& name = "",
                              RunEnd::Outcome outcome = RunEnd::Outcome::time_limit) const;
  std::vector<Quantity> quantities() const;

  /// Returns to the start of a run.
  void reset();
  /// Sets what the world has; by default the first scene sets it. Throws what the plugin refuses.
  void equip(const Scene& start);

  const Declaration& declaration() const { return *declaration_; }
  elsie::Measure& operator*() { return *object_; }
  elsie::Measure* operator->() { return object_.get(); }

 private:
  Plugins plugins_;
  const Declaration* declaration_;
  plugin::Object<elsie::Measure> object_;
  double time_s_ = 0.0;
  bool equipped_ = false;
  bool reset_ = false;
};

}  // namespace elsie::testing
