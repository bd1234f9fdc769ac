// A curve that a plugin shows to the user.
#pragma once

#include <string>
#include <vector>

namespace elsie {

/// One number as a function of another: the error of a network over the samples presented to it.
struct Curve {
  struct Point {
    double x = 0.0;
    double y = 0.0;

    friend bool operator==(const Point&, const Point&) = default;
  };

  std::string name;     // one word: "error"
  std::string x_label;  // with the unit, where there is one: "presentations"
  std::string y_label;
  std::vector<Point> points;  // finite; x ascending

  friend bool operator==(const Curve&, const Curve&) = default;
};

}  // namespace elsie
