// The border between the simulator and the plugins of one robot.
#pragma once

#include <cstdint>
#include <exception>
#include <optional>
#include <string>
#include <vector>

#include "elsie/plugin/error.h"
#include "elsie/simulation/fault.h"
#include "elsie/world/description.h"
#include "elsie/world/error.h"

namespace elsie::simulation {

/// Runs code of a robot's plugins while the simulation runs: whatever it throws becomes a
/// PluginFault that names the plugin, the robot and the step. The first fault is kept: a
/// coordinator may swallow what a behaviour threw, but the run does not.
class Guard {
 public:
  explicit Guard(std::string robot) : robot_(std::move(robot)) {}

  template <class Action>
  decltype(auto) run(const world::PluginUse& use, Action action) {
    try {
      return action();
    } catch (const PluginFault&) {
      throw;  // of another plugin, which this one had called
    } catch (const std::exception& problem) {
      fail(use, problem.what());
    } catch (...) {
      fail(use, "it threw something that is no std::exception");
    }
  }

  [[noreturn]] void fail(const world::PluginUse& use, const std::string& problem) {
    if (!fault_) {
      fault_.emplace(use.plugin, use.id, robot_, step_, problem);
    }
    throw *fault_;
  }

  /// Throws the fault, if there was one.
  void check() const {
    if (fault_) {
      throw *fault_;
    }
  }

  void begin_run() { fault_.reset(); }
  void begin_step(std::uint64_t step) { step_ = step; }

 private:
  std::string robot_;
  std::uint64_t step_ = 0;
  std::optional<PluginFault> fault_;
};

/// While a robot is put together, what a plugin object refuses is a fault of the world file: it is
/// added to `problems`, and the result is an empty one.
template <class Action>
auto blaming(const world::PluginUse& use, std::vector<world::Problem>& problems, Action action)
    -> decltype(action()) {
  const auto blame = [&](const std::string& problem) {
    problems.push_back(
        {use.location.file, use.location.line, "plugin '" + use.plugin + "': " + problem});
  };
  try {
    return action();
  } catch (const plugin::PluginError& problem) {  // which names the plugin
    problems.push_back({use.location.file, use.location.line, problem.what()});
  } catch (const std::exception& problem) {
    blame(problem.what());
  } catch (...) {
    blame("it threw something that is no std::exception");
  }
  return decltype(action())();
}

}  // namespace elsie::simulation
