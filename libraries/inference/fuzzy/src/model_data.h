// A model in the form that inference uses.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "elsie/fuzzy/model.h"

#include "formula.h"

namespace elsie::fuzzy {

/// The degree to which one input is (or is not) one of its terms.
struct Leaf {
  /// A point of the membership function, and the straight line to the next point. The line is
  /// anchored at its lower end, so that rounding never makes a positive degree zero.
  struct Knot {
    double x;
    double degree;  // at x itself
    double anchor_x;
    double anchor_degree;
    double slope;
    double cap;  // the line's higher end

    /// The line at x.
    double line(double at) const { return std::min(cap, anchor_degree + slope * (at - anchor_x)); }
  };

  Leaf(std::size_t input_index, const FuzzySet& set);

  double degree(double x) const;
  /// Just right and just left of x: these differ at a step.
  double after(double x) const;
  double before(double x) const;

  std::size_t input;
  double first;  // left of all knots
  double last;   // right of all knots
  std::vector<Knot> knots;
};

/// The operators of conditions. De Morgan's laws move negations into the leaves, so each operator
/// has its dual (min and max, product and algebraic sum, bounded difference and bounded sum).
enum class Operator : std::uint8_t {
  leaf,
  min,
  product,
  bounded_difference,
  max,
  algebraic_sum,
  bounded_sum
};

/// a AND b, a OR b.
double combine(Operator op, double a, double b);

/// A condition in postfix order: a leaf pushes its degree, an operator takes `argument` degrees
/// and pushes one.
struct Instruction {
  Operator op = Operator::leaf;
  std::size_t argument = 0;  // index of the leaf, or number of operands
};

/// An output's term as a target of conclusions, whose degrees are combined here. Which conclusions
/// share a slot depends on the accumulation.
struct Slot {
  std::size_t term = 0;
  bool scales = false;  // ACT: PROD; else cuts off
};

struct Target {
  std::size_t output = 0;
  std::size_t slot = 0;  // index among all slots of the model
  std::string hedges;    // applied to the rule's degree
};

struct CompiledRule {
  std::vector<Instruction> condition;
  bool all_min = false;  // only leaves, combined by min
  double weight = 1.0;
  std::vector<Target> targets;
};

/// All terms of an output are straight lines between two neighbouring points of any of them.
struct Cell {
  double x0 = 0.0;
  double x1 = 0.0;
  std::size_t first_line = 0;
  std::size_t end_line = 0;
};

/// A term in a cell in which it is not zero everywhere.
struct Line {
  double y0 = 0.0;
  double y1 = 0.0;
  std::size_t first_slot = 0;  // the slots of this term
  std::size_t end_slot = 0;
};

struct CompiledOutput {
  std::size_t first_slot = 0;
  std::size_t end_slot = 0;
  std::vector<Cell> cells;  // ascending, without gaps, over the whole range
  std::vector<Line> lines;
  bool singletons = false;
};

struct ModelData {
  std::string name;
  std::vector<Variable> inputs;
  std::vector<OutputVariable> outputs;
  std::vector<Rule> rules;
  std::vector<Problem> notes;
  /// By output and index, for terms that are formulas.
  std::map<std::pair<std::size_t, std::size_t>, Formula> formulas;

  std::vector<Leaf> leaves;
  std::vector<CompiledRule> compiled_rules;  // one for each of `rules`
  std::vector<CompiledOutput> compiled_outputs;
  std::vector<Slot> slots;
  std::size_t stack_depth = 0;
  std::size_t most_slots = 0;  // of one output
};

}  // namespace elsie::fuzzy
