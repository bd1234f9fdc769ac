#include "learning_curve.h"

#include <algorithm>

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

void draw_rewards(std::span<const double> rewards, std::size_t window, const std::string& title,
                  const std::vector<std::string>& subtitles, const std::filesystem::path& file) {
  namespace picture = elsie::picture;
  picture::LineChart chart;
  chart.x = {"episode", "", 1.0, static_cast<double>(std::max<std::size_t>(rewards.size(), 2))};
  chart.y = {"reward", "", {}, {}};
  chart.series.resize(2);
  chart.series[0].name = "of each episode";
  chart.series[1].name = "mean of " + std::to_string(window);
  double sum = 0.0;
  for (std::size_t i = 0; i < rewards.size(); ++i) {
    const auto episode = static_cast<double>(i + 1);
    sum += rewards[i] - (i >= window ? rewards[i - window] : 0.0);
    chart.series[0].points.push_back({episode, rewards[i]});
    if (i + 1 >= window) {
      chart.series[1].points.push_back({episode, sum / static_cast<double>(window)});
    }
  }
  picture::Page page;
  page.title = title;
  page.subtitles = subtitles;
  picture::Row& row = page.rows.emplace_back();
  row.panels.emplace_back(chart);
  row.aspect = 0.4;
  picture::save_page(page, file);
}

}  // namespace elsie::program
