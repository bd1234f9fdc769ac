// Vectors and small matrices in the plane.
#pragma once

#include <cmath>

#include "elsie/api/geometry.h"

namespace elsie::physics {

inline Vector2 plus(const Vector2& a, const Vector2& b) { return {a.x + b.x, a.y + b.y}; }
inline Vector2 minus(const Vector2& a, const Vector2& b) { return {a.x - b.x, a.y - b.y}; }

/// A velocity of a rigid body (m/s, m/s, rad/s), or an impulse on it (N s, N s, N m s).
struct Twist {
  double x = 0.0;
  double y = 0.0;
  double turn = 0.0;

  friend bool operator==(const Twist&, const Twist&) = default;
  friend Twist operator+(const Twist& a, const Twist& b) {
    return {a.x + b.x, a.y + b.y, a.turn + b.turn};
  }
  friend Twist operator*(double s, const Twist& t) { return {s * t.x, s * t.y, s * t.turn}; }
};

inline double dot(const Twist& a, const Twist& b) {
  return a.x * b.x + a.y * b.y + a.turn * b.turn;
}

/// The cosine and sine of an angle.
struct Direction {
  double c = 1.0;
  double s = 0.0;

  static Direction of(double angle_rad) { return {std::cos(angle_rad), std::sin(angle_rad)}; }
  Vector2 turn(const Vector2& v) const { return {c * v.x - s * v.y, s * v.x + c * v.y}; }
  Vector2 turn_back(const Vector2& v) const { return {c * v.x + s * v.y, c * v.y - s * v.x}; }
  Twist turn(const Twist& t) const { return {c * t.x - s * t.y, s * t.x + c * t.y, t.turn}; }
  Twist turn_back(const Twist& t) const { return {c * t.x + s * t.y, c * t.y - s * t.x, t.turn}; }
  /// This direction turned by another one.
  Direction turned(const Direction& by) const { return {c * by.c - s * by.s, s * by.c + c * by.s}; }
  /// This direction with length one, after small rounding errors (a step of Newton's method).
  Direction normal() const {
    const double factor = 1.5 - 0.5 * (c * c + s * s);
    return {factor * c, factor * s};
  }
};

/// Where a body is.
struct Placement {
  Vector2 place;  // of its origin
  Direction ahead;
};

/// The sine of h, the cosine of h and sin(h) / h.
struct HalfTurn {
  double s, c, sinc;

  explicit HalfTurn(double h) {
    const double q = h * h;
    if (q < 0.01) {  // the next terms are below the rounding
      constexpr auto part = [](int n) { return 1.0 / static_cast<double>(n * (n + 1)); };
      const auto less = [q](double of, double rest) { return 1.0 - of * q * rest; };
      sinc = less(part(2), less(part(4), less(part(6), less(part(8), less(part(10), 1.0)))));
      s = h * sinc;
      c = less(part(1), less(part(3), less(part(5), less(part(7), less(part(9), 1.0)))));
    } else {
      s = std::sin(h);
      c = std::cos(h);
      sinc = s / h;
    }
  }
  Direction half() const { return {c, s}; }
  Direction whole() const { return {1.0 - 2.0 * s * s, 2.0 * s * c}; }
};

/// A symmetric matrix over twists.
struct Symmetric {
  double xx = 0.0, xy = 0.0, yy = 0.0, xt = 0.0, yt = 0.0, tt = 0.0;

  friend Symmetric operator+(const Symmetric& a, const Symmetric& b) {
    return {a.xx + b.xx, a.xy + b.xy, a.yy + b.yy, a.xt + b.xt, a.yt + b.yt, a.tt + b.tt};
  }
  friend Twist operator*(const Symmetric& m, const Twist& t) {
    return {m.xx * t.x + m.xy * t.y + m.xt * t.turn, m.xy * t.x + m.yy * t.y + m.yt * t.turn,
            m.xt * t.x + m.yt * t.y + m.tt * t.turn};
  }
  /// Adds factor t t'.
  void add(double factor, const Twist& t) {
    const double x = factor * t.x, y = factor * t.y;
    xx += x * t.x;
    xy += x * t.y;
    yy += y * t.y;
    xt += x * t.turn;
    yt += y * t.turn;
    tt += factor * t.turn * t.turn;
  }
  /// The inverse of a positive definite matrix, by factors, so that very unlike numbers keep their
  /// digits.
  Symmetric inverse() const;
  /// The same matrix with the axes of x and y turned by `by`.
  Symmetric turned(const Direction& by) const {
    const double c = by.c, s = by.s, both = c * s * (xx - yy);
    return {c * c * xx - 2.0 * c * s * xy + s * s * yy,
            both + (c * c - s * s) * xy,
            s * s * xx + 2.0 * c * s * xy + c * c * yy,
            c * xt - s * yt,
            s * xt + c * yt,
            tt};
  }
};

inline Symmetric Symmetric::inverse() const {
  // L D L' with ones in the diagonal of L, and the inverse of L.
  const double i1 = 1.0 / xx, l21 = xy * i1, l31 = xt * i1;
  const double i2 = 1.0 / (yy - l21 * xy);
  const double rest = yt - l31 * xy, l32 = rest * i2;
  const double i3 = 1.0 / (tt - l31 * xt - l32 * rest);
  const double p = -l21, r = -l32, q = l21 * l32 - l31;
  return {i1 + p * p * i2 + q * q * i3, p * i2 + q * r * i3, i2 + r * r * i3, q * i3, r * i3, i3};
}

}  // namespace elsie::physics
