#include "elsie/fuzzy/model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "coverage.h"
#include "inference.h"
#include "model_data.h"
#include "text.h"
#include "workspace.h"

namespace elsie::fuzzy {

namespace {

template <class Named>
std::optional<std::size_t> index_of(const std::vector<Named>& all, std::string_view name) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (same_name(all[i].name, name)) {
      return i;
    }
  }
  return std::nullopt;
}

void check_size(std::size_t size, std::size_t expected, const char* what, const ModelData& model) {
  if (size != expected) {
    throw std::invalid_argument("Found " + std::to_string(size) + " " + std::string(what) +
                                ", but the fuzzy model '" + model.name + "' has " +
                                std::to_string(expected) + ".");
  }
}

}  // namespace

const Term* Variable::term(std::string_view term_name) const {
  const auto index = index_of(terms, term_name);
  return index ? &terms[*index] : nullptr;
}

Workspace::Workspace() : memory_(std::make_unique<Memory>()) {}
Workspace::~Workspace() = default;
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace& Workspace::operator=(Workspace&&) noexcept = default;

void Workspace::Memory::fit(const ModelData& model) {
  inputs.resize(model.inputs.size());
  leaves.resize(model.leaves.size());
  stack.resize(std::max(stack.size(), model.stack_depth));
  degrees.resize(model.rules.size());
  slots.resize(model.slots.size());
  active.reserve(model.most_slots);
  splits.reserve(model.most_slots + 2);
  edges.reserve(model.most_slots);
  kept_edges.reserve(model.most_slots);
}

Model::Model(std::shared_ptr<const ModelData> data) : data_(std::move(data)) {}

const std::string& Model::name() const { return data_->name; }
std::span<const Variable> Model::inputs() const { return data_->inputs; }
std::span<const OutputVariable> Model::outputs() const { return data_->outputs; }
std::span<const Rule> Model::rules() const { return data_->rules; }
std::span<const Problem> Model::notes() const { return data_->notes; }

std::optional<std::size_t> Model::input_index(std::string_view name) const {
  return index_of(data_->inputs, name);
}

std::optional<std::size_t> Model::output_index(std::string_view name) const {
  return index_of(data_->outputs, name);
}

std::optional<std::string> Model::undecided_at(std::size_t output) const {
  const std::optional<Gap> gap = find_gap(*data_, output);
  return gap ? std::optional(gap->example) : std::nullopt;
}

void Model::activate(std::span<const double> inputs, Workspace& workspace) const {
  const ModelData& model = *data_;
  Workspace::Memory& memory = *workspace.memory_;
  check_size(inputs.size(), model.inputs.size(), "input values", model);
  memory.fit(model);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const Variable& input = model.inputs[i];
    if (!std::isfinite(inputs[i])) {
      throw std::invalid_argument("The input '" + input.name + "' of the fuzzy model '" +
                                  model.name + "' is " + number_text(inputs[i]) +
                                  "; expected a finite number.");
    }
    memory.inputs[i] =
        input.range_given ? std::clamp(inputs[i], input.range.low, input.range.high) : inputs[i];
  }
  fire_rules(model, memory);
}

void Model::evaluate(std::span<const double> inputs, std::span<double> outputs,
                     Workspace& workspace) const {
  check_size(outputs.size(), data_->outputs.size(), "places for outputs", *data_);
  activate(inputs, workspace);
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const OutputVariable& output = data_->outputs[i];
    if (const auto value = defuzzified(*data_, i, *workspace.memory_)) {
      outputs[i] = *value;
    } else if (output.default_value && (!output.keeps_last || std::isnan(outputs[i]))) {
      outputs[i] = *output.default_value;
    } else if (output.gap) {
      outputs[i] = std::numeric_limits<double>::quiet_NaN();
    } else if (!output.keeps_last) {
      // Some rule fires, but rounding lost its degree.
      outputs[i] = 0.5 * (output.range.low + output.range.high);
    }
  }
}

void Model::output_set(std::size_t output, std::span<const double> inputs, Workspace& workspace,
                       FuzzySet& set) const {
  if (output >= data_->outputs.size()) {
    throw std::invalid_argument("The fuzzy model '" + data_->name + "' has no output number " +
                                std::to_string(output) + "; it has " +
                                std::to_string(data_->outputs.size()) + ", counted from 0.");
  }
  activate(inputs, workspace);
  accumulated(*data_, output, *workspace.memory_, set);
}

FuzzySet Model::output_set(std::size_t output, std::span<const double> inputs,
                           Workspace& workspace) const {
  FuzzySet set;
  output_set(output, inputs, workspace, set);
  return set;
}

void Model::rule_degrees(std::span<const double> inputs, std::span<double> degrees,
                         Workspace& workspace) const {
  check_size(degrees.size(), data_->rules.size(), "places for rules", *data_);
  activate(inputs, workspace);
  std::copy(workspace.memory_->degrees.begin(), workspace.memory_->degrees.end(), degrees.begin());
}

}  // namespace elsie::fuzzy
