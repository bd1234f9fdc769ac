// Plugin objects at run time: sensors, behaviours, coordinators and drives of robots, and measures.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "elsie/api/behavior.h"
#include "elsie/api/declaration.h"
#include "elsie/api/image.h"
#include "elsie/api/remember.h"
#include "elsie/plugin/host.h"
#include "elsie/world/description.h"

#include "changes/undo.h"
#include "plugins/guard.h"

namespace elsie::simulation {

/// What the world says of an object's parameters, or what was said since. All others have their
/// defaults.
struct Setup {
  std::map<std::string, ParameterValue> parameters;
  std::vector<ElementValue> elements;
};

Setup as_described(const world::PluginUse& use);

/// What an object remembers of the run; nothing if its class does not derive from Remembers.
Memory memory_of(Component& object);

/// One plugin object, and what the simulator keeps of it.
class PluginObject {
 public:
  PluginObject(PluginKind of_kind, const world::PluginUse& described, const plugin::Host& host)
      : kind(of_kind), use(&described), declaration(host.find(of_kind, described.plugin)) {}
  PluginObject(const PluginObject&) = delete;
  PluginObject& operator=(const PluginObject&) = delete;
  virtual ~PluginObject() = default;

  /// Makes and configures the object. There is none, and a problem more, when that fails.
  void make(const plugin::Host& host, std::vector<base::Problem>& problems);
  /// The same for another object, with these parameters. Throws what the plugin throws.
  plugin::Object<Component> made(const plugin::Host& host, const Setup& setup);

  /// Returns its present parameters.
  Setup setup() const { return changed ? *changed : as_described(*use); }
  /// Returns `setup` plus the default of every parameter that only `now` sets.
  Setup completed(Setup setup, const Setup& now) const;
  /// Sets the parameters, and keeps what the object remembers. Throws what the plugin throws; they
  /// must be set back then.
  void set(Setup setup, const Perception& example);
  /// Has another object of the plugin take the parameters. Throws what that throws. Of a sensor:
  /// the camera that it would look through.
  std::optional<Camera> try_out(const Setup& setup, const Perception& example) const;

  /// Tells an object of this plugin, this one or another, what the robot has; see
  /// Behavior::equipped(). Throws what the plugin throws.
  virtual void equip(Component& /*object*/, const Perception& /*example*/) const {}
  /// The camera that an object of this plugin looks through, if it does.
  virtual std::optional<Camera> camera_of(const Component& /*object*/) const { return {}; }
  /// Resets the object, with the random stream of this path from its start.
  void reset(std::uint64_t seed, const std::string& path);
  /// Clears the last answer of an object that was replaced.
  virtual void forget_answers(Undo& /*undo*/) {}

  const PluginKind kind;
  const world::PluginUse* use;
  const Declaration* declaration;  // null: there is no such plugin
  plugin::Object<Component> held;
  Random random;
  std::optional<Setup> changed;  // its parameters, if they are not as the world says
  std::optional<Camera> camera;  // that it looks through
  Heap heap;
  bool is_new = true;  // until it is reset

 private:
  virtual plugin::Object<Component> create(const plugin::Host& host) const = 0;
  virtual Coordination* inside_of_it() { return nullptr; }  // of a behaviour that holds others
  virtual void forget() {}
  void apply(Component& object, const Setup& setup, const Perception& example) const;
};

/// One whose class is known.
template <class Kind, PluginKind kKind>
class ObjectOf : public PluginObject {
 public:
  ObjectOf(const world::PluginUse& described, const plugin::Host& host)
      : PluginObject(kKind, described, host) {}

  Kind& object() const { return static_cast<Kind&>(*held); }

 private:
  plugin::Object<Component> create(const plugin::Host& host) const override {
    return host.create<Kind>(kKind, use->plugin);
  }
};

/// What plugin objects say once they are reset, gathered for the result of a run.
struct Statements {
  std::vector<Note> notes;
  std::vector<LearningCurve> curves;

  /// Asks an object of the guard's robot, or a measure. `path`: what stands before the object's id
  /// where it is inside a behaviour, "explore/", else "". Throws PluginFault.
  void ask(const PluginObject& object, const std::string& path, Guard& guard);
};

/// What is done to each of a robot's objects. `path` names it on the robot:
/// "behavior[explore]/behavior[roam]"; `within` says what it is inside of: "explore/", or "".
using Visit =
    std::function<void(PluginObject&, const std::string& path, const std::string& within)>;
/// Whether a behaviour comes before those inside it, or after them.
enum class Order { outer_first, inner_first };

}  // namespace elsie::simulation
