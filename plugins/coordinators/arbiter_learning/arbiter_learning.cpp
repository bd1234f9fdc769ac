// Which behaviour decides is learned from rewards: by Q-learning (Watkins, "Learning from delayed
// rewards", 1989), or by W-learning of agents that know one reward each (Humphrys, "Action
// selection methods using reinforcement learning", 1997). A choice holds for a while, as in
// semi-Markov decision processes (Bradtke and Duff, 1995). In a run nothing is learned.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <elsie/api/remember.h>
#include <elsie/base/number_text.h>
#include <elsie/base/words.h>
#include <elsie/learning/reward_learner.h>

#include "agents.h"
#include "state_space.h"
#include "winner.h"

namespace {

using elsie::learning::Ending;
using elsie::learning::Remark;
using elsie::learning::Values;

class ArbiterLearning final : public WinnerTakesAll,
                              public elsie::Remembers,
                              public elsie::learning::RewardLearner {
 public:
  std::string method = "q";
  double rate = 0.1;
  double discount = 0.95;
  double hold = 1.0;
  elsie::FilePath values;
  bool untrained = false;
  std::vector<Feature> features;

  void configured() override { space_ = StateSpace(features); }

  void equipped(std::span<const elsie::Member> members, const elsie::Perception& example) override {
    space_.equip(members, example);
    behaviors_.clear();
    for (const elsie::Member& member : members) behaviors_.emplace_back(member.name());
    if (lesson_) {
      if (lesson_->about == about()) return;
      throw std::invalid_argument("its behaviours or features changed while it was learning");
    }
    // A file that changes in a run is not read again when the robot gets another sensor.
    if (read_ != std::pair(values.path, about())) {
      agents_ = values.path.empty() ? agents_without_file() : agents_of_file();
      read_ = {values.path, about()};
    }
    resume(choice_);
  }

  void reset(elsie::Random&) override {
    choice_.reset();
    lesson_.reset();
  }

  void remember(elsie::Memory& memory) override {
    std::vector<double> choice;
    if (choice_) choice = {double(choice_->state), double(choice_->action), choice_->since_s};
    memory("choice", choice);
    if (!memory.recalls() || choice_ || choice.size() != 3) return;
    resume(Choice{std::size_t(choice[0]), std::size_t(choice[1]), {}, choice[2]});
  }

  std::vector<std::string> notes() const override { return notes_; }

  elsie::Motion coordinate(std::span<elsie::Member> members,
                           const elsie::Perception& now) override {
    if (members.empty()) return nobody(members, "");
    constexpr double kRounding = 1e-9;  // s
    period_s_ = now.period_s();
    state_ = space_.state(members, now);
    if (choice_ &&
        (choice_->state != state_ || now.time_s() - choice_->since_s + kRounding >= hold)) {
      if (lesson_) learn(state_);
      choice_.reset();
    }
    if (!choice_) choose(now.time_s());
    const elsie::Motion command =
        let_decide(members, choice_->action, reasons_[choice_->action].c_str(), "");
    for (std::size_t i = 0; i < members.size(); ++i) {
      members[i].trace.weight = value_of(i) - least_;
      members[i].trace.reason = reasons_[i];
    }
    return command;
  }

  void begin(const std::vector<std::string>& rewards, Values known, double exploration,
             const elsie::Random& random) override {
    if (behaviors_.empty()) throw std::invalid_argument("it has no behaviours to choose from");
    const bool several = method == "w";
    if (several && rewards.size() < 2) {
      throw std::invalid_argument(
          "with method=\"w\" rewards compete; its robot has one, expected two or more");
    }
    rewards_ = rewards;
    agents_ = known.tables.empty() ? Agents(several ? rewards : std::vector<std::string>{kOneAgent},
                                            space_.size(), behaviors_.size())
                                   : Agents(std::move(known.tables));
    if (!agents_.fit(space_.size(), behaviors_.size(), several) ||
        (several && agents_.names() != rewards)) {
      throw std::invalid_argument("what was learned before does not fit it any more");
    }
    read_.reset();
    lesson_.emplace(Lesson{exploration, random, about()});
  }

  void learned(std::span<const double> rewards) override {
    if (!lesson_) {
      throw std::logic_error(
          "the coordinator that learns was made again, by an edit in the run; what it learned "
          "before is lost");
    }
    if (rewards.size() != rewards_.size()) {
      throw std::logic_error("it got " + elsie::base::counted(rewards.size(), "reward") +
                             ", but its episode began with " + std::to_string(rewards_.size()));
    }
    if (!choice_) return;
    const double factor = std::pow(discount, choice_->passed_s);
    for (std::size_t i = 0; i < rewards.size(); ++i) {
      choice_->discounted[agents_.count() > 1 ? i : 0] += factor * rewards[i];
    }
    choice_->passed_s += period_s_;
  }

  Values finish(Ending ending) override {
    if (choice_) learn(ending == Ending::cut_off ? std::optional(state_) : std::nullopt);
    choice_.reset();
    lesson_.reset();
    Values learned{agents_.tables(), about()};
    learned.about.push_back({"rewards", elsie::base::joined(rewards_, " ")});
    return learned;
  }

  /// The number of the present state, from 1, and the value in it of the behaviour that decides.
  double state() const { return choice_ ? static_cast<double>(choice_->state + 1) : kNone; }
  double value() const { return choice_ ? value_of(choice_->action) : kNone; }

 private:
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  static constexpr const char* kOneAgent = "value";  // of the sum of all rewards

  struct Lesson {
    double exploration;
    elsie::Random random;
    std::vector<Remark> about;  // what its tables mean
  };

  /// What a file of values must have been learned with.
  std::vector<Remark> about() const {
    return {{"method", method},
            {"behaviors", elsie::base::joined(behaviors_, " ")},
            {"features", space_.description()}};
  }

  Agents agents_without_file() {
    if (!untrained) {
      throw std::invalid_argument(
          "it has no values: train it with `elsie train WORLD --values FILE`, and then write "
          "values=\"FILE\"; with untrained=\"true\" all values are 0");
    }
    notes_ = {"It is untrained: all values are 0, and the first behaviour decides."};
    return Agents({kOneAgent}, space_.size(), behaviors_.size());
  }

  Agents agents_of_file() {
    Values read = elsie::learning::read_values(values.path);
    require_same(read, about(), values.path);
    const std::string training(read.remark("training"));
    Agents agents(std::move(read.tables));
    if (!agents.fit(space_.size(), behaviors_.size(), method == "w")) {
      throw std::invalid_argument(values.path + ": its tables are not of " +
                                  elsie::base::counted(space_.size(), "state") + " and " +
                                  elsie::base::counted(behaviors_.size(), "behaviour") +
                                  "; train again with elsie train");
    }
    notes_ = {"Values of " + std::filesystem::path(values.path).filename().string() +
              (training.empty() ? "" : ", learned in " + training) + "; nothing is learned."};
    return agents;
  }

  /// Goes on with a choice of before, if there still are its state and its behaviour.
  void resume(std::optional<Choice> before) {
    const bool is_there =
        before && before->state < space_.size() && before->action < behaviors_.size();
    choice_ = is_there ? std::move(before) : std::nullopt;
    if (!choice_) return;
    choice_->leader = agents_.leader(choice_->state);
    explain();
  }

  void choose(double time_s) {
    const std::size_t leads = agents_.leader(state_);
    choice_ = Choice{state_, agents_.values(leads).best(state_), leads, time_s};
    choice_->discounted.assign(agents_.count(), 0.0);
    if (lesson_ && lesson_->random.chance(lesson_->exploration)) explore(*choice_);
    explain();
  }

  /// Any behaviour decides; of several agents, half of the times any of them leads, so that who
  /// leads otherwise learns what it would lose.
  void explore(Choice& choice) {
    const auto drawn = [this](std::size_t from) {
      return static_cast<std::size_t>(lesson_->random.uniform(0.0, static_cast<double>(from)));
    };
    if (agents_.count() > 1 && lesson_->random.chance(0.5)) {
      choice.leader = drawn(agents_.count());
      choice.action = agents_.values(*choice.leader).best(choice.state);
    } else {
      choice.leader.reset();
      choice.action = drawn(behaviors_.size());
    }
  }

  void learn(std::optional<std::size_t> next) {
    agents_.learn(*choice_, next, std::pow(discount, choice_->passed_s), rate);
  }

  /// Of a behaviour in the present state, for the agent that leads there.
  double value_of(std::size_t behavior) const {
    const std::size_t agent = choice_->leader.value_or(agents_.leader(choice_->state));
    return agents_.values(agent).at(choice_->state, behavior);
  }

  void explain() {
    const auto number = [](double value) { return elsie::base::number_text(value, 3); };
    reasons_.resize(behaviors_.size());
    least_ = value_of(choice_->action);
    for (std::size_t i = 0; i < reasons_.size(); ++i) {
      reasons_[i] = "value " + number(value_of(i));
      least_ = std::min(least_, value_of(i));
    }
    std::string& won = reasons_[choice_->action];
    won +=
        (choice_->leader ? ", best in state " : ", tried in state ") + space_.text(choice_->state);
    if (choice_->leader && agents_.count() > 1) {
      won = agents_.name(*choice_->leader) + " leads, W " +
            number(agents_.weight(choice_->state, *choice_->leader)) + ": " + won;
    }
  }

  StateSpace space_;
  std::vector<std::string> behaviors_;
  std::vector<std::string> rewards_;
  Agents agents_;
  std::optional<std::pair<std::string, std::vector<Remark>>> read_;  // file and about() of agents_
  std::vector<std::string> notes_;
  std::optional<Lesson> lesson_;  // none: a run
  double period_s_ = 0.0;
  std::size_t state_ = 0;  // perceived last
  std::optional<Choice> choice_;
  std::vector<std::string> reasons_;  // of the choice, in the trace
  double least_ = 0.0;                // value in its state; weights in the trace are not negative
};

}  // namespace

ELSIE_COORDINATOR(
    ArbiterLearning, "arbiter_learning",
    "The behaviour with the largest learned value in the present state decides",
    elsie::elements(
        &ArbiterLearning::features,
        elsie::element<Feature>(
            "feature", "a part of the state: how many thresholds a number reaches",
            elsie::parameter("of", &Feature::of,
                             {.meaning = "a number or a condition over what the robot perceives",
                              .required = true}),
            elsie::parameter("at", &Feature::at,
                             {.min = -1e9, .max = 1e9, .meaning = "its thresholds, ascending"}),
            elsie::parameter("name", &Feature::name,
                             {.meaning = "what the trace calls it; by default what it is of"}))),
    elsie::parameter("method", &ArbiterLearning::method,
                     {.choices = {"q", "w"},
                      .meaning = "'q': one table, of the sum of all rewards; 'w': a table for each "
                                 "reward, and who has most to lose leads"}),
    elsie::parameter("rate", &ArbiterLearning::rate,
                     {.above = 0,
                      .max = 1,
                      .meaning = "how far a value moves towards what was seen, in training"}),
    elsie::parameter(
        "discount", &ArbiterLearning::discount,
        {.above = 0, .max = 1, .meaning = "what a reward in a second counts now, in training"}),
    elsie::parameter(
        "hold", &ArbiterLearning::hold,
        {.unit = "s", .min = 0, .meaning = "how long a choice holds, unless the state changes"}),
    elsie::parameter("values", &ArbiterLearning::values,
                     {.meaning = "file of what was learned, as elsie train writes it"}),
    elsie::parameter("untrained", &ArbiterLearning::untrained,
                     {.meaning = "whether it may run without that file, with all values 0"}),
    elsie::publishes("state", &ArbiterLearning::state,
                     {.meaning = "the number of the present state"}),
    elsie::publishes("value", &ArbiterLearning::value,
                     {.meaning = "the value in it of the behaviour that decides"}));
