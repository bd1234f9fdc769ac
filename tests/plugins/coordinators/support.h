// Coordinators with their teams.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/testing/coordinator.h"

#include "shipped.h"
#include "situation.h"

namespace elsie::test {

inline void check_near(const MotorCommand& command, const MotorCommand& expected,
                       double within = 1e-9) {
  CHECK(command.left == Approx(expected.left).margin(within));
  CHECK(command.right == Approx(expected.right).margin(within));
}

/// A team with its shipped coordinator, ready to run; throws at once when they do not fit.
class Coordinated : public testing::Coordinator {
 public:
  Coordinated(const char* coordinator, Team& team, Parameters parameters = {},
              const std::vector<ElementValue>& elements = {})
      : testing::Coordinator(coordinator, team, parameters, elements) {
    equip(now);
    reset();
  }
};

}  // namespace elsie::test
