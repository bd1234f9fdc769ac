// Parsing and computing are muparser's (https://beltoforion.de/en/muparser); its operators and
// functions are replaced by our own, so that a value that is none stays none, as in min(1, 1 / 0).
#include "elsie/formula/formula.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>

#include <muParser.h>

#include "elsie/base/utf8.h"
#include "elsie/base/words.h"

namespace elsie::formula {

namespace {

constexpr std::size_t kLongest = 1000;
constexpr std::array<std::string_view, 7> kFunctions{"min", "max", "abs", "sqrt",
                                                     "log", "exp", "not"};
constexpr const char* kNameChars =
    "0123456789_.abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
using Kind = Formula::Kind;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

[[noreturn]] void fail(std::size_t column, const std::string& message) {
  throw std::invalid_argument("column " + std::to_string(column) + ": " + message);
}

bool is_first(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_further(char c) { return is_first(c) || is_digit(c) || c == '.'; }

// A result without bounds is none.
double bounded(double value) { return std::isfinite(value) ? value : kNone; }

double add(double a, double b) { return bounded(a + b); }
double subtract(double a, double b) { return bounded(a - b); }
double multiply(double a, double b) { return bounded(a * b); }
double divide(double a, double b) { return bounded(a / b); }
// Also of 1 and of what is to the power of 0, for which std::pow() has a value in any case.
double power(double a, double b) {
  return std::isnan(a) || std::isnan(b) ? kNone : bounded(std::pow(a, b));
}
double absolute(double a) { return std::abs(a); }
double root(double a) { return bounded(std::sqrt(a)); }
double logarithm(double a) { return bounded(std::log(a)); }
double exponential(double a) { return bounded(std::exp(a)); }

double truth(bool value) { return value ? 1.0 : 0.0; }
double less(double a, double b) { return truth(a < b); }
double at_most(double a, double b) { return truth(a <= b); }
double greater(double a, double b) { return truth(a > b); }
double at_least(double a, double b) { return truth(a >= b); }
double equal(double a, double b) { return truth(a == b); }
double different(double a, double b) { return truth(a < b || a > b); }
bool is_true(double value) { return value != 0.0 && !std::isnan(value); }
double both(double a, double b) { return truth(is_true(a) && is_true(b)); }
double either(double a, double b) { return truth(is_true(a) || is_true(b)); }
double opposite(double a) { return truth(!is_true(a)); }

/// The functions of such a formula: "min, max".
std::string functions(Kind kind) {
  const std::size_t count = kFunctions.size() - (kind == Kind::condition ? 0 : 1);
  return base::listed(std::vector<std::string>(kFunctions.begin(), kFunctions.begin() + count));
}
bool is_function_of(Kind kind, const std::string& name) {
  return (kind == Kind::condition || name != "not") &&
         std::find(kFunctions.begin(), kFunctions.end(), name) != kFunctions.end();
}

template <class Better>
double best(const double* values, int count, Better better) {
  double found = values[0];
  for (int i = 0; i < count; ++i) {
    if (std::isnan(values[i])) {
      return kNone;
    }
    found = better(values[i], found) ? values[i] : found;
  }
  return found;
}
double least(const double* values, int count) {
  return best(values, count, [](double a, double b) { return a < b; });
}
double largest(const double* values, int count) {
  return best(values, count, [](double a, double b) { return a > b; });
}

// Reports what muparser would take or explain badly, and returns the names.
std::vector<Formula::Name> scanned(const std::string& text, Kind kind) {
  const bool is_condition = kind == Kind::condition;
  const std::string_view signs = is_condition ? "+-*/^(),<>=! \t\r\n" : "+-*/^(), \t\r\n";
  std::vector<int> comparisons{0};  // that are not joined yet, in each pair of brackets
  std::vector<Formula::Name> names;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = at;
    if (is_digit(text[at]) || text[at] == '.') {
      double number = 0.0;
      const auto [end, error] =
          std::from_chars(text.data() + at, text.data() + text.size(), number);
      if (error != std::errc()) {
        fail(begin + 1, "here is no number that can be computed with");
      }
      at = static_cast<std::size_t>(end - text.data());
    } else if (is_first(text[at])) {
      at = static_cast<std::size_t>(
          std::find_if_not(text.begin() + static_cast<std::ptrdiff_t>(at), text.end(), is_further) -
          text.begin());
      const std::string name = text.substr(begin, at - begin);
      const std::size_t next = text.find_first_not_of(" \t\r\n", at);
      const bool called = next != std::string::npos && text[next] == '(';
      if (is_condition && (name == "and" || name == "or")) {
        comparisons.back() = 0;
        continue;
      }
      const bool is_function = is_function_of(kind, name);
      if (called && !is_function) {
        fail(begin + 1, "there is no function '" + name + "'; there are: " + functions(kind));
      }
      if (!called && is_function) {
        fail(begin + 1, "'" + name + "' is a function; expected \"(\" after it");
      }
      if (!is_function && std::none_of(names.begin(), names.end(),
                                       [&](const auto& other) { return other.text == name; })) {
        names.push_back({name, begin + 1});
      }
    } else if (signs.find(text[at]) != std::string_view::npos) {
      if (text[at] == '(') comparisons.push_back(0);
      if (text[at] == ')' && comparisons.size() > 1) comparisons.pop_back();
      if (text[at] == ',') comparisons.back() = 0;
      if (std::string_view("<>=!").find(text[at]) != std::string_view::npos) {
        if (++comparisons.back() > 1) {
          fail(begin + 1, "comparisons do not stand in a row; write a < b and b < c");
        }
        if (at + 1 < text.size() && text[at + 1] == '=') ++at;
      }
      ++at;
    } else {
      at += std::max<std::size_t>(base::character_at(text, at).bytes, 1);
      fail(begin + 1, "unexpected " + base::in_quotes(text.substr(begin, at - begin)) +
                          (is_condition ? "; a condition has numbers, names, + - * / ^ ( ), < <= > "
                                          ">= == !=, and, or, not()"
                                        : "; a formula has numbers, names, + - * / ^ ( ) and "
                                          "\",\""));
    }
  }
  return names;
}

// The place of a mistake from 0; at the end of the text muparser counts one too many.
std::size_t place_of(const mu::Parser::exception_type& error, const std::string& text) {
  return std::min(static_cast<std::size_t>(std::max(error.GetPos(), 0)), text.size());
}

// What is wrong, as the end of a sentence.
std::string reason(const mu::Parser::exception_type& error, const std::string& text, Kind kind) {
  constexpr const char* kTooEarly =
      "the formula ends too early; expected a number, a name or \"(\"";
  switch (error.GetCode()) {
    case mu::ecUNEXPECTED_EOF:
      return kTooEarly;
    case mu::ecEMPTY_EXPRESSION:
      return "the formula is empty";
    case mu::ecMISSING_PARENS:
      return "a \")\" is missing";
    case mu::ecUNEXPECTED_PARENS:
      return "unexpected \"" + error.GetToken() +
             "\": brackets come in pairs, with something in "
             "between";
    case mu::ecTOO_FEW_PARAMS:
    case mu::ecTOO_MANY_PARAMS:
      return "a function has another number of values; min and max take any number, the others one";
    case mu::ecUNEXPECTED_ARG:
    case mu::ecUNEXPECTED_ARG_SEP:
      return "unexpected \",\"; it stands between the values of min and max only";
    default:
      break;
  }
  // muparser's token goes on to the end of the text after an operator.
  const std::size_t at = place_of(error, text);
  if (at >= text.size()) {
    return kTooEarly;
  }
  const bool is_word = is_further(text[at]);
  return "unexpected \"" + (is_word ? error.GetToken() : text.substr(at, 1)) +
         "\"; expected an operator, " +
         (kind == Kind::condition ? "such as + or <" : "+ - * / or ^") + ", between two values";
}

}  // namespace

struct Formula::Parser {
  std::vector<Name> names;
  std::vector<double> values;  // parallel to the names; muparser keeps their addresses
  mu::Parser parser;
};

Formula::Formula(const std::string& text, Kind kind) : parser_(std::make_unique<Parser>()) {
  if (text.size() > kLongest) {
    fail(kLongest + 1, "the formula is longer than " + std::to_string(kLongest) +
                           " characters; expected a shorter one");
  }
  parser_->names = scanned(text, kind);
  parser_->values.assign(parser_->names.size(), 1.0);
  mu::Parser& parser = parser_->parser;
  try {
    parser.ClearConst();
    parser.ClearFun();
    parser.EnableBuiltInOprt(false);
    parser.DefineNameChars(kNameChars);
    parser.DefineOprt("+", add, mu::prADD_SUB);
    parser.DefineOprt("-", subtract, mu::prADD_SUB);
    parser.DefineOprt("*", multiply, mu::prMUL_DIV);
    parser.DefineOprt("/", divide, mu::prMUL_DIV);
    parser.DefineOprt("^", power, mu::prPOW, mu::oaRIGHT);
    parser.DefineFun("min", least);
    parser.DefineFun("max", largest);
    parser.DefineFun("abs", absolute);
    parser.DefineFun("sqrt", root);
    parser.DefineFun("log", logarithm);
    parser.DefineFun("exp", exponential);
    if (kind == Kind::condition) {
      parser.DefineOprt("<", less, mu::prCMP);
      parser.DefineOprt("<=", at_most, mu::prCMP);
      parser.DefineOprt(">", greater, mu::prCMP);
      parser.DefineOprt(">=", at_least, mu::prCMP);
      parser.DefineOprt("==", equal, mu::prCMP);
      parser.DefineOprt("!=", different, mu::prCMP);
      parser.DefineOprt("and", both, mu::prLAND);
      parser.DefineOprt("or", either, mu::prLOR);
      parser.DefineFun("not", opposite);
    }
    for (std::size_t i = 0; i < parser_->names.size(); ++i) {
      parser.DefineVar(parser_->names[i].text, &parser_->values[i]);
    }
    parser.SetExpr(text);
    parser.Eval();
    if (parser.GetNumResults() != 1) {
      fail(text.find(',') + 1,
           "unexpected \",\"; it stands between the values of min and max only");
    }
  } catch (const mu::Parser::exception_type& error) {
    fail(place_of(error, text) + 1, reason(error, text, kind));
  }
}

Formula::~Formula() = default;
Formula::Formula(Formula&&) noexcept = default;
Formula& Formula::operator=(Formula&&) noexcept = default;

const std::vector<Formula::Name>& Formula::names() const { return parser_->names; }

std::optional<double> Formula::value(std::span<const double> values) const {
  std::copy(values.begin(), values.end(), parser_->values.begin());
  const double value = parser_->parser.Eval();
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace elsie::formula
