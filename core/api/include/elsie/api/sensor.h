// A sensor: it asks the world a question from where it is mounted and answers with a reading of its
// kind.
//
// Once every control period all sensors of all robots are updated, each from the same instant,
// before any behaviour is asked. A sensor adds its own noise, from its own random stream.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "elsie/api/component.h"
#include "elsie/api/geometry.h"
#include "elsie/api/image.h"
#include "elsie/api/perception.h"
#include "elsie/api/reading.h"
#include "elsie/api/registration.h"
#include "elsie/base/random.h"

namespace elsie {

/// A rectangular pyramid: its apex at the frame's origin, looking along the frame's forward axis.
struct Pyramid {
  Frame frame;                    // in the world
  double horizontal_fov_rad = 0;  // the full angle
  double vertical_fov_rad = 0;    // the full angle
  double range_m = 0;             // height of the pyramid, along its axis
};

/// What a sensor may ask of the world. The robot that carries the sensor is never part of an
/// answer.
class Surroundings {
 public:
  /// Distance in metres from `origin` to the first surface that range sensors see, along
  /// `direction` (a unit vector), both in the world frame; none beyond `max_range_m`.
  virtual std::optional<double> cast_ray(const Vector3& origin, const Vector3& direction,
                                         double max_range_m) const = 0;
  /// Whether any body that proximity sensors see reaches into the volume. The floor does not count.
  virtual bool anything_in(const Pyramid& pyramid) const = 0;
  /// The carrier's own true pose.
  virtual Pose pose() const = 0;
  /// The nearest other robot, of any team, within the radius around the carrier: for radio or
  /// infra-red beacons.
  virtual std::optional<TeamMate> nearest_robot(double radius_m) const = 0;
  /// All other robots, of any team, within the radius around the carrier, in file order; appended
  /// to `robots`.
  virtual void robots_within(double radius_m, std::vector<TeamMate>& robots) const = 0;
  /// The colours of the resources that the carrier may collect, as cameras see them in full light:
  /// each once, in file order. The same during a whole run.
  virtual std::span<const Colour> resource_colours() const = 0;

 protected:
  ~Surroundings() = default;
};

/// The instant at which a sensor is updated.
struct SensorContext {
  double time_s = 0.0;
  double period_s = 0.0;
  Frame frame;               // the sensor in the world: forward is where it looks
  const Mounting* mounting;  // the sensor on the robot
  const Surroundings* world;
  Random* random;
  const Image* image = nullptr;  // what the sensor's camera sees now; see Sensor::camera()
};

/// What a sensor learns about the robot that carries it, once that is complete: what does not
/// change in a run. A view, valid during the call.
struct Carrier {
  const Mounting* mounting = nullptr;        // the sensor on the robot
  std::span<const Colour> resource_colours;  // see Surroundings
};

/// A sensor with the type of its reading left out. Derive from SensorOf<Reading> instead.
class Sensor : public Component {
 public:
  /// Called after configured(), when the robot is complete, and again after a change of parameters
  /// while a run goes on. Throw (std::invalid_argument, with a sentence) when the parameters do not
  /// fit it: the world is refused then, at the sensor's line, or the change.
  virtual void equipped(const Carrier& /*carrier*/) {}

  /// The camera that the sensor looks through, if it does: the simulator then takes a picture from
  /// the sensor's frame before each update. Asked after configured(), and again when parameters
  /// were changed; whether it has one stays. Taking pictures needs
  /// EGL on the machine; a sensor without a camera does not.
  virtual std::optional<Camera> camera() const { return std::nullopt; }

  /// What kind of reading it makes.
  virtual ReadingKind kind() const = 0;
  /// Takes a new reading.
  virtual void update(const SensorContext& now) = 0;
  /// The memory of the current reading; the same address for the whole life of the sensor.
  virtual const void* reading() const = 0;
  /// Forgets the current reading; the simulator's call, before each run.
  virtual void forget() = 0;
  /// Appends the numbers of the current reading: always the same names in the same order.
  virtual void list_values(std::vector<NamedValue>& values) const = 0;
};

/// A sensor that produces readings of one kind.
template <class Reading>
class SensorOf : public Sensor {
 public:
  using ReadingType = Reading;

  /// What is sensed now. One of the two must be overridden: this one, or the next one for readings
  /// with memory of their own (images), which stay where they are from one update to the next.
  virtual Reading sense(const SensorContext& /*now*/) { return {}; }
  /// Likewise, into the reading of the last update.
  virtual void sense_into(const SensorContext& now, Reading& reading) { reading = sense(now); }

  ReadingKind kind() const final { return ReadingKind::of<Reading>(); }
  void update(const SensorContext& now) final { sense_into(now, reading_); }
  const void* reading() const final { return &reading_; }
  void forget() final { reading_ = Reading{}; }
  void list_values(std::vector<NamedValue>& values) const final {
    const auto add = [&values](const char* name, auto value) {
      values.push_back({name, static_cast<double>(value)});
    };
    if constexpr (kVisitable) {
      reading_.visit(add);
    }
  }

 private:
  static constexpr bool kVisitable =
      requires(const Reading& reading, void (*visitor)(const char*, double)) {
    reading.visit(visitor);
  };

  Reading reading_{};
};

namespace detail {

/// Whether &Class::sense still is that of SensorOf. A method that cannot be named from here, being
/// private or overloaded, is the class' own.
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

}  // namespace detail

/// Makes a sensor class a plugin; see ELSIE_BEHAVIOR. The kind of reading that it produces is taken
/// from its base.
#define ELSIE_SENSOR(Class, name, description, ...)                                           \
  static_assert(                                                                              \
      !::elsie::detail::kInheritsSense<Class> || !::elsie::detail::kInheritsSenseInto<Class>, \
      "this sensor senses nothing: override sense() or sense_into(), whose names and "        \
      "parameters must be those of SensorOf");                                                \
  ELSIE_REGISTER_PLUGIN_(::elsie::PluginKind::sensor, Class, name, description,               \
                         ::elsie::produces<Class::ReadingType>() __VA_OPT__(, ) __VA_ARGS__)

}  // namespace elsie
