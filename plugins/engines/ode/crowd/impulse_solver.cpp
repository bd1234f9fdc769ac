#include "impulse_solver.h"

#include <algorithm>
#include <cstddef>

namespace elsie::physics {
namespace {

Vector3 product(const std::array<Vector3, 3>& rows, const Vector3& v) {
  return {dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)};
}

void add(Vector3& to, double times, const Vector3& what) {
  to.x += times * what.x;
  to.y += times * what.y;
  to.z += times * what.z;
}

}  // namespace

void ImpulseSolver::clear() {
  bodies_.clear();
  spins_.clear();
  rows_.clear();
}

int ImpulseSolver::add(const Body& body) {
  bodies_.push_back(body);
  return static_cast<int>(bodies_.size()) - 1;
}

int ImpulseSolver::add(const Spin& spin) {
  spins_.push_back(spin);
  return static_cast<int>(spins_.size()) - 1;
}

int ImpulseSolver::add(const Row& row) {
  rows_.push_back(row);
  return static_cast<int>(rows_.size()) - 1;
}

ImpulseSolver::Response ImpulseSolver::response(const Row& row) const {
  Response made;
  double inverse = row.softness;  // of the effective mass, m/s per N s
  if (row.a != kNone) {
    const Body& a = body(row.a);
    made.turn_a = product(a.inverse_inertia, row.turn_a);
    inverse += a.inverse_mass * dot(row.linear, row.linear) + dot(row.turn_a, made.turn_a);
  }
  if (row.b != kNone) {
    const Body& b = body(row.b);
    made.turn_b = product(b.inverse_inertia, row.turn_b);
    inverse += b.inverse_mass * dot(row.linear, row.linear) + dot(row.turn_b, made.turn_b);
  }
  if (row.spin_a != kNone) inverse += row.roll_a * row.roll_a * spin(row.spin_a).inverse_inertia;
  if (row.spin_b != kNone) inverse += row.roll_b * row.roll_b * spin(row.spin_b).inverse_inertia;
  made.mass = inverse > 0.0 ? 1.0 / inverse : 0.0;
  return made;
}

void ImpulseSolver::relax(Row& row, const Response& response) {
  Body* const a = row.a == kNone ? nullptr : &body(row.a);
  Body* const b = row.b == kNone ? nullptr : &body(row.b);
  Spin* const spin_a =
      row.spin_a == kNone ? nullptr : &spins_[static_cast<std::size_t>(row.spin_a)];
  Spin* const spin_b =
      row.spin_b == kNone ? nullptr : &spins_[static_cast<std::size_t>(row.spin_b)];
  double speed = 0.0;
  if (a) speed += dot(row.linear, a->velocity) + dot(row.turn_a, a->turning);
  if (b) speed += dot(row.turn_b, b->turning) - dot(row.linear, b->velocity);
  if (spin_a) speed += row.roll_a * spin_a->rate;
  if (spin_b) speed += row.roll_b * spin_b->rate;
  double lower = row.lower, upper = row.upper;
  if (row.normal != kNone) {
    upper = row.mu * rows_[static_cast<std::size_t>(row.normal)].impulse;
    lower = -upper;
  }
  const double wanted =
      row.impulse + response.mass * (row.target - row.softness * row.impulse - speed);
  const double now = std::clamp(wanted, lower, upper);
  const double more = now - row.impulse;
  row.impulse = now;
  if (a) {
    elsie::physics::add(a->velocity, more * a->inverse_mass, row.linear);
    elsie::physics::add(a->turning, more, response.turn_a);
  }
  if (b) {
    elsie::physics::add(b->velocity, -more * b->inverse_mass, row.linear);
    elsie::physics::add(b->turning, more, response.turn_b);
  }
  if (spin_a) spin_a->rate += more * row.roll_a * spin_a->inverse_inertia;
  if (spin_b) spin_b->rate += more * row.roll_b * spin_b->inverse_inertia;
}

void ImpulseSolver::solve(int sweeps) {
  responses_.clear();
  for (const Row& row : rows_) responses_.push_back(response(row));
  const std::size_t count = rows_.size();
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t at = sweep % 2 == 0 ? i : count - 1 - i;
      relax(rows_[at], responses_[at]);
    }
  }
}

}  // namespace elsie::physics
