// Tokens to the pieces that statements are made of, and how reading goes on after a mistake.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "elsie/fuzzy/error.h"

#include "ast.h"
#include "lexer.h"
#include "text.h"

namespace elsie::fuzzy {

/// Thrown when a statement cannot be read, after the problem was noted.
struct StatementLost {};
/// Thrown to give up on the file.
struct FileLost {};

/// Words that begin or end something; where a statement went wrong, reading goes on at one.
inline constexpr std::array kLandmarks = {
    "function_block", "end_function_block", "var_input", "var_output", "end_var",
    "fuzzify",        "end_fuzzify",        "defuzzify", "ruleblock",  "end_defuzzify",
    "end_ruleblock",
};
/// Words that begin a statement.
inline constexpr std::array kStatements = {"term", "method", "accu", "default", "range",
                                           "rule", "and",    "or",   "act",     "enabled"};
/// Words that cannot be names.
inline constexpr std::array kReserved = {"if", "then", "is", "not", "and", "or", "with"};

template <class List>
bool contains(const List& list, std::string_view text) {
  const std::string word = lower(text);
  return std::any_of(list.begin(), list.end(), [&](const char* item) { return word == item; });
}

/// The file token by token. What is expected and not there is noted and thrown as StatementLost.
class StatementReader {
 public:
  StatementReader(std::string_view text, Problems& problems)
      : tokens_(tokenize(text, problems)), problems_(problems) {}

 protected:
  // --- tokens ---

  const Token& now() const { return tokens_[at_]; }
  const Token& next() const { return tokens_[std::min(at_ + 1, tokens_.size() - 1)]; }
  /// The one that was taken last.
  const Token& last() const { return tokens_[at_ - 1]; }
  const Token& take();
  bool at_end() const { return now().kind == TokenKind::end; }
  bool at_word(std::string_view word) const {
    return now().kind == TokenKind::word && same_name(now().text, word);
  }
  bool at_landmark() const {
    return now().kind == TokenKind::word && contains(kLandmarks, now().text);
  }
  bool at_symbol(std::string_view symbol) const {
    return now().kind == TokenKind::symbol && now().text == symbol;
  }
  bool accept_word(std::string_view word) { return at_word(word) && (take(), true); }
  bool accept_symbol(std::string_view symbol) { return at_symbol(symbol) && (take(), true); }
  /// What stands there, in words.
  std::string found() const;

  // --- mistakes ---

  Problems& problems() { return problems_; }

  /// Throws FileLost after too many.
  void note(int line, const std::string& message);
  [[noreturn]] void lose(const std::string& message);
  [[noreturn]] void lose_expecting(const std::string& expected);
  void expect_symbol(std::string_view symbol, const std::string& where);
  /// A line that ends, and a next one that begins another statement, will do: that is noted.
  void expect_semicolon(const std::string& statement);
  /// Goes on after the statement that was lost.
  void recover();

  /// Reads statements until the end word of a block; `statement` must consume something or throw.
  template <class Statement>
  void block(const std::string& opening, const std::string& closing, Statement statement) {
    const int line = last().line;
    while (true) {
      if (accept_word(closing)) {
        accept_symbol(";");
        return;
      }
      if (at_end() || at_landmark()) {
        note(now().line, "Found " + found() + ", but the " + opening + " that begins in line " +
                             std::to_string(line) + " is not closed. Write " + closing +
                             " before it.");
        return;
      }
      const std::size_t start = at_;
      try {
        statement();
      } catch (const StatementLost&) {
        if (at_ == start) {
          take();
        }
        recover();
      }
    }
  }

  // --- pieces ---

  /// Some tools write names such as Check-Plus-Tip.
  ast::Name name(const std::string& what);
  /// The name of what is declared here.
  ast::Name new_name(const std::string& what);
  double number(const std::string& what);
  /// RANGE := (low .. high); after the word RANGE.
  ast::RangeStatement range();

  /// Takes a statement's value unless the block has one already.
  template <class Value>
  void set_once(std::optional<Value>& place, Value value, int line, const std::string& keyword) {
    if (place) {
      note(line, keyword + " is set a second time in this block. Remove one of the two.");
    } else {
      place = std::move(value);
    }
  }

  /// KEYWORD : WORD ;
  void option(std::optional<ast::Name>& place, const std::string& keyword);

 private:
  std::vector<Token> tokens_;
  Problems& problems_;
  std::size_t at_ = 0;
};

}  // namespace elsie::fuzzy
