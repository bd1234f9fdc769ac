// Action selection by spreading activation (Maes, 1989): competences with preconditions, and with
// lists of what they make true and false, give each other activation; so do the situation and the
// goals. An executable one above the threshold decides.
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <elsie/api/remember.h>
#include <elsie/base/near_name.h>

#include "member_names.h"
#include "propositions.h"
#include "spreading_network.h"
#include "winner.h"

namespace {

struct Competence {
  std::string of;
  std::string needs;
  std::string adds;
  std::string deletes;
};

class ArbiterSpreadingActivation final : public WinnerTakesAll, public elsie::Remembers {
 public:
  using Set = SpreadingNetwork::Set;

  std::string goals;
  double phi = 20.0;
  double gamma = 70.0;
  double delta = 50.0;
  double pi = 20.0;
  double theta = 45.0;
  double interval = 0.1;
  bool interrupts = true;
  std::vector<Competence> competences;
  std::vector<Proposition> propositions;

  void equipped(std::span<const elsie::Member> members, const elsie::Perception& example) override;
  void reset(elsie::Random&) override {
    network_.reset(theta);
    situation_.reset();
    winner_.reset();
    next_s_ = -1.0;
    state_ = 0;
  }
  void remember(elsie::Memory& memory) override;
  std::vector<std::string> notes() const override;

  elsie::Motion coordinate(std::span<elsie::Member> members, const elsie::Perception& now) override;

  double threshold() const { return network_.threshold; }
  double level() const {
    return winner_ ? network_.modules[*winner_].level : std::numeric_limits<double>::quiet_NaN();
  }
  double true_ones() const { return std::popcount(state_); }
  double goals_reached() const { return std::popcount(state_ & goals_); }

 private:
  Set set_of(const std::string& list, const std::string& where);
  bool is_done(std::size_t member) const { return !(network_.modules[member].adds & ~state_); }
  void spread(const elsie::Perception& now);
  void trace(std::span<elsie::Member> members, bool is_new) const;

  MemberNames names_;
  std::vector<bool> able_;                // whether a member has a competence
  std::vector<std::string> prioritized_;  // members with a priority of their own
  std::vector<std::string> proposition_names_;
  std::vector<std::string> needs_;  // reasons: "needs at_food"
  SpreadingNetwork network_;
  Situation situation_;
  Set goals_ = 0;
  Set state_ = 0;         // true propositions
  double next_s_ = -1.0;  // when activation spreads again; below 0: at once
};

void ArbiterSpreadingActivation::equipped(std::span<const elsie::Member> members,
                                          const elsie::Perception& example) {
  names_.read(members);
  prioritized_.clear();
  for (const elsie::Member& member : members) {
    if (member.priority() != 1.0) {
      prioritized_.emplace_back(member.name());
    }
  }
  proposition_names_.clear();
  needs_.clear();
  for (const Proposition& proposition : propositions) {
    const std::string& name = name_of(proposition);
    if (std::find(proposition_names_.begin(), proposition_names_.end(), name) !=
        proposition_names_.end()) {
      names_.refuse("two propositions have the name '" + name + "'; rename or remove one");
    }
    proposition_names_.push_back(name);
    needs_.push_back("needs " + name);
  }
  if (propositions.size() > SpreadingNetwork::kPropositions) {
    names_.refuse("there are " + std::to_string(propositions.size()) +
                  " propositions, and the most are 64; remove some");
    names_.throw_problems();
  }
  situation_.use(propositions, members, example,
                 [&](const std::string& problem) { names_.refuse(problem); });
  goals_ = set_of(goals, "goals=\"" + goals + "\"");
  network_.modules.assign(names_.size(), {});
  able_.assign(names_.size(), false);
  for (const Competence& competence : competences) {
    const auto of = names_.find("competence", "of", competence.of);
    const std::string text = MemberNames::text("competence", "of", competence.of);
    if (of && able_[*of]) {
      names_.refuse(text + " is given twice; remove one");
    }
    SpreadingNetwork::Module module;
    module.needs = set_of(competence.needs, text);
    module.adds = set_of(competence.adds, text);
    module.deletes = set_of(competence.deletes, text);
    if (module.adds & module.deletes) {
      names_.refuse(text + " has the same proposition in 'adds' and in 'deletes'; remove one");
    }
    if (of) {
      able_[*of] = true;
      network_.modules[*of] = module;
    }
  }
  names_.throw_problems();
  network_.prepare();
  network_.reset(theta);
  winner_.reset();
  next_s_ = -1.0;
}

/// The set of the propositions in a list of names.
SpreadingNetwork::Set ArbiterSpreadingActivation::set_of(const std::string& list,
                                                         const std::string& where) {
  Set set = 0;
  std::istringstream words(list);
  for (std::string word; words >> word;) {
    const auto found = std::find(proposition_names_.begin(), proposition_names_.end(), word);
    if (found == proposition_names_.end()) {
      names_.refuse(where + " has '" + word + "', which is the name of no proposition" +
                    (proposition_names_.empty()
                         ? "; declare it by <perceives>, <recalls> or <place>"
                         : elsie::base::near_or_all(word, proposition_names_, "there are")));
    } else {
      set |= Set{1} << (found - proposition_names_.begin());
    }
  }
  return set;
}

std::vector<std::string> ArbiterSpreadingActivation::notes() const {
  std::vector<std::string> notes;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (!able_[i]) {
      notes.push_back("'" + names_[i] + "' has no <competence> and never decides");
    }
  }
  if (!goals_) {
    notes.push_back("it has no goals, so only the situation activates behaviours; give it goals=");
  }
  for (const std::string& name : prioritized_) {
    notes.push_back("the attribute 'priority' of " + name + " has no effect: activation decides");
  }
  return notes;
}

void ArbiterSpreadingActivation::remember(elsie::Memory& memory) {
  for (std::size_t i = 0; i < names_.size(); ++i) {
    memory("level of " + names_[i], network_.modules[i].level);
    bool decides = winner_ == i, selected = network_.selected() == i;
    memory(names_[i] + " decides", decides);
    memory(names_[i] + " is selected", selected);
    if (memory.recalls()) {
      winner_ = decides ? i : winner_ == i ? std::nullopt : winner_;
      network_.select(selected ? i : network_.selected() == i ? std::nullopt : network_.selected());
    }
  }
  memory("threshold", network_.threshold);
  memory("next_s", next_s_);
  situation_.remember(memory);
}

elsie::Motion ArbiterSpreadingActivation::coordinate(std::span<elsie::Member> members,
                                                     const elsie::Perception& now) {
  if (members.size() != names_.size()) {
    equipped(members, now);
  }
  state_ = situation_.update(members, now);
  const std::optional<std::size_t> before = winner_;
  spread(now);
  if (winner_ && !network_.is_executable(*winner_, state_)) {
    winner_.reset();
  }
  const elsie::Motion command =
      winner_ ? let_decide(members, *winner_, "", "") : nobody(members, "");
  trace(members, winner_ != before);
  return command;
}

/// The steps of the network that are due. In between, the last one selected goes on.
void ArbiterSpreadingActivation::spread(const elsie::Perception& now) {
  const double now_s = now.time_s();
  if (next_s_ < 0.0 || now_s - next_s_ > now.period_s() + interval) {
    next_s_ = now_s;  // at the start, and after a pause in which nobody asked
  }
  for (; next_s_ <= now_s + 1e-9; next_s_ += interval) {
    if (interrupts || !winner_ || !network_.is_executable(*winner_, state_) || is_done(*winner_)) {
      const auto selected = network_.step(state_, goals_, {phi, gamma, delta, pi, theta});
      winner_ = selected ? selected : winner_;
    }
  }
}

void ArbiterSpreadingActivation::trace(std::span<elsie::Member> members, bool is_new) const {
  double sum = 0.0;
  for (const SpreadingNetwork::Module& module : network_.modules) {
    sum += module.level;
  }
  for (std::size_t i = 0; i < members.size(); ++i) {
    const SpreadingNetwork::Module& module = network_.modules[i];
    elsie::TraceRow& row = members[i].trace;
    row.weight = sum > 0.0 ? module.level / sum : 0.0;
    if (winner_ == i) {
      row.reason = is_new ? "selected" : "goes on";
    } else if (const Set missing = module.needs & ~state_) {
      row.reason = needs_[static_cast<std::size_t>(std::countr_zero(missing))];
      row.inhibited_by = -1;
    } else {
      row.reason = !able_[i]                            ? "no competence"
                   : module.level >= network_.threshold ? "less activation"
                                                        : "below threshold";
    }
  }
}

}  // namespace

ELSIE_COORDINATOR(
    ArbiterSpreadingActivation, "arbiter_spreading_activation",
    "Competences give each other activation towards goals; an executable one above a threshold "
    "decides",
    elsie::parameter("goals", &ArbiterSpreadingActivation::goals,
                     {.meaning = "the propositions that are to be true, separated by spaces"}),
    elsie::parameter("phi", &ArbiterSpreadingActivation::phi,
                     {.min = 0, .max = 1e4, .meaning = "activation from a true proposition"}),
    elsie::parameter("gamma", &ArbiterSpreadingActivation::gamma,
                     {.above = 0, .max = 1e4, .meaning = "activation from a goal"}),
    elsie::parameter("delta", &ArbiterSpreadingActivation::delta,
                     {.min = 0,
                      .max = 1e4,
                      .meaning = "activation that a goal which is reached takes from what would "
                                 "undo it"}),
    elsie::parameter("pi", &ArbiterSpreadingActivation::pi,
                     {.above = 0, .max = 1e4, .meaning = "mean level of activation"}),
    elsie::parameter("theta", &ArbiterSpreadingActivation::theta,
                     {.above = 0,
                      .max = 1e5,
                      .meaning = "threshold; lower by a tenth each time that none is selected"}),
    elsie::parameter("interval", &ArbiterSpreadingActivation::interval,
                     {.unit = "s",
                      .min = 0.01,
                      .max = 100,
                      .meaning = "time from one step of the network to the next"}),
    elsie::parameter("interrupts", &ArbiterSpreadingActivation::interrupts,
                     {.meaning = "whether the network goes on while a behaviour decides that has "
                                 "not yet done what it adds, and may select another"}),
    elsie::elements(
        &ArbiterSpreadingActivation::competences,
        elsie::element<Competence>(
            "competence",
            "what a behaviour needs and brings about: names of propositions, "
            "separated by spaces",
            elsie::parameter("of", &Competence::of,
                             {.meaning = "the behaviour's id", .required = true}),
            elsie::parameter("needs", &Competence::needs,
                             {.meaning = "its preconditions: it decides only while all are true"}),
            elsie::parameter("adds", &Competence::adds, {.meaning = "what it makes true"}),
            elsie::parameter("deletes", &Competence::deletes, {.meaning = "what it makes false"}))),
    elsie::elements(
        &ArbiterSpreadingActivation::propositions,
        elsie::element<Perceives>(
            "perceives", "a proposition that is true while a condition holds",
            elsie::parameter("name", &Perceives::name, {.meaning = "its name", .required = true}),
            elsie::parameter("when", &Perceives::when,
                             {.meaning = "a condition over what the robot perceives",
                              .required = true})),
        elsie::element<Recalls>(
            "recalls", "a proposition that is true from an event on",
            elsie::parameter("name", &Recalls::name, {.meaning = "its name", .required = true}),
            elsie::parameter("event", &Recalls::event,
                             {.meaning = "the event that makes it true", .required = true}),
            elsie::parameter("until", &Recalls::until,
                             {.meaning = "the event that makes it false"}),
            elsie::parameter("for", &Recalls::for_s,
                             {.unit = "s",
                              .min = 0,
                              .max = 1e9,
                              .meaning = "how long it is true; 0: until the other event"}),
            elsie::parameter("initially", &Recalls::initially,
                             {.meaning = "whether it is true at the start"})),
        elsie::element<Place>(
            "place", "a proposition that is true near a place",
            elsie::parameter("name", &Place::name, {.meaning = "its name", .required = true}),
            elsie::parameter("x", &Place::x, {.unit = "m", .meaning = "the place, east"}),
            elsie::parameter("y", &Place::y, {.unit = "m", .meaning = "the place, north"}),
            elsie::parameter("radius", &Place::radius,
                             {.unit = "m", .above = 0, .max = 1e6, .meaning = "how near"}),
            elsie::parameter("keeps", &Place::keeps,
                             {.meaning = "whether it stays true once the robot was there"}))),
    elsie::names_event("recalls/event"), elsie::names_event("recalls/until"),
    elsie::publishes("threshold", &ArbiterSpreadingActivation::threshold,
                     {.meaning = "the present one"}),
    elsie::publishes("level", &ArbiterSpreadingActivation::level,
                     {.meaning = "activation of the behaviour that decides; none: nobody does"}),
    elsie::publishes("propositions", &ArbiterSpreadingActivation::true_ones,
                     {.meaning = "how many are true"}),
    elsie::publishes("goals_reached", &ArbiterSpreadingActivation::goals_reached,
                     {.meaning = "how many goals are true"}));
