// Conditions that users write: "battery < 0.2 or not(leader_seen)".
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <elsie/api/coordinator.h>
#include <elsie/formula/formula.h>

/// A condition over what a robot perceives. Its names are
///
///   battery, front_range, ...  the inputs of perception_inputs.h
///   SENSOR.FIELD               a number of the reading of a sensor, by the sensor's id
///   MEMBER.NUMBER              a number that a behaviour publishes
///   event.NAME                 1 if the event is perceived now
///   heard.KIND                 the number of such messages that are heard now
///
/// What has no value now (a published number that is not there) is compared with nothing.
class Condition {
 public:
  /// Throws std::invalid_argument with a sentence.
  explicit Condition(const std::string& text)
      : text_(text), formula_(text, elsie::formula::Formula::Kind::condition) {}

  const std::string& text() const { return text_; }
  /// Finds what the names mean on this robot. Throws std::invalid_argument with a sentence.
  void equip(std::span<const elsie::Member> members, const elsie::Perception& example);
  /// Call equip() first.
  bool holds(std::span<const elsie::Member> members, const elsie::Perception& now);

 private:
  using Source = std::function<double(std::span<const elsie::Member>, const elsie::Perception&)>;
  Source source_of(const std::string& name, std::span<const elsie::Member> members,
                   const elsie::Perception& example) const;

  std::string text_;
  elsie::formula::Formula formula_;
  std::vector<Source> sources_;  // of its names
  std::vector<double> values_;
};

/// Whether the robot perceives the event now.
bool perceives(const elsie::Perception& now, std::string_view event);
