// What a model leaves unexplained: residuals of a measure, fitted against observed rates of
// success.
#include <variant>

#include "charts.h"
#include "numbers.h"

namespace elsie::report {

namespace {

// Marks with bars and no line between them.
picture::Series marks(const std::string& name) {
  picture::Series series;
  series.name = name;
  series.marked = series.bars = true;
  series.joining = picture::Joining::nothing;
  series.colour = picture::kNeutral;
  return series;
}

picture::Series line(const Vector2& from, const Vector2& to) {
  picture::Series series;
  series.name = "the model";
  series.colour = picture::kNeutral;
  series.points = {from, to};
  return series;
}

Chart residual_chart(const Findings& findings, const FactorModel& model, const LinearFit& fit) {
  std::vector<std::vector<double>> by_cell(findings.cells.size());
  std::vector<double> fitted(findings.cells.size(), kUnknown);
  for (std::size_t i = 0; i < model.cells.size(); ++i) {
    by_cell[model.cells[i]].push_back(fit.residuals[i]);
    fitted[model.cells[i]] = fit.fitted[i];
  }
  picture::Series cells = marks("median and quartiles of a cell");
  Interval range;
  for (std::size_t i = 0; i < by_cell.size(); ++i) {
    if (const auto all = summary(by_cell[i])) {
      cells.points.push_back({fitted[i], all->median});
      cells.spread.push_back({all->lower_quartile, all->upper_quartile});
      range.include(fitted[i]);
    }
  }
  Interval wide = range.widened();
  const double extra = 0.06 * wide.span();
  wide.include(wide.low - extra);
  wide.include(wide.high + extra);
  picture::LineChart chart;
  chart.x = chart.y = axis_of(model.response);
  chart.x.label = "fitted " + chart.x.label;
  chart.x.low = wide.low;
  chart.x.high = wide.high;
  chart.y.label = "residual";
  chart.series = {std::move(cells), line({wide.low, 0.0}, {wide.high, 0.0})};
  return {"residuals-" + file_part(model.response.name),
          "Residuals: " + model.formula +
              ", median and quartiles of each cell, which stand about "
              "0 if the model fits",
          std::move(chart)};
}

Chart fitted_rates_chart(const FactorModel& model) {
  const std::vector<RateGroup> groups = rate_groups(model);
  picture::Series observed = marks("observed, with Wilson's 95 % interval");
  for (const RateGroup& group : groups) {
    observed.points.push_back({group.fitted, group.observed.rate()});
    observed.spread.push_back(group.interval);
  }
  picture::LineChart chart;
  constexpr double kMargin = 0.03;  // so that marks at 0 and 1 keep off the frame
  chart.x = {.label = "fitted rate of success", .low = -kMargin, .high = 1.0 + kMargin};
  chart.y = {.label = "observed rate", .low = 0.0, .high = 1.0};
  chart.series = {std::move(observed), line({0.0, 0.0}, {1.0, 1.0})};
  return {"rates-" + file_part(model.response.name),
          "Fitted and observed rates: " + model.formula + ", " + counted(groups.size(), "group") +
              " of cells, nearly all of whose intervals reach the line if the model fits",
          std::move(chart)};
}

}  // namespace

Chart model_chart(const Findings& findings, const FactorModel& model) {
  const auto* const linear = std::get_if<LinearFit>(&model.fit);
  return linear ? residual_chart(findings, model, *linear) : fitted_rates_chart(model);
}

}  // namespace elsie::report
