// Builds a model from statements; shared by the parts of build().
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "elsie/fuzzy/fcl.h"

#include "ast.h"
#include "compile.h"
#include "model_data.h"
#include "problems.h"
#include "text.h"
#include "words.h"

namespace elsie::fuzzy {

inline std::string range_text(const Range& range) {
  return std::string("(").append(number_text(range.low)) + " .. " + number_text(range.high) + ")";
}

/// Whether a term of an output with an area has none itself.
inline bool is_point(const Term& term) {
  const std::vector<FuzzySet::Point>& points = term.set.points;
  return !term.singleton && !points.empty() && points.front().x == points.back().x &&
         points.front().degree == 0.0 && points.back().degree == 0.0;
}

class ModelBuilder {
 public:
  ModelBuilder(const ast::FunctionBlock& block, Problems& problems, Gaps gaps)
      : block_(block), problems_(problems), gaps_(gaps), model_(std::make_shared<ModelData>()) {}

  std::shared_ptr<const ModelData> run();

 private:
  struct Declared {
    bool output;
    std::size_t index;
    const ast::VariableDeclaration* declaration;
    int block_line = 0;  // line of its FUZZIFY or DEFUZZIFY block
    int accumulation_line = 0;
    bool used = false;        // in a condition or conclusion
    bool in_formula = false;  // in that of an output's term
    bool usable = false;      // it has a block with terms
  };
  /// AND and OR of a rule block.
  struct Operators {
    Operator conjunction;
    Operator disjunction;
  };

  void declare(const std::vector<ast::VariableDeclaration>& variables, bool output);
  Declared* find(const ast::Name& name, const char* wanted);
  Variable& variable(const Declared& declared);
  void variable_blocks();
  void variable_block(const ast::VariableBlock& block, bool output);
  void output_block(const ast::VariableBlock& block, OutputVariable& output, Declared& declared);
  void range(const ast::VariableBlock& block, const Declared& declared, Variable& variable);
  void linear_term(const ast::Term& term, Variable& variable);
  void formula_term(const ast::Term& term, std::size_t output);
  std::optional<FuzzySet> term_set(const ast::Term& term, const Variable& variable);
  ast::Term with_singleton(const ast::Term& term);
  bool check_points(const ast::Term& term);
  std::vector<FuzzySet::Point> without_repetitions(const ast::Term& term);
  void take_points_for_terms_without_area(const ast::VariableBlock& block, OutputVariable& output);
  void check_output_terms(const ast::VariableBlock& block, OutputVariable& output,
                          bool method_given);

  /// The meaning of a word in the file; none: it is missing or unknown.
  template <class Value, std::size_t count>
  std::optional<Value> word(const std::optional<ast::Name>& name,
                            const std::array<Word<Value>, count>& words, const char* keyword) {
    if (!name || same_name(name->text, "none")) {
      return std::nullopt;  // some tools write NONE for a missing value
    }
    std::vector<std::string> known;
    for (const Word<Value>& candidate : words) {
      if (same_name(candidate.word, name->text)) {
        return candidate.value;
      }
      known.emplace_back(candidate.word);
    }
    const char* const tool = tool_of(name->text);
    problems_.add(name->line, "Found " + name_in_quotes(name->text) + " for " + keyword +
                                  ", expected " + base::enumerated(known, "or") + "." +
                                  (tool ? " (This is a " + std::string(tool) +
                                              " extension, which is not supported.)"
                                        : ""));
    return std::nullopt;
  }

  void accumulate(Declared& declared, Accumulation accumulation, int line);
  void check_accumulation(std::size_t output);

  void rule_block(const ast::RuleBlock& block);
  void rule(const ast::RuleBlock& block, const ast::Rule& rule, const Operators& operators,
            bool scales);
  bool condition(const ast::Condition& condition, bool negated, const Operators& operators,
                 std::vector<Instruction>& into);
  bool comparison(const ast::Condition& condition, bool negated, std::vector<Instruction>& into);
  /// The degree of a term, or of its complement, with hedges as in "very" or "very very".
  std::size_t leaf(std::size_t input, std::size_t term, const std::string& hedges, bool complement);
  std::string condition_text(const ast::Condition& condition) const;

  void check_use(const Declared& declared);
  void check_coverage();

  const ast::FunctionBlock& block_;
  Problems& problems_;
  Gaps gaps_;
  std::shared_ptr<ModelData> model_;
  std::map<std::string, Declared> variables_;  // by name in lower case
  std::map<std::tuple<std::size_t, std::size_t, std::string, bool>, std::size_t> leaves_;

  std::vector<Conclusion> conclusions_;
};

}  // namespace elsie::fuzzy
