// The statements of an FCL file before they are checked.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "elsie/base/fuzzy_set.h"
#include "elsie/fuzzy/model.h"

#include "formula.h"

namespace elsie::fuzzy::ast {

struct Name {
  std::string text;
  int line = 0;
};

struct RangeStatement {
  Range range;
  int line = 0;
};

/// A formula whose inputs are names: a step of op input is an index into `variables`.
struct Formula {
  std::string text;
  std::vector<FormulaStep> steps;
  std::vector<Name> variables;
};

struct Term {
  Name name;
  std::vector<FuzzySet::Point> points;  // only of a list of points
  std::optional<double> singleton;
  std::string shape;
  std::vector<double> parameters;  // only of a shape
  std::optional<Formula> formula;
};

struct VariableDeclaration {
  Name name;
  std::optional<RangeStatement> range;
};

struct DefaultStatement {
  std::optional<double> value;
  bool no_change = false;
  int line = 0;
};

/// A FUZZIFY or DEFUZZIFY block.
struct VariableBlock {
  Name name;
  std::optional<RangeStatement> range;
  std::vector<Term> terms;
  // only in DEFUZZIFY:
  std::optional<Name> method;
  std::optional<Name> accumulation;
  std::optional<DefaultStatement> default_value;
};

struct Condition {
  enum Kind { is, is_not, negation, conjunction, disjunction } kind = is;
  Name variable;                    // only of is and is_not
  Name term;                        // only of is and is_not
  std::string hedges;               // only of is and is_not: "very", "very very"...
  std::vector<Condition> operands;  // only of the others
};

struct Conclusion {
  Name variable;
  Name term;
  std::string hedges;  // as in a condition
};

struct Rule {
  Name label;
  Condition condition;
  std::vector<Conclusion> conclusions;
  double weight = 1.0;
};

struct RuleBlock {
  Name name;
  std::optional<Name> conjunction;
  std::optional<Name> disjunction;
  std::optional<Name> activation;
  std::optional<Name> accumulation;
  std::vector<Rule> rules;
};

struct FunctionBlock {
  Name name;
  int first_line = 0;
  int last_line = 0;
  std::vector<VariableDeclaration> inputs;
  std::vector<VariableDeclaration> outputs;
  std::vector<VariableBlock> fuzzify;
  std::vector<VariableBlock> defuzzify;
  std::vector<RuleBlock> rule_blocks;
};

}  // namespace elsie::fuzzy::ast
