#include "softness.h"

#include <optional>
#include <string>

#include "elsie/world/facts.h"

namespace elsie::physics {
namespace {

struct Parameters {
  double erp = 0.2;
  double cfm = 1e-5;
  std::optional<double> kp;  // N/m
  std::optional<double> kd;  // N s/m
};

}  // namespace

std::vector<world::AttributeSpec> softness_parameters() {
  using world::positive, world::range;
  const world::ElementSpec described =
      world::Describe<Parameters>("physics", "")
          .costs(world::Cost::engine)
          .attribute(
              "erp", &Parameters::erp,
              positive("", 1, "error reduction of joints and contacts; useful from 0.1 to 0.8"))
          .attribute(
              "cfm", &Parameters::cfm,
              range("", 0, 1,
                    "constraint force mixing: how soft contacts are; only in the engine ode"))
          .attribute("kp", &Parameters::kp,
                     positive("N/m", 1e12, "spring constant, with kd, instead of erp and cfm"))
          .attribute("kd", &Parameters::kd,
                     range("N s/m", 0, 1e12, "damping constant, with kp, instead of erp and cfm"));
  return described.attributes;
}

Softness softness_of(const world::Physics& physics) {
  Parameters all;
  for (const world::AttributeSpec& parameter : softness_parameters()) {
    const auto given = physics.parameters.find(parameter.name);
    if (given != physics.parameters.end()) parameter.set(&all, given->second);
  }
  if (!all.kp || !all.kd) return {all.erp, all.cfm};
  const double h = physics.step, kp = *all.kp, kd = *all.kd;
  return {h * kp / (h * kp + kd), 1.0 / (h * kp + kd), true};
}

void check_softness(const world::Physics& physics, base::Problems& problems) {
  const bool has_kp = physics.parameters.contains("kp"), has_kd = physics.parameters.contains("kd");
  if (has_kp != has_kd) {
    const std::string given = has_kp ? "kp" : "kd", missing = has_kp ? "kd" : "kp";
    problems.add(physics.location, "<physics> has '" + given + "' without '" + missing +
                                       "'; give both, or erp and cfm instead");
  }
  for (const std::string name : {"erp", "cfm"}) {
    if (has_kp && has_kd && physics.parameters.contains(name)) {
      problems.add(physics.location, "<physics> has '" + name +
                                         "' beside kp and kd, from which it follows; take it out");
    }
  }
}

}  // namespace elsie::physics
