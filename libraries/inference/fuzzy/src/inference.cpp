// Computes sets and numbers from the degrees of rules.
#include "inference.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>

#include "elsie/fuzzy/sets.h"

#include "polynomials.h"
#include "text.h"
#include "walk.h"

namespace elsie::fuzzy {

namespace {

/// The accumulated degree of the slots of one singleton.
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

/// The position of a singleton for these inputs.
double place_of(const ModelData& model, std::size_t output, std::size_t index,
                std::span<const double> inputs) {
  const Term& term = model.outputs[output].terms[index];
  if (!term.formula.empty()) {
    const double x = value_of(model.formulas.at({output, index}), inputs);
    if (!(std::abs(x) <= kFurthestPlace)) {
      throw std::invalid_argument("The term '" + term.name + "' of the output '" +
                                  model.outputs[output].name + "' of the fuzzy model '" +
                                  model.name + "', '" + term.formula + "', is " + number_text(x) +
                                  " for these inputs; expected a number from -1e100 to 1e100.");
    }
    return x;
  }
  if (term.linear.empty()) {
    return *term.singleton;
  }
  double x = term.linear.back();
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    x += term.linear[i] * inputs[i];
  }
  return x;
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
      take(place_of(model, index, model.slots[s].term, memory.inputs), degree);
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

/// Scales up degrees so small that areas would lose digits; the shape stays.
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
