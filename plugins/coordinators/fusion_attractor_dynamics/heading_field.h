// A vector field over headings, and where it turns a robot in a while.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <elsie/api/geometry.h>

/// What one behaviour adds to the rate of the heading.
struct Forcelet {
  double psi = 0.0;       // rad, from the present heading
  double strength = 0.0;  // 1/s
  double sigma = 1.0;     // rad, of a repeller
  bool repels = false;

  double range(double off) const { return std::exp(-0.5 * off * off / (sigma * sigma)); }
  /// rad/s, at a heading that differs from the present one.
  double at(double heading) const {
    const double off = elsie::wrap_angle(heading - psi);
    return strength * (repels ? off * range(off) : -std::sin(off));
  }
};

class HeadingField {
 public:
  std::vector<Forcelet> forcelets;

  /// The rate of the heading, rad/s.
  double at(double heading) const {
    double rate = 0.0;
    for (const Forcelet& forcelet : forcelets) {
      rate += forcelet.strength > 0.0 ? forcelet.at(heading) : 0.0;
    }
    return rate;
  }

  /// 1/s, at the present heading.
  double slope() const {
    constexpr double kStep = 1e-4;  // rad
    return (at(kStep) - at(-kStep)) / (2.0 * kStep);
  }

  /// The change of the heading in this time, rad, by the method of Runge and Kutta. Its steps are
  /// short for the strongest field, so that it is true of long control periods, too.
  double turned(double seconds) const {
    double strengths = 0.0;
    for (const Forcelet& forcelet : forcelets) {
      strengths += forcelet.strength;
    }
    const double steps = std::ceil(seconds * std::clamp(5.0 * strengths, 200.0, 1e4));
    const double h = seconds / steps;
    double heading = 0.0;
    for (int k = 0; k < static_cast<int>(steps); ++k) {
      const double a = at(heading);
      const double b = at(heading + 0.5 * h * a);
      const double c = at(heading + 0.5 * h * b);
      const double d = at(heading + h * c);
      heading += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
    }
    return heading;
  }
};
