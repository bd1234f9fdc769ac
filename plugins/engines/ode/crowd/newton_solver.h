// An exact solver for long chains of bodies.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include "impulse_solver.h"

namespace elsie::physics {

/// Solves the rows of an ImpulseSolver exactly. Each sweep over the rows carries a pull only a few
/// segments further, so that a train of a hundred would need thousands.
///
/// The velocities v that satisfy the rows within the limits of their impulses minimize
///
///   f(v) = 1/2 (v - v0)' M (v - v0) + sum of p_i(target_i - J_i v),
///
/// where M has the masses, v0 the velocities before, and p_i is the energy that row i stores: a
/// parabola of curvature 1 / softness_i, continued as a straight line from where its impulse, the
/// derivative, reaches a limit (Todorov, "Convex and analytically-invertible dynamics with contacts
/// and constraints", 2014). f is strictly convex and consists of parabolas, so Newton's method with
/// an exact line search lowers it in each iteration, and ends at the minimum after a few of them.
///
/// An iteration solves with the matrix M + sum of J_i' J_i / softness_i over the rows within their
/// limits. It is positive definite however redundant the rows are, which the matrix of the dual
/// problem, J M^-1 J' + softness, is only by the softness. It is sparse: a chain has one block for
/// each body and one for each joint, and the cost grows with their number.
///
/// Friction is limited by the pressures that there would be without it, as in ODE's dWorldStep().
class NewtonSolver {
 public:
  /// Changes the velocities and rates so that the rows hold, and sets the impulses of the rows.
  void solve(ImpulseSolver& problem);

 private:
  using Row = ImpulseSolver::Row;
  using Vector = Eigen::VectorXd;

  /// A body that can be moved: six numbers in v from `at` on, then the rates of its wheels.
  struct Block {
    int at = 0;
    int size = 6;
    double mass = 0.0;        // kg
    Eigen::Matrix3d inertia;  // kg m2
  };
  /// One end of a row.
  struct Arm {
    int body;
    Vector3 linear, turn;
    int spin;
    double roll;
  };
  /// The factors of a row for the numbers of one block.
  struct Side {
    int block = -1;  // none: nothing that can be moved
    int count = 0;
    std::array<int, 7> at{};  // in v
    std::array<double, 7> factors{};
  };
  struct Term {
    Side a, b;                  // a's block is not before b's
    std::ptrdiff_t offset = 0;  // of a's block in the columns of b's
    double target = 0.0;
    double softness = 0.0;
    double inverse_mass = 0.0;  // J M^-1 J'
    double lower = 0.0, upper = 0.0;
    double error = 0.0;   // target - J v
    double change = 0.0;  // J d, where d is the step

    double impulse() const { return std::clamp(error / softness, lower, upper); }
    double product(const Vector& v) const;
    void add(double times, Vector& to) const;
  };
  /// Two blocks with a common row.
  struct Link {
    int low, high;
    std::ptrdiff_t offset;                          // of the high one in the columns of the low one
    auto operator<=>(const Link&) const = default;  // NOLINT(modernize-use-nullptr)
  };

  void add_blocks(const ImpulseSolver& problem);
  void add_term(const ImpulseSolver& problem, const Row& row);
  Side side_of(const ImpulseSolver& problem, const Arm& arm, Term& term) const;
  void lay_out();
  void minimize();
  void differentiate();
  void add_square(const Term& term);
  std::pair<double, bool> line_search(double slope);
  void write(ImpulseSolver& problem) const;

  std::vector<int> block_of_;  // of each body; negative: none
  std::vector<int> place_of_;  // of each spin in v
  std::vector<Block> blocks_;
  std::vector<Term> terms_;
  std::vector<Link> links_;
  std::vector<int> layout_;                       // that the matrix has
  std::vector<std::pair<double, double>> bends_;  // of f along a step: where, and by how much
  Vector start_, now_, step_, gradient_;
  Vector spin_inertias_;  // kg m2; 0 where v has no rate of a wheel
  Eigen::SparseMatrix<double> matrix_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors_;
};

}  // namespace elsie::physics
