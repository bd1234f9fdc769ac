#include "observing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>
#include <utility>

#include "elsie/base/error.h"
#include "elsie/base/near_name.h"
#include "elsie/plugin/parameters.h"

#include "field_size.h"

namespace elsie::python {
namespace {

/// The bounds of numbers whose own are not known.
constexpr double kUnknown = 1e6;

template <class Number>
double stored_number(const void* at) {
  return static_cast<double>(*static_cast<const Number*>(at));
}

double number_at(const void* at, FieldType type) {
  switch (type) {
    case FieldType::boolean:
      return stored_number<bool>(at);
    case FieldType::int8:
      return stored_number<std::int8_t>(at);
    case FieldType::int16:
      return stored_number<std::int16_t>(at);
    case FieldType::int32:
      return stored_number<std::int32_t>(at);
    case FieldType::int64:
      return stored_number<std::int64_t>(at);
    case FieldType::uint8:
      return stored_number<std::uint8_t>(at);
    case FieldType::uint16:
      return stored_number<std::uint16_t>(at);
    case FieldType::uint32:
      return stored_number<std::uint32_t>(at);
    case FieldType::uint64:
      return stored_number<std::uint64_t>(at);
    case FieldType::real32:
      return stored_number<float>(at);
    case FieldType::real64:
      return stored_number<double>(at);
    case FieldType::picture:
      break;
  }
  return 0.0;
}

Bounded bounds_by_type(std::string name, FieldType type) {
  switch (type) {
    case FieldType::boolean:
      return {std::move(name), 0.0, 1.0};
    case FieldType::int8:
      return {std::move(name), -128.0, 127.0};
    case FieldType::uint8:
      return {std::move(name), 0.0, 255.0};
    case FieldType::uint16:
    case FieldType::uint32:
    case FieldType::uint64:
      return {std::move(name), 0.0, kUnknown};
    default:
      return {std::move(name), -kUnknown, kUnknown};
  }
}

const world::MountedUse* use_of(const world::Robot& robot, std::string_view sensor) {
  const auto found = std::find_if(robot.sensors.begin(), robot.sensors.end(),
                                  [&](const auto& use) { return use.id == sensor; });
  return found == robot.sensors.end() ? nullptr : &*found;
}

/// How far a sensor reaches, by its reading or its parameter `max_range`; 0: it is not known.
double reach_of(const simulation::SensorView& view, const world::Robot& robot,
                const plugin::Host& host) {
  const ReadingKind kind = view.sensor->kind();
  if (kind == ReadingKind::of<RangeReading>()) {
    return static_cast<const RangeReading*>(view.sensor->reading())->max_range_m;
  }
  const Declaration* const plugin = host.find(PluginKind::sensor, std::string(view.plugin));
  const world::MountedUse* const use = use_of(robot, view.id);
  if (!plugin || !use) return 0.0;
  for (const ParameterDeclaration& parameter : plugin->parameters) {
    if (parameter.name != "max_range" || parameter.type != ParameterType::real) continue;
    const auto given = use->parameters.find(parameter.name);
    return std::get<double>(given == use->parameters.end() ? parameter.default_value
                                                           : given->second);
  }
  return 0.0;
}

/// The bounds of a field. `reach_m`: see reach_of(); lengths are within it.
Bounded bounds_of(std::string name, const ReadingField& field, double reach_m) {
  Bounded bounds = bounds_by_type(std::move(name), field.type);
  if (field.unit == "m" && reach_m > 0.0) {
    const auto has = [&](std::string_view part) {
      return field.name.find(part) != field.name.npos;
    };
    bounds.low = has("dist") || has("range") ? 0.0 : -reach_m;
    bounds.high = reach_m;
  }
  return bounds;
}

bool names(const ReadingField& field, std::size_t i, std::string_view wanted) {
  return wanted.empty() || field.path() == wanted || field.column(i) == wanted;
}

}  // namespace

Observing::Observing(const simulation::Simulation& simulation, const plugin::Host& host,
                     std::size_t robot, const std::vector<Named>& names)
    : robot_(robot) {
  for (const Named& named : names) {
    if (named.name == "readings") {
      for (std::size_t i = 0; i < simulation.sensors(robot); ++i) {
        add_readings(simulation, host,
                     {std::string(simulation.sensor(robot, i).id), named.low, named.high});
      }
      continue;
    }
    if (!add_readings(simulation, host, named) && !add_own(simulation, named) &&
        !add_published(simulation, named)) {
      refuse(simulation, named);
    }
  }
  take(std::vector<Bounded>(numbers_));
}

void Observing::take(const std::vector<Bounded>& numbers) {
  numbers_ = numbers;
  low_.clear();
  high_.clear();
  for (const Bounded& number : numbers_) {
    if (!(number.low < number.high) || !std::isfinite(number.high - number.low)) {
      throw base::BadInput("observe: the bounds of '" + number.name +
                           "' are no interval; expected a least and a greatest value");
    }
    low_.push_back(static_cast<float>(number.low));
    high_.push_back(static_cast<float>(number.high));
  }
}

std::size_t Observing::add(Bounded number, const Named& named) {
  number.take_bounds(named);
  numbers_.push_back(std::move(number));
  return numbers_.size() - 1;
}

/// All sensors with readings of this kind, or the one with this id: "range.distance_m".
bool Observing::add_readings(const simulation::Simulation& simulation, const plugin::Host& host,
                             const Named& named) {
  const std::size_t point = named.name.find('.');
  const std::string head = named.name.substr(0, point);
  const std::string rest = point == std::string::npos ? "" : named.name.substr(point + 1);
  const std::size_t before = numbers_.size();
  const auto count = simulation.sensors(robot_);
  const auto is_kind = [&](std::size_t i) {
    return head == simulation.sensor(robot_, i).sensor->kind().name;
  };
  bool by_kind = false;
  for (std::size_t i = 0; i < count; ++i) by_kind = by_kind || is_kind(i);
  const world::Robot& robot = *simulation.robot(robot_).description;
  for (std::size_t i = 0; i < count; ++i) {
    const simulation::SensorView view = simulation.sensor(robot_, i);
    if (by_kind ? !is_kind(i) : head != view.id) continue;
    const double reach_m = reach_of(view, robot, host);
    const auto* const begin = static_cast<const char*>(view.sensor->reading());
    const std::size_t size = view.sensor->kind().size;
    Visited visited{i, {}};
    bool moves = false;
    std::vector<Stored> stored;
    simulation.visit_reading(robot_, i, [&](const ReadingField& field) {
      if (!field.is_number()) return;
      const auto* const first = static_cast<const char*>(field.at);
      const std::size_t bytes = size_of(field.type);
      const bool stays = field.is_stored && !field.varies && field.group.empty() &&
                         std::less_equal<>()(begin, first) &&
                         std::less_equal<>()(first + bytes * field.size, begin + size);
      for (std::size_t k = 0; k < field.size; ++k) {
        visited.places.push_back(kNowhere);
        if (!names(field, k, rest)) continue;
        const std::string name = std::string(view.id) + "." + field.column(k);
        const std::size_t place = add(bounds_of(name, field, reach_m), named);
        visited.places.back() = place;
        stored.push_back({place, first + bytes * k, field.type});
        moves = moves || !stays;
      }
    });
    if (moves) {
      visited_.push_back(std::move(visited));
    } else {
      for (const Stored& each : stored) keep(each);
    }
  }
  return numbers_.size() > before;
}

/// The robot's own state: "pose", "motion.turn", "energy".
bool Observing::add_own(const simulation::Simulation& simulation, const Named& named) {
  const OwnState& state = *simulation.robot(robot_).state;
  const world::Arena& arena = simulation.world().arena;
  const double fastest = state.max_speed_m_s, turn = fastest / state.wheels.half_axle;
  const std::size_t before = numbers_.size();
  const auto offer = [&](const std::string& group, const char* part, const auto& at, double low,
                         double high) {
    const std::string name = *part ? group + "." + part : group;
    if (named.name != group && named.name != name) return;
    const FieldType type =
        std::is_same_v<std::decay_t<decltype(at)>, bool> ? FieldType::boolean : FieldType::real64;
    keep({add({name, low, high}, named), &at, type});
  };
  offer("pose", "x", state.pose.x, -0.5 * arena.length, 0.5 * arena.length);
  offer("pose", "y", state.pose.y, -0.5 * arena.width, 0.5 * arena.width);
  offer("pose", "heading", state.pose.heading_rad, -std::numbers::pi, std::numbers::pi);
  for (const auto& [group, motion] : {std::pair<const char*, const Motion&>{"motion", state.moving},
                                      {"odometry", state.odometry},
                                      {"commanded", state.commanded}}) {
    offer(group, "forward", motion.forward, -fastest, fastest);
    if (state.channels.lateral) offer(group, "lateral", motion.lateral, -fastest, fastest);
    offer(group, "turn", motion.turn, -turn, turn);
  }
  offer("energy", "", state.energy, 0.0, std::max(state.capacity, 1.0));
  offer("charging", "", state.charging, 0.0, 1.0);
  return numbers_.size() > before;
}

/// Numbers that plugins of the robot publish, or else measures and rules:
/// "explore/avoid.clearance".
bool Observing::add_published(const simulation::Simulation& simulation, const Named& named) {
  const std::size_t before = numbers_.size();
  const auto look = [&](std::vector<std::size_t>& places, const auto& visit) {
    std::size_t i = 0;
    visit([&](const simulation::PublishedValue& published) {
      const std::string path(published.path), name = path + "." + published.number.name;
      if (places.size() == i) places.push_back(kNowhere);
      if (named.name == path || named.name == name) {
        if (places[i] != kNowhere) {
          throw base::BadInput("observe: '" + name + "' is named twice");
        }
        places[i] = add({name, -kUnknown, kUnknown}, named);
      }
      ++i;
    });
  };
  look(published_, [&](const auto& visit) { simulation.visit_published(robot_, visit); });
  if (numbers_.size() == before) {
    look(published_there_, [&](const auto& visit) { simulation.visit_published(visit); });
  }
  const auto is_unused = [](const std::vector<std::size_t>& places) {
    return std::all_of(places.begin(), places.end(), [](auto place) { return place == kNowhere; });
  };
  if (is_unused(published_)) published_.clear();
  if (is_unused(published_there_)) published_there_.clear();
  return numbers_.size() > before;
}

void Observing::refuse(const simulation::Simulation& simulation, const Named& named) const {
  std::vector<std::string> known{"readings",  "pose",   "motion",  "odometry",
                                 "commanded", "energy", "charging"};
  for (std::size_t i = 0; i < simulation.sensors(robot_); ++i) {
    const simulation::SensorView view = simulation.sensor(robot_, i);
    for (const std::string& head : {std::string(view.sensor->kind().name), std::string(view.id)}) {
      simulation.visit_reading(robot_, i, [&](const ReadingField& field) {
        if (field.is_number()) known.push_back(head + "." + field.path());
      });
    }
  }
  const auto add = [&](const simulation::PublishedValue& published) {
    known.push_back(std::string(published.path) + "." + published.number.name);
  };
  simulation.visit_published(robot_, add);
  simulation.visit_published(add);
  std::sort(known.begin(), known.end());
  known.erase(std::unique(known.begin(), known.end()), known.end());
  throw base::BadInput("observe: robot '" + simulation.robot(robot_).description->id +
                       "' has nothing that is named '" + named.name + "'" +
                       base::near_or_all(named.name, known, "it has"));
}

void Observing::keep(const Stored& stored) {
  if (stored.type == FieldType::real64) {
    reals_.push_back({stored.place, static_cast<const double*>(stored.at)});
  } else {
    stored_.push_back(stored);
  }
}

void Observing::read(const simulation::Simulation& simulation, float* to) const {
  for (const StoredReal& each : reals_) to[each.place] = static_cast<float>(*each.at);
  for (const Stored& each : stored_) {
    to[each.place] = static_cast<float>(number_at(each.at, each.type));
  }
  for (const Visited& each : visited_) {
    auto place = each.places.begin();
    simulation.visit_reading(robot_, each.sensor, [&](const ReadingField& field) {
      if (!field.is_number()) return;
      for (std::size_t k = 0; k < field.size && place != each.places.end(); ++k, ++place) {
        if (*place == kNowhere) continue;
        to[*place] = k < field.count ? static_cast<float>(field.number(k)) : 0.0f;
      }
    });
  }
  const auto look = [&](const std::vector<std::size_t>& places, const auto& visit) {
    if (places.empty()) return;
    std::size_t i = 0;
    visit([&](const simulation::PublishedValue& published) {
      const std::size_t place = i < places.size() ? places[i] : kNowhere;
      ++i;
      if (place == kNowhere) return;
      to[place] = std::isfinite(published.value) ? static_cast<float>(published.value) : 0.0f;
    });
  };
  look(published_, [&](const auto& visit) { simulation.visit_published(robot_, visit); });
  look(published_there_, [&](const auto& visit) { simulation.visit_published(visit); });
  for (std::size_t i = 0; i < low_.size(); ++i) to[i] = std::clamp(to[i], low_[i], high_[i]);
}

}  // namespace elsie::python
