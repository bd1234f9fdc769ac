#include "elsie/report/figure_files.h"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <system_error>

#include "elsie/files/scratch_folder.h"
#include "elsie/picture/bodies.h"
#include "elsie/picture/top_view.h"
#include "elsie/plugin/host.h"
#include "elsie/world/error.h"

#include "charts.h"
#include "numbers.h"
#include "page.h"

namespace elsie::report {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kRowsOfChart = 40;  // cells or runs in one chart of rows

// Where figures are drawn before the folder gets them, or becomes it.
class Workshop {
 public:
  explicit Workshop(const fs::path& folder)
      : folder_(folder), inner_(fs::exists(folder) ? folder : parent_of(folder)) {}

  // The file to draw into. Equal names get numbers.
  fs::path file(const std::string& name, const std::string& suffix) {
    std::string free = name;
    for (int i = 2; !names_.insert(free + "." + suffix).second; ++i) {
      free = name + "-" + std::to_string(i);
    }
    return inner_.path() / (free + "." + suffix);
  }

  // All of the files, or none.
  void deliver() {
    for (const std::string& name : names_) {
      if (fs::is_directory(folder_ / name)) {
        throw FigureInTheWay("'" + (folder_ / name).string() +
                             "' is a folder, and a figure has this name; remove it, or name "
                             "another folder for the figures");
      }
    }
    if (!names_.empty() && !fs::exists(folder_)) {
      try {
        inner_.become(folder_);
        return;
      } catch (const fs::filesystem_error&) {
        if (!fs::is_directory(folder_)) throw;  // else another program has just made it
      }
    }
    for (const fs::directory_entry& entry : fs::directory_iterator(inner_.path())) {
      fs::rename(entry.path(), folder_ / entry.path().filename());
    }
  }

 private:
  static fs::path parent_of(const fs::path& folder) {
    return fs::absolute(folder / "").lexically_normal().parent_path().parent_path();
  }

  fs::path folder_;
  files::ScratchFolder inner_;
  std::set<std::string> names_;
};

class Artist {
 public:
  Artist(Workshop& workshop, const std::vector<std::string>& formats, std::string experiment)
      : workshop_(workshop), formats_(formats), experiment_(std::move(experiment)) {}

  std::size_t count() const { return count_; }

  void draw(const Chart& chart) {
    picture::Page page;
    const std::size_t colon = chart.caption.find(": ");
    page.title = chart.caption.substr(0, colon);
    page.title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(page.title[0])));
    page.subtitles = {experiment_};
    if (colon != std::string::npos) {
      page.subtitles.push_back(chart.caption.substr(colon + 2));
    }
    page.subtitles.insert(page.subtitles.end(), chart.notes.begin(), chart.notes.end());
    page.rows = {{{chart.panel}, {}, 0.0}};
    for (const std::string& format : formats_) {
      picture::save_page(page, workshop_.file(chart.name, format), {900, 0});
    }
    ++count_;
  }
  void draw(const std::vector<Chart>& charts) {
    for (const Chart& chart : charts) {
      draw(chart);
    }
  }
  void draw(const picture::TopView& view, const std::string& name) {
    for (const std::string& format : formats_) {
      picture::save_top_view(view, workshop_.file(name, format), {900, 0});
    }
    ++count_;
  }

 private:
  Workshop& workshop_;
  const std::vector<std::string>& formats_;
  std::string experiment_;
  std::size_t count_ = 0;
};

// The ways of all runs of a cell over its world.
void draw_map(const Findings& findings, std::size_t cell, const std::vector<Trajectory>& ways,
              Artist& artist) {
  const CellInfo& info = findings.results.cells[cell];
  world::World world;
  try {
    world = picture::bodies_of(info.world_text, info.world_file, plugin::Host());
  } catch (const world::WorldError&) {
    return;  // the page says why
  }
  std::set<std::int64_t> sample;
  for (const std::size_t place : findings.cells[cell].runs) {
    sample.insert(findings.results.runs[place].id);
  }
  picture::TopView view{world};
  view.title = info.label.empty() ? findings.results.experiment : info.label;
  view.subtitles = {"The ways of " + counted(sample.size(), "run")};
  for (const Trajectory& way : ways) {
    if (sample.contains(way.run) && !way.poses.empty()) {
      picture::RobotTrack track{way.robot, way.poses, way.poses.back(), {}, {}};
      track.from_s = way.from_s;
      view.robots.push_back(std::move(track));
    }
  }
  artist.draw(view, "ways-" + std::to_string(cell + 1));
}

}  // namespace

std::size_t write_figures(const Findings& findings, const ResultsFile& file, const Answers& answers,
                          const fs::path& folder, const std::vector<std::string>& formats,
                          const std::string& cells) {
  const std::vector<std::size_t> detailed = cells_in_detail(findings, cells);
  Inks inks = choose_inks(findings);
  add_behaviors(file, findings, detailed, inks);
  Workshop workshop(folder);
  Artist artist(workshop, formats, findings.results.experiment);
  const std::size_t count = findings.cells.size();
  if (count <= kMostRows) {
    for (std::size_t from = 0; from < count; from += kRowsOfChart) {
      const std::size_t to = std::min(count, from + kRowsOfChart);
      if (findings.any_goals()) {
        artist.draw(rate_chart(findings, inks, from, to));
      }
      for (const Response& response : responses(findings)) {
        if (response.measure && !is_constant(findings, response)) {
          artist.draw(box_chart(findings, *response.measure, inks, from, to));
        }
      }
    }
    if (any_cut_off(findings)) {
      artist.draw(survival_charts(findings, inks));
    }
    artist.draw(series_charts(findings, file, inks));
  }
  for (const Response& response : responses(findings)) {
    if (is_constant(findings, response)) {
      continue;
    }
    artist.draw(effect_charts(findings, response));
    artist.draw(pair_charts(findings, response, inks));
    if (varied_factors(findings.results).empty()) {
      continue;
    }
    try {
      artist.draw(model_chart(findings, factor_model(findings, main_effects(findings, response))));
    } catch (const std::invalid_argument&) {
      // The page says why there is no model.
    }
  }
  for (const FactorModel& model : answers.models) {
    artist.draw(model_chart(findings, model));
  }
  for (const std::size_t cell : detailed) {
    const std::int64_t id = findings.results.cells[cell].id;
    draw_map(findings, cell, file.trajectories(id), artist);
    artist.draw(decision_charts(findings, cell, file.timelines(id), inks, kRowsOfChart));
    artist.draw(learning_charts(findings, cell, file.curves(id)));
  }
  workshop.deliver();
  return artist.count();
}

}  // namespace elsie::report
