#include "expression.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string_view>

#include <elsie/base/near_name.h>

#include "perception_inputs.h"

namespace {

using elsie::Member;
using elsie::Perception;

constexpr std::string_view kEvent = "event.", kHeard = "heard.";

/// Where a number stands in the readings of a robot.
struct ReadingPlace {
  std::size_t group, reading;
  std::size_t offset;  // in the struct of the reading
  elsie::FieldType type;

  double value(const Perception& now) const {
    elsie::ReadingField field;
    field.type = type;
    const void* const sensed = now.all_readings()[group].readings[reading].value;
    field.at = static_cast<const char*>(sensed) + offset;
    return field.number(0);
  }
};

/// Throws: there is no such name, but perhaps one like it.
[[noreturn]] void refuse(const std::string& what, const std::string& name,
                         const std::vector<std::string>& known) {
  throw std::invalid_argument(what + elsie::base::near_or_all(name, known, "there are"));
}

/// The number of a sensor's reading; none: no sensor has this id.
std::optional<ReadingPlace> find_reading(const std::string& sensor, const std::string& field,
                                         const Perception& example) {
  const auto groups = example.all_readings();
  for (std::size_t g = 0; g < groups.size(); ++g) {
    for (std::size_t r = 0; r < groups[g].readings.size(); ++r) {
      if (sensor != groups[g].readings[r].sensor || !groups[g].declaration) continue;
      std::vector<std::string> known;
      for (const elsie::FieldDeclaration& number : groups[g].declaration->fields) {
        if (!number.is_single) continue;
        if (number.name == field) return ReadingPlace{g, r, number.offset, number.type};
        known.push_back(sensor + "." + number.name);
      }
      refuse("the sensor '" + sensor + "' reads no single number '" + field + "'",
             sensor + "." + field, known);
    }
  }
  return std::nullopt;
}

/// The index of a number that a member publishes; none: there is no such member.
std::optional<std::pair<std::size_t, std::size_t>> find_published(const std::string& name,
                                                                  const std::string& number,
                                                                  std::span<const Member> members) {
  for (std::size_t m = 0; m < members.size(); ++m) {
    if (members[m].name() != name) continue;
    const auto all = members[m].published();
    std::vector<std::string> known;
    for (std::size_t n = 0; n < all.size(); ++n) {
      if (all[n].name == number) return std::pair(m, n);
      known.push_back(name + "." + all[n].name);
    }
    refuse("the behavior '" + name + "' publishes no number '" + number + "'", name + "." + number,
           known);
  }
  return std::nullopt;
}

}  // namespace

bool perceives(const Perception& now, std::string_view event) {
  return std::any_of(now.events().begin(), now.events().end(),
                     [event](const elsie::Event& each) { return each.name == event; });
}

void Expression::equip(std::span<const Member> members, const Perception& example) {
  sources_.clear();
  for (const auto& name : formula_.names()) {
    try {
      sources_.push_back(source_of(name.text, members, example));
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument("the " + std::string(what_) + " \"" + text_ + "\", column " +
                                  std::to_string(name.column) + ": " + error.what());
    }
  }
  values_.resize(sources_.size());
}

Expression::Source Expression::source_of(const std::string& name, std::span<const Member> members,
                                         const Perception& example) const {
  if (name.starts_with(kEvent)) {
    return [event = name.substr(kEvent.size())](auto, const Perception& now) {
      return perceives(now, event) ? 1.0 : 0.0;
    };
  }
  if (name.starts_with(kHeard)) {
    return [kind = name.substr(kHeard.size())](auto, const Perception& now) {
      const auto heard = now.all_heard();
      return static_cast<double>(
          std::count_if(heard.begin(), heard.end(), [&](const elsie::HeardMessage& message) {
            return kind == message.message->kind().name;
          }));
    };
  }
  if (const PerceptionInput* const input = find_perception_input(name)) {
    if (!input->available(example)) {
      throw std::invalid_argument("'" + name + "' needs " + input->needs);
    }
    return [input](auto, const Perception& now) { return input->value(now); };
  }
  const std::size_t dot = name.rfind('.');
  if (dot != std::string::npos) {
    const std::string of = name.substr(0, dot), number = name.substr(dot + 1);
    if (const auto found = find_published(of, number, members)) {
      return [found = *found](std::span<const Member> all, const Perception&) {
        return all[found.first].published(found.second);
      };
    }
    if (const auto found = find_reading(of, number, example)) {
      return [found = *found](auto, const Perception& now) { return found.value(now); };
    }
    throw std::invalid_argument("the robot has no behavior and no sensor '" + of + "'");
  }
  throw std::invalid_argument("'" + name + "' is nothing that the robot perceives" +
                              perception_input_hint(name));
}

std::optional<double> Expression::value(std::span<const Member> members, const Perception& now) {
  for (std::size_t i = 0; i < sources_.size(); ++i) values_[i] = sources_[i](members, now);
  return formula_.value(values_);
}
