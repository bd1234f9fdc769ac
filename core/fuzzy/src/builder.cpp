#include "builder.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "elsie/fuzzy/sets.h"

#include "compile.h"
#include "coverage.h"
#include "shapes.h"
#include "text.h"

namespace elsie::fuzzy {

namespace {

std::string quoted(const std::string& text) { return std::string("'").append(text).append("'"); }

std::string range_text(const Range& range) {
  return std::string("(").append(number_text(range.low)) + " .. " + number_text(range.high) + ")";
}

/// A word of the language and what it stands for.
template <class Value>
struct Word {
  const char* word;
  Value value;
};

constexpr std::array<Word<Operator>, 3> kAnd = {
    {{"MIN", Operator::min}, {"PROD", Operator::product}, {"BDIF", Operator::bounded_difference}}};
constexpr std::array<Word<Operator>, 4> kOr = {{{"MAX", Operator::max},
                                                {"ASUM", Operator::algebraic_sum},
                                                {"PROBOR", Operator::algebraic_sum},
                                                {"BSUM", Operator::bounded_sum}}};
constexpr std::array<Word<bool>, 2> kActivation = {{{"MIN", false}, {"PROD", true}}};
constexpr std::array<Word<Accumulation>, 6> kAccumulation = {
    {{"MAX", Accumulation::max},
     {"ASUM", Accumulation::algebraic_sum},
     {"PROBOR", Accumulation::algebraic_sum},
     {"BSUM", Accumulation::bounded_sum},
     {"NSUM", Accumulation::normalized_sum},
     {"SUM", Accumulation::normalized_sum}}};
constexpr std::array<Word<Defuzzification>, 7> kMethod = {
    {{"COG", Defuzzification::centroid},
     {"COGS", Defuzzification::centroid_of_singletons},
     {"COA", Defuzzification::bisector},
     {"LM", Defuzzification::leftmost_maximum},
     {"RM", Defuzzification::rightmost_maximum},
     {"MM", Defuzzification::mean_of_maxima},
     {"MOM", Defuzzification::mean_of_maxima}}};

/// The operator of the complements: NOT (a op b) = (NOT a) dual(op) (NOT b).
Operator dual(Operator op) {
  switch (op) {
    case Operator::min:
      return Operator::max;
    case Operator::product:
      return Operator::algebraic_sum;
    case Operator::bounded_difference:
      return Operator::bounded_sum;
    case Operator::max:
      return Operator::min;
    case Operator::algebraic_sum:
      return Operator::product;
    case Operator::bounded_sum:
      return Operator::bounded_difference;
    case Operator::leaf:
      break;
  }
  return Operator::leaf;
}

class Builder {
 public:
  Builder(const ast::FunctionBlock& block, Problems& problems)
      : block_(block), problems_(problems), model_(std::make_shared<ModelData>()) {}

  std::shared_ptr<const ModelData> run();

 private:
  struct Declared {
    bool output;
    std::size_t index;
    const ast::VariableDeclaration* declaration;
    int block_line = 0;  // of its FUZZIFY or DEFUZZIFY block
    int accumulation_line = 0;
    bool used = false;
    bool usable = false;  // has a block with terms
  };
  /// AND and OR of a rule block.
  struct Operators {
    Operator conjunction;
    Operator disjunction;
  };

  void declare(const std::vector<ast::VariableDeclaration>& variables, bool output);
  Declared* find(const ast::Name& name, const char* wanted);
  Variable& variable(const Declared& declared);
  void variable_block(const ast::VariableBlock& block, bool output);
  void output_block(const ast::VariableBlock& block, OutputVariable& output, Declared& declared);
  void range(const ast::VariableBlock& block, const Declared& declared, Variable& variable);
  std::optional<FuzzySet> term_set(const ast::Term& term, const Variable& variable);
  bool check_points(const ast::Term& term);
  void check_output_terms(const ast::VariableBlock& block, const OutputVariable& output,
                          bool method_given);

  template <class Value, std::size_t count>
  std::optional<Value> word(const std::optional<ast::Name>& name,
                            const std::array<Word<Value>, count>& words, const char* keyword);
  void accumulate(Declared& declared, Accumulation accumulation, int line);

  void rule_block(const ast::RuleBlock& block);
  void rule(const ast::RuleBlock& block, const ast::Rule& rule, const Operators& operators,
            bool scales);
  bool condition(const ast::Condition& condition, bool negated, const Operators& operators,
                 std::vector<Instruction>& into);
  bool comparison(const ast::Condition& condition, bool negated, std::vector<Instruction>& into);
  std::size_t leaf(std::size_t input, std::size_t term, bool complement);
  std::string condition_text(const ast::Condition& condition) const;

  void check_coverage();

  const ast::FunctionBlock& block_;
  Problems& problems_;
  std::shared_ptr<ModelData> model_;
  std::map<std::string, Declared> variables_;  // by name in lower case
  std::map<std::tuple<std::size_t, std::size_t, bool>, std::size_t> leaves_;

  std::vector<Conclusion> conclusions_;
};

std::shared_ptr<const ModelData> Builder::run() {
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

// --- variables ---

void Builder::declare(const std::vector<ast::VariableDeclaration>& variables, bool output) {
  for (const ast::VariableDeclaration& declaration : variables) {
    const std::size_t index = output ? model_->outputs.size() : model_->inputs.size();
    const auto [place, is_new] =
        variables_.try_emplace(lower(declaration.name.text), Declared{output, index, &declaration});
    if (!is_new) {
      const ast::Name& first = place->second.declaration->name;
      problems_.add(declaration.name.line,
                    "The variable " + quoted(declaration.name.text) +
                        " is declared a second time; the first is " + quoted(first.text) +
                        " in line " + std::to_string(first.line) +
                        ". Names are the same in any letter case: choose another one.");
      continue;
    }
    Variable named;
    named.name = declaration.name.text;
    if (output) {
      static_cast<Variable&>(model_->outputs.emplace_back()) = std::move(named);
    } else {
      model_->inputs.push_back(std::move(named));
    }
  }
}

Variable& Builder::variable(const Declared& declared) {
  return declared.output ? model_->outputs[declared.index] : model_->inputs[declared.index];
}

Builder::Declared* Builder::find(const ast::Name& name, const char* wanted) {
  const auto found = variables_.find(lower(name.text));
  if (found != variables_.end()) {
    return &found->second;
  }
  std::vector<std::string> names;
  for (const auto& [key, declared] : variables_) {
    names.push_back(declared.declaration->name.text);
  }
  problems_.add(name.line, "There is no " + std::string(wanted) + " " + quoted(name.text) + "." +
                               did_you_mean(name.text, names) + " Declare it in " +
                               (std::string_view(wanted) == "output" ? "VAR_OUTPUT" : "VAR_INPUT") +
                               " or correct the name.");
  return nullptr;
}

void Builder::variable_block(const ast::VariableBlock& block, bool output) {
  const char* keyword = output ? "DEFUZZIFY" : "FUZZIFY";
  Declared* declared = find(block.name, output ? "output" : "input");
  if (!declared) {
    return;
  }
  if (declared->output != output) {
    problems_.add(block.name.line, quoted(block.name.text) + " is an " +
                                       (output ? "input" : "output") + ", so its block is " +
                                       (output ? "FUZZIFY" : "DEFUZZIFY") + ", not " + keyword +
                                       ".");
    declared->block_line = declared->block_line ? declared->block_line : block.name.line;
    return;
  }
  if (declared->block_line) {
    problems_.add(block.name.line, "A second " + std::string(keyword) + " block of " +
                                       quoted(block.name.text) + "; the first is in line " +
                                       std::to_string(declared->block_line) +
                                       ". Put them together.");
    return;
  }
  declared->block_line = block.name.line;
  Variable& target = variable(*declared);
  range(block, *declared, target);
  if (block.terms.empty()) {
    problems_.add(block.name.line, "The variable " + quoted(block.name.text) +
                                       " has no terms. Write at least one TERM.");
  }
  std::map<std::string, const ast::Name*> seen;
  for (const ast::Term& term : block.terms) {
    const auto [place, is_new] = seen.try_emplace(lower(term.name.text), &term.name);
    if (!is_new) {
      problems_.add(term.name.line,
                    "The term " + quoted(term.name.text) + " of " + quoted(block.name.text) +
                        " is defined a second time; the first is " + quoted(place->second->text) +
                        " in line " + std::to_string(place->second->line) +
                        ". Names are the same in any letter case: choose another one.");
      continue;
    }
    std::optional<FuzzySet> set = term_set(term, target);
    target.terms.push_back({term.name.text, set.value_or(FuzzySet{}), term.singleton});
  }
  declared->usable = !target.terms.empty();
  if (!target.range_given) {
    bool any = false;
    for (const Term& term : target.terms) {
      if (!term.set.points.empty()) {
        const double low = term.set.points.front().x;
        const double high = term.set.points.back().x;
        target.range.low = any ? std::min(target.range.low, low) : low;
        target.range.high = any ? std::max(target.range.high, high) : high;
        any = true;
      }
    }
    if (!output && target.range.low == target.range.high) {
      target.range.low -= 1.0;
      target.range.high += 1.0;
    }
  }
  if (output) {
    output_block(block, model_->outputs[declared->index], *declared);
  }
}

void Builder::range(const ast::VariableBlock& block, const Declared& declared, Variable& variable) {
  const std::optional<ast::RangeStatement>& first = declared.declaration->range;
  for (const auto* statement : {&first, &block.range}) {
    if (!*statement) {
      continue;
    }
    const ast::RangeStatement& stated = **statement;
    if (!(stated.range.low < stated.range.high)) {
      problems_.add(stated.line, "The RANGE " + range_text(stated.range) + " of " +
                                     quoted(block.name.text) +
                                     " is empty: its lower end must be below its upper end.");
      continue;
    }
    if (variable.range_given && !(variable.range == stated.range)) {
      problems_.add(stated.line, "The RANGE " + range_text(stated.range) + " of " +
                                     quoted(block.name.text) + " contradicts " +
                                     range_text(variable.range) + " in line " +
                                     std::to_string(first->line) + ". Remove one of the two.");
      continue;
    }
    variable.range = stated.range;
    variable.range_given = true;
  }
}

bool Builder::check_points(const ast::Term& term) {
  const int line = term.name.line;
  if (term.points.size() == 1) {
    problems_.add(line, "The term " + quoted(term.name.text) +
                            " has one point only. Write a singleton as := " +
                            number_text(term.points[0].x) + ", or give at least two points.");
    return false;
  }
  for (std::size_t i = 0; i < term.points.size(); ++i) {
    const FuzzySet::Point& point = term.points[i];
    const std::string text = "(" + number_text(point.x) + ", " + number_text(point.degree) + ")";
    if (!(point.degree >= 0.0 && point.degree <= 1.0)) {
      problems_.add(line, "The point " + text + " of the term " + quoted(term.name.text) +
                              " has the degree " + number_text(point.degree) +
                              ". Degrees lie in 0 to 1.");
      return false;
    }
    if (i == 0) {
      continue;
    }
    const FuzzySet::Point& before = term.points[i - 1];
    if (point.x < before.x) {
      problems_.add(
          line, "The points of the term " + quoted(term.name.text) + " do not ascend: " + text +
                    " comes after x = " + number_text(before.x) + ". Put them in the order of x.");
      return false;
    }
    if (point.x == before.x &&
        (point.degree == before.degree || (i > 1 && term.points[i - 2].x == point.x))) {
      problems_.add(line, "The points of the term " + quoted(term.name.text) +
                              " do not ascend: x = " + number_text(point.x) +
                              " comes too often. A step has two points of one x, with different "
                              "degrees.");
      return false;
    }
  }
  return true;
}

std::optional<FuzzySet> Builder::term_set(const ast::Term& term, const Variable& variable) {
  if (term.singleton) {
    const double x = *term.singleton;
    if (variable.range_given && (x < variable.range.low || x > variable.range.high)) {
      problems_.add(term.name.line, "The singleton " + quoted(term.name.text) + " at " +
                                        number_text(x) + " lies outside the RANGE " +
                                        range_text(variable.range) + " of " +
                                        quoted(variable.name) + ". Correct one of the two.");
      return std::nullopt;
    }
    return FuzzySet{{{x, 0.0}, {x, 1.0}, {x, 0.0}}};
  }
  if (!term.points.empty()) {
    return check_points(term) ? std::optional(FuzzySet{term.points}) : std::nullopt;
  }
  try {
    return make_shape(term.shape, term.parameters,
                      variable.range_given ? std::optional(variable.range) : std::nullopt);
  } catch (const std::invalid_argument& problem) {
    problems_.add(term.name.line, "In the term " + quoted(term.name.text) + " of " +
                                      quoted(variable.name) + ": " + problem.what());
    return std::nullopt;
  }
}

// --- outputs ---

template <class Value, std::size_t count>
std::optional<Value> Builder::word(const std::optional<ast::Name>& name,
                                   const std::array<Word<Value>, count>& words,
                                   const char* keyword) {
  if (!name || same_name(name->text, "none")) {
    return std::nullopt;  // some tools write NONE for what is not set
  }
  std::vector<std::string> known;
  for (const Word<Value>& candidate : words) {
    if (same_name(candidate.word, name->text)) {
      return candidate.value;
    }
    known.emplace_back(candidate.word);
  }
  problems_.add(name->line, "Found " + quoted(name->text) + " for " + keyword + ", expected " +
                                one_of(known) + ".");
  return std::nullopt;
}

void Builder::output_block(const ast::VariableBlock& block, OutputVariable& output,
                           Declared& declared) {
  const bool all_singletons =
      !output.terms.empty() && std::all_of(output.terms.begin(), output.terms.end(),
                                           [](const Term& t) { return t.singleton.has_value(); });
  const std::optional<Defuzzification> method = word(block.method, kMethod, "METHOD");
  output.method = method.value_or(all_singletons ? Defuzzification::centroid_of_singletons
                                                 : Defuzzification::centroid);
  if (const auto accumulation = word(block.accumulation, kAccumulation, "ACCU")) {
    accumulate(declared, *accumulation, block.accumulation->line);
  }
  if (block.default_value) {
    const ast::DefaultStatement& statement = *block.default_value;
    output.default_value = statement.value;
    output.keeps_last = statement.no_change;
    if (statement.value && output.range_given &&
        (*statement.value < output.range.low || *statement.value > output.range.high)) {
      problems_.add(statement.line, "The DEFAULT " + number_text(*statement.value) + " of " +
                                        quoted(output.name) + " lies outside its RANGE " +
                                        range_text(output.range) + ". Correct one of the two.");
    }
  }
  check_output_terms(block, output, method.has_value());
}

void Builder::check_output_terms(const ast::VariableBlock& block, const OutputVariable& output,
                                 bool method_given) {
  const auto singletons = std::count_if(output.terms.begin(), output.terms.end(),
                                        [](const Term& t) { return t.singleton.has_value(); });
  const int line = method_given ? block.method->line : block.name.line;
  const bool needs_singletons = output.method == Defuzzification::centroid_of_singletons;
  const bool needs_area =
      output.method == Defuzzification::centroid || output.method == Defuzzification::bisector;
  if (singletons > 0 && singletons < static_cast<std::ptrdiff_t>(output.terms.size())) {
    problems_.add(block.name.line, "The output " + quoted(output.name) +
                                       " has singletons beside terms with an area. Make all its "
                                       "terms of one kind.");
    return;
  }
  if (needs_singletons && singletons == 0 && !output.terms.empty()) {
    problems_.add(line, "COGS works on singletons, but the terms of " + quoted(output.name) +
                            " have an area. Use COG, or write the terms as := value.");
    return;
  }
  if (needs_area && singletons > 0) {
    problems_.add(line, "The terms of " + quoted(output.name) +
                            " are singletons, which have no area. Use METHOD : COGS.");
    return;
  }
  if (singletons > 0) {
    return;
  }
  for (std::size_t i = 0; i < output.terms.size(); ++i) {
    const Term& term = output.terms[i];
    if (!term.set.points.empty() &&
        !(output.range.low < output.range.high &&
          area(restricted(term.set, output.range.low, output.range.high)) > 0.0)) {
      const auto written =
          std::find_if(block.terms.begin(), block.terms.end(),
                       [&](const ast::Term& t) { return t.name.text == term.name; });
      problems_.add(written->name.line,
                    "The term " + quoted(term.name) + " of " + quoted(output.name) +
                        " has no area within " + range_text(output.range) +
                        ", so that nothing can be concluded from it. Correct the term or the "
                        "RANGE.");
    }
  }
}

void Builder::accumulate(Declared& declared, Accumulation accumulation, int line) {
  OutputVariable& output = model_->outputs[declared.index];
  if (declared.accumulation_line && output.accumulation != accumulation) {
    problems_.add(line, "This ACCU contradicts that of line " +
                            std::to_string(declared.accumulation_line) + " for the output " +
                            quoted(output.name) +
                            ". An output has one accumulation: make them "
                            "the same.");
    return;
  }
  output.accumulation = accumulation;
  declared.accumulation_line = line;
}

// --- rules ---

void Builder::rule_block(const ast::RuleBlock& block) {
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
    problems_.add(block.name.line, "The rule block has no rules. Write one, or remove the block.");
  }
  const std::size_t first_conclusion = conclusions_.size();
  std::map<std::string, int> labels;
  for (const ast::Rule& written : block.rules) {
    const auto [place, is_new] = labels.try_emplace(lower(written.label.text), written.label.line);
    if (!is_new) {
      problems_.add(written.label.line, "A second rule " + written.label.text +
                                            " in this block; the first is in line " +
                                            std::to_string(place->second) + ". Number it anew.");
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

void Builder::rule(const ast::RuleBlock& block, const ast::Rule& rule, const Operators& operators,
                   bool scales) {
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
  for (std::size_t i = 0; i < rule.conclusions.size(); ++i) {
    const ast::Conclusion& conclusion = rule.conclusions[i];
    shown.text += (i == 0 ? "" : ", ") + conclusion.variable.text + " IS " + conclusion.term.text;
    Declared* declared = find(conclusion.variable, "output");
    if (!declared) {
      continue;
    }
    if (!declared->output) {
      problems_.add(conclusion.variable.line,
                    quoted(conclusion.variable.text) +
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
      problems_.add(conclusion.term.line, "The output " + quoted(output.name) + " has no term " +
                                              quoted(conclusion.term.text) + "." +
                                              did_you_mean(conclusion.term.text, names) +
                                              " Its terms are " + one_of(names) + ".");
      continue;
    }
    conclusions_.push_back({model_->rules.size(), declared->index,
                            static_cast<std::size_t>(term - output.terms.data()), scales});
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

bool Builder::condition(const ast::Condition& condition, bool negated, const Operators& operators,
                        std::vector<Instruction>& into) {
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

bool Builder::comparison(const ast::Condition& condition, bool negated,
                         std::vector<Instruction>& into) {
  Declared* declared = find(condition.variable, "input");
  if (!declared) {
    return false;
  }
  if (declared->output) {
    problems_.add(condition.variable.line,
                  quoted(condition.variable.text) +
                      " is an output. A condition asks for inputs; correct the name.");
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
    problems_.add(condition.term.line, "The input " + quoted(input.name) + " has no term " +
                                           quoted(condition.term.text) + "." +
                                           did_you_mean(condition.term.text, names) +
                                           " Its terms are " + one_of(names) + ".");
    return false;
  }
  if (term->set.points.empty()) {
    return false;  // reported with the term
  }
  const auto index = static_cast<std::size_t>(term - input.terms.data());
  into.push_back({Operator::leaf, leaf(declared->index, index, negated)});
  return true;
}

std::size_t Builder::leaf(std::size_t input, std::size_t term, bool complement) {
  const auto [place, is_new] =
      leaves_.try_emplace(std::tuple(input, term, complement), model_->leaves.size());
  if (is_new) {
    const Term& of = model_->inputs[input].terms[term];
    // At a step a set takes its larger degree, and so its complement the smaller of its own two.
    Leaf made(input, complement ? complement_of(of.set) : of.set);
    if (complement) {
      for (Leaf::Knot& knot : made.knots) {
        knot.degree = 1.0 - of.set.degree(knot.x);
      }
    }
    model_->leaves.push_back(std::move(made));
  }
  return place->second;
}

std::string Builder::condition_text(const ast::Condition& condition) const {
  using Kind = ast::Condition::Kind;
  if (condition.kind == Kind::is || condition.kind == Kind::is_not) {
    return condition.variable.text + (condition.kind == Kind::is ? " IS " : " IS NOT ") +
           condition.term.text;
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

void Builder::check_coverage() {
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

}  // namespace

std::shared_ptr<const ModelData> build(const ast::FunctionBlock& block, Problems& problems) {
  return Builder(block, problems).run();
}

}  // namespace elsie::fuzzy
