// A plugin that failed while a simulation ran.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace elsie::simulation {

/// A plugin threw, or answered with something that is not a number. what() is a sentence that names
/// the plugin, the robot and the step. What was recorded until then is valid.
class PluginFault : public std::runtime_error {
 public:
  PluginFault(std::string faulty_plugin, std::string on_robot, std::uint64_t at_step,
              const std::string& problem)
      : std::runtime_error("plugin '" + faulty_plugin + "' of robot '" + on_robot +
                           "' failed in step " + std::to_string(at_step) + ": " + problem),
        plugin(std::move(faulty_plugin)),
        robot(std::move(on_robot)),
        step(at_step) {}

  std::string plugin;
  std::string robot;
  std::uint64_t step;
};

}  // namespace elsie::simulation
