// The window as a whole, with the program's own engine: real clicks and key presses.
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QScreen>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

#include <catch2/catch.hpp>

#include "control_bar.h"
#include "hands.h"
#include "text/problems_panel.h"
#include "text/world_editor.h"
#include "world/form.h"
#include "world/properties.h"
#include "world/world_tree.h"

using namespace elsie::desktop;

TEST_CASE("A run in the window has the state hash of the same run headless, also with edits") {
  Room window;
  const QString file = window.bench().file();
  window.after([&] { window.bench().reset(3); });
  window.after([&] { window.bench().edit({"robot[r1]/@heading_deg=20"}, "turn"); });
  const Json end = window.run_to_the_end();
  CHECK(end.at("state_hash").get<std::string>() ==
        headless_hash({file, "--seed", "3", "--set", "robot[r1]/@heading_deg=20"}));
}

TEST_CASE("Start, pause, step and reset") {
  Room window;
  auto* run = window.get<QToolButton>("run");
  CHECK(window.bench().time_s() == 0.0);
  QTest::mouseClick(window.get<QToolButton>("step"), Qt::LeftButton);
  REQUIRE(wait_for([&] { return window.bench().run_state() == Workbench::Run::paused; }));
  CHECK(window.bench().time_s() > 0.0);
  QTest::mouseClick(run, Qt::LeftButton);
  REQUIRE(wait_for([&] { return window.bench().time_s() > 0.2; }));
  QTest::mouseClick(run, Qt::LeftButton);
  REQUIRE(wait_for([&] { return window.bench().run_state() == Workbench::Run::paused; }));
  const double paused_s = window.bench().time_s();
  bool is_answered = false;  // by an engine that has nothing else to say
  window.bench().ask({{"do", "ping"}}, [&](const Json&) { is_answered = true; });
  REQUIRE(wait_for([&] { return is_answered; }));
  CHECK(window.bench().time_s() == paused_s);
  QTest::mouseClick(window.get<QToolButton>("reset"), Qt::LeftButton);
  REQUIRE(wait_for([&] { return window.bench().run_state() == Workbench::Run::ready; }));
  CHECK(wait_for([&] { return window.get<QLabel>("time_s")->text() == "0.00 s"; }));
}

TEST_CASE("The properties of what is chosen are edits with a name that are undone and redone") {
  Room window;
  window.choose("robot[r1]");
  auto* properties = window.get<Properties>("properties");
  REQUIRE(properties->path() == "robot[r1]");
  auto* x = qobject_cast<QLineEdit*>(properties->form().editor("x"));
  REQUIRE(x);
  CHECK(x->text() == "-1");
  x->setFocus();
  x->selectAll();
  window.after([&] {
    QTest::keyClicks(x, "1.25");
    QTest::keyClick(x, Qt::Key_Return);
  });
  CHECK(window.bench().text().contains("x=\"1.25\""));
  CHECK(window.bench().undo_name().contains("set x of r1"));
  CHECK(window->isWindowModified());
  window.after([&] { window.act("undo"); });
  CHECK(window.bench().text() == kRoom);
  CHECK_FALSE(window->isWindowModified());
  window.after([&] { window.act("redo"); });
  CHECK(window.bench().text().contains("x=\"1.25\""));

  SECTION("and a wrong number is refused at the field, with nothing changed") {
    const QString before = window.bench().text();
    enter(x, "1,5");
    CHECK(properties->form().findChild<QLabel*>("x_problem")->text().contains("with a point"));
    CHECK(window.bench().text() == before);
  }
}

TEST_CASE(
    "A robot is added to a team with the button of its window, and gets a sensor and behaviours") {
  Room window;
  auto* blue = window.get<WorldTree>("team_tree_blue");
  window.get<QDockWidget>("dock_team_blue")->raise();
  QTest::mouseClick(blue->findChild<QPushButton*>("add_robot"), Qt::LeftButton);
  auto* robot = window.dialog("element_dialog");
  auto* form = robot->findChild<Form*>("form_robot");
  REQUIRE(form);
  CHECK(qobject_cast<QLineEdit*>(form->editor("id"))->text() == "r2");  // a free one
  form->set_value("id", "b1");
  form->set_value("x", "1");
  window.after([&] { Window::press(robot, QDialogButtonBox::Ok); });
  REQUIRE(blue->item("robot[b1]"));
  CHECK(window.bench().text().contains("team=\"blue\""));
  window.await_closed("element_dialog");

  blue->tree()->setCurrentItem(blue->item("robot[b1]"));
  QTest::mouseClick(blue->findChild<QPushButton*>("add_sensor"), Qt::LeftButton);
  auto* sensor = window.dialog("element_dialog");
  auto* kinds = sensor->findChild<QListWidget*>("kinds");
  kinds->setCurrentItem(kinds->findItems("proximity", Qt::MatchExactly).front());
  QTest::mouseClick(sensor->findChild<QPushButton*>("random_heading"), Qt::LeftButton);
  window.after([&] { Window::press(sensor, QDialogButtonBox::Ok); });
  CHECK(blue->item("robot[b1]/sensor[proximity]"));

  QTest::mouseClick(blue->findChild<QPushButton*>("behaviors"), Qt::LeftButton);
  auto* behaviors = window.dialog("behaviors_dialog");
  auto* pool = behaviors->findChild<QListWidget*>("pool");
  auto* carried = behaviors->findChild<QListWidget*>("carried");
  pool->setCurrentItem(pool->findItems("wander", Qt::MatchExactly).front());
  QTest::mouseClick(behaviors->findChild<QPushButton*>("add"), Qt::LeftButton);
  CHECK(carried->count() == 1);
  QTest::mouseClick(behaviors->findChild<QPushButton*>("take_away"), Qt::LeftButton);
  CHECK(carried->count() == 0);
  pool->setCurrentItem(pool->findItems("wander", Qt::MatchExactly).front());
  QTest::mouseClick(behaviors->findChild<QPushButton*>("add"), Qt::LeftButton);
  CHECK_FALSE(blue->item("robot[b1]/behavior[wander]"));  // OK applies
  window.after([&] { Window::press(behaviors, QDialogButtonBox::Ok); });
  CHECK(blue->item("robot[b1]/behavior[wander]"));
  CHECK(blue->item("robot[b1]/coordinator"));
}

TEST_CASE("OK with a wrong number in a field leaves the dialog open, with the sentence") {
  Room window;
  window.choose("robot[r1]");
  auto* dialog = window.dialog_of("add_sensor");
  auto* yaw = dialog->findChild<QLineEdit*>("yaw_deg");
  REQUIRE(yaw);
  QTest::keyClicks(yaw, "4,5");
  Window::press(dialog, QDialogButtonBox::Ok);
  CHECK(dialog->isVisible());
  CHECK(dialog->findChild<QLabel*>("yaw_deg_problem")->text().contains("with a point"));
  CHECK(window.bench().text() == kRoom);
  yaw->clear();
  QTest::keyClicks(yaw, "45");
  window.after([&] { Window::press(dialog, QDialogButtonBox::Ok); });
  CHECK(window.bench().text().contains("yaw_deg=\"45\""));
}

TEST_CASE("A dialog that edits applies its changes with OK, with Cancel none, or immediately") {
  Room window;
  auto* tree = window.get<WorldTree>("world_tree");
  const auto edit = [&] {
    Q_EMIT tree->edit_wished("robot[r1]/sensor[ahead]");
    return window.dialog("element_dialog");
  };
  QDialog* dialog = edit();
  dialog->findChild<Form*>("form_beam_range")->set_value("max_range", "2");
  Window::press(dialog, QDialogButtonBox::Cancel);
  window.await_closed("element_dialog");
  CHECK(window.bench().text() == kRoom);

  dialog = edit();
  dialog->findChild<Form*>("form_beam_range")->set_value("max_range", "2");
  window.after([&] { Window::press(dialog, QDialogButtonBox::Ok); });
  CHECK(window.bench().text().contains("max_range=\"2\""));
  window.await_closed("element_dialog");

  dialog = edit();
  QTest::mouseClick(dialog->findChild<QAbstractButton*>("apply_immediately"), Qt::LeftButton, {},
                    QPoint(8, 8));
  window.after([&] { dialog->findChild<Form*>("form_beam_range")->set_value("max_range", "3"); });
  CHECK(window.bench().text().contains("max_range=\"3\""));
  Window::press(dialog, QDialogButtonBox::Cancel);
}

TEST_CASE("A thing is chosen by a click in the view, and moved by its handle, also in a run") {
  Room window;
  SceneView& scene = window->scene();
  REQUIRE(wait_for([&] { return scene.stage().body_of("robot[r1]") != nullptr; }));
  const auto at = scene.pixel_of({1.0, 1.0, 0.1});
  REQUIRE(at);
  QTest::mouseClick(&scene, Qt::LeftButton, {}, at->toPoint());
  REQUIRE(window.get<Properties>("properties")->path() == "obstacle[crate]");
  const auto foot = scene.handle(SceneView::Tool::move);
  const auto goal = scene.pixel_of({-1.0, 1.0, 0.0});
  REQUIRE((foot && goal));
  window.step();
  window.after([&] { drag_by_hand(&scene, Qt::LeftButton, foot->toPoint(), goal->toPoint()); });
  REQUIRE(wait_for([&] {
    return std::abs(scene.stage().body_of("obstacle[crate]")->frame.origin.x + 1.0) < 0.05;
  }));
  CHECK(window.bench().undo_name().startsWith("move"));
  window.after([&] { window.act("undo"); });
  CHECK(window.bench().text() == kRoom);
}

TEST_CASE("Text and world change together, and a wrong text leaves the world as it is") {
  Room window;
  auto* editor = window->findChild<WorldEditor*>();
  REQUIRE(editor);
  CHECK(editor->toPlainText() == kRoom);
  window.get<QDockWidget>("dock_text")->raise();
  editor->setFocus();
  editor->go_to(6);
  QTest::keyClick(editor, Qt::Key_Up);
  QTest::keyClick(editor, Qt::Key_End);
  window.after([&] { QTest::keyClicks(editor, "<static_box id='late' y='-1'/>"); });
  CHECK(window.get<WorldTree>("world_tree")->item("obstacle[late]"));
  QTest::keyClicks(editor, "<nonsense/>");
  REQUIRE(wait_for([&] { return !window.bench().problems().empty(); }));
  CHECK(window.bench().problems().front().line == 5);
  CHECK(window.get<WorldTree>("world_tree")->item("obstacle[late]"));
  window.act("undo");
  CHECK(window.bench().problems().empty());
  CHECK_FALSE(editor->toPlainText().contains("nonsense"));
}

TEST_CASE(
    "What is saved runs headless with the same state hash, and nothing unsaved is lost silently") {
  Room window;
  const QString file = window.bench().file();
  window.after([&] { window.bench().edit({"robot[r1]/@heading_deg=30"}, "turn"); });
  window.answer = MainWindow::Answer::cancel;
  CHECK_FALSE(window->close());
  CHECK(window.asked == 1);
  window.act("save");
  REQUIRE(wait_for([&] { return !window->isWindowModified(); }));
  CHECK(window->close());
  CHECK(window.asked == 1);
  window->show();
  CHECK(window.hash_at_the_end() == headless_hash({file}));
}

TEST_CASE("Without a world, only what needs none can be done") {
  Window window;
  const QSet<QString> need_none{
      "new",           "open",
      "quit",          "layout_author",
      "layout_watch",  "layout_train",
      "layout_reset",  "next_dock",
      "commands",      "keys",
      "shortcuts",     "about",
      "tutorial",      "show_trails",
      "show_sketches", "show_names",
      "show_grid",     "show_status_bar",
      "theme_system",  "theme_light",
      "theme_dark",    "language_system",
      "language_en",   "language_de",
      "context_menu",  "stop_engine"};  // a library may never finish loading
  QSet<QString> enabled;
  int count = 0;
  const auto look = [&] {
    enabled.clear();
    count = 0;
    for (const QAction* each : window->findChildren<QAction*>(Qt::FindDirectChildrenOnly)) {
      if (each->objectName().isEmpty()) continue;
      ++count;
      if (each->isEnabled()) enabled << each->objectName();
    }
  };
  look();
  CHECK(count > 60);
  CHECK((enabled - need_none).values().join(' ').toStdString() == "");
  CHECK((need_none - enabled).values().join(' ').toStdString() == "");
  for (const char* button : {"run", "step", "reset", "boxes"}) {
    CHECK_FALSE(window.get<QToolButton>(button)->isEnabled());
  }
  for (const char* harmless :
       {"layout_watch", "layout_author", "layout_reset", "next_dock", "show_grid", "show_grid"}) {
    window.act(harmless);
  }

  window.open(window.file(kRoom));
  look();
  CHECK(enabled.size() == count - 2);  // nothing to undo or redo
  CHECK(window.get<QToolButton>("boxes")->isEnabled());

  // A text that is no world can be saved, and nothing else be done with it.
  window.open(window.file("<world", "broken.xml"));
  CHECK(window.get<QLabel>("outcome")->text() == "no world");
  look();
  CHECK((enabled - need_none) == QSet<QString>{"save", "save_as", "start_page", "next_problem"});
}

TEST_CASE("A new seed asks before it ends a run that is under way") {
  Room window;
  auto* seed = window.get<QLineEdit>("seed");
  window.after([&] { enter(seed, "5"); });  // nothing is lost with it
  CHECK(window.bench().seed() == 5);
  window.step();
  int asked = 0;
  const auto answer = [&](QMessageBox::StandardButton button) {
    at_dialog("new_seed", [&asked, button](QDialog* box) {
      ++asked;
      CHECK(qobject_cast<QMessageBox*>(box)->text().contains("with seed 6"));
      qobject_cast<QMessageBox*>(box)->button(button)->click();
    });
  };
  answer(QMessageBox::No);
  enter(seed, "6");
  CHECK(asked == 1);
  CHECK(seed->text() == "5");
  CHECK(window.bench().seed() == 5);
  CHECK(window.bench().run_state() == Workbench::Run::paused);
  answer(QMessageBox::Yes);
  window.after([&] { enter(seed, "6"); });
  CHECK(asked == 2);
  CHECK(window.bench().seed() == 6);
  CHECK(window.bench().time_s() == 0.0);
}

TEST_CASE("When the user stops the engine, the world and its unsaved changes stay") {
  Room window;
  window.after([&] { window.bench().edit({"robot[r1]/@heading_deg=30"}, "turn"); });
  const QString text = window.bench().text();
  QString report;
  QObject::connect(&window.bench(), &Workbench::engine_lost, &window.window(),
                   [&](const QString& said) { report = said; });
  window.bench().run();
  window.act("stop_engine");
  REQUIRE(wait_for(
      [&] { return !report.isEmpty() && window.bench().run_state() == Workbench::Run::ready; }));
  CHECK(window.bench().text() == text);
  CHECK(window->isWindowModified());
  const auto* box = window->findChild<QMessageBox*>("engine_lost");
  REQUIRE(box);
  CHECK(box->text().startsWith("You stopped the engine."));
  CHECK(box->windowTitle() == "The engine was stopped");
  CHECK(box->icon() == QMessageBox::Information);
  CHECK_FALSE(box->informativeText().contains("exit code"));
  window.after([&] { window.act("undo"); });  // the texts lead back
  CHECK(window.bench().text() == kRoom);
}

TEST_CASE("Errors of other files are listed, and not marked in the text of the world") {
  Window window;
  window.file("<robot_template format=\"1\"\n speed=\"0.2\"/>", "part.xml");
  window.open(
      window.file(QString(kRoom).replace("id=\"r1\"", "id=\"r1\" template=\"part.xml\"").toUtf8()));
  REQUIRE(window.bench().problems().size() == 1);
  CHECK(window.bench().problems().front().file.endsWith("part.xml"));
  auto* list = window->findChild<ProblemsPanel*>()->findChild<QTreeWidget*>("problems");
  CHECK(list->topLevelItemCount() == 1);
  CHECK(window.get<WorldEditor>("world_editor")->extraSelections().size() == 1);  // the cursor's
}

TEST_CASE("The errors panel has the warnings of elsie check") {
  Room window;
  auto* list = window->findChild<ProblemsPanel*>()->findChild<QTreeWidget*>("problems");
  CHECK(list->topLevelItemCount() == 0);
  window.after([&] { window.bench().edit({"physics/@cfm=0"}, "stiff"); });
  REQUIRE(list->topLevelItemCount() == 1);
  CHECK(list->topLevelItem(0)->text(0).startsWith("Warning"));
  CHECK(list->topLevelItem(0)->text(0).contains("cfm"));
  window.after([&] { window.act("undo"); });
  CHECK(list->topLevelItemCount() == 0);
}

TEST_CASE("The windows of teams come back as they were left, and go with their world") {
  const QString green = QString(kRoom)
                            .replace("team=\"red\"", "team=\"green\"")
                            .replace("<robots>", "<teams><team id=\"green\"/></teams><robots>");
  const auto dock = [](Window& window) {
    return window->findChild<QDockWidget*>("dock_team_green");
  };
  {
    Window window;
    window.open(window.file(green.toUtf8()));
    REQUIRE(window.bench().is_right());
    REQUIRE(dock(window));
    dock(window)->setFloating(true);
    dock(window)->resize(333, 222);
    CHECK(window->close());
  }
  Window window;
  window.open(window.file(green.toUtf8()));
  REQUIRE(dock(window));
  CHECK(dock(window)->isFloating());
  window.after([&] { window.open(window.file(kRoom, "other.xml")); });
  CHECK(wait_for([&] { return !dock(window); }));
  CHECK(window->findChild<QDockWidget*>("dock_team_red"));
  window.act("layout_reset");
  window->close();
}

TEST_CASE("A floating window whose title is off the screen comes back") {
  const QRect screen = QApplication::primaryScreen()->availableGeometry();
  for (const QPoint place : {QPoint(screen.right(), 100), QPoint(100, screen.top() - 200),
                             QPoint(100, screen.bottom())}) {
    {
      Window window;
      auto* dock = window.get<QDockWidget>("dock_sensors");
      dock->show();
      dock->setFloating(true);
      dock->resize(300, 200);
      dock->move(place);
      CHECK(window->close());
    }
    Window window;
    auto* dock = window.get<QDockWidget>("dock_sensors");
    REQUIRE(dock->isFloating());
    const QRect title(dock->frameGeometry().topLeft(), QSize(dock->frameGeometry().width(), 20));
    const QRect seen = title & screen;
    CHECK(seen.width() > 50);
    CHECK(seen.height() > 10);
    window.act("layout_reset");
    window->close();
  }
}

TEST_CASE("A plugin that is reloaded is in the view at once, and its mistakes are errors") {
  QTemporaryDir folder;
  const QString source = folder.filePath("veer.cpp");
  const auto write = [&](const QByteArray& rate) {
    std::ofstream(source.toStdString()) << R"(#include <elsie/api/behavior.h>
namespace {
class Veer final : public elsie::Behavior {
 public:
  elsie::Response respond(const elsie::Perception& now) override {
    return now.self().wheels.motion({)" << rate.toStdString()
                                        << R"(, 3.0});
  }
};
}  // namespace
ELSIE_BEHAVIOR(Veer, "veer", "Veers");
)";
  };
  write("3.0");
  Window window({}, {"--plugin", source});
  window.open(window.file(QString(kRoom).replace("<wander/>", "<veer/>").toUtf8()));
  REQUIRE(window.bench().is_right());
  const std::uint64_t epoch = window.bench().epoch();
  write("2.0");
  REQUIRE(wait_for([&] { return window.bench().epoch() > epoch; }));
  const Stage& stage = window->scene().stage();
  const double x = stage.body_of("robot[r1]")->frame.origin.x;
  window.get<QToolButton>("run")->click();
  CHECK(wait_for([&] { return stage.body_of("robot[r1]")->frame.origin.x != x; }));

  write("no_such_rate");
  auto* list = window->findChild<ProblemsPanel*>()->findChild<QTreeWidget*>("problems");
  REQUIRE(wait_for([&] { return list->topLevelItemCount() == 1; }));
  CHECK(list->topLevelItem(0)->text(0).contains("no_such_rate"));
  CHECK(window.get<QDockWidget>("dock_problems")->isVisible());
  write("1.0");
  CHECK(wait_for([&] { return list->topLevelItemCount() == 0; }));
}
