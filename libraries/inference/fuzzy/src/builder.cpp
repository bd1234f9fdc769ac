#include "builder.h"

#include <algorithm>

#include "coverage.h"
#include "model_builder.h"

namespace elsie::fuzzy {

std::shared_ptr<const ModelData> ModelBuilder::run() {
  model_->name = block_.name.text;
  declare(block_.inputs, false);
  declare(block_.outputs, true);
  variable_blocks();
  for (const auto& [name, declared] : variables_) {
    if (declared.block_line == 0 && declared.output) {
      const ast::Name& written = declared.declaration->name;
      problems_.add(written.line,
                    "The variable " + name_in_quotes(written.text) +
                        " has no DEFUZZIFY block. Write one, or remove the variable.");
    }
  }
  if (block_.inputs.empty()) {
    problems_.add(block_.name.line, "The function block has no input. Declare one in VAR_INPUT.");
  }
  if (block_.outputs.empty()) {
    const std::string lacks = "The function block has no output";
    const std::string remedy = "Declare one in VAR_OUTPUT.";
    gaps_ == Gaps::refused
        ? problems_.add(block_.name.line, lacks + ". " + remedy)
        : problems_.add_note(block_.name.line,
                             lacks + ", so that no robot can use the model. " + remedy);
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
  for (std::size_t i = 0; i < model_->outputs.size(); ++i) {
    check_accumulation(i);
  }
  compile_outputs(conclusions_, *model_);
  check_coverage();
  model_->notes = problems_.notes();
  return model_;
}

/// Some tools write an output's terms in a FUZZIFY block, and the rest in DEFUZZIFY.
void ModelBuilder::variable_blocks() {
  std::vector<ast::VariableBlock> defuzzify = block_.defuzzify;
  for (const ast::VariableBlock& block : block_.fuzzify) {
    const auto declared = variables_.find(lower(block.name.text));
    const auto rest =
        std::find_if(defuzzify.begin(), defuzzify.end(), [&](const ast::VariableBlock& candidate) {
          return same_name(candidate.name.text, block.name.text) && candidate.terms.empty();
        });
    if (declared == variables_.end() || !declared->second.output || rest == defuzzify.end() ||
        (block.range && rest->range)) {
      variable_block(block, false);
      continue;
    }
    problems_.add_note(block.name.line, name_in_quotes(block.name.text) +
                                            " is an output, whose terms belong into its DEFUZZIFY "
                                            "block. Write them there.");
    rest->terms = block.terms;
    rest->range = block.range ? block.range : rest->range;
  }
  for (const ast::VariableBlock& block : defuzzify) {
    variable_block(block, true);
  }
}

/// An unused input is harmless, and so is an output that always has its DEFAULT.
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
    const std::string lacks =
        "The variable " + name_in_quotes(written.text) + " has no FUZZIFY block";
    if (declared.used) {
      problems_.add(written.line, lacks + ". Write one, or remove the variable.");
    } else if (!declared.in_formula) {
      problems_.add_note(written.line, lacks + ", and no rule asks for it. Remove the variable.");
    }
    return;
  }
  if (!declared.output && declared.used && !declared.usable) {
    problems_.add(declared.block_line, "The variable " + name_in_quotes(written.text) +
                                           " has no terms. Write at least one TERM.");
    return;
  }
  if (declared.used || declared.in_formula || (declared.output && !declared.usable)) {
    return;
  }
  if (!declared.output) {
    problems_.add_note(written.line, "No rule asks for the variable " +
                                         name_in_quotes(written.text) +
                                         ". Write one, or remove the variable.");
    return;
  }
  const OutputVariable& output = model_->outputs[declared.index];
  const std::string undecided = "No rule decides the variable " + name_in_quotes(written.text);
  output.default_value || output.keeps_last
      ? problems_.add_note(written.line, undecided +
                                             ": it always has its DEFAULT. Write one, or "
                                             "remove the variable.")
      : problems_.add(written.line, undecided + ". Write one, or remove the variable.");
}

void ModelBuilder::check_coverage() {
  for (std::size_t i = 0; i < model_->outputs.size(); ++i) {
    OutputVariable& output = model_->outputs[i];
    if (output.default_value || output.keeps_last) {
      continue;
    }
    const std::optional<Gap> gap = find_gap(*model_, i);
    if (!gap) {
      continue;
    }
    const int line = variables_.at(lower(output.name)).block_line;
    const std::string lacks =
        "The output " + name_in_quotes(output.name) + " has no DEFAULT, but no rule " +
        (gap->certain ? "decides it" : "could be shown to decide it") + " at " + gap->example;
    const std::string remedy =
        "Add DEFAULT := value to its DEFUZZIFY block, or a rule for this case.";
    if (gaps_ == Gaps::refused) {
      problems_.add(line, lacks + ". " + remedy);
    } else {
      problems_.add_note(
          line, lacks + ": it is nan there, so that no robot can use the model. " + remedy);
      output.gap = gap->example;
    }
  }
}

std::shared_ptr<const ModelData> build(const ast::FunctionBlock& block, Problems& problems,
                                       Gaps gaps) {
  return ModelBuilder(block, problems, gaps).run();
}

}  // namespace elsie::fuzzy
