#include "formula_reader.h"

#include <algorithm>
#include <array>
#include <utility>

#include "words.h"

namespace elsie::fuzzy {

namespace {

constexpr std::array<Word<FormulaOp>, 8> kFunctions = {{{"SIN", FormulaOp::sine},
                                                        {"COS", FormulaOp::cosine},
                                                        {"TAN", FormulaOp::tangent},
                                                        {"EXP", FormulaOp::exponential},
                                                        {"LN", FormulaOp::logarithm},
                                                        {"ABS", FormulaOp::absolute},
                                                        {"FABS", FormulaOp::absolute},
                                                        {"SQRT", FormulaOp::root}}};

}  // namespace

ast::Formula FormulaReader::formula() {
  made_ = {};
  height_ = 0;
  const char* const begin = now().text.data();
  sum(0);
  made_.text.assign(begin, last().text.data() + last().text.size());
  std::replace_if(
      made_.text.begin(), made_.text.end(),
      [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
  return std::move(made_);
}

void FormulaReader::sum(int depth) {
  if (depth > static_cast<int>(kDeepestFormula)) {
    lose("Parentheses are nested more than " + std::to_string(kDeepestFormula) +
         " deep here. Simplify the formula.");
  }
  product(depth);
  while (at_symbol("+") || at_symbol("-")) {
    const FormulaOp op = take().text == "+" ? FormulaOp::add : FormulaOp::subtract;
    product(depth);
    push({op});
  }
}

void FormulaReader::product(int depth) {
  power(depth);
  while (at_symbol("*") || at_symbol("/")) {
    const FormulaOp op = take().text == "*" ? FormulaOp::multiply : FormulaOp::divide;
    power(depth);
    push({op});
  }
  if (at_symbol("%")) {
    lose(
        "Found '%', which comes before '*' in jFuzzyLogic and not in fuzzylite. Write the formula "
        "without it.");
  }
}

void FormulaReader::power(int depth) {
  const auto sign = [&] {
    const bool negative = at_symbol("-");
    return std::pair(negative, negative ? accept_symbol("-") : accept_symbol("+"));
  };
  const auto [negative, has_sign] = sign();
  operand(depth);
  if (accept_symbol("^")) {
    const bool negative_exponent = sign().first;
    operand(depth);
    if (negative_exponent) {
      push({FormulaOp::negate});
    }
    push({FormulaOp::power});
    if (has_sign || at_symbol("^")) {
      lose(
          "Found '^' after a sign or another '^', where tools differ in what comes first. Put "
          "parentheses around what belongs together.");
    }
  }
  if (negative) {
    push({FormulaOp::negate});
  }
}

void FormulaReader::operand(int depth) {
  if (accept_symbol("(")) {
    sum(depth + 1);
    expect_symbol(")", "in the formula");
  } else if (now().kind == TokenKind::number) {
    push({FormulaOp::number, take().value});
  } else if (now().kind == TokenKind::word && !at_landmark()) {
    function_or_input(depth);
  } else {
    lose_expecting("a number, an input or a function such as SIN(x) in the formula");
  }
}

void FormulaReader::function_or_input(int depth) {
  const ast::Name word = {std::string(now().text), now().line};
  if (next().text != "(") {
    take();
    push({FormulaOp::input, 0.0, made_.variables.size()});
    made_.variables.push_back(word);
    return;
  }
  const auto* const function =
      std::find_if(kFunctions.begin(), kFunctions.end(),
                   [&](const Word<FormulaOp>& known) { return same_name(known.word, word.text); });
  if (same_name(word.text, "log")) {
    lose(
        "Found LOG, which has the base 10 in jFuzzyLogic and the base e in fuzzylite. Write "
        "LN(x) for the base e, LN(x) / LN(10) for the base 10.");
  }
  if (function == kFunctions.end()) {
    std::vector<std::string> known;
    known.reserve(kFunctions.size());
    for (const Word<FormulaOp>& candidate : kFunctions) {
      known.emplace_back(candidate.word);
    }
    lose("Found the function '" + word.text + "', expected " + base::enumerated(known, "or") + ".");
  }
  take();
  expect_symbol("(", "after " + word.text);
  sum(depth + 1);
  expect_symbol(")", "after the argument of " + word.text);
  push({function->value});
}

void FormulaReader::push(FormulaStep step) {
  const bool is_value = step.op == FormulaOp::number || step.op == FormulaOp::input;
  const bool is_binary = step.op >= FormulaOp::add && step.op <= FormulaOp::power;
  height_ += is_value ? 1 : 0;
  height_ -= is_binary ? 1 : 0;
  if (height_ > kDeepestFormula) {
    lose("The formula keeps more than " + std::to_string(kDeepestFormula) +
         " values until it can use them. Simplify it.");
  }
  made_.steps.push_back(step);
}

}  // namespace elsie::fuzzy
