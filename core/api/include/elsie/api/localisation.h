// A localisation: what a robot believes of its own place and motion.
//
// It stands in the element <localisation> of a robot. Behaviours, coordinators and mates get what
// it answers, as OwnState::pose and moving; sensors, measures and goals use the truth. Without the
// element the robot believes the truth.
#pragma once

#include <span>

#include "elsie/api/body.h"
#include "elsie/api/component.h"
#include "elsie/api/geometry.h"
#include "elsie/api/motion.h"
#include "elsie/api/registration.h"
#include "elsie/base/random.h"

namespace elsie {

/// What a robot believes.
struct Belief {
  Pose pose;
  Motion moving;

  friend bool operator==(const Belief&, const Belief&) = default;
};

/// One instant, after a step in which the robot moved.
struct LocalisationContext {
  double time_s = 0.0;
  double step_s = 0.0;                   // since the last call
  const Belief& truth;                   // an estimate adds its own error
  Motion odometry;                       // from the joints of its drive: if no wheel slips
  std::span<const JointSetting> joints;  // measured; those that can be set
  WheelPair wheels;                      // of the equivalent differential drive
  Random* random = nullptr;              // its own stream
};

class Localisation : public Component {
 public:
  /// The belief at the start of a run, after reset(). By default it is the truth.
  virtual Belief start(const Belief& truth, Random& /*random*/) { return truth; }
  /// The belief after a step; `before` is the last one. Called once in every step.
  virtual Belief update(const Belief& before, const LocalisationContext& now) = 0;
  /// The belief after an edit has placed the robot elsewhere. By default the robot does not notice.
  virtual Belief placed(const Belief& before, const Belief& /*truth*/) { return before; }
};

/// Makes a localisation class a plugin; see ELSIE_BEHAVIOR.
#define ELSIE_LOCALISATION(Class, ...) \
  ELSIE_REGISTER_PLUGIN_(::elsie::PluginKind::localisation, Class, __VA_ARGS__)

}  // namespace elsie
