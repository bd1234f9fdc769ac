#include "learning_curve.h"

#include "elsie/picture/plot.h"

namespace elsie::program {

void draw_learning_curve(const neural::Training& training, const std::string& title,
                         const std::vector<std::string>& subtitles,
                         const std::filesystem::path& file) {
  namespace picture = elsie::picture;
  picture::LineChart chart;
  chart.x = {"presentations", "", 0.0, static_cast<double>(training.presentations)};
  chart.y = {"mean error of an epoch", "", 0.0, {}};
  auto& points = chart.series.emplace_back().points;
  for (const neural::CurvePoint& point : training.curve) {
    points.push_back({static_cast<double>(point.presentations), point.error});
  }
  picture::Page page;
  page.title = title;
  page.subtitles = subtitles;
  for (const bool logarithmic : {false, true}) {
    if (logarithmic) chart.y = {chart.y.label, "", {}, {}, true};
    picture::Row& row = page.rows.emplace_back();
    row.panels.emplace_back(chart);
    row.aspect = 0.32;
  }
  picture::save_page(page, file);
}

}  // namespace elsie::program
