// Formulas and conditions: what they mean, and which texts are none.
#include <catch2/catch.hpp>

#include "elsie/formula/formula.h"

using elsie::formula::Formula;

namespace {

/// The value with all names 2; none: it has no value.
std::optional<double> value(const std::string& text) {
  const Formula formula(text);
  return formula.value(std::vector<double>(formula.names().size(), 2.0));
}

std::string mistake(const std::string& text) {
  try {
    const Formula formula(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("Operators bind as in mathematics") {
  CHECK(value("1 + 2 * 3 - 8 / 4") == 5.0);
  CHECK(value("(1 + 2) * 3") == 9.0);
  CHECK(value("-2^2") == -4.0);
  CHECK(value("2^3^2") == 512.0);
  CHECK(value("2^-1") == 0.5);
  CHECK(value("8 / 4 / 2") == 1.0);
  CHECK(value("7 - 2 - 1") == 4.0);
  CHECK(value("1.5e3 + .5") == 1500.5);
}

TEST_CASE("Functions") {
  CHECK(value("min(3, 1, 2)") == 1.0);
  CHECK(value("max(3, 1, 2) + max(5)") == 8.0);
  CHECK(value("abs(-3)") == 3.0);
  CHECK(value("sqrt(9)") == 3.0);
  CHECK(value("log(exp(2))") == 2.0);
}

TEST_CASE("Names stand for the values that are given, in the order of the text") {
  const Formula formula("collisions / robots / (home.time_s / 60) + collisions");
  REQUIRE(formula.names().size() == 3);
  CHECK(formula.names()[0].text == "collisions");
  CHECK(formula.names()[1].text == "robots");
  CHECK(formula.names()[1].column == 14);
  CHECK(formula.names()[2].text == "home.time_s");
  CHECK(formula.value(std::vector<double>{6.0, 2.0, 120.0}) == 7.5);
  CHECK(formula.value(std::vector<double>{0.0, 1.0, 60.0}) == 0.0);
}

TEST_CASE("What divides by 0, or leaves the numbers, has no value, wherever it is inside") {
  for (const char* text :
       {"1 / 0", "0 / 0", "sqrt(-1)", "log(0)", "log(-1)", "10^400", "exp(1000)", "min(1, 1 / 0)",
        "max(1, 0 / 0)", "1 / (1 / 0)", "(1 / 0)^0", "1^(0 / 0)", "(a - 2) / (b - 2)"}) {
    CAPTURE(text);
    CHECK_FALSE(value(text));
  }
  CHECK(value("0^0") == 1.0);
}

TEST_CASE("A mistake is named with its column and with what was expected") {
  CHECK(mistake("a + ") ==
        "column 5: the formula ends too early; expected a number, a name or \"(\"");
  CHECK(mistake("-") == "column 2: the formula ends too early; expected a number, a name or \"(\"");
  CHECK(mistake("(a") == "column 3: a \")\" is missing");
  CHECK_THAT(mistake("a)"), Catch::StartsWith("column 2: unexpected \")\""));
  CHECK_THAT(mistake("()"), Catch::StartsWith("column 2: unexpected \")\""));
  CHECK(mistake("a b") ==
        "column 3: unexpected \"b\"; expected an operator, + - * / or ^, between two values");
  CHECK_THAT(mistake("a ** b"), Catch::StartsWith("column 4: unexpected \"*\";"));
  CHECK_THAT(mistake("1.2.3"), Catch::StartsWith("column 4: unexpected \".3\";"));
  CHECK(mistake("sin(a)") ==
        "column 1: there is no function 'sin'; there are: min, max, abs, sqrt, log, exp");
  CHECK(mistake("2 * min") == "column 5: 'min' is a function; expected \"(\" after it");
  CHECK_THAT(mistake("abs(1, 2)"), Catch::Contains("a function has another number of values"));
  CHECK_THAT(mistake("min()"), Catch::Contains("a function has another number of values"));
  CHECK_THAT(mistake("a, b"), Catch::StartsWith("column 2: unexpected \",\""));
  CHECK(mistake("") == "column 1: the formula is empty");
  CHECK(mistake(" \t") == "column 1: the formula is empty");
  CHECK_THAT(mistake("a = 2"), Catch::StartsWith("column 3: unexpected '='"));
  CHECK_THAT(mistake("a ? b : c"), Catch::StartsWith("column 3: unexpected '?'"));
  CHECK_THAT(mistake("2 * \xc3\xa4"), Catch::StartsWith("column 5: unexpected '\xc3\xa4'"));
  CHECK_THAT(mistake("1e999"), Catch::StartsWith("column 1: "));
  CHECK_THAT(mistake(std::string(1001, 'a')), Catch::Contains("longer than 1000 characters"));
}

namespace {

bool holds(const std::string& text, double a = 2.0, double b = 3.0) {
  const Formula condition(text, Formula::Kind::condition);
  std::vector<double> values;
  for (const Formula::Name& name : condition.names()) values.push_back(name.text == "a" ? a : b);
  return condition.is_true(values);
}

std::string mistake_in_condition(const std::string& text) {
  try {
    const Formula condition(text, Formula::Kind::condition);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("Conditions compare, and join what is compared") {
  CHECK(holds("a < b"));
  CHECK_FALSE(holds("a > b"));
  CHECK(holds("a <= 2 and b >= 3"));
  CHECK_FALSE(holds("a < 2 or b > 3"));
  CHECK(holds("a == 2 and b != 2"));
  CHECK(holds("not(a > b)"));
  CHECK(holds("a + 1 < b + 1 and min(a, b) == a"));  // sums bind closer than comparisons
  CHECK(holds("a > b or a < b and b > 0"));          // `and` closer than `or`
  CHECK_FALSE(holds("(a < b or a > b) and b < 0"));
  CHECK(holds("a"));
  CHECK_FALSE(holds("a", 0.0));
  CHECK(holds("android < oracle", 2.0, 3.0) == false);  // names that begin like an operator
}

TEST_CASE("What is compared with no number is false") {
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (const char* text : {"a < 1", "a > 1", "a == 1", "a != 1", "a <= 1", "a", "a and 1"}) {
    CAPTURE(text);
    CHECK_FALSE(holds(text, none));
    CHECK_FALSE(holds("1 / 0 < 1"));
  }
  CHECK(holds("not(a > 1)", none));
  CHECK(holds("a > 1 or b > 1", none));
}

TEST_CASE("A formula compares nothing, and a condition that is wrong is refused in words") {
  CHECK_THAT(mistake("a < b"), Catch::StartsWith("column 3: unexpected '<'"));
  CHECK_THAT(mistake("not(a)"), Catch::StartsWith("column 1: there is no function 'not'"));
  CHECK_THAT(mistake_in_condition("a <"), Catch::StartsWith("column 4: "));
  CHECK_THAT(mistake_in_condition("a and"), Catch::StartsWith("column 6: "));
  CHECK_THAT(mistake_in_condition("and b"), Catch::StartsWith("column 1: "));
  CHECK_THAT(mistake_in_condition("a = b"), Catch::StartsWith("column 3: "));
  CHECK_THAT(mistake_in_condition("a & b"), Catch::StartsWith("column 3: unexpected '&'"));
  CHECK_THAT(mistake_in_condition("not a"), Catch::StartsWith("column 1: 'not' is a function"));
  CHECK_THAT(mistake_in_condition("sin(a)"),
             Catch::Contains("there are: min, max, abs, sqrt, log, exp, not"));
  CHECK_THAT(mistake_in_condition("0 < a < 1"),
             Catch::StartsWith("column 7: comparisons do not stand in a row"));
  CHECK(mistake_in_condition("(a < 1) == (b < 1) and a <= b").empty());
  CHECK_THAT(mistake_in_condition(""), Catch::StartsWith("column 1: the formula is empty"));
}
