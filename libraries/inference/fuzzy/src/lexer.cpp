#include "lexer.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <string>

namespace elsie::fuzzy {

namespace {

/// The greatest number: beyond it, sums and products in the inference could overflow.
constexpr double kLargestNumber = 1e100;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Names may contain letters of other scripts (UTF-8).
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

class Lexer {
 public:
  Lexer(std::string_view text, Problems& problems) : text_(text), problems_(problems) {}

  std::vector<Token> run() {
    skip_byte_order_mark();
    while (skip_space_and_comments(), at_ < text_.size()) {
      const char c = text_[at_];
      if (is_letter(c)) {
        word();
      } else if (is_digit(c) || (c == '.' && is_digit(peek(1)))) {
        number();
      } else {
        symbol();
      }
    }
    push(TokenKind::end, 0);
    return std::move(tokens_);
  }

 private:
  char peek(std::size_t ahead) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }
  bool looking_at(std::string_view what) const { return text_.substr(at_).starts_with(what); }

  void skip_byte_order_mark() {
    if (looking_at("\xEF\xBB\xBF")) {
      at_ += 3;
    }
  }

  void advance_to(std::size_t end) {
    for (; at_ < end; ++at_) {
      if (text_[at_] == '\n') {
        ++line_;
        first_ = true;
      }
    }
  }

  void skip_space_and_comments() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v') {
        advance_to(at_ + 1);
      } else if (looking_at("//")) {
        const std::size_t end = text_.find('\n', at_);
        advance_to(end == std::string_view::npos ? text_.size() : end);
      } else if (looking_at("/*")) {
        const std::size_t end = text_.find("*/", at_ + 2);
        end_comment(end == std::string_view::npos ? std::nullopt : std::optional(end + 2), "*/");
      } else if (looking_at("(*")) {
        end_comment(end_of_standard_comment(), "*)");
      } else {
        return;
      }
    }
  }

  void end_comment(std::optional<std::size_t> end, const char* closing) {
    if (!end) {
      problems_.add(line_, "The comment that begins here is never closed. Close it with '" +
                               std::string(closing) + "'.");
    }
    advance_to(end.value_or(text_.size()));
  }

  /// Finds the end of a nested comment; if there is none, the file's comments do not nest.
  std::optional<std::size_t> end_of_standard_comment() {
    if (!nesting_fails_) {
      int depth = 0;
      for (std::size_t i = at_; i + 1 < text_.size(); ++i) {
        if (text_[i] == '(' && text_[i + 1] == '*') {
          ++depth;
          ++i;
        } else if (text_[i] == '*' && text_[i + 1] == ')') {
          ++i;
          if (--depth == 0) {
            return i + 1;
          }
        }
      }
      nesting_fails_ = true;  // do not search to the end again
    }
    const std::size_t end = text_.find("*)", at_ + 2);
    return end == std::string_view::npos ? std::nullopt : std::optional(end + 2);
  }

  void push(TokenKind kind, std::size_t length, double value = 0.0) {
    tokens_.push_back({kind, text_.substr(at_, length), value, line_, first_});
    at_ += length;
    first_ = false;
  }

  void word() {
    std::size_t length = 1;
    while (is_letter(peek(length)) || is_digit(peek(length))) {
      ++length;
    }
    push(TokenKind::word, length);
  }

  void number() {
    std::size_t length = 0;
    const auto digits = [&] {
      while (is_digit(peek(length))) {
        ++length;
      }
    };
    digits();
    if (peek(length) == '.' && peek(length + 1) != '.') {
      ++length;
      digits();
    }
    if (peek(length) == 'e' || peek(length) == 'E') {
      const std::size_t sign = peek(length + 1) == '+' || peek(length + 1) == '-' ? 2 : 1;
      if (is_digit(peek(length + sign))) {
        length += sign;
        digits();
      }
    }
    const std::size_t number_length = length;
    while (is_letter(peek(length)) || is_digit(peek(length)) ||
           (peek(length) == '.' && peek(length + 1) != '.')) {
      ++length;  // 3abc, 1_000, 1.2.3
    }
    const std::string_view text = text_.substr(at_, length);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (length != number_length || end != text.data() + text.size() ||
        (error != std::errc() && error != std::errc::result_out_of_range)) {
      problems_.add(line_, "'" + std::string(text) +
                               "' is not a number. Numbers are written like 2, 0.25 or 1.5e-3.");
      value = 0.0;
    } else if (error != std::errc() || std::abs(value) > kLargestNumber) {
      problems_.add(line_, "The number " + std::string(text) +
                               " is out of reach: numbers go from -1e100 to 1e100, and those "
                               "nearer to zero than 1e-307 are zero. Write another one.");
      value = 0.0;
    }
    push(TokenKind::number, length, value);
  }

  void symbol() {
    for (const std::string_view symbol :
         {":=", "..", ":", ";", ",", "(", ")", "|", "+", "-", "*", "/", "^", "%"}) {
      if (looking_at(symbol)) {
        push(TokenKind::symbol, symbol.size());
        return;
      }
    }
    const auto byte = static_cast<unsigned char>(text_[at_]);
    constexpr char kHex[] = "0123456789abcdef";
    const std::string shown = byte > 0x20 && byte < 0x7f
                                  ? "'" + std::string(1, text_[at_]) + "'"
                                  : std::string("the byte 0x") + kHex[byte / 16] + kHex[byte % 16];
    problems_.add(line_, "Found " + shown + ", which has no meaning in FCL. Remove it.");
    // One message for a sequence of such bytes: a file that is not text has many.
    const std::string_view meaning = ":;,()|+-*/^%. \t\r\n";
    while (at_ < text_.size() && !is_letter(text_[at_]) && !is_digit(text_[at_]) &&
           (meaning.find(text_[at_]) == std::string_view::npos ||
            static_cast<unsigned char>(text_[at_]) == byte)) {
      ++at_;
    }
  }

  std::string_view text_;
  Problems& problems_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  int line_ = 1;
  bool first_ = true;
  bool nesting_fails_ = false;
};

}  // namespace

std::vector<Token> tokenize(std::string_view text, Problems& problems) {
  return Lexer(text, problems).run();
}

}  // namespace elsie::fuzzy
