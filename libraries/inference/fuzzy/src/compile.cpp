#include "compile.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <tuple>
#include <utility>

#include "elsie/fuzzy/sets.h"

namespace elsie::fuzzy {

namespace {

/// Gives each conclusion its slot.
void assign_slots(std::vector<Conclusion>& conclusions, ModelData& model) {
  // Slots of one output are adjacent, and among them those of one term.
  std::stable_sort(
      conclusions.begin(), conclusions.end(), [](const Conclusion& a, const Conclusion& b) {
        return std::tuple(a.output, a.term, a.scales) < std::tuple(b.output, b.term, b.scales);
      });
  model.compiled_outputs.resize(model.outputs.size());
  const Conclusion* last = nullptr;
  for (const Conclusion& conclusion : conclusions) {
    const Accumulation accumulation = model.outputs[conclusion.output].accumulation;
    // Two cuts of one term: the maximum keeps only the higher one, other accumulations need both.
    // Scaled terms may be added before they are scaled.
    const bool may_share = accumulation == Accumulation::max ||
                           (conclusion.scales && accumulation != Accumulation::algebraic_sum);
    const bool shares = may_share && last && last->output == conclusion.output &&
                        last->term == conclusion.term && last->scales == conclusion.scales;
    if (!shares) {
      model.slots.push_back({conclusion.term, conclusion.scales});
    }
    CompiledOutput& output = model.compiled_outputs[conclusion.output];
    if (!last || last->output != conclusion.output) {
      output.first_slot = model.slots.size() - 1;
    }
    output.end_slot = model.slots.size();
    model.compiled_rules[conclusion.rule].targets.push_back(
        {conclusion.output, model.slots.size() - 1, conclusion.hedges});
    last = &conclusion;
  }
}

/// Divides the range of an output into cells.
void compile_output(std::size_t index, ModelData& model) {
  const OutputVariable& variable = model.outputs[index];
  CompiledOutput& output = model.compiled_outputs[index];
  output.singletons = variable.terms.front().singleton.has_value();
  model.most_slots = std::max(model.most_slots, output.end_slot - output.first_slot);
  if (output.singletons) {
    return;
  }
  const Range& range = variable.range;
  std::set<double> places{range.low, range.high};
  std::vector<std::pair<std::size_t, std::size_t>> slots_of(variable.terms.size());
  for (std::size_t s = output.first_slot; s < output.end_slot; ++s) {
    auto& [first, end] = slots_of[model.slots[s].term];
    first = end == 0 ? s : first;
    end = s + 1;
  }
  for (std::size_t t = 0; t < variable.terms.size(); ++t) {
    if (slots_of[t].second == 0) {
      continue;  // no rule concludes it
    }
    for (const FuzzySet::Point& point : variable.terms[t].set.points) {
      if (point.x > range.low && point.x < range.high) {
        places.insert(point.x);
      }
    }
  }
  for (auto left = places.begin(), right = std::next(left); right != places.end();
       ++left, ++right) {
    Cell cell{*left, *right, output.lines.size(), 0};
    for (std::size_t t = 0; t < variable.terms.size(); ++t) {
      const auto& [first, end] = slots_of[t];
      const double y0 = degree_after(variable.terms[t].set, *left);
      const double y1 = degree_before(variable.terms[t].set, *right);
      if (end != 0 && (y0 > 0.0 || y1 > 0.0)) {
        output.lines.push_back({y0, y1, first, end});
      }
    }
    cell.end_line = output.lines.size();
    output.cells.push_back(cell);
  }
}

}  // namespace

void compile_outputs(std::vector<Conclusion> conclusions, ModelData& model) {
  assign_slots(conclusions, model);
  for (std::size_t i = 0; i < model.outputs.size(); ++i) {
    compile_output(i, model);
  }
}

}  // namespace elsie::fuzzy
