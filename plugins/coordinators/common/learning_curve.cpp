#include "learning_curve.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace {

constexpr double kMostPoints = 200;

}  // namespace

elsie::Curve learning_curve(const elsie::neural::Training& training) {
  elsie::Curve curve{"error", "presentations", "mean error of an epoch", {}};
  const auto& points = training.curve;
  if (points.empty()) {
    return curve;
  }
  const auto first = static_cast<double>(points.front().presentations);
  const auto last = static_cast<double>(points.back().presentations);
  const double ratio = std::pow(last / first, 1.0 / (kMostPoints - 2.0));
  double end = first;  // of the current step
  for (std::size_t i = 0; i < points.size();) {
    double sum = 0.0;
    const std::size_t begin = i;
    do {
      sum += points[i++].error;
    } while (i < points.size() && static_cast<double>(points[i].presentations) <= end);
    curve.points.push_back(
        {static_cast<double>(points[i - 1].presentations), sum / static_cast<double>(i - begin)});
    end = std::max(end, curve.points.back().x) * ratio;
  }
  return curve;
}
