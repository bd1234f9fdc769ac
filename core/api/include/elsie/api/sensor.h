// A sensor queries the world from its mounting and produces a reading of its kind.
//
// Once every control period, all sensors of all robots are updated for the same instant, before any
// behaviour is asked. A sensor adds its own noise, from its own random stream.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "elsie/api/component.h"
#include "elsie/api/disturbance.h"
#include "elsie/api/image.h"
#include "elsie/api/perception.h"
#include "elsie/api/reading.h"
#include "elsie/api/registration.h"
#include "elsie/api/surroundings.h"
#include "elsie/base/random.h"

namespace elsie {

/// The instant at which a sensor is updated.
struct SensorContext {
  double time_s = 0.0;
  double period_s = 0.0;
  Frame frame;               // the sensor in the world; it looks along forward
  const Mounting* mounting;  // the sensor on the robot
  const Surroundings* world;
  Random* random;
  const Image* image = nullptr;  // the present picture of its camera; see Sensor::camera()
};

/// Where a sensor is on its robot.
struct SensorPlace {
  Mounting mounting;
  Frame frame;  // the same, in the frame of the robot or of its segment
};

class Sensor;

namespace detail {
/// Throws base::Error with a sentence: what is wrong with a reading of the sensor. `blank`: one
/// that has the right sizes.
[[noreturn]] void faulty_reading(const Sensor& sensor, const void* reading, const void* blank);
}  // namespace detail

/// Several sensors of one plugin on one robot, which are updated in one call.
struct SensorBatch {
  struct Entry {
    Sensor* sensor;  // of the same class as the called object
    const SensorPlace* place;
    Random* random;
  };
  std::span<const Entry> sensors;
  double time_s;
  double period_s;
  const Frame& robot;  // in the world; of the segment, if they are on one
  const Surroundings* world;
  std::span<RayQuery> rays;  // memory for a query of each sensor, with any values

  /// What update() of one of them gets.
  SensorContext now(const Entry& each) const {
    return {time_s, period_s,   robot.frame(each.place->frame), &each.place->mounting,
            world,  each.random};
  }
};

/// Properties of the robot that carries a sensor; they do not change in a run. A view, valid only
/// during the call.
struct Carrier {
  const Mounting* mounting = nullptr;        // the sensor on the robot
  std::span<const Colour> resource_colours;  // see Surroundings
};

/// A sensor without the type of its reading. Derive from SensorOf<Reading> instead.
class Sensor : public Component {
 public:
  /// Called after configured(), when the robot is complete, and again after a change of parameters
  /// during a run. Throw (std::invalid_argument, with a sentence) when the parameters do not fit
  /// the robot: then the change is refused, or the world, with the line of the sensor.
  virtual void equipped(const Carrier& /*carrier*/) {}

  /// The camera of the sensor, or none. The simulator takes a picture from the sensor's frame
  /// before each update. Called after configured(), and again when parameters were changed; a
  /// sensor must not gain or lose its camera. Pictures need EGL on the machine.
  virtual std::optional<Camera> camera() const { return std::nullopt; }

  /// The kind of reading that it produces.
  virtual ReadingKind kind() const = 0;
  /// Produces a new reading.
  virtual void update(const SensorContext& now) = 0;
  /// Produces new readings of all sensors of this plugin on the robot, in file order; the called
  /// object is the first of them. Override this only for speed, where one query for all is cheaper
  /// than one for each: readings and random numbers must be those of update(). A fault in it is
  /// that of the first sensor. Sensors with a camera are always updated one by one.
  virtual void update_all(const SensorBatch& all) {
    for (const SensorBatch::Entry& each : all.sensors) {
      each.sensor->update(all.now(each));
    }
  }
  /// The address of the current reading, the same for the whole life of the sensor.
  virtual const void* reading() const = 0;
  /// The address of what the last update has measured: the current reading, unless its element
  /// gives the sensor noise or failures. The simulator then makes the reading of it.
  virtual const void* measured() const = 0;
  /// The current reading, to change it.
  virtual void* own_reading() = 0;
  /// Forgets the current reading: it is blank. The simulator calls this before each run.
  virtual void forget() = 0;
  /// Forgets the current reading if its arrays have other sizes than those of a blank one, and
  /// returns whether they had; begins or ends to keep apart what is measured. The simulator calls
  /// this after equipped().
  virtual bool fit_reading() = 0;

  // Readings without their type. `reading` is one of this sensor's kind.

  /// Calls `visit` for each of its fields.
  virtual void visit_fields(const void* reading, const FieldVisit& visit) const = 0;
  /// A blank one, in memory of its own.
  virtual std::shared_ptr<void> new_reading() const = 0;
  virtual void copy_reading(const void* from, void* to) const = 0;

  /// The noise and the failures that its element in the world file gives it, for the simulator.
  const std::vector<Disturbance>& disturbances() const { return disturbances_; }
  /// Adds what every sensor declares.
  static void declare_for_all(Declaration& declaration);

 private:
  std::vector<Disturbance> disturbances_;
};

/// A sensor that produces readings of one kind.
template <class Reading>
class SensorOf : public Sensor {
 public:
  using ReadingType = Reading;

  /// A reading before the first update. A sensor whose reading has arrays gives them their sizes
  /// here, by its parameters: every reading must have the same sizes. Called after equipped().
  virtual Reading blank() const { return {}; }
  /// The present reading. Override this function, or sense_into() for readings that own memory
  /// (arrays, images), which is then reused from one update to the next.
  virtual Reading sense(const SensorContext& /*now*/) { return {}; }
  /// Updates the reading of the last update in place.
  virtual void sense_into(const SensorContext& now, Reading& reading) { reading = sense(now); }

  ReadingKind kind() const final { return ReadingKind::of<Reading>(); }
  void update(const SensorContext& now) final {
    Reading& reading = in_work();
    sense_into(now, reading);
    check(reading);
  }
  /// Sets the present reading, for update_all().
  void set_reading(Reading reading) {
    Reading& to = in_work();
    to = std::move(reading);
    check(to);
  }
  const void* reading() const final { return &reading_; }
  const void* measured() const final { return measured_ ? measured_.get() : &reading_; }
  void* own_reading() final { return &reading_; }
  void forget() final {
    reading_ = blank();
    if (measured_) *measured_ = blank();
    sizes_ = checked(reading_).sizes;
  }
  bool fit_reading() final {
    if (disturbances().empty()) {
      measured_.reset();
    } else if (!measured_) {
      measured_ = std::make_unique<Reading>(reading_);
    }
    const bool has_other_sizes = checked(blank()).sizes != sizes_;
    if (has_other_sizes) forget();
    return has_other_sizes;
  }
  void visit_fields(const void* reading, const FieldVisit& visit) const final {
    elsie::visit_fields(*static_cast<const Reading*>(reading), visit);
  }
  std::shared_ptr<void> new_reading() const final { return std::make_shared<Reading>(blank()); }
  void copy_reading(const void* from, void* to) const final {
    *static_cast<Reading*>(to) = *static_cast<const Reading*>(from);
  }

 protected:
  /// The current reading, for sketch().
  const Reading& current() const { return reading_; }

 private:
  Reading& in_work() { return measured_ ? *measured_ : reading_; }
  static detail::ReadingCheck checked(const Reading& reading) {
    detail::ReadingCheck check;
    if constexpr (kListsFields<Reading>) {
      reading.visit(check);
    }
    return check;
  }
  void check(const Reading& reading) const {
    const detail::ReadingCheck check = checked(reading);
    if (!check.is_finite || !check.fits || check.sizes != sizes_) [[unlikely]] {
      const Reading expected = blank();
      detail::faulty_reading(*this, &reading, &expected);
    }
  }

  Reading reading_{};
  std::unique_ptr<Reading> measured_;  // null: what is measured is the reading
  std::uint64_t sizes_ = 0;            // see ReadingCheck
};

namespace detail {

/// True if &Class::sense is still that of SensorOf. A method that cannot be named here, because it
/// is private or overloaded, belongs to the class.
template <class Class>
constexpr bool kInheritsSense = requires {
  requires std::is_same_v<decltype(&Class::sense),
                          typename Class::ReadingType (SensorOf<typename Class::ReadingType>::*)(
                              const SensorContext&)>;
};
template <class Class>
constexpr bool kInheritsSenseInto = requires {
  requires std::is_same_v<decltype(&Class::sense_into),
                          void (SensorOf<typename Class::ReadingType>::*)(
                              const SensorContext&, typename Class::ReadingType&)>;
};

/// True if the class updates several sensors in one call.
template <class Class>
constexpr bool kUpdatesAll = !requires {
  requires std::is_same_v<decltype(&Class::update_all), void (Sensor::*)(const SensorBatch&)>;
};

}  // namespace detail

/// The sensor asks for Surroundings::contacts(), which the simulator does not compute for others.
inline auto feels_contacts() {
  return [](Declaration& declaration) { declaration.feels_contacts = true; };
}

/// Makes a sensor class a plugin; see ELSIE_BEHAVIOR. The kind of reading comes from its base
/// class.
#define ELSIE_SENSOR(Class, name, description, ...)                                           \
  static_assert(                                                                              \
      !::elsie::detail::kInheritsSense<Class> || !::elsie::detail::kInheritsSenseInto<Class>, \
      "this sensor senses nothing: override sense() or sense_into(), whose names and "        \
      "parameters must be those of SensorOf");                                                \
  ELSIE_REGISTER_PLUGIN_(::elsie::PluginKind::sensor, Class, name, description,               \
                         ::elsie::produces<Class::ReadingType>(                               \
                             ::elsie::detail::kUpdatesAll<Class>) __VA_OPT__(, ) __VA_ARGS__)

}  // namespace elsie
