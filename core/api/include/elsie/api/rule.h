// A rule changes a world while it runs: resources come back, a door opens, a referee ends the run.
//
// It belongs to the world, in its <rules>, and sees what a measure sees (measure.h). What it
// answers are edits as a user makes them with `elsie run --at`, events, and the end of the run; it
// cannot reach into the simulator in any other way. So a run with rules depends only on the world
// and its seed, like any other: a rule draws random numbers from its own stream, and is part of the
// world. Whoever repeats a run runs its rules again. The edits that they made are in the log of
// events, as `changed` by the rule, and are never made from there.
//
// A run, for a rule:
//
// 1. reset();
// 2. apply(): the world before the first step, at time zero, with the user's edits (is_start);
// 3. apply() after every step, when goals have been judged and measures have observed;
// 4. its edits are made before the next step, after those of the user for that time, together or
//    not at all; those of several rules in the order of the file. One that is refused ends the run
//    as one of the user's does, and names the rule. Events are perceived in the next decision. The
//    end of the run comes at once, unless the goals have decided it in the same step: a failure,
//    of goals or of a rule, counts more than a success, and of rules the first in the file.
//
// A rule lives as long as its element in the world is the same, while robots and boxes come and go,
// also by its own edits. So it keeps ids, not indices and no views of texts.
//
// What edits cost: docs/changing-a-world.md. Placing a robot, a resource or a box that can be
// pushed, energy and parameters of plugins are made in place, and may be frequent. Most others
// build the physics engine again; a rule that does so often slows the run down, and a note says so.
//
// docs/writing-a-rule.md has a complete plugin.
#pragma once

#include <string>
#include <string_view>

#include "elsie/api/component.h"
#include "elsie/api/event.h"
#include "elsie/api/measure.h"
#include "elsie/api/registration.h"

namespace elsie {

/// What a rule answers. Valid during apply().
class WorldChanges {
 public:
  /// Makes an edit before the next step: "robot[r1]/@energy" and "50", or "obstacle[+]" and
  /// "<static_box .../>"; paths are those of `elsie run --at`.
  virtual void edit(std::string path, std::string value) = 0;
  /// Puts "robot[r1]", or "resource[food]" or "obstacle[b1]" if that can be pushed, there at rest.
  /// A resource that was collected comes back. Throws std::invalid_argument if there is none.
  virtual void place(std::string_view what, const Pose& pose) = 0;
  /// Whether place() would find room, as bodies are now and with what rules have placed since;
  /// false if there is no such body (a user may have removed it).
  virtual bool has_room(std::string_view what, const Pose& pose) = 0;
  /// Raises an event that the rule's declaration names (elsie::raises()), for a robot by its id or
  /// for all robots (""). Throws std::invalid_argument for any other event or robot.
  virtual void raise(const Event& event, std::string_view robot = {}) = 0;
  /// Ends the run. `reason`: a clause for the user, "all sheep are in the fold".
  virtual void succeed(std::string reason) = 0;
  virtual void fail(std::string reason) = 0;

  // Edits in other words.

  void set(std::string path, std::string value) { edit(std::move(path), std::move(value)); }
  void set(std::string path, double value);
  /// Adds an element to a list: add("obstacle", "<static_box/>").
  void add(const std::string& list, std::string element) { edit(list + "[+]", std::move(element)); }
  void replace(std::string path, std::string element) { edit(std::move(path), std::move(element)); }
  void remove(const std::string& path) { edit(path + "/@remove", "true"); }

 protected:
  ~WorldChanges() = default;
};

/// See the head of this file.
class Rule : public Component {
 public:
  /// Called after configured(), before the first run, with the world of the file. Throw
  /// (std::invalid_argument, with a sentence) when parameters name something that does not exist.
  virtual void equipped(const Observation& /*start*/) {}

  /// Looks at an instant, and says what shall change.
  virtual void apply(const Observation& now, WorldChanges& world) = 0;
};

/// Makes a rule class a plugin; see ELSIE_BEHAVIOR. An edit of it during a run creates a new
/// object.
#define ELSIE_RULE(Class, ...) ELSIE_REGISTER_PLUGIN_(::elsie::PluginKind::rule, Class, __VA_ARGS__)

}  // namespace elsie
