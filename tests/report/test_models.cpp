// Models of the factors.
#include <cmath>

#include <catch2/catch.hpp>

#include "elsie/report/models.h"

using namespace elsie::report;

namespace {

// Times of robots with three speed limits and two coordinators.
const std::vector<double> kLimits{0.05, 0.05, 0.1, 0.1, 0.2, 0.2, 0.2, 0.05};
const std::vector<double> kFusion{0, 1, 0, 1, 0, 1, 0, 1};
const std::vector<double> kTimes{60.1, 62.3, 31.2, 33.9, 15.8, 17.2, 16.4, 61.0};

}  // namespace

TEST_CASE("Least squares gives what a second implementation gives") {
  const std::vector<Term> terms{{"limit", kLimits}, {"fusion", kFusion}};
  const LinearFit fit = fit_linear(terms, kTimes, 0.95);
  // statsmodels 0.13, OLS.
  REQUIRE(fit.coefficients.size() == 3);
  CHECK(fit.coefficients[0].estimate == Approx(69.1));
  CHECK(fit.coefficients[1].estimate == Approx(-278.0));
  CHECK(fit.coefficients[2].estimate == Approx(2.3));
  CHECK(fit.coefficients[0].error == Approx(6.76078079));
  CHECK(fit.coefficients[1].error == Approx(41.24037618));
  CHECK(fit.coefficients[2].error == Approx(5.43117905));
  CHECK(fit.coefficients[1].p == Approx(1.08988838e-03));
  CHECK(fit.coefficients[2].p == Approx(6.89543469e-01));
  CHECK(fit.coefficients[1].interval.low == Approx(-384.01176194));
  CHECK(fit.coefficients[1].interval.high == Approx(-171.98823806));
  CHECK(fit.r_squared == Approx(0.9113701842));
  CHECK(fit.adjusted_r_squared == Approx(0.8759182579));
  CHECK(fit.deviation == Approx(7.3628798714));
  CHECK(fit.freedom == 5);
  CHECK(fit.f == Approx(25.7072119641));
  CHECK(fit.p == Approx(0.0023385659));
  double sum = 0.0;
  for (const double residual : fit.residuals) sum += residual;
  CHECK(sum == Approx(0.0).margin(1e-9));
}

TEST_CASE("Logistic regression gives the published fit of the hours of study") {
  // Twenty students; the example of Wikipedia's article on logistic regression.
  const std::vector<double> hours{0.5,  0.75, 1,    1.25, 1.5, 1.75, 1.75, 2,    2.25, 2.5,
                                  2.75, 3,    3.25, 3.5,  4,   4.25, 4.5,  4.75, 5,    5.5};
  const std::vector<bool> passed{false, false, false, false, false, false, true, false, true, false,
                                 true,  false, true,  false, true,  true,  true, true,  true, true};
  const std::vector<Term> terms{{"hours", hours}};
  const LogisticFit fit = fit_logistic(terms, passed, 0.95);
  // statsmodels 0.13, GLM of the binomial family.
  CHECK(fit.coefficients[0].estimate == Approx(-4.07771343).epsilon(1e-7));
  CHECK(fit.coefficients[1].estimate == Approx(1.50464543).epsilon(1e-7));
  CHECK(fit.coefficients[0].error == Approx(1.7610).epsilon(1e-4));
  CHECK(fit.coefficients[1].p == Approx(0.0167).epsilon(1e-3));
  CHECK(fit.deviance == Approx(16.05975692868935));
  CHECK(fit.null_deviance == Approx(27.72588722239781));
  CHECK(fit.separated.empty());
}

TEST_CASE("A term that is a combination of others is left out and named") {
  std::vector<double> slow;
  for (const double limit : kLimits) slow.push_back(1.0 - 2.0 * limit);
  const std::vector<Term> terms{{"limit", kLimits}, {"slow", slow}, {"fusion", kFusion}};
  const LinearFit fit = fit_linear(terms, kTimes, 0.95);
  CHECK(fit.left_out == std::vector<std::string>{"slow"});
  CHECK(fit.coefficients.size() == 3);
  CHECK(fit.r_squared == Approx(0.9113701842));
}

TEST_CASE("Collinearity shows as inflation of the variance") {
  std::vector<double> nearly;
  for (std::size_t i = 0; i < kLimits.size(); ++i)
    nearly.push_back(kLimits[i] + static_cast<double>(i % 3) * 0.001);
  const std::vector<Term> apart{{"limit", kLimits}, {"fusion", kFusion}};
  const std::vector<Term> alike{{"limit", kLimits}, {"nearly", nearly}};
  CHECK(*fit_linear(apart, kTimes, 0.95).coefficients[1].inflation < 1.3);
  CHECK(*fit_linear(alike, kTimes, 0.95).coefficients[1].inflation > kMuchInflation);
  CHECK_FALSE(fit_linear(alike, kTimes, 0.95).coefficients[0].inflation);
}

TEST_CASE("Successes that a term separates from the others are said") {
  const std::vector<double> x{1, 2, 3, 4, 5, 6, 7, 8};
  const std::vector<bool> complete{false, false, false, false, true, true, true, true};
  const std::vector<Term> one{{"x", x}};
  CHECK(fit_logistic(one, complete, 0.95).separated == std::vector<std::string>{"", "x"});
  // Only the second level always succeeds: its coefficient has no limit, the others have.
  const std::vector<double> second{0, 0, 0, 0, 1, 1, 1, 1};
  const std::vector<bool> some{true, false, true, false, true, true, true, true};
  const std::vector<Term> level{{"second", second}};
  const LogisticFit fit = fit_logistic(level, some, 0.95);
  CHECK(fit.separated == std::vector<std::string>{"second"});
  CHECK(fit.coefficients[0].estimate == Approx(0.0).margin(1e-9));
}

TEST_CASE("A coefficient with a huge standard error is separated, however slowly it grows") {
  // Without `other`, success is x > 0.025: the constant grows forty times as slowly as x.
  const std::vector<Term> terms{{"x", {-1, -0.9, 0.95, 1, 0, 0, 0, 0}},
                                {"other", {0, 0, 0, 0, 1, 1, 1, 1}}};
  const LogisticFit fit =
      fit_logistic(terms, {false, false, true, true, true, false, true, false}, 0.95);
  CHECK(fit.separated == std::vector<std::string>{"", "x", "other"});
  CHECK_FALSE(fit.perfect);
}

TEST_CASE("Where the terms tell all successes from all failures, nothing can be estimated") {
  const std::vector<Term> terms{{"x", {1, 2, 3, 4, 5, 6, 7, 8}}, {"y", {1, 0, 1, 0, 0, 1, 0, 1}}};
  const LogisticFit fit =
      fit_logistic(terms, {false, false, false, false, true, true, true, true}, 0.95);
  CHECK(fit.perfect);
  CHECK(fit.separated == std::vector<std::string>{"", "x", "y"});
}

TEST_CASE("What no model can explain is refused in a sentence") {
  const std::vector<Term> one{{"x", {1, 2, 3}}}, two{{"x", {1, 2, 4}}, {"y", {2, 1, 7}}};
  const std::vector<double> equal{5, 5, 5}, values{1, 2, 4};
  CHECK_THROWS_WITH(fit_linear(one, equal, 0.95), Catch::Contains("all 3 values are equal"));
  CHECK_THROWS_WITH(fit_linear(two, values, 0.95),
                    Catch::Contains("a model with 3 coefficients needs more observations"));
  CHECK_THROWS_WITH(fit_logistic(one, {true, true, true}, 0.95),
                    Catch::Contains("all 3 runs succeeded"));
  CHECK_THROWS_WITH(fit_logistic(one, {false, false, false}, 0.95),
                    Catch::Contains("all 3 runs failed"));
}

TEST_CASE("A fit without any error has no uncertainty and is finite") {
  const std::vector<Term> one{{"x", {1, 2, 3, 4}}};
  const LinearFit fit = fit_linear(one, std::vector<double>{2, 4, 6, 8}, 0.95);
  CHECK(fit.r_squared == Approx(1.0));
  CHECK(fit.coefficients[1].estimate == Approx(2.0));
  CHECK(fit.p == 0.0);
}
