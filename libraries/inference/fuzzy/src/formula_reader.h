// Reads formulas of terms from tokens.
#pragma once

#include <string>

#include "statement_reader.h"

namespace elsie::fuzzy {

/// Reads formulas after FUNCTION as in jFuzzyLogic and fuzzylite: + - * / ^, parentheses, numbers,
/// inputs and functions. A formula that means different things to the two is refused.
class FormulaReader : protected StatementReader {
 protected:
  using StatementReader::StatementReader;

  /// After the word FUNCTION.
  ast::Formula formula();

 private:
  void sum(int depth);
  void product(int depth);
  void power(int depth);
  void operand(int depth);
  void function_or_input(int depth);
  void push(FormulaStep step);

  ast::Formula made_;
  std::size_t height_ = 0;  // height of the stack after the steps so far
};

}  // namespace elsie::fuzzy
