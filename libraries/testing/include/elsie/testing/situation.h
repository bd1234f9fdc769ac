// A robot's perception at an instant, made up by hand.
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
/// By default a robot at the origin that looks east, is alone, and has no sensors. Angles are in
/// degrees, azimuths counter-clockwise from straight ahead. Copies are independent.
class Situation {
 public:
  // Sensors with their readings. Readings of one kind keep their order.

  /// Adds a range sensor that looks this way and reads this distance; max_range_m is no hit.
  Situation& beam(double azimuth_deg, double distance_m, double max_range_m = 1.0);
  Situation& proximity(double azimuth_deg, bool detected, double max_range_m = 0.5);
  /// Adds a camera that sees a blob with its middle at this column, of 100, with matching pictures:
  /// a disc of that colour and area.
  Situation& blob(double column, double horizontal_fov_deg = 30.0, double area_px = 100.0,
                  double azimuth_deg = 0.0, const Colour& colour = kRed);
  /// Adds a camera that sees nothing.
  Situation& camera(double horizontal_fov_deg = 30.0, double azimuth_deg = 0.0);
  /// Adds a camera with any reading.
  Situation& view(const VisionReading& reading, double azimuth_deg = 0.0);
  /// Adds a reading of any kind, also of one that a plugin defines in its own header.
  template <class Reading>
  Situation& reading(Reading value, double azimuth_deg = 0.0) {
    return reading(std::move(value), Mounting{{}, radians(azimuth_deg), 0.0});
  }
  template <class Reading>
  Situation& reading(Reading value, const Mounting& mounting, const std::string& sensor = "") {
    static const ReadingDeclaration declaration = ReadingDeclaration::of<Reading>();
    return sensed(ReadingKind::of<Reading>(), std::make_shared<const Reading>(std::move(value)),
                  mounting, sensor, &declaration);
  }
  /// The same without its type. `kind.name` and the declaration must remain valid.
  Situation& sensed(const ReadingKind& kind, std::shared_ptr<const void> value,
                    const Mounting& mounting, std::string sensor = "",
                    const ReadingDeclaration* declaration = nullptr);
  /// Removes all sensors, so that those of the next instant can be added.
  Situation& clear_readings();

  // The robot itself. Members without a function here are set in `self`.

  Situation& at(double x, double y, double heading_deg);
  /// Sets the measured motion: along the heading and counter-clockwise.
  Situation& moving(double speed_m_s, double turn_rate_rad_s = 0.0);
  /// Sets the charge of the battery as a share of its capacity.
  Situation& battery(double part);
  Situation& charging(bool is_charging = true);

  // Its team.

  /// Adds a robot of the team whose coverage reaches this one.
  Situation& mate(const std::string& id, double x, double y, bool is_leader = false,
                  double heading_deg = 0.0, int team_index = 0);
  /// Adds the team's leader in the same way.
  Situation& leader(double x, double y, double heading_deg = 0.0);
  Situation& charger(double x, double y);
  Situation& nest(double x, double y, double radius_m = 0.5);

  // The instant.

  /// Adds an event that was raised on this robot in the last step.
  Situation& event(const std::string& name);
  /// Adds a message that the robot hears, from a robot with this id; with range and bearing, from
  /// such a distance and direction.
  template <class Content>
  Situation& hear(Content content, const std::string& from = "", double distance_m = kUnknown,
                  double bearing_deg = kUnknown) {
    return hear(std::make_shared<const AnyMessage>(AnyMessage(std::move(content))), from,
                distance_m, bearing_deg);
  }
  Situation& hear(std::shared_ptr<const AnyMessage> message, const std::string& from,
                  double distance_m, double bearing_deg);
  /// The same with all that a device may tell: hear(Offer{}, {.device = "radio", .age_s = 0.2}).
  template <class Content>
  Situation& hear(Content content, HeardMessage how) {
    how.message = std::make_shared<const AnyMessage>(AnyMessage(std::move(content)));
    return hear(how);
  }
  Situation& hear(const HeardMessage& heard);
  static constexpr double kUnknown = HeardMessage::kUnknown;
  Situation& time(double time_s);
  /// Sets the time between decisions.
  Situation& period(double period_s);
  /// Sets the seed of the stream in perception(). Objects of this library draw from their own
  /// streams.
  Situation& seed(std::uint64_t seed);

  /// The kinds of messages that its perceptions were asked for, each at least once.
  const std::vector<ReadingKind>& listened() const { return views_.listened; }

  /// For calling a plugin's object directly. Refers to this situation, and is valid until that
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
    const ReadingDeclaration* declaration;
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
  struct Said {
    HeardMessage message;
    std::string device, from;
  };
  std::deque<Said> said_;
  Perception::Data data_;
  // The data that perception() refers to, renewed by each call.
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
    std::vector<HeardMessage> heard;
    std::vector<ReadingKind> listened;
  };
  mutable Views views_;
};

}  // namespace elsie::testing
