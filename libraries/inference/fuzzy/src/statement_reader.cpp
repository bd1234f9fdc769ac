#include "statement_reader.h"

namespace elsie::fuzzy {

namespace {

/// After so many mistakes, the rest of the file is not read.
constexpr std::size_t kMostMistakes = 100;

}  // namespace

const Token& StatementReader::take() {
  const Token& token = tokens_[at_];
  if (token.kind != TokenKind::end) {
    ++at_;
  }
  return token;
}

std::string StatementReader::found() const {
  return at_end() ? std::string("the end of the file") : "'" + std::string(now().text) + "'";
}

void StatementReader::note(int line, const std::string& message) {
  problems_.add(line, message);
  if (problems_.size() >= kMostMistakes) {
    throw FileLost();
  }
}

void StatementReader::lose(const std::string& message) {
  note(now().line, message);
  throw StatementLost();
}

void StatementReader::lose_expecting(const std::string& expected) {
  lose("Found " + found() + ", expected " + expected + ".");
}

void StatementReader::expect_symbol(std::string_view symbol, const std::string& where) {
  if (!accept_symbol(symbol)) {
    lose_expecting("'" + std::string(symbol) + "' " + where);
  }
}

void StatementReader::expect_semicolon(const std::string& statement) {
  if (accept_symbol(";")) {
    return;
  }
  if (now().first_on_line && now().kind == TokenKind::word &&
      (at_landmark() || contains(kStatements, now().text))) {
    problems_.add_note(last().line, "The " + statement +
                                        " statement has no ';' at its end, after '" +
                                        std::string(last().text) + "'. Write one.");
    return;
  }
  note(last().line, "Expected ';' at the end of the " + statement + " statement, after '" +
                        std::string(last().text) + "', found " + found() + ".");
  throw StatementLost();
}

void StatementReader::recover() {
  while (!at_end()) {
    if (accept_symbol(";")) {
      return;
    }
    if (now().kind == TokenKind::word &&
        (at_landmark() || (now().first_on_line && contains(kStatements, now().text)))) {
      return;
    }
    take();
  }
}

ast::Name StatementReader::name(const std::string& what) {
  if (now().kind != TokenKind::word) {
    lose_expecting(what);
  }
  if (contains(kReserved, now().text) || contains(kLandmarks, now().text)) {
    lose("Found the keyword " + upper(now().text) + ", expected " + what + ".");
  }
  const Token& first = take();
  const auto follows = [&](const Token& token) {
    return token.text.data() == last().text.data() + last().text.size();
  };
  while (at_symbol("-") && follows(now()) && next().kind == TokenKind::word &&
         next().text.data() == now().text.data() + 1) {
    take();
    take();
  }
  return {std::string(first.text.data(), last().text.data() + last().text.size()), first.line};
}

ast::Name StatementReader::new_name(const std::string& what) {
  ast::Name result = name(what);
  if (result.text.find('-') != std::string::npos) {
    problems_.add_note(
        result.line,
        "The name '" + result.text + "' has a '-', which is no part of names in FCL. Write '_'.");
  }
  return result;
}

double StatementReader::number(const std::string& what) {
  double sign = 1.0;
  if (at_symbol("-") || at_symbol("+")) {
    sign = take().text == "-" ? -1.0 : 1.0;
  }
  if (now().kind != TokenKind::number) {
    lose_expecting(what);
  }
  return sign * take().value;
}

ast::RangeStatement StatementReader::range() {
  ast::RangeStatement statement;
  statement.line = last().line;
  accept_symbol(":=");
  expect_symbol("(", "before the lower end of RANGE, as in RANGE := (0 .. 1)");
  statement.range.low = number("the lower end of RANGE, a number");
  expect_symbol("..", "between the two ends of RANGE");
  statement.range.high = number("the upper end of RANGE, a number");
  expect_symbol(")", "after the upper end of RANGE");
  return statement;
}

void StatementReader::option(std::optional<ast::Name>& place, const std::string& keyword) {
  const int line = take().line;
  if (!accept_symbol(":=")) {
    expect_symbol(":", "after " + keyword);
  }
  ast::Name value = name("the name of an algorithm after " + keyword);
  expect_semicolon(keyword);
  set_once(place, std::move(value), line, keyword);
}

}  // namespace elsie::fuzzy
