#include "regions.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>
#include <variant>

#include "elsie/api/geometry.h"
#include "elsie/base/number_text.h"

namespace elsie::layouts {

namespace {

constexpr int kTriesInCell = 10;  // of a grid with jitter

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

Spot around(double x, double y, double radius, Random& random) {
  const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
  return {x + radius * std::cos(angle), y + radius * std::sin(angle)};
}

/// The rectangle along the axes that a region fills.
Area extent_of(const Region& region) {
  return std::visit(Overloaded{[&](const InBox& box) -> Area {
                                 const double length = box.area.length;
                                 const double width = box.area.width;
                                 const double c = std::abs(std::cos(radians(box.heading_deg)));
                                 const double s = std::abs(std::sin(radians(box.heading_deg)));
                                 // So that a region as large as the arena does not reach out of it.
                                 const auto rounded = [](double v) {
                                   return std::min(v, rounded_m(v));
                                 };
                                 return {box.area.x, box.area.y, rounded(c * length + s * width),
                                         rounded(s * length + c * width)};
                               },
                               [](const InDisc& disc) -> Area {
                                 return {disc.x, disc.y, 2.0 * disc.radius, 2.0 * disc.radius};
                               },
                               [](const InRing& ring) -> Area {
                                 return {ring.x, ring.y, 2.0 * ring.outer, 2.0 * ring.outer};
                               },
                               [](const Gaussian& cloud) -> Area {
                                 return {cloud.x, cloud.y, 0.0, 0.0};
                               },
                               [](const OnGrid& grid) { return grid.area; },
                               [](const OnLine& line) -> Area {
                                 return {0.5 * (line.x1 + line.x2), 0.5 * (line.y1 + line.y2),
                                         std::abs(line.x2 - line.x1), std::abs(line.y2 - line.y1)};
                               }},
                    region);
}

}  // namespace

Places::Places(Drawing& drawing, const Scatter& scatter)
    : scatter_(scatter),
      region_(scatter.regions.empty()
                  ? Region(InBox{{0.0, 0.0, drawing.arena.length, drawing.arena.width}, 0.0})
                  : scatter.regions.front()) {
  is_right_ = check(drawing) && check_heading(drawing);
  if (const auto* grid = std::get_if<OnGrid>(&region_)) {
    cells_.resize(static_cast<std::size_t>(grid->columns) * static_cast<std::size_t>(grid->rows));
    std::iota(cells_.begin(), cells_.end(), std::size_t{0});
    Random random = drawing.stream(scatter.id + "/cells");
    for (std::size_t i = cells_.size(); i > 1; --i) {
      std::swap(cells_[i - 1], cells_[drawn_index(random, i)]);
    }
  }
}

bool Places::check(Drawing& drawing) {
  if (scatter_.regions.size() > 1) {
    return drawing.refuse(scatter_.location, scatter_.id,
                          "says more than once where its things stand; expected one of in_box, "
                          "in_disc, in_ring, gaussian, on_grid and on_line");
  }
  if (const auto* ring = std::get_if<InRing>(&region_); ring && ring->inner >= ring->outer) {
    return drawing.refuse(scatter_.location, scatter_.id,
                          "has a ring from the radius " + base::number_text(ring->inner) +
                              " m to " + base::number_text(ring->outer) +
                              " m; expected an inner radius below the outer one");
  }
  return drawing.require_inside(extent_of(region_), scatter_.location, scatter_.id);
}

bool Places::check_heading(Drawing& drawing) const {
  if (!scatter_.heading) {
    return true;
  }
  const HeadingRule& rule = *scatter_.heading;
  if (rule.rule == "along" && !std::holds_alternative<OnLine>(region_)) {
    return drawing.refuse(rule.location, scatter_.id,
                          "has things that face along a line, but no <on_line>; add one, or choose "
                          "another rule");
  }
  if (rule.rule == "uniform" && rule.from_deg > rule.to_deg) {
    return drawing.refuse(rule.location, scatter_.id,
                          "has headings from " + base::number_text(rule.from_deg) + " to " +
                              base::number_text(rule.to_deg) +
                              " degrees; expected the least first");
  }
  return true;
}

std::optional<double> Places::area() const {
  return std::visit(Overloaded{[&](const InBox& box) -> std::optional<double> {
                                 return box.area.length * box.area.width;
                               },
                               [](const InDisc& disc) -> std::optional<double> {
                                 return std::numbers::pi * disc.radius * disc.radius;
                               },
                               [](const InRing& ring) -> std::optional<double> {
                                 return std::numbers::pi *
                                        (ring.outer * ring.outer - ring.inner * ring.inner);
                               },
                               [&](const OnGrid& grid) -> std::optional<double> {
                                 const Area area = grid.area;
                                 return area.length * area.width;
                               },
                               [](const auto&) -> std::optional<double> { return std::nullopt; }},
                    region_);
}

std::optional<std::size_t> Places::most() const {
  return std::holds_alternative<OnGrid>(region_) ? std::optional(cells_.size()) : std::nullopt;
}

std::optional<Spot> Places::next(std::size_t thing, int attempt, Random& random) {
  const bool is_last = attempt >= scatter_.tries;
  std::optional<Spot> spot = std::visit(
      Overloaded{
          [&](const InBox& box) -> std::optional<Spot> {
            const double along = random.uniform(-0.5, 0.5) * box.area.length;
            const double across = random.uniform(-0.5, 0.5) * box.area.width;
            const Vector2 at =
                point_of({box.area.x, box.area.y, radians(box.heading_deg)}, {along, across});
            return Spot{at.x, at.y};
          },
          [&](const InDisc& disc) -> std::optional<Spot> {
            return around(disc.x, disc.y, disc.radius * std::sqrt(random.uniform()), random);
          },
          [&](const InRing& ring) -> std::optional<Spot> {
            const double inner = ring.inner * ring.inner, outer = ring.outer * ring.outer;
            return around(ring.x, ring.y, std::sqrt(random.uniform(inner, outer)), random);
          },
          [&](const Gaussian& cloud) -> std::optional<Spot> {
            const double x = random.normal(cloud.x, cloud.sd);
            return Spot{x, random.normal(cloud.y, cloud.sd)};
          },
          [&](const OnGrid& grid) -> std::optional<Spot> {
            // Without jitter, each cell has one place.
            const int tries = grid.jitter > 0.0 ? kTriesInCell : 1;
            if (static_cast<std::size_t>(attempt / tries) >= cells_.size()) {
              return std::nullopt;
            }
            if (attempt > 0 && attempt % tries == 0) {
              cells_.push_front(cells_.back());
              cells_.pop_back();
            }
            const Area area = grid.area;
            const auto columns = static_cast<std::size_t>(grid.columns);
            const double length = area.length / grid.columns, width = area.width / grid.rows;
            const std::size_t column = cells_.back() % columns, row = cells_.back() / columns;
            const double x = area.left() + length * (0.5 + static_cast<double>(column));
            const double y = area.bottom() + width * (0.5 + static_cast<double>(row));
            const double off = 0.5 * grid.jitter * length;
            return Spot{x + random.uniform(-off, off),
                        y + 0.5 * grid.jitter * width * random.uniform(-1.0, 1.0)};
          },
          [&](const OnLine& line) -> std::optional<Spot> {
            if (line.even && attempt > 0) {
              return std::nullopt;
            }
            const double even =
                count_ < 2 ? 0.5 : static_cast<double>(thing) / static_cast<double>(count_ - 1);
            const double t = line.even ? even : random.uniform();
            return Spot{line.x1 + t * (line.x2 - line.x1), line.y1 + t * (line.y2 - line.y1)};
          }},
      region_);
  if (is_last && !most()) {
    return std::nullopt;
  }
  return spot ? std::optional(Spot{rounded_m(spot->x), rounded_m(spot->y)}) : std::nullopt;
}

void Places::take() {
  if (most()) cells_.pop_back();
}

std::optional<double> Places::heading_deg(const Spot& spot, Random& random) const {
  if (!scatter_.heading) {
    return std::nullopt;
  }
  const HeadingRule& rule = *scatter_.heading;
  const auto towards = [](double x, double y) { return degrees(std::atan2(y, x)); };
  double angle = rule.deg;
  if (rule.rule == "uniform") {
    angle = random.uniform(rule.from_deg, rule.to_deg);
  } else if (rule.rule == "gaussian") {
    angle = random.normal(rule.deg, rule.sd_deg);
  } else if (rule.rule == "along") {
    const auto& line = std::get<OnLine>(region_);
    angle += towards(line.x2 - line.x1, line.y2 - line.y1);
  } else if (rule.rule == "towards") {
    angle += towards(rule.x - spot.x, rule.y - spot.y);
  } else if (rule.rule == "away") {
    angle += towards(spot.x - rule.x, spot.y - rule.y);
  }
  return rounded_deg(angle);
}

}  // namespace elsie::layouts
