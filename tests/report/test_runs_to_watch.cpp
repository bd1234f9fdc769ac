// Runs that the page of a report plays: which they are, and what is said about others.
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "elsie/base/random.h"

#include "fixture.h"
#include "hostile.h"

using namespace elsie::test;
using Catch::Contains;

namespace {

std::size_t count_of(const std::string& html, const std::string& word) {
  std::size_t number = 0;
  for (std::size_t at = 0; (at = html.find(word, at)) != std::string::npos; ++at) ++number;
  return number;
}

const std::string kBlock = "<script type=\"application/json\" id=\"run-";

/// The numbers of the runs that a page plays, in its order.
std::vector<int> watched(const std::string& html) {
  std::vector<int> runs;
  for (std::size_t at = 0; (at = html.find(kBlock, at)) != std::string::npos;) {
    at += kBlock.size();
    runs.push_back(std::stoi(html.substr(at)));
  }
  return runs;
}

nlohmann::json block_of(const std::string& html, int run) {
  const std::string head = kBlock + std::to_string(run) + "\">";
  const std::size_t from = html.find(head);
  REQUIRE(from != std::string::npos);
  const std::size_t start = from + head.size();
  return nlohmann::json::parse(html.substr(start, html.find("</script>", start) - start));
}

/// The section about the runs.
std::string section(const std::string& html) {
  const std::size_t from = html.find("<section id=\"watch\">");
  return from == std::string::npos ? "" : html.substr(from, html.find("</section>", from) - from);
}

/// The same without the viewer and the runs' data.
std::string words(const std::string& html) {
  std::string text = section(html);
  for (const auto& [open, close] : {std::pair{"<iframe", "</iframe>"}, {"<script", "</script>"}}) {
    for (std::size_t at; (at = text.find(open)) != std::string::npos;) {
      text.erase(at, text.find(close, at) - at + std::string(close).size());
    }
  }
  return text;
}

void fail(MadeRun& run, const std::string& message = "It took too long.") {
  run.outcome = "failure";
  run.message = message;
  run.measures["success"] = 0.0;
}

}  // namespace

TEST_CASE("A report plays of each cell the run that is nearest to the median") {
  const std::string html = Made(made_from({{1, 2, 9, 3, 8}, {5, 4, 1, 2, 3}})).html();
  CHECK(watched(html) == std::vector<int>{4, 10});
  CHECK_THAT(words(html), Contains("Chosen are a typical run of each cell (of those with the "
                                   "commonest outcome, the one whose path length is nearest to the "
                                   "median). They are played from the stored trajectories"));
  CHECK_THAT(words(html), Contains("typical: path length 3 m"));
  CHECK(block_of(html, 4)["title"] == "a");
  CHECK(block_of(html, 4)["outcome"] == "success");
}

TEST_CASE(
    "A report plays runs without success, at most three of a cell, and says why they failed") {
  MadeExperiment made_up = made_from({{1, 2, 3, 4, 5, 6, 7, 8, 9}, {1, 2, 3}});
  for (const std::size_t i : {0, 2, 3, 5}) fail(made_up.cells[0].runs[i], "It ran into a wall.");
  made_up.cells[1].runs[2].end_as("fault");
  made_up.cells[1].runs[2].message = "behavior 'wander' answered with a NaN";
  const std::string html = Made(made_up).html();
  CHECK(watched(html) == std::vector<int>{7, 1, 3, 4, 10, 12});
  CHECK_THAT(words(html), Contains("and 4 of 5 runs without success, at most 3 of a cell") &&
                              Contains("It ran into a wall.") && Contains("answered with a NaN") &&
                              Contains("<em class=\"tag bad\">fault</em>"));
}

TEST_CASE("A typical run without success is there once") {
  MadeExperiment made_up = made_from({{1, 2, 3}});
  for (MadeRun& run : made_up.cells[0].runs) fail(run);
  const std::string html = Made(made_up).html();
  CHECK(watched(html) == std::vector<int>{2, 1, 3});
  CHECK_THAT(words(html), Contains("typical: path length 2 m; It took too long."));
}

TEST_CASE("Of many cells and failures a report plays twelve runs, at least half of them typical") {
  std::vector<std::vector<double>> lengths(20, {1, 2, 3, 4, 5});
  MadeExperiment made_up = made_from(lengths);
  for (std::size_t i = 0; i < 20; ++i) made_up.cells[i].label += std::to_string(i);
  SECTION("all succeed") {
    const std::string html = Made(made_up).html();
    CHECK(watched(html).size() == 12);
    CHECK_THAT(words(html), Contains("typical runs of 12 of 20 cells, picked evenly"));
  }
  SECTION("many fail") {
    for (MadeCell& cell : made_up.cells) fail(cell.runs[0]);
    const std::string html = Made(made_up).html();
    CHECK(watched(html).size() == 12);
    CHECK_THAT(words(html), Contains("typical runs of 6 of 20 cells, picked evenly") &&
                                Contains("and 6 of 20 runs without success"));
  }
}

TEST_CASE("A report has the viewer once, under a policy that allows nothing else") {
  const std::string html = Made(made_study()).html();
  CHECK(count_of(html, "<iframe") == 1);
  CHECK(count_of(html, "data-viewer=\"") == 1);
  CHECK(count_of(html, "</iframe>") == 1);
  const std::string head = "Content-Security-Policy\" content=\"";
  const std::size_t from = html.find(head) + head.size();
  const std::string policy = html.substr(from, html.find('"', from) - from);
  const std::string hash = "'sha256-[A-Za-z0-9+/]{43}='";
  CHECK_THAT(policy, Catch::Matches("default-src 'none'; style-src " + hash + " " + hash +
                                    "; script-src " + hash + " " + hash +
                                    "; img-src data:; base-uri 'none'; form-action 'none'"));
  CHECK(count_of(html, " style=\"") == 0);  // the policy would refuse it
}

TEST_CASE("A run without a trajectory is named, and not played") {
  MadeExperiment made_up = made_from({{1, 2, 3}, {1, 2, 3}});
  MadeRun& crash = made_up.cells[0].runs[0];
  crash.end_as("crash");
  crash.robots.clear();
  made_up.cells[1].runs[1].robots.clear();  // the typical one
  const std::string html = Made(made_up).html();
  CHECK(watched(html) == std::vector<int>{2});
  CHECK_THAT(words(html),
             Contains("2 runs cannot be played, because the database has no trajectory "
                      "of them (run 1 (a, seed 1): crash; run 5 (b, seed 2): success)"));
}

TEST_CASE("Without any trajectory a report has no viewer, and says why") {
  MadeExperiment made_up = made_from({{1, 2, 3}});
  for (MadeRun& run : made_up.cells[0].runs) run.robots.clear();
  const std::string html = Made(made_up).html();
  CHECK(count_of(html, "<iframe") == 0);
  CHECK_THAT(words(html), Contains("A run cannot be played, because the database has no trajectory "
                                   "of it (run 2 (a, seed 2): success)"));
}

TEST_CASE("A report of runs that are still to be done says nothing of playing them") {
  MadeExperiment made_up = made_from({{1, 2, 3}});
  for (MadeRun& run : made_up.cells[0].runs) run.end_as("pending");
  CHECK(section(Made(made_up).html()).empty());
}

TEST_CASE("What is damaged in a run is said in a sentence") {
  MadeExperiment made_up = made_from({{1, 2, 3}, {1, 2, 3}});
  MadeRobot& robot = made_up.cells[1].runs[1].robots[0];
  SECTION("its world") {
    made_up.cells[1].world_text =
        "<world format=\"1\"><robots><robot wheels=\"9\"/></robots></world>";
    const std::string html = Made(made_up).html();
    CHECK(watched(html) == std::vector<int>{2});
    CHECK_THAT(words(html),
               Contains("Run 5 (b, seed 2) cannot be played: its world cannot be read:"));
  }
  SECTION("its poses") {
    const double none = std::nan("");
    robot.poses = {{none, none, none}};
    const std::string html = Made(made_up).html();
    CHECK_THAT(words(html),
               Contains("Run 5 (b, seed 2) cannot be played: its stored trajectory has "
                        "no poses."));
  }
}

TEST_CASE("Hostile names do not leave the data of a run") {
  const std::string html = Made(hostile()).html(kHostile);
  for (const int run : watched(html)) {
    CHECK_NOTHROW(block_of(html, run));
    CHECK(block_of(html, run)["title"].get<std::string>().find('<') == std::string::npos);
  }
  CHECK_FALSE(watched(html).empty());
}

TEST_CASE("The same database gives the same page, with its runs") {
  const Made made(made_study());
  CHECK(made.html() == made.html());
}

TEST_CASE("A run of a huge swarm that does not fit is left out, and the page says so",
          "[release]") {
  constexpr std::size_t kRobots = 2000, kPoses = 66;
  MadeExperiment made_up = made_from(std::vector<std::vector<double>>(12, {1, 2, 3}));
  std::string world = "<world format=\"1\"><arena length=\"200\" width=\"200\"/><robots>";
  for (std::size_t i = 0; i < kRobots; ++i) {
    world += "<robot id=\"r" + std::to_string(i + 1) + "\" x=\"" +
             std::to_string(2.0 * static_cast<double>(i % 60) - 60.0) + "\" y=\"" +
             std::to_string(2.0 * static_cast<double>(i / 60) - 60.0) + "\"/>";
  }
  made_up.cells[0].world_text = world + "</robots></world>";
  elsie::Random random(1, "swarm");
  std::vector<MadeRobot>& swarm = made_up.cells[0].runs[1].robots;
  swarm.resize(kRobots);
  for (std::size_t i = 0; i < kRobots; ++i) {
    swarm[i].id = "r" + std::to_string(i + 1);
    for (std::size_t k = 0; k < kPoses; ++k) {
      swarm[i].poses.push_back(
          {random.uniform(-90.0, 90.0), random.uniform(-90.0, 90.0), random.uniform(-3.1, 3.1)});
    }
  }
  const std::string html = Made(made_up).html();
  CHECK(html.size() < 10'000'000);
  CHECK(watched(html).size() == 11);
  CHECK_THAT(words(html), Contains("Run 2 (a, seed 2) cannot be played: its 2000 robots take") &&
                              Contains("the page may have 10.0 MB in all"));
}
