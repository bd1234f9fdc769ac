// How much each behaviour counts where several decide together.
#pragma once

#include <span>
#include <string>

#include <elsie/api/coordinator.h>

/// What a behaviour's activation does to its weight.
enum class ActivationRule {
  scale,   // the weight counts as many times as the behaviour is active
  gate,    // a behaviour that is not active counts nothing, all others their full weight
  ignore,  // nothing
};

/// The parameter `activation` of such a coordinator: its facts, and what a value of it means.
elsie::ParameterFacts activation_facts();
ActivationRule activation_rule_of(const std::string& name);

/// What the rule makes of an activation: the factor of the weight.
double factor_of(ActivationRule rule, double activation);

/// Asks every member of positive priority and notes its weight in its trace, in [0, 1]: its
/// priority as a fraction of the highest one, times what the rule makes of its activation. A member
/// of priority zero or less does not count and is not asked. Those that count get `reason`, the
/// others one of their own. `contexts`, if given, has a further factor for each member, in [0, 1]:
/// how far it applies now; at zero it is not asked. Returns the sum of the weights.
double weigh(std::span<elsie::Member> members, ActivationRule rule, const char* reason,
             std::span<const double> contexts = {});

/// Makes each member's share its part in the sum of all shares; where that sum is zero, its part in
/// the sum of the weights (without signs).
void normalize_shares(std::span<elsie::Member> members);
