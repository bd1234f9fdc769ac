// Command fusion on fuzzy sets. Each behaviour gives its wishes as sets: one for each wheel, and
// one for the lateral speed of drives that have it. The sets are combined, and the result is
// defuzzified last.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <elsie/api/coordinator.h>

#include "set_operations.h"
#include "weighing.h"

// Facts of the parameters that both plugins declare.
elsie::ParameterFacts combination_facts();
elsie::ParameterFacts weighting_facts();
elsie::ParameterFacts defuzzification_facts();
elsie::ParameterFacts conflict_facts();

/// The common base of fusion_fuzzy and fusion_context_blending, which compute the weights.
class SetFusion : public elsie::Coordinator {
 public:
  // Parameters.
  std::string combination = "max";
  std::string weighting = "scale";
  std::string defuzzification = "centre_of_gravity";
  std::string conflict = "stop";
  std::string activation = "scale";

  void configured() override;
  /// The members' ratings, combined by the same operator as their sets.
  void rate(std::span<elsie::Member> members, const elsie::Perception& now,
            const elsie::Motion& given, std::span<const elsie::Motion> candidates,
            std::span<double> desirability) override;
  /// The sets from which the command was computed.
  elsie::CommandSets command_sets(std::span<elsie::Member> members, const elsie::Perception& now,
                                  const elsie::Motion& given) override;

 protected:
  SetFusion(const char* default_weighting, const char* default_activation)
      : weighting(default_weighting), activation(default_activation) {}

  /// The command of members with weights, in [0, 1], in their traces.
  elsie::Motion fuse(std::span<elsie::Member> members, const elsie::Perception& now);
  /// The rule that the parameter `activation` names.
  ActivationRule activation_rule() const { return activation_rule_; }

 private:
  enum class Defuzzifier { centre_of_gravity, mean_of_maximum, bisector, centre_of_largest_area };

  void collect(std::span<elsie::Member> members);
  void combine(std::span<const elsie::Member> members, SetOperator by);
  std::optional<elsie::Motion> settle(const elsie::WheelPair& wheels) const;
  std::optional<elsie::Motion> centre_of_largest_area(const elsie::WheelPair& wheels) const;
  void trace(std::span<elsie::Member> members, const elsie::WheelPair& wheels,
             const elsie::Motion& command) const;

  SetOperator operator_ = SetOperator::maximum;
  Defuzzifier defuzzifier_ = Defuzzifier::centre_of_gravity;
  bool clip_ = false;
  ActivationRule activation_rule_ = ActivationRule::scale;

  // From the last decision:
  std::vector<elsie::CommandSets> wishes_;    // of each member; empty sets if it does not count
  std::vector<elsie::CommandSets> weighted_;  // the same, weighted
  elsie::CommandSets together_;
  SetOperator used_ = SetOperator::maximum;
  std::vector<double> ratings_;
};
