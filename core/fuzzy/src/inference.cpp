#include "inference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "elsie/fuzzy/sets.h"

#include "pieces.h"

namespace elsie::fuzzy {

namespace {

/// A product of positive degrees stays above zero: otherwise a rule that fires would be lost.
double positive_product(double a, double b) {
  const double product = a * b;
  return product > 0.0 || a == 0.0 || b == 0.0 ? product : std::numeric_limits<double>::min();
}

double evaluate_condition(const CompiledRule& rule, const double* leaves, double* stack) {
  if (rule.all_min) {
    double degree = 1.0;
    for (const Instruction& instruction : rule.condition) {
      if (instruction.op == Operator::leaf) {
        degree = std::min(degree, leaves[instruction.argument]);
      }
    }
    return degree;
  }
  double* top = stack;
  for (const Instruction& instruction : rule.condition) {
    if (instruction.op == Operator::leaf) {
      *top++ = leaves[instruction.argument];
      continue;
    }
    top -= instruction.argument;
    double degree = top[0];
    for (std::size_t i = 1; i < instruction.argument; ++i) {
      degree = combine(instruction.op, degree, top[i]);
    }
    *top++ = degree;
  }
  return stack[0];
}

/// Walks along the cells of an output and hands the accumulated set to a sink, line by line.
///
/// Within a cell every term is a straight line. A cut makes it two, at a place between; between all
/// such places each conclusion is one straight line, and what is accumulated from them is made of
/// few: the highest line at each x, or a sum.
template <class Sink>
class Walk {
 public:
  Walk(const ModelData& model, std::size_t output, Workspace::Memory& memory, Sink& sink)
      : slots_(model.slots.data()),
        output_(model.compiled_outputs[output]),
        accumulation_(model.outputs[output].accumulation),
        memory_(memory),
        sink_(sink) {}

  void run() {
    for (const Cell& cell : output_.cells) {
      gather(cell);
      if (memory_.active.size() == 1) {
        single(cell, memory_.active.front());
      } else if (!memory_.active.empty()) {
        several(cell);
      }
    }
  }

 private:
  void gather(const Cell& cell) {
    memory_.active.clear();
    for (std::size_t i = cell.first_line; i < cell.end_line; ++i) {
      const Line& line = output_.lines[i];
      for (std::size_t s = line.first_slot; s < line.end_slot; ++s) {
        const double degree = memory_.slots[s];
        if (degree <= 0.0) {
          continue;
        }
        if (slots_[s].scales) {
          memory_.active.push_back({line.y0 * degree, line.y1 * degree, kNoCut});
        } else {
          Active active{line.y0, line.y1, degree};
          const double t = split(active);
          if (t >= 1.0 && active.y1 < degree) {
            active.y1 = degree;  // cut so low that only rounding keeps the end from being cut too
          } else if (t == 0.0 && active.y0 < degree) {
            active.y0 = degree;
          }
          memory_.active.push_back(active);
        }
      }
    }
  }

  /// Where the conclusion's cut begins or ends, as a fraction of the cell; or nothing in (0, 1).
  static double split(const Active& active) {
    return (active.y0 < active.cut) != (active.y1 < active.cut)
               ? (active.cut - active.y0) / (active.y1 - active.y0)
               : -1.0;
  }

  void single(const Cell& cell, const Active& active) {
    const double t = split(active);
    const double y0 = std::min(active.y0, active.cut);
    const double y1 = std::min(active.y1, active.cut);
    if (t > 0.0 && t < 1.0) {
      const double x = cell.x0 + t * (cell.x1 - cell.x0);
      line(cell.x0, x, y0, active.cut);
      line(x, cell.x1, active.cut, y1);
    } else {
      line(cell.x0, cell.x1, y0, y1);
    }
  }

  /// Two or more conclusions in one cell.
  void several(const Cell& cell) {
    auto& splits = memory_.splits;
    splits.clear();
    for (const Active& active : memory_.active) {
      const double t = split(active);
      if (t > 0.0 && t < 1.0) {
        splits.push_back(t);
      }
    }
    std::sort(splits.begin(), splits.end());
    splits.push_back(1.0);
    double t0 = 0.0;
    double x0 = cell.x0;
    for (const double t1 : splits) {
      const double x1 = t1 == 1.0 ? cell.x1 : cell.x0 + t1 * (cell.x1 - cell.x0);
      if (x0 < x1) {
        memory_.edges.clear();
        for (const Active& active : memory_.active) {
          const double rise = active.y1 - active.y0;
          memory_.edges.push_back(
              {std::min(active.cut, t0 == 0.0 ? active.y0 : active.y0 + t0 * rise),
               std::min(active.cut, t1 == 1.0 ? active.y1 : active.y0 + t1 * rise)});
        }
        stretch(x0, x1);
      }
      t0 = t1;
      x0 = x1;
    }
  }

  /// The edges are straight from x0 to x1.
  void stretch(double x0, double x1) {
    switch (accumulation_) {
      case Accumulation::max:
        highest(x0, x1);
        break;
      case Accumulation::bounded_sum:
      case Accumulation::normalized_sum: {
        Edge sum;
        for (const Edge& edge : memory_.edges) {
          sum.y0 += edge.y0;
          sum.y1 += edge.y1;
        }
        line(x0, x1, sum.y0, sum.y1);
        break;
      }
      case Accumulation::algebraic_sum:
        sink_.polynomial(x0, x1, std::span<const Edge>(memory_.edges));
        break;
    }
  }

  /// Follows the highest line from crossing to crossing.
  void highest(double x0, double x1) {
    auto& edges = memory_.edges;
    Edge now = edges.front();
    for (const Edge& edge : edges) {
      if (edge.y0 > now.y0 || (edge.y0 == now.y0 && edge.y1 > now.y1)) {
        now = edge;
      }
    }
    double t = 0.0;
    double x = x0;
    double y = now.y0;
    while (true) {
      const Edge* next = nullptr;
      double next_t = 1.0;
      for (const Edge& edge : edges) {
        if (edge.y1 > now.y1) {  // steeper: it crosses somewhere before x1
          const double below = now.y0 - edge.y0;
          const double crossing = below / (below + (edge.y1 - now.y1));
          if (crossing < next_t || (crossing == next_t && next && edge.y1 > next->y1)) {
            next_t = crossing;
            next = &edge;
          }
        }
      }
      if (!next) {
        break;
      }
      t = std::max(t, next_t);
      const double crossing_x = x0 + t * (x1 - x0);
      const double crossing_y = now.y0 + t * (now.y1 - now.y0);
      if (crossing_x > x && crossing_x < x1) {
        sink_.line(x, crossing_x, y, crossing_y);
        x = crossing_x;
        y = crossing_y;
      }
      now = *next;
    }
    sink_.line(x, x1, y, now.y1);
  }

  /// A line of the result; the bounded sum cuts it off at 1.
  void line(double x0, double x1, double y0, double y1) {
    if (accumulation_ != Accumulation::bounded_sum || (y0 <= 1.0 && y1 <= 1.0)) {
      sink_.line(x0, x1, y0, y1);
      return;
    }
    const double t = (1.0 - y0) / (y1 - y0);
    const double x = x0 + t * (x1 - x0);
    if ((y0 < 1.0 || y1 < 1.0) && x > x0 && x < x1) {
      sink_.line(x0, x, std::min(y0, 1.0), 1.0);
      sink_.line(x, x1, 1.0, std::min(y1, 1.0));
    } else {
      sink_.line(x0, x1, std::min(y0, 1.0), std::min(y1, 1.0));
    }
  }

  static constexpr double kNoCut = std::numeric_limits<double>::infinity();
  const Slot* slots_;
  const CompiledOutput& output_;
  Accumulation accumulation_;
  Workspace::Memory& memory_;
  Sink& sink_;
};

template <class Sink>
void walk(const ModelData& model, std::size_t output, Workspace::Memory& memory, Sink& sink) {
  Walk<Sink>(model, output, memory, sink).run();
}

/// Nodes and weights of Gauss and Legendre's quadrature with ten nodes on [-1, 1], the positive
/// half: exact for polynomials up to degree 19 (Abramowitz and Stegun, 1964, table 25.4).
constexpr std::array<double, 5> kNodes = {0.14887433898163122, 0.43339539412924719,
                                          0.67940956829902441, 0.86506336668898451,
                                          0.97390652851717172};
constexpr std::array<double, 5> kWeights = {0.29552422471475287, 0.26926671930999636,
                                            0.21908636251598204, 0.14945134915058059,
                                            0.06667134430868814};
/// With this many edges the integrand of a moment, x (1 - product of the edges), is of degree 19.
constexpr std::size_t kMostEdges = 18;

/// a + b - a b of all edges at a fraction of their length.
double algebraic_sum(std::span<const Edge> edges, double t) {
  double none = 1.0;
  for (const Edge& edge : edges) {
    none *= 1.0 - (edge.y0 + t * (edge.y1 - edge.y0));
  }
  return 1.0 - none;
}

/// Calls add(t, weight) for the nodes of the integral over t from t0 to t1, in fractions of a
/// stretch. More edges than the quadrature is exact for: it goes in steps, whose error is far below
/// rounding.
template <class Add>
void each_node(std::size_t edges, double t0, double t1, Add add) {
  const std::size_t steps = (edges + kMostEdges - 1) / kMostEdges;
  const double half = 0.5 * (t1 - t0) / static_cast<double>(steps);
  for (std::size_t step = 0; step < steps; ++step) {
    const double middle = t0 + half * static_cast<double>(2 * step + 1);
    for (std::size_t i = 0; i < kNodes.size(); ++i) {
      add(middle - half * kNodes[i], half * kWeights[i]);
      add(middle + half * kNodes[i], half * kWeights[i]);
    }
  }
}

double polynomial_area(double width, std::span<const Edge> edges, double t0, double t1) {
  double sum = 0.0;
  each_node(edges.size(), t0, t1,
            [&](double t, double weight) { sum += weight * algebraic_sum(edges, t); });
  return sum * width;
}

struct CentroidWalk : CentroidSink {
  using CentroidSink::CentroidSink;
  void polynomial(double x0, double x1, std::span<const Edge> edges) {
    const double width = x1 - x0;
    each_node(edges.size(), 0.0, 1.0, [&](double t, double weight) {
      const double piece = weight * width * algebraic_sum(edges, t);
      area += piece;
      moment += (x0 - origin + t * width) * piece;
    });
  }
};

struct BisectorWalk : BisectorSink {
  using BisectorSink::BisectorSink;
  void polynomial(double x0, double x1, std::span<const Edge> edges) {
    const double width = x1 - x0;
    piece_ends(x0, x1, polynomial_area(width, edges, 0.0, 1.0), [&](double part) {
      double low = 0.0;
      double high = 1.0;
      while (true) {  // halves the interval until no number is left between
        const double t = 0.5 * (low + high);
        if (t <= low || t >= high) {
          return x0 + t * width;
        }
        (polynomial_area(width, edges, 0.0, t) < part ? low : high) = t;
      }
    });
  }
};

struct MaximaWalk : MaximaSink {
  /// The logarithm of the product of (1 - edge) is concave: its lowest values, and so the highest
  /// sums, are at the ends.
  void polynomial(double x0, double x1, std::span<const Edge> edges) {
    const double y0 = algebraic_sum(edges, 0.0);
    const double y1 = algebraic_sum(edges, 1.0);
    const bool flat = std::all_of(edges.begin(), edges.end(),
                                  [](const Edge& edge) { return edge.y0 == edge.y1; });
    // A sum with a full term is full, whatever is added.
    const bool full = std::any_of(edges.begin(), edges.end(), [](const Edge& edge) {
      return edge.y0 == 1.0 && edge.y1 == 1.0;
    });
    if (flat || full) {
      line(x0, x1, y0, y1);
    } else {
      peak(x0, y0);
      peak(x1, y1);
    }
  }
};

struct SetWalk : SetSink {
  using SetSink::SetSink;
  void polynomial(double x0, double x1, std::span<const Edge> edges) {
    // Degrees bend by no more than (sum of the slopes)^2 in a stretch of length 1: a chord over a
    // n-th part of it is off by at most an eighth of that, over n^2.
    double slopes = 0.0;
    for (const Edge& edge : edges) {
      slopes += std::abs(edge.y1 - edge.y0);
    }
    const int n = std::max(1, static_cast<int>(std::ceil(slopes / std::sqrt(8 * kSetTolerance))));
    double x = x0;
    double y = algebraic_sum(edges, 0.0);
    for (int i = 1; i <= n; ++i) {
      const double t = static_cast<double>(i) / n;
      const double next_x = i == n ? x1 : x0 + t * (x1 - x0);
      const double next_y = algebraic_sum(edges, t);
      if (next_x > x) {
        line(x, next_x, y, next_y);
        x = next_x;
        y = next_y;
      }
    }
  }
};

/// The degree that is accumulated from the slots of one singleton.
double singleton_degree(Accumulation accumulation, std::span<const double> slots) {
  double degree = 0.0;
  for (const double slot : slots) {
    switch (accumulation) {
      case Accumulation::max:
        degree = std::max(degree, slot);
        break;
      case Accumulation::algebraic_sum:
        degree = combine(Operator::algebraic_sum, degree, slot);
        break;
      case Accumulation::bounded_sum:
        degree = combine(Operator::bounded_sum, degree, slot);
        break;
      case Accumulation::normalized_sum:
        degree += slot;
        break;
    }
  }
  return degree;
}

/// Calls take(x, degree) for each singleton that is concluded.
template <class Take>
void each_singleton(const ModelData& model, std::size_t index, const Workspace::Memory& memory,
                    Take take) {
  const CompiledOutput& output = model.compiled_outputs[index];
  for (std::size_t s = output.first_slot; s < output.end_slot;) {
    std::size_t end = s;
    while (end < output.end_slot && model.slots[end].term == model.slots[s].term) {
      ++end;
    }
    const double degree = singleton_degree(model.outputs[index].accumulation,
                                           std::span(memory.slots).subspan(s, end - s));
    if (degree > 0.0) {
      take(*model.outputs[index].terms[model.slots[s].term].singleton, degree);
    }
    s = end;
  }
}

double defuzzified_singletons(const ModelData& model, std::size_t output,
                              const Workspace::Memory& memory) {
  if (model.outputs[output].method == Defuzzification::centroid_of_singletons) {
    double sum = 0.0;
    double moment = 0.0;
    each_singleton(model, output, memory, [&](double x, double degree) {
      sum += degree;
      moment += x * degree;
    });
    return moment / sum;
  }
  MaximaSink sink;
  each_singleton(model, output, memory, [&](double x, double degree) { sink.peak(x, degree); });
  return model.outputs[output].method == Defuzzification::leftmost_maximum    ? sink.first
         : model.outputs[output].method == Defuzzification::rightmost_maximum ? sink.last
                                                                              : sink.mean();
}

/// The highest degree of any slot of an output.
double strongest(const CompiledOutput& output, const Workspace::Memory& memory) {
  double highest = 0.0;
  for (std::size_t s = output.first_slot; s < output.end_slot; ++s) {
    highest = std::max(highest, memory.slots[s]);
  }
  return highest;
}

/// Degrees so small that areas would lose digits are raised alike: the shape stays.
double strengthen(const CompiledOutput& output, Workspace::Memory& memory) {
  constexpr double kTiny = 1e-200;
  const double highest = strongest(output, memory);
  if (highest > 0.0 && highest < kTiny) {
    for (std::size_t s = output.first_slot; s < output.end_slot; ++s) {
      memory.slots[s] /= kTiny;
    }
  }
  return highest;
}

}  // namespace

Leaf::Leaf(std::size_t input_index, const FuzzySet& set)
    : input(input_index), first(set.points.front().degree), last(set.points.back().degree) {
  for (const FuzzySet::Point& point : set.points) {
    if (knots.empty() || knots.back().x != point.x) {
      knots.push_back({point.x, set.degree(point.x), point.x, last, 0.0, 1.0});
    }
  }
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    Knot& knot = knots[i];
    const double x1 = knots[i + 1].x;
    const double y0 = degree_after(set, knot.x);
    const double y1 = degree_before(set, x1);
    knot.slope = (y1 - y0) / (x1 - knot.x);
    knot.anchor_x = y0 <= y1 ? knot.x : x1;
    knot.anchor_degree = std::min(y0, y1);
    knot.cap = std::max(y0, y1);
  }
}

double Leaf::degree(double x) const {
  if (x < knots.front().x) {
    return first;
  }
  constexpr std::size_t kFew = 8;
  std::size_t i = 0;
  if (knots.size() <= kFew) {
    while (i + 1 < knots.size() && knots[i + 1].x <= x) {
      ++i;
    }
  } else {
    const auto right = std::upper_bound(knots.begin(), knots.end(), x,
                                        [](double v, const Knot& knot) { return v < knot.x; });
    i = static_cast<std::size_t>(right - knots.begin()) - 1;
  }
  const Knot& knot = knots[i];
  if (knot.x == x) {
    return knot.degree;
  }
  if (i + 1 == knots.size()) {
    return last;
  }
  return knot.line(x);
}

double Leaf::after(double x) const {
  if (x < knots.front().x) {
    return first;
  }
  const auto right = std::upper_bound(knots.begin(), knots.end(), x,
                                      [](double v, const Knot& knot) { return v < knot.x; });
  return right == knots.end() ? last : (right - 1)->line(x);
}

double Leaf::before(double x) const {
  const auto right = std::lower_bound(knots.begin(), knots.end(), x,
                                      [](const Knot& knot, double v) { return knot.x < v; });
  return right == knots.begin() ? first : right == knots.end() ? last : (right - 1)->line(x);
}

double combine(Operator op, double a, double b) {
  switch (op) {
    case Operator::min:
      return std::min(a, b);
    case Operator::product:
      return positive_product(a, b);
    case Operator::bounded_difference:
      return std::max(0.0, a + b - 1.0);
    case Operator::max:
      return std::max(a, b);
    case Operator::algebraic_sum:
      return std::min(1.0, a + b * (1.0 - a));
    case Operator::bounded_sum:
      return std::min(1.0, a + b);
    case Operator::leaf:
      break;
  }
  return 0.0;
}

void fire_rules(const ModelData& model, Workspace::Memory& memory) {
  for (std::size_t i = 0; i < model.leaves.size(); ++i) {
    const Leaf& leaf = model.leaves[i];
    memory.leaves[i] = leaf.degree(memory.inputs[leaf.input]);
  }
  std::fill(memory.slots.begin(), memory.slots.end(), 0.0);
  for (std::size_t r = 0; r < model.compiled_rules.size(); ++r) {
    const CompiledRule& rule = model.compiled_rules[r];
    double degree = evaluate_condition(rule, memory.leaves.data(), memory.stack.data());
    if (rule.weight != 1.0) {
      degree = positive_product(degree, rule.weight);
    }
    memory.degrees[r] = degree;
    if (degree <= 0.0) {
      continue;
    }
    for (const Target& target : rule.targets) {
      double& slot = memory.slots[target.slot];
      slot = model.outputs[target.output].accumulation == Accumulation::max ? std::max(slot, degree)
                                                                            : slot + degree;
    }
  }
}

std::optional<double> defuzzified(const ModelData& model, std::size_t index,
                                  Workspace::Memory& memory) {
  const CompiledOutput& output = model.compiled_outputs[index];
  const OutputVariable& variable = model.outputs[index];
  if (strengthen(output, memory) <= 0.0) {
    return std::nullopt;
  }
  if (output.singletons) {
    return defuzzified_singletons(model, index, memory);
  }
  const Range& range = variable.range;
  switch (variable.method) {
    case Defuzzification::centroid:
    case Defuzzification::centroid_of_singletons: {
      CentroidWalk sink(0.5 * (range.low + range.high));
      walk(model, index, memory, sink);
      return std::clamp(sink.centroid(), range.low, range.high);
    }
    case Defuzzification::bisector: {
      CentroidWalk whole(range.low);
      walk(model, index, memory, whole);
      BisectorWalk sink(whole.area);
      walk(model, index, memory, sink);
      return std::clamp(sink.bisector(), range.low, range.high);
    }
    case Defuzzification::leftmost_maximum:
    case Defuzzification::rightmost_maximum:
    case Defuzzification::mean_of_maxima:
      break;
  }
  MaximaWalk sink;
  walk(model, index, memory, sink);
  return variable.method == Defuzzification::leftmost_maximum    ? sink.first
         : variable.method == Defuzzification::rightmost_maximum ? sink.last
                                                                 : sink.mean();
}

void accumulated(const ModelData& model, std::size_t index, Workspace::Memory& memory,
                 FuzzySet& set) {
  set.points.clear();
  const CompiledOutput& output = model.compiled_outputs[index];
  const OutputVariable& variable = model.outputs[index];
  if (strongest(output, memory) <= 0.0) {
    return;
  }
  if (output.singletons) {
    each_singleton(model, index, memory, [&](double x, double degree) {
      set.points.insert(set.points.end(), {{x, 0.0}, {x, degree}, {x, 0.0}});
    });
    std::stable_sort(set.points.begin(), set.points.end(),
                     [](const FuzzySet::Point& a, const FuzzySet::Point& b) { return a.x < b.x; });
  } else {
    SetWalk sink(set, variable.range.low, variable.range.high);
    walk(model, index, memory, sink);
    sink.finish();
  }
  if (variable.accumulation == Accumulation::normalized_sum) {
    const double highest = height(set);
    for (FuzzySet::Point& point : set.points) {
      point.degree /= std::max(1.0, highest);
    }
  }
}

}  // namespace elsie::fuzzy
