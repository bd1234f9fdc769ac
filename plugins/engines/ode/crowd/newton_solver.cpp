#include "newton_solver.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "eigen_vectors.h"

namespace elsie::physics {
namespace {

// Ten are usual. A train of very light segments that is thrown about may need a hundred, but the
// later ones bring little.
constexpr int kMostIterations = 40;

// An iteration that can lower f by no more than this share of what another one could is the last.
constexpr double kTolerance = 1e-18;

// The least softness of a row, in terms of the velocity that an impulse would give to its bodies
// without other rows. With stiffer ones, rounding would hide the motion of a whole chain.
constexpr double kLeastSoftness = 1e-9;

std::size_t place(int index) { return static_cast<std::size_t>(index); }

}  // namespace

void NewtonSolver::solve(ImpulseSolver& problem) {
  add_blocks(problem);
  terms_.clear();
  for (const Row& row : problem.rows()) add_term(problem, row);
  lay_out();
  now_ = start_;
  const std::span<const Row> rows = problem.rows();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].normal != ImpulseSolver::kNone) terms_[i].lower = terms_[i].upper = 0.0;
  }
  minimize();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].normal == ImpulseSolver::kNone) continue;
    terms_[i].upper = rows[i].mu * terms_[place(rows[i].normal)].impulse();
    terms_[i].lower = -terms_[i].upper;
  }
  minimize();
  write(problem);
}

void NewtonSolver::add_blocks(const ImpulseSolver& problem) {
  blocks_.clear();
  block_of_.clear();
  for (const ImpulseSolver::Body& body : problem.bodies()) {
    const bool moves = body.inverse_mass > 0.0;
    block_of_.push_back(moves ? static_cast<int>(blocks_.size()) : -1);
    if (!moves) continue;
    Block& block = blocks_.emplace_back();
    block.mass = 1.0 / body.inverse_mass;
    Eigen::Matrix3d inverse;  // it is symmetric
    inverse << to_eigen(body.inverse_inertia[0]), to_eigen(body.inverse_inertia[1]),
        to_eigen(body.inverse_inertia[2]);
    block.inertia = inverse.inverse();
  }
  const std::span<const ImpulseSolver::Spin> spins = problem.spins();
  for (const ImpulseSolver::Spin& spin : spins) ++blocks_[place(block_of_[place(spin.body)])].size;
  int size = 0;
  std::vector<int> next;  // place of a spin, in each block
  for (Block& block : blocks_) {
    block.at = size;
    next.push_back(size + 6);
    size += block.size;
  }
  start_.resize(size);
  spin_inertias_.setZero(size);
  for (std::size_t i = 0; i < block_of_.size(); ++i) {
    if (block_of_[i] < 0) continue;
    const Block& block = blocks_[place(block_of_[i])];
    const ImpulseSolver::Body& body = problem.body(static_cast<int>(i));
    start_.segment<3>(block.at) = to_eigen(body.velocity);
    start_.segment<3>(block.at + 3) = to_eigen(body.turning);
  }
  place_of_.clear();
  for (const ImpulseSolver::Spin& spin : spins) {
    const int at = next[place(block_of_[place(spin.body)])]++;
    place_of_.push_back(at);
    start_[at] = spin.rate;
    spin_inertias_[at] = 1.0 / spin.inverse_inertia;
  }
}

NewtonSolver::Side NewtonSolver::side_of(const ImpulseSolver& problem, const Arm& arm,
                                         Term& term) const {
  Side side;
  if (arm.body == ImpulseSolver::kNone) return side;
  const ImpulseSolver::Body& body = problem.body(arm.body);
  side.block = block_of_[place(arm.body)];
  if (side.block < 0) {
    term.target -= dot(arm.linear, body.velocity) + dot(arm.turn, body.turning);
    return side;
  }
  const auto enter = [&](int at, double factor) {
    side.at[place(side.count)] = at;
    side.factors[place(side.count++)] = factor;
  };
  const int at = blocks_[place(side.block)].at;
  for (const Vector3& some : {arm.linear, arm.turn}) {
    for (const double factor : {some.x, some.y, some.z}) enter(at + side.count, factor);
  }
  const auto& inertia = body.inverse_inertia;
  const Vector3 turned{dot(inertia[0], arm.turn), dot(inertia[1], arm.turn),
                       dot(inertia[2], arm.turn)};
  term.inverse_mass += body.inverse_mass * dot(arm.linear, arm.linear) + dot(arm.turn, turned);
  if (arm.spin == ImpulseSolver::kNone) return side;
  enter(place_of_[place(arm.spin)], arm.roll);
  term.inverse_mass += arm.roll * arm.roll * problem.spin(arm.spin).inverse_inertia;
  return side;
}

void NewtonSolver::add_term(const ImpulseSolver& problem, const Row& row) {
  Term& term = terms_.emplace_back();
  term.target = row.target;
  term.lower = row.lower;
  term.upper = row.upper;
  term.a = side_of(problem, {row.a, row.linear, row.turn_a, row.spin_a, row.roll_a}, term);
  term.b = side_of(problem, {row.b, -1.0 * row.linear, row.turn_b, row.spin_b, row.roll_b}, term);
  if (term.a.block < term.b.block) std::swap(term.a, term.b);
  term.softness = std::max(row.softness, kLeastSoftness * term.inverse_mass);
}

/// Gives every number of the matrix its place. Those in the columns of a block: its own, then of
/// each later block with which it shares a row.
void NewtonSolver::lay_out() {
  links_.clear();
  for (const Term& term : terms_) {
    if (term.b.block >= 0 && term.a.block != term.b.block) {
      links_.push_back({term.b.block, term.a.block, 0});
    }
  }
  std::sort(links_.begin(), links_.end());
  links_.erase(std::unique(links_.begin(), links_.end()), links_.end());
  std::vector<int> layout{static_cast<int>(blocks_.size())};
  for (const Block& block : blocks_) layout.push_back(block.size);
  for (const Link& link : links_) layout.insert(layout.end(), {link.low, link.high});
  const bool is_known = layout == layout_;
  layout_ = std::move(layout);

  std::vector<int> rows;
  std::vector<int> ends;  // of the columns
  auto link = links_.begin();
  const auto add_rows = [&rows](const Block& block) {
    for (int i = 0; i < block.size; ++i) rows.push_back(block.at + i);
  };
  ends.push_back(0);
  for (std::size_t low = 0; low < blocks_.size(); ++low) {
    const auto first = link;
    for (int column = 0; column < blocks_[low].size; ++column) {
      const std::size_t begin = rows.size();
      add_rows(blocks_[low]);
      for (link = first; link != links_.end() && place(link->low) == low; ++link) {
        link->offset = static_cast<std::ptrdiff_t>(rows.size() - begin);
        add_rows(blocks_[place(link->high)]);
      }
      ends.push_back(static_cast<int>(rows.size()));
    }
  }
  for (Term& term : terms_) {
    if (term.b.block < 0 || term.a.block == term.b.block) continue;
    const auto found =
        std::lower_bound(links_.begin(), links_.end(), Link{term.b.block, term.a.block, 0},
                         [](const Link& x, const Link& y) {
                           return x.low != y.low ? x.low < y.low : x.high < y.high;
                         });
    term.offset = found->offset;
  }
  if (is_known) return;
  matrix_.resize(start_.size(), start_.size());
  matrix_.resizeNonZeros(static_cast<Eigen::Index>(rows.size()));
  std::copy(rows.begin(), rows.end(), matrix_.innerIndexPtr());
  std::copy(ends.begin(), ends.end(), matrix_.outerIndexPtr());
  factors_.analyzePattern(matrix_);
}

double NewtonSolver::Term::product(const Vector& v) const {
  double sum = 0.0;
  for (const Side* side : {&a, &b}) {
    for (std::size_t i = 0; i < place(side->count); ++i) sum += side->factors[i] * v[side->at[i]];
  }
  return sum;
}

void NewtonSolver::Term::add(double times, Vector& to) const {
  for (const Side* side : {&a, &b}) {
    for (std::size_t i = 0; i < place(side->count); ++i) {
      to[side->at[i]] += times * side->factors[i];
    }
  }
}

/// Adds a term's curvature to the matrix.
void NewtonSolver::add_square(const Term& term) {
  const double stiffness = 1.0 / term.softness;
  const auto add = [&](const Side& across, const Side& down, std::ptrdiff_t offset) {
    if (across.block < 0 || down.block < 0) return;
    const int first = blocks_[place(down.block)].at;
    for (std::size_t j = 0; j < place(across.count); ++j) {
      double* const column = matrix_.valuePtr() + matrix_.outerIndexPtr()[across.at[j]] + offset;
      const double factor = stiffness * across.factors[j];
      for (std::size_t i = 0; i < place(down.count); ++i) {
        column[down.at[i] - first] += factor * down.factors[i];
      }
    }
  };
  add(term.a, term.a, 0);
  add(term.b, term.b, 0);
  add(term.b, term.a, term.offset);
}

/// The matrix and the gradient at the present velocities.
void NewtonSolver::differentiate() {
  std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), 0.0);
  const Vector gained = now_ - start_;
  gradient_ = spin_inertias_.cwiseProduct(gained);
  for (const Block& block : blocks_) {
    for (int i = 0; i < block.size; ++i) {
      double* const column = matrix_.valuePtr() + matrix_.outerIndexPtr()[block.at + i];
      if (i < 3) column[i] = block.mass;
      if (i >= 3 && i < 6) Eigen::Map<Eigen::Vector3d>(column + 3) = block.inertia.col(i - 3);
      if (i >= 6) column[i] = spin_inertias_[block.at + i];
    }
    gradient_.segment<3>(block.at) = block.mass * gained.segment<3>(block.at);
    gradient_.segment<3>(block.at + 3) = block.inertia * gained.segment<3>(block.at + 3);
  }
  for (Term& term : terms_) {
    term.error = term.target - term.product(now_);
    const double impulse = term.impulse();
    term.add(-impulse, gradient_);
    if (impulse > term.lower && impulse < term.upper) add_square(term);
  }
}

void NewtonSolver::minimize() {
  double most = 0.0;
  for (int i = 0; i < kMostIterations; ++i) {
    differentiate();
    factors_.factorize(matrix_);
    if (factors_.info() != Eigen::Success) break;  // a velocity is not finite
    step_ = -factors_.solve(gradient_);
    const double slope = gradient_.dot(step_);
    if (!(slope < 0.0)) break;
    most = std::max(most, -slope);
    for (Term& term : terms_) term.change = term.product(step_);
    const auto [length, is_last] = line_search(slope);
    now_ += length * step_;
    if (is_last || -slope <= kTolerance * most) break;
  }
  for (Term& term : terms_) term.error = term.target - term.product(now_);
}

/// How many steps it is to the minimum of f along the step, and whether f is one parabola up to
/// there.
std::pair<double, bool> NewtonSolver::line_search(double slope) {
  bends_.clear();
  // Without bends the minimum is after one step.
  double curvature = -slope;
  for (const Term& term : terms_) {
    if (term.change == 0.0) continue;
    double in = (term.error - term.softness * term.lower) / term.change;
    double out = (term.error - term.softness * term.upper) / term.change;
    if (in > out) std::swap(in, out);
    const double bend = term.change * term.change / term.softness;
    const double impulse = term.impulse();
    const bool is_free = impulse > term.lower && impulse < term.upper;
    if (is_free || (out > 0.0 && in < out)) {
      if (!is_free) bends_.emplace_back(std::max(0.0, in), bend);
      if (std::isfinite(out)) bends_.emplace_back(out, -bend);  // else it has no limit there
    }
  }
  std::sort(bends_.begin(), bends_.end());
  double at = 0.0;
  bool is_straight = true;
  for (const auto& [bend, change] : bends_) {
    const double reached = slope + curvature * (bend - at);
    if (reached >= 0.0) break;
    is_straight = false;
    slope = reached;
    at = bend;
    curvature += change;
  }
  // Rounding may leave nothing of the curvature after many bends.
  return {curvature > 0.0 ? at - slope / curvature : at, is_straight};
}

void NewtonSolver::write(ImpulseSolver& problem) const {
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    problem.row(static_cast<int>(i)).impulse = terms_[i].impulse();
  }
  for (std::size_t i = 0; i < block_of_.size(); ++i) {
    if (block_of_[i] < 0) continue;
    const Block& block = blocks_[place(block_of_[i])];
    ImpulseSolver::Body& body = problem.body(static_cast<int>(i));
    body.velocity = from_eigen(now_.segment<3>(block.at));
    body.turning = from_eigen(now_.segment<3>(block.at + 3));
  }
  for (std::size_t i = 0; i < place_of_.size(); ++i) {
    problem.spin(static_cast<int>(i)).rate = now_[place_of_[i]];
  }
}

}  // namespace elsie::physics
