// What a robot of an environment does: numbers of an array in [-1, 1] as a motion, as commands to
// actuators, as priorities of the robot's own behaviours, as live parameters.
//
//   prepare(world, host, 0, names);                  // `commanded` in place of its behaviours
//   Acting hands(simulation, host, 0, names);
//   hands.apply(simulation, row);
//
// Actions are edits of the world. Motions, commands and priorities are set without the work of an
// edit, with the same effect, unless `by_edits`; edits() gives those that repeat them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "elsie/api/component.h"
#include "elsie/api/declaration.h"
#include "elsie/plugin/host.h"
#include "elsie/simulation/simulation.h"

#include "declared.h"

namespace elsie::python {

/// Whether the actions are motions or commands: then `commanded` replaces the robot's behaviours
/// and its coordinator. Throws base::BadInput for names that exclude each other.
void prepare(world::World& world, const plugin::Host& host, std::size_t robot,
             const std::vector<Named>& names);

class Acting {
 public:
  /// Throws base::BadInput with a sentence for a name that this robot does not have. `by_edits`:
  /// the world has rules, whose edits would undo what is set without one.
  Acting(simulation::Simulation& simulation, const plugin::Host& host, std::size_t robot,
         const std::vector<Named>& names, bool by_edits);

  const std::vector<Bounded>& numbers() const { return numbers_; }
  /// Replaces the bounds; there are as many.
  void take(const std::vector<Bounded>& numbers);
  void apply(simulation::Simulation& simulation, const float* actions) const;
  /// To be called after Simulation::reset(), which forgets edits and priorities: forgets the motion
  /// and the commands.
  void forget() const;
  /// The edits of an action: those that change what `before` has, which then has the new values.
  /// It is empty before the first action.
  void add_edits(const float* actions, std::vector<double>& before,
                 std::vector<simulation::Edit>& edits) const;

 private:
  enum class Kind : std::uint8_t { motion, command, priority, parameter };
  struct Number {
    Kind kind;
    std::size_t index = 0;  // of the parameter of a motion, of a command, of a behaviour's trace
    std::string path{};     // of the edit
    double middle = 0.0, half = 1.0;
    bool is_switch = false;  // true above 0

    double value(float action) const;
  };

  bool add_motion(const simulation::Simulation& simulation, const Named& named);
  bool add_commands(const simulation::Simulation& simulation, const Named& named);
  bool add_priorities(const simulation::Simulation& simulation, const Named& named);
  bool add_parameters(const simulation::Simulation& simulation, const plugin::Host& host,
                      const Named& named);
  void add(Number number, Bounded bounds, const Named& named);
  void find_commanded(simulation::Simulation& simulation, const plugin::Host& host);
  [[noreturn]] void refuse(const simulation::Simulation& simulation, const Named& named) const;

  std::size_t robot_;
  bool by_edits_;
  std::string behaviors_;  // "robot[r1]/behavior[": the beginning of paths
  std::vector<Bounded> numbers_;
  std::vector<Number> actions_;
  std::size_t commands_ = 0;
  bool has_parameters_ = false;
  Component* commanded_ = nullptr;
  std::vector<const ParameterDeclaration*> motion_;
  const ParameterDeclaration* values_ = nullptr;
};

}  // namespace elsie::python
