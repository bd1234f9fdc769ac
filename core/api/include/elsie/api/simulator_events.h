// The events that the simulator raises.
//
// Each is a struct that says its name, its meaning and what its detail holds. A new one is a struct
// here with a place in AnyEvent; results, recordings, `elsie describe events` and the checker of
// plugins follow from that.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace elsie::events {

/// What all events of one name have in common.
struct Facts {
  std::string_view name;
  std::string_view meaning;
  std::string_view detail{};  // what its detail holds; "": it has none
  bool is_perceived = true;   // by the robot's behaviours, in the next control period
  bool is_warning = false;    // viewers of recordings show it as one
};

struct Collision {
  static constexpr Facts kFacts{
      .name = "collision",
      .meaning =
          "the robot touches something that it may not collect; a touch counts anew after "
          "0.2 s apart",
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
  static constexpr Facts kFacts{.name = "changed",
                                .meaning = "a user edits the robot or, without one, the world",
                                .detail = "the edit: `robot[r1]/@max_speed=0.3`",
                                .is_perceived = false};
  std::string element;    // "robot[r1]/sensor[left]"
  std::string attribute;  // "": the element as a whole
  std::string value;
  std::string detail() const;
  /// The event of this detail; none if it is no such detail.
  static std::optional<Changed> from(std::string_view detail);
  /// Whether it puts the robot at another place.
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

using AnyEvent = std::variant<Raised, Collision, Collected, BatteryEmpty, ChargingStarted,
                              ChargingEnded, Changed, Replaced>;

std::string_view name_of(const AnyEvent& event);
/// Empty for an event without a detail.
std::string detail_of(const AnyEvent& event);
/// Of an event of the simulator; null for one of a plugin.
const Facts* facts_of(const AnyEvent& event);

/// All events of the simulator, in the order of AnyEvent.
std::span<const Facts> of_simulator();
/// The one of this name, or null.
const Facts* find(std::string_view name);

}  // namespace elsie::events
