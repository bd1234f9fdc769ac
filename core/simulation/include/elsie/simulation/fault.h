// Errors that end a simulation early: a failure of a plugin or of the physics.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "elsie/base/error.h"
#include "elsie/base/number_text.h"

namespace elsie::simulation {

/// A plugin threw, answered with a value that is not finite, or exceeded a budget. what() is a
/// sentence that names the plugin, the robot and the step with its time. Recordings up to this step
/// are valid.
class PluginFault : public base::Error {
 public:
  /// `at_id`: the plugin's id on the robot, or its name if the world file gives no id. `on_robot`:
  /// "" for a measure or a rule, which belong to the world. `thrown_at`: the place in the plugin's
  /// source that threw; "" if it is not known.
  PluginFault(std::string faulty_plugin, std::string at_id, std::string on_robot,
              std::uint64_t at_step, double at_time_s, const std::string& problem,
              std::string thrown_at = "")
      : Error("plugin '" + faulty_plugin + "'" +
                  (at_id == faulty_plugin ? "" : " (id '" + at_id + "')") +
                  (on_robot.empty() ? " of the world" : " of robot '" + on_robot + "'") +
                  " failed in " + base::step_text(at_step, at_time_s) + ": " + problem,
              base::kPluginFailed),
        plugin(std::move(faulty_plugin)),
        id(std::move(at_id)),
        robot(std::move(on_robot)),
        step(at_step),
        place(std::move(thrown_at)) {}

  /// With the place in a line of its own, if it is known.
  std::string message() const override {
    return Error::message() + (place.empty() ? "" : "\nthe plugin's own line: " + place);
  }

  std::string plugin;
  std::string id;
  std::string robot;  // "": a measure or a rule failed
  std::uint64_t step;
  std::string place;  // "respond() at brake.cpp:12", or ""
};

/// The physics lost a body: its state is not finite, or it is at a place that nothing in the world
/// could have moved it to. what() is a sentence that names the body, the time and the likely cause.
/// Recordings up to this step are valid.
class PhysicsFault : public base::Error {
 public:
  PhysicsFault(std::string of_robot, std::uint64_t at_step, const std::string& sentence)
      : Error(sentence), robot(std::move(of_robot)), step(at_step) {}

  std::string robot;  // "": an obstacle, or no known body
  std::uint64_t step;
};

}  // namespace elsie::simulation
