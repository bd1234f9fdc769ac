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
    if (declared.block_line == 0) {
      const ast::Name& written = declared.declaration->name;
      problems_.add(written.line, "The variable " + quoted(written.text) + " has no " +
                                      (declared.output ? "DEFUZZIFY" : "FUZZIFY") +
                                      " block. Write one, or remove the variable.");
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
    if (!declared.used && declared.usable) {
      const ast::Name& written = declared.declaration->name;
      problems_.add(written.line, "No rule " +
                                      std::string(declared.output ? "decides" : "asks for") +
                                      " the variable " + quoted(written.text) +
                                      ". Write one, or remove the variable.");
    }
  }
  if (!problems_.empty()) {
    return nullptr;
  }
  compile_outputs(conclusions_, *model_);
  check_coverage();
  return model_;
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
