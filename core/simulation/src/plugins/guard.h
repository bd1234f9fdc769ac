// The border between the simulator and the plugins of one robot, or the measures of the world.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "elsie/base/thrown.h"
#include "elsie/plugin/call.h"
#include "elsie/plugin/error.h"
#include "elsie/simulation/fault.h"
#include "elsie/simulation/run_result.h"
#include "elsie/simulation/simulation.h"
#include "elsie/world/description.h"
#include "elsie/world/error.h"

namespace elsie::simulation {

/// Returns the result of the action, or an empty value if it returns nothing.
template <class Action>
auto value_of(Action& action) {
  if constexpr (std::is_void_v<decltype(action())>) {
    action();
    return std::monostate();
  } else {
    return action();
  }
}

/// Heap memory that the calls of one object have left allocated since the run began.
struct Heap {
  std::int64_t bytes = 0;
  std::uint64_t calls = 0;
};

/// Runs code of a robot's plugins during a simulation: any exception becomes a PluginFault that
/// names the plugin, the robot and the step. The first fault is kept: it ends the run even if a
/// coordinator catches the exception of a behaviour.
class Guard {
 public:
  /// `robot`: "" for measures.
  Guard(std::string robot, const Budget& budget) : budget_(budget), robot_(std::move(robot)) {}

  /// A call without a budget: before the run, or a rare one.
  template <class Action>
  auto run(const world::PluginUse& use, Action action) {
    plugin::Call call(facts(use));
    return caught(use, call, action);
  }

  /// A call that only shows what an object has. Its fault is for the caller, and not kept: a run
  /// that nobody looks at would not have it.
  template <class Action>
  auto look(const world::PluginUse& use, Action action) {
    try {
      return run(use, action);
    } catch (const PluginFault&) {
      forgive();
      throw;
    }
  }

  /// A call of a PluginObject within a step: the budget applies.
  template <class Object, class Action>
  auto step(Object& object, Action action) {
    plugin::Call call(facts(*object.use));
    if (!has_budget()) [[likely]] {
      return caught(*object.use, call, action);
    }
    Heap& heap = object.own_extras().heap;
    const std::int64_t before = begin(call);
    auto result = caught(*object.use, call, action);
    end(*object.use, heap, call, before);
    return result;
  }

  /// `place`: see PluginFault.
  [[noreturn]] void fail(const world::PluginUse& use, const std::string& problem,
                         const std::string& place = "") {
    if (!fault_) {
      fault_ =
          std::make_unique<PluginFault>(use.plugin, use.id, robot_, step_, time_s_, problem, place);
    }
    throw *fault_;
  }

  /// Throws the fault, if there was one.
  void check() const {
    if (fault_) {
      throw *fault_;
    }
  }

  const std::string& robot() const { return robot_; }
  bool has_budget() const { return budget_.time_s > 0.0 || budget_.memory > 0; }

  void begin_run() {
    fault_.reset();
    arithmetic_.clear();
  }
  void begin_step(std::uint64_t step, double time_s) {
    step_ = step;
    time_s_ = time_s;
  }
  /// Appends a note for each plugin that has changed the floating-point settings in this run.
  void list_notes(std::vector<Note>& notes) const;
  /// Forgets the fault, because what failed is undone.
  void forgive() { fault_.reset(); }

 private:
  /// How often a plugin has changed the floating-point settings.
  struct ChangedArithmetic {
    std::string id;
    std::string what;
    std::string first;  // the step
    std::uint64_t calls = 0;
  };

  plugin::CallFacts facts(const world::PluginUse& use) const {
    return {.plugin = &use.plugin,
            .id = &use.id,
            .robot = robot_.empty() ? nullptr : &robot_,
            .step = step_,
            .time_s = time_s_};
  }

  template <class Action>
  auto caught(const world::PluginUse& use, plugin::Call& call, Action& action) {
    try {
      auto result = value_of(action);
      settle(use, call);
      return result;
    } catch (const PluginFault&) {
      throw;  // from another plugin that this one called
    } catch (const base::Error& error) {
      fail(use, error.what());  // found by Elsie, so that no line of the plugin threw it
    } catch (...) {
      fail(use, base::what_was_thrown(), base::place_of_throw());
    }
  }

  /// Checks after a call whether it changed the process.
  void settle(const world::PluginUse& use, plugin::Call& call) {
    if (const char* const changed = call.end_arithmetic()) [[unlikely]] {
      note_arithmetic(use, changed);
    }
    if (call.has_forked()) [[unlikely]] {
      fail(use,
           "it made a copy of the program with fork(); start other programs with posix_spawn()");
    }
  }
  void note_arithmetic(const world::PluginUse& use, const char* changed);

  std::int64_t begin(plugin::Call& call) const;
  /// Faults the plugin if it went beyond its budget.
  void end(const world::PluginUse& use, Heap& heap, const plugin::Call& call, std::int64_t before);

  Budget budget_;
  std::uint64_t step_ = 0;
  double time_s_ = 0.0;
  std::unique_ptr<PluginFault> fault_;
  std::string robot_;
  std::vector<ChangedArithmetic> arithmetic_;
};

/// While a robot is made, an exception of a plugin object is an error of the world file: it is
/// added to `problems`, and the result is empty.
template <class Action>
auto blaming(const world::PluginUse& use, std::vector<base::Problem>& problems, Action action)
    -> decltype(value_of(action)) {
  const auto blame = [&](const std::string& problem, bool plugin_failed = false) {
    problems.push_back({use.location.file, use.location.line,
                        "plugin '" + use.plugin + "': " + problem, plugin_failed});
  };
  plugin::Call call({.plugin = &use.plugin,
                     .id = &use.id,
                     .file = use.location.file.text().c_str(),
                     .line = use.location.line,
                     .doing = "while it was prepared"});
  try {
    auto result = value_of(action);
    if (const char* const changed = call.restore_arithmetic()) {
      blame(std::string("it changed ") + changed + " for the whole program", true);
    }
    return result;
  } catch (const plugin::PluginError& problem) {  // its text names the plugin
    problems.push_back({use.location.file, use.location.line, problem.what(),
                        problem.exit_code() == base::kPluginFailed});
  } catch (...) {
    blame(base::what_was_thrown());
  }
  return {};
}

}  // namespace elsie::simulation
