// Formulas of terms, token by token.
#pragma once

#include <string>

#include "statement_reader.h"

namespace elsie::fuzzy {

/// What jFuzzyLogic and fuzzylite write after FUNCTION, as far as both mean the same by it:
/// + - * / ^, parentheses, numbers, inputs and functions. Where they differ the formula is refused.
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
  std::size_t height_ = 0;  // of the stack, when the steps so far are done
};

}  // namespace elsie::fuzzy
