// Shared by the tests of measures.
#pragma once

#include <string>

#include "elsie/testing/catch.h"

namespace elsie::test {

using testing::Measure;
using testing::Scene;
using testing::Settings;

/// The message of a measure that refuses a world; "" otherwise.
inline std::string refusal(Measure measure, const Scene& start) {
  try {
    measure.equip(start);
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

/// Three robots in two teams; r1 leads the red one.
inline Scene three_robots() {
  Scene now;
  now.robot("r1").leads().robot("r2", 1, 0).robot("b1", -1, 0, "blue");
  return now;
}

}  // namespace elsie::test
