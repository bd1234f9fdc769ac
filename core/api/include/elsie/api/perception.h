// What a behaviour perceives.
#pragma once

#include <cstddef>
#include <iterator>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "elsie/api/event.h"
#include "elsie/api/geometry.h"
#include "elsie/api/message.h"
#include "elsie/api/motion.h"
#include "elsie/api/reading.h"
#include "elsie/base/random.h"

namespace elsie {

/// The position and direction of a sensor in the frame of the robot, or of a segment that it pulls
/// (origin on the floor below the middle of the axle, x forward, y left).
struct Mounting {
  Vector3 position;          // m
  double azimuth_rad = 0.0;  // from the robot's forward axis, counter-clockwise, in (-pi, pi]
  double pitch_rad = 0.0;    // positive points up
  int segment = 0;           // 0: the robot; then its segments, counted backwards from it
};

/// Something that the robot holds.
struct HeldThing {
  std::string_view id;        // of the resource or the box
  std::string_view actuator;  // the id of the one that holds it
  bool moves = false;         // as many robots hold it as must for it to move with them
};

/// Where the robots of a team deliver resources.
struct NestView {
  Vector2 place;  // m, its middle
  double radius_m = 0.0;
};

/// The state of the robot's own body.
struct OwnState {
  std::string_view id;
  Pose pose;          // as the robot believes; see localisation.h
  Motion commanded;   // in the last step, as the drive can make it
  Motion moving;      // as it believes
  Motion odometry;    // from the joints of the drive: the motion if no wheel slips
  Channels channels;  // that the drive can make
  /// For behaviours that use wheel rates, with any drive: `self.wheels.motion({l, r})` is the
  /// command, `self.wheels.wheel_rates(motion)` the inverse.
  WheelPair wheels;
  double length_m = 0.08;  // of the chassis, along the heading
  double width_m = 0.08;   // of the chassis
  double max_speed_m_s = 0.5;
  double coverage_m = 0.5;  // communication radius: within it, mates perceive this robot
  bool is_leader = false;
  int team_index = 0;        // its number in its team, in file order, from 0
  double energy = 5000.0;    // units
  double capacity = 5000.0;  // units
  bool charging = false;
  bool hears_messages = true;       // it has an actuator that hears them
  std::span<const HeldThing> held;  // one for each actuator that holds something

  /// The largest wheel rate that the robot obeys, rad/s.
  double max_wheel_rate() const { return max_speed_m_s / wheels.radius; }
};

/// Another robot of the same team, whose communication coverage reaches this one.
struct TeamMate {
  std::string_view id;
  Pose pose;  // as that robot believes
  double distance_m = 0.0;
  double bearing_rad = 0.0;  // from this robot's heading, positive to the left
  bool is_leader = false;
  int team_index = 0;  // see OwnState
};

struct TeamState {
  std::string_view name;
  std::span<const TeamMate> mates;  // those whose coverage reaches this robot, in file order
  std::optional<Vector2> charger;   // the team's nearest charger
  std::optional<NestView> nest;     // the team's nearest nest

  /// The nearest leader whose coverage reaches this robot, or none.
  const TeamMate* leader() const {
    const TeamMate* nearest = nullptr;
    for (const TeamMate& mate : mates) {
      if (mate.is_leader && (!nearest || mate.distance_m < nearest->distance_m)) {
        nearest = &mate;
      }
    }
    return nearest;
  }
};

/// One sensor's current reading, without its type.
struct SensedReading {
  const void* value = nullptr;
  const Mounting* mounting = nullptr;
  const char* sensor = "";  // its id
  double age_s = 0.0;       // how long ago it was measured, by the latency and dropouts of its file
};

/// All readings of one kind, in the order of the sensors in the world file.
struct ReadingGroup {
  ReadingKind kind;
  std::span<const SensedReading> readings;
  const ReadingDeclaration* declaration = nullptr;  // of the first of the sensors; null: unknown
};

/// One reading of a known type: `beam->distance_m`, `beam.azimuth_rad()`.
template <class Reading>
class Sensed {
 public:
  explicit Sensed(const SensedReading& sensed) : sensed_(&sensed) {}
  const Reading& operator*() const { return *static_cast<const Reading*>(sensed_->value); }
  const Reading* operator->() const { return static_cast<const Reading*>(sensed_->value); }
  const Mounting& mounting() const { return *sensed_->mounting; }
  double azimuth_rad() const { return sensed_->mounting->azimuth_rad; }
  std::string_view sensor() const { return sensed_->sensor; }
  /// How long ago it was measured, s. Above 0 only if the world file gives the sensor a latency or
  /// dropouts.
  double age_s() const { return sensed_->age_s; }

 private:
  const SensedReading* sensed_;
};

namespace detail {
/// Throws std::out_of_range with a sentence: there are only `count` readings of this kind.
[[noreturn]] void no_such_reading(const char* kind, std::size_t i, std::size_t count);
/// Throws base::Error with a sentence: a sensor makes other readings of this name.
[[noreturn]] void other_layout(const ReadingKind& wanted, const ReadingGroup& made);
}  // namespace detail

/// A view of the readings of one type, to loop over.
template <class Reading>
class Readings {
 public:
  class Iterator {
   public:
    using value_type = Sensed<Reading>;
    using difference_type = std::ptrdiff_t;
    Iterator() = default;
    explicit Iterator(const SensedReading* at) : at_(at) {}
    Sensed<Reading> operator*() const { return Sensed<Reading>(*at_); }
    Iterator& operator++() {
      ++at_;
      return *this;
    }
    Iterator operator++(int) { return Iterator(at_++); }
    friend bool operator==(const Iterator&, const Iterator&) = default;

   private:
    const SensedReading* at_ = nullptr;
  };

  Readings() = default;
  explicit Readings(std::span<const SensedReading> all) : all_(all) {}
  Iterator begin() const { return Iterator(all_.data()); }
  Iterator end() const { return Iterator(all_.data() + all_.size()); }
  std::size_t size() const { return all_.size(); }
  bool empty() const { return all_.empty(); }
  /// The reading of sensor i, counted from 0; throws std::out_of_range when there are fewer.
  Sensed<Reading> operator[](std::size_t i) const {
    if (i >= all_.size()) [[unlikely]] {
      detail::no_such_reading(Reading::kind, i, all_.size());
    }
    return Sensed<Reading>(all_[i]);
  }

 private:
  std::span<const SensedReading> all_;
};

/// Everything that a behaviour or a coordinator gets at one instant, and nothing else: no world, no
/// other behaviour. It is a view of the simulator's memory, valid only during the call. Making and
/// reading one allocates nothing.
class Perception {
 public:
  /// The memory behind a perception. The simulator fills it; so does a test that gives a behaviour
  /// made-up readings.
  struct Data {
    double time_s = 0.0;
    double period_s = 0.01;
    std::span<const ReadingGroup> groups;
    const OwnState* self = nullptr;
    const TeamState* team = nullptr;
    std::span<const Event> events;
    std::span<const HeardMessage> heard{};
    std::vector<ReadingKind>* listened = nullptr;  // tests: kinds of messages that were asked for
  };

  Perception(const Data& data, Random& random) : data_(&data), random_(&random) {}

  /// Simulated time since the start of the run.
  double time_s() const { return data_->time_s; }
  /// The control period: the time from one decision to the next, s.
  double period_s() const { return data_->period_s; }
  /// The readings of one kind, e.g. `readings<elsie::RangeReading>()`; empty when no sensor
  /// produces them. Throws base::Error when a sensor produces others of the same name.
  template <class Reading>
  Readings<Reading> readings() const {
    const ReadingKind& wanted = ReadingKind::of<Reading>();
    for (const ReadingGroup& group : data_->groups) {
      if (!group.kind.has_name_of(wanted)) continue;
      if (!group.kind.has_layout_of(wanted)) [[unlikely]] {
        detail::other_layout(wanted, group);
      }
      return Readings<Reading>(group.readings);
    }
    return {};
  }
  /// All readings, for plugins that find a number by the names of a sensor and of a field.
  std::span<const ReadingGroup> all_readings() const { return data_->groups; }
  /// All messages that its actuators hear in this control period, of any type.
  std::span<const HeardMessage> all_heard() const { return data_->heard; }
  /// The messages of this type that its actuators hear in this control period.
  template <class Content>
  HeardMessages<Content> heard() const {
    if (data_->listened) data_->listened->push_back(ReadingKind::of<Content>());
    return HeardMessages<Content>(data_->heard);
  }
  const OwnState& self() const { return *data_->self; }
  const TeamState& team() const { return *data_->team; }
  /// The events that behaviours and the simulator raised on this robot in the last control period.
  std::span<const Event> events() const { return data_->events; }
  /// The stream of the behaviour (or coordinator) that is being asked.
  Random& random() const { return *random_; }

  /// The same perception with another stream: each behaviour draws from its own.
  Perception with_random(Random& random) const { return {*data_, random}; }

 private:
  const Data* data_;
  Random* random_;
};

}  // namespace elsie
