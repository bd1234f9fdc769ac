// Consumers of a set (pieces.h) that also take polynomials, which the algebraic sum of several
// straight edges makes: 1 - (1 - a)(1 - b)...
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "pieces.h"
#include "workspace.h"

namespace elsie::fuzzy {

/// Nodes and weights of Gauss and Legendre's quadrature with ten nodes on [-1, 1], the positive
/// half: exact for polynomials up to degree 19 (Abramowitz and Stegun, 1964, table 25.4).
inline constexpr std::array<double, 5> kNodes = {0.14887433898163122, 0.43339539412924719,
                                                 0.67940956829902441, 0.86506336668898451,
                                                 0.97390652851717172};
inline constexpr std::array<double, 5> kWeights = {0.29552422471475287, 0.26926671930999636,
                                                   0.21908636251598204, 0.14945134915058059,
                                                   0.06667134430868814};
/// With this many edges the integrand of a moment, x (1 - product of the edges), is of degree 19.
inline constexpr std::size_t kMostEdges = 18;

/// The algebraic sum of all edges at a fraction of their length.
inline double algebraic_sum(std::span<const Edge> edges, double t) {
  double none = 1.0;
  for (const Edge& edge : edges) {
    none *= 1.0 - (edge.y0 + t * (edge.y1 - edge.y0));
  }
  return 1.0 - none;
}

/// Calls add(t, weight) for the nodes of the integral over t from t0 to t1, in fractions of a
/// stretch. With more edges than the quadrature is exact for, the stretch is divided, and the error
/// is far below rounding.
template <class Add>
void each_node(std::size_t edges, double t0, double t1, Add add) {
  const std::size_t steps = (edges + kMostEdges - 1) / kMostEdges;
  const double half = 0.5 * (t1 - t0) / static_cast<double>(steps);
  for (std::size_t step = 0; step < steps; ++step) {
    const double middle = t0 + half * static_cast<double>(2 * step + 1);
    for (std::size_t i = 0; i < kNodes.size(); ++i) {
      add(middle - half * kNodes[i], half * kWeights[i]);
      add(middle + half * kNodes[i], half * kWeights[i]);
    }
  }
}

inline double polynomial_area(double width, std::span<const Edge> edges, double t0, double t1) {
  double sum = 0.0;
  each_node(edges.size(), t0, t1,
            [&](double t, double weight) { sum += weight * algebraic_sum(edges, t); });
  return sum * width;
}

struct CentroidWalk : CentroidSink {
  using CentroidSink::CentroidSink;
  void polynomial(double x0, double x1, std::span<const Edge> edges) {
    const double width = x1 - x0;
    each_node(edges.size(), 0.0, 1.0, [&](double t, double weight) {
      const double piece = weight * width * algebraic_sum(edges, t);
      area += piece;
      moment += (x0 - origin + t * width) * piece;
    });
  }
};

struct BisectorWalk : BisectorSink {
  using BisectorSink::BisectorSink;
  void polynomial(double x0, double x1, std::span<const Edge> edges) {
    const double width = x1 - x0;
    piece_ends(x0, x1, polynomial_area(width, edges, 0.0, 1.0), [&](double part) {
      double low = 0.0;
      double high = 1.0;
      while (true) {  // halve the interval as far as numbers allow
        const double t = 0.5 * (low + high);
        if (t <= low || t >= high) {
          return x0 + t * width;
        }
        (polynomial_area(width, edges, 0.0, t) < part ? low : high) = t;
      }
    });
  }
};

struct MaximaWalk : MaximaSink {
  /// The logarithm of the product of (1 - edge) is concave: its lowest values, and so the highest
  /// sums, are at the ends.
  void polynomial(double x0, double x1, std::span<const Edge> edges) {
    const double y0 = algebraic_sum(edges, 0.0);
    const double y1 = algebraic_sum(edges, 1.0);
    const bool flat = std::all_of(edges.begin(), edges.end(),
                                  [](const Edge& edge) { return edge.y0 == edge.y1; });
    // A sum with a full term is full.
    const bool full = std::any_of(edges.begin(), edges.end(), [](const Edge& edge) {
      return edge.y0 == 1.0 && edge.y1 == 1.0;
    });
    if (flat || full) {
      line(x0, x1, y0, y1);
    } else {
      peak(x0, y0);
      peak(x1, y1);
    }
  }
};

struct SetWalk : SetSink {
  using SetSink::SetSink;
  void polynomial(double x0, double x1, std::span<const Edge> edges) {
    // In a stretch of length 1, degrees bend by at most (sum of the slopes)^2: a chord over an n-th
    // part of it is off by at most an eighth of that, over n^2.
    double slopes = 0.0;
    for (const Edge& edge : edges) {
      slopes += std::abs(edge.y1 - edge.y0);
    }
    const int n = std::max(1, static_cast<int>(std::ceil(slopes / std::sqrt(8 * kSetTolerance))));
    double x = x0;
    double y = algebraic_sum(edges, 0.0);
    for (int i = 1; i <= n; ++i) {
      const double t = static_cast<double>(i) / n;
      const double next_x = i == n ? x1 : x0 + t * (x1 - x0);
      const double next_y = algebraic_sum(edges, t);
      if (next_x > x) {
        line(x, next_x, y, next_y);
        x = next_x;
        y = next_y;
      }
    }
  }
};

}  // namespace elsie::fuzzy
