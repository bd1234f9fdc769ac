// FCL text to tokens.
#pragma once

#include <string_view>
#include <vector>

#include "elsie/fuzzy/error.h"

namespace elsie::fuzzy {

enum class TokenKind { word, number, symbol, end };

struct Token {
  TokenKind kind = TokenKind::end;
  std::string_view text;       // in the file's text
  double value = 0.0;          // of a number; without sign
  int line = 0;                // from 1
  bool first_on_line = false;  // comments do not count
};

/// The tokens of the text, ended by one of kind `end`. Symbols: := : ; , ( ) .. | + - * / ^ %
/// What is no token is reported and left out.
std::vector<Token> tokenize(std::string_view text, Problems& problems);

}  // namespace elsie::fuzzy
