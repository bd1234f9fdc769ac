// An iterative solver for many bodies in contact.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "elsie/api/geometry.h"

namespace elsie::physics {

/// Bodies, and rows that constrain their relative velocities. solve() finds the impulses that
/// satisfy the rows: projected Gauss-Seidel (Catto, "Iterative Dynamics with Temporal Coherence",
/// 2005), over all rows in a fixed order, forwards and backwards in turn. The time of a sweep is
/// proportional to the number of rows, and the result depends only on bodies and rows.
///
/// A sweep visits one row after the other and gives each the impulse that satisfies it alone,
///
///   p' = clamp(p + (target - softness p - J v) / (J M^-1 J' + softness), lower, upper),
///   v' = v + M^-1 J' (p' - p).
///
/// Impulses never leave their limits, so an inexact solution stops bodies a little too slowly, but
/// adds no energy.
class ImpulseSolver {
 public:
  static constexpr int kNone = -1;
  static constexpr double kUnlimited = std::numeric_limits<double>::infinity();

  struct Body {
    Vector3 center;
    Vector3 velocity;                          // m/s, of the center
    Vector3 turning;                           // rad/s
    double inverse_mass = 0.0;                 // 1/kg; 0: it cannot be moved
    std::array<Vector3, 3> inverse_inertia{};  // 1/(kg m2), rows, in the world's frame
  };

  /// A wheel, which turns about an axle that a body carries along.
  struct Spin {
    int body = kNone;              // that carries it
    double rate = 0.0;             // rad/s, about the axle, in the world's frame
    double inverse_inertia = 0.0;  // 1/(kg m2)
  };

  /// linear (v_a - v_b) + turn_a w_a + turn_b w_b + roll_a s_a + roll_b s_b
  ///   = target - softness impulse,
  /// unless the impulse would leave its limits.
  struct Row {
    int a = kNone, b = kNone;  // bodies; none: a fixed one
    int spin_a = kNone, spin_b = kNone;
    Vector3 linear, turn_a, turn_b;
    double roll_a = 0.0, roll_b = 0.0;
    double target = 0.0;                             // m/s or rad/s
    double softness = 0.0;                           // m/s per N s, or rad/s per N m s
    double lower = -kUnlimited, upper = kUnlimited;  // N s or N m s
    int normal = kNone;  // friction: the row whose impulse, times mu, is the limit both ways
    double mu = 0.0;
    double impulse = 0.0;  // the result
  };

  void clear();
  int add(const Body& body);
  int add(const Spin& spin);
  int add(const Row& row);

  /// Changes the velocities and rates so that the rows hold.
  void solve(int sweeps);

  Body& body(int index) { return bodies_[static_cast<std::size_t>(index)]; }
  const Body& body(int index) const { return bodies_[static_cast<std::size_t>(index)]; }
  Spin& spin(int index) { return spins_[static_cast<std::size_t>(index)]; }
  const Spin& spin(int index) const { return spins_[static_cast<std::size_t>(index)]; }
  Row& row(int index) { return rows_[static_cast<std::size_t>(index)]; }
  const std::vector<Body>& bodies() const { return bodies_; }
  const std::vector<Spin>& spins() const { return spins_; }
  const std::vector<Row>& rows() const { return rows_; }

 private:
  /// The effect of an impulse of a row on its bodies and spins.
  struct Response {
    Vector3 turn_a, turn_b;  // rad/s per N s
    double mass = 0.0;       // N s per m/s: 1 / (J M^-1 J' + softness)
  };

  Response response(const Row& row) const;
  void relax(Row& row, const Response& response);

  std::vector<Body> bodies_;
  std::vector<Spin> spins_;
  std::vector<Row> rows_;
  std::vector<Response> responses_;
};

}  // namespace elsie::physics
