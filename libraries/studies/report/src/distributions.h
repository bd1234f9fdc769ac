// Distributions of test statistics. Boost.Math, which is slow to compile, stands behind them once.
#pragma once

#include <cstddef>

namespace elsie::report {

/// How many standard deviations to both sides of the mean hold this part of a normal distribution.
double normal_reach(double confidence);
/// The probability of being as far as |z| standard deviations from the mean, or farther.
double normal_two_sided(double z);

/// Student's t with these degrees of freedom: the value that this part is below.
double student_quantile(double probability, double freedom);
double student_two_sided(double t, double freedom);

/// The probability of values above f: Fisher's F.
double fisher_above(double f, double between, double within);
double chi_squared_above(double value, double freedom);

/// The probability of at most `most` heads in `count` throws of a fair coin.
double fair_at_most(std::size_t most, std::size_t count);

}  // namespace elsie::report
