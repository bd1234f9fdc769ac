// The weights of behaviours that decide together.
#pragma once

#include <span>
#include <string>

#include <elsie/api/coordinator.h>

/// The effect of a behaviour's activation on its weight.
enum class ActivationRule {
  scale,   // the weight is multiplied by the activation
  gate,    // inactive behaviours have no weight, others their full weight
  ignore,  // no effect
};

/// The parameter `activation` of such a coordinator: its facts, and the rule of a value.
elsie::ParameterFacts activation_facts();
ActivationRule activation_rule_of(const std::string& name);

/// The factor of the weight for an activation.
double factor_of(ActivationRule rule, double activation);

/// Asks every member of positive priority and writes its weight in [0, 1] to its trace: its
/// priority relative to the highest one, times the factor for its activation. Members of priority
/// zero or less do not count and are not asked. Members that count get `reason`, the others a
/// reason of their own. `contexts`, if given, has a further factor in [0, 1] for each member; at
/// zero it is not asked. Returns the sum of the weights.
double weigh(std::span<elsie::Member> members, ActivationRule rule, const char* reason,
             std::span<const double> contexts = {});

/// Divides each member's share by the sum of all shares; if that is zero, uses the weights (without
/// signs) instead.
void normalize_shares(std::span<elsie::Member> members);
