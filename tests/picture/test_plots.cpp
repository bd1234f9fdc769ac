#include <cmath>
#include <cstdlib>

#include <catch2/catch.hpp>

#include "elsie/picture/fuzzy_plot.h"

#include "support.h"

using namespace elsie;
using namespace elsie::picture;
using namespace elsie::picture::test;

namespace {

MembershipPanel range_panel() {
  return {"range",
          "m",
          0,
          3,
          {{"near", {{{0.3, 1}, {1, 0}}}},
           {"medium", FuzzySet::triangle(1, 0.7)},
           {"far", {{{1, 0}, {2, 1}}}}}};
}

ControlSurface plane() {
  return {{"range", "m", 0, 3},
          SurfaceVariable{"angle", "rad", -1.5, 1.5},
          {"rate", "rad/s", -10, 10},
          {{"battery", "units", 2500}},
          [](double x, double y) { return 10 * (x / 3 * 2 - 1) + 0 * y; }};
}

// Pixels of the picture that satisfy the predicate.
template <class Predicate>
int count(const Bitmap& image, int from_x, int to_x, Predicate predicate) {
  int found = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = from_x; x < to_x; ++x) {
      found += predicate(image.at({static_cast<double>(x), static_cast<double>(y)})) ? 1 : 0;
    }
  }
  return found;
}

bool is_yellow(const Pixel& p) { return p.red > 200 && p.green > 200 && p.blue < 110; }
bool is_violet(const Pixel& p) { return p.red > 50 && p.red < 80 && p.green < 50 && p.blue > 75; }

}  // namespace

TEST_CASE("Membership functions are drawn, one colour a term") {
  const Folder folder;
  save_fuzzy_picture({"Sensors", {}, {range_panel()}, {}}, folder / "a.png");
  const Bitmap image(folder / "a.png");
  CHECK(image.width() == 1000);
  CHECK(count(image, 0, 1000, [](const Pixel& p) { return p.blue > 150 && p.red < 30; }) > 500);
  CHECK(count(image, 0, 1000, [](const Pixel& p) { return p.red > 190 && p.blue < 30; }) > 500);
  CHECK(count(image, 0, 1000,
              [](const Pixel& p) { return p.green > 140 && p.red < 30 && p.blue < 140; }) > 500);
}

TEST_CASE("Sets of any kind can be drawn: empty, single points, steps, outside of the range") {
  const Folder folder;
  const MembershipPanel panel{"odd",
                              "",
                              -1,
                              1,
                              {{"empty", {}},
                               {"spike", {{{0, 0}, {0, 1}, {0, 0}}}},
                               {"one point", {{{0.5, 1}}}},
                               {"step", {{{-0.5, 0}, {-0.5, 1}, {0.2, 1}, {0.2, 0}}}},
                               {"outside", FuzzySet::triangle(50, 2)},
                               {std::string("\xff", 1), FuzzySet::triangle(0, 1)}}};
  for (const std::string file : {"a.png", "a.svg"}) {
    CHECK_NOTHROW(
        save_fuzzy_picture({"", {}, {panel, panel, panel, panel, panel}, {}}, folder / file));
  }
  CHECK_NOTHROW(save_fuzzy_picture({"nothing", {}, {}, {}}, folder / "none.png"));
  CHECK_NOTHROW(
      save_fuzzy_picture({"", {}, {{"no terms", "", 0, 1, {}}}, {}}, folder / "bare.png"));
}

TEST_CASE("A variable over an empty range is refused in a sentence") {
  const Folder folder;
  for (const auto& [low, high] : {std::pair{1.0, 1.0}, {2.0, 1.0}, {0.0, std::nan("")}}) {
    CHECK_THROWS_AS(
        save_fuzzy_picture({"", {}, {{"range", "m", low, high, {}}}, {}}, folder / "a.png"),
        std::invalid_argument);
  }
  CHECK_THROWS_WITH(
      save_fuzzy_picture({"", {}, {{"range", "m", 2, 1, {}}}, {}}, folder / "a.png"),
      "The variable 'range' cannot be drawn over a range from 2 to 1: both must be finite and the "
      "first below the second.");
  ControlSurface surface = plane();
  surface.value = nullptr;
  CHECK_THROWS_AS(save_fuzzy_picture({"", {}, {}, {surface}}, folder / "a.png"),
                  std::invalid_argument);
  CHECK(folder.files() == 0);
}

TEST_CASE("A control surface goes from dark violet at its lowest to yellow at its highest") {
  const Folder folder;
  save_fuzzy_picture({"", {}, {}, {plane()}}, folder / "a.png");
  const Bitmap image(folder / "a.png");
  const int middle = 240;  // of the heat map, the left one of two panels
  CHECK(count(image, 0, middle, is_violet) > 1000);
  CHECK(count(image, 0, middle, is_yellow) == 0);
  CHECK(count(image, middle, 405, is_yellow) > 1000);
  CHECK(count(image, middle, 405, is_violet) == 0);
}

TEST_CASE("The title says what is drawn over what, and where the other inputs are held") {
  const Page page = fuzzy_page({"model", {}, {range_panel()}, {plane()}});
  REQUIRE(page.rows.size() == 2);
  CHECK(page.rows[1].title == "rate over range and angle at battery = 2500 units");
  REQUIRE(page.rows[1].panels.size() == 2);
  const auto& map = std::get<HeatMap>(page.rows[1].panels[0]);
  CHECK(map.field.values.front() == Approx(-10));
  CHECK(map.field.values.back() == Approx(10));
  CHECK(std::holds_alternative<Mesh>(page.rows[1].panels[1]));
}

TEST_CASE("With a single input the control surface is a curve") {
  ControlSurface surface = plane();
  surface.y.reset();
  surface.held.clear();
  const Page page = fuzzy_page({"", {}, {}, {surface}});
  CHECK(page.rows.at(0).title == "rate over range");
  const auto& chart = std::get<LineChart>(page.rows[0].panels.at(0));
  CHECK(chart.series.at(0).points.front() == Vector2{0, -10});
  CHECK(chart.series.at(0).points.back().x == Approx(3));
  CHECK(chart.series.at(0).points.back().y == Approx(10));
}

TEST_CASE("Where no rule fires, the surface stays blank") {
  const Folder folder;
  ControlSurface surface = plane();
  surface.value = [](double, double) { return std::nan(""); };
  save_fuzzy_picture({"", {}, {}, {surface}}, folder / "a.png");
  const Bitmap image(folder / "a.png");
  CHECK(count(image, 0, 405, is_violet) + count(image, 0, 405, is_yellow) == 0);
}

TEST_CASE("Plots are well-formed and the same every time") {
  const Folder folder;
  const FuzzyPicture picture{"model <&>", {"2 inputs"}, {range_panel()}, {plane()}};
  for (const std::string suffix : {".png", ".svg"}) {
    save_fuzzy_picture(picture, folder / ("a" + suffix));
    save_fuzzy_picture(picture, folder / ("b" + suffix));
    const bool same = bytes_of(folder / ("a" + suffix)) == bytes_of(folder / ("b" + suffix));
    CHECK(same);
  }
  CHECK(std::system(("xmllint --noout '" + (folder / "a.svg").string() + "'").c_str()) == 0);
}

TEST_CASE("Line charts take gaps, single values, no values, and many series") {
  const Folder folder;
  LineChart chart{"rates", {"time", "s"}, {"rate", "rad/s"}, {}};
  for (int i = 0; i < 30; ++i) {
    chart.series.push_back(
        {"series " + std::to_string(i), {{0, 1.0 * i}, {1, std::nan("")}, {2, 3}}});
  }
  LineChart constant{"", {}, {}, {{"", {{1, 5}, {2, 5}}}}};
  LineChart borders{"", {"x", "", 5.0, {}}, {"y", "", {}, -3.0}, {{"", {{0, 0}, {1, 1}}}}};
  CHECK_NOTHROW(
      save_page({"", {}, {{{chart}}, {{constant, LineChart{}, borders}}, {}}}, folder / "a.png"));
  CHECK_NOTHROW(save_page({"", {}, {{{chart}}}}, folder / "flat.png", {1000, 200}));
  CHECK(Bitmap(folder / "flat.png").height() == 200);
  CHECK_NOTHROW(save_page({}, folder / "empty.png"));
}

TEST_CASE("Axes that cannot be drawn are refused") {
  const Folder folder;
  const auto save = [&](Panel panel) {
    save_page({"", {}, {{{std::move(panel)}}}}, folder / "a.png");
  };
  CHECK_THROWS_AS(save(LineChart{"", {"x", "", 1.0, 1.0}, {}, {}}), std::invalid_argument);
  CHECK_THROWS_AS(save(LineChart{"", {"x", "", std::nan(""), {}}, {}, {}}), std::invalid_argument);
  const Field field{{"x", "", 0.0, 1.0}, {"y", "", 0.0, 1.0}, {}, 2, 2, {1, 2, 3, 4}};
  CHECK_NOTHROW(save(HeatMap{"", field}));
  CHECK_NOTHROW(save(Mesh{"", field}));
}
