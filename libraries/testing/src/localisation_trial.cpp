#include <cmath>
#include <vector>

#include "elsie/api/localisation.h"
#include "elsie/plugin/parameters.h"

#include "text.h"
#include "trial.h"

namespace elsie::testing {
namespace {

constexpr double kStep = 0.01;  // s

/// Lets a robot drive the motions of the input, and asks where it believes itself to be.
class LocalisationTrial final : public Trial {
 public:
  explicit LocalisationTrial(const TrialSetting& setting)
      : input_(setting.input),
        declaration_(setting.declaration),
        settings_(setting.plugins.completed(setting.declaration, setting.settings)),
        elements_(setting.elements),
        localisation_(setting.plugins.host().create<Localisation>(PluginKind::localisation,
                                                                  declaration_.name)) {
    configure_again();
  }

  Component& object() override { return *localisation_; }
  void reset(std::uint64_t seed) override {
    random_ = Random(seed);
    localisation_->reset(random_);
    localisation_->notes();
    localisation_->curves();
    truth_ = {};
    belief_ = localisation_->start(truth_, random_);
  }
  bool take_over(Trial& /*before*/) override { return false; }
  void configure_again() override {
    plugin::apply_parameters(declaration_, *localisation_, settings_, elements_);
  }

  void step(std::size_t step, Answer& answer) override {
    const Motion& moving = input_.asked[step % input_.asked.size()];
    drive(moving);
    const bool is_placed = step % 97 == 96;
    if (is_placed) truth_.pose = {0.1 * static_cast<double>(step % 10), -1.0, 0.0};
    const WheelPair wheels{input_.chassis.wheel_radius, input_.chassis.half_axle};
    const WheelRates rates = wheels.wheel_rates(moving);
    const JointSetting joints[] = {{rates.left}, {rates.right}};
    belief_ = is_placed
                  ? localisation_->placed(belief_, truth_)
                  : localisation_->update(belief_, {static_cast<double>(step) * kStep, kStep,
                                                    truth_, moving, joints, wheels, &random_});
    answer.clear();
    const auto add = [&](const char* name, double value) {
      require_finite(name, value);
      answer.add(name, value);
    };
    add("the believed x", belief_.pose.x);
    add("the believed y", belief_.pose.y);
    add("the believed heading", belief_.pose.heading_rad);
    add("the believed forward speed", belief_.moving.forward);
    add("the believed lateral speed", belief_.moving.lateral);
    add("the believed turn rate", belief_.moving.turn);
  }

 private:
  void drive(const Motion& moving) {
    Pose& pose = truth_.pose;
    const Vector2 to = point_of(pose, {moving.forward * kStep, moving.lateral * kStep});
    pose = {to.x, to.y, wrap_angle(pose.heading_rad + moving.turn * kStep)};
    truth_.moving = moving;
  }

  const Input& input_;
  const Declaration& declaration_;
  const Settings settings_;
  const Elements elements_;
  plugin::Object<Localisation> localisation_;
  Random random_;
  Belief truth_;
  Belief belief_;
};

}  // namespace

std::unique_ptr<Trial> make_localisation_trial(const TrialSetting& setting) {
  return std::make_unique<LocalisationTrial>(setting);
}

}  // namespace elsie::testing
