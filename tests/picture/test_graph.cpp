// Drawings of coordinators' states and trees.
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "elsie/base/error.h"
#include "elsie/picture/graph_picture.h"

using namespace elsie;
using Catch::Contains;
using picture::GraphLayout;
using picture::GraphLights;
using picture::NamedGraph;

namespace {

/// A frame "work" with the states "dig" and "carry" in it, and "rest" beside it.
NamedGraph states() {
  return {"arbiter_states",
          {{{"work"}, {"dig & drill", 0}, {"carry", 0}, {"rest"}},
           {{1, 2, "full"}, {0, 3, "battery < 0.2"}, {3, 0, "fresh"}}}};
}
const GraphLights kCarries{
    {NodeState::running, NodeState::dark, NodeState::running, NodeState::dark}};

NamedGraph tree() {
  return {"arbiter_tree", {{{"fallback"}, {"a"}, {"b"}, {"c"}}, {{0, 1}, {0, 2}, {0, 3}}}};
}

long times(const std::string& text, const std::string& part) {
  long found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++found;
  return found;
}

std::string svg_of(const NamedGraph& graph, const GraphLights& lights, const std::string& title) {
  return picture::draw_graphs(picture::lay_out({graph}), lights, title, "svg");
}

bool is_inside(const GraphLayout::Box& inner, const GraphLayout::Box& outer) {
  return inner.from.x > outer.from.x && inner.from.y > outer.from.y && inner.to.x < outer.to.x &&
         inner.to.y < outer.to.y;
}
bool are_apart(const GraphLayout::Box& a, const GraphLayout::Box& b) {
  return a.to.x <= b.from.x || b.to.x <= a.from.x || a.to.y <= b.from.y || b.to.y <= a.from.y;
}
/// How far a point is from the rim of a box.
double from_rim(const Vector2& point, const GraphLayout::Box& box) {
  const double x = std::clamp(point.x, box.from.x, box.to.x);
  const double y = std::clamp(point.y, box.from.y, box.to.y);
  const double outside = std::hypot(point.x - x, point.y - y);
  const double inside = std::min({std::abs(point.x - box.from.x), std::abs(point.x - box.to.x),
                                  std::abs(point.y - box.from.y), std::abs(point.y - box.to.y)});
  return outside > 0.0 ? outside : inside;
}

}  // namespace

TEST_CASE("A layout has a box for each node, those of a frame inside it, and all on the sheet") {
  const GraphLayout layout = picture::lay_out({states()});
  REQUIRE(layout.boxes.size() == 4);
  const auto& boxes = layout.boxes;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    INFO(boxes[i].label.text);
    CHECK(boxes[i].node == i);
    CHECK(boxes[i].is_frame == (i == 0));
    CHECK(boxes[i].from.x >= 0.0);
    CHECK(boxes[i].from.y >= 0.0);
    CHECK(boxes[i].to.x <= layout.width);
    CHECK(boxes[i].to.y <= layout.height);
    CHECK(boxes[i].label.at.x > boxes[i].from.x);
    CHECK(boxes[i].label.at.x < boxes[i].to.x);
    CHECK(boxes[i].label.at.y > boxes[i].from.y);
    CHECK(boxes[i].label.at.y < boxes[i].to.y);
  }
  CHECK(is_inside(boxes[1], boxes[0]));
  CHECK(is_inside(boxes[2], boxes[0]));
  CHECK(are_apart(boxes[1], boxes[2]));
  CHECK(are_apart(boxes[3], boxes[0]));
  CHECK(boxes[1].label.text == "dig & drill");
}

TEST_CASE("An arrow ends at the rim of its node, or of the frame that it leads to") {
  const GraphLayout layout = picture::lay_out({states()});
  REQUIRE(layout.arrows.size() == 5);
  const std::size_t ends[] = {2, 3, 0, 0, 1};  // the last two from dots
  for (std::size_t i = 0; i < 5; ++i) {
    const GraphLayout::Arrow& arrow = layout.arrows[i];
    INFO(arrow.label.text);
    CHECK(arrow.curve.size() % 3 == 1);
    CHECK(from_rim(arrow.tip, layout.boxes[ends[i]]) < 2.0);
  }
  CHECK(layout.arrows[1].label.text == "battery < 0.2");
}

TEST_CASE("A graph is drawn with its names, its edges, and what is running in colour") {
  const std::string svg = svg_of(states(), kCarries, "r1: after 3 s");
  for (const char* words : {"work", "dig &amp; drill", "carry", "rest", "full", "battery &lt; 0.2",
                            "fresh", "r1: after 3 s"}) {
    CHECK_THAT(svg, Contains(words));
  }
  CHECK(times(svg, "stroke=\"#606060\"") == 5);  // arrows, two of them from dots
  CHECK(times(svg, "<title>") == 4);
  CHECK_THAT(svg, Contains("<title>carry: running</title>"));
  CHECK_THAT(svg, Contains("<title>work: running</title>"));
  CHECK_THAT(svg, Contains("<title>rest</title>"));
  CHECK(times(svg, "#ffd966") == 1);  // carry
  CHECK(times(svg, "#fff4d1") == 1);  // the frame around it
  CHECK(svg_of(states(), kCarries, "r1: after 3 s") == svg);
}

TEST_CASE("What succeeded and what failed have colours and marks of their own") {
  const auto with = [](NodeState a, NodeState b) {
    return svg_of(tree(), {{NodeState::running, a, b, NodeState::dark}}, "");
  };
  const std::string svg = with(NodeState::failure, NodeState::success);
  CHECK(times(svg, "#f4b6ae") == 1);
  CHECK(times(svg, "#b6d7a8") == 1);
  CHECK(times(svg, "#fafafa") == 1);
  CHECK(times(svg, "<path") == times(with(NodeState::dark, NodeState::dark), "<path") + 2);
}

TEST_CASE("With other lights, nothing moves") {
  const GraphLayout layout = picture::lay_out({states()});
  GraphLights lights = kCarries;
  const std::string before = picture::draw_graphs(layout, lights, "", "svg");
  std::swap(lights[0][1], lights[0][2]);
  const std::string after = picture::draw_graphs(layout, lights, "", "svg");
  CHECK(before != after);
  const auto boxes = [](const std::string& svg) { return svg.substr(0, svg.find("<title>")); };
  CHECK(boxes(before) == boxes(after));
  CHECK(before.size() == after.size());
}

TEST_CASE("Several graphs of a robot stand in frames with their paths") {
  NamedGraph inner = states();
  inner.path = "explore/arbiter_states";
  const GraphLayout layout = picture::lay_out({states(), inner});
  CHECK(layout.boxes.size() == 10);
  const std::string svg =
      picture::draw_graphs(layout, {kCarries[0], std::vector<NodeState>(4)}, "r1", "svg");
  CHECK_THAT(svg, Contains("explore/arbiter_states"));
  CHECK(times(svg, "#ffd966") == 1);
}

TEST_CASE("A way between a frame and what is in it is drawn, too") {
  NamedGraph graph = states();
  graph.graph.edges = {{0, 2, "in"}, {2, 0, "out"}, {0, 0, "again"}};
  const GraphLayout layout = picture::lay_out({graph});
  CHECK(layout.arrows.size() == 5);
}

TEST_CASE(
    "A dot shows in which state the whole begins, and in which each state with states in it") {
  const GraphLayout layout = picture::lay_out({states()});
  REQUIRE(layout.dots.size() == 2);
  const auto is_in = [&](const Vector2& dot, std::size_t box) {
    return is_inside({dot, dot, {}}, layout.boxes[box]);
  };
  CHECK_FALSE(is_in(layout.dots[0], 0));
  CHECK(is_in(layout.dots[1], 0));  // "work", beside "dig"
  CHECK(from_rim(layout.arrows[3].tip, layout.boxes[0]) < 2.0);
  CHECK(from_rim(layout.arrows[4].tip, layout.boxes[1]) < 2.0);
  CHECK(picture::lay_out({tree()}).dots.empty());
}

TEST_CASE("No arrow begins where another ends") {
  const NamedGraph round{
      "arbiter_states",
      {{{"out"}, {"load"}, {"back"}},
       {{0, 1, "arrived"}, {1, 2, "after 3 s"}, {2, 0, "done"}, {1, 0, "lost"}, {2, 1, "empty"}}}};
  const GraphLayout layout = picture::lay_out({round});
  for (const GraphLayout::Arrow& one : layout.arrows) {
    for (const GraphLayout::Arrow& other : layout.arrows) {
      const Vector2& begin = other.curve.front();
      INFO(one.label.text << ", " << other.label.text);
      CHECK(std::hypot(one.tip.x - begin.x, one.tip.y - begin.y) > 8.0);
    }
  }
}

TEST_CASE("Labels of arrows lie neither on the rim of a frame nor on a node") {
  NamedGraph graph = states();
  graph.graph.nodes.insert(graph.graph.nodes.end(), {{"sleep"}, {"deep", 4}, {"light", 4}});
  graph.graph.edges.insert(graph.graph.edges.end(), {{1, 6, "[0.3 > battery] after 12 s"},
                                                     {0, 4, "tired"},
                                                     {6, 2, "[battery > 0.9]"},
                                                     {5, 6, "heard"},
                                                     {6, 5, "after 3 s"},
                                                     {4, 3, "light_seen"}});
  const GraphLayout layout = picture::lay_out({graph});
  for (const GraphLayout::Arrow& arrow : layout.arrows) {
    const auto& [words, at, size] = arrow.label;
    if (words.empty()) continue;
    const GraphLayout::Box place{
        {at.x - size.x / 2, at.y - size.y / 2}, {at.x + size.x / 2, at.y + size.y / 2}, {}};
    for (const GraphLayout::Box& box : layout.boxes) {
      INFO(words << " at " << box.label.text);
      CHECK((are_apart(place, box) || (box.is_frame && is_inside(place, box))));
    }
  }
}

TEST_CASE("A backslash in a name is a backslash, and an entity is what is written") {
  NamedGraph odd = states();
  odd.graph.nodes[2].label = "q \\N \\G &lt;";
  CHECK_THAT(svg_of(odd, kCarries, "a\\b"), Contains("q \\N \\G &amp;lt;") && Contains("a\\b"));
}

TEST_CASE("A PNG of a graph is a PNG") {
  const GraphLayout layout = picture::lay_out({states()});
  CHECK(picture::draw_graphs(layout, kCarries, "r1", "png").substr(1, 3) == "PNG");
  CHECK_THROWS_AS(picture::draw_graphs(layout, kCarries, "r1", "nothing"), base::Error);
}

TEST_CASE("A part of a graph is drawn for a screen, in its colours") {
  const GraphLayout layout = picture::lay_out({states()});
  const GraphLayout::Box& carry = layout.boxes[2];
  const picture::Style dark{{"surface", {0, 0, 0}}, {"running", {10, 20, 30}}};
  // From the middle of the box, below its text, to its lower rim.
  const Vector2 from{carry.from.x + 4, carry.to.y - 6};
  const auto pixels = picture::screen_graphs(layout, kCarries, from, 8, 4, 2.0, dark);
  REQUIRE(pixels.size() == 32);
  for (const std::uint32_t pixel : pixels) CHECK((pixel & 0xffffffU) == 0x0a141eU);
  const auto outside = picture::screen_graphs(layout, kCarries, {-50, -50}, 2, 2, 1.0, dark);
  CHECK((outside[0] & 0xffffffU) == 0U);
}

TEST_CASE("A graph of too many nodes is refused, before Graphviz takes minutes for it") {
  NamedGraph ring{"arbiter_states", {}};
  constexpr std::size_t kStates = picture::kMostGraphNodes + 1;
  for (std::size_t i = 0; i < kStates; ++i) {
    ring.graph.nodes.push_back({"s"});
    ring.graph.edges.push_back({i, (i + 1) % kStates, "next"});
  }
  CHECK_THROWS_WITH(picture::lay_out({ring}),
                    Contains("401 nodes") && Contains("at most 400") && Contains("elsie explain"));
  ring.graph.nodes.resize(200);
  ring.graph.edges.clear();
  CHECK_NOTHROW(picture::require_drawable({ring, ring}));
  ring.graph.nodes.push_back({"one more"});
  CHECK_THROWS_AS(picture::require_drawable({ring, ring}), base::Error);
}

TEST_CASE("A PNG whose texts could not be read is refused; an SVG is as wide as it must be") {
  NamedGraph flat{"arbiter_tree", {{{"parallel"}}, {}}};
  for (std::size_t i = 1; i <= 300; ++i) {
    flat.graph.nodes.push_back({"a behaviour"});
    flat.graph.edges.push_back({0, i});
  }
  const GraphLayout layout = picture::lay_out({flat});
  REQUIRE(layout.width > 16000.0);
  const GraphLights lights{std::vector<NodeState>(301)};
  CHECK_THROWS_WITH(picture::draw_graphs(layout, lights, "", "png"),
                    Contains("at most 16000") && Contains(".svg"));
  CHECK_THAT(picture::draw_graphs(layout, lights, "", "svg"), Contains("a behaviour"));
}
