// The dynamic approach (Schoener, Dose and Engels, 1995; Large, Christensen and Bajcsy, 1999): the
// heading phi is the state of a dynamical system. Behaviours put attractors and repellers on the
// circle of headings, and compete by dynamics of their own:
//
//   phi' = sum_i |w_i| f_i(phi)      attractor: f = -lambda sin(phi - psi)
//                                    repeller:  f = lambda d exp(-d^2 / (2 sigma^2)), d = phi - psi
//   tau w_i' = alpha_i (w_i - w_i^3) - sum_{j != i} gamma_ji w_j^2 w_i + noise
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <elsie/api/remember.h>

#include "heading_field.h"
#include "member_names.h"
#include "weighing.h"

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

struct Repeller {
  std::string of;
  double width_deg = 30.0;
  bool opposite = false;
};

struct Competition {
  std::string by;
  std::string of;
  double gamma = 2.0;
};

class FusionAttractorDynamics final : public elsie::Coordinator, public elsie::Remembers {
 public:
  double attraction = 2.0;
  double repulsion = 4.0;
  double horizon = 0.33;
  double speed = 0.0;
  double tau = 0.1;
  double threshold = 0.1;
  double competition = 0.0;
  double least = 0.05;
  double noise = 0.0;
  std::vector<Repeller> repellers;
  std::vector<Competition> competitions;

  void configured() override {
    if (names_.size() > 0) {
      assign();
    }
  }
  void equipped(std::span<const elsie::Member> members, const elsie::Perception&) override {
    names_.read(members);
    neurons_.assign(names_.size(), Neuron{.w = least});
    field_.forcelets.assign(names_.size(), {});
    assign();
  }
  void reset(elsie::Random&) override {
    for (Neuron& neuron : neurons_) {
      neuron.w = least;
    }
    rate_ = slope_ = kNone;
  }
  void remember(elsie::Memory& memory) override {
    for (std::size_t i = 0; i < neurons_.size(); ++i) {
      memory(names_[i], neurons_[i].w);
    }
  }

  elsie::Motion coordinate(std::span<elsie::Member> members,
                           const elsie::Perception& now) override {
    if (members.size() != names_.size()) {
      equipped(members, now);
    }
    ask(members);
    compete(now);
    bool any = false;
    for (std::size_t i = 0; i < members.size(); ++i) {
      field_.forcelets[i].strength = is_on(i) ? neurons_[i].w * neurons_[i].lambda : 0.0;
      any = any || acts(i);
    }
    trace(members);
    rate_ = any ? field_.at(0.0) : kNone;
    slope_ = any ? field_.slope() : kNone;
    const double period_s = now.period_s();
    return any ? elsie::Motion{forward(members), 0.0, field_.turned(period_s) / period_s}
               : elsie::Motion{};
  }

  double rate_ = kNone;   // rad/s, of the heading at the present one
  double slope_ = kNone;  // 1/s, of the field there: negative near an attractor

 private:
  struct Neuron {
    double w = 0.0;      // in [least, 1]: the sign of the paper's w never matters
    double alpha = 0.0;  // its competitive advantage, in [-1, 1]
    double suppression = 0.0;
    double next = 0.0;
    double lambda = 0.0;  // 1/s, of the force of its behaviour at w = 1
    bool opposite = false;
  };

  bool is_on(std::size_t i) const { return neurons_[i].w > least; }
  bool acts(std::size_t i) const { return field_.forcelets[i].strength > 0.0; }
  double pressure(std::size_t by, std::size_t of) const {
    const double w = by != of && is_on(by) ? neurons_[by].w : 0.0;
    return gammas_[of * names_.size() + by] * w * w;
  }

  void assign();
  void ask(std::span<elsie::Member> members);
  void compete(const elsie::Perception& now);
  double forward(std::span<elsie::Member> members) const;
  void trace(std::span<elsie::Member> members) const;

  MemberNames names_;
  std::vector<Neuron> neurons_;
  HeadingField field_;          // a forcelet for each member
  std::vector<double> gammas_;  // row by row: of each member, by all
};

void FusionAttractorDynamics::assign() {
  const std::size_t n = names_.size();
  gammas_.assign(n * n, competition);
  for (std::size_t i = 0; i < n; ++i) {
    field_.forcelets[i].repels = neurons_[i].opposite = false;
  }
  for (const Repeller& repeller : repellers) {
    if (const auto of = names_.find("repeller", "of", repeller.of)) {
      Forcelet& forcelet = field_.forcelets[*of];
      if (forcelet.repels) {
        names_.refuse(MemberNames::text("repeller", "of", repeller.of) +
                      " is given twice; remove one");
      }
      forcelet.repels = true;
      forcelet.sigma = elsie::radians(repeller.width_deg);
      neurons_[*of].opposite = repeller.opposite;
    }
  }
  for (const Competition& pair : competitions) {
    const auto by = names_.find("competition", "by", pair.by);
    const auto of = names_.find("competition", "of", pair.of);
    if (by && of && *by == *of) {
      names_.refuse(MemberNames::text("competition", "by", pair.by) +
                    " has the same behaviour in 'of', and none competes with itself; name two");
    } else if (by && of) {
      gammas_[*of * n + *by] = pair.gamma;
    }
  }
  names_.throw_problems();
}

/// Asks the members: their directions, strengths and advantages.
void FusionAttractorDynamics::ask(std::span<elsie::Member> members) {
  double highest = 0.0;
  for (const elsie::Member& member : members) {
    highest = std::max(highest, member.priority());
  }
  for (std::size_t i = 0; i < members.size(); ++i) {
    Neuron& neuron = neurons_[i];
    neuron.lambda = 0.0;
    neuron.alpha = -1.0;
    if (!(members[i].priority() > 0.0)) {
      continue;
    }
    const elsie::Response& response = members[i].respond();
    const double above = response.activation - threshold;
    neuron.alpha = above / (above > 0.0 ? 1.0 - threshold : threshold);
    const elsie::Motion& wish = response.command;
    const bool moves = wish.forward != 0.0 || wish.lateral != 0.0;
    if (!moves && wish.turn == 0.0) {
      continue;  // a wish to stand has no direction
    }
    // Where it would head after the horizon; no turn leads farther than to what is behind.
    constexpr double kBehind = elsie::radians(179.0);
    Forcelet& forcelet = field_.forcelets[i];
    forcelet.psi = elsie::wrap_angle((moves ? std::atan2(wish.lateral, wish.forward) : 0.0) +
                                     std::clamp(wish.turn * horizon, -kBehind, kBehind) +
                                     (neuron.opposite ? elsie::radians(180.0) : 0.0));
    neuron.lambda = (forcelet.repels ? repulsion : attraction) * response.activation *
                    response.strength * (members[i].priority() / highest);
  }
}

/// Integrates the neurons over the control period. In each small step the suppression c by others
/// is constant, and w' = (alpha - c) w - alpha w^3 has a closed solution.
void FusionAttractorDynamics::compete(const elsie::Perception& now) {
  const double steps = std::ceil(20.0 * now.period_s() / tau);
  const double step = now.period_s() / steps / tau;
  const double kick = noise * std::sqrt(now.period_s() / steps);
  for (int k = 0; k < static_cast<int>(steps); ++k) {
    for (std::size_t i = 0; i < neurons_.size(); ++i) {
      Neuron& neuron = neurons_[i];
      neuron.suppression = 0.0;
      for (std::size_t j = 0; j < neurons_.size(); ++j) {
        neuron.suppression += pressure(j, i);
      }
      const double growth = neuron.alpha - neuron.suppression;
      // At w = 1, too, the equation stands still: what is to fade leaves that at once.
      const double w = neuron.alpha < 0.0 ? std::min(neuron.w, 1.0 - least) : neuron.w;
      const double square = w * w;
      const double decay = std::exp(std::min(500.0, -2.0 * growth * step));  // finite
      const double gone = std::abs(growth * step) < 1e-9 ? 2.0 * step : (1.0 - decay) / growth;
      neuron.next = std::sqrt(square / (decay + neuron.alpha * square * gone));
    }
    for (Neuron& neuron : neurons_) {
      const double pushed = kick > 0.0 ? kick * now.random().normal() : 0.0;
      neuron.w = std::clamp(std::abs(neuron.next + pushed), least, 1.0);
    }
  }
}

/// The mean forward speed of what attracts, or the parameter's; less until one of them has won.
double FusionAttractorDynamics::forward(std::span<elsie::Member> members) const {
  double strengths = 0.0, sum = 0.0, most = 0.0;
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (acts(i) && !field_.forcelets[i].repels) {
      strengths += field_.forcelets[i].strength;
      sum += field_.forcelets[i].strength * members[i].respond().command.forward;
      most = std::max(most, neurons_[i].w);
    }
  }
  return strengths > 0.0 ? most * (speed > 0.0 ? speed : std::max(0.0, sum / strengths)) : 0.0;
}

void FusionAttractorDynamics::trace(std::span<elsie::Member> members) const {
  for (std::size_t i = 0; i < members.size(); ++i) {
    const Neuron& neuron = neurons_[i];
    const Forcelet& forcelet = field_.forcelets[i];
    elsie::TraceRow& row = members[i].trace;
    row.weight = acts(i) ? neuron.w : 0.0;
    row.share = forcelet.strength * (forcelet.repels ? forcelet.range(forcelet.psi) : 1.0);
    if (!(members[i].priority() > 0.0)) {
      row.reason = "priority not above zero";
    } else if (!(neuron.alpha > 0.0)) {
      row.reason = acts(i) ? "fading" : "not active";
    } else if (neuron.suppression > neuron.alpha) {
      row.reason = is_on(i) ? "losing" : "suppressed";
      double most = 0.0;
      for (std::size_t j = 0; !is_on(i) && j < members.size(); ++j) {
        if (pressure(j, i) > most) {
          most = pressure(j, i);
          row.inhibited_by = static_cast<int>(j);
        }
      }
    } else if (!acts(i)) {
      row.reason = is_on(i) ? "no direction" : "rising";
    } else {
      row.reason = forcelet.repels ? "repels" : "attracts";
    }
  }
  normalize_shares(members);
}

}  // namespace

ELSIE_COORDINATOR(
    FusionAttractorDynamics, "fusion_attractor_dynamics",
    "Turns the heading by attractors and repellers of behaviours that compete with each other",
    elsie::parameter("attraction", &FusionAttractorDynamics::attraction,
                     {.unit = "1/s", .min = 0, .max = 50, .meaning = "strength of an attractor"}),
    elsie::parameter("repulsion", &FusionAttractorDynamics::repulsion,
                     {.unit = "1/s", .min = 0, .max = 50, .meaning = "strength of a repeller"}),
    elsie::parameter("horizon", &FusionAttractorDynamics::horizon,
                     {.unit = "s",
                      .min = 0,
                      .max = 10,
                      .meaning = "a behaviour's direction is that in which its command would head "
                                 "after this time"}),
    elsie::parameter("speed", &FusionAttractorDynamics::speed,
                     {.unit = "m/s",
                      .min = 0,
                      .max = 10,
                      .meaning = "speed while anything attracts; 0: the mean forward speed of "
                                 "the attracting behaviours' commands"}),
    elsie::parameter(
        "tau", &FusionAttractorDynamics::tau,
        {.unit = "s", .min = 0.01, .max = 100, .meaning = "time constant of the competition"}),
    elsie::parameter("threshold", &FusionAttractorDynamics::threshold,
                     {.min = 0.01,
                      .max = 0.99,
                      .meaning = "a behaviour more active than this has an advantage, and its "
                                 "weight grows; a less active one fades"}),
    elsie::parameter("competition", &FusionAttractorDynamics::competition,
                     {.min = 0,
                      .max = 100,
                      .meaning = "gamma of all pairs without a <competition>: how strongly each "
                                 "suppresses each other one"}),
    elsie::parameter("least", &FusionAttractorDynamics::least,
                     {.above = 0,
                      .max = 0.5,
                      .meaning = "where weights begin, and below which they do not fall, so that a "
                                 "behaviour comes back; it has no force there"}),
    elsie::parameter("noise", &FusionAttractorDynamics::noise,
                     {.min = 0,
                      .max = 10,
                      .meaning = "standard deviation of the random change of a weight in a second; "
                                 "lets one of two equals win"}),
    elsie::elements(
        &FusionAttractorDynamics::repellers,
        elsie::element<Repeller>(
            "repeller", "the direction that this behaviour wishes repels",
            elsie::parameter("of", &Repeller::of,
                             {.meaning = "the behaviour's id", .required = true}),
            elsie::parameter("width_deg", &Repeller::width_deg,
                             {.unit = "deg",
                              .min = 1,
                              .max = 180,
                              .meaning = "sigma, the range of the repulsion"}),
            elsie::parameter("opposite", &Repeller::opposite,
                             {.meaning = "whether the direction opposite to its wish repels, as "
                                         "for a behaviour that turns away"}))),
    elsie::elements(
        &FusionAttractorDynamics::competitions,
        elsie::element<Competition>(
            "competition", "how strongly behaviour 'by' suppresses behaviour 'of'",
            elsie::parameter("by", &Competition::by,
                             {.meaning = "the id of the one that suppresses", .required = true}),
            elsie::parameter("of", &Competition::of,
                             {.meaning = "the id of the one that is suppressed", .required = true}),
            elsie::parameter("gamma", &Competition::gamma,
                             {.min = 0,
                              .max = 100,
                              .meaning = "compared with the advantage of the other, which is up "
                                         "to 1"}))),
    elsie::publishes("rate", &FusionAttractorDynamics::rate_,
                     {.unit = "rad/s",
                      .meaning = "of the heading, by the field; none: nothing acts"}),
    elsie::publishes("slope", &FusionAttractorDynamics::slope_,
                     {.unit = "1/s",
                      .meaning = "of the field at the heading: negative near an attractor, "
                                 "positive near a repeller"}));
