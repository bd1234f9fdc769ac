// Automata and trees in the window: where they are, and their elements at any depth.
#include <QDockWidget>
#include <QLineEdit>
#include <QListWidget>
#include <QTreeWidget>

#include <catch2/catch.hpp>

#include "control_bar.h"
#include "hands.h"
#include "watch/graph_panel.h"
#include "window.h"

using namespace elsie::desktop;

namespace {

const QString kFirst = "robot[r1]/coordinator/state[1]/state[1]";

constexpr const char* kTwoStates = R"(<world format="1">
  <robots>
    <robot id="r1">
      <behaviors><wander/></behaviors>
      <coordinator>
        <arbiter_states>
          <state name="work">
            <state name="go" behavior="wander"><transition to="rest" after="1"/></state>
            <state name="rest"><transition to="go" after="1"/></state>
          </state>
          <state name="off" ends="success"/>
        </arbiter_states>
      </coordinator>
    </robot>
    <robot id="r2" x="1">
      <behaviors><wander/></behaviors>
      <coordinator><arbiter_tree>
        <sequence><run behavior="wander"/></sequence>
      </arbiter_tree></coordinator>
    </robot>
    <robot id="r3" x="-1">
      <behaviors><wander/></behaviors>
      <coordinator><arbiter_suppression/></coordinator>
    </robot>
  </robots>
  <limits time="60"/>
</world>
)";

GraphPanel* graph_in_front(Window& window) {
  window->arrange("watch");
  show_dock(window.window(), "dock_graph");
  return window.get<GraphPanel>("graph");
}

}  // namespace

TEST_CASE("The graph of the selected robot is lit while the world runs, and back in time") {
  Room window(kTwoStates);
  GraphPanel* graph = graph_in_front(window);
  REQUIRE(wait_for([&] { return graph->running() == QStringList{"work", "go"}; }));
  run_until(window, 1.5);
  CHECK(wait_for([&] { return graph->running() == QStringList{"work", "rest"}; }));
  window.get<TimeLine>("time_line")->go_to(0.5);
  CHECK(wait_for([&] { return graph->running() == QStringList{"work", "go"}; }));
  window.choose("robot[r3]");
  CHECK(wait_for([&] { return graph->notice().contains("r3 shows no graph"); }));
  window.choose("robot[r1]");
  CHECK(wait_for([&] { return graph->running() == QStringList{"work", "go"}; }));
  window.get<TimeLine>("time_line")->go_to_now();
  CHECK(wait_for([&] { return graph->running() == QStringList{"work", "rest"}; }));

  window.choose("robot[r2]");
  CHECK(wait_for([&] { return graph->running().size() == 2; }));
  window.choose("robot[r3]");
  CHECK(wait_for([&] { return graph->notice().contains("r3 shows no graph"); }));
  window.choose("robot[r1]");
  CHECK(wait_for([&] { return graph->running() == QStringList{"work", "rest"}; }));
}

TEST_CASE("An edit of an automaton is an edit of its graph") {
  Room window(kTwoStates);
  GraphPanel* graph = graph_in_front(window);
  REQUIRE(wait_for([&] { return graph->running() == QStringList{"work", "go"}; }));
  const QString rest = "robot[r1]/coordinator/state[1]/state[2]";
  window.after([&] {
    window.bench().edit({rest + "/transition/@to=off", kFirst + "/@remove=true"}, "remove");
  });
  CHECK(wait_for([&] { return graph->running() == QStringList{"work", "rest"}; }));
}

TEST_CASE("A recorded run that is played shows its graph") {
  Window window;
  const QString world = window.file(kTwoStates);
  const QString recording = window.folder() + "/run.mcap";
  run_elsie({"run", world, "--duration", "3", "--record", recording, "--quiet"});
  window.open(recording);
  GraphPanel* graph = graph_in_front(window);
  run_until(window, 1.5);
  CHECK(wait_for([&] { return graph->running() == QStringList{"work", "rest"}; }));
  window.get<TimeLine>("time_line")->go_to(0.5);
  CHECK(wait_for([&] { return graph->running() == QStringList{"work", "go"}; }));
}

TEST_CASE("States in states are in the tree, and have forms") {
  Room window(kTwoStates);
  window.choose(kFirst);
  CHECK(window.get<WorldTree>("world_tree")->item(kFirst)->text(0) == "go (state)");
  CHECK(field(window, "behavior")->text() == "wander");
  window.choose(kFirst + "/transition");
  window.after([&] { enter(field(window, "after"), "2.5"); });
  CHECK(window.bench().text().contains("<transition to=\"rest\" after=\"2.5\"/>"));
  window.choose("robot[r2]/coordinator/sequence/run");
  CHECK(field(window, "success")->toolTip().contains("an event that means its success"));
}

TEST_CASE("An element is added to one of a plugin by a dialog with all that may stand there") {
  Room window(kTwoStates);
  window.choose("robot[r2]/coordinator/sequence");
  const auto is_picked = pick_when_open("element_menu", "Add element");
  window.act("more");
  CHECK(*is_picked);
  QDialog* dialog = window.dialog("element_dialog");
  auto* kinds = dialog->findChild<QListWidget*>("kinds");
  CHECK(kinds->findItems("parallel", Qt::MatchExactly).size() == 1);
  CHECK(kinds->findItems("define", Qt::MatchExactly).isEmpty());  // not in a node
  kinds->setCurrentItem(kinds->findItems("run", Qt::MatchExactly).front());
  auto* form = dialog->findChild<Form*>("form_run");
  REQUIRE(form);
  form->set_value("behavior", "wander");
  form->set_value("name", "again");
  window.after([&] { Window::press(dialog, QDialogButtonBox::Ok); });
  const QString made = "robot[r2]/coordinator/sequence/run[2]";
  const ElementPlace place = place_of(window.bench().tree(), made);
  REQUIRE(place.element);
  CHECK(attribute(*place.element, "name") == "again");
  CHECK(wait_for(
      [&] { return window.get<WorldTree>("world_tree")->selection() == QStringList{made}; }));
}

TEST_CASE("Nodes of a tree are copied beside each other, and into one that is chosen") {
  Room window(kTwoStates);
  const QString root = "robot[r2]/coordinator/sequence";
  const auto is_there = [&](const QString& path) {
    return place_of(window.bench().tree(), path).element != nullptr;
  };
  window.choose(root + "/run");
  window.after([&] { window.act("duplicate"); });
  CHECK(is_there(root + "/run[2]"));
  window.choose(root);
  window.act("copy");
  window.choose(root + "/run[1]");
  window.after([&] { window.act("paste"); });
  CHECK(is_there(root + "/sequence/run[2]"));
  // It may hold its like, but its copy stands beside it.
  window.choose(root + "/sequence");
  window.after([&] { window.act("duplicate"); });
  CHECK(is_there(root + "/sequence[2]/run[2]"));
  CHECK_FALSE(is_there(root + "/sequence[1]/sequence"));
  window.choose(root + "/sequence[2]");
  window.after([&] { window.act("delete"); });
  CHECK(is_there(root + "/sequence/run[2]"));
}
