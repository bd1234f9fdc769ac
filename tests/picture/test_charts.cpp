// Charts of what runs came to: bands, steps, numbers below the axis, tiles, rows.
#include <cstdio>
#include <cstdlib>
#include <limits>

#include <catch2/catch.hpp>

#include "elsie/picture/plot.h"

#include "support.h"

using namespace elsie;
using namespace elsie::picture;
using namespace elsie::picture::test;

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

LineChart survival() {
  LineChart chart;
  chart.title = "Not there yet";
  chart.x = {.label = "time", .unit = "s"};
  chart.y = {.label = "part of the runs", .low = 0.0, .high = 1.0};
  Series series{.name = "fusion", .points = {{0, 1}, {10, 0.5}, {20, 0.25}}};
  series.joining = Joining::steps;
  series.spread = {{1, 1}, {0.2, 0.8}, {0.1, 0.6}};
  series.strokes = {{15, 0.5}};
  chart.series = {series};
  chart.rows_title = "at risk";
  chart.rows = {{"fusion", {{0, "20"}, {10, "11"}, {20, "5"}}}};
  return chart;
}

Tiles two_by_two() {
  Tiles tiles;
  tiles.x = {.label = "speed", .names = {{0, "slow"}, {0, "fast"}}};
  tiles.y = {.label = "coordinator", .names = {{0, "fusion"}, {0, "arbitration"}}};
  tiles.values = {1.0, 2.0, 3.0, kUnknown};
  tiles.texts = {"1.0", "2.0", "3.0", "none"};
  return tiles;
}

RowChart boxes() {
  RowChart chart;
  chart.x = {.label = "path length", .unit = "m"};
  ChartRow row{.name = "fusion"};
  row.box = {{1, 9}, {3, 6}, 5};
  row.dots = {{1}, {3}, {5}, {6}, {.at = 9, .ringed = true, .title = "run <5>"}, {12, true, true}};
  row.mark = 5.2;
  row.interval = Interval{4, 7};
  chart.rows = {row, {.name = "arbitration", .bars = {{{0, 4}, 1}, {{4, 12}, 2}}}};
  chart.key = {{"find_resource", 1}, {"avoid_obstacle", 2}};
  return chart;
}

}  // namespace

TEST_CASE("Every kind of panel is the same picture as PNG, SVG and PDF, with texts as texts") {
  const Folder folder;
  Page page;
  page.rows = {{{survival(), two_by_two()}, {}, 0}, {{boxes()}, {}, 0}};
  for (const std::string name : {"a.svg", "a.png", "a.pdf"}) save_page(page, folder / name);
  for (const std::string text : {">fusion</text>", ">at risk</text>", ">11</text>", ">none</text>",
                                 ">find_resource</text>", ">path length (m)</text>"}) {
    CAPTURE(text);
    CHECK(bytes_of(folder / "a.svg").find(text) != std::string::npos);
  }
  CHECK(bytes_of(folder / "a.png").starts_with("\x89PNG"));
  CHECK(bytes_of(folder / "a.pdf").starts_with("%PDF-"));
  CHECK(bytes_of(folder / "a.pdf").find("/FontFile") != std::string::npos);  // not outlines
  CHECK(std::system(("xmllint --noout --nonet '" + (folder / "a.svg").string() + "'").c_str()) ==
        0);
}

TEST_CASE("The same page gives the same bytes, also as a PDF") {
  const Folder folder;
  const Page page{"A page", {}, {{{survival()}, {}, 0}}};
  save_page(page, folder / "a.pdf");
  save_page(page, folder / "b.pdf");
  CHECK(bytes_of(folder / "a.pdf") == bytes_of(folder / "b.pdf"));
}

TEST_CASE("Steps go across before they go down, and a band follows them") {
  LineChart chart = survival();
  chart.series[0].spread.clear();
  const std::string steps = page_chart(chart, "", {400, 300});
  chart.series[0].joining = Joining::lines;
  const std::string lines = page_chart(chart, "", {400, 300});
  CHECK(steps != lines);
  CHECK(count(page_chart(survival(), "", {400, 300}), "fill-opacity=\"0.15\"") == 1);
  CHECK(count(steps, "fill-opacity=\"0.15\"") == 0);
}

TEST_CASE("A bar whose upper end is unknown reaches the edge of the plot and has an arrow") {
  LineChart chart;
  chart.y = {.low = 0.0, .high = 10.0};
  Series series{.name = "", .points = {{0, 4}, {1, 5}}, .joining = Joining::nothing};
  series.bars = true;
  series.spread = {{3, 5}, {4, 6}};
  chart.series = {series};
  const std::string known = page_chart(chart, "", {400, 300});
  chart.series[0].spread[1].high = std::numeric_limits<double>::infinity();
  const std::string unknown = page_chart(chart, "", {400, 300});
  chart.series[0].spread[1].high = kUnknown;
  const std::string none = page_chart(chart, "", {400, 300});
  // The bar, and the two strokes of the arrow, are lines that begin with a move.
  const auto moves = [](const std::string& text) { return count(text, "M"); };
  CHECK(moves(unknown) == moves(known) + 2);
  CHECK(moves(none) == moves(known) - 1);
}

TEST_CASE("Names stand in place of numbers on an axis, in two rows when one is too narrow") {
  LineChart chart;
  chart.x.names = {{0, "vector summation of all"}, {1, "action selection by strength"}};
  chart.series = {{.name = "", .points = {{0, 1}, {1, 2}}}};
  const std::string narrow = page_chart(chart, "", {300, 200});
  CHECK(narrow.find(">vector summation of all<") == std::string::npos);
  CHECK(narrow.find(">vector<") + narrow.find(">vector summation<") != 2 * std::string::npos);
  CHECK(page_chart(chart, "", {1000, 200}).find(">vector summation of all<") != std::string::npos);
  // Names of plugins have no blanks.
  chart.x.names = {{0, "arbiter_voting"}, {1, "fusion_interval"}};
  const std::string plugins = page_chart(chart, "", {200, 200});
  CHECK(count(plugins, ">arbiter_</text>") == 1);
  CHECK(count(plugins, ">voting</text>") == 1);
}

TEST_CASE("Names that begin alike end differently when they are shortened, with one ellipsis") {
  constexpr const char* kEllipsis = "\xE2\x80\xA6";
  const std::string alike = "feed_forward_network_of_sensors_and_motors_with_hidden_layer_";
  LineChart chart;
  chart.x.names = {{0, alike + "4"}, {1, alike + "9"}};
  chart.series = {{.name = "", .points = {{0, 1}, {1, 2}}}};
  const std::string line = page_chart(chart, "", {300, 200});
  CHECK(count(line, "_4</text>") == 1);
  CHECK(count(line, "_9</text>") == 1);
  CHECK(count(line, kEllipsis) == 2);
  // In two rows, what has no room is left out between them.
  chart.x.names = {{0, "vector summation of everything with a memory of 1 s"},
                   {1, "vector summation of everything with a memory of 9 s"}};
  const std::string rows = page_chart(chart, "", {300, 200});
  CHECK(count(rows, std::string(kEllipsis) + "</text>") == 2);
  CHECK(count(rows, " of 1 s</text>") == 1);
  CHECK(count(rows, " of 9 s</text>") == 1);
  CHECK(count(rows, kEllipsis) == 2);
  // Shortened before.
  Tiles tiles = two_by_two();
  tiles.y.names = {{0, "feed_forward_network" + std::string(kEllipsis) + "ith_hidden_layer_4"},
                   {0, "feed_forward_network" + std::string(kEllipsis) + "ith_hidden_layer_9"}};
  const std::string again = page_chart(tiles, "", {300, 0});
  CHECK(count(again, "_4</text>") == 1);
  CHECK(count(again, "_9</text>") == 1);
  CHECK(count(again, kEllipsis) == 2);
}

TEST_CASE("Curves differ by their dashes where they have no colours, and marks by their shapes") {
  LineChart chart;
  for (std::size_t i = 0; i < 4; ++i) {
    Series series{.name = std::to_string(i), .points = {{0, double(i)}, {1, double(i)}}};
    series.colour = kNeutral;
    chart.series.push_back(series);
  }
  const std::string text = page_chart(chart, "", {400, 200});
  CHECK(count(text, "stroke-dasharray=\"7 5\"") == 2);  // the curve, and its sample
  CHECK(count(text, "stroke-dasharray=\"1 4.5\"") == 2);
  CHECK(count(text, "stroke-dasharray=\"9 4 1 4\"") == 2);
}

TEST_CASE("Neutral curves are counted among themselves: the first is solid and as dark as text") {
  LineChart chart;
  chart.series = {{.name = "", .points = {{0, 1}, {1, 1}}, .colour = kNeutral}};
  const std::string alone = page_chart(chart, "", {400, 200});
  CHECK(count(alone, "stroke-dasharray") == 0);
  const std::size_t opaque = count(alone, "stroke-opacity");
  chart.naming = Naming::at_peak;  // without samples of the curves
  chart.series.insert(chart.series.begin(), 5, {.name = "", .points = {{0, 0}, {1, 0}}});
  const std::string behind = page_chart(chart, "", {400, 200});
  CHECK(count(behind, "stroke-dasharray") == 0);
  CHECK(count(behind, "stroke-opacity") == opaque);
}

TEST_CASE("On a screen, curves differ in their dashes as well as in their colours") {
  LineChart chart;
  chart.naming = Naming::at_peak;
  chart.series = {{.name = "", .points = {{0, 0}, {1, 0}}},
                  {.name = "", .points = {{0, 1}, {1, 1}}}};
  const auto pixels =
      screen_chart(chart, 400, 200, 1.0, {{"c0", {255, 0, 0}}, {"c1", {0, 0, 255}}});
  std::size_t red = 0, blue = 0;
  for (const std::uint32_t pixel : pixels) {
    const int more = static_cast<int>((pixel >> 16U) & 0xffU) - static_cast<int>(pixel & 0xffU);
    red += more > 60 ? 1 : 0;
    blue += more < -60 ? 1 : 0;
  }
  CHECK(blue > 100);
  CHECK(4 * red > 5 * blue);
}

TEST_CASE("Dots and bars say what they are, and a ring is an outline more") {
  RowChart chart = boxes();
  const std::string rings = page_chart(chart, "", {400, 0});
  CHECK(count(rings, "<title>run &lt;5&gt;</title>") == 1);
  CHECK(count(rings, "<title>find_resource</title>") == 1);
  CHECK(count(rings, "<circle") == 5);
  for (RowDot& dot : chart.rows[0].dots) dot.ringed = false;
  CHECK(count(page_chart(chart, "", {400, 0}), "<path") == count(rings, "<path") - 2);
}

TEST_CASE("All names of an axis stand in their chart, in order, when no value is known") {
  LineChart chart;
  chart.x.names = {{0, "calm"}, {1, "restless"}, {2, "nervous"}, {3, "mad"}};
  chart.y = {.label = "time", .unit = "s", .low = 0.0, .high = 120.0};
  Series series{.marked = true, .bars = true};
  for (int i = 0; i < 4; ++i) {
    series.points.push_back({1.0 * i, kUnknown});
    series.spread.push_back({100, std::numeric_limits<double>::infinity()});
  }
  chart.series = {series};
  const std::string text = page_chart(chart, "", {400, 200});
  double before = 40.0;  // left of it are the numbers of the other axis
  for (const auto& name : chart.x.names) {
    const std::size_t at = text.rfind("<text x=\"", text.find(">" + name.text + "<"));
    REQUIRE(at != std::string::npos);
    const double x = std::stod(text.substr(at + 9));
    CHECK(x > before + 40.0);
    before = x;
  }
  CHECK(before < 380.0);
}

TEST_CASE("Parts of a bar are above each other and leave no gap") {
  RowChart chart;
  chart.rows = {{.name = "x", .bars = {{{0, 4}, 1, {0.0, 0.3}}, {{0, 4}, 2, {0.3, 1.0}}}}};
  const std::string text = page_chart(chart, "", {400, 0});
  const auto edges = [&](const std::string& colour) {  // top and height of its only bar
    const std::size_t at = text.rfind("<path d=\"M", text.find("fill=\"var(--" + colour));
    double x = 0.0, top = 0.0, width = 0.0, height = 0.0;
    REQUIRE(std::sscanf(text.c_str() + at, "<path d=\"M%lf %lfl%lf 0 0 %lf", &x, &top, &width,
                        &height) == 4);
    return std::pair(top, height);
  };
  const auto [lower, low] = edges("c1");
  const auto [upper, high] = edges("c2");
  CHECK(upper + high == lower);
  CHECK(high > low);
}

TEST_CASE(
    "Names of rows are on the left, or above the rows if one is too long; notes on the right") {
  RowChart chart;
  chart.rows = {{.name = "fusion", .note = "19/20", .mark = 0.95}};
  const std::string left = page_chart(chart, "", {400, 0});
  CHECK(left.find("text-anchor=\"end\">fusion<") != std::string::npos);
  CHECK(left.find(">19/20<") != std::string::npos);
  chart.rows.push_back({.name = "a name that is as long as some names are", .mark = 0.5});
  const std::string above = page_chart(chart, "", {400, 0});
  CHECK(above.find("text-anchor=\"end\"") == std::string::npos);
  CHECK(above.find(">a name that is as long as some names are<") != std::string::npos);
}

TEST_CASE("In a page, colours are those of its style") {
  CHECK(page_chart(boxes(), "", {400, 0}).find("var(--c1)") != std::string::npos);
  CHECK(page_chart(survival(), "", {400, 0}).find("var(--c0)") != std::string::npos);
}

TEST_CASE("Charts with nothing in them, equal values or infinite ones are drawn") {
  const double infinite = std::numeric_limits<double>::infinity();
  RowChart rows;
  CHECK_NOTHROW(page_chart(rows, "", {400, 0}));
  rows.rows = {{.name = "x", .dots = {{2}, {2}, {2}}},
               {.name = "", .interval = Interval{1, infinite}}};
  CHECK_NOTHROW(page_chart(rows, "", {400, 0}));
  Tiles tiles = two_by_two();
  tiles.values = {kUnknown, kUnknown, kUnknown, kUnknown};
  CHECK_NOTHROW(page_chart(tiles, "", {400, 0}));
  tiles.values = {2, 2, 2, 2};
  CHECK_NOTHROW(page_chart(tiles, "", {400, 0}));
  LineChart chart = survival();
  chart.series[0].spread[1].high = infinite;
  CHECK_NOTHROW(page_chart(chart, "", {400, 0}));
}
