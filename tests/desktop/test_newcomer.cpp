// What a newcomer met who had only the docs.
#include <QClipboard>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFile>
#include <QKeyEvent>
#include <QLineEdit>
#include <QLocale>
#include <QProgressDialog>
#include <QSlider>
#include <QStyle>

#include "authoring/authoring.h"
#include "control_bar.h"
#include "disk.h"
#include "export/exporter.h"
#include "hands.h"
#include "paint/boxes.h"
#include "scene/scene_view.h"
#include "scene/typed_drag.h"
#include "text/world_editor.h"
#include "world/fan.h"
#include "world/properties.h"

using namespace elsie::desktop;

TEST_CASE("A text with mistakes is saved only when that is agreed, and the star stays right") {
  Room window;
  const QString file = window.bench().file();
  window->arrange("author");
  window.get<QDockWidget>("dock_text")->raise();
  auto* editor = window.get<WorldEditor>("world_editor");
  editor->setFocus();
  editor->go_to(4);
  type_text(editor, "<foo/>");

  bool is_asked = false;
  SECTION("No leaves the file as it is") {
    at_dialog("save_mistakes", [&](QDialog* box) {
      is_asked = true;
      press_key(box, Qt::Key_Escape);
    });
    press_key(editor, Qt::Key_S, Qt::ControlModifier);
    CHECK(is_asked);
    CHECK(bytes_of(file) == kRoom);
    CHECK(window->isWindowModified());
  }
  SECTION("after Yes and undo the star says that the file has something else") {
    at_dialog("save_mistakes", [&](QDialog* box) {
      is_asked = true;
      press_yes(box);
    });
    press_key(editor, Qt::Key_S, Qt::ControlModifier);
    CHECK(is_asked);
    CHECK(bytes_of(file).contains("<foo/>"));
    window.after([&] { press_key(editor, Qt::Key_Z, Qt::ControlModifier); });
    CHECK(window.bench().text() == kRoom);
    CHECK(window->isWindowModified());
    window.answer = MainWindow::Answer::cancel;
    CHECK_FALSE(window->close());
    CHECK(window.asked == 1);
  }
}

TEST_CASE("Of thousands of mistakes the first are listed, and how many more there are") {
  Window window;
  QByteArray text = "<world format=\"1\"><arena length=\"4\" width=\"4\"/><obstacles>\n";
  for (int i = 0; i < 1000; ++i) {
    text += "<static_box x=\"99\"/>\n";
  }
  window.open(window.file((text + "</obstacles></world>\n").constData()));
  auto* list = window.get<QTreeWidget>("problems");
  REQUIRE(list->topLevelItemCount() == 201);
  CHECK(list->topLevelItem(200)->text(0) == "And 800 more.");
  CHECK(window.get<QDockWidget>("dock_problems")->windowTitle() == "Errors (201)");
}

TEST_CASE("A command line that does not repeat the run any more says so") {
  Room window;
  run_until(window, 1.0);
  window.act("copy_command");
  REQUIRE(wait_for([&] { return window.said().startsWith("Copied"); }));
  CHECK_FALSE(window.said().contains("different run"));
  window.after([&] { window.bench().edit({"robot[r1]/@max_speed=0.1"}, "slower"); });
  REQUIRE(window.saved_as(window.bench().file()).isEmpty());
  window.act("copy_command");
  CHECK(wait_for([&] { return window.said().contains("gives a different run"); }));
}

TEST_CASE("Copies stand where nothing is, and are chosen; keys go on with them") {
  Room window;
  window->scene().setFocus();
  auto* authoring = window->findChild<Authoring*>();
  authoring->select({"obstacle[crate]"});
  window.after([&] { press_key(&window->scene(), Qt::Key_D, Qt::ControlModifier); });
  const QStringList first = authoring->selection();
  REQUIRE(first.size() == 1);
  CHECK(first != QStringList{"obstacle[crate]"});
  window.after([&] { press_key(&window->scene(), Qt::Key_D, Qt::ControlModifier); });
  const QStringList second = authoring->selection();
  REQUIRE(second.size() == 1);
  CHECK(second != first);
  const auto at = [&](const QString& path) {
    const auto frame = window->scene().stage().place_of(path);
    REQUIRE(frame);
    return frame->origin;
  };
  const auto a = at("obstacle[crate]"), b = at(first.front()), c = at(second.front());
  CHECK(std::hypot(a.x - b.x, a.y - b.y) > 0.25);
  CHECK(std::hypot(a.x - c.x, a.y - c.y) > 0.25);
  CHECK(std::hypot(c.x - b.x, c.y - b.y) > 0.25);

  // The neighbour, which has another name from then on, is not chosen instead.
  window.after([&] {
    authoring->select(first);
    press_key(&window->scene(), Qt::Key_Delete);
  });
  CHECK(wait_for([&] { return authoring->selection().isEmpty(); }));
  window.bench().undo();
}

TEST_CASE("What was added from the tool bar is deleted by the key") {
  Room window;
  window.get<QLineEdit>("filter")->setFocus();
  auto* dialog = window.dialog_of("add_static");
  window.after([&] { Window::press(dialog, QDialogButtonBox::Ok); });
  window.await_closed("element_dialog");
  activate(window.window());
  REQUIRE(wait_for([&] { return window->scene().hasFocus(); }));
  CHECK(window.bench().text() != kRoom);
  window.after([&] { press_key(&window->scene(), Qt::Key_Delete); });
  CHECK(window.bench().text().count("static_box") == 1);
}

TEST_CASE("A film that is cancelled gives the run back, also one that has ended") {
  Room window;
  window.bench().reset(1);
  window.after([&] { window.bench().edit({"limits/@time=20"}, "shorter"); });
  window.run_to_the_end();
  REQUIRE(wait_for([&] { return window.bench().time_s() > 19.9; }));
  const double until_s = window.bench().time_s();
  auto* exporter = window->findChild<Exporter*>();
  bool has_ended = false;
  QObject::connect(exporter, &Exporter::film_ended, &window.window(),
                   [&](bool) { has_ended = true; });
  exporter->write_film(window.folder() + "/run.avi");
  auto* progress = window.get<QProgressDialog>("film_progress");
  REQUIRE(wait_for([&] { return progress->value() > 3; }));
  QTest::mouseClick(progress->findChild<QPushButton*>(), Qt::LeftButton);
  REQUIRE(wait_for([&] { return has_ended; }));
  CHECK(wait_for([&] { return window->scene().stage().time_s() == until_s; }));
  CHECK(window.bench().time_s() == until_s);
  CHECK(window.bench().run_state() == Workbench::Run::ended);
}

TEST_CASE("A click in the tree chooses; Enter and a double click edit") {
  Room window;
  auto* tree = window.get<WorldTree>("world_tree");
  const auto edited = [&] { return window->findChild<QDialog*>("element_dialog") != nullptr; };
  click_row(tree, "robot[r1]");
  Q_EMIT tree->tree()->itemActivated(tree->item("robot[r1]"), 0);  // as KDE does at one click
  CHECK_FALSE(edited());
  tree->tree()->setFocus();
  press_key(tree, Qt::Key_Return);
  REQUIRE(wait_for(edited));
  window->findChild<QDialog*>("element_dialog")->close();
  REQUIRE(wait_for([&] { return !edited(); }));
  activate(window.window());
  auto* rows = tree->tree()->viewport();
  const QPoint at = tree->tree()->visualItemRect(tree->item("robot[r1]")).center();
  QTest::mouseDClick(window->windowHandle(), Qt::LeftButton, {}, rows->mapTo(&window.window(), at));
  CHECK(wait_for(edited));
}

TEST_CASE("A fan goes from left to right") {
  Fan fan(2);
  fan.findChild<QDoubleSpinBox*>("spread_deg")->setValue(30.0);
  CHECK(fan.headings_deg(0.0) == std::vector<double>{15.0, -15.0});
}

TEST_CASE("A comma that is typed is a decimal point, and refused in a count") {
  QLocale::setDefault(QLocale(QLocale::German));
  NumberBox length;
  length.setRange(0.5, 1000.0);
  for (const char* typed : {"6,5", "6.5"}) {
    length.setValue(1.0);
    length.selectAll();
    QTest::keyClicks(&length, typed);
    CHECK(length.value() == 6.5);
  }
  CountBox count;
  count.setRange(0, 99);
  for (const char* typed : {"1,5", "1.5"}) {
    count.setValue(4);
    count.selectAll();
    QTest::keyClicks(&count, typed);
    QTest::keyClick(&count, Qt::Key_Return);
    CHECK(count.value() != 15);
  }
  QLocale::setDefault(QLocale::c());
  TypedDrag drag;
  drag.begin(Tool::move);
  for (const Qt::Key key : {Qt::Key_6, Qt::Key_Comma, Qt::Key_5}) {
    CHECK(drag.take(QKeyEvent(QEvent::KeyPress, key, Qt::NoModifier)));
  }
  CHECK(drag.number() == 6.5);
}

TEST_CASE("A new window has room on the screen with its frame") {
  const QSize frame(16, 40);
  CHECK(MainWindow::first_size({1280, 800}, frame) == QSize(1264, 760));
  CHECK(MainWindow::first_size({1600, 1000}, frame) == QSize(1280, 800));
  CHECK(MainWindow::first_size({2000, 1000}, frame) == QSize(1900, 950));
}

TEST_CASE("A click in the groove of the time line goes there") {
  Room window;
  window.run_to_the_end();
  auto* slider = window.get<QSlider>("time");
  QTest::mouseClick(slider, Qt::LeftButton, {}, QPoint(slider->width() / 4, slider->height() / 2));
  CHECK(wait_for([&] { return std::abs(window->scene().stage().time_s() - 15.0) < 0.5; }));
}

TEST_CASE("What is no seed is said") {
  Room window;
  auto* seed = window.get<QLineEdit>("seed");
  seed->setFocus();
  for (const char* wrong : {"abc", "12345678901234567890123"}) {
    enter(seed, wrong);
    CHECK(window.said().contains(QString(wrong)));
    CHECK(seed->text() == "1");
  }
}

TEST_CASE("Without a world nothing can be added; a world just made has nothing to save") {
  Window window;
  CHECK_FALSE(window.get<QAction>("add_robot")->isEnabled());
  CHECK_FALSE(window.get<QAction>("undo")->isEnabled());
  window.after([&] { click_on(window.get<QPushButton>("empty_world")); });
  CHECK(window.get<QAction>("add_robot")->isEnabled());
  CHECK_FALSE(window->isWindowModified());
  CHECK(window->close());
  CHECK(window.asked == 0);
  window->show();
  window.after([&] { window.open(window.file("", "empty.xml")); });
  CHECK(window->windowTitle().contains("empty.xml"));
}

TEST_CASE("The window says what it shows: whose coordination, and that the text has mistakes") {
  Room window;
  CHECK(window.get<QDockWidget>("dock_coordination")->windowTitle() == "Coordination of r1");
  window.bench().type(QString(kRoom).replace("<limits", "<foo/><limits"));
  REQUIRE(wait_for([&] { return !window.bench().problems().empty(); }));
  window.bench().run();
  CHECK(wait_for([&] { return window.said().contains("has mistakes"); }));
  window.bench().pause();
}

TEST_CASE("S on a robot says that it has no size, Delete of the world that nothing is chosen") {
  Room window;
  window.choose("robot[r1]");
  window->scene().setFocus();
  press_key(&window->scene(), Qt::Key_S);
  CHECK(window.said().contains("Properties"));
  window.choose("");
  window.act("delete");
  CHECK(window.said().contains("Nothing is selected"));
  CHECK(window.bench().text() == kRoom);
}

TEST_CASE("The menu of the world in the tree offers what has no place, too") {
  Room window;
  const auto is_picked = pick_when_open("floor_menu", "Add goal");
  window->findChild<Authoring*>()->open_menu({}, window->mapToGlobal(QPoint(50, 50)));
  CHECK(*is_picked);
  auto* dialog = window.dialog("element_dialog");
  CHECK(dialog->windowTitle() == "New goal");
}
