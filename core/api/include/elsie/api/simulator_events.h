// The events that the simulator raises.
//
// Each is a struct with its name, its meaning and the content of its detail. To add an event, add a
// struct here and to AnyEvent; results, recordings, `elsie describe events` and the checker of
// plugins follow from that.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace elsie::events {

/// Facts about all events of one name.
struct Facts {
  std::string_view name;
  std::string_view meaning;
  std::string_view detail{};  // the content of its detail; "": no detail
  bool is_perceived = true;   // by the robot's behaviours, in the next control period
  bool is_warning = false;    // viewers of recordings show a warning
};

struct Collision {
  static constexpr Facts kFacts{
      .name = "collision",
      .meaning =
          "the robot touches something that it may not collect; a touch counts again after "
          "0.2 s without contact",
      .detail = "`wall`, `charger`, or the id of the box or robot",
      .is_warning = true};
  enum class With { wall, charger, box, robot };
  With with = With::wall;
  std::string id{};  // of the box or robot
  std::string detail() const;
};

struct Collected {
  static constexpr Facts kFacts{.name = "collected",
                                .meaning = "the robot collects a resource",
                                .detail = "the id of the resource"};
  std::string resource;
  const std::string& detail() const { return resource; }
};

struct Taken {
  static constexpr Facts kFacts{.name = "taken",
                                .meaning = "the robot takes hold of something",
                                .detail = "the id of the box or resource"};
  std::string thing;
  const std::string& detail() const { return thing; }
};

struct Released {
  static constexpr Facts kFacts{.name = "released",
                                .meaning = "the robot lets go of something",
                                .detail = "the id of the box or resource"};
  std::string thing;
  const std::string& detail() const { return thing; }
};

struct Delivered {
  static constexpr Facts kFacts{
      .name = "delivered",
      .meaning = "a resource that the robot lets go of is in a nest of its team, and is collected",
      .detail = "the id of the resource"};
  std::string resource;
  const std::string& detail() const { return resource; }
};

struct BatteryEmpty {
  static constexpr Facts kFacts{.name = "battery_empty",
                                .meaning = "the battery is empty, and the robot stops",
                                .is_warning = true};
};

struct ChargingStarted {
  static constexpr Facts kFacts{
      .name = "charging_started",
      .meaning = "a charger begins to charge the robot, as a behaviour asked"};
};

struct ChargingEnded {
  static constexpr Facts kFacts{
      .name = "charging_ended",
      .meaning = "charging ends: the battery is full, or the robot has left the charger"};
};

struct Changed {
  static constexpr Facts kFacts{
      .name = "changed",
      .meaning = "a user or a rule edits the robot or, without one, the world",
      .detail =
          "the edit: `robot[r1]/@max_speed=0.3`; of a rule with "
          "`, by the rule 'NAME'`",
      .is_perceived = false};
  std::string element;    // "robot[r1]/sensor[left]"
  std::string attribute;  // "": the element as a whole
  std::string value;
  std::string rule{};  // that makes it; "": a user does
  std::string detail() const;
  /// The edit that sets what a path leads to: "robot[r1]/@max_speed", "robot[r1]/coordinator".
  static Changed of(const std::string& path, std::string value);
  /// Returns whether it moves the robot to another place.
  bool moves_robot() const {
    return element.find('/') == std::string::npos &&
           (attribute.empty() || attribute == "x" || attribute == "y");
  }
};

struct Replaced {
  static constexpr Facts kFacts{
      .name = "replaced",
      .meaning = "an object of the robot is replaced by one of a renewed plugin",
      .detail = "its path on the robot, and its plugin: `behavior[roam]: wander`",
      .is_perceived = false};
  std::string path;
  std::string plugin;
  std::string detail() const { return path + ": " + plugin; }
};

/// An event of a plugin, which declares it with elsie::raises().
struct Raised {
  std::string name;
};

using AnyEvent = std::variant<Raised, Collision, Collected, Taken, Released, Delivered,
                              BatteryEmpty, ChargingStarted, ChargingEnded, Changed, Replaced>;

std::string_view name_of(const AnyEvent& event);
/// The detail of an event; empty for an event without one.
std::string detail_of(const AnyEvent& event);
/// The facts about an event of the simulator; null for an event of a plugin.
const Facts* facts_of(const AnyEvent& event);

/// All events of the simulator, in the order of AnyEvent.
std::span<const Facts> of_simulator();
/// The facts about the event with this name, or null.
const Facts* find(std::string_view name);

}  // namespace elsie::events
