// What is done with the selection: clipboard, copies, menus, in a window with an engine.
#include <QClipboard>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>

#include <catch2/catch.hpp>

#include "authoring/authoring.h"
#include "authoring/pieces.h"
#include "hands.h"
#include "scene/scene_view.h"
#include "world/element_dialog.h"
#include "world/form.h"
#include "world/properties.h"
#include "world/world_tree.h"

using namespace elsie::desktop;

namespace {

void choose(Window& window, const QStringList& paths) {
  auto* tree = window.get<WorldTree>("world_tree");
  tree->tree()->clearSelection();
  for (const QString& path : paths) {
    REQUIRE(tree->item(path));
    tree->item(path)->setSelected(true);
  }
}

}  // namespace

TEST_CASE("A copy that is made in a run is put where nothing stands, and where nothing begins") {
  Room window;
  run_until(window, 5.0);
  const auto& now = window->scene().stage().body_of("robot[r1]")->frame.origin;
  REQUIRE(std::hypot(now.x + 1.0, now.y) > 0.4);  // its first place is free
  choose(window, {"robot[r1]"});
  window.after([&] { window.act("duplicate"); });
  CHECK(window.get<WorldTree>("world_tree")->item("robot[r2]"));
}

TEST_CASE("Pieces of a world are told apart, with their attributes") {
  const auto pieces = pieces_of("<robot id='r1' x=\"1\">\n  <sensors/>\n</robot>\n <charger/>");
  REQUIRE(pieces.size() == 2);
  CHECK(pieces[0].name == "robot");
  CHECK(pieces[0].markup == "<robot id='r1' x=\"1\">\n  <sensors/>\n</robot>");
  CHECK(pieces[1].markup == "<charger/>");
  CHECK(attribute_of(pieces[0], "id") == "r1");
  CHECK(attribute_of(pieces[0], "x") == "1");
  CHECK(attribute_of(pieces[1], "x").isEmpty());
  CHECK(with_attribute(pieces[1], "x", "0.3") == "<charger x=\"0.3\"/>");
  CHECK(with_attribute(pieces[0], "id", {}).startsWith("<robot x=\"1\">"));
  CHECK(with_attribute({"a", "<a b=\"x>y\" c=\"1\"/>"}, "c", "2") == "<a b=\"x>y\" c=\"2\"/>");
  CHECK(pieces_of("no XML <at all").empty());
  CHECK(pieces_of("").empty());
}

TEST_CASE("Several things are chosen, copied, pasted and deleted, each as one edit") {
  Room window;
  choose(window, {"obstacle[crate]", "robot[r1]"});
  window.act("copy");
  window.after([&] { window.act("paste"); });
  auto* tree = window.get<WorldTree>("world_tree");
  CHECK(tree->item("robot[r2]"));
  CHECK(tree->item("robot[r2]/sensor[ahead]"));
  CHECK(window.bench().undo_name() == "paste");
  CHECK(window.bench().text().contains("x=\"1.3\""));
  window.after([&] { window.act("undo"); });
  CHECK(window.bench().text() == kRoom);

  choose(window, {"obstacle[crate]", "robot[r1]"});
  window.after([&] { window.act("duplicate"); });
  CHECK(tree->item("robot[r2]"));
  CHECK(window.bench().undo_name() == "duplicate");
  window.after([&] { window.act("undo"); });

  choose(window, {"obstacle[crate]", "robot[r1]"});
  window.after([&] { window.act("delete"); });
  CHECK_FALSE(tree->item("robot[r1]"));
  CHECK_FALSE(tree->item("obstacle[crate]"));
  window.after([&] { window.act("undo"); });
  CHECK(window.bench().text() == kRoom);
}

TEST_CASE("A behaviour is copied from one robot to another") {
  Room window;
  choose(window, {"robot[r1]"});
  window.after([&] { window.act("duplicate"); });
  choose(window, {"robot[r1]/sensor[ahead]"});
  window.act("copy");
  choose(window, {"robot[r2]"});
  window.after([&] { window.act("paste"); });
  CHECK(window.get<WorldTree>("world_tree")->item("robot[r2]/sensor[beam_range]"));
}

TEST_CASE("What cannot be pasted is named, and changes nothing") {
  Room window;
  const auto paste = [&](const QString& text) {
    QApplication::clipboard()->setText(text);
    window.act("paste");
    return window.said();
  };
  CHECK(paste("a letter <to").contains("nothing to paste"));
  CHECK(paste("<letter/>").contains("'letter' is not an element"));
  choose(window, {});
  CHECK(paste("<wander/>").contains("Select the robot"));
  CHECK(window.bench().text() == kRoom);
  CHECK(window.bench().undo_name().isEmpty());
}

TEST_CASE("A robot begins where it is now") {
  Room window;
  window.run_past(5.0);
  choose(window, {"robot[r1]"});
  const double x = window->scene().stage().body_of("robot[r1]")->frame.origin.x;
  window.after([&] { window.act("start_pose"); });
  CHECK_FALSE(window.bench().text().contains("x=\"-1\""));
  window.after([&] { window.bench().reset(1); });
  REQUIRE(wait_for([&] {
    const Stage::Body* body = window->scene().stage().body_of("robot[r1]");
    return body && std::abs(body->frame.origin.x - x) < 0.002;
  }));
}

TEST_CASE("A new robot stands where nothing is, now and at the start") {
  Room window(QString(kRoom).replace("x=\"-1\"", "x=\"0\""));
  run_until(window, 5.0);  // r1 has left the middle
  QDialog* dialog = window.dialog_of("add_robot");
  window.after([&] { Window::press(dialog, QDialogButtonBox::Ok); });
  window.await_closed("element_dialog");
  CHECK(window.bench().text().contains("<robot id=\"r2\""));
}

TEST_CASE("A refusal about a world without a file names the line, and no file") {
  Window window;
  window.open_text(kRoom);
  Problems said;
  window.bench().edit({"robot[+]=<robot id=\"r2\" x=\"-1\"/>"}, "add", {}, &window.window(),
                      [&](const Problems& problems) { said = problems; });
  REQUIRE(wait_for([&] { return !said.empty(); }));
  CHECK(said.front().message.contains("overlaps"));
  CHECK_FALSE(said.front().message.contains("(:"));
}

TEST_CASE("After a run has ended, its last pose can be made the start") {
  Room window(QString(kRoom).replace("time=\"60\"", "time=\"2\""));
  window.run_to_the_end();
  window.choose("robot[r1]");
  REQUIRE(wait_for(
      [&] { return window->scene().stage().body_of("robot[r1]")->frame.origin.x != -1.0; }));
  const double x = window->scene().stage().body_of("robot[r1]")->frame.origin.x;
  window.after([&] { window.act("start_pose"); });
  const ElementPlace robot = place_of(window.bench().tree(), "robot[r1]");
  REQUIRE(robot.element);
  CHECK(attribute(*robot.element, "x").toDouble() == Approx(x).margin(0.002));
}

TEST_CASE("A copy of a robot keeps its template") {
  Window window;
  window.open(world_file("ten_robots"));
  choose(window, {"robot[r1]"});
  window.after([&] { window.act("duplicate"); });
  CHECK(window.bench().text().contains(QRegularExpression(
      "\n    <robot id=\"r11\" [^>]*template=\"../robots/scout.xml\"[^>]*/>\n  </robots>")));
  CHECK(window.get<WorldTree>("world_tree")->item("robot[r11]/sensor[front_left]"));
}

TEST_CASE("A list in the tree shows what it holds, and adds to it") {
  Room window;
  auto* tree = window.get<WorldTree>("world_tree");
  const auto choose_list = [&](const QString& member) {
    QTreeWidgetItem* list = tree->item(member)->parent();
    tree->tree()->setCurrentItem(list);
  };
  auto* properties = window->findChild<Properties*>();
  const auto title = [&] { return properties->findChild<QLabel*>("title")->text(); };
  auto* add = properties->findChild<QPushButton*>("add_to_list");
  CHECK_FALSE(add->isVisible());
  choose_list("robot[r1]/sensor[ahead]");
  CHECK(title() == "sensors of r1");
  CHECK(properties->form().values().empty());
  CHECK_FALSE(properties->form().editor("format"));  // that is the world's
  REQUIRE(add->isVisible());
  CHECK(add->text() == "Add sensor...");
  QTest::mouseClick(add, Qt::LeftButton);
  Window::press(window.dialog("element_dialog"), QDialogButtonBox::Cancel);
  window.await_closed("element_dialog");
  choose_list("robot[r1]");
  CHECK(title() == "robots");
  CHECK(add->text() == "Add robot...");
  QTest::mouseClick(add, Qt::LeftButton);
  window.after([&] { Window::press(window.dialog("element_dialog"), QDialogButtonBox::Ok); });
  REQUIRE(wait_for([&] { return title() == "r2"; }));  // what was added is chosen
  CHECK_FALSE(add->isVisible());

  // A list that goes with an undo is shown no more.
  choose_list("robot[r1]/behavior[wander]");
  CHECK(title() == "behaviors of r1");
  window.after([&] { window.bench().edit({"robot[r1]/@remove=true"}, "remove"); });
  CHECK_FALSE(title().contains("behaviors"));
  CHECK_FALSE(add->isVisible());
}

TEST_CASE("A second wish to edit an element raises the dialog that is open") {
  Room window;
  auto* authoring = window->findChild<Authoring*>();
  const auto shown = [&] {
    const auto all = window->findChildren<QDialog*>();
    return std::count_if(all.begin(), all.end(), std::mem_fn(&QWidget::isVisible));
  };
  authoring->edit_element("robot[r1]");
  QDialog* robot = window.dialog("element_dialog");
  authoring->edit_element("robot[r1]/sensor[ahead]");
  CHECK(shown() == 2);  // of another element
  activate(window.window());
  CHECK_FALSE(robot->isActiveWindow());
  authoring->edit_element("robot[r1]");
  CHECK(shown() == 2);
  CHECK(wait_for([&] { return robot->isActiveWindow(); }));
  authoring->add_element("robot[r1]", "coordinator");
  authoring->edit_element("robot[r1]/coordinator");
  authoring->add_element("robot[r1]", "coordinator");
  CHECK(shown() == 3);
  authoring->edit_behaviors("robot[r1]");
  authoring->edit_behaviors("robot[r1]");
  CHECK(shown() == 4);
  SECTION("also under its new name") {
    window.after([&] { window.bench().edit({"robot[r1]/@id=rob"}, "rename"); });
    authoring->edit_element("robot[rob]");
    authoring->add_element("robot[rob]", "coordinator");
    authoring->edit_behaviors("robot[rob]");
    CHECK(shown() == 4);
  }
  SECTION("but not for another world, which closes them") {
    window.open(window.file(kRoom, "other.xml"));
    CHECK(shown() == 0);
  }
}

TEST_CASE("The menu of an element offers to duplicate it only if the world may have another") {
  Room window;
  auto* authoring = window->findChild<Authoring*>();
  const auto offers = [&](const char* path) {
    return offered_by([&] { authoring->open_menu(path, window->pos()); })
        .entries.contains("Duplicate");
  };
  for (const char* one : {"obstacle[crate]", "robot[r1]", "robot[r1]/sensor[ahead]"}) {
    INFO(one);
    CHECK(offers(one));
  }
  for (const char* only : {"arena", "limits", "robot[r1]/coordinator"}) {
    INFO(only);
    CHECK_FALSE(offers(only));
  }
}
