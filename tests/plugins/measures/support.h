// What the tests of measures have in common.
#pragma once

#include <string>

#include "elsie/testing/catch.h"

namespace elsie::test {

using testing::Measure;
using testing::Scene;
using testing::Settings;

/// What a measure says when it is told of a world.
inline std::string refusal(Measure measure, const Scene& start) {
  try {
    measure.equip(start);
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

/// Three robots in two teams, of which r1 leads the red one.
inline Scene three_robots() {
  Scene now;
  now.robot("r1").leads().robot("r2", 1, 0).robot("b1", -1, 0, "blue");
  return now;
}

}  // namespace elsie::test
