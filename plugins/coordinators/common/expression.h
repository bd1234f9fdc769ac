// Expressions that users write: "battery", "max(left_range, right_range)", "battery < 0.2".
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <elsie/api/coordinator.h>
#include <elsie/formula/formula.h>

/// A number or a condition over what a robot perceives. Its names are
///
///   battery, front_range, ...  the inputs of perception_inputs.h
///   SENSOR.FIELD               a number of the reading of a sensor, by the sensor's id
///   MEMBER.NUMBER              a number that a behaviour publishes
///   event.NAME                 1 if the event is perceived now
///   heard.KIND                 the number of such messages that are heard now
///
/// What has no value now (a published number that is not there) is compared with nothing.
class Expression {
 public:
  /// `what`: what it is called in messages. Throws std::invalid_argument with a sentence.
  explicit Expression(const std::string& text, const char* what = "expression")
      : text_(text), what_(what), formula_(text, elsie::formula::Formula::Kind::condition) {}

  const std::string& text() const { return text_; }
  /// Finds what the names mean on this robot. Throws std::invalid_argument with a sentence.
  void equip(std::span<const elsie::Member> members, const elsie::Perception& example);
  /// Its value now, of a condition 1 or 0; none where something in it has none. Call equip() first.
  std::optional<double> value(std::span<const elsie::Member> members, const elsie::Perception& now);

 private:
  using Source = std::function<double(std::span<const elsie::Member>, const elsie::Perception&)>;
  Source source_of(const std::string& name, std::span<const elsie::Member> members,
                   const elsie::Perception& example) const;

  std::string text_;
  const char* what_;
  elsie::formula::Formula formula_;
  std::vector<Source> sources_;  // of its names
  std::vector<double> values_;
};

/// Whether the robot perceives the event now.
bool perceives(const elsie::Perception& now, std::string_view event);
