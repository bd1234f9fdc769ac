#include <cmath>
#include <string>
#include <vector>

#include "elsie/api/drive.h"
#include "elsie/physics/engine.h"
#include "elsie/plugin/parameters.h"
#include "elsie/world/parts.h"

#include "text.h"
#include "trial.h"

namespace elsie::testing {
namespace {

constexpr double kDrivePeriod = 0.01;  // s

bool is_near_motion(double a, double b) { return std::abs(a - b) <= 1e-6 * (1.0 + std::abs(a)); }

std::string motion_words(const Motion& motion) {
  return "(" + number_text(motion.forward) + " m/s, " + number_text(motion.lateral) + " m/s, " +
         number_text(motion.turn) + " rad/s)";
}

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

  void reset(std::uint64_t seed) override {
    random_ = Random(seed);
    drive_->reset(random_);
    drive_->notes();
    drive_->curves();
    joints_.assign(limits_.size(), {});
    const auto engine = physics::make_ode_engine({}, {});
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
    const DriveState now{before, input_.max_speed, kDrivePeriod};
    const Motion possible = drive_->command(asked, now, joints_);
    answer.clear();
    add("forward", possible.forward, answer);
    add("lateral", possible.lateral, answer);
    add("turn", possible.turn, answer);
    for (std::size_t i = 0; i < joints_.size(); ++i) check_joint(i, answer);
    const Turret turret = drive_->turret(joints_);
    add("the angle of its turret", turret.angle_rad, answer);
    add("the turn rate of its turret", turret.turn_rad_s, answer);
    require_same("odometry() of the joints that command() set", drive_->odometry(joints_),
                 possible);
    std::vector<JointSetting> again = joints_;
    require_same("command() for the motion that it returned", drive_->command(possible, now, again),
                 possible);
  }

 private:
  struct Limit {
    double radius = 0.0;  // m, of a wheel
    double angle_rad = 0.0;
  };

  void build() {
    equipping([&] { plan_ = world::plan_of(input_.chassis, *drive_); });
    limits_.clear();
    for (const Part& part : plan_.parts) {
      if (!can_be_set(part.joint)) continue;
      if (const auto* wheel = std::get_if<WheelJoint>(&part.joint)) {
        limits_.push_back({part.shape.radius(), wheel->steered ? wheel->max_steer_rad : 0.0});
      } else if (const auto* hitch = std::get_if<HitchJoint>(&part.joint)) {
        limits_.push_back({0.0, hitch->max_yaw_rad});
      }
    }
    joints_.assign(limits_.size(), {});
  }

  static void add(const char* name, double value, Answer& answer) {
    require_finite(name, value);
    answer.add(name, value);
  }

  void check_joint(std::size_t index, Answer& answer) const {
    const JointSetting& joint = joints_[index];
    const Limit& limit = limits_[index];
    add("the rate of a joint", joint.rate_rad_s, answer);
    add("the angle of a joint", joint.angle_rad, answer);
    add("the turn rate of a joint", joint.turn_rad_s, answer);
    const double rim = std::abs(joint.rate_rad_s) * limit.radius;
    if (rim > input_.max_speed * (1.0 + 1e-9)) {
      throw Wrong("a wheel rolls at " + number_text(rim) + " m/s, and the most is " +
                  number_text(input_.max_speed) + " m/s");
    }
    if (std::abs(joint.angle_rad) > limit.angle_rad + 1e-9) {
      throw Wrong("a joint is turned to " + number_text(joint.angle_rad) +
                  " rad, and its limit is " + number_text(limit.angle_rad) + " rad");
    }
  }

  static void require_same(const std::string& what, const Motion& motion, const Motion& expected) {
    if (!is_near_motion(motion.forward, expected.forward) ||
        !is_near_motion(motion.lateral, expected.lateral) ||
        !is_near_motion(motion.turn, expected.turn)) {
      throw Wrong(what + " is " + motion_words(motion) + ", and command() returned " +
                  motion_words(expected));
    }
  }

  const Input& input_;
  const Declaration& declaration_;
  const Settings settings_;
  const Elements elements_;
  plugin::Object<Drive> drive_;
  Random random_;
  BodyPlan plan_;
  std::vector<Limit> limits_;
  std::vector<JointSetting> joints_;
};

}  // namespace

std::unique_ptr<Trial> make_drive_trial(const TrialSetting& setting) {
  return std::make_unique<DriveTrial>(setting);
}

}  // namespace elsie::testing
