// Path data, numbers and charts as SVG.
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string>

#include <catch2/catch.hpp>

#include "elsie/picture/plot.h"
#include "elsie/picture/polyline.h"
#include "elsie/picture/svg.h"

#include "support.h"

using namespace elsie;
using namespace elsie::picture;
using Catch::Contains;

namespace {

LineChart learning(bool logarithmic) {
  LineChart chart;
  chart.x = {"presentations", "", {}, {}};
  chart.y = {"error", "", {}, {}, logarithmic};
  chart.naming = Naming::in_titles;
  chart.series = {{"run <1>", {{0, 1}, {10, 0.1}, {20, 0}, {30, 0.001}, {40, 0.02}}}};
  return chart;
}

}  // namespace

TEST_CASE("Numbers are short and never a negative zero") {
  CHECK(short_number(0.25, 2) == "0.25");
  CHECK(short_number(3.0, 2) == "3");
  CHECK(short_number(100.0, 0) == "100");
  CHECK(short_number(-0.001, 2) == "0");
  CHECK(hex_text({208, 49, 30}) == "#d0311e");
}

TEST_CASE("Path data is relative, and steps that vanish are left out") {
  const auto data = [](std::vector<Vector2> line, int decimals = 0, bool closed = false) {
    return path_data(line, decimals, closed);
  };
  CHECK(data({{10, 20}, {13, 16}, {13.2, 16.1}, {18, 22}}, 0, true) == "M10 20l3-4 5 6z");
  CHECK(data({{1.5, 1}, {1.5, 1}}, 2) == "M1.5 1l0 0");  // round ends make it a dot
  CHECK(data({{1, 1}}) == "M1 1l0 0");
  CHECK(data({{0, 0}, {1e300, 0}}) == "M0 0l100000 0");
  CHECK(data({{0, 0}, {0.5, 0.25}}, 1) == "M0 0l0.5 0.3");
  CHECK(data({}).empty());
}

TEST_CASE("A line is divided where it is unknown, and simplified within a tolerance") {
  const double unknown = std::nan("");
  CHECK(pieces({{unknown, 0}, {1, 1}, {2, 2}, {3, unknown}, {4, 4}, {unknown, 0}}) ==
        std::vector<std::vector<Vector2>>{{{1, 1}, {2, 2}}, {{4, 4}}});
  CHECK(simplified({{0, 0}, {1, 0.05}, {2, 0}, {3, 1}}, 0.1) ==
        std::vector<Vector2>{{0, 0}, {2, 0}, {3, 1}});
}

TEST_CASE("A chart of a page has the colours of its style, and names as titles") {
  const std::string chart = page_chart(learning(false), "Error <over> time", {400, 200});
  CHECK_THAT(chart, Catch::StartsWith("<svg role=\"img\" aria-label=\"Error &lt;over&gt; time\" "
                                      "viewBox=\"0 0 400 200\"") &&
                        Catch::EndsWith("</svg>"));
  CHECK_THAT(chart, Contains("<title>run &lt;1&gt;</title>") && Contains("\"var(--c)\"") &&
                        Contains("\"var(--grid)\"") && Contains("\"var(--ink)\""));
  CHECK_THAT(chart, !Contains("url("));
  CHECK_THAT(chart, !Contains("fill=\"#") && !Contains("stroke=\"#"));
}

TEST_CASE("A logarithmic axis has powers of ten, and leaves out what has no logarithm") {
  const std::string chart = page_chart(learning(true), "", {400, 200});
  for (const std::string label : {">10⁻³<", ">10⁻²<", ">10⁻¹<", ">10⁰<"}) {
    CHECK_THAT(chart, Contains(label));
  }
  const std::size_t first = chart.find("stroke=\"var(--c)\"");
  REQUIRE(first != std::string::npos);
  CHECK(chart.find("stroke=\"var(--c)\"", first + 1) != std::string::npos);  // two parts
  LineChart below = learning(true);
  below.y.low = 0.0;
  CHECK_THROWS_AS(page_chart(below, "", {400, 200}), std::invalid_argument);
}
