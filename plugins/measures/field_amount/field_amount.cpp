// How much there is of a field of the world: in all, at its largest, and in a disc.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <elsie/api/measure.h>
#include <elsie/base/near_name.h>

namespace {

class FieldAmount final : public elsie::Measure {
 public:
  std::string field = "pheromone";
  double x = 0.0, y = 0.0, radius = 0.0;

  void equipped(const elsie::Observation& start) override {
    std::vector<std::string> there;
    for (const elsie::ObservedField& each : start.fields) {
      if (each.id == field) return;
      there.emplace_back(each.id);
    }
    throw std::invalid_argument(
        "it is about the field '" + field + "', which the world does not have" +
        (there.empty() ? "; add <fields> with a <field id=\"" + field + "\"/>"
                       : elsie::base::near_or_all(field, there, "it has")));
  }
  std::vector<elsie::Quantity> quantities() const override {
    std::vector<elsie::Quantity> all{
        {"total", "units", "how much there is in all, at the end"},
        {"total_mean", "units", "the same, mean over time"},
        {"largest", "units/m2", "the largest value of a cell at any time"}};
    if (radius > 0.0) {
      all.push_back({"disc", "units/m2", "mean value in the disc, at the end"});
      all.push_back({"disc_mean", "units/m2", "the same, mean over time"});
    }
    return all;
  }
  void reset(elsie::Random&) override {
    total_ = disc_ = {};
    largest_ = 0.0;
  }
  void observe(const elsie::Observation& now) override {
    if (now.is_start || now.decided) look(now);  // it changes once in a control period
    if (now.is_start) return;
    total_.sum += total_.last;
    disc_.sum += disc_.last;
    total_.count += 1.0;
    disc_.count += 1.0;
  }
  void report(const elsie::RunEnd&, std::span<std::optional<double>> values) const override {
    if (!total_.is_known) return;
    values[0] = total_.last;
    values[1] = total_.mean();
    values[2] = largest_;
    if (radius > 0.0) {
      values[3] = disc_.last;
      values[4] = disc_.mean();
    }
  }

 private:
  struct Amount {
    bool is_known = false;
    double last = 0.0;
    double sum = 0.0, count = 0.0;  // over steps
    double mean() const { return count > 0.0 ? sum / count : last; }
  };

  void look(const elsie::Observation& now) {
    const auto found = std::find_if(now.fields.begin(), now.fields.end(),
                                    [&](const auto& each) { return each.id == field; });
    if (found == now.fields.end() || found->cells.empty()) return;
    const double length = now.arena_length_m / static_cast<double>(found->columns);
    const double width = now.arena_width_m / static_cast<double>(found->rows);
    double sum = 0.0, largest = 0.0;
    for (const double cell : found->cells) {
      sum += cell;
      largest = std::max(largest, cell);
    }
    total_.is_known = true;
    total_.last = sum * found->scale * length * width;
    largest_ = std::max(largest_, largest * found->scale);
    if (radius > 0.0) look_in_disc(now, *found, length, width);
  }

  /// Over the cells whose middles are in the disc; without any, over the nearest.
  void look_in_disc(const elsie::Observation& now, const elsie::ObservedField& seen, double length,
                    double width) {
    const auto middle = [](std::size_t i, double cell, double arena) {
      return (static_cast<double>(i) + 0.5) * cell - 0.5 * arena;
    };
    const auto nearest = [](double place, double cell, double arena, std::size_t count) {
      const double i = std::floor((place + 0.5 * arena) / cell);
      return static_cast<std::size_t>(std::clamp(i, 0.0, static_cast<double>(count - 1)));
    };
    const std::size_t first = nearest(y - radius, width, now.arena_width_m, seen.rows);
    const std::size_t last = nearest(y + radius, width, now.arena_width_m, seen.rows);
    const std::size_t west = nearest(x - radius, length, now.arena_length_m, seen.columns);
    const std::size_t east = nearest(x + radius, length, now.arena_length_m, seen.columns);
    double sum = 0.0, count = 0.0;
    for (std::size_t row = first; row <= last; ++row) {
      for (std::size_t column = west; column <= east; ++column) {
        const double dx = middle(column, length, now.arena_length_m) - x;
        const double dy = middle(row, width, now.arena_width_m) - y;
        if (std::hypot(dx, dy) > radius) continue;
        sum += seen.cells[row * seen.columns + column];
        count += 1.0;
      }
    }
    if (count == 0.0) {
      const std::size_t row = nearest(y, width, now.arena_width_m, seen.rows);
      sum = seen.cells[row * seen.columns + nearest(x, length, now.arena_length_m, seen.columns)];
      count = 1.0;
    }
    disc_.last = sum / count * seen.scale;
  }

  Amount total_, disc_;
  double largest_ = 0.0;
};

}  // namespace

ELSIE_MEASURE(FieldAmount, "field_amount",
              "How much there is of a field: in all, at its largest, and in a disc",
              elsie::parameter("field", &FieldAmount::field, {.meaning = "its id"}),
              elsie::parameter("x", &FieldAmount::x,
                               {.unit = "m", .meaning = "the middle of the disc, east"}),
              elsie::parameter("y", &FieldAmount::y,
                               {.unit = "m", .meaning = "the middle of the disc, north"}),
              elsie::parameter(
                  "radius", &FieldAmount::radius,
                  {.unit = "m", .min = 0, .max = 1e4, .meaning = "of the disc; 0: without one"}));
