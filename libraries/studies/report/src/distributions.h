// Distributions of test statistics. Only their source includes Boost.Math, which is slow to
// compile.
#pragma once

#include <cstddef>

namespace elsie::report {

/// The z for which the interval from -z to z contains this part of a standard normal distribution.
double normal_reach(double confidence);
/// The probability of being as far as |z| standard deviations from the mean, or farther.
double normal_two_sided(double z);

/// The quantile of Student's t with these degrees of freedom.
double student_quantile(double probability, double freedom);
/// The probability of values at least as far from 0 as t.
double student_two_sided(double t, double freedom);

/// The probability of values above f, of Fisher's F.
double fisher_above(double f, double between, double within);
/// The probability of values above this one.
double chi_squared_above(double value, double freedom);

/// The probability of at most `most` heads in `count` throws of a fair coin.
double fair_at_most(std::size_t most, std::size_t count);

}  // namespace elsie::report
