// Noise and failure of sensors, actuators and drives, as data of a world file.
//
//   <beam_range>
//     <noise on="distance_m" gaussian="0.01" resolution="0.005"/>
//     <failure dropout="0.05" latency="0.1"/>
//   </beam_range>
//
// Every sensor, actuator and drive may hold these elements, whatever its plugin: the simulator
// applies them to the numbers that visit() of a reading lists, after the sensor's own noise; to
// those of a command, before the actuator carries it out; or to the set points of a drive's joints.
// Each <noise> and <failure> draws from a random stream of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "elsie/api/component.h"
#include "elsie/api/declaration_items.h"
#include "elsie/api/reading.h"

namespace elsie {

/// Noise on a number, or on each number of an array. A value v becomes w = v scale + bias, then
/// w + w proportional n1 + gaussian n2 + uniform u, rounded to a multiple of `resolution`, within
/// `clamp`; n1 and n2 are normal with deviation 1, u is uniform in [-1, 1).
struct Noise {
  std::string on;             // a field: "blobs.distance"; of a drive: "left_wheel.rate"
  double scale = 1.0;         // a factor
  double bias = 0.0;          // in the unit of the number, as the following
  double proportional = 0.0;  // standard deviation as a fraction of the value
  double gaussian = 0.0;      // standard deviation
  double uniform = 0.0;       // half the width
  double resolution = 0.0;    // 0: it is not rounded
  std::vector<double> clamp;  // the least and the greatest value; empty: no limits
};

/// How a sensor fails to renew its reading, an actuator its command, or a drive the set points of
/// its joints.
struct UpdateFailure {
  double dropout = 0.0;      // probability of each update to be missed: the last one holds on
  double latency = 0.0;      // s: an update takes effect so much later
  double stuck_from = -1.0;  // s: from this time on nothing is renewed; negative: never
};

using Disturbance = std::variant<Noise, UpdateFailure>;

/// Declares the elements <noise> and <failure> for a plugin whose objects keep them in this list.
void declare_disturbances(Declaration& declaration,
                          std::vector<Disturbance>& (*list_of)(Component&));

/// A sensor or an actuator: a plugin object with a struct of its own, its reading or its command,
/// to which a world file may add noise and failures. Derive from SensorOf or ActuatorOf instead.
class Disturbable : public Component {
 public:
  /// "reading", "command"
  virtual const char* value_name() const = 0;
  /// The kind of the struct.
  virtual ReadingKind kind() const = 0;
  /// The address of the present struct, the same for the whole life of the object.
  virtual const void* value() const = 0;
  /// The same, to change it.
  virtual void* own_value() = 0;
  /// The address of a sensor's last measurement, or of the last command that a behaviour gave to an
  /// actuator: the present struct, unless the element has noise or failures. The simulator then
  /// computes the present one from it.
  virtual const void* undisturbed() const = 0;
  /// Makes the present struct blank. The simulator calls this before each run.
  virtual void forget() = 0;
  /// Makes it blank if its arrays have other sizes than those of a blank one, and returns whether
  /// they had; begins or ends to keep apart what is undisturbed. The simulator calls this after
  /// equipped().
  virtual bool fit_value() = 0;

  // Structs of this kind without their type.

  /// Calls `visit` for each field.
  virtual void visit_fields(const void* value, const FieldVisit& visit) const = 0;
  /// A blank one, in memory of its own.
  virtual std::shared_ptr<void> new_value() const = 0;
  virtual void copy_value(const void* from, void* to) const = 0;

  /// The noise and the failures that its element in the world file gives it, for the simulator.
  const std::vector<Disturbance>& disturbances() const { return disturbances_; }
  /// Adds what every such plugin declares.
  static void declare_for_all(Declaration& declaration);

 private:
  std::vector<Disturbance> disturbances_;
};

namespace detail {
/// Throws base::Error with a sentence: what is wrong with a struct of this object. `blank`: one
/// that has the right sizes.
[[noreturn]] void faulty_value(const Disturbable& object, const void* value, const void* blank);
}  // namespace detail

/// A `Base`, Sensor or Actuator, with its struct.
template <class Base, class Value>
class Holding : public Base {
 public:
  /// The struct before the first update or command. An object whose struct has arrays gives them
  /// their sizes here, by its parameters: all must have the same sizes. Called after equipped().
  virtual Value blank() const { return {}; }

  ReadingKind kind() const final { return ReadingKind::of<Value>(); }
  const void* value() const final { return &value_; }
  void* own_value() final { return &value_; }
  const void* undisturbed() const final { return undisturbed_ ? undisturbed_.get() : &value_; }
  void forget() final {
    value_ = blank();
    if (undisturbed_) *undisturbed_ = value_;
    sizes_ = checked(value_).sizes;
  }
  bool fit_value() final {
    if (this->disturbances().empty()) {
      undisturbed_.reset();
    } else if (!undisturbed_) {
      undisturbed_ = std::make_unique<Value>(value_);
    }
    const bool has_other_sizes = checked(blank()).sizes != sizes_;
    if (has_other_sizes) forget();
    return has_other_sizes;
  }
  void visit_fields(const void* value, const FieldVisit& visit) const final {
    elsie::visit_fields(*static_cast<const Value*>(value), visit);
  }
  std::shared_ptr<void> new_value() const final { return std::make_shared<Value>(blank()); }
  void copy_value(const void* from, void* to) const final {
    *static_cast<Value*>(to) = *static_cast<const Value*>(from);
  }

 protected:
  /// The present struct.
  const Value& current() const { return value_; }
  Value& in_work() { return undisturbed_ ? *undisturbed_ : value_; }
  /// Throws base::Error when its numbers are not finite, or its arrays have other sizes.
  void check(const Value& value) const {
    const ReadingCheck check = checked(value);
    if (!check.is_finite || !check.fits || check.sizes != sizes_) [[unlikely]] {
      const Value expected = blank();
      detail::faulty_value(*this, &value, &expected);
    }
  }

 private:
  using ReadingCheck = detail::ReadingCheck;
  static ReadingCheck checked(const Value& value) {
    ReadingCheck check;
    if constexpr (kListsFields<Value>) {
      value.visit(check);
    }
    return check;
  }

  Value value_{};
  std::unique_ptr<Value> undisturbed_;  // null: the present struct is
  std::uint64_t sizes_ = 0;             // see ReadingCheck
};

}  // namespace elsie
