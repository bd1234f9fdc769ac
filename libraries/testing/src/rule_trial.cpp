#include <cstdint>

#include "elsie/plugin/parameters.h"
#include "elsie/testing/rule.h"

#include "trial.h"

namespace elsie::testing {
namespace {

/// Shows a rule random worlds, in which there sometimes is no room. Its edits are noted, not made.
class RuleTrial final : public Trial {
 public:
  explicit RuleTrial(const TrialSetting& setting)
      : input_(setting.input),
        settings_(setting.plugins.completed(setting.declaration, setting.settings)),
        elements_(setting.plugins.completed(setting.declaration, setting.elements)),
        rule_(setting.plugins, setting.declaration.name, setting.settings, setting.elements) {
    rule_.has_room = [this](std::string_view, const Pose&) { return asked_++ % 3 != 0; };
    equipping([&] { rule_.equip(input_.watched.front()); });
  }

  Component& object() override { return *rule_; }
  void reset(std::uint64_t seed) override {
    rule_.reset(seed);
    rule_->notes();
    rule_->curves();
    asked_ = 0;
    rule_.apply(input_.watched.front());
  }
  bool take_over(Trial& /*before*/) override { return false; }  // rules are not replaced
  void configure_again() override {
    plugin::apply_parameters(rule_.declaration(), *rule_, settings_, elements_);
    equipping([&] { rule_.equip(input_.watched.front()); });
  }

  void step(std::size_t step, Answer& answer) override {
    const Ruling& ruling = rule_.apply(instant(input_, step));
    answer.clear();
    for (const std::string& edit : ruling.edits) {
      if (edit.starts_with('=')) throw Wrong("it makes an edit without a path");
      answer.events.push_back("edit " + edit);
    }
    for (const std::string& event : ruling.events) answer.events.push_back(event);
    if (ruling.outcome != RunEnd::Outcome::running) {
      if (ruling.reason.empty()) throw Wrong("it ends the run and gives no reason");
      answer.events.push_back(std::string("end in ") + to_string(ruling.outcome) + ": " +
                              ruling.reason);
    }
  }

 private:
  const Input& input_;
  Settings settings_;
  Elements elements_;
  Rule rule_;
  std::uint64_t asked_ = 0;  // how often has_room() was asked
};

}  // namespace

std::unique_ptr<Trial> make_rule_trial(const TrialSetting& setting) {
  return std::make_unique<RuleTrial>(setting);
}

}  // namespace elsie::testing
