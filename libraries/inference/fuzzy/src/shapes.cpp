#include "shapes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <stdexcept>

#include "elsie/base/words.h"
#include "elsie/fuzzy/fcl.h"

#include "text.h"

namespace elsie::fuzzy {

namespace {

using Points = std::vector<FuzzySet::Point>;

/// A curve ends when it is this near to its limit.
constexpr double kTail = 1e-4;

[[noreturn]] void refuse(const std::string& sentence) { throw std::invalid_argument(sentence); }

double sigmoid_at(double x, double centre, double slope) {
  return 1.0 / (1.0 + std::exp(-slope * (x - centre)));
}

/// Logistic curves end this far from their centres.
double sigmoid_reach(double slope) { return std::log(1.0 / kTail) / std::abs(slope); }

double gaussian_at(double x, double mean, double deviation) {
  const double z = (x - mean) / deviation;
  return std::exp(-0.5 * z * z);
}

/// Gaussian curves end this many deviations from their means.
double gaussian_reach() { return std::sqrt(2.0 * std::log(1.0 / kTail)); }

/// The S curve of two parabolas from 0 at `from` to 1 at `to` (from < to).
double s_curve(double x, double from, double to) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t < 0.5 ? 2.0 * t * t : 1.0 - 2.0 * (1.0 - t) * (1.0 - t);
}

/// One call of make_shape().
class Shape {
 public:
  Shape(std::string_view name, std::span<const double> parameters,
        const std::optional<Range>& range)
      : name_(name), p_(parameters), range_(range) {}

  FuzzySet make();

 private:
  void require(bool holds, const std::string& what) const {
    if (!holds) {
      refuse("The parameters of " + name_ + " do not fit together: " + what + ".");
    }
  }
  void require_finite() const {
    require(std::all_of(p_.begin(), p_.end(), [](double p) { return std::isfinite(p); }),
            "all must be finite");
  }

  /// Adds a corner, unless it is at infinity.
  void corner(double x, double degree) {
    if (std::isfinite(x)) {
      set_.points.push_back({x, degree});
    }
  }

  void trapezoid(double a, double b, double c, double d);
  void discrete();

  /// Adds a curve that bends at the knots, and ends with the range, or else at the first and last
  /// knot.
  void curve(const std::function<double(double)>& function, std::vector<double> knots);

  std::string name_;
  std::span<const double> p_;
  const std::optional<Range>& range_;
  FuzzySet set_;
};

void Shape::trapezoid(double a, double b, double c, double d) {
  require(a <= b && b <= c && c <= d, "they must ascend");
  require(a < d, "the first must be below the last");
  corner(a, 0.0);
  corner(b, 1.0);
  if (c != b) {
    corner(c, 1.0);
  }
  corner(d, 0.0);
  require(!set_.points.empty(), "one must be finite");
}

void Shape::discrete() {
  require_finite();
  require(!p_.empty() && p_.size() % 2 == 0, "they come in pairs of x and degree");
  for (std::size_t i = 0; i + 1 < p_.size(); i += 2) {
    require(i == 0 || p_[i - 2] < p_[i], "the x must ascend");
    require(p_[i + 1] >= 0.0 && p_[i + 1] <= 1.0, "degrees lie in 0 to 1");
    set_.points.push_back({p_[i], p_[i + 1]});
  }
}

void Shape::curve(const std::function<double(double)>& function, std::vector<double> knots) {
  std::sort(knots.begin(), knots.end());
  require(std::isfinite(knots.front()) && std::isfinite(knots.back()),
          "the curve is too wide for numbers");
  if (range_) {
    std::erase_if(knots, [&](double x) { return x <= range_->low || x >= range_->high; });
    knots.insert(knots.begin(), range_->low);
    knots.push_back(range_->high);
  }
  knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
  require(knots.size() > 1, "the curve is too narrow for numbers");
  draw_curve(function, knots, set_.points);
}

struct Kind {
  enum Form {
    triangle,
    trapezoid,
    rectangle,
    ramp,
    discrete,
    binary,
    gaussian,
    gaussian_product,
    bell,
    sigmoid,
    sigmoid_difference,
    sigmoid_product,
    s_shape,
    z_shape,
    pi_shape,
    cosine,
    spike,
    concave,
  } form;
  /// For each parameter in this name's order, its index in the order of the code below.
  std::vector<std::size_t> order;
  const char* parameters;
};

struct NamedKind {
  const char* name;
  Kind kind;
};

const std::vector<NamedKind>& kinds() {
  static const std::vector<NamedKind> kAll = {
      {"Triangle", {Kind::triangle, {0, 1, 2}, "a b c"}},
      {"triangular", {Kind::triangle, {0, 1, 2}, "a b c"}},
      {"trian", {Kind::triangle, {0, 1, 2}, "a b c"}},
      {"trimf", {Kind::triangle, {0, 1, 2}, "a b c"}},
      {"Trapezoid", {Kind::trapezoid, {0, 1, 2, 3}, "a b c d"}},
      {"trapezoidal", {Kind::trapezoid, {0, 1, 2, 3}, "a b c d"}},
      {"trape", {Kind::trapezoid, {0, 1, 2, 3}, "a b c d"}},
      {"trapmf", {Kind::trapezoid, {0, 1, 2, 3}, "a b c d"}},
      {"Rectangle", {Kind::rectangle, {0, 1}, "start end"}},
      {"Ramp", {Kind::ramp, {0, 1}, "from to"}},
      {"Discrete", {Kind::discrete, {}, "x degree x degree ..."}},
      {"Binary", {Kind::binary, {0, 1}, "start direction"}},
      {"Gaussian", {Kind::gaussian, {0, 1}, "mean deviation"}},
      {"gauss", {Kind::gaussian, {0, 1}, "mean deviation"}},
      {"gaussmf", {Kind::gaussian, {1, 0}, "deviation mean"}},
      {"GaussianProduct", {Kind::gaussian_product, {0, 1, 2, 3}, "mean deviation mean deviation"}},
      {"gauss2", {Kind::gaussian_product, {0, 1, 2, 3}, "mean deviation mean deviation"}},
      {"gauss2mf", {Kind::gaussian_product, {1, 0, 3, 2}, "deviation mean deviation mean"}},
      {"Bell", {Kind::bell, {0, 1, 2}, "centre width slope"}},
      {"gbell", {Kind::bell, {1, 2, 0}, "width slope centre"}},
      {"gbellmf", {Kind::bell, {1, 2, 0}, "width slope centre"}},
      {"Sigmoid", {Kind::sigmoid, {0, 1}, "centre slope"}},
      {"sigm", {Kind::sigmoid, {1, 0}, "slope centre"}},
      {"sigmf", {Kind::sigmoid, {1, 0}, "slope centre"}},
      {"SigmoidDifference", {Kind::sigmoid_difference, {0, 1, 3, 2}, "left rising falling right"}},
      {"dsigm", {Kind::sigmoid_difference, {1, 0, 3, 2}, "slope centre slope centre"}},
      {"dsigmf", {Kind::sigmoid_difference, {1, 0, 3, 2}, "slope centre slope centre"}},
      {"SigmoidProduct", {Kind::sigmoid_product, {0, 1, 3, 2}, "left rising falling right"}},
      {"psigmf", {Kind::sigmoid_product, {1, 0, 3, 2}, "slope centre slope centre"}},
      {"SShape", {Kind::s_shape, {0, 1}, "from to"}},
      {"smf", {Kind::s_shape, {0, 1}, "from to"}},
      {"ZShape", {Kind::z_shape, {0, 1}, "from to"}},
      {"zmf", {Kind::z_shape, {0, 1}, "from to"}},
      {"PiShape", {Kind::pi_shape, {0, 1, 2, 3}, "a b c d"}},
      {"pimf", {Kind::pi_shape, {0, 1, 2, 3}, "a b c d"}},
      {"Cosine", {Kind::cosine, {0, 1}, "centre width"}},
      {"Spike", {Kind::spike, {0, 1}, "centre width"}},
      {"Concave", {Kind::concave, {0, 1}, "inflection end"}},
  };
  return kAll;
}

std::vector<NamedKind>::const_iterator kind_named(std::string_view name) {
  return std::find_if(kinds().begin(), kinds().end(),
                      [&](const NamedKind& candidate) { return same_name(candidate.name, name); });
}

FuzzySet Shape::make() {
  const auto named = kind_named(name_);
  if (named == kinds().end()) {
    std::vector<std::string> full_names;  // the other names abbreviate these
    std::copy_if(shape_names().begin(), shape_names().end(), std::back_inserter(full_names),
                 [](const std::string& name) { return name[0] >= 'A' && name[0] <= 'Z'; });
    refuse("Found the shape '" + name_ + "', which is not known." +
           did_you_mean(name_, shape_names()) + " Known are " + base::enumerated(full_names, "or") +
           ".");
  }
  if (named->kind.form == Kind::cosine && name_ != named->name) {
    refuse("Found the shape '" + name_ +
           "', whose numbers are the centre and the width in fuzzylite, which writes Cosine, and "
           "half the width and the centre in jFuzzyLogic. Write Cosine, the centre and the width.");
  }
  name_ = named->name;
  const Kind& kind = named->kind;
  if (kind.form == Kind::discrete) {
    discrete();
    return std::move(set_);
  }

  const std::size_t count = kind.order.size();
  if (p_.size() != count && p_.size() != count + 1) {
    refuse(name_ + " takes " + std::to_string(count) + " numbers (" + kind.parameters +
           ") and perhaps a height, but here are " + std::to_string(p_.size()) + ".");
  }
  const double height = p_.size() > count ? p_[count] : 1.0;
  require(height > 0.0 && height <= 1.0, "the height must be above 0 and at most 1");
  double v[4] = {};
  for (std::size_t i = 0; i < count; ++i) {
    v[kind.order[i]] = p_[i];
  }
  if (kind.form != Kind::triangle && kind.form != Kind::trapezoid && kind.form != Kind::binary) {
    require_finite();
  }
  require(std::none_of(p_.begin(), p_.end(), [](double p) { return std::isnan(p); }),
          "nan is no number");

  switch (kind.form) {
    case Kind::triangle:
      require(std::isfinite(v[1]), "the peak must be finite");
      trapezoid(v[0], v[1], v[1], v[2]);
      break;
    case Kind::trapezoid:
      trapezoid(v[0], v[1], v[2], v[3]);
      break;
    case Kind::rectangle:
      require(v[0] < v[1], "start must be below end");
      set_.points = {{v[0], 0.0}, {v[0], 1.0}, {v[1], 1.0}, {v[1], 0.0}};
      break;
    case Kind::ramp:
      require(v[0] != v[1], "the two must differ");
      set_.points =
          v[0] < v[1] ? Points{{v[0], 0.0}, {v[1], 1.0}} : Points{{v[1], 1.0}, {v[0], 0.0}};
      break;
    case Kind::discrete:
      break;  // above
    case Kind::binary:
      require(std::isfinite(v[0]), "start must be finite");
      require(v[0] != v[1], "start and direction must differ");
      set_.points =
          v[1] > v[0] ? Points{{v[0], 0.0}, {v[0], 1.0}} : Points{{v[0], 1.0}, {v[0], 0.0}};
      break;
    case Kind::gaussian: {
      require(v[1] > 0.0, "the deviation must be above 0");
      const double reach = gaussian_reach() * v[1];
      curve([&](double x) { return gaussian_at(x, v[0], v[1]); },
            {v[0] - reach, v[0] - v[1], v[0], v[0] + v[1], v[0] + reach});
      break;
    }
    case Kind::gaussian_product: {
      require(v[1] > 0.0 && v[3] > 0.0, "the deviations must be above 0");
      const auto rising = [&](double x) { return x < v[0] ? gaussian_at(x, v[0], v[1]) : 1.0; };
      const auto falling = [&](double x) { return x > v[2] ? gaussian_at(x, v[2], v[3]) : 1.0; };
      curve([&](double x) { return rising(x) * falling(x); },
            {v[0] - gaussian_reach() * v[1], v[0] - v[1], v[0], v[2], v[2] + v[3],
             v[2] + gaussian_reach() * v[3]});
      break;
    }
    case Kind::bell: {
      require(v[1] > 0.0 && v[2] > 0.0, "width and slope must be above 0");
      const double reach = v[1] * std::pow(1.0 / kTail, 0.5 / v[2]);
      curve(
          [&](double x) { return 1.0 / (1.0 + std::pow(std::abs((x - v[0]) / v[1]), 2.0 * v[2])); },
          {v[0] - reach, v[0] - v[1], v[0], v[0] + v[1], v[0] + reach});
      break;
    }
    case Kind::sigmoid: {
      require(v[1] != 0.0, "the slope must not be 0");
      const double reach = sigmoid_reach(v[1]);
      curve([&](double x) { return sigmoid_at(x, v[0], v[1]); },
            {v[0] - reach, v[0], v[0] + reach});
      break;
    }
    case Kind::sigmoid_difference:
    case Kind::sigmoid_product: {
      require(v[1] != 0.0 && v[3] != 0.0, "the slopes must not be 0");
      const double a = sigmoid_reach(v[1]);
      const double b = sigmoid_reach(v[3]);
      const bool product = kind.form == Kind::sigmoid_product;
      const bool is_cut_off = name_ == "dsigm";  // jFuzzyLogic's; others take the absolute value
      curve(
          [&](double x) {
            const double first = sigmoid_at(x, v[0], v[1]);
            const double second = sigmoid_at(x, v[2], v[3]);
            return product      ? first * second
                   : is_cut_off ? std::max(first - second, 0.0)
                                : std::abs(first - second);
          },
          {v[0] - a, v[0], v[0] + a, v[2] - b, v[2], v[2] + b});
      break;
    }
    case Kind::s_shape:
    case Kind::z_shape: {
      require(v[0] < v[1], "the first must be below the second");
      const bool falls = kind.form == Kind::z_shape;
      curve([&](double x) { return falls ? 1.0 - s_curve(x, v[0], v[1]) : s_curve(x, v[0], v[1]); },
            {v[0], 0.5 * (v[0] + v[1]), v[1]});
      break;
    }
    case Kind::pi_shape:
      require(v[0] < v[1] && v[1] <= v[2] && v[2] < v[3], "they must ascend");
      curve([&](double x) { return s_curve(x, v[0], v[1]) * (1.0 - s_curve(x, v[2], v[3])); },
            {v[0], 0.5 * (v[0] + v[1]), v[1], v[2], 0.5 * (v[2] + v[3]), v[3]});
      break;
    case Kind::cosine:
      require(v[1] > 0.0, "the width must be above 0");
      curve(
          [&](double x) {
            const double turns = std::min(std::abs(x - v[0]) / v[1], 0.5);
            return 0.5 * (1.0 + std::cos(2.0 * std::numbers::pi * turns));
          },
          {v[0] - 0.5 * v[1], v[0] - 0.25 * v[1], v[0], v[0] + 0.25 * v[1], v[0] + 0.5 * v[1]});
      break;
    case Kind::spike: {
      require(v[1] > 0.0, "the width must be above 0");
      const double reach = 0.1 * std::log(1.0 / kTail) * v[1];
      curve([&](double x) { return std::exp(-std::abs(10.0 / v[1] * (x - v[0]))); },
            {v[0] - reach, v[0], v[0] + reach});
      break;
    }
    case Kind::concave: {
      require(v[0] != v[1], "the two must differ");
      const double width = std::abs(v[1] - v[0]);
      const double side = v[0] < v[1] ? 1.0 : -1.0;  // which side is 1
      curve(
          [&](double x) {
            const double short_of_end = side * (v[1] - x);
            return short_of_end <= 0.0 ? 1.0 : width / (width + short_of_end);
          },
          {v[1], v[1] - side * width / kTail});
      break;
    }
  }
  for (FuzzySet::Point& point : set_.points) {
    point.degree = std::clamp(point.degree, 0.0, 1.0) * height;
  }
  return std::move(set_);
}

}  // namespace

std::span<const std::string> shape_names() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names;
    for (const NamedKind& kind : kinds()) {
      names.emplace_back(kind.name);
    }
    return names;
  }();
  return kNames;
}

std::optional<double> only_corner(std::string_view name, std::span<const double> parameters) {
  const auto named = kind_named(name);
  const bool has_corners = named != kinds().end() && (named->kind.form == Kind::triangle ||
                                                      named->kind.form == Kind::trapezoid);
  return has_corners && parameters.size() == named->kind.order.size() &&
                 std::isfinite(parameters.front()) &&
                 std::all_of(parameters.begin(), parameters.end(),
                             [&](double each) { return each == parameters.front(); })
             ? std::optional(parameters.front())
             : std::nullopt;
}

FuzzySet make_shape(std::string_view name, std::span<const double> parameters,
                    const std::optional<Range>& range) {
  return Shape(name, parameters, range).make();
}

void draw_curve(const std::function<double(double)>& function, std::span<const double> knots,
                std::vector<FuzzySet::Point>& points) {
  // Where a function bends one way, its distance from a chord is concave: its largest value is at
  // most twice that in the middle. Stretches between knots are divided first, so that other points
  // of inflection fall into short pieces.
  constexpr int kPieces = 8;
  constexpr int kDeepestSplit = 40;
  struct Drawer {
    const std::function<double(double)>& function;
    std::vector<FuzzySet::Point>& points;

    void draw(FuzzySet::Point a, FuzzySet::Point b, int depth) const {
      double furthest = 0.0;
      FuzzySet::Point middle;
      for (const double t : {0.25, 0.75, 0.5}) {
        middle.x = a.x + t * (b.x - a.x);
        middle.degree = function(middle.x);
        furthest =
            std::max(furthest, std::abs(middle.degree - (a.degree + t * (b.degree - a.degree))));
      }
      if (furthest > 0.5 * kCurveTolerance && depth < kDeepestSplit && a.x < middle.x &&
          middle.x < b.x) {
        draw(a, middle, depth + 1);
        draw(middle, b, depth + 1);
      } else {
        points.push_back(b);
      }
    }
  };
  points.push_back({knots.front(), function(knots.front())});
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    FuzzySet::Point from{knots[i], function(knots[i])};
    for (int k = 1; k <= kPieces; ++k) {
      const double x =
          k == kPieces ? knots[i + 1] : knots[i] + (knots[i + 1] - knots[i]) * k / kPieces;
      if (x > from.x) {
        const FuzzySet::Point to{x, function(x)};
        Drawer{function, points}.draw(from, to, 0);
        from = to;
      }
    }
  }
}

namespace {

double hedged_degree(double degree, std::string_view hedge) {
  const double d = std::clamp(degree, 0.0, 1.0);
  if (hedge == "very") {
    return d * d;
  }
  if (hedge == "somewhat") {
    return std::sqrt(d);
  }
  if (hedge == "extremely") {
    return d <= 0.5 ? 2.0 * d * d : 1.0 - 2.0 * (1.0 - d) * (1.0 - d);
  }
  return d <= 0.5 ? std::sqrt(0.5 * d) : 1.0 - std::sqrt(0.5 * (1.0 - d));  // seldom
}

}  // namespace

double hedged(double degree, std::string_view hedges) {
  while (!hedges.empty()) {
    const std::size_t space = hedges.rfind(' ');
    const bool is_last = space == std::string_view::npos;
    degree = hedged_degree(degree, is_last ? hedges : hedges.substr(space + 1));
    hedges = is_last ? "" : hedges.substr(0, space);
  }
  return degree;
}

FuzzySet hedged(const FuzzySet& set, std::string_view hedges) {
  if (hedges.empty()) {
    return set;
  }
  const std::size_t space = hedges.rfind(' ');
  const std::string_view hedge =
      space == std::string_view::npos ? hedges : hedges.substr(space + 1);
  FuzzySet result;
  for (std::size_t i = 0; i < set.points.size(); ++i) {
    const FuzzySet::Point& to = set.points[i];
    const FuzzySet::Point& from = set.points[i == 0 ? 0 : i - 1];
    if (from.x < to.x && from.degree != to.degree) {
      result.points.pop_back();  // drawn again
      const double knots[] = {from.x, to.x};
      draw_curve(
          [&](double x) {
            const double t = (x - from.x) / (to.x - from.x);
            return hedged_degree(from.degree + t * (to.degree - from.degree), hedge);
          },
          knots, result.points);
    } else {
      result.points.push_back({to.x, hedged_degree(to.degree, hedge)});
    }
  }
  return hedged(result, space == std::string_view::npos ? "" : hedges.substr(0, space));
}

}  // namespace elsie::fuzzy
