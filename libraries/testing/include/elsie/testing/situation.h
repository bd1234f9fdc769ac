// What a robot perceives at an instant, put together by hand.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "elsie/api/perception.h"
#include "elsie/base/random.h"
#include "elsie/testing/picture.h"

namespace elsie::testing {

///   Situation now;
///   now.beam(15, 0.2).beam(-15, 1.0).blob(70).at(1, 2, 90).battery(0.1).charger(3, 0);
///
/// A robot that stands at the origin, looks east, is alone, and has no sensors, until it is said
/// otherwise. Angles are in degrees, azimuths counter-clockwise from straight ahead. A copy is a
/// situation of its own.
class Situation {
 public:
  // Sensors, each with what it reads now. Readings of one kind keep their order.

  /// A range sensor that looks this way and reads this distance; nothing is hit at max_range_m.
  Situation& beam(double azimuth_deg, double distance_m, double max_range_m = 1.0);
  Situation& proximity(double azimuth_deg, bool detected, double max_range_m = 0.5);
  /// A camera that sees a blob with its middle at this column, of 100, with pictures to go with it:
  /// a disc of that colour and area.
  Situation& blob(double column, double horizontal_fov_deg = 30.0, double area_px = 100.0,
                  double azimuth_deg = 0.0, const Colour& colour = kRed);
  /// A camera that finds nothing.
  Situation& camera(double horizontal_fov_deg = 30.0, double azimuth_deg = 0.0);
  /// Any reading of a camera.
  Situation& view(const VisionReading& reading, double azimuth_deg = 0.0);
  /// A reading of any kind, also of one that a plugin brings in a header of its own.
  template <class Reading>
  Situation& reading(Reading value, double azimuth_deg = 0.0) {
    return reading(std::move(value), Mounting{{}, radians(azimuth_deg), 0.0});
  }
  template <class Reading>
  Situation& reading(Reading value, const Mounting& mounting, std::string sensor = "") {
    return sensed(ReadingKind::of<Reading>(), std::make_shared<const Reading>(std::move(value)),
                  mounting, std::move(sensor));
  }
  /// Likewise with its type left out. `kind.name` must stay where it is.
  Situation& sensed(const ReadingKind& kind, std::shared_ptr<const void> value,
                    const Mounting& mounting, std::string sensor = "");
  /// Takes all sensors away, so that those of the next instant can be put there.
  Situation& clear_readings();

  // The robot itself. Whatever has no word here is set in `self`.

  Situation& at(double x, double y, double heading_deg);
  /// Measured: along the heading, and turning counter-clockwise; the wheel rates go with it.
  Situation& moving(double speed_m_s, double turn_rate_rad_s = 0.0);
  /// What is left in the battery, as a part of its capacity.
  Situation& battery(double part);
  Situation& charging(bool is_charging = true);

  // Its team.

  /// Another robot of the team, whose coverage reaches this one.
  Situation& mate(const std::string& id, double x, double y, bool is_leader = false,
                  double heading_deg = 0.0, int team_index = 0);
  /// The same for the team's leader.
  Situation& leader(double x, double y, double heading_deg = 0.0);
  Situation& charger(double x, double y);

  // The instant.

  /// Something that was raised on this robot in the last step.
  Situation& event(const std::string& name);
  Situation& time(double time_s);
  /// From one decision to the next.
  Situation& period(double period_s);
  /// Of the stream that perception() hands out. Objects of this library draw from streams of their
  /// own.
  Situation& seed(std::uint64_t seed);

  /// For calling a plugin's object directly. Refers to this situation, and is good until that
  /// changes.
  Perception perception() const;
  double time_s() const { return data_.time_s; }
  double period_s() const { return data_.period_s; }

  OwnState self;
  TeamState team;  // perception() fills in the mates
  mutable Random random{1};

 private:
  struct Entry {
    ReadingKind kind;
    std::shared_ptr<const void> value;
    Mounting mounting;
    std::string sensor;
  };
  struct Mate {
    std::string id;
    Pose pose;
    bool is_leader;
    int team_index;
  };

  std::deque<Entry> entries_;
  std::deque<Mate> mates_;
  std::deque<std::string> events_;
  Perception::Data data_;
  // What perception() refers to, made anew by each call.
  struct Views {
    Views() = default;
    Views(const Views&) {}  // a copy of the situation makes its own
    Views& operator=(const Views&) { return *this; }
    Perception::Data data;
    TeamState team;
    std::vector<SensedReading> sensed;
    std::vector<ReadingGroup> groups;
    std::vector<TeamMate> mates;
    std::vector<Event> events;
  };
  mutable Views views_;
};

}  // namespace elsie::testing
