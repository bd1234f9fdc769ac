#include <cmath>
#include <string>
#include <vector>

#include "elsie/api/drive.h"
#include "elsie/physics/engine.h"
#include "elsie/plugin/parameters.h"
#include "elsie/world/drive_check.h"
#include "elsie/world/parts.h"

#include "text.h"
#include "trial.h"

namespace elsie::testing {
namespace {

constexpr double kDrivePeriod = 0.01;  // s

/// Asks a drive for random motions; its joints always come where it sets them.
class DriveTrial final : public Trial {
 public:
  explicit DriveTrial(const TrialSetting& setting)
      : input_(setting.input),
        declaration_(setting.declaration),
        settings_(setting.plugins.completed(setting.declaration, setting.settings)),
        elements_(setting.elements),
        drive_(setting.plugins.host().create<Drive>(PluginKind::drive, declaration_.name)) {
    plugin::apply_parameters(declaration_, *drive_, settings_, elements_);
    build();
  }

  Component& object() override { return *drive_; }
  void reset(std::uint64_t seed) override {
    random_ = Random(seed);
    drive_->reset(random_);
    drive_->notes();
    drive_->curves();
    joints_.assign(check_.joints(), {});
    const auto engine = physics::make_engine({}, {});
    try {
      engine->add_robot(plan_, {});
    } catch (const std::invalid_argument& refused) {
      throw Wrong(std::string("build() makes a body that physics refuses: ") + refused.what());
    }
    const WheelPair pair = drive_->wheels(input_.chassis);
    if (!(pair.radius > 0.0 && pair.half_axle > 0.0 &&
          std::isfinite(pair.radius + pair.half_axle))) {
      throw Wrong("wheels() gives a pair of wheels whose sizes are not positive and finite");
    }
  }
  bool take_over(Trial& /*before*/) override { return false; }
  void configure_again() override {
    plugin::apply_parameters(declaration_, *drive_, settings_, elements_);
    build();
  }

  void step(std::size_t step, Answer& answer) override {
    const Motion& asked = input_.asked[step % input_.asked.size()];
    const std::vector<JointSetting> before = joints_;
    const DriveState now{before, input_.max_speed, kDrivePeriod, &random_};
    const Motion possible = drive_->command(asked, now, joints_);
    answer.clear();
    add("forward", possible.forward, answer);
    add("lateral", possible.lateral, answer);
    add("turn", possible.turn, answer);
    for (const JointSetting& joint : joints_) {
      add("the rate of a joint", joint.rate_rad_s, answer);
      add("the angle of a joint", joint.angle_rad, answer);
      add("the turn rate of a joint", joint.turn_rad_s, answer);
    }
    const Turret turret = drive_->turret(joints_);
    add("the angle of its turret", turret.angle_rad, answer);
    add("the turn rate of its turret", turret.turn_rad_s, answer);
    if (const auto problem = check_.problem(*drive_, possible, input_.max_speed, joints_);
        !problem.empty()) {
      throw Wrong(problem);
    }
    std::vector<JointSetting> again = joints_;
    const Motion repeated = drive_->command(possible, now, again);
    if (!world::is_near(repeated, possible)) {
      throw Wrong("command() for the motion that it returned is " + world::motion_text(repeated) +
                  ", and command() returned " + world::motion_text(possible));
    }
  }

 private:
  void build() {
    equipping([&] { plan_ = world::plan_of(input_.chassis, *drive_); });
    check_ = world::DriveCheck(plan_);
    joints_.assign(check_.joints(), {});
  }

  static void add(const char* name, double value, Answer& answer) {
    require_finite(name, value);
    answer.add(name, value);
  }

  const Input& input_;
  const Declaration& declaration_;
  const Settings settings_;
  const Elements elements_;
  plugin::Object<Drive> drive_;
  Random random_;
  BodyPlan plan_;
  world::DriveCheck check_;
  std::vector<JointSetting> joints_;
};

}  // namespace

std::unique_ptr<Trial> make_drive_trial(const TrialSetting& setting) {
  return std::make_unique<DriveTrial>(setting);
}

}  // namespace elsie::testing
