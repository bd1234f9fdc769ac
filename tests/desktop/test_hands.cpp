// Choosing, renaming, deleting, pasting and the focus of the keyboard, as hands do them.
#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScrollBar>

#include <catch2/catch.hpp>

#include "engine/history.h"
#include "hands.h"

using namespace elsie::desktop;

namespace {

constexpr const char* kThree = R"(<world format="1">
  <arena length="8" width="6"/>
  <obstacles>
    <static_box x="1" y="1"/>
    <static_box x="2" y="1"/>
    <static_box x="3" y="1"/>
  </obstacles>
  <robots>
    <robot id="r1" team="red" x="-1">
      <sensors><beam_range id="ahead"/></sensors>
      <behaviors><wander/></behaviors>
      <coordinator><arbiter_suppression/></coordinator>
    </robot>
    <robot id="r2" team="blue" x="-2"/>
  </robots>
</world>
)";

void enter_by_hand(QLineEdit* edit, const char* text) {
  click_on(edit);
  press_key(edit, Qt::Key_A, Qt::ControlModifier);
  type_text(edit, text);
  press_key(edit, Qt::Key_Return);
}

WorldTree* world_tree(Window& window) { return window.get<WorldTree>("world_tree"); }

}  // namespace

TEST_CASE("A click in the view gives it the keys: Space runs, and no form takes them") {
  Room window;
  REQUIRE(wait_for([&] { return window->scene().stage().body_of("robot[r1]") != nullptr; }));
  click_at(&window->scene(), pixel_at(window, {1.0, 1.0, 0.1}));
  REQUIRE(window.get<Properties>("properties")->path() == "obstacle[crate]");
  CHECK(window->scene().hasFocus());
  press_key(&window->scene(), Qt::Key_Space);
  CHECK(wait_for([&] { return window.bench().run_state() == Workbench::Run::running; }));
  press_key(&window->scene(), Qt::Key_Space);
  CHECK(wait_for([&] { return window.bench().run_state() == Workbench::Run::paused; }));
}

TEST_CASE("What is typed when another thing is chosen goes to the thing that it was typed for") {
  Room window;
  click_row(world_tree(window), "robot[r1]");
  QLineEdit* x = field(window, "x");
  click_on(x);
  press_key(x, Qt::Key_A, Qt::ControlModifier);
  type_text(x, "0.5");
  window.after([&] { click_row(world_tree(window), "obstacle[crate]"); });
  CHECK(window.bench().text().contains("<robot id=\"r1\" team=\"red\" x=\"0.5\">"));
  CHECK(field(window, "x")->text() == "1");
}

TEST_CASE("The wheel over a box without the focus moves the page and changes nothing") {
  Room window;
  click_row(world_tree(window), "robot[r1]");
  auto* leader =
      qobject_cast<QComboBox*>(window.get<Properties>("properties")->form().editor("leader"));
  REQUIRE(leader);
  turn_wheel(leader, leader->rect().center(), -120);
  auto* speed = window.get<QComboBox>("speed");
  const int row = speed->currentIndex();
  turn_wheel(speed, speed->rect().center(), -120);
  CHECK(speed->currentIndex() == row);
  CHECK(window.bench().text() == kRoom);
  CHECK(window.bench().undo_name().isEmpty());
  CHECK_FALSE(leader->hasFocus());
}

TEST_CASE("Ctrl+Z after Enter in a field undoes the edit; while something is typed, the typing") {
  Room window;
  click_row(world_tree(window), "robot[r1]");
  QLineEdit* x = field(window, "x");
  window.after([&] { enter_by_hand(x, "0.5"); });
  REQUIRE(x->hasFocus());
  window.after([&] { press_key(x, Qt::Key_Z, Qt::ControlModifier); });
  CHECK(window.bench().text() == kRoom);
  CHECK(x->text() == "-1");
  window.after([&] { press_key(x, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier); });
  CHECK(window.bench().text().contains("x=\"0.5\""));
  press_key(x, Qt::Key_A, Qt::ControlModifier);
  type_text(x, "7");
  press_key(x, Qt::Key_Z, Qt::ControlModifier);
  CHECK(x->text() == "0.5");
  CHECK(window.bench().text().contains("x=\"0.5\""));
}

TEST_CASE("Arrow keys step a number without losing its digits") {
  Room window;
  click_row(world_tree(window), "robot[r1]");
  QLineEdit* x = field(window, "x");
  click_on(x);
  press_key(x, Qt::Key_A, Qt::ControlModifier);
  type_text(x, "1.2345678");
  window.after([&] { press_key(x, Qt::Key_Up); });
  CHECK(x->text() == "1.3345678");

  Form form;
  Field whole;
  whole.name = "presentations";
  whole.type = "integer";
  form.show_fields({whole}, Json{{"presentations", "1000000"}});
  form.show();
  auto* edit = qobject_cast<QLineEdit*>(form.editor("presentations"));
  QTest::keyClick(edit, Qt::Key_Up);
  CHECK(edit->text() == "1000001");
  form.set_value("presentations", "12345678");
  QTest::keyClick(edit, Qt::Key_Down);
  CHECK(edit->text() == "12345677");
}

TEST_CASE("Several things are deleted in any order of choosing, and nothing else") {
  Room window(kThree);
  auto* tree = world_tree(window);
  QStringList boxes;
  visit(window.bench().tree(), [&](const ElementPlace& place) {
    if (name_of(*place.element) == "static_box") boxes << place.path;
    return true;
  });
  REQUIRE(boxes.size() == 3);
  click_row(tree, boxes[1]);
  click_row(tree, boxes[0], Qt::LeftButton, Qt::ControlModifier);
  window.after([&] { press_key(tree, Qt::Key_Delete); });
  CHECK(window.bench().text().count("<static_box") == 1);
  CHECK(window.bench().text().contains("x=\"3\""));
  CHECK(window.bench().undo_name() == "delete 2 things");
  window.after([&] { window.act("undo"); });

  // A robot with its own sensor is the robot.
  click_row(tree, "robot[r1]/sensor[ahead]");
  click_row(tree, "robot[r1]", Qt::LeftButton, Qt::ControlModifier);
  window.after([&] { press_key(tree, Qt::Key_D, Qt::ControlModifier); });
  CHECK(window.bench().text().count("<beam_range") == 2);
  window.after([&] { window.act("undo"); });
  click_row(tree, "robot[r1]/sensor[ahead]");
  click_row(tree, "robot[r1]", Qt::LeftButton, Qt::ControlModifier);
  window.after([&] { press_key(tree, Qt::Key_Delete); });
  CHECK_FALSE(window.bench().text().contains("\"r1\""));
  CHECK(window.bench().undo_name() == "delete r1");
}

TEST_CASE("What is renamed stays chosen and followed, also by undo; a name in use is refused") {
  Room window(kThree);
  auto* tree = world_tree(window);
  auto* properties = window.get<Properties>("properties");
  click_row(tree, "robot[r1]");
  window.act("follow");
  at_dialog("rename_dialog", [](QDialog* dialog) {
    auto* name = dialog->findChild<QLineEdit*>();
    enter(name, "scout");
  });
  window.after([&] { press_key(tree, Qt::Key_F2); });
  CHECK(window.bench().text().contains("id=\"scout\""));
  CHECK(window.bench().undo_name() == "rename r1");
  CHECK(properties->path() == "robot[scout]");
  CHECK(tree->selection() == QStringList{"robot[scout]"});
  CHECK(window->scene().followed() == "robot[scout]");
  window.after([&] { window.act("undo"); });
  CHECK(properties->path() == "robot[r1]");
  CHECK(tree->selection() == QStringList{"robot[r1]"});

  // The same in the form.
  window.after([&] { enter_by_hand(field(window, "id"), "lead"); });
  CHECK(properties->path() == "robot[lead]");
  window.after([&] { enter_by_hand(field(window, "x"), "0.5"); });
  CHECK(window.bench().text().contains("<robot id=\"lead\" team=\"red\" x=\"0.5\">"));
  const QString before = window.bench().text();
  enter_by_hand(field(window, "id"), "r2");
  auto* problem = properties->form().findChild<QLabel*>("id_problem");
  CHECK(wait_for([&] { return problem->text().contains("r2"); }));
  CHECK(problem->isVisible());
  CHECK(window.bench().text() == before);
  CHECK(properties->path() == "robot[lead]");
}

TEST_CASE("A drag and back leaves no entry in the history, and no star") {
  Room window;
  SceneView& scene = window->scene();
  REQUIRE(wait_for([&] { return scene.stage().body_of("obstacle[crate]") != nullptr; }));
  click_at(&scene, pixel_at(window, {1.0, 1.0, 0.1}));
  const auto move = [&](Qt::Key key) { window.after([&] { press_key(&scene, key); }); };
  while (true) {
    QElapsedTimer clock;
    clock.start();
    move(Qt::Key_Right);
    CHECK(window.bench().undo_name() == "move crate");
    CHECK(window->isWindowModified());
    move(Qt::Key_Left);
    REQUIRE(window.bench().text() == kRoom);
    if (clock.elapsed() < History::kMerging_ms) break;
    while (!window.bench().undo_name().isEmpty()) {  // too slow to be one entry: once more
      window.after([&] { window.act("undo"); });
    }
  }
  CHECK(window.bench().undo_name().isEmpty());
  CHECK_FALSE(window->isWindowModified());
}

TEST_CASE("What is locked stays where it is: arrows, drags and G move the others") {
  Room window;
  SceneView& scene = window->scene();
  REQUIRE(wait_for([&] { return scene.stage().body_of("robot[r1]") != nullptr; }));
  click_at(&scene, pixel_at(window, {1.0, 1.0, 0.1}));
  press_key(&scene, Qt::Key_L, Qt::ControlModifier);
  press_key(&scene, Qt::Key_Right);
  press_key(&scene, Qt::Key_G);
  press_key(&scene, Qt::Key_Escape);
  CHECK_FALSE(scene.handle(SceneView::Tool::move));
  click_at(&scene, pixel_at(window, {-1.0, 0.0, 0.05}), Qt::LeftButton, Qt::ShiftModifier);
  window.after([&] { press_key(&scene, Qt::Key_Right); });
  CHECK(window.bench().text().contains("<static_box id=\"crate\" x=\"1\" y=\"1\"/>"));
  CHECK(window.bench().text().contains("x=\"-0.9\""));
  CHECK(window.bench().undo_name() == "move r1");

  // A sensor has no place that arrows could move.
  const QString before = window.bench().text();
  click_row(world_tree(window), "robot[r1]/sensor[ahead]");
  scene.setFocus();
  press_key(&scene, Qt::Key_Right);
  window.after([&] { window.bench().reset(1); });
  CHECK(window.bench().text() == before);
}

TEST_CASE("Home moves the camera in the view only") {
  Room window(kThree);
  SceneView& scene = window->scene();
  click_row(world_tree(window), "robot[r2]");
  scene.camera().distance = 1.0;
  press_key(world_tree(window), Qt::Key_Home);
  CHECK(scene.camera().distance == 1.0);
  CHECK(world_tree(window)->tree()->currentItem() == world_tree(window)->item(""));
  scene.setFocus();
  press_key(&scene, Qt::Key_Home);
  CHECK(scene.camera().distance > 2.0);
}

TEST_CASE("The rows of the tree stay in view, and the current one stays, when the world changes") {
  Window window(world_file("ten_robots"));
  auto* tree = world_tree(window);
  tree->tree()->expandAll();
  click_row(tree, "robot[r9]");
  const int top = tree->tree()->verticalScrollBar()->value();
  REQUIRE(top > 0);
  window.after([&] { window.bench().edit({"robot[r9]/@x=0.3"}, "move"); });
  CHECK(tree->tree()->verticalScrollBar()->value() == top);
  window.after([&] { window.bench().edit({"obstacle[+]=<static_box y=\"2\"/>"}, "add"); });
  CHECK(tree->tree()->verticalScrollBar()->value() == top);
  CHECK(tree->tree()->currentItem() == tree->item("robot[r9]"));
  CHECK(tree->selection() == QStringList{"robot[r9]"});
}

TEST_CASE("A right click opens the editor of an item, in the trees and in the view") {
  Room window;
  auto* tree = world_tree(window);
  const auto edited = [&](const std::function<void()>& click) {
    click();
    QDialog* dialog = window.dialog("element_dialog");
    const QString title = dialog->windowTitle();
    click_on(dialog->findChild<QDialogButtonBox*>("buttons")->button(QDialogButtonBox::Cancel));
    window.await_closed("element_dialog");
    return title;
  };
  CHECK(edited([&] { click_row(tree, "robot[r1]", Qt::RightButton); }) == "Edit r1");
  CHECK(edited([&] { click_row(tree, "robot[r1]/sensor[ahead]", Qt::RightButton); }) ==
        "Edit ahead");
  CHECK(edited([&] { click_row(tree, "robot[r1]/behavior[wander]", Qt::RightButton); }) ==
        "Edit wander");
  CHECK(edited([&] {
          click_at(&window->scene(), pixel_at(window, {1.0, 1.0, 0.1}), Qt::RightButton);
        }) == "Edit crate");

  // On the floor it offers what can be put there.
  const auto is_picked = pick_when_open("floor_menu", "charger");
  click_at(&window->scene(), pixel_at(window, {-1.0, 1.0, 0.0}), Qt::RightButton);
  CHECK(*is_picked);
  QDialog* dialog = window.dialog("element_dialog");
  const double y = dialog->findChild<Form*>("form_charger")->values().at("y").toDouble();
  CHECK(y == Approx(1.0).margin(0.05));
  window.after([&] { Window::press(dialog, QDialogButtonBox::Ok); });
  CHECK(window.bench().text().contains("<charger "));
}

TEST_CASE("The key for menus opens the menu of what is chosen") {
  Room window;
  auto* tree = world_tree(window);
  click_row(tree, "robot[r1]");
  const auto is_picked = pick_when_open("element_menu", "Duplicate");
  window.after([&] {
    QContextMenuEvent wish(QContextMenuEvent::Keyboard, QPoint(5, 5),
                           tree->tree()->mapToGlobal(QPoint(5, 5)));
    QApplication::sendEvent(tree->tree(), &wish);  // which has the keyboard
  });
  CHECK(*is_picked);
  CHECK(tree->item("robot[r3]") == nullptr);
  CHECK(tree->item("robot[r2]"));
}

TEST_CASE("A right click on an item without parameters opens nothing, and says why") {
  Room window;
  click_row(world_tree(window), "robot[r1]/coordinator", Qt::RightButton);
  CHECK(window.said().contains("has no parameters"));
  CHECK(window->findChild<QDialog*>("element_dialog") == nullptr);
}

TEST_CASE("In a team's window the buttons act on the chosen robot, and on none if none is chosen") {
  Room window(kThree);
  auto* red = window.get<WorldTree>("team_tree_red");
  window.get<QDockWidget>("dock_team_red")->raise();
  REQUIRE(wait_for([&] { return red->isVisible() && !red->visibleRegion().isEmpty(); }));
  for (const char* name : {"add_sensor", "behaviors", "coordinator"}) {
    INFO(name);
    window->statusBar()->clearMessage();
    click_on(red->findChild<QPushButton*>(name));
    CHECK(window.said().contains("Select the robot"));
  }
  CHECK(window->findChild<QDialog*>("element_dialog") == nullptr);
  click_row(red, "robot[r1]");
  click_on(red->findChild<QPushButton*>("add_sensor"));
  QDialog* sensor = window.dialog("element_dialog");
  CHECK(sensor->windowTitle() == "New sensor of r1");
  Window::press(sensor, QDialogButtonBox::Cancel);
  window.await_closed("element_dialog");

  // The coordinator that is there can be replaced by another.
  click_on(red->findChild<QPushButton*>("coordinator"));
  QDialog* dialog = window.dialog("element_dialog");
  CHECK(dialog->windowTitle() == "coordinator of r1");
  auto* kinds = dialog->findChild<QListWidget*>("kinds");
  REQUIRE(kinds->isVisible());
  kinds->setCurrentItem(kinds->findItems("fusion_vector_summation", Qt::MatchExactly).front());
  window.after([&] { Window::press(dialog, QDialogButtonBox::Ok); });
  CHECK(window.bench().text().contains("<fusion_vector_summation/>"));
  CHECK_FALSE(window.bench().text().contains("<arbiter_suppression"));
}

TEST_CASE("OK of the behaviours waits for the engine: a second click adds nothing again") {
  Room window;
  click_row(world_tree(window), "robot[r1]");
  window.act("behaviors");
  QDialog* dialog = window.dialog("behaviors_dialog");
  click_on(dialog->findChild<QPushButton*>("add"));
  QPushButton* ok = dialog->findChild<QDialogButtonBox*>("buttons")->button(QDialogButtonBox::Ok);
  window.after([&] {
    QTest::mouseClick(ok, Qt::LeftButton);  // hears nothing of the engine meanwhile
    CHECK_FALSE(ok->isEnabled());
    QTest::mouseClick(ok, Qt::LeftButton);
  });
  window.await_closed("behaviors_dialog");
  CHECK(window.bench().text().count("<avoid_obstacle") == 1);
  window.after([&] { window.act("undo"); });
  CHECK(window.bench().text() == kRoom);
}

TEST_CASE("Coordinators, drives and waypoints are copied, too; each goes where it was") {
  Window window;
  window.open(window.file(R"(<world format="1">
  <arena length="8" width="6"/>
  <obstacles>
    <moving_box id="cart" x="2" y="1"><waypoint x="1" y="1"/><waypoint x="2" y="2"/></moving_box>
  </obstacles>
  <robots>
    <robot id="r1" x="-1">
      <drive><mecanum/></drive>
      <behaviors><wander/></behaviors>
      <coordinator><arbiter_suppression/></coordinator>
    </robot>
    <robot id="r2" x="-2">
      <behaviors><wander/></behaviors>
      <coordinator><fusion_vector_summation/></coordinator>
    </robot>
  </robots>
</world>
)"));
  auto* tree = world_tree(window);
  const auto paste_into_r2 = [&](const QString& path) {
    click_row(tree, path);
    press_key(tree, Qt::Key_C, Qt::ControlModifier);
    click_row(tree, "robot[r2]");
    window.after([&] { press_key(tree, Qt::Key_V, Qt::ControlModifier); });
  };
  paste_into_r2("robot[r1]/coordinator");
  CHECK(window.bench().text().count("<arbiter_suppression") == 2);
  CHECK_FALSE(window.bench().text().contains("<fusion_vector_summation"));
  paste_into_r2("robot[r1]/drive");
  CHECK(window.bench().text().count("<mecanum") == 2);
  click_row(tree, "obstacle[cart]/waypoint[2]");
  window.after([&] { press_key(tree, Qt::Key_D, Qt::ControlModifier); });
  CHECK(window.bench().text().count("<waypoint") == 3);
}
