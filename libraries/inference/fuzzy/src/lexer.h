// Divides FCL text into tokens.
#pragma once

#include <string_view>
#include <vector>

#include "problems.h"

namespace elsie::fuzzy {

enum class TokenKind { word, number, symbol, end };

struct Token {
  TokenKind kind = TokenKind::end;
  std::string_view text;       // part of the file's text
  double value = 0.0;          // of a number, without its sign
  int line = 0;                // from 1
  bool first_on_line = false;  // ignoring comments
};

/// The tokens of the text, and at the end one of kind `end`. Symbols: := : ; , ( ) .. | + - * / ^
/// %. Other characters are reported and left out.
std::vector<Token> tokenize(std::string_view text, Problems& problems);

}  // namespace elsie::fuzzy
