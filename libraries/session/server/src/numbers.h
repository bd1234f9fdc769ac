// The earlier numbers of a run, for a window that plots them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "elsie/simulation/simulation.h"

#include "samples.h"

namespace elsie::server {

/// Samples of the numbers of all robots, by names such as "r1/speed", "r1/avoid/share" or
/// "r1/left/distance_m"; see Samples. Values are those of the last decision and measurement, not
/// rounded, in single precision. Numbers that do not exist at a time are NaN then.
class Numbers {
 public:
  struct Sample {
    double time_s = 0.0;
    std::shared_ptr<const std::vector<std::string>> names;
    std::vector<float> values;  // of the first names; the others are NaN

    std::size_t bytes() const { return sizeof(*this) + values.size() * sizeof(float); }
  };

  static constexpr std::string_view kMeasures = "measures";  // before the slash

  explicit Numbers(std::size_t most = std::size_t{200} << 20) : samples_(most) {}

  /// Begins a new run. The first sample must be added at once.
  void begin(const simulation::Simulation& simulation, double period_s);
  /// The world has changed: robots may have other numbers from now on.
  void lay_out(const simulation::Simulation& simulation);
  /// Whether a sample is due. Must be called once for each time, in ascending order.
  bool is_due(double time_s) { return samples_.is_due(time_s); }
  /// Adds the present numbers; measures and the values of fuzzy models only on request, because
  /// they cost more. A plugin that fails to list its numbers loses them; the run goes on.
  void add(const simulation::Simulation& simulation, bool with_measures, bool with_fuzzy);

  double period_s() const { return samples_.period_s(); }
  std::size_t size() const { return samples_.all().size(); }
  std::span<const Sample> after(double time_s) const { return samples_.after(time_s); }
  /// The present names, and the number of this list, which changes with it.
  const std::vector<std::string>& names() const { return *names_; }
  std::uint64_t layout() const { return layout_; }
  /// The values of these numbers in some samples.
  static std::vector<std::vector<float>> values(std::span<const std::string> names,
                                                std::span<const Sample> samples);

 private:
  void set_names(std::vector<std::string> names);
  void add_further(const simulation::Simulation& simulation, bool with_measures, bool with_fuzzy,
                   std::vector<float>& values);
  void put(const std::string& name, double value, std::vector<float>& values);

  Samples<Sample> samples_;
  std::shared_ptr<const std::vector<std::string>> names_;
  std::unordered_map<std::string, std::size_t> further_;  // places of measures and fuzzy values
  std::size_t fixed_ = 0;                                 // the number of names before them
  std::uint64_t layout_ = 0;
  bool has_sensors_ = true;
};

}  // namespace elsie::server
