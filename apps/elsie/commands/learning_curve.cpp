#include "learning_curve.h"

#include <cmath>

#include "elsie/picture/plot.h"

namespace elsie::program {

void draw_learning_curve(const neural::Training& training, const std::string& title,
                         const std::vector<std::string>& subtitles,
                         const std::filesystem::path& file) {
  namespace picture = elsie::picture;
  picture::Series plain, powers;
  for (const neural::CurvePoint& point : training.curve) {
    const auto x = static_cast<double>(point.presentations);
    plain.points.push_back({x, point.error});
    powers.points.push_back({x, std::log10(point.error)});
  }
  const picture::Axis presentations{"presentations", "", 0.0,
                                    static_cast<double>(training.presentations)};
  picture::LineChart above, below;
  above.x = presentations;
  above.y = {"mean error of an epoch", "", 0.0, {}};
  above.series.push_back(std::move(plain));
  below.x = presentations;
  below.y.label = "log10 of the mean error";
  below.series.push_back(std::move(powers));
  picture::Page page;
  page.title = title;
  page.subtitles = subtitles;
  for (picture::LineChart* chart : {&above, &below}) {
    picture::Row row;
    row.panels.emplace_back(std::move(*chart));
    row.aspect = 0.32;
    page.rows.push_back(std::move(row));
  }
  picture::save_page(page, file);
}

}  // namespace elsie::program
