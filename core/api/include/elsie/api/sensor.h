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
class Sensor : public Disturbable {
 public:
  /// Called after configured(), when the robot is complete, and again after a change of parameters
  /// during a run. Throw (std::invalid_argument, with a sentence) when the parameters do not fit
  /// the robot: then the change is refused, or the world, with the line of the sensor.
  virtual void equipped(const Carrier& /*carrier*/) {}

  /// The camera of the sensor, or none. The simulator takes a picture from the sensor's frame
  /// before each update. Called after configured(), and again when parameters were changed; a
  /// sensor must not gain or lose its camera. Pictures need EGL on the machine.
  virtual std::optional<Camera> camera() const { return std::nullopt; }

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
  const void* reading() const { return value(); }
  const char* value_name() const final { return "reading"; }
};

/// A sensor that produces readings of one kind.
template <class Reading>
class SensorOf : public Holding<Sensor, Reading> {
 public:
  using ReadingType = Reading;

  /// The present reading. Override this function, or sense_into() for readings that own memory
  /// (arrays, images), which is then reused from one update to the next.
  virtual Reading sense(const SensorContext& /*now*/) { return {}; }
  /// Updates the reading of the last update in place.
  virtual void sense_into(const SensorContext& now, Reading& reading) { reading = sense(now); }

  void update(const SensorContext& now) final {
    Reading& reading = this->in_work();
    sense_into(now, reading);
    this->check(reading);
  }
  /// Sets the present reading, for update_all().
  void set_reading(Reading reading) {
    Reading& to = this->in_work();
    to = std::move(reading);
    this->check(to);
  }
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
