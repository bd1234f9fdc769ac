// A curve that a plugin has to show.
#pragma once

#include <string>
#include <vector>

namespace elsie {

/// How one number depends on another: the error of a network over the samples that it was shown.
struct Curve {
  struct Point {
    double x = 0.0;
    double y = 0.0;

    friend bool operator==(const Point&, const Point&) = default;
  };

  std::string name;     // what it is, in a word: "error"
  std::string x_label;  // with the unit, where there is one: "presentations"
  std::string y_label;
  std::vector<Point> points;  // finite; x ascending

  friend bool operator==(const Curve&, const Curve&) = default;
};

}  // namespace elsie
