// Where coordinators were in their graphs.
#include <catch2/catch.hpp>

#include "elsie/traces/graph_account.h"

using namespace elsie;
using namespace elsie::traces;

namespace {

constexpr NodeState kDark = NodeState::dark, kRuns = NodeState::running;

/// Two states in turn, in a frame.
TraceGraph in_turn() {
  TraceGraph graph{"arbiter_states", "arbiter_states", {{{"work"}, {"dig", 0}, {"carry", 0}}, {}}};
  graph.lights = {{1.0, {kRuns, kRuns, kDark}},
                  {3.0, {kRuns, kDark, kRuns}},
                  {4.0, {kRuns, kRuns, kDark}},
                  {8.0, {kDark, kDark, kDark}}};
  return graph;
}

}  // namespace

TEST_CASE("The time in each state, and how often it was entered") {
  const auto nodes = account(in_turn(), {0.0, 10.0});
  REQUIRE(nodes.size() == 3);
  CHECK(nodes[0].running.time_s == 7.0);
  CHECK(nodes[0].running.times == 1);  // without a pause
  CHECK(nodes[1].running.time_s == 6.0);
  CHECK(nodes[1].running.times == 2);
  CHECK(nodes[2].running.time_s == 1.0);
  CHECK(nodes[2].was_lit());
}

TEST_CASE("Only the span counts, and only the time in which the graph is there") {
  TraceGraph graph = in_turn();
  const auto part = account(graph, {3.5, 5.0});
  CHECK(part[1].running.time_s == 1.0);
  CHECK(part[2].running.time_s == 0.5);
  graph.lights.pop_back();
  graph.to_s = 6.0;
  CHECK(account(graph, {0.0, 10.0})[1].running.time_s == 4.0);
}

TEST_CASE("Successes and failures are counted on their own") {
  TraceGraph graph{"arbiter_tree", "arbiter_tree", {{{"retry"}, {"try"}}, {{0, 1}}}};
  graph.lights = {{0.0, {kRuns, kRuns}},
                  {1.0, {kRuns, NodeState::failure}},
                  {1.5, {kRuns, kRuns}},
                  {2.0, {NodeState::success, NodeState::success}}};
  const auto nodes = account(graph, {0.0, 3.0});
  CHECK(nodes[1].failure.times == 1);
  CHECK(nodes[1].failure.time_s == 0.5);
  CHECK(nodes[1].success.times == 1);
  CHECK(nodes[0].success.time_s == 1.0);
}

TEST_CASE("Nodes stand as deep as those around them or, in a tree, above them") {
  CHECK(depths({{{"a"}, {"b", 0}, {"c", 1}, {"d"}}, {{0, 3}}}) == std::vector{0, 1, 2, 0});
  CHECK(depths({{{"a"}, {"b"}, {"c"}, {"d"}}, {{0, 1}, {1, 2}, {0, 3}}}) ==
        std::vector{0, 1, 2, 1});
  CHECK(depths({{{"a"}, {"b"}}, {{0, 1}, {1, 0}}}) == std::vector{0, 0});  // no tree
  CHECK(depths({{{"a"}, {"b"}, {"c"}}, {{0, 2}, {1, 2}}}) == std::vector{0, 0, 0});
}

TEST_CASE("States with ways in one direction only are no tree: ways say when they are taken") {
  const Graph errand{{{"search"}, {"fetch"}, {"deliver"}},
                     {{0, 1, "resource_seen"}, {1, 2, "collected"}}};
  CHECK_FALSE(is_tree(errand));
  CHECK(depths(errand) == std::vector{0, 0, 0});
}

TEST_CASE("A tree has one root") {
  CHECK(is_tree({{{"a"}, {"b"}, {"c"}}, {{0, 1}, {0, 2}}}));
  CHECK(is_tree({{{"a"}}, {}}));
  CHECK_FALSE(is_tree({{{"a"}, {"b"}, {"c"}}, {{0, 1}}}));
  CHECK_FALSE(is_tree({{{"a"}, {"b", 0}}, {{0, 1}}}));
}
