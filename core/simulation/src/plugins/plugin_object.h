// Plugin objects at run time: sensors, behaviours, coordinators and drives of robots, and measures.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "elsie/api/behavior.h"
#include "elsie/api/declaration.h"
#include "elsie/api/image.h"
#include "elsie/api/remember.h"
#include "elsie/api/sensor.h"
#include "elsie/plugin/host.h"
#include "elsie/world/description.h"

#include "edits/undo.h"
#include "plugins/guard.h"

namespace elsie::simulation {

/// Parameters of an object. All others have their defaults.
struct Setup {
  std::map<std::string, ParameterValue> parameters;
  std::vector<ElementValue> elements;
};

Setup as_described(const world::PluginUse& use);

/// What an object is equipped with: views of its robot.
struct Example {
  Perception perception;
  const std::vector<Colour>& resource_colours;  // see Surroundings
};

/// The memory of an object; empty if its class does not derive from Remembers.
Memory memory_of(Component& object);

/// One plugin object and the simulator's data about it. A crowd has millions of them.
class PluginObject {
 public:
  PluginObject(PluginKind of_kind, const world::PluginUse& described, const plugin::Host& host)
      : kind(of_kind), use(&described), declaration(host.find(of_kind, described.plugin)) {}
  PluginObject(const PluginObject&) = delete;
  PluginObject& operator=(const PluginObject&) = delete;
  virtual ~PluginObject() = default;

  /// Makes and configures the object. If that fails, adds a problem; then there is no object.
  void make(const plugin::Host& host, std::vector<base::Problem>& problems);
  /// Returns another object with these parameters. Passes on exceptions of the plugin.
  plugin::Object<Component> made(const plugin::Host& host, const Setup& setup);

  /// Returns its present parameters.
  Setup setup() const { return as_described(*use); }
  /// Returns `setup` plus the default of every parameter that only `now` sets.
  Setup completed(Setup setup, const Setup& now) const;
  /// Sets the parameters, which its description then gets; the object keeps its memory. Passes on
  /// exceptions of the plugin; the caller must then restore the parameters.
  void set(const Setup& setup, const Example& example);
  /// Tries the parameters on another object of the plugin. Passes on its exceptions. Returns the
  /// camera that a sensor would then have.
  std::optional<Camera> try_out(const Setup& setup, const Example& example) const;

  /// Calls equipped() of this object or of another one of its plugin; see Behavior::equipped().
  /// Passes on exceptions of the plugin.
  virtual void equip(Component& /*object*/, const Example& /*example*/) const {}
  /// Equips the object, which stays, with these parameters or the present ones; it gets the memory.
  void equip_again(const std::optional<Setup>& setup, Memory memory, const Example& example);
  /// The camera of an object of this plugin, if it has one.
  virtual std::optional<Camera> camera_of(const Component& /*object*/) const { return {}; }
  /// Resets the object, with the random stream of this path at its start. Its parameters stay.
  virtual void reset(std::uint64_t seed, const std::string& path);
  /// The same message, which keeps the library of its maker loaded for as long as it is under way.
  using Message = std::shared_ptr<const AnyMessage>;
  Message lasting(const Message& message) const {
    struct Keeping {
      std::shared_ptr<const plugin::Library> library;  // released last
      Message message;
      void operator()(const AnyMessage*) { message.reset(); }
    };
    if (std::get_deleter<Keeping>(message)) return message;  // heard, and said again
    return {message.get(), Keeping{held.get_deleter().library, message}};
  }

  /// Data that few objects have.
  struct Extras {
    std::optional<Camera> camera;    // of a sensor, if it has one
    std::unique_ptr<Image> picture;  // of that camera; null: none was taken
    Heap heap;
  };
  const Extras& extras() const { return extras_ ? *extras_ : kNoExtras; }
  /// The same, to change them.
  Extras& own_extras() { return extras_ ? *extras_ : *(extras_ = std::make_unique<Extras>()); }

  const PluginKind kind;
  bool is_new = true;  // until it is reset
  const world::PluginUse* use;
  const Declaration* declaration;  // null: there is no such plugin
  plugin::Object<Component> held;
  Random random;

 private:
  static inline const Extras kNoExtras{};

  virtual plugin::Object<Component> create(const plugin::Host& host) const = 0;
  virtual Coordination* inside_of_it() { return nullptr; }  // of a behaviour that holds others
  virtual void forget() {}
  void apply(Component& object, const Setup& setup, const Example& example) const;

  std::unique_ptr<Extras> extras_;
};

/// A plugin object of a known class.
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

/// Notes and curves of plugin objects after a reset, for the result of a run.
struct Statements {
  std::vector<Note> notes;
  std::vector<LearningCurve> curves;

  /// Collects those of an object of the guard's robot. `path`: the prefix of the object's id inside
  /// a behaviour, "explore/", else "". Throws PluginFault.
  void ask(const PluginObject& object, const std::string& path, Guard& guard);
  /// The same, of one kind; also of measures, whose curves are asked for at the end of a run.
  void ask_notes(const PluginObject& object, Guard& guard);
  void ask_curves(const PluginObject& object, const std::string& path, Guard& guard);
};

/// Calls `visit` for each number that an object publishes; `within` as in Statements::ask(). Throws
/// PluginFault.
void list_published(const PluginObject& object, const std::string& within, Guard& guard,
                    const VisitPublished& visit);
/// Adds what an object draws in this frame, if it draws anything. Throws PluginFault.
void add_sketch(const PluginObject& object, const std::string& within, const Frame& frame,
                Guard& guard, std::vector<PluginSketch>& sketches);

/// A function called for each of a robot's objects. `path` names the object on the robot:
/// "behavior[explore]/behavior[roam]"; `within` is the prefix of its id: "explore/", or "".
using Visit =
    std::function<void(PluginObject&, const std::string& path, const std::string& within)>;
/// The order of visits: a behaviour before those inside it, or after them.
enum class Order { outer_first, inner_first };

}  // namespace elsie::simulation
