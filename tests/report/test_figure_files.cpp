// Figures and tables as files.
#include <algorithm>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include <catch2/catch.hpp>

#include "elsie/report/figure_files.h"

#include "by_factor.h"
#include "fixture.h"
#include "hostile.h"

using namespace elsie::report;
using Catch::Contains;
using namespace elsie::test;

namespace fs = std::filesystem;

namespace {

std::string bytes(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

std::size_t draw(const Made& made, const fs::path& folder,
                 const std::vector<std::string>& formats) {
  const ResultsFile file(made.path);
  return write_figures(made.findings(), file, {}, folder, formats);
}

// Where the bars of a chart stand, from its left edge, 0, to the right one, 1.
std::vector<double> bars_in(const std::string& svg) {
  std::smatch box;
  REQUIRE(std::regex_search(svg, box, std::regex("viewBox=\"0 0 ([0-9.]+) ")));
  const std::regex bar(
      "<path d=\"M ?([0-9.]+)[^\"]*\" stroke=\"[^\"]*\" stroke-opacity=\"0.6\" "
      "stroke-width=\"1.4\"/>");
  std::vector<double> places;
  for (auto found = std::sregex_iterator(svg.begin(), svg.end(), bar);
       found != std::sregex_iterator(); ++found) {
    places.push_back(std::stod((*found)[1]) / std::stod(box[1]));
  }
  std::sort(places.begin(), places.end());
  return places;
}

}  // namespace

TEST_CASE("Charts of times have every level in their frame, even if no median is known") {
  using Labels = std::vector<std::string>;
  const Labels moods =
      GENERATE(Labels{"calm", "restless", "nervous", "mad"}, Labels{"1", "2", "3", "4"});
  MadeExperiment study;
  study.factors = {"world", "mood", "kind"};
  for (const std::string& mood : moods) {
    for (const std::string kind : {"a", "b"}) {
      elsie::test::MadeCell& cell = study.cells.emplace_back();
      cell.label = mood + ", " + kind;
      cell.levels = {"w", mood, kind};
      cell.world_text = elsie::test::made_world();
      for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        elsie::test::MadeRun& run = cell.runs.emplace_back();
        run.seed = seed;
        run.outcome = seed <= 2 ? "success" : "time_limit";
        run.measures = {{"time_s", seed <= 2 ? 10.0 + static_cast<double>(seed) : 40.0}};
      }
    }
  }
  const Folder folder;
  draw(Made(study), folder.path(), {"svg"});
  const std::pair<const char*, std::size_t> charts[] = {{"effect-time_s-mood", 4},
                                                        {"interaction-time_s-mood-kind", 8}};
  for (const auto& [name, count] : charts) {
    CAPTURE(name, moods);
    const std::string svg = bytes(folder / (std::string(name) + ".svg"));
    const std::vector<double> bars = bars_in(svg);
    REQUIRE(bars.size() == count);
    CHECK(bars.front() > 0.1);
    CHECK(bars.back() < 1.0);
    // The four levels share the frame evenly.
    const std::size_t lines = count / 4;
    const double step = bars[lines] - bars[0];
    CHECK(step > 0.1);
    for (std::size_t i = lines; i < count; ++i) {
      CHECK(bars[i] - bars[i - lines] == Approx(step).margin(0.01));
    }
    for (const std::string& mood : moods) {
      // An axis of numbers has round ones: "1.0", "1.5".
      CHECK_THAT(svg, Contains(">" + mood + (moods[0] == "1" ? ".0" : "") + "</text>"));
    }
  }
}

TEST_CASE("Of two factors with many levels, the longer list of names has rows of its own") {
  MadeExperiment study;
  study.factors = {"world", "mood", "kind"};
  for (int mood = 0; mood < 8; ++mood) {
    for (int kind = 0; kind < 7; ++kind) {
      elsie::test::MadeCell& cell = study.cells.emplace_back();
      cell.levels = {"w", "mood" + std::to_string(mood), "kind" + std::to_string(kind)};
      cell.label = cell.levels[1] + ", " + cell.levels[2];
      cell.world_text = elsie::test::made_world();
      for (std::uint64_t seed = 1; seed <= 2; ++seed) {
        elsie::test::MadeRun& run = cell.runs.emplace_back();
        run.seed = seed;
        run.measures = {{"success", 1.0},
                        {"path_length_m", mood + 0.1 * static_cast<double>(seed)}};
      }
    }
  }
  const Folder folder;
  draw(Made(study), folder.path(), {"svg"});
  CHECK(names_in(folder.path()).contains("tiles-path_length_m-kind-mood.svg"));
}

TEST_CASE("Every figure is a file of each format, with its texts as texts") {
  const Made made(by_factor());
  const Folder folder;
  const std::size_t count = draw(made, folder.path(), kFigureFormats);
  const auto names = names_in(folder.path());
  CHECK(names.size() == 3 * count);
  for (const char* name :
       {"success", "boxes-path_length_m", "effect-success-speed", "effect-time_s-coordinator",
        "interaction-path_length_m-speed-coordinator", "tiles-success-speed-coordinator",
        "residuals-path_length_m", "rates-success", "survival-speed_0.4",
        "series-distance_driven-speed", "ways-1"}) {
    CAPTURE(name);
    CHECK(names.contains(std::string(name) + ".svg"));
    CHECK(names.contains(std::string(name) + ".pdf"));
    CHECK(names.contains(std::string(name) + ".png"));
  }
  CHECK_FALSE(names.contains("boxes-collisions.svg"));  // the same in every run
  for (const std::string& name : names) {
    CAPTURE(name);
    const std::string all = bytes(folder / name);
    if (name.ends_with(".svg")) CHECK(elsie::test::xmllint(all, "--nonet").empty());
    if (name.ends_with(".svg")) CHECK(all.find("</text>") != std::string::npos);
    if (name.ends_with(".pdf")) CHECK(all.starts_with("%PDF-"));
    if (name.ends_with(".png")) CHECK(all.starts_with("\x89PNG"));
  }
}

TEST_CASE("The same database gives the same figures, bit for bit") {
  const Made made(made_study());
  const Folder first, second;
  draw(made, first.path(), {"svg", "pdf"});
  draw(made, second.path(), {"svg", "pdf"});
  REQUIRE(names_in(first.path()) == names_in(second.path()));
  for (const std::string& name : names_in(first.path())) {
    CAPTURE(name);
    CHECK(bytes(first / name) == bytes(second / name));
  }
  CHECK(names_in(first.path()).contains("decisions-1.svg"));
  CHECK(fs::exists(first / "learning-1-collector-fusion_neural_network-error.svg"));
}

TEST_CASE("A figure that cannot be written leaves the folder as it was") {
  const Made made(by_factor());
  const Folder folder;
  std::ofstream(folder / "mine.txt") << "mine";
  fs::create_directory(folder / "success.svg");  // cannot be replaced by a file
  std::ofstream(folder / "success.svg" / "inside") << "x";
  CHECK_THROWS_AS(draw(made, folder.path(), {"svg"}), FigureInTheWay);
  CHECK(names_in(folder.path()) == std::set<std::string>{"mine.txt", "success.svg"});
}

TEST_CASE("The folder of figures is made with all of them, and not for none") {
  const Made made(by_factor());
  const Folder folder;
  const std::size_t count = draw(made, folder / "new", {"svg"});
  CHECK(names_in(folder / "new").size() == count);
  CHECK(names_in(folder.path()) == std::set<std::string>{"new"});
  draw(made, folder / "without formats", {});
  CHECK_FALSE(fs::exists(folder / "without formats"));
}

TEST_CASE("Labels of any bytes make figures and names of files that every system takes") {
  MadeExperiment study = by_factor(2);
  study.factors = {"world", "../speed/\xff<&>", "coordinator"};
  const Made made(study);
  const Folder folder;
  draw(made, folder.path(), {"svg"});
  for (const std::string& name : names_in(folder.path())) {
    CAPTURE(name);
    CHECK(name.find_first_not_of(
              "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-") ==
          std::string::npos);
    CHECK(elsie::test::xmllint(bytes(folder / name), "--nonet").empty());
  }
}

TEST_CASE("The table for LaTeX has a row for each cell, with rules of booktabs and escaped texts") {
  MadeExperiment study = by_factor();
  study.name = "100 % of $x_1$ & #2 {a} ~ ^ \\";
  const Made made(study);
  const std::string text = latex_report(made.findings());
  for (const char* part : {"\\toprule", "\\midrule", "\\bottomrule", "\\begin{tabular}{llrrrr}",
                           "speed & coordinator & success & path length (m) & time (s)",
                           "0.4 & arbitration & 3/6 & $2.35 \\pm 0.19$",
                           "100 \\% of \\$x\\_1\\$ \\& \\#2 \\{a\\} \\textasciitilde{} "
                           "\\textasciicircum{} \\textbackslash{}",
                           "$>$ 100"}) {
    CAPTURE(part, text);
    CHECK(text.find(part) != std::string::npos);
  }
  CHECK(std::count(text.begin(), text.end(), '{') - std::count(text.begin(), text.end(), '}') == 0);
}

TEST_CASE("A row for LaTeX may begin with a bracket or a star") {
  MadeExperiment study = by_factor();
  for (auto& cell : study.cells) cell.levels[1] = cell.levels[1] == "0.4" ? "[1, 2]" : "*";
  const std::string text = latex_report(Made(study).findings());
  CHECK_THAT(text, Contains("\n{[}1, 2] & arbitration") && Contains("\n{*} & fusion"));
  study.name = "a < b > c";
  CHECK_THAT(latex_report(Made(study).findings()), Contains("a \\textless{} b \\textgreater{} c"));
}

TEST_CASE("A figure says what it leaves out, and its title is not cut off") {
  MadeExperiment study = by_factor();
  study.cells[2].runs[0].end_as("pending");
  const Made made(study);
  const Folder folder;
  draw(made, folder.path(), {"svg"});
  const std::string note = "1 seed is left out, without a value in some of the cells";
  CHECK_THAT(bytes(folder / "effect-path_length_m-coordinator.svg"), Contains(note));
  CHECK_THAT(bytes(folder / "tiles-path_length_m-speed-coordinator.svg"), Contains(note));
  CHECK_THAT(bytes(folder / "survival-speed_0.4.svg"),
             Contains(">Runs that have not reached their goals yet</text>"));
  CHECK_THAT(bytes(folder / "effect-time_s-coordinator.svg"), Contains(">median time (s)</text>"));
}

TEST_CASE("A long table goes over several pages") {
  MadeExperiment study = by_factor(2);
  while (study.cells.size() < 40) {
    study.cells.push_back(study.cells[study.cells.size() % 6]);
    const std::string speed = std::to_string(study.cells.size());
    study.cells.back().label = speed;
    study.cells.back().levels[1] = speed;
  }
  CHECK_THAT(latex_report(Made(study).findings()),
             Contains("\\begin{longtable}") && Contains("\\usepackage{longtable}"));
}

TEST_CASE("The table of cells has what the page has of each, and nothing where nothing is known") {
  const Made made(by_factor());
  std::istringstream lines(cells_csv(made.findings()));
  std::string head, first, second;
  std::getline(lines, head);
  std::getline(lines, first);
  std::getline(lines, second);
  CHECK_THAT(head, Catch::StartsWith("cell,runs,successes,success_low,success_high,broken,pending,"
                                     "world,speed,coordinator,path_length_m:n,path_length_m:mean"));
  CHECK_THAT(first, Catch::StartsWith("\"0.4, arbitration\",6,3,"));
  CHECK_THAT(first, Contains(",6,,,,,,,,,,3,100"));  // time_s: three bounds at 100, no median
  CHECK_THAT(second, Catch::StartsWith("\"0.4, fusion\",6,6,"));
}
