// Drawings of coordinators' states and trees.
#include <algorithm>

#include <catch2/catch.hpp>

#include "elsie/base/error.h"
#include "elsie/picture/graph_picture.h"

using namespace elsie;
using Catch::Contains;
using simulation::LitGraph;

namespace {

/// A frame "work" with the states "dig" and "carry" in it, and "rest" beside it.
LitGraph states() {
  LitGraph lit{"arbiter_states", "arbiter_states", {}, {}};
  lit.graph.nodes = {{"work"}, {"dig & drill", 0}, {"carry", 0}, {"rest"}};
  lit.graph.edges = {{1, 2, "full"}, {0, 3, "battery < 0.2"}, {3, 0, "fresh"}};
  lit.lights = {NodeState::running, NodeState::dark, NodeState::running, NodeState::dark};
  return lit;
}

long times(const std::string& text, const std::string& part) {
  long found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++found;
  return found;
}

}  // namespace

TEST_CASE("A graph is drawn with its names, its edges, and what is running in colour") {
  const std::string svg = picture::draw_graphs({states()}, "r1: after 3 s", "svg");
  for (const char* words : {"work", "dig &amp; drill", "carry", "rest", "full", "battery &lt; 0.2",
                            "fresh", "r1: after 3 s"}) {
    CHECK_THAT(svg, Contains(words));
  }
  CHECK(times(svg, "class=\"edge\"") == 3);
  CHECK(times(svg, "class=\"node\"") == 3);  // a state that holds others is a frame
  CHECK(times(svg, "class=\"cluster\"") == 1);
  CHECK(times(svg, "#ffd966") == 1);  // carry
  CHECK(picture::draw_graphs({states()}, "r1: after 3 s", "svg") == svg);
}

TEST_CASE("What succeeded and what failed have colours of their own") {
  LitGraph tree{"arbiter_tree", "arbiter_tree", {}, {}};
  tree.graph.nodes = {{"fallback"}, {"a"}, {"b"}, {"c"}};
  tree.graph.edges = {{0, 1}, {0, 2}, {0, 3}};
  tree.lights = {NodeState::running, NodeState::failure, NodeState::success, NodeState::dark};
  const std::string svg = picture::draw_graphs({tree}, "", "svg");
  CHECK(times(svg, "#f4b6ae") == 1);
  CHECK(times(svg, "#b6d7a8") == 1);
  CHECK(times(svg, "#fafafa") == 1);
}

TEST_CASE("Several graphs of a robot stand in frames with their paths") {
  LitGraph inner = states();
  inner.path = "explore/arbiter_states";
  const std::string svg = picture::draw_graphs({states(), inner}, "r1", "svg");
  CHECK(times(svg, "class=\"node\"") == 6);
  CHECK(times(svg, "class=\"cluster\"") == 4);
  CHECK_THAT(svg, Contains("explore/arbiter_states"));
}

TEST_CASE("A backslash in a name is a backslash") {
  LitGraph odd = states();
  odd.graph.nodes[2].label = "q \\N \\G";
  CHECK_THAT(picture::draw_graphs({odd}, "a\\b", "svg"), Contains("q \\N \\G") && Contains("a\\b"));
}

TEST_CASE("A PNG of a graph is a PNG") {
  const std::string png = picture::draw_graphs({states()}, "r1", "png");
  CHECK(png.substr(1, 3) == "PNG");
  CHECK_THROWS_AS(picture::draw_graphs({states()}, "r1", "nothing"), base::Error);
}
