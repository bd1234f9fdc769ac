// The earlier numbers of a run, for a window that plots them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "elsie/simulation/simulation.h"

#include "samples.h"

namespace elsie::server {

/// Samples of the numbers of all robots, by names such as "r1/speed", "r1/avoid/share" or
/// "r1/left/distance_m"; see Samples. Values are those of the last decision and measurement, not
/// rounded, in single precision. Numbers that do not exist at a time are NaN then. A node of a
/// graph, such as "r1/arbiter_states/nodes/3", is 0 (dark), 1 (running), 2 (success) or 3
/// (failure).
class Numbers {
 public:
  struct Sample {
    double time_s = 0.0;
    SharedNames names;
    std::vector<float> values;  // of the first names; the others are NaN

    std::size_t bytes() const { return sizeof(*this) + values.size() * sizeof(float); }
  };

  static constexpr std::string_view kMeasures = "measures";  // before the slash
  /// A robot whose graphs have more nodes has no numbers of them.
  static constexpr std::size_t kMostNodes = 500;

  /// By the names of numbers that have one.
  using Units = std::map<std::string, std::string, std::less<>>;

  explicit Numbers(std::size_t most = std::size_t{200} << 20) : samples_(most) {}

  /// Begins a new run. The first sample must be added at once.
  void begin(const simulation::Simulation& simulation, double period_s);
  /// The world has changed: robots may have other numbers from now on.
  void lay_out(const simulation::Simulation& simulation);
  /// Whether a sample is due. Must be called once for each time, in ascending order.
  bool is_due(double time_s) { return samples_.is_due(time_s); }
  /// Adds the present numbers; measures and the values of fuzzy models only on request, because
  /// they cost more. A plugin that fails to list its numbers loses them until the next layout,
  /// which a note says once in a run.
  void add(const simulation::Simulation& simulation, bool with_measures, bool with_fuzzy);

  /// The notes that were made since the last call.
  std::vector<simulation::Note> take_notes() { return std::exchange(notes_, {}); }

  double period_s() const { return samples_.period_s(); }
  std::size_t size() const { return samples_.all().size(); }
  std::span<const Sample> after(double time_s) const { return samples_.after(time_s); }
  /// The last sample until that time; null if there is none.
  const Sample* until(double time_s) const { return samples_.until(time_s); }
  /// The present names, and the number of this list, which changes with it.
  const std::vector<std::string>& names() const { return names_->names(); }
  std::uint64_t layout() const { return layout_; }
  const Units& units() const { return units_; }
  /// The values of these numbers in some samples: all of the first number, all of the second, ...
  static std::vector<float> values(std::span<const std::string> names,
                                   std::span<const Sample> samples);

 private:
  /// Visits the numbers of all robots except what has failed. Returns whether nothing new failed.
  template <class Visitor>
  bool visit_all(const simulation::Simulation& simulation, Visitor visitor);
  /// Visits the numbers that `list` lists for its visitor, if it succeeds.
  template <class List, class Visitor>
  void visit_published(std::string_view whose, std::pair<std::size_t, std::size_t> source,
                       const List& list, bool has_decided, Visitor& visitor);
  /// Visits a number for each node that the robot's graphs had when the names were listed.
  template <class Visitor>
  void visit_nodes(const simulation::Simulation& simulation, std::size_t robot, bool has_decided,
                   Visitor& visitor);
  /// Calls plugins of this source, a robot and a sensor, unless they have failed. Returns whether
  /// they have succeeded.
  template <class Call>
  bool succeeds(std::pair<std::size_t, std::size_t> source, const Call& call);
  void list_names(const simulation::Simulation& simulation);
  void set_names(std::vector<std::string> names);
  void add_further(const simulation::Simulation& simulation, bool with_measures, bool with_fuzzy,
                   std::vector<float>& values);

  Samples<Sample> samples_;
  SharedNames names_;
  Units units_;
  std::unordered_map<std::string, std::size_t> further_;  // places of measures and fuzzy values
  std::size_t fixed_ = 0;                                 // the number of names before them
  std::uint64_t layout_ = 0;
  std::set<std::pair<std::size_t, std::size_t>> failed_;
  std::set<std::pair<std::size_t, std::size_t>> silent_;  // they publish nothing
  /// Of each robot, by its place: the paths of its graphs, and the number of their nodes.
  std::map<std::size_t, std::vector<std::pair<std::string, std::size_t>>> nodes_;
  std::set<std::pair<std::string, std::string>> noted_;  // the robot and the id of a plugin
  std::vector<simulation::Note> notes_;
};

}  // namespace elsie::server
