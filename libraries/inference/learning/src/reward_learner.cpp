#include "elsie/learning/reward_learner.h"

namespace elsie::learning {

// Defined here, so that all libraries share the class's type information.
RewardLearner::~RewardLearner() = default;

}  // namespace elsie::learning
