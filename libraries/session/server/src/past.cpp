#include "past.h"

#include <algorithm>
#include <bit>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "elsie/output/base64.h"

#include "scene.h"

namespace elsie::server {
namespace {

constexpr std::size_t kMostNumbers = 100'000;  // in an answer

using Robots = std::unordered_set<std::string_view>;  // none: all

static_assert(std::endian::native == std::endian::little);

template <class Number>
std::string packed(const std::vector<Number>& numbers) {
  return output::base64(
      {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)});
}

/// The first of the samples, so many as fit into an answer with that number of columns. Adds their
/// times to the answer.
template <class Sample>
std::span<const Sample> first_of(std::span<const Sample> samples, std::size_t columns,
                                 double period_s, Json& answer) {
  const std::size_t most = std::max<std::size_t>(1, kMostNumbers / (columns + 1));
  const std::span<const Sample> first = samples.first(std::min(most, samples.size()));
  std::vector<double> times;
  for (const Sample& sample : first) {
    times.push_back(sample.time_s);
  }
  answer["period_s"] = period_s;
  answer["more"] = first.size() < samples.size();
  answer["times"] = packed(times);
  answer["values"] = Json::object();
  return first;
}

}  // namespace

void Past::begin(const simulation::Simulation& simulation) {
  const double period_s = period_of_past(simulation.world().physics.step);
  poses_.begin(body_names(simulation.world()), period_s);
  numbers_.begin(simulation, period_s);
  placed_.clear();
  events_ = simulation.events().size();
  keep(simulation);
}

void Past::watch(bool measures, bool fuzzy) {
  with_measures_ = with_measures_ || measures;
  with_fuzzy_ = with_fuzzy_ || fuzzy;
}

void Past::keep(const simulation::Simulation& simulation) {
  keep_poses(simulation);
  keep_numbers(simulation);
}

void Past::keep_poses(const simulation::Simulation& simulation) {
  place_bodies(simulation, bodies_);
  poses_.add(simulation.time_s(), simulation.steps(), bodies_);
}

void Past::keep_numbers(const simulation::Simulation& simulation) {
  numbers_.add(simulation, with_measures_, with_fuzzy_);
}

void Past::note_placements(const simulation::Simulation& simulation) {
  const auto events = simulation.events();
  for (; events_ < events.size(); ++events_) {
    const simulation::EventRecord& event = events[events_];
    const auto* const changed = event.as<events::Changed>();
    if (changed && changed->moves_robot()) {
      placed_.push_back({event.robot, event.time_s});
    }
  }
}

void Past::stepped(const simulation::Simulation& simulation) {
  note_placements(simulation);
  if (poses_.is_due(simulation.time_s())) {
    keep_poses(simulation);
  }
  if (numbers_.is_due(simulation.time_s())) {
    keep_numbers(simulation);
  }
}

void Past::replaced(const simulation::Simulation& simulation) {
  poses_.rename(body_names(simulation.world()));
  numbers_.lay_out(simulation);
}

Past::Wish Past::wish_of(const Json& order, bool of_numbers) {
  Wish wish;
  wish.of_numbers = of_numbers;
  wish.robots = order.value("robots", wish.robots);
  wish.after_s = order.value("after_s", wish.after_s);
  if (of_numbers) {
    wish.names = order.at("names").get<std::vector<std::string>>();
    wish.layout = whole_number(order, "layout", 0);
  }
  return wish;
}

void Past::tell(const Wish& wish, Json& answer) const {
  wish.of_numbers ? tell_numbers(wish, answer) : tell_paths(wish, answer);
}

void Past::tell_paths(const Wish& wish, Json& answer) const {
  constexpr std::string_view kBegin = "robot[", kEnd = "] 0";  // of a robot's first vehicle
  const Robots robots(wish.robots.begin(), wish.robots.end());
  std::vector<std::string> bodies, ids;
  for (const std::string& name : poses_.names()) {
    if (name.starts_with(kBegin) && name.ends_with(kEnd)) {
      std::string id = name.substr(kBegin.size(), name.size() - kBegin.size() - kEnd.size());
      if (robots.empty() || robots.contains(id)) {
        bodies.push_back(name);
        ids.push_back(std::move(id));
      }
    }
  }
  const auto samples =
      first_of(poses_.after(wish.after_s), 2 * ids.size(), poses_.period_s(), answer);
  const std::vector<History::Path> paths = History::paths(bodies, samples);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    answer["values"][ids[i] + "/x"] = packed(paths[i].x);
    answer["values"][ids[i] + "/y"] = packed(paths[i].y);
  }
  answer["placed"] = Json::array();
  for (const Placed& each : placed_) {
    if (each.time_s >= wish.after_s) {
      answer["placed"].push_back({{"robot", each.robot}, {"time_s", each.time_s}});
    }
  }
}

void Past::tell_numbers(const Wish& wish, Json& answer) const {
  const auto samples =
      first_of(numbers_.after(wish.after_s), wish.names.size(), numbers_.period_s(), answer);
  const std::vector<std::vector<float>> values = Numbers::values(wish.names, samples);
  for (std::size_t i = 0; i < wish.names.size(); ++i) {
    answer["values"][wish.names[i]] = packed(values[i]);
  }
  answer["layout"] = numbers_.layout();
  if (wish.layout == numbers_.layout()) {
    return;
  }
  const Robots robots(wish.robots.begin(), wish.robots.end());
  Json& names = answer["names"] = Json::array();
  for (const std::string& name : numbers_.names()) {
    const std::string_view robot = std::string_view(name).substr(0, name.find('/'));
    if (robots.empty() || robots.contains(robot) || robot == Numbers::kMeasures) {
      names.push_back(name);
    }
  }
}

}  // namespace elsie::server
