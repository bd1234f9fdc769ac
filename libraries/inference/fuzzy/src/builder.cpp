#include "builder.h"

#include "coverage.h"
#include "model_builder.h"

namespace elsie::fuzzy {

std::shared_ptr<const ModelData> ModelBuilder::run() {
  model_->name = block_.name.text;
  declare(block_.inputs, false);
  declare(block_.outputs, true);
  for (const ast::VariableBlock& block : block_.fuzzify) {
    variable_block(block, false);
  }
  for (const ast::VariableBlock& block : block_.defuzzify) {
    variable_block(block, true);
  }
  for (const auto& [name, declared] : variables_) {
    if (declared.block_line == 0 && declared.output) {
      const ast::Name& written = declared.declaration->name;
      problems_.add(written.line,
                    "The variable " + quoted(written.text) +
                        " has no DEFUZZIFY block. Write one, or remove the variable.");
    }
  }
  if (block_.inputs.empty()) {
    problems_.add(block_.name.line, "The function block has no input. Declare one in VAR_INPUT.");
  }
  if (block_.outputs.empty()) {
    problems_.add(block_.name.line, "The function block has no output. Declare one in VAR_OUTPUT.");
  }
  for (const ast::RuleBlock& block : block_.rule_blocks) {
    rule_block(block);
  }
  for (const auto& [name, declared] : variables_) {
    check_use(declared);
  }
  if (!problems_.empty()) {
    return nullptr;
  }
  compile_outputs(conclusions_, *model_);
  check_coverage();
  model_->notes = problems_.notes();
  return model_;
}

/// An input that no rule asks for does no harm, nor does an output that always has its DEFAULT.
void ModelBuilder::check_use(const Declared& declared) {
  const ast::Name& written = declared.declaration->name;
  if (!declared.output && declared.block_line == 0) {
    Variable& input = variable(declared);
    if (const auto& stated = declared.declaration->range) {
      input.range = stated->range;
      input.range_given = true;
    } else {
      input.range = {-1.0, 1.0};
    }
    const std::string lacks = "The variable " + quoted(written.text) + " has no FUZZIFY block";
    declared.used ? problems_.add(written.line, lacks + ". Write one, or remove the variable.")
                  : problems_.add_note(written.line,
                                       lacks + ", and no rule asks for it. Remove the variable.");
    return;
  }
  if (declared.used || !declared.usable) {
    return;
  }
  if (!declared.output) {
    problems_.add_note(written.line, "No rule asks for the variable " + quoted(written.text) +
                                         ". Write one, or remove the variable.");
    return;
  }
  const OutputVariable& output = model_->outputs[declared.index];
  const std::string undecided = "No rule decides the variable " + quoted(written.text);
  output.default_value || output.keeps_last
      ? problems_.add_note(written.line, undecided +
                                             ": it always has its DEFAULT. Write one, or "
                                             "remove the variable.")
      : problems_.add(written.line, undecided + ". Write one, or remove the variable.");
}

void ModelBuilder::check_coverage() {
  for (std::size_t i = 0; i < model_->outputs.size(); ++i) {
    const OutputVariable& output = model_->outputs[i];
    if (output.default_value || output.keeps_last) {
      continue;
    }
    if (const std::optional<Gap> gap = find_gap(*model_, i)) {
      problems_.add(variables_.at(lower(output.name)).block_line,
                    "The output " + quoted(output.name) + " has no DEFAULT, but no rule " +
                        (gap->certain ? "decides it" : "could be shown to decide it") + " at " +
                        gap->example +
                        ". Add DEFAULT := value to its DEFUZZIFY block, or a rule for this case.");
    }
  }
}

std::shared_ptr<const ModelData> build(const ast::FunctionBlock& block, Problems& problems) {
  return ModelBuilder(block, problems).run();
}

}  // namespace elsie::fuzzy
