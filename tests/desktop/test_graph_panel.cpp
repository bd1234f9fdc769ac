// The panel of graphs: what is lit, now and in the past.
#include <QApplication>
#include <QTest>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "stored.h"
#include "waiting.h"
#include "watch/graph_panel.h"
#include "watch/state.h"

using namespace elsie::desktop;

namespace {

/// An automaton whose state of that number is running, in a frame, and a tree inside a behaviour.
Json graphs(int running) {
  Json state = Json::parse(R"({"event": "state", "time_s": 0.1, "robots": [{"id": "r1", "graphs": [
    {"path": "arbiter_states", "plugin": "arbiter_states",
     "nodes": [{"label": "work"}, {"label": "dig", "within": 0}, {"label": "carry", "within": 0}],
     "edges": [{"from": 1, "to": 2, "label": "full"}]},
    {"path": "errand/arbiter_tree", "plugin": "arbiter_tree",
     "nodes": [{"label": "run wander"}], "edges": [], "running": [], "failure": [0]}]},
    {"id": "r2", "graphs": []}]})");
  state["robots"][0]["graphs"][0]["running"] = {0, running};
  return state;
}

/// The colours of the panel, by how many pixels have them.
int pixels_of(GraphPanel& panel, const QColor& colour) {
  const QImage image = panel.grab().toImage();
  int count = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) count += image.pixelColor(x, y) == colour ? 1 : 0;
  }
  return count;
}

const QColor kLit(0xff, 0xd9, 0x66), kFailed(0xf4, 0xb6, 0xae);

}  // namespace

TEST_CASE("graph: all graphs of the selected robot, with what is running lit") {
  GraphPanel panel;
  panel.resize(500, 400);
  CHECK(panel.notice().contains(QStringLiteral("Select a robot")));
  panel.set_robot(QStringLiteral("r1"));
  CHECK(panel.notice().contains(QStringLiteral("Nothing from r1 yet")));
  panel.add(graphs(1));
  CHECK(panel.notice() == QString());
  CHECK(panel.running() == QStringList{QStringLiteral("work"), QStringLiteral("dig")});
  CHECK(pixels_of(panel, kLit) > 100);
  CHECK(pixels_of(panel, kFailed) > 100);
  panel.add(graphs(2));
  CHECK(panel.running() == QStringList{QStringLiteral("work"), QStringLiteral("carry")});
  auto* page = panel.findChild<QWidget*>(QStringLiteral("graph_page"));
  const QString said = QAccessible::queryAccessibleInterface(page)->text(QAccessible::Value);
  CHECK(said.contains(QStringLiteral("coordinator arbiter_states, node carry, state running")));
  CHECK(said.contains(
      QStringLiteral("coordinator errand/arbiter_tree, node run wander, state failure")));
}

TEST_CASE("graph: a robot whose coordinator has none says who has") {
  GraphPanel panel;
  panel.set_robot(QStringLiteral("r2"));
  panel.add(graphs(1));
  CHECK(panel.notice() ==
        QStringLiteral("The coordinator of r2 shows no graph; arbiter_states and arbiter_tree do"));
  CHECK(panel.running().isEmpty());
  panel.grab();
}

TEST_CASE("graph: what was lit at the shown time, as far as it is stored") {
  GraphPanel panel;
  panel.resize(500, 400);
  panel.set_robot(QStringLiteral("r1"));
  panel.add(graphs(2));
  REQUIRE(panel.numbers().size() == 4);
  const auto number = [](int node) { return "r1/arbiter_states/nodes/" + std::to_string(node); };
  Samples samples;
  samples.add(stored({0.1, 0.2}, {{number(0), {1.0F, 1.0F}},
                                  {number(1), {1.0F, 0.0F}},
                                  {number(2), {0.0F, 1.0F}},
                                  {"r1/errand/arbiter_tree/nodes/0", {std::nanf(""), 3.0F}}}));
  panel.set_samples(samples);
  panel.look_back(0.15);
  CHECK(panel.running() == QStringList{QStringLiteral("work"), QStringLiteral("dig")});
  CHECK(pixels_of(panel, kFailed) == 0);
  panel.look_back(0.2);
  CHECK(panel.running() == QStringList{QStringLiteral("work"), QStringLiteral("carry")});
  panel.look_back(0.15);
  panel.look_back(std::nullopt);
  CHECK(panel.running() == QStringList{QStringLiteral("work"), QStringLiteral("carry")});
}

TEST_CASE("graph: one that is larger than the panel can be scrolled, and read") {
  GraphPanel panel;
  panel.set_robot(QStringLiteral("r1"));
  Json state = graphs(1);
  Json& nodes = state["robots"][0]["graphs"][0]["nodes"];
  for (int i = 3; i < 40; ++i) nodes.push_back({{"label", "state number " + std::to_string(i)}});
  panel.resize(300, 200);
  panel.add(state);
  auto* page = panel.findChild<QWidget*>(QStringLiteral("graph_page"));
  CHECK(page->minimumWidth() > 1000);
  panel.add(graphs(1));
  CHECK(page->minimumWidth() < 1000);
}

TEST_CASE("graph: too many nodes, and what is no graph, are said") {
  GraphPanel panel;
  panel.set_robot(QStringLiteral("r1"));
  Json state = graphs(1);
  Json& nodes = state["robots"][0]["graphs"][0]["nodes"];
  for (int i = 3; i < 501; ++i) nodes.push_back({{"label", "x"}});
  panel.add(state);
  CHECK(panel.notice().contains(QStringLiteral("502 nodes are too many")));
  state["robots"][0]["graphs"][0]["nodes"][1]["within"] = 7;
  panel.add(state);
  CHECK(panel.notice().contains(QStringLiteral("no node 7")));
  panel.add(graphs(1));
  CHECK(panel.notice() == QString());
}
