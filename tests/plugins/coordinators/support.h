// Coordinators with their teams.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/testing/coordinator.h"

#include "shipped.h"
#include "situation.h"
#include "wheels.h"

namespace elsie::test {

inline void check_near(const Motion& command, const Motion& expected, double within = 1e-9) {
  CHECK(rates(command).left == Approx(rates(expected).left).margin(within));
  CHECK(rates(command).right == Approx(rates(expected).right).margin(within));
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
