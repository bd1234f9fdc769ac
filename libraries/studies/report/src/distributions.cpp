#include "distributions.h"

#include <cmath>

#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace elsie::report {

using boost::math::cdf;
using boost::math::complement;
using boost::math::quantile;

double normal_reach(double confidence) {
  return quantile(boost::math::normal(), 0.5 + 0.5 * confidence);
}

double normal_two_sided(double z) {
  return 2.0 * cdf(complement(boost::math::normal(), std::abs(z)));
}

double student_quantile(double probability, double freedom) {
  return quantile(boost::math::students_t(freedom), probability);
}

double student_two_sided(double t, double freedom) {
  return 2.0 * cdf(complement(boost::math::students_t(freedom), std::abs(t)));
}

double fisher_above(double f, double between, double within) {
  return cdf(complement(boost::math::fisher_f(between, within), f));
}

double chi_squared_above(double value, double freedom) {
  return cdf(complement(boost::math::chi_squared(freedom), value));
}

double fair_at_most(std::size_t most, std::size_t count) {
  const boost::math::binomial heads(static_cast<double>(count), 0.5);
  return cdf(heads, static_cast<double>(most));
}

}  // namespace elsie::report
