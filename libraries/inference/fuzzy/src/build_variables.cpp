// Builds variables: their ranges, terms and algorithms.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "elsie/fuzzy/sets.h"

#include "model_builder.h"
#include "shapes.h"

namespace elsie::fuzzy {

void ModelBuilder::declare(const std::vector<ast::VariableDeclaration>& variables, bool output) {
  for (const ast::VariableDeclaration& declaration : variables) {
    const std::size_t index = output ? model_->outputs.size() : model_->inputs.size();
    const auto [place, is_new] =
        variables_.try_emplace(lower(declaration.name.text), Declared{output, index, &declaration});
    if (!is_new) {
      const ast::Name& first = place->second.declaration->name;
      problems_.add(declaration.name.line,
                    "The variable " + name_in_quotes(declaration.name.text) +
                        " is declared a second time; the first is " + name_in_quotes(first.text) +
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

Variable& ModelBuilder::variable(const Declared& declared) {
  return declared.output ? model_->outputs[declared.index] : model_->inputs[declared.index];
}

ModelBuilder::Declared* ModelBuilder::find(const ast::Name& name, const char* wanted) {
  const auto found = variables_.find(lower(name.text));
  if (found != variables_.end()) {
    return &found->second;
  }
  std::vector<std::string> names;
  for (const auto& [key, declared] : variables_) {
    names.push_back(declared.declaration->name.text);
  }
  problems_.add(name.line, "There is no " + std::string(wanted) + " " + name_in_quotes(name.text) +
                               "." + did_you_mean(name.text, names) + " Declare it in " +
                               (std::string_view(wanted) == "output" ? "VAR_OUTPUT" : "VAR_INPUT") +
                               " or correct the name.");
  return nullptr;
}

void ModelBuilder::variable_block(const ast::VariableBlock& block, bool output) {
  const char* keyword = output ? "DEFUZZIFY" : "FUZZIFY";
  Declared* declared = find(block.name, output ? "output" : "input");
  if (!declared) {
    return;
  }
  if (declared->output != output) {
    problems_.add(block.name.line, name_in_quotes(block.name.text) + " is an " +
                                       (output ? "input" : "output") + ", so its block is " +
                                       (output ? "FUZZIFY" : "DEFUZZIFY") + ", not " + keyword +
                                       ".");
    declared->block_line = declared->block_line ? declared->block_line : block.name.line;
    return;
  }
  if (declared->block_line) {
    problems_.add(block.name.line, "A second " + std::string(keyword) + " block of " +
                                       name_in_quotes(block.name.text) + "; the first is in line " +
                                       std::to_string(declared->block_line) +
                                       ". Put them together.");
    return;
  }
  declared->block_line = block.name.line;
  Variable& target = variable(*declared);
  range(block, *declared, target);
  if (output && block.terms.empty()) {
    problems_.add(block.name.line, "The variable " + name_in_quotes(block.name.text) +
                                       " has no terms. Write at least one TERM.");
  }
  std::map<std::string, const ast::Name*> seen;
  for (const ast::Term& written : block.terms) {
    const ast::Term term = with_singleton(written);
    const auto [place, is_new] = seen.try_emplace(lower(term.name.text), &written.name);
    if (!is_new) {
      problems_.add(
          term.name.line,
          "The term " + name_in_quotes(term.name.text) + " of " + name_in_quotes(block.name.text) +
              " is defined a second time; the first is " + name_in_quotes(place->second->text) +
              " in line " + std::to_string(place->second->line) +
              ". Names are the same in any letter case: choose another one.");
      continue;
    }
    if (output && same_name(term.shape, "linear")) {
      linear_term(term, target);
      continue;
    }
    if (output && term.formula) {
      formula_term(term, declared->index);
      continue;
    }
    std::optional<FuzzySet> set = term_set(term, target);
    target.terms.push_back({term.name.text, set.value_or(FuzzySet{}), term.singleton, {}, ""});
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

void ModelBuilder::range(const ast::VariableBlock& block, const Declared& declared,
                         Variable& variable) {
  const std::optional<ast::RangeStatement>& first = declared.declaration->range;
  for (const auto* statement : {&first, &block.range}) {
    if (!*statement) {
      continue;
    }
    const ast::RangeStatement& stated = **statement;
    if (!(stated.range.low < stated.range.high)) {
      problems_.add(stated.line, "The RANGE " + range_text(stated.range) + " of " +
                                     name_in_quotes(block.name.text) +
                                     " is empty: its lower end must be below its upper end.");
      continue;
    }
    if (variable.range_given && !(variable.range == stated.range)) {
      problems_.add(stated.line, "The RANGE " + range_text(stated.range) + " of " +
                                     name_in_quotes(block.name.text) + " contradicts " +
                                     range_text(variable.range) + " in line " +
                                     std::to_string(first->line) + ". Remove one of the two.");
      continue;
    }
    variable.range = stated.range;
    variable.range_given = true;
  }
}

const char* tool_of(std::string_view word) {
  constexpr std::array kJFuzzyLogic = {"DMIN", "NIPMIN", "HAMACHER", "DMAX", "NIPMAX", "EINSTEIN"};
  constexpr std::array kFuzzylite = {"DPROD", "EPROD", "HPROD", "NMIN",
                                     "DSUM",  "ESUM",  "HSUM",  "NMAX"};
  const auto has = [&](const auto& words) {
    return std::any_of(words.begin(), words.end(),
                       [&](const char* known) { return same_name(known, word); });
  };
  return has(kJFuzzyLogic) ? "jFuzzyLogic" : has(kFuzzylite) ? "fuzzylite" : nullptr;
}

/// A term of one point, perhaps repeated, is what the standard writes as := x.
ast::Term ModelBuilder::with_singleton(const ast::Term& term) {
  const auto is_first = [&](const FuzzySet::Point& point) { return point == term.points.front(); };
  std::optional<double> x = only_corner(term.shape, term.parameters);
  if (!term.points.empty() && term.points.front().degree == 1.0 &&
      std::all_of(term.points.begin(), term.points.end(), is_first)) {
    x = term.points.front().x;
  }
  if (!x) {
    return term;
  }
  problems_.add_note(term.name.line, "The term " + name_in_quotes(term.name.text) +
                                         " has one point only and is read as the singleton := " +
                                         number_text(*x) + ".");
  return {term.name, {}, x, {}, {}, {}};
}

/// Reduces points with the same x to the first and the last, unless another is higher or lower.
std::vector<FuzzySet::Point> ModelBuilder::without_repetitions(const ast::Term& term) {
  std::vector<FuzzySet::Point> kept;
  bool repeats = false;
  for (auto at = term.points.begin(); at != term.points.end();) {
    const auto end = std::find_if(at, term.points.end(),
                                  [&](const FuzzySet::Point& point) { return point.x != at->x; });
    const auto [low, high] = std::minmax(at->degree, (end - 1)->degree);
    const bool stands_out =
        std::any_of(at, end, [low = low, high = high](const FuzzySet::Point& point) {
          return point.degree < low || point.degree > high;
        });
    const bool is_step = end - at == 2 && low < high;
    if (end - at == 1 || is_step || stands_out) {
      kept.insert(kept.end(), at, end);
    } else {
      repeats = true;
      kept.push_back(*at);
      if (low < high) {
        kept.push_back(*(end - 1));
      }
    }
    at = end;
  }
  if (repeats) {
    problems_.add_note(term.name.line, "The term " + name_in_quotes(term.name.text) +
                                           " repeats points of one x. Write each once; a step has "
                                           "two.");
  }
  return kept;
}

bool ModelBuilder::check_points(const ast::Term& term) {
  const int line = term.name.line;
  if (term.points.size() == 1) {
    problems_.add(line, "The term " + name_in_quotes(term.name.text) +
                            " has one point only. Write a singleton as := " +
                            number_text(term.points[0].x) + ", or give at least two points.");
    return false;
  }
  for (std::size_t i = 0; i < term.points.size(); ++i) {
    const FuzzySet::Point& point = term.points[i];
    const std::string text = "(" + number_text(point.x) + ", " + number_text(point.degree) + ")";
    if (!(point.degree >= 0.0 && point.degree <= 1.0)) {
      problems_.add(line, "The point " + text + " of the term " + name_in_quotes(term.name.text) +
                              " has the degree " + number_text(point.degree) +
                              ". Degrees lie in 0 to 1.");
      return false;
    }
    if (i == 0) {
      continue;
    }
    const FuzzySet::Point& before = term.points[i - 1];
    if (point.x < before.x) {
      problems_.add(line, "The points of the term " + name_in_quotes(term.name.text) +
                              " do not ascend: " + text + " comes after x = " +
                              number_text(before.x) + ". Put them in the order of x.");
      return false;
    }
    if (point.x == before.x &&
        (point.degree == before.degree || (i > 1 && term.points[i - 2].x == point.x))) {
      problems_.add(line, "The points of the term " + name_in_quotes(term.name.text) +
                              " do not ascend: x = " + number_text(point.x) +
                              " occurs too often. A step has two points of one x, with different "
                              "degrees.");
      return false;
    }
  }
  return true;
}

std::optional<FuzzySet> ModelBuilder::term_set(const ast::Term& term, const Variable& variable) {
  if (term.singleton) {
    const double x = *term.singleton;
    if (variable.range_given && (x < variable.range.low || x > variable.range.high)) {
      problems_.add(term.name.line,
                    "The singleton " + name_in_quotes(term.name.text) + " at " + number_text(x) +
                        " lies outside the RANGE " + range_text(variable.range) + " of " +
                        name_in_quotes(variable.name) + ". Correct one of the two.");
      return std::nullopt;
    }
    return FuzzySet{{{x, 0.0}, {x, 1.0}, {x, 0.0}}};
  }
  if (!term.points.empty()) {
    ast::Term tidy = term;
    tidy.points = without_repetitions(term);
    return check_points(tidy) ? std::optional(FuzzySet{tidy.points}) : std::nullopt;
  }
  if (term.formula) {
    problems_.add(term.name.line, "The term " + name_in_quotes(term.name.text) + " of the input " +
                                      name_in_quotes(variable.name) +
                                      " is a formula, which says where a term of an output "
                                      "stands. Write points or a shape.");
    return std::nullopt;
  }
  try {
    return make_shape(term.shape, term.parameters,
                      variable.range_given ? std::optional(variable.range) : std::nullopt);
  } catch (const std::invalid_argument& problem) {
    problems_.add(term.name.line, "In the term " + name_in_quotes(term.name.text) + " of " +
                                      name_in_quotes(variable.name) + ": " + problem.what());
    return std::nullopt;
  }
}

/// a b c: a times the first input, plus b times the second, plus c.
void ModelBuilder::linear_term(const ast::Term& term, Variable& variable) {
  if (term.parameters.size() != model_->inputs.size() + 1) {
    problems_.add(term.name.line, "Linear needs a number for each input and one more, " +
                                      std::to_string(model_->inputs.size() + 1) +
                                      " in all, but the term " + name_in_quotes(term.name.text) +
                                      " of " + name_in_quotes(variable.name) + " has " +
                                      std::to_string(term.parameters.size()) + ".");
    variable.terms.push_back({term.name.text, FuzzySet{}, 0.0, {}, ""});
    return;
  }
  double x = term.parameters.back();
  for (std::size_t i = 0; i < model_->inputs.size(); ++i) {
    const Range& range = model_->inputs[i].range;
    x += term.parameters[i] * 0.5 * (range.low + range.high);
    if (term.parameters[i] != 0.0) {
      variables_.at(lower(model_->inputs[i].name)).in_formula = true;
    }
  }
  variable.terms.push_back(
      {term.name.text, FuzzySet{{{x, 0.0}, {x, 1.0}, {x, 0.0}}}, x, term.parameters, ""});
}

/// Shown at 0 if it has no value in the middle of the inputs' ranges.
void ModelBuilder::formula_term(const ast::Term& term, std::size_t output) {
  Formula formula = term.formula->steps;
  for (FormulaStep& step : formula) {
    if (step.op != FormulaOp::input) {
      continue;
    }
    const ast::Name& name = term.formula->variables[step.input];
    Declared* input = find(name, "input");
    if (input && input->output) {
      problems_.add(name.line, name_in_quotes(name.text) +
                                   " is an output. A formula works on inputs; correct the name. "
                                   "(Formulas of outputs are a fuzzylite extension, which is not "
                                   "supported.)");
    }
    step.input = 0;
    if (input && !input->output) {
      input->in_formula = true;
      step.input = input->index;
    }
  }
  std::vector<double> middle;
  for (const Variable& input : model_->inputs) {
    middle.push_back(0.5 * (input.range.low + input.range.high));
  }
  const double value = middle.empty() ? 0.0 : value_of(formula, middle);
  const double x = std::abs(value) <= kFurthestPlace ? value : 0.0;
  Variable& variable = model_->outputs[output];
  model_->formulas[{output, variable.terms.size()}] = std::move(formula);
  variable.terms.push_back(
      {term.name.text, FuzzySet{{{x, 0.0}, {x, 1.0}, {x, 0.0}}}, x, {}, term.formula->text});
}

void ModelBuilder::output_block(const ast::VariableBlock& block, OutputVariable& output,
                                Declared& declared) {
  const bool all_singletons =
      !output.terms.empty() && std::all_of(output.terms.begin(), output.terms.end(),
                                           [](const Term& t) { return t.singleton.has_value(); });
  std::optional<Defuzzification> method = word(block.method, kMethod, "METHOD");
  if (all_singletons && method == Defuzzification::centroid) {
    problems_.add_note(block.method->line, "The terms of " + name_in_quotes(output.name) +
                                               " are singletons, whose centre of gravity is that "
                                               "of COGS. Write METHOD : COGS.");
    method = Defuzzification::centroid_of_singletons;
  }
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
                                        name_in_quotes(output.name) + " lies outside its RANGE " +
                                        range_text(output.range) + ". Correct one of the two.");
    }
  }
  check_output_terms(block, output, method.has_value());
}

const ast::Name& written_as(const Term& term, const ast::VariableBlock& block) {
  return std::find_if(block.terms.begin(), block.terms.end(),
                      [&](const ast::Term& written) { return written.name.text == term.name; })
      ->name;
}

/// Among terms with an area, one of a single point adds nothing to the centre of gravity. Where it
/// is written as := x, it is a mistake.
void ModelBuilder::take_points_for_terms_without_area(const ast::VariableBlock& block,
                                                      OutputVariable& output) {
  const auto has_place = [](const auto& term) { return term.singleton.has_value(); };
  if (std::any_of(block.terms.begin(), block.terms.end(), has_place) ||
      std::all_of(output.terms.begin(), output.terms.end(), has_place)) {
    return;
  }
  for (Term& term : output.terms) {
    if (term.singleton && term.linear.empty() && term.formula.empty()) {
      problems_.add_note(written_as(term, block).line,
                         "The term " + name_in_quotes(term.name) + " of " +
                             name_in_quotes(output.name) +
                             " has no area, so that it has no effect among terms with an area. "
                             "Give it a width.");
      term.singleton.reset();
    }
  }
}

void ModelBuilder::check_output_terms(const ast::VariableBlock& block, OutputVariable& output,
                                      bool method_given) {
  if (output.method == Defuzzification::centroid) {
    take_points_for_terms_without_area(block, output);
  }
  const auto singletons = std::count_if(output.terms.begin(), output.terms.end(),
                                        [](const Term& t) { return t.singleton.has_value(); });
  const int line = method_given ? block.method->line : block.name.line;
  const bool needs_singletons = output.method == Defuzzification::centroid_of_singletons;
  const bool needs_area =
      output.method == Defuzzification::centroid || output.method == Defuzzification::bisector;
  if (singletons > 0 && singletons < static_cast<std::ptrdiff_t>(output.terms.size())) {
    problems_.add(block.name.line, "The output " + name_in_quotes(output.name) +
                                       " has both singletons and terms with an area. Make all its "
                                       "terms of one kind.");
    return;
  }
  if (needs_singletons && singletons == 0 && !output.terms.empty()) {
    problems_.add(line, "COGS works on singletons, but the terms of " +
                            name_in_quotes(output.name) +
                            " have an area. Use COG, or write the terms as := value. (COGS of "
                            "sloping terms, Tsukamoto's method, is a fuzzylite extension, which "
                            "is not supported.)");
    return;
  }
  if (needs_area && singletons > 0) {
    problems_.add(line, "The terms of " + name_in_quotes(output.name) +
                            " are singletons, which have no area. Use METHOD : COGS.");
    return;
  }
  if (singletons > 0) {
    return;
  }
  for (std::size_t i = 0; i < output.terms.size(); ++i) {
    const Term& term = output.terms[i];
    if (!term.set.points.empty() && !is_point(term) &&
        !(output.range.low < output.range.high &&
          area(restricted(term.set, output.range.low, output.range.high)) > 0.0)) {
      problems_.add(written_as(term, block).line,
                    "The term " + name_in_quotes(term.name) + " of " + name_in_quotes(output.name) +
                        " has no area within " + range_text(output.range) +
                        ", so that nothing can be concluded from it. Correct the term or the "
                        "RANGE.");
    }
  }
}

void ModelBuilder::accumulate(Declared& declared, Accumulation accumulation, int line) {
  OutputVariable& output = model_->outputs[declared.index];
  if (declared.accumulation_line && output.accumulation != accumulation) {
    problems_.add(line, "This ACCU contradicts that of line " +
                            std::to_string(declared.accumulation_line) + " for the output " +
                            name_in_quotes(output.name) +
                            ". An output has one accumulation: make them "
                            "the same.");
    return;
  }
  output.accumulation = accumulation;
  declared.accumulation_line = line;
}

}  // namespace elsie::fuzzy
