// Motions as the wheel rates of a robot with the default body, which tests think in.
#pragma once

#include "elsie/api/motion.h"
#include "elsie/files/rounded.h"

namespace elsie::test {

/// The motion of wheels at these rates, rad/s.
inline Motion wheels(double left, double right) { return WheelPair().motion({left, right}); }

/// The wheel rates of a motion, without the rounding of the way there and back.
inline WheelRates rates(const Motion& motion) {
  const WheelRates exact = WheelPair().wheel_rates(motion);
  return {files::rounded(exact.left, 9), files::rounded(exact.right, 9)};
}

}  // namespace elsie::test
