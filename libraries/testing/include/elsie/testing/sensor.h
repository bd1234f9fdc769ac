// A sensor under test.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "elsie/api/sensor.h"
#include "elsie/testing/plugins.h"
#include "elsie/testing/surroundings.h"

namespace elsie::testing {

/// A number of a reading, by the name that it has in recordings: "distance_m", "ranges.0".
struct NamedValue {
  std::string name;
  double value = 0.0;
};

///   Sensor beam("beam_range", {{"max_range", 2.0}});
///   CHECK(beam.sense<RangeReading>(Surroundings().wall(1, -1, 1, 1)).hit);
///
/// Any sensor by its name, at the front edge and on top of a robot of the default size, looking
/// ahead, as by default in a world.
class Sensor {
 public:
  /// Throws plugin::PluginError with a sentence for an unknown plugin, wrong names or values of
  /// parameters, and what configured() refuses.
  explicit Sensor(const std::string& name, const Settings& settings = {},
                  const Elements& elements = {});
  Sensor(const Plugins& plugins, const std::string& name, const Settings& settings = {},
         const Elements& elements = {});

  /// Sets its place on the robot.
  Sensor& mounted(const Mounting& mounting);
  Sensor& turned(double yaw_deg, double pitch_deg = 0.0);

  /// A new reading, one control period after the last. A sensor with a camera gets a picture of
  /// these surroundings. Throws std::invalid_argument when its readings are of another kind.
  template <class Reading>
  const Reading& sense(const elsie::testing::Surroundings& surroundings) {
    require(ReadingKind::of<Reading>());
    update(surroundings, nullptr);
    return *static_cast<const Reading*>(object_->reading());
  }
  /// The same for a sensor with a camera, which gets this picture.
  template <class Reading>
  const Reading& sense(const Image& picture, const elsie::Surroundings& around = Surroundings()) {
    require(ReadingKind::of<Reading>());
    update(around, &picture);
    return *static_cast<const Reading*>(object_->reading());
  }
  /// Makes a new reading of any kind; values() gives its numbers.
  void update(const elsie::testing::Surroundings& surroundings, const Image* picture);
  void update(const elsie::Surroundings& surroundings, const Image* picture);
  /// The numbers of the current reading, by name.
  std::vector<NamedValue> values() const;

  /// Sets what its robot is like; by default the first surroundings do, and others whose resources
  /// have other colours. Throws what the plugin refuses.
  void equip(const elsie::Surroundings& surroundings);
  /// Returns to the start of a run, with the random stream (the noise) of this seed.
  void reset(std::uint64_t seed = 1);
  /// Acts as when its library is replaced while a robot drives (docs/hot-reload.md): continues the
  /// run of `before`, with what that remembers and its random stream. Returns whether both classes
  /// derive from Remembers; otherwise nothing is remembered. Throws what the plugin throws.
  bool take_over(Sensor& before);

  const Declaration& declaration() const { return *declaration_; }
  elsie::Sensor& operator*() { return *object_; }
  elsie::Sensor* operator->() { return object_.get(); }

 private:
  /// Throws std::invalid_argument when its readings are of another kind.
  void require(const ReadingKind& kind) const;
  Frame frame_at(const Pose& pose) const;

  Plugins plugins_;
  const Declaration* declaration_;
  Mounting mounting_{{0.04, 0.0, 0.09}, 0.0, 0.0};
  std::uint64_t seed_ = 1;  // of the random stream
  Random random_;
  plugin::Object<elsie::Sensor> object_;
  Image picture_;
  std::optional<std::vector<Colour>> colours_;  // the resources' colours that the sensor knows
  double time_s_ = 0.0;
  bool reset_ = false;
};

}  // namespace elsie::testing
