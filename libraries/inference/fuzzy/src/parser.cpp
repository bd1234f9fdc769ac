#include "parser.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "formula_reader.h"

namespace elsie::fuzzy {

namespace {

/// Deeper nesting is an error.
constexpr int kDeepest = 100;

/// Hedges that fuzzylite allows before a term; see shapes.h.
constexpr std::array kHedges = {"very", "extremely", "somewhat", "seldom"};
/// Hedges of other tools.
constexpr std::array kOtherHedges = {"any", "slightly", "more", "indeed"};

class Parser : private FormulaReader {
 public:
  using FormulaReader::FormulaReader;

  std::vector<ast::FunctionBlock> run() {
    try {
      file();
    } catch (const FileLost&) {
    }
    return std::move(blocks_);
  }

 private:
  // --- the file ---

  void file() {
    if (at_end()) {
      note(now().line, "The file has no statements. Expected FUNCTION_BLOCK.");
      return;
    }
    if (!at_word("function_block")) {
      note(now().line, "Found " + found() + ", expected FUNCTION_BLOCK at the beginning.");
      return;
    }
    do {
      blocks_.emplace_back();
      function_block();
      blocks_.back().last_line = last().line;
    } while (at_word("function_block"));
    if (!at_end()) {
      problems().forget(now().line, std::numeric_limits<int>::max());
      problems().add_note(now().line, "Found " + found() +
                                          " after END_FUNCTION_BLOCK. Nothing from here on is "
                                          "read: remove it.");
    }
  }

  void function_block() {
    current().first_line = take().line;
    try {
      if (now().kind == TokenKind::word && !at_landmark()) {
        current().name = block_name();
      }
    } catch (const StatementLost&) {
      skip_to_landmark();
    }
    while (!at_end() && !at_word("end_function_block")) {
      section();
    }
    if (!accept_word("end_function_block")) {
      note(now().line, "The file ends before END_FUNCTION_BLOCK. Is it complete?");
      return;
    }
    accept_symbol(";");
  }

  ast::FunctionBlock& current() { return blocks_.back(); }

  /// One word in the standard; some tools write several on the line.
  ast::Name block_name() {
    const char* const begin = now().text.data();
    ast::Name result = name("the name of the function block");
    bool is_word = result.text.find('-') == std::string::npos;
    while (!at_end() && !now().first_on_line && !at_landmark()) {
      take();
      is_word = false;
    }
    if (!is_word) {
      result.text.assign(begin, last().text.data() + last().text.size());
      problems().add_note(result.line, "The name of the function block, '" + result.text +
                                           "', is not one word. Write '_' between its parts.");
    }
    return result;
  }

  void section() {
    try {
      declared_.reset();
      if (accept_word("var_input")) {
        block("VAR_INPUT", "END_VAR", [this] { declaration(current().inputs); });
      } else if (accept_word("var_output")) {
        block("VAR_OUTPUT", "END_VAR", [this] { declaration(current().outputs); });
      } else if (at_word("fuzzify") || at_word("defuzzify")) {
        variable_block();
      } else if (accept_word("ruleblock")) {
        rule_block();
      } else if (at_landmark()) {
        note(now().line, "Found " + found() + ", but no such block is open here. Remove it.");
        take();
      } else {
        lose_expecting(
            "VAR_INPUT, VAR_OUTPUT, FUZZIFY, DEFUZZIFY, RULEBLOCK or "
            "END_FUNCTION_BLOCK");
      }
    } catch (const StatementLost&) {
      skip_to_landmark();
    }
  }

  void skip_to_landmark() {
    while (!at_end() && !at_landmark()) {
      take();
    }
  }

  /// a, b : REAL RANGE := (0 .. 1); or RANGE := (0 .. 1); for the declaration before it.
  void declaration(std::vector<ast::VariableDeclaration>& into) {
    if (at_word("range") && next().text == ":=" && declared_) {
      const int line = take().line;
      const ast::RangeStatement stated = range();
      expect_semicolon("RANGE");
      if (*declared_ > 0) {
        const auto first = into.end() - static_cast<std::ptrdiff_t>(*declared_);
        set_once(first->range, stated, line, "RANGE");
        std::for_each(first, into.end(), [&](auto& variable) { variable.range = first->range; });
      }
      return;
    }
    declared_ = 0;
    std::vector<ast::VariableDeclaration> declared;
    do {
      declared.push_back({new_name("the name of a variable"), std::nullopt});
    } while (accept_symbol(","));
    expect_symbol(":", "between the name of a variable and its type");
    if (!at_word("real") && !at_word("lreal")) {
      lose("Found " + found() + ", expected the type REAL: fuzzy models work on real numbers.");
    }
    take();
    std::optional<ast::RangeStatement> stated;
    if (accept_word("range")) {
      stated = range();
    }
    expect_semicolon("variable");
    declared_ = declared.size();
    for (ast::VariableDeclaration& variable : declared) {
      variable.range = stated;
      into.push_back(std::move(variable));
    }
  }

  void variable_block() {
    const bool output = at_word("defuzzify");
    const std::string keyword = output ? "DEFUZZIFY" : "FUZZIFY";
    take();
    ast::VariableBlock variable;
    variable.name = name("the name of a variable after " + keyword);
    block(keyword, "END_" + keyword, [&] {
      if (accept_word("term")) {
        variable.terms.push_back(term());
        expect_semicolon("TERM");
      } else if (at_word("range")) {
        const int line = take().line;
        const ast::RangeStatement stated = range();
        expect_semicolon("RANGE");
        set_once(variable.range, stated, line, "RANGE");
      } else if (output && at_word("method")) {
        option(variable.method, "METHOD");
      } else if (output && at_word("accu")) {
        option(variable.accumulation, "ACCU");
      } else if (output && at_word("default")) {
        default_value(variable);
      } else if (at_word("enabled")) {
        enabled();
      } else if (at_word("lock")) {
        lose(
            "LOCK is a fuzzylite extension, which is not supported: remove it, and write "
            "DEFAULT := NC for an output that keeps its last value.");
      } else {
        lose_expecting(output ? "TERM, METHOD, ACCU, DEFAULT, RANGE or END_DEFUZZIFY"
                              : "TERM, RANGE or END_FUZZIFY");
      }
    });
    (output ? current().defuzzify : current().fuzzify).push_back(std::move(variable));
  }

  /// DEFAULT := 0.5;   DEFAULT := NC;   DEFAULT := 0.5 | NC;   DEFAULT := nan;
  void default_value(ast::VariableBlock& variable) {
    ast::DefaultStatement statement;
    statement.line = take().line;
    expect_symbol(":=", "after DEFAULT");
    if (accept_word("nc")) {
      statement.no_change = true;
    } else {
      if (!accept_word("nan")) {
        statement.value = number("a number or NC after DEFAULT");
      }
      if (accept_symbol("|")) {
        if (!accept_word("nc")) {
          lose_expecting("NC after '|'");
        }
        statement.no_change = true;
      }
    }
    expect_semicolon("DEFAULT");
    set_once(variable.default_value, statement, statement.line, "DEFAULT");
  }

  /// name := (x, y) (x, y);   name := 5;   name := Triangle 0 1 2;   after the word TERM.
  ast::Term term() {
    ast::Term result;
    result.name = new_name("the name of a term");
    expect_symbol(":=", "after the name of the term");
    if (at_symbol("(")) {
      while (accept_symbol("(")) {
        FuzzySet::Point point;
        if (now().kind == TokenKind::word && !at_word("nan") && !at_word("inf")) {
          lose("Found " + found() +
               " for the x of a point. A point that moves with a variable is a jFuzzyLogic "
               "extension, which is not supported: write a number.");
        }
        point.x = number("the x of a point, a number");
        expect_symbol(",", "between x and degree of a point");
        point.degree = number("the degree of a point, a number");
        expect_symbol(")", "after the degree of a point");
        result.points.push_back(point);
        accept_symbol(",");
      }
    } else if (now().kind == TokenKind::word && !at_landmark() &&
               !(now().first_on_line && contains(kStatements, now().text))) {
      if (accept_word("function")) {
        result.formula = formula();
        return result;
      }
      result.shape = take().text;
      const bool in_parentheses = accept_symbol("(");
      while (now().kind == TokenKind::number || at_symbol("-") || at_symbol("+") ||
             at_word("inf") || at_symbol(",")) {
        if (accept_symbol(",")) {
          continue;
        }
        result.parameters.push_back(parameter());
      }
      if (now().kind == TokenKind::word && !now().first_on_line && !at_landmark()) {
        lose("Found " + found() + " among the numbers of " + result.shape +
             ". A shape that moves with a variable is a jFuzzyLogic extension, which is not "
             "supported: write a number.");
      }
      if (in_parentheses) {
        expect_symbol(")", "after the parameters of " + result.shape);
      }
    } else {
      result.singleton = number("points (x, y), a number or a shape such as Triangle 0 1 2");
    }
    return result;
  }

  /// ENABLED : TRUE; which fuzzylite writes unless something is switched off.
  void enabled() {
    take();
    expect_symbol(":", "after ENABLED");
    if (!accept_word("true")) {
      lose("Found " + found() +
           " for ENABLED. To switch off variables and rule blocks is a fuzzylite extension, which "
           "is not supported: remove what is switched off, or write TRUE.");
    }
    expect_semicolon("ENABLED");
  }

  double parameter() {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (accept_word("inf")) {
      return kInfinity;
    }
    if ((at_symbol("-") || at_symbol("+")) && next().kind == TokenKind::word &&
        same_name(next().text, "inf")) {
      const bool negative = take().text == "-";
      take();
      return negative ? -kInfinity : kInfinity;
    }
    return number("a number");
  }

  void rule_block() {
    ast::RuleBlock rules;
    rules.name.line = last().line;
    if (now().kind == TokenKind::word && next().text != ":" && next().text != ":=" &&
        !contains(kLandmarks, now().text) && !at_word("rule")) {
      rules.name = name("the name of the rule block");
    }
    block("RULEBLOCK", "END_RULEBLOCK", [&] {
      if (at_word("and")) {
        option(rules.conjunction, "AND");
      } else if (at_word("or")) {
        option(rules.disjunction, "OR");
      } else if (at_word("act")) {
        option(rules.activation, "ACT");
      } else if (at_word("accu")) {
        option(rules.accumulation, "ACCU");
      } else if (accept_word("rule")) {
        rules.rules.push_back(rule());
      } else if (at_word("enabled")) {
        enabled();
      } else {
        lose_expecting("AND, OR, ACT, ACCU, RULE or END_RULEBLOCK");
      }
    });
    current().rule_blocks.push_back(std::move(rules));
  }

  // --- rules ---

  /// label : IF condition THEN conclusion, conclusion WITH weight;   after the word RULE.
  ast::Rule rule() {
    ast::Rule result;
    result.label.line = last().line;
    if (now().kind != TokenKind::number && now().kind != TokenKind::word) {
      lose_expecting("the number or name of the rule");
    }
    result.label = {std::string(now().text), now().line};
    take();
    expect_symbol(":", "after the number of the rule");
    if (!accept_word("if")) {
      lose_expecting("IF at the beginning of the rule");
    }
    result.condition = disjunction(0);
    if (!accept_word("then")) {
      lose_expecting("AND, OR or THEN after a condition");
    }
    do {
      result.conclusions.push_back(conclusion());
    } while (accept_symbol(",") || accept_word("and"));
    if (accept_word("with")) {
      result.weight = number("the weight of the rule after WITH, a number");
    }
    // fuzzylite ends rules with the line.
    const bool line_ends_it = now().first_on_line && (at_word("rule") || at_word("end_ruleblock"));
    if (!line_ends_it) {
      expect_semicolon("RULE");
    }
    return result;
  }

  ast::Condition disjunction(int depth) {
    return chain(ast::Condition::disjunction, "or", depth,
                 [this, depth] { return conjunction(depth); });
  }

  ast::Condition conjunction(int depth) {
    return chain(ast::Condition::conjunction, "and", depth,
                 [this, depth] { return factor(depth); });
  }

  template <class Operand>
  ast::Condition chain(ast::Condition::Kind kind, std::string_view word, int depth,
                       Operand operand) {
    if (depth > kDeepest) {
      lose("Parentheses and NOT are nested more than " + std::to_string(kDeepest) +
           " deep here. Simplify the condition.");
    }
    ast::Condition first = operand();
    if (!at_word(word)) {
      return first;
    }
    ast::Condition result;
    result.kind = kind;
    result.operands.push_back(std::move(first));
    while (accept_word(word)) {
      result.operands.push_back(operand());
    }
    return result;
  }

  ast::Condition factor(int depth) {
    if (depth > kDeepest) {
      lose("Parentheses and NOT are nested more than " + std::to_string(kDeepest) +
           " deep here. Simplify the condition.");
    }
    if (accept_word("not")) {
      ast::Condition result;
      result.kind = ast::Condition::negation;
      result.operands.push_back(factor(depth + 1));
      return result;
    }
    if (accept_symbol("(")) {
      ast::Condition result = disjunction(depth + 1);
      if (!accept_symbol(")")) {
        lose_expecting("AND, OR or ')' after a condition");
      }
      return result;
    }
    ast::Condition result;
    result.variable = name("a condition such as 'range IS near'");
    if (!accept_word("is")) {
      lose_expecting("IS after the variable '" + result.variable.text + "'");
    }
    if (accept_word("not")) {
      result.kind = ast::Condition::is_not;
    }
    result.term = hedged_term(result.hedges);
    return result;
  }

  /// power IS high;   some tools write (power IS high)
  ast::Conclusion conclusion() {
    ast::Conclusion result;
    const bool in_parentheses = accept_symbol("(");
    result.variable = name("a conclusion such as 'speed IS slow'");
    if (!accept_word("is")) {
      lose_expecting("IS after the variable '" + result.variable.text + "'");
    }
    if (at_word("not")) {
      lose("Found NOT in a conclusion, which says nothing definite. Name the term that is meant.");
    }
    result.term = hedged_term(result.hedges);
    if (in_parentheses) {
      expect_symbol(")", "after the conclusion");
    }
    return result;
  }

  /// very near: after IS.
  ast::Name hedged_term(std::string& hedges) {
    ast::Name term = name("the name of a term after IS");
    while (is_hedge(term) && contains(kHedges, term.text)) {
      hedges += (hedges.empty() ? "" : " ") + lower(term.text);
      term = name("the name of a term after " + term.text);
    }
    if (is_hedge(term)) {
      lose("Found the hedge '" + term.text + "' before '" + std::string(now().text) +
           "'. FCL knows no hedges; very, extremely, somewhat and seldom are read as fuzzylite has "
           "them. Define a term of its own for what is meant.");
    }
    return term;
  }

  /// `range IS very near`: a hedge of some tool, followed by a term.
  bool is_hedge(const ast::Name& word) const {
    return (contains(kHedges, word.text) || contains(kOtherHedges, word.text)) &&
           now().kind == TokenKind::word && !now().first_on_line &&
           !contains(kReserved, now().text);
  }

  std::vector<ast::FunctionBlock> blocks_;
  /// The number of variables in the last declaration of this VAR block, 0 if it had errors; none:
  /// there was no declaration yet.
  std::optional<std::size_t> declared_;
};

}  // namespace

std::vector<ast::FunctionBlock> parse(std::string_view text, Problems& problems) {
  return Parser(text, problems).run();
}

}  // namespace elsie::fuzzy
