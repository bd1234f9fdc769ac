#include "weighing.h"

#include <algorithm>
#include <cmath>

elsie::ParameterFacts activation_facts() {
  return {.choices = {"scale", "gate", "ignore"},
          .meaning =
              "what a behaviour's activation does to its weight: 'scale' multiplies, 'gate' "
              "leaves out those that are not active, 'ignore' does nothing"};
}

ActivationRule activation_rule_of(const std::string& name) {
  return name == "gate"     ? ActivationRule::gate
         : name == "ignore" ? ActivationRule::ignore
                            : ActivationRule::scale;
}

double factor_of(ActivationRule rule, double activation) {
  switch (rule) {
    case ActivationRule::scale:
      return activation;
    case ActivationRule::gate:
      return activation > 0.0 ? 1.0 : 0.0;
    case ActivationRule::ignore:
      break;
  }
  return 1.0;
}

double weigh(std::span<elsie::Member> members, ActivationRule rule, const char* reason,
             std::span<const double> contexts) {
  double highest = 0.0;
  for (const elsie::Member& member : members) {
    highest = std::max(highest, member.priority());
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < members.size(); ++i) {
    elsie::Member& member = members[i];
    const double context = contexts.empty() ? 1.0 : contexts[i];
    if (!(member.priority() > 0.0)) {
      member.trace.reason = "priority not above zero";
    } else if (!(context > 0.0)) {
      member.trace.reason = "not in this context";
    } else {
      member.trace.weight =
          context * (member.priority() / highest) * factor_of(rule, member.respond().activation);
      member.trace.reason = member.trace.weight > 0.0 ? reason : "not active";
      sum += member.trace.weight;
    }
  }
  return sum;
}

void normalize_shares(std::span<elsie::Member> members) {
  double shares = 0.0;
  double weights = 0.0;
  for (const elsie::Member& member : members) {
    shares += member.trace.share;
    weights += std::abs(member.trace.weight);
  }
  for (elsie::Member& member : members) {
    if (shares > 0.0 && std::isfinite(shares)) {
      member.trace.share /= shares;
    } else {
      member.trace.share = weights > 0.0 ? std::abs(member.trace.weight) / weights : 0.0;
    }
  }
}
