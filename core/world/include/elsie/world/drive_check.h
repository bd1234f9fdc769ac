// Checks the answers of a drive.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "elsie/api/drive.h"

namespace elsie::world {

/// Compares the answers of a drive with the limits of the body that it built.
class DriveCheck {
 public:
  DriveCheck() = default;
  explicit DriveCheck(const BodyPlan& plan);

  /// The number of joints that the drive sets.
  std::size_t joints() const { return limits_.size(); }
  /// The error in an answer of Drive::command(), which returned `possible` and set `joints`:
  /// "a wheel rolls at 1 m/s, and the most is 0.5 m/s". "" if there is none.
  std::string problem(const Drive& drive, const Motion& possible, double max_speed,
                      std::span<const JointSetting> joints) const;

 private:
  struct Limit {
    double radius = 0.0;     // m, of a wheel
    double angle_rad = 0.0;  // the largest to either side
  };

  std::vector<Limit> limits_;
};

/// A motion in words: "(0.1 m/s, 0 m/s, 2 rad/s)".
std::string motion_text(const Motion& motion);
/// Whether two motions are equal up to rounding.
bool is_near(const Motion& a, const Motion& b);

}  // namespace elsie::world
