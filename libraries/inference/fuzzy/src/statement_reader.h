// Reads the parts of statements from tokens, and recovers after mistakes.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ast.h"
#include "lexer.h"
#include "text.h"

namespace elsie::fuzzy {

/// Thrown when a statement cannot be read, after the problem was noted.
struct StatementLost {};
/// Thrown to stop reading the file.
struct FileLost {};

/// Words that begin or end something; after a mistake, reading continues at one.
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

/// Reads the file token by token. A missing token is reported, and thrown as StatementLost.
class StatementReader {
 public:
  StatementReader(std::string_view text, Problems& problems)
      : tokens_(tokenize(text, problems)), problems_(problems) {}

 protected:
  // --- tokens ---

  const Token& now() const { return tokens_[at_]; }
  const Token& next() const { return tokens_[std::min(at_ + 1, tokens_.size() - 1)]; }
  /// The token before the current one.
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
  /// The current token, in words.
  std::string found() const;

  // --- mistakes ---

  Problems& problems() { return problems_; }

  /// Reports a mistake. Throws FileLost after too many.
  void note(int line, const std::string& message);
  [[noreturn]] void lose(const std::string& message);
  [[noreturn]] void lose_expecting(const std::string& expected);
  void expect_symbol(std::string_view symbol, const std::string& where);
  /// A line's end before a new statement is accepted, with a note.
  void expect_semicolon(const std::string& statement);
  /// Skips the rest of a statement with a mistake.
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

  /// A name; some tools write names such as Check-Plus-Tip.
  ast::Name name(const std::string& what);
  /// The name in a declaration.
  ast::Name new_name(const std::string& what);
  double number(const std::string& what);
  /// RANGE := (low .. high); after the word RANGE.
  ast::RangeStatement range();

  /// Takes a statement's value unless the block already has one.
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
