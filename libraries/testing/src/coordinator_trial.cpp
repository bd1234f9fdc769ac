#include <vector>

#include "elsie/plugin/parameters.h"
#include "elsie/testing/coordinator.h"

#include "text.h"
#include "trial.h"

namespace elsie::testing {
namespace {

class CoordinatorTrial final : public Trial {
 public:
  explicit CoordinatorTrial(const TrialSetting& setting)
      : input_(setting.input),
        instants_(setting.input.instants),
        settings_(setting.plugins.completed(setting.declaration, setting.settings)) {
    for (std::size_t i = 0; i < input_.members.size(); ++i) {
      team_.member(input_.members[i], input_.priorities[i], Response());
    }
    coordinator_ = std::make_unique<Coordinator>(setting.plugins, setting.declaration.name, team_,
                                                 setting.settings, setting.elements);
    equipping([&] { coordinator_->equip(instants_.front()); });
  }

  Component& object() override { return **coordinator_; }
  void reset(std::uint64_t seed) override {
    coordinator_->reset(seed);
    (*coordinator_)->notes();
  }
  void configure_again() override {
    plugin::apply_parameters(coordinator_->declaration(), **coordinator_, settings_);
    equipping([&] { coordinator_->equip(instants_.front()); });
  }

  bool take_over(Trial& before) override {
    return coordinator_->take_over(*static_cast<CoordinatorTrial&>(before).coordinator_);
  }

  void step(std::size_t step, Answer& answer) override {
    const std::size_t at = step % instants_.size();
    Situation& now = instants_[at];
    now.time(static_cast<double>(step) * now.period_s());
    for (std::size_t i = 0; i < team_.size(); ++i) {
      team_.answer(i) = input_.wishes[at][i];
    }
    const Motion command = coordinator_->decide(now);
    require_declared(coordinator_->declaration(), coordinator_->now.listened());
    answer.clear();
    require_finite(command);
    answer.add(command);
    double shares = 0.0;
    for (const Member& member : team_.members()) {
      tell(member.trace, answer);
      shares += member.trace.share;
    }
    if (shares > 1.0 + 1e-6) {
      throw Wrong("the shares in its trace add up to " + number_text(shares) + ", more than 1");
    }
    resolve(step, answer);
    const std::vector<double> desirability =
        coordinator_->rate({candidates().begin(), candidates().end()});
    require_rating(desirability);
    for (const double degree : desirability) {
      answer.add("its rating of a candidate command", degree);
    }
    const CommandSets sets = coordinator_->sets();
    require_sets(sets);
    answer.add(sets);
  }

 private:
  struct Flag {
    static constexpr const char* kind = "flag";
    bool raised = true;
  };

  /// Lets some of those behaviours command an actuator that may.
  void resolve(std::size_t step, Answer& answer) {
    Random random(step + 1);
    std::vector<Wish> wishes;
    for (const Member& member : team_.members()) {
      if (!member.trace.asked || member.trace.inhibited_by >= 0 || random.chance(0.2)) continue;
      wishes.emplace_back(std::string(member.name()), Flag{});
    }
    if (wishes.size() < 2) return;
    const std::size_t chosen = coordinator_->resolve("actuator", wishes);
    if (chosen > wishes.size()) {
      throw Wrong("resolve() chooses wish " + std::to_string(chosen) + " of " +
                  std::to_string(wishes.size()));
    }
    answer.add("the wish that resolve() chooses", static_cast<double>(chosen));
  }

  void tell(const TraceRow& row, Answer& answer) const {
    require_finite("a weight in its trace", row.weight);
    if (!(row.share >= 0.0 && row.share <= 1.0 + 1e-9)) {
      throw Wrong("a share in its trace is " + number_text(row.share) + ", which is not in [0, 1]");
    }
    if (row.inhibited_by < -1 || row.inhibited_by >= static_cast<int>(team_.size())) {
      throw Wrong("its trace says that member " + std::to_string(row.inhibited_by) +
                  " inhibits another, but there is no such member");
    }
    answer.add("a weight in its trace", row.weight);
    answer.add("a share in its trace", row.share);
    answer.add("who inhibits whom in its trace", row.inhibited_by);
    answer.add("whether it asks a member", row.asked);
    answer.events.emplace_back(row.reason);
  }

  const Input& input_;
  std::vector<Situation> instants_;
  Settings settings_;
  Team team_;
  std::unique_ptr<Coordinator> coordinator_;
};

}  // namespace

std::unique_ptr<Trial> make_coordinator_trial(const TrialSetting& setting) {
  return std::make_unique<CoordinatorTrial>(setting);
}

}  // namespace elsie::testing
