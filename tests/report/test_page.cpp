// The page as text; tests/report/browser/ opens it in a browser.
#include <cctype>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

#include <catch2/catch.hpp>

#include "elsie/base/random.h"
#include "elsie/picture/bodies.h"
#include "elsie/world/markup.h"

#include "hostile.h"

using namespace elsie::report;
using Catch::Contains;
using namespace elsie::test;

namespace {

// Reads a page as strictly as XML: every element is closed in order, every attribute quoted, no
// bare "<" in texts. Returns the error, or "". Counts the elements by name.
std::string badly_nested(const std::string& html, std::map<std::string, int>& elements) {
  static const std::set<std::string> kVoid{"meta", "link", "!doctype"};
  std::vector<std::string> open;
  std::size_t at = 0;
  const auto around = [&] { return html.substr(at > 40 ? at - 40 : 0, 120); };
  while ((at = html.find_first_of("<>", at)) != std::string::npos) {
    if (html[at] == '>') return "a bare > near: " + around();
    const std::size_t start = ++at;
    if (html[at] == '/') {
      const std::size_t end = html.find('>', at);
      const std::string name = html.substr(at + 1, end - at - 1);
      if (open.empty() || open.back() != name) return "</" + name + "> near: " + around();
      open.pop_back();
      at = end + 1;
      continue;
    }
    while (at < html.size() &&
           (std::isalnum(static_cast<unsigned char>(html[at])) || html[at] == '!')) {
      ++at;
    }
    const std::string name = html.substr(start, at - start);
    if (name.empty()) return "a bare < near: " + around();
    bool closed = false;
    while (html.at(at) != '>') {
      if (html[at] == '/' && html.at(at + 1) == '>') {
        closed = true;
        ++at;
      } else if (html[at] == '"') {
        at = html.find('"', at + 1);
        if (at == std::string::npos) return "an attribute without an end in <" + name;
        ++at;
      } else if (html[at] == '<') {
        return "a < in the tag <" + name;
      } else {
        ++at;
      }
    }
    ++at;
    ++elements[name];
    if (closed || kVoid.contains(name)) continue;
    if (name == "style" || name == "script") {
      at = html.find("</" + name + ">", at) + name.size() + 3;
      continue;
    }
    open.push_back(name);
  }
  return open.empty() ? "" : "<" + open.back() + "> is not closed";
}

MadeExperiment with_ways(std::size_t cells, std::size_t runs, std::size_t poses) {
  MadeExperiment made_up;
  made_up.factors = {"world", "number"};
  elsie::Random random(1, "ways");
  for (std::size_t i = 0; i < cells; ++i) {
    auto& cell = made_up.cells.emplace_back();
    cell.label = "cell number " + std::to_string(i);
    cell.levels = {"w", std::to_string(i)};
    cell.world_text = elsie::test::made_world();
    for (std::size_t j = 0; j < runs; ++j) {
      auto& run = cell.runs.emplace_back();
      run.seed = j + 1;
      for (const char* name : {"success", "path_length_m", "time_s", "collisions"}) {
        run.measures[name] = random.normal(10.0, 2.0);
      }
      auto& robot = run.robots.emplace_back();
      elsie::Pose pose;
      for (std::size_t k = 0; k < poses; ++k) {
        robot.poses.push_back(pose);
        pose.x = std::clamp(pose.x + random.normal(0.0, 0.2), -5.0, 5.0);
        pose.y = std::clamp(pose.y + random.normal(0.0, 0.2), -5.0, 5.0);
      }
      for (int k = 0; k < 60; ++k) {
        robot.episodes.push_back({1.0 * k, 1.0 * k + 1.0, k % 2 ? "avoid" : "find"});
      }
      robot.shares = {{"avoid", 0.5}, {"find", 0.5}};
    }
  }
  return made_up;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++found;
  return found;
}

// The first map of a page.
std::string map_in(const std::string& html) {
  const std::size_t begin = html.find("class=\"map ");
  REQUIRE(begin != std::string::npos);
  return html.substr(begin, html.find("</svg>", begin) - begin);
}

}  // namespace

TEST_CASE("The page of a study has all its parts") {
  elsie::experiment::Expectation expectation =
      expectation_of("fusion completes every case", "success", Statistic::rate);
  expectation.where = {{"coordinator", {"arbitration"}}};
  expectation.at_least = 1.0;
  const Made made(elsie::test::made_study(), expecting(expectation));
  const std::string html = made.html();
  std::map<std::string, int> elements;
  CHECK(badly_nested(html, elements) == "");
  CHECK(elements["article"] == 8);
  CHECK_THAT(html, Contains("<h1>Coordination by neural networks</h1>"));
  CHECK(count(html, "<figure class=\"map ") == 8);
  CHECK(count(html, "aria-label=\"Who decided when: ") == 8);
  CHECK(count(html, "aria-label=\"Learning of ") == 8);
  CHECK(count(html, "aria-label=\"Box plots of ") == 5);
  CHECK_THAT(html, Contains("1 of 1 expectation is not met"));
  // Every run without success has its command, and so has every outlier.
  const Findings findings = made.findings();
  for (const Run& run : findings.results.runs) {
    if (run.success()) continue;
    CHECK_THAT(html, Contains("elsie replay results.db " + std::to_string(run.id) + "</code>"));
  }
  for (const CellFindings& cell : findings.cells) {
    for (const Outlier& outlier : cell.outliers) {
      CHECK_THAT(html, Contains("elsie replay results.db " +
                                std::to_string(findings.results.runs[outlier.run].id) + "</code>"));
    }
  }
}

TEST_CASE("The same results give the same page, table and test cases, byte for byte") {
  const Made made(elsie::test::made_study()), again(elsie::test::made_study());
  CHECK(made.html() == again.html());
  CHECK(csv_report(made.findings()) == csv_report(again.findings()));
  CHECK(junit_report(made.findings(), "r.db") == junit_report(again.findings(), "r.db"));
}

TEST_CASE("A value that is the same in every run is stated, not drawn") {
  MadeExperiment made_up = made_from({{1, 2, 3}, {4, 5, 6}});
  for (auto& cell : made_up.cells) {
    for (auto& run : cell.runs) run.measures["time_s"] = 30.0;
  }
  const std::string html = Made(made_up).html();
  CHECK(count(html, "aria-label=\"Box plots of ") == 1);
  CHECK_THAT(html, Contains("The same in every run: time 30 s."));
  made_up.cells[1].runs[2].measures["time_s"] = 30.0 + 1e-6;
  const std::string rounded = Made(made_up).html();
  CHECK(count(rounded, "aria-label=\"Box plots of ") == 1);
  CHECK_THAT(rounded, Contains("The same in every run, or in none: success, time."));
  made_up.cells[1].runs[2].measures["time_s"] = 31.0;
  CHECK(count(Made(made_up).html(), "aria-label=\"Box plots of ") == 2);
}

TEST_CASE("A measure without a value in any run has no box plot, and the page says so") {
  MadeExperiment made_up = made_from({{1, 2, 3}, {4, 5, 6}});
  for (auto& cell : made_up.cells) {
    for (auto& run : cell.runs) run.measures["gap_m"] = std::nullopt;
  }
  const std::string html = Made(made_up).html();
  CHECK(count(html, "aria-label=\"Box plots of ") == 1);
  CHECK_THAT(html, Contains("No run has a value: gap m."));
  made_up.cells[1].runs[2].measures["gap_m"] = 0.5;
  CHECK(count(Made(made_up).html(), "aria-label=\"Box plots of ") == 2);
}

TEST_CASE("Of many notable runs, some are shown and the others folded") {
  const auto page_with = [](std::size_t missed) {
    MadeExperiment made_up = made_from({std::vector<double>(20, 5.0)});
    for (std::size_t i = 0; i < missed; ++i) made_up.cells[0].runs[i].outcome = "failure";
    const std::string html = Made(made_up).html();
    std::map<std::string, int> elements;
    CHECK(badly_nested(html, elements) == "");
    CHECK(count(html.substr(html.find("<section id=\"cells\">")), "elsie replay results.db ") ==
          missed);
    return html;
  };
  CHECK_THAT(page_with(9), !Contains(" more</summary>"));
  CHECK_THAT(page_with(10), Contains("<summary>2 more</summary>"));
  CHECK_THAT(page_with(20), Contains("<summary>12 more</summary>"));
}

TEST_CASE("The page refers to nothing outside of itself") {
  for (const auto& experiment : {elsie::test::made_study(), hostile()}) {
    const std::string html = Made(experiment).html();
    CHECK_THAT(html, !Contains("http:"));
    CHECK_THAT(html, !Contains("https:"));
    CHECK_THAT(html, !Contains(" src="));
    CHECK_THAT(html, !Contains("@import"));
    CHECK_THAT(html, !Contains("url("));
    for (std::size_t at = 0; (at = html.find("href=\"", at)) != std::string::npos; ++at) {
      const char first = html.at(at + 6);
      CHECK((first == '#' || html.substr(at + 6, 6) == "data:,"));
    }
    CHECK_THAT(html, Contains("default-src 'none'"));
  }
}

TEST_CASE("Names are only text, whatever they contain") {
  const Made made(hostile(), expecting(hostile_expectation()));
  const std::string html = made.html(elsie::test::kHostile);
  std::map<std::string, int> elements;
  CHECK(badly_nested(html, elements) == "");
  CHECK(elements["script"] ==
        1 + static_cast<int>(count(html, "<script type=\"application/json\" id=\"run-")));
  CHECK_THAT(html, !Contains("<script>alert"));
  CHECK_THAT(html, Contains("&lt;script&gt;alert(1)&lt;/script&gt;"));
  CHECK_THAT(html, Contains("\xf0\x9f\x90\xa2"));  // a turtle stays
  CHECK_THAT(html, !Contains("\xff"));             // bytes that are not UTF-8 go
  CHECK_THAT(html, !Contains(std::string(1, '\x01')));
}

TEST_CASE("Worlds are drawn without their plugins") {
  const std::string html = Made(made_from({{1, 2}})).html();
  const std::string map = map_in(html);
  CHECK(count(map, "<g><title>run ") == 2);
  CHECK(count(map, "fill=\"#2e9e4f\"") == 4);  // resources
  CHECK(count(map, "fill=\"#f7dede\"") == 1);  // the robot
  CHECK_THAT(html, Contains("10 m \xc3\x97 10 m"));
}

TEST_CASE("Every world that is shipped can be looked at without a plugin") {
  int count = 0;
  for (const char* folder : {"worlds", "experiments/worlds"}) {
    for (const auto& entry : std::filesystem::directory_iterator(source_path(folder))) {
      if (entry.path().extension() != ".xml") continue;
      CAPTURE(entry.path().string());
      const std::string file = entry.path().string();
      const std::string text = elsie::world::read_text(file);
      if (text.find("<layouts") != std::string::npos) continue;  // a record has what it drew
      CHECK_NOTHROW(elsie::picture::bodies_of(text, file, {}));
      ++count;
    }
  }
  CHECK(count > 10);
}

TEST_CASE("A world that cannot be read does not hide the rest") {
  MadeExperiment made_up = made_from({{1, 2}});
  made_up.cells[0].world_text = "<world format=\"1\"><arena length=\"much\"/></world>";
  const std::string html = Made(made_up).html();
  CHECK_THAT(html, Contains("cannot be drawn"));
  CHECK_THAT(html, Contains("Comparison"));
}

TEST_CASE("Several robots: a row for each in a typical run") {
  MadeExperiment made_up = made_from({{1, 2, 3}});
  made_up.cells[0].world_text = elsie::test::made_world(3);
  for (auto& run : made_up.cells[0].runs) {
    run.robots.clear();
    for (const char* id : {"r1", "r2", "r3"}) {
      auto& robot = run.robots.emplace_back();
      robot.id = id;
      robot.poses = {{0, 0, 0}, {1, 1, 0}};
      robot.episodes = {{0, 5, "follow"}, {5, 10, ""}};
      robot.shares = {{"follow", 0.5}};
    }
  }
  const std::string html = Made(made_up).html();
  CHECK_THAT(html, Contains("run 2, seed 2, a typical one"));
  CHECK(count(map_in(html), "<g><title>run ") == 9);
  for (const char* id : {"r1", "r2", "r3"}) {
    CHECK_THAT(map_in(html), Contains(std::string(">") + id + "</text>"));
  }
}

TEST_CASE("The page is green when all is well, not only what was expected") {
  elsie::experiment::Expectation expectation = expectation_of("short enough", "path_length_m");
  expectation.at_most = 10.0;
  MadeExperiment made_up = made_from({{1, 2, 3}, {4, 5, 6}});
  auto& runs = made_up.cells[0].runs;
  const auto answer = [&](bool expected) {
    auto questions = expecting(expectation);
    if (!expected) questions.expectations.clear();
    const std::string html = Made(made_up, questions).html();
    const std::size_t start = html.find("<h2 class=\"verdict ") + 19;
    const std::string head = html.substr(start, html.find("</h2>", start) - start);
    const std::string color = head.substr(0, head.find('"'));
    CHECK_THAT(head, Contains(color == "good"   ? "icon yes"
                              : color == "open" ? "icon open"
                                                : "icon no"));
    const std::size_t words = head.find("<span>") + 6;
    return color + ": " + head.substr(words, head.find("</span>") - words);
  };
  CHECK(answer(true) == "good: The expectation is met");
  CHECK(answer(false) == "good: Every run ended normally");
  SECTION("a run crashed") {
    runs[0].end_as("crash");
    CHECK(answer(true) == "bad: The expectation is met, but 1 run ended abnormally");
    CHECK(answer(false) == "bad: Not all runs ended normally");
  }
  SECTION("runs crashed, and one is still to be done in a cell that nothing is expected of") {
    runs[0].end_as("crash");
    runs[1].end_as("crash");
    made_up.cells[1].runs[2].end_as("pending");
    expectation.where = {{"scheme", {"a"}}};
    CHECK(answer(true) ==
          "bad: The expectation is met, but 2 runs ended abnormally and 1 is still "
          "to be done");
    CHECK(answer(false) == "bad: Not all runs are done");
  }
  SECTION("equal seeds gave different runs") {
    runs.push_back(runs[0]);
    runs.back().repetition = 2;
    runs.back().state_hash = "fedcba9876543210";
    CHECK(answer(true) == "bad: The expectation is met, but equal seeds gave different runs");
    CHECK(answer(false) == "bad: Equal seeds gave different runs");
  }
  SECTION("some of the runs are in other databases") {
    made_up.all_runs = 9;
    CHECK(answer(true) == "open: 1 of 1 expectation is not known yet");
    CHECK(answer(false) == "open: Not all runs are in this database");
  }
  SECTION("something expected did not come true") {
    expectation.at_most = 1.0;
    CHECK(answer(true) == "bad: 1 of 1 expectation is not met");
  }
}

TEST_CASE("A ring is round what the list of outliers has, be it a run without success") {
  const auto page = [](const std::vector<double>& values, std::size_t failed) {
    MadeExperiment made_up = made_from({values, {1, 2, 3, 4, 5, 6}});
    if (failed < values.size()) made_up.cells[0].runs[failed].outcome = "failure";
    return Made(made_up).html();
  };
  const auto rings = [](const std::string& html) {
    const std::size_t all = count(html, ", outlier</title>");
    const std::size_t missed = count(html, ", failure, outlier</title>");
    return std::to_string(all - missed) + " and " + std::to_string(missed);
  };
  CHECK(rings(page({0.3, 0.1 + 0.2, 0.3, 0.3, 0.3, 0.3}, 9)) == "0 and 0");
  CHECK(rings(page({3, 3, 3, 3, 3, 4}, 9)) == "1 and 0");
  CHECK(rings(page({3, 3, 3, 3, 3, 4}, 5)) == "0 and 1");
}

TEST_CASE("Hundreds of cells: the page stays within a few megabytes, and cells are folded") {
  const std::string html = Made(with_ways(300, 10, 400)).html();
  CHECK(html.size() < 6'000'000);
  CHECK(count(html, "<article class=\"cell\"") == 100);
  CHECK(count(html, "<details><summary><h3>") == 100);
}

TEST_CASE("Many runs in a cell: some are drawn, and the page says how many") {
  const std::string html = Made(with_ways(1, 200, 100)).html();
  CHECK_THAT(html, Contains("60 of 200 runs are drawn."));
  CHECK(html.size() < 1'000'000);
}

TEST_CASE("A page of two thousand cells stays below four megabytes", "[release]") {
  MadeExperiment made_up;
  made_up.factors = {"world", "gain"};
  elsie::Random random(3, "large");
  for (int i = 0; i < 2000; ++i) {
    auto& cell = made_up.cells.emplace_back();
    cell.label = "gain " + std::to_string(i) + "/2000";
    cell.levels = {"w", std::to_string(i)};
    cell.world_text = elsie::test::made_world();
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      auto& run = cell.runs.emplace_back();
      run.seed = seed;
      for (const char* measure :
           {"path_length_m", "time_s", "collected", "collisions", "energy_left"}) {
        run.measures[measure] = random.uniform(1.0, 100.0);
      }
      if (i == 1234) run.outcome = "failure";
      auto& robot = run.robots.emplace_back();
      for (int k = 0; k < 60; ++k) {
        robot.poses.push_back({random.uniform(-4.0, 4.0), random.uniform(-4.0, 4.0), 0.0});
        robot.episodes.push_back({double(k), k + 1.0, k % 2 ? "avoid" : "find"});
      }
    }
  }
  const Made made(made_up);
  const std::string html = made.html();
  CHECK(html.size() < 4'000'000);
  CHECK_THAT(html, Contains("100 of 2000 cells are drawn here."));
  CHECK_THAT(html, Contains("Box plots are left out: 2000 cells are too many for one page."));
  // The cell whose runs failed is among them; all have their row in the table.
  CHECK_THAT(html, Contains("<article class=\"cell\" id=\"cell-1235\""));
  std::size_t rows = 0;
  for (std::size_t at = 0; (at = html.find("<tr data-cell=", at)) != std::string::npos; ++at)
    ++rows;
  CHECK(rows == 2000);
  // All links have targets.
  CHECK_THAT(html, !Contains("href=\"#cell-1234\"") || Contains("id=\"cell-1234\""));
  const ResultsFile file(made.path);
  const std::string chosen = html_report(made.findings(), file, "r.db", "gain 77/");
  CHECK_THAT(chosen, Contains("1 of 2000 cells is drawn here.") && Contains("id=\"cell-78\""));
}
