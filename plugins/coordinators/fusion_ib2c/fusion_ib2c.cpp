// The fusion behaviours of iB2C (Proetzsch, Luksch and Berns, 2010): behaviours stimulate and
// inhibit each other, and their activities weigh their commands.
//
//   iota = s (1 - i)     activation, from the stimulation s and the inhibition i
//   a <= iota            activity: the influence of the behaviour
//   r                    target rating: 0 content, 1 not at all; it does not depend on iota
#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <elsie/api/remember.h>

#include "desirability.h"
#include "member_names.h"
#include "signal_links.h"
#include "weighing.h"

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

class FusionIb2c final : public elsie::Coordinator, public elsie::Remembers {
 public:
  std::string fusion = "average";
  std::string rating = "activation";
  std::vector<Link> inhibitions;
  std::vector<Link> stimulations;

  void configured() override {
    rule_ = fusion == "maximum" ? Rule::maximum : fusion == "sum" ? Rule::sum : Rule::average;
    by_strength_ = rating == "strength";
    if (names_.size() > 0) {
      link();
    }
  }
  void equipped(std::span<const elsie::Member> members, const elsie::Perception&) override {
    names_.read(members);
    signals_.assign(names_.size(), {});
    link();
  }
  void reset(elsie::Random&) override {
    std::fill(signals_.begin(), signals_.end(), Signals{});
    activity_ = rating_ = kNone;
  }
  void remember(elsie::Memory& memory) override {
    for (std::size_t i = 0; i < signals_.size(); ++i) {
      memory(names_[i], signals_[i].activity);
    }
  }

  elsie::Motion coordinate(std::span<elsie::Member> members, const elsie::Perception& now) override;

  // Inside a behaviour: the mean of the members' wishes, weighted with their activities.
  void rate(std::span<elsie::Member> members, const elsie::Perception& /*now*/,
            const elsie::Motion& /*given*/, std::span<const elsie::Motion> candidates,
            std::span<double> desirability) override {
    desirability_.rate(members, candidates, desirability);
  }
  elsie::CommandSets command_sets(std::span<elsie::Member> members,
                                  const elsie::Perception& /*now*/,
                                  const elsie::Motion& /*given*/) override {
    return Desirability::sets(members);
  }

  double activity_ = kNone;  // of the fusion
  double rating_ = kNone;

 private:
  enum class Rule { maximum, average, sum };

  struct Signals {
    double stimulation = 0.0;
    double inhibition = 0.0;
    int inhibited_by = -1;
    double activity = 0.0;  // until it is decided, that of the last step
    double rating = 0.0;
  };
  void link() {
    links_.make(names_, stimulations, inhibitions);
    names_.throw_problems();
  }
  void decide(elsie::Member& member, std::size_t i, double priority);
  void trace(std::span<elsie::Member> members, std::size_t strongest) const;

  Rule rule_ = Rule::average;
  bool by_strength_ = false;
  MemberNames names_;
  SignalLinks links_;
  std::vector<Signals> signals_;
  Desirability desirability_;
};

elsie::Motion FusionIb2c::coordinate(std::span<elsie::Member> members,
                                     const elsie::Perception& now) {
  if (members.size() != names_.size()) {
    equipped(members, now);
  }
  double highest = 0.0;
  for (const elsie::Member& member : members) {
    highest = std::max(highest, member.priority());
  }
  for (const std::size_t i : links_.order) {
    decide(members[i], i, highest > 0.0 ? members[i].priority() / highest : 0.0);
  }
  double most = 0.0, sum = 0.0, squares = 0.0, ratings = 0.0;
  std::size_t strongest = 0;
  elsie::Motion command;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const Signals& signals = signals_[i];
    if (signals.activity > most) {
      most = signals.activity;
      strongest = i;
    }
    if (signals.activity > 0.0) {
      sum += signals.activity;
      squares += signals.activity * signals.activity;
      ratings += signals.activity * signals.rating;
      command += signals.activity * members[i].respond().command;
    }
  }
  trace(members, strongest);
  activity_ = rating_ = members.empty() ? kNone : 0.0;
  if (!(most > 0.0)) {
    return {};
  }
  if (rule_ == Rule::maximum) {
    activity_ = most;
    rating_ = signals_[strongest].rating;
    return members[strongest].respond().command;
  }
  rating_ = ratings / sum;
  activity_ = rule_ == Rule::sum ? std::min(1.0, squares / most) : squares / sum;
  return command / (rule_ == Rule::sum ? most : sum);
}

/// The signals of one member, after those that act on it.
void FusionIb2c::decide(elsie::Member& member, std::size_t i, double priority) {
  Signals& signals = signals_[i];
  bool linked = false;
  double stimulation = 0.0;
  signals.inhibition = 0.0;
  signals.inhibited_by = -1;
  for (const SignalLinks::Wire& wire : links_.wires) {
    if (wire.of != i) {
      continue;
    }
    const double signal = wire.factor * signals_[wire.by].activity;
    if (!wire.inhibits) {
      linked = true;
      stimulation = std::max(stimulation, signal);
    } else if (signal > signals.inhibition) {
      signals.inhibition = signal;
      signals.inhibited_by = static_cast<int>(wire.by);
    }
  }
  signals.stimulation = std::max(0.0, priority) * (linked ? stimulation : 1.0);
  signals.activity = signals.rating = 0.0;
  if (priority > 0.0) {
    // Also without activation: the target rating does not depend on that.
    const elsie::Response& response = member.respond();
    signals.rating = by_strength_ ? response.strength : response.activation;
    signals.activity =
        signals.stimulation * (1.0 - signals.inhibition) * response.activation * response.strength;
  }
}

void FusionIb2c::trace(std::span<elsie::Member> members, std::size_t strongest) const {
  for (std::size_t i = 0; i < members.size(); ++i) {
    const Signals& signals = signals_[i];
    elsie::TraceRow& row = members[i].trace;
    const bool loses = rule_ == Rule::maximum && i != strongest && signals.activity > 0.0;
    const bool silenced = signals.inhibition > 0.5 && signals.stimulation > 0.0;
    row.weight = loses ? 0.0 : signals.activity;
    row.inhibited_by = silenced ? signals.inhibited_by : loses ? static_cast<int>(strongest) : -1;
    row.reason = !(members[i].priority() > 0.0) ? "priority not above zero"
                 : silenced                     ? "inhibited"
                 : !(signals.stimulation > 0.0) ? "not stimulated"
                 : !(row.activation > 0.0)      ? "not active"
                 : !(row.strength > 0.0)        ? "no strength"
                 : loses                        ? "lower activity"
                 : rule_ == Rule::maximum       ? "highest activity"
                 : signals.inhibition > 0.0     ? "partly inhibited"
                                                : "active";
  }
  normalize_shares(members);
}

}  // namespace

ELSIE_COORDINATOR(
    FusionIb2c, "fusion_ib2c",
    "Behaviours stimulate and inhibit each other; their activities weigh their commands",
    elsie::parameter(
        "fusion", &FusionIb2c::fusion,
        {.choices = {"maximum", "average", "sum"},
         .meaning = "the fusion behaviour: the most active one decides; the mean of the commands, "
                    "weighted with the activities; their sum, divided by the largest activity"}),
    elsie::parameter("rating", &FusionIb2c::rating,
                     {.choices = {"activation", "strength"},
                      .meaning = "what of a behaviour's answer is its target rating: 0 when it is "
                                 "content"}),
    elsie::elements(
        &FusionIb2c::inhibitions,
        elsie::element<Link>(
            "inhibit", "the activity of behaviour 'by' inhibits behaviour 'of'",
            elsie::parameter("by", &Link::by,
                             {.meaning = "the id of the one that inhibits", .required = true}),
            elsie::parameter("of", &Link::of,
                             {.meaning = "the id of the one that is inhibited", .required = true}),
            elsie::parameter("factor", &Link::factor,
                             {.min = 0, .max = 1, .meaning = "of the activity"}))),
    elsie::elements(
        &FusionIb2c::stimulations,
        elsie::element<Link>(
            "stimulate",
            "the activity of behaviour 'by' stimulates behaviour 'of'; one without such an element "
            "is always stimulated",
            elsie::parameter("by", &Link::by,
                             {.meaning = "the id of the one that stimulates", .required = true}),
            elsie::parameter("of", &Link::of,
                             {.meaning = "the id of the one that is stimulated", .required = true}),
            elsie::parameter("factor", &Link::factor,
                             {.min = 0, .max = 1, .meaning = "of the activity"}))),
    elsie::publishes("activity", &FusionIb2c::activity_,
                     {.meaning = "of the fusion, 0 to 1; none without behaviours"}),
    elsie::publishes("rating", &FusionIb2c::rating_,
                     {.meaning = "target rating of the fusion, 0 to 1: 0 is content"}));
