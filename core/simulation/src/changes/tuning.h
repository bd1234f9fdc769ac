// Parameters of plugin objects that change while they run.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "elsie/api/coordinator.h"
#include "elsie/api/declaration.h"
#include "elsie/api/image.h"
#include "elsie/api/sensor.h"
#include "elsie/world/description.h"

namespace elsie::simulation {

/// What the world says of an object's parameters, or what was said since. All others have their
/// defaults.
struct Setup {
  std::map<std::string, ParameterValue> parameters;
  std::vector<ElementValue> elements;
};

Setup as_described(const world::PluginUse& use);

/// A plugin object of a robot, and what it takes to set its parameters.
struct TunedObject {
  PluginKind kind = PluginKind::behavior;
  const world::PluginUse* use = nullptr;
  const Declaration* declaration = nullptr;
  Component* object = nullptr;
  std::span<const Member> members;  // of a coordinator
  Carrier carrier{};                // of a sensor
};

/// Which objects of a robot have other parameters than the world says.
class Tuning {
 public:
  /// What the object's parameters are.
  Setup setup(const world::PluginUse& use) const;

  bool is_changed(const world::PluginUse& use) const;

  /// Tells a behaviour or coordinator what the robot has; see Behavior::equipped(). `object`: that
  /// of `tuned` or another one of the same plugin. Throws what the plugin throws.
  static void equip(const TunedObject& tuned, Component& object, const Perception& example);

  /// The same with the defaults of what `setup` says nothing of, but `now` does.
  static Setup complete(Setup setup, const Setup& now, const Declaration& declaration);

  /// Has another object of the plugin take the parameters, on this robot (`example`). Throws what
  /// that throws. Of a sensor: the camera that it would look through.
  static std::optional<Camera> try_out(const TunedObject& tuned, const Setup& setup,
                                       const Perception& example);

  /// Sets them, and keeps what the object remembers. Throws what the plugin throws; it must be set
  /// back then.
  void set(const TunedObject& tuned, Setup setup, const Perception& example);

  /// Of one that was changed: these are its parameters now, which it has not been given.
  void take_over(const world::PluginUse& use, Setup setup);

  /// The objects that are not as the world says, in the order in which they were first changed.
  std::vector<const world::PluginUse*> changed() const;
  /// All objects are as the world says now.
  void settle() { changed_.clear(); }
  /// Makes one as the world says. Throws what the plugin throws.
  void forget(const TunedObject& tuned, const Perception& example);

 private:
  std::vector<std::pair<const world::PluginUse*, Setup>> changed_;
};

}  // namespace elsie::simulation
