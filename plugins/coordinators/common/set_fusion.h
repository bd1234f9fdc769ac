// Command fusion on fuzzy sets: the behaviours hand over their wishes for each wheel as sets, the
// sets are put together, and only what comes out of that is made a number.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <elsie/api/coordinator.h>

#include "set_operations.h"
#include "weighing.h"

// The facts of the parameters that both plugins declare.
elsie::ParameterFacts combination_facts();
elsie::ParameterFacts weighting_facts();
elsie::ParameterFacts defuzzification_facts();
elsie::ParameterFacts conflict_facts();

/// What fusion_fuzzy and fusion_context_blending have in common, once the weights are known.
class SetFusion : public elsie::Coordinator {
 public:
  // Parameters.
  std::string combination = "max";
  std::string weighting = "scale";
  std::string defuzzification = "centre_of_gravity";
  std::string conflict = "stop";
  std::string activation = "scale";

  void configured() override;
  /// The members' ratings, put together by the same operator as their sets.
  void rate(std::span<elsie::Member> members, const elsie::MotorCommand& given,
            std::span<const elsie::MotorCommand> candidates,
            std::span<double> desirability) override;
  /// What the command was made from.
  elsie::CommandSets command_sets(std::span<elsie::Member> members,
                                  const elsie::MotorCommand& given) override;

 protected:
  SetFusion(const char* default_weighting, const char* default_activation)
      : weighting(default_weighting), activation(default_activation) {}

  /// The command of the members whose weights, in [0, 1], are in their traces.
  elsie::MotorCommand fuse(std::span<elsie::Member> members);
  /// What the parameter `activation` says.
  ActivationRule activation_rule() const { return activation_rule_; }

 private:
  enum class Defuzzifier { centre_of_gravity, mean_of_maximum, bisector, centre_of_largest_area };

  void collect(std::span<elsie::Member> members);
  void combine(std::span<const elsie::Member> members, SetOperator by);
  std::optional<elsie::MotorCommand> settle() const;
  std::optional<elsie::MotorCommand> centre_of_largest_area() const;
  void trace(std::span<elsie::Member> members, const elsie::MotorCommand& command) const;

  SetOperator operator_ = SetOperator::maximum;
  Defuzzifier defuzzifier_ = Defuzzifier::centre_of_gravity;
  bool clip_ = false;
  ActivationRule activation_rule_ = ActivationRule::scale;

  // Of the last decision:
  std::vector<elsie::CommandSets> wishes_;    // of each member; empty sets where it does not count
  std::vector<elsie::CommandSets> weighted_;  // the same, weighted
  elsie::CommandSets together_;
  SetOperator used_ = SetOperator::maximum;
  std::vector<double> ratings_;
};
