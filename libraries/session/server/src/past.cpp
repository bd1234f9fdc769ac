#include "past.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "elsie/base/error.h"
#include "elsie/files/base64.h"
#include "elsie/traces/tracks.h"

#include "scene.h"

namespace elsie::server {
namespace {

constexpr std::size_t kMostNumbers = 100'000;  // in an answer
constexpr std::size_t kMostNames = 10'000;     // in an order

using Robots = std::unordered_set<std::string_view>;  // none: all

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
  answer["times"] = files::packed(times);
  return first;
}

// The name of a robot's first vehicle.
constexpr std::string_view kBegin = "robot[", kEnd = "] 0";

std::string first_vehicle(const std::string& robot) {
  return std::string(kBegin) + robot + std::string(kEnd);
}

}  // namespace

void Past::begin(const simulation::Simulation& simulation) {
  const double period_s = period_of_past(simulation.world().physics.step);
  poses_.begin(body_names(simulation.world()), period_s);
  numbers_.begin(simulation, period_s);
  looks_.begin(period_s);
  placed_.clear();
  events_ = simulation.events().size();
  keep(simulation);
}

void Past::keep(const simulation::Simulation& simulation) {
  keep_poses(simulation);
  keep_numbers(simulation);
  keep_look(simulation);
}

void Past::keep_poses(const simulation::Simulation& simulation) {
  place_bodies(simulation, bodies_);
  poses_.add(simulation.time_s(), simulation.steps(), bodies_);
}

void Past::keep_numbers(const simulation::Simulation& simulation) {
  numbers_.add(simulation, watching_.watches("measures"), watching_.watches("fuzzy"));
}

void Past::keep_look(const simulation::Simulation& simulation) {
  looks_.add(simulation.time_s(), watching_.look(simulation));
}

void Past::started(const simulation::Simulation& simulation) {
  const std::size_t seen = events_;
  begin(simulation);
  events_ = seen;  // a window may have the sample from before the changes at time zero
}

void Past::stepped(const simulation::Simulation& simulation) {
  traces::see_placements(simulation, events_, [this](const simulation::EventRecord& event) {
    placed_.push_back({event.robot, event.time_s});
  });
  if (poses_.is_due(simulation.time_s())) {
    keep_poses(simulation);
  }
  if (numbers_.is_due(simulation.time_s())) {
    keep_numbers(simulation);
  }
  if (looks_.is_due(simulation.time_s())) {
    keep_look(simulation);
  }
}

void Past::replaced(const simulation::Simulation& simulation) {
  poses_.rename(body_names(simulation.world()));
  numbers_.lay_out(simulation);
}

Past::Request Past::request_of(const Json& order, bool of_numbers) {
  Request request;
  request.of_numbers = of_numbers;
  request.robots = order.value("robots", request.robots);
  request.after_s = order.value("after_s", request.after_s);
  if (of_numbers) {
    request.names = order.at("names").get<std::vector<std::string>>();
    if (request.names.size() > kMostNames) {
      throw base::BadInput("the order asks for " + std::to_string(request.names.size()) +
                           " numbers; expected at most " + std::to_string(kMostNames) +
                           " `names`: ask for the others in a further order");
    }
    request.layout = whole_number(order, "layout", 0);
  }
  return request;
}

void Past::tell(const Request& request, Json& answer) const {
  request.of_numbers ? tell_numbers(request, answer) : tell_paths(request, answer);
}

void Past::tell_paths(const Request& request, Json& answer) const {
  const Robots robots(request.robots.begin(), request.robots.end());
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
      first_of(poses_.after(request.after_s), 2 * ids.size(), poses_.period_s(), answer);
  const std::vector<History::Path> paths = History::paths(bodies, samples);
  Json& curves = answer["curves"] = Json::array();
  std::vector<float> values;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    curves.push_back(ids[i] + "/x");
    curves.push_back(ids[i] + "/y");
    values.insert(values.end(), paths[i].x.begin(), paths[i].x.end());
    values.insert(values.end(), paths[i].y.begin(), paths[i].y.end());
  }
  answer["values"] = files::packed(values);
  Json& placed = answer["placed"] = Json::array();
  const auto is_before = [](const Placed& each, double time_s) { return each.time_s < time_s; };
  auto each = std::lower_bound(placed_.begin(), placed_.end(), request.after_s, is_before);
  for (; each != placed_.end() && !samples.empty() && each->time_s < samples.back().time_s;
       ++each) {
    placed.push_back({{"robot", each->robot}, {"time_s", each->time_s}});
  }
}

void Past::add_paths(picture::TopView& view) const {
  std::vector<std::string> bodies;
  for (const picture::RobotTrack& robot : view.robots) bodies.push_back(first_vehicle(robot.id));
  const auto samples = poses_.after(-1.0);
  const std::vector<History::Path> paths = History::paths(bodies, samples);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    picture::RobotTrack& robot = view.robots[i];
    for (std::size_t k = 0; k < samples.size(); ++k) {
      robot.path.push_back({paths[i].x[k], paths[i].y[k], 0.0});
    }
    for (const Placed& placed : placed_) {
      const auto after = std::lower_bound(
          samples.begin(), samples.end(), placed.time_s,
          [](const auto& sample, double time_s) { return sample.time_s < time_s; });
      if (placed.robot == robot.id && after != samples.end()) {
        robot.placed.push_back(static_cast<std::size_t>(after - samples.begin()));
      }
    }
  }
  view.path_period_s = poses_.period_s();
}

void Past::tell_numbers(const Request& request, Json& answer) const {
  const auto samples =
      first_of(numbers_.after(request.after_s), request.names.size(), numbers_.period_s(), answer);
  answer["curves"] = request.names;
  answer["values"] = files::packed(Numbers::values(request.names, samples));
  answer["layout"] = numbers_.layout();
  if (request.layout == numbers_.layout()) {
    return;
  }
  const Robots robots(request.robots.begin(), request.robots.end());
  Json names = Json::array(), units = Json::object();
  for (const std::string& name : numbers_.names()) {
    const std::string_view robot = std::string_view(name).substr(0, name.find('/'));
    if (robots.empty() || robots.contains(robot) || robot == Numbers::kMeasures) {
      names.push_back(name);
      const auto unit = numbers_.units().find(name);
      if (unit != numbers_.units().end()) units[name] = unit->second;
    }
  }
  answer["names"] = std::move(names);
  answer["units"] = std::move(units);
}

void Past::tell_instant(double time_s, const std::vector<std::string>& robots, Json& answer) const {
  const Robots wanted(robots.begin(), robots.end());
  Json& numbers = answer["numbers"] = Json::object();
  if (const Numbers::Sample* const then = numbers_.until(time_s)) {
    const std::vector<std::string>& names = then->names->names();
    for (std::size_t i = 0; i < then->values.size(); ++i) {
      const std::string_view robot = std::string_view(names[i]).substr(0, names[i].find('/'));
      if (wanted.contains(robot) && std::isfinite(then->values[i])) {
        numbers[names[i]] = then->values[i];
      }
    }
  }
  if (Json look = looks_.at(time_s); !look.is_null()) answer["look"] = std::move(look);
}

}  // namespace elsie::server
