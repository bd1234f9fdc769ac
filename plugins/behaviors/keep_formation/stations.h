// The places of a leader's followers in a formation (Balch and Arkin 1998).
#pragma once

#include <string>

#include <elsie/api/geometry.h>

/// The place of follower `slot` (from 1) in the leader's frame (x ahead, y to the left), m:
///
///   line     1 and 2 to the left and right of the leader, 3 and 4 beyond them...
///   column   one behind the other
///   wedge    like the line, each pair one spacing farther back
///   diamond  1 and 2 one spacing back to the left and right, 3 two back in the middle; every
///            three more form another diamond behind
inline elsie::Vector2 station(const std::string& formation, int slot, double spacing_m) {
  const int pair = (slot + 1) / 2;
  const double side = slot % 2 == 1 ? 1.0 : -1.0;
  if (formation == "line") {
    return {0.0, side * pair * spacing_m};
  }
  if (formation == "column") {
    return {-slot * spacing_m, 0.0};
  }
  if (formation == "wedge") {
    return {-pair * spacing_m, side * pair * spacing_m};
  }
  const int diamonds_ahead = (slot - 1) / 3;
  const int place = (slot - 1) % 3;
  const double back = 2.0 * diamonds_ahead + (place == 2 ? 2.0 : 1.0);
  return {-back * spacing_m, place == 2 ? 0.0 : (place == 0 ? 1.0 : -1.0) * spacing_m};
}
