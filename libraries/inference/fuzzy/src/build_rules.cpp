// Builds rules: their conditions and conclusions.
#include <algorithm>
#include <set>

#include "elsie/base/words.h"
#include "elsie/fuzzy/sets.h"

#include "model_builder.h"
#include "shapes.h"

namespace elsie::fuzzy {

void ModelBuilder::rule_block(const ast::RuleBlock& block) {
  const auto conjunction = word(block.conjunction, kAnd, "AND");
  const auto disjunction = word(block.disjunction, kOr, "OR");
  const bool scales = word(block.activation, kActivation, "ACT").value_or(false);
  const auto accumulation = word(block.accumulation, kAccumulation, "ACCU");
  Operators operators{Operator::min, Operator::max};
  if (conjunction) {
    operators = {*conjunction, dual(*conjunction)};
  }
  if (disjunction) {
    operators.disjunction = *disjunction;
    operators.conjunction = conjunction.value_or(dual(*disjunction));
  }
  if (block.rules.empty()) {
    problems_.add_note(block.name.line,
                       "The rule block has no rules. Write one, or remove the block.");
  }
  const std::size_t first_conclusion = conclusions_.size();
  std::map<std::string, int> labels;
  for (const ast::Rule& written : block.rules) {
    const auto [place, is_new] = labels.try_emplace(lower(written.label.text), written.label.line);
    if (!is_new) {
      problems_.add_note(written.label.line, "A second rule " + written.label.text +
                                                 " in this block; the first is in line " +
                                                 std::to_string(place->second) +
                                                 ". Both count: give it another number.");
    }
    rule(block, written, operators, scales);
  }
  if (accumulation) {
    std::set<std::size_t> concluded;
    for (std::size_t i = first_conclusion; i < conclusions_.size(); ++i) {
      concluded.insert(conclusions_[i].output);
    }
    for (const std::size_t output : concluded) {
      accumulate(variables_.at(lower(model_->outputs[output].name)), *accumulation,
                 block.accumulation->line);
    }
  }
}

/// Tools differ in how they combine several rules on one singleton.
void ModelBuilder::check_accumulation(std::size_t index) {
  OutputVariable& output = model_->outputs[index];
  const Declared& declared = variables_.at(lower(output.name));
  const bool is_linear = std::any_of(output.terms.begin(), output.terms.end(),
                                     [](const Term& term) { return !term.linear.empty(); });
  if (output.method != Defuzzification::centroid_of_singletons) {
    return;
  }
  if (is_linear) {  // each rule has its weight in the mean
    if (declared.accumulation_line && output.accumulation != Accumulation::normalized_sum) {
      problems_.add_note(declared.accumulation_line,
                         "ACCU does not count for " + name_in_quotes(output.name) +
                             ", which has Linear terms: each rule has its weight. Remove it.");
    }
    output.accumulation = Accumulation::normalized_sum;
    return;
  }
  if (declared.accumulation_line) {
    return;
  }
  std::set<std::size_t> seen;
  for (const Conclusion& conclusion : conclusions_) {
    if (conclusion.output == index && !seen.insert(conclusion.term).second) {
      problems_.add_note(
          declared.block_line,
          "Several rules conclude " +
              name_in_quotes(output.name + " IS " + output.terms[conclusion.term].name) +
              ", and there is no ACCU. The strongest counts, where fuzzylite adds "
              "them up. Write ACCU : MAX or ACCU : NSUM.");
      return;
    }
  }
}

void ModelBuilder::rule(const ast::RuleBlock& block, const ast::Rule& rule,
                        const Operators& operators, bool scales) {
  CompiledRule compiled;
  Rule shown;
  shown.block = block.name.text;
  shown.label = rule.label.text;
  shown.line = rule.label.line;
  shown.weight = rule.weight;
  if (!(rule.weight >= 0.0 && rule.weight <= 1.0)) {
    problems_.add(rule.label.line, "Rule " + rule.label.text + " has the weight " +
                                       number_text(rule.weight) + ". Weights lie in 0 to 1.");
  }
  compiled.weight = rule.weight;
  condition(rule.condition, false, operators, compiled.condition);
  compiled.all_min = std::all_of(
      compiled.condition.begin(), compiled.condition.end(), [](const Instruction& instruction) {
        return instruction.op == Operator::leaf || instruction.op == Operator::min;
      });
  shown.text = "IF " + condition_text(rule.condition) + " THEN ";
  std::string hedges;  // in fuzzylite they hold from their conclusion on
  for (std::size_t i = 0; i < rule.conclusions.size(); ++i) {
    const ast::Conclusion& conclusion = rule.conclusions[i];
    shown.text += (i == 0 ? "" : ", ") + conclusion.variable.text + " IS " + conclusion.hedges +
                  (conclusion.hedges.empty() ? "" : " ") + conclusion.term.text;
    if (!conclusion.hedges.empty()) {
      hedges.insert(0, conclusion.hedges + (hedges.empty() ? "" : " "));
      if (i + 1 < rule.conclusions.size()) {
        problems_.add_note(conclusion.term.line,
                           "The hedge before " + name_in_quotes(conclusion.term.text) +
                               " holds for the conclusions after it too, as in fuzzylite. Write a "
                               "rule for each conclusion if that is not meant.");
      }
    }
    Declared* declared = find(conclusion.variable, "output");
    if (!declared) {
      continue;
    }
    if (!declared->output) {
      problems_.add(conclusion.variable.line,
                    name_in_quotes(conclusion.variable.text) +
                        " is an input. A rule concludes on outputs; correct the name.");
      continue;
    }
    declared->used = true;
    if (!declared->usable) {
      continue;
    }
    const OutputVariable& output = model_->outputs[declared->index];
    const Term* term = output.term(conclusion.term.text);
    if (!term) {
      std::vector<std::string> names;
      for (const Term& candidate : output.terms) {
        names.push_back(candidate.name);
      }
      problems_.add(conclusion.term.line,
                    "The output " + name_in_quotes(output.name) + " has no term " +
                        name_in_quotes(conclusion.term.text) + "." +
                        did_you_mean(conclusion.term.text, names) + " Its terms are " +
                        base::enumerated(names, "or") + ".");
      continue;
    }
    if (is_point(*term)) {
      continue;
    }
    conclusions_.push_back({model_->rules.size(), declared->index,
                            static_cast<std::size_t>(term - output.terms.data()), scales, hedges});
  }
  if (rule.weight != 1.0) {
    shown.text += " WITH " + number_text(rule.weight);
  }
  std::size_t depth = 0;
  for (const Instruction& instruction : compiled.condition) {
    depth = instruction.op == Operator::leaf ? depth + 1 : depth + 1 - instruction.argument;
    model_->stack_depth = std::max(model_->stack_depth, depth);
  }
  model_->compiled_rules.push_back(std::move(compiled));
  model_->rules.push_back(std::move(shown));
}

bool ModelBuilder::condition(const ast::Condition& condition, bool negated,
                             const Operators& operators, std::vector<Instruction>& into) {
  using Kind = ast::Condition::Kind;
  switch (condition.kind) {
    case Kind::is:
    case Kind::is_not:
      return comparison(condition, negated != (condition.kind == Kind::is_not), into);
    case Kind::negation:
      return this->condition(condition.operands[0], !negated, operators, into);
    case Kind::conjunction:
    case Kind::disjunction:
      break;
  }
  bool sound = true;
  for (const ast::Condition& operand : condition.operands) {
    sound = this->condition(operand, negated, operators, into) && sound;
  }
  const Operator op =
      condition.kind == Kind::conjunction ? operators.conjunction : operators.disjunction;
  if (sound) {
    into.push_back({negated ? dual(op) : op, condition.operands.size()});
  }
  return sound;
}

bool ModelBuilder::comparison(const ast::Condition& condition, bool negated,
                              std::vector<Instruction>& into) {
  Declared* declared = find(condition.variable, "input");
  if (!declared) {
    return false;
  }
  if (declared->output) {
    problems_.add(condition.variable.line,
                  name_in_quotes(condition.variable.text) +
                      " is an output. A condition asks for inputs; correct the name. (Conditions "
                      "on outputs are an extension of fuzzylite and jFuzzyLogic, each in its own "
                      "sense, which is not supported.)");
    return false;
  }
  declared->used = true;
  if (!declared->usable) {
    return false;  // reported with its block
  }
  const Variable& input = model_->inputs[declared->index];
  const Term* term = input.term(condition.term.text);
  if (!term) {
    std::vector<std::string> names;
    for (const Term& candidate : input.terms) {
      names.push_back(candidate.name);
    }
    problems_.add(
        condition.term.line,
        "The input " + name_in_quotes(input.name) + " has no term " +
            name_in_quotes(condition.term.text) + "." + did_you_mean(condition.term.text, names) +
            " Its terms are " + base::enumerated(names, "or") + "." +
            (same_name(condition.term.text, "any") ? " (The hedge 'any' is a fuzzylite extension, "
                                                     "which is not supported.)"
                                                   : ""));
    return false;
  }
  if (term->set.points.empty()) {
    return false;  // reported with the term
  }
  const auto index = static_cast<std::size_t>(term - input.terms.data());
  into.push_back({Operator::leaf, leaf(declared->index, index, condition.hedges, negated)});
  return true;
}

std::size_t ModelBuilder::leaf(std::size_t input, std::size_t term, const std::string& hedges,
                               bool complement) {
  const auto [place, is_new] =
      leaves_.try_emplace(std::tuple(input, term, hedges, complement), model_->leaves.size());
  if (is_new) {
    const FuzzySet set = hedged(model_->inputs[input].terms[term].set, hedges);
    // At a step a set takes its larger degree, and so its complement the smaller one.
    Leaf made(input, complement ? complement_of(set) : set);
    if (complement) {
      for (Leaf::Knot& knot : made.knots) {
        knot.degree = 1.0 - set.degree(knot.x);
      }
    }
    model_->leaves.push_back(std::move(made));
  }
  return place->second;
}

std::string ModelBuilder::condition_text(const ast::Condition& condition) const {
  using Kind = ast::Condition::Kind;
  if (condition.kind == Kind::is || condition.kind == Kind::is_not) {
    return condition.variable.text + (condition.kind == Kind::is ? " IS " : " IS NOT ") +
           condition.hedges + (condition.hedges.empty() ? "" : " ") + condition.term.text;
  }
  if (condition.kind == Kind::negation) {
    return "NOT (" + condition_text(condition.operands[0]) + ")";
  }
  std::string text;
  for (const ast::Condition& operand : condition.operands) {
    const bool parentheses = operand.kind == Kind::disjunction ||
                             (operand.kind == Kind::conjunction && condition.kind != operand.kind);
    text += text.empty() ? "" : (condition.kind == Kind::conjunction ? " AND " : " OR ");
    text += parentheses ? "(" + condition_text(operand) + ")" : condition_text(operand);
  }
  return text;
}

}  // namespace elsie::fuzzy
