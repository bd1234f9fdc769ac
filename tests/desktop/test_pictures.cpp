// Pictures of every window, for docs and for eyes: scripts/desktop-pictures. Hidden from ordinary
// runs.
#include <QComboBox>
#include <QDockWidget>
#include <QListWidget>
#include <QMenuBar>
#include <QMessageBox>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabWidget>
#include <QTreeWidget>

#include <catch2/catch.hpp>

#include "control_bar.h"
#include "engine/recovery.h"
#include "export/exporter.h"
#include "export/sharer.h"
#include "hands.h"
#include "inferring.h"
#include "paint/figures.h"
#include "scene/scene_view.h"
#include "training/learning_curve.h"
#include "watch/plots_panel.h"
#include "watch/vision_panel.h"
#include "world/form.h"

using namespace elsie::desktop;

namespace {

void keep(QWidget& widget, const QString& name) {
  QTest::qWait(300);  // for animations of docks
  const QString folder = qEnvironmentVariable("ELSIE_PICTURES", ".");
  CHECK(widget.grab().save(folder + '/' + name + ".png"));
}

/// A picture of the window at rest, and one from above of the same instant.
void keep(Window& window, const QString& name) {
  const SceneView& scene = window->scene();
  if (scene.isVisible() && !scene.stage().is_empty()) {
    REQUIRE(wait_for([&] { return scene.photograph().is_finished(); }));
    auto* exporter = window->findChild<Exporter*>();
    bool is_drawn = false;
    const auto connection = QObject::connect(exporter, &Exporter::picture_ended,
                                             [&](bool is_right) { is_drawn = is_right; });
    const QDir folder(qEnvironmentVariable("ELSIE_PICTURES", "."));
    exporter->write_from_above(folder.filePath("above_" + name + ".png"), {.size = {1000, 0}});
    CHECK(wait_for([&] { return is_drawn; }));
    QObject::disconnect(connection);
    window->statusBar()->clearMessage();
  }
  keep(window.window(), name);
}

/// A picture of each menu of the window, as it drops down.
void keep_menus(Window& window) {
  int number = 0;
  for (const QAction* each : window->menuBar()->actions()) {
    each->menu()->popup(window->mapToGlobal(QPoint(0, 20)));
    keep(*each->menu(), "menu_" + QString::number(++number));
    each->menu()->hide();
  }
}

void resize(Window& window) {
  const QStringList size = qEnvironmentVariable("ELSIE_PICTURE_SIZE", "1280x800").split('x');
  window->resize(size[0].toInt(), size[1].toInt());
  window->scene().photograph().set_finest(elsie::render::kFinished);
  window->arrange("author");
}

void play_until(Window& window, double time_s) {
  window.bench().set_speed(4.0);
  window.bench().run();
  REQUIRE(wait_for([&] {
    return window.bench().time_s() > time_s || window.bench().run_state() == Workbench::Run::ended;
  }));
  window.bench().pause();
  wait_for([&] { return window.bench().run_state() != Workbench::Run::running; });
}

void keep_dialog(Window& window, const char* action, const QString& name) {
  window.act(action);
  QDialog* dialog = window.any_dialog();
  keep(*dialog, name);
  if (auto* tabs = dialog->findChild<QTabWidget*>("pages"); tabs && tabs->count() > 1) {
    tabs->setCurrentIndex(tabs->count() - 1);
    keep(*dialog, name + "_last_page");
  }
  dialog->reject();
  REQUIRE(wait_for([&] { return window->findChildren<QDialog*>().isEmpty(); }));
}

/// A picture of the modal dialog that comes next, which is then closed.
void keep_modal(const QString& name, const std::function<void(QDialog*)>& close) {
  auto* waiting = new QTimer(qApp);
  QObject::connect(waiting, &QTimer::timeout, waiting, [=] {
    if (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) {
      waiting->stop();
      waiting->deleteLater();
      keep(*dialog, name);
      close(dialog);
    }
  });
  waiting->start(20);
}

}  // namespace

TEST_CASE("Pictures: the start page", "[.pictures]") {
  Window window;
  resize(window);
  auto* examples = window.get<QListWidget>("examples");
  REQUIRE(wait_for(
      [&] { return !examples->item(examples->count() - 1)->icon().availableSizes().isEmpty(); }));
  keep(window.window(), "start");
}

TEST_CASE("Pictures: a world being built, and watched", "[.pictures]") {
  Window window(world_file("ten_robots"));
  resize(window);
  play_until(window, 12.0);
  window.choose(window->scene().stage().bodies().front().path);
  keep(window, "author");
  window->arrange("watch");
  show_dock(window.window(), "dock_fuzzy");
  window.bench().run();
  auto* fuzzy = window->findChild<FuzzyPanel*>();
  wait_for([&] { return !fuzzy->now().degrees.empty(); });
  window.bench().pause();
  keep(window, "fuzzy");
  window.get<QDockWidget>("dock_sensors")->raise();
  keep(window, "sensors");
  window->arrange("author");
  window.get<QDockWidget>("dock_text")->raise();
  keep(window, "text");
}

TEST_CASE("Pictures: cameras and plots", "[.pictures]") {
  Window window(world_file("four_resources"));
  resize(window);
  window->arrange("watch");
  auto* plots = window->findChild<PlotsPanel*>();
  window.get<QDockWidget>("dock_plots")->raise();
  play_until(window, 1.0);
  for (const QString& name : plots->names()) {
    if (name.count('/') == 1 && (name.endsWith("/speed") || name.endsWith("/energy"))) {
      plots->choose(name, true);
    }
  }
  play_until(window, 15.0);
  keep(window, "watch");
}

TEST_CASE("Pictures: a run at greatest speed", "[.pictures]") {
  Window window(world_file("layers"));
  resize(window);
  window->scene().look(OrbitCamera::kFromTop);
  window.get<QDockWidget>("dock_coordination")->raise();
  window.run_to_the_end();
  keep(window, "fast_coordination");
  window.get<QDockWidget>("dock_plots")->raise();
  auto* plots = window->findChild<PlotsPanel*>();
  const QString robot = robot_id(window->scene().stage().bodies().front().path);
  REQUIRE(wait_for([&] { return plots->names().contains(robot + "/speed"); }));
  plots->choose(robot + "/speed", true);
  plots->choose(robot + "/asked/turn", true);
  REQUIRE(wait_for([&] { return !plots->sampling().startsWith("0 "); }));
  keep(window, "fast_plots");
  plots->choose(robot + "/speed", false);
  plots->choose(robot + "/asked/turn", false);
}

TEST_CASE("Pictures: dialogs", "[.pictures]") {
  Window window(world_file("learned_priorities"));
  resize(window);
  const QString robot = window->scene().stage().bodies().front().path;
  window.choose(robot);
  keep_dialog(window, "add_robot", "dialog_robot");
  keep_dialog(window, "add_sensor", "dialog_sensor");
  keep_dialog(window, "behaviors", "dialog_behaviours");
  keep_dialog(window, "coordinator", "dialog_coordinator");
  keep_dialog(window, "physics", "dialog_physics");
  keep_dialog(window, "add_moving", "dialog_moving_box");
}

TEST_CASE("Pictures: obstacles of all forms", "[.pictures]") {
  Window window(world_file("shapes"));
  resize(window);
  window.choose("obstacle[hexagon]");
  keep(window, "shapes");
  keep_dialog(window, "add_prism", "dialog_prism");
}

TEST_CASE("Pictures: errors, teams, keys and the new world", "[.pictures]") {
  Window window;
  resize(window);
  window.after([&] { window.act("new"); });
  resize(window);
  keep(window, "new_world");
  keep_dialog(window, "shortcuts", "dialog_keys");
  window.open(
      window.file("<world format=\"1\">\n  <robots>\n    <robot id=\"a\" speed=\"1\"/>\n"
                  "    <robot id=\"b\" x=\"left\"/>\n  </robots>\n</world>\n"));
  resize(window);
  window.get<QDockWidget>("dock_problems")->raise();
  keep(window, "errors");
  window.open(world_file("ten_robots"));
  REQUIRE(wait_for([&] { return window.bench().is_right(); }));
  window.get<QDockWidget>("dock_team_red")->raise();
  keep(window, "team");
}

TEST_CASE("Pictures: behaviours in use, and the past", "[.pictures]") {
  Window window(world_file("clutter"));
  resize(window);
  window.get<QDockWidget>("dock_coordination")->raise();
  play_until(window, 10.0);
  keep(window, "behaviours");
  window.get<QWidget>("time")->setFocus();
  press_key(&window.window(), Qt::Key_Left, Qt::ShiftModifier);
  REQUIRE(wait_for([&] { return window->scene().stage().is_past(); }));
  keep(window, "past");
}

TEST_CASE("Pictures: when a plugin ends the engine, and after a crash", "[.pictures]") {
  Room window;
  resize(window);
  window.after([&] { window.bench().edit({"robot[r1]/@x=0.3"}, "move r1"); });
  window.act("stop_engine");
  keep(*window.dialog<QMessageBox>("engine_lost"), "engine_lost");
  window.dialog<QMessageBox>("engine_lost")->close();

  Recovery().keep({"/home/you/worlds/maze.xml", kRoom});  // as a window leaves it that crashes
  at_dialog("recovered", [](QDialog* dialog) {
    keep(*dialog, "recovered");
    qobject_cast<QMessageBox*>(dialog)->button(QMessageBox::Yes)->click();
  });
  window->offer_recovered();
  REQUIRE(wait_for([&] { return window.bench().is_right(); }));
  keep(window, "recovered_window");
}

TEST_CASE("Pictures: an automaton", "[.pictures]") {
  Window window(world_file("guard"));
  resize(window);
  window.choose(window->scene().stage().bodies().front().path);
  show_dock(window.window(), "dock_graph");
  play_until(window, 6.0);
  keep(window, "graph");
}

TEST_CASE("Pictures: messages, and a run that goes on", "[.pictures]") {
  Window window(world_file("flock"));
  resize(window);
  show_dock(window.window(), "dock_sensors");
  play_until(window, 3.0);
  keep(window, "messages");
  window.bench().set_speed(1.0);
  window.bench().run();
  REQUIRE(wait_for([&] { return window.bench().time_s() > 4.0; }));
  keep(window.window(), "running");
  window.bench().pause();
}

TEST_CASE("Pictures: menus, keys, commands and About", "[.pictures]") {
  Window window(world_file("clutter"));
  resize(window);
  keep_menus(window);
  for (const auto& [action, name] :
       {std::pair{"keys", "box_keys"}, {"about", "box_about"}, {"commands", "box_commands"}}) {
    keep_modal(name, [](QDialog* dialog) { dialog->reject(); });
    window.act(action);
  }
}

TEST_CASE("Pictures: questions about unsaved work and files", "[.pictures]") {
  {
    MainWindow plain(build_file("elsie"), {});
    plain.show();
    plain.workbench().open_text(kRoom, {}, false);
    REQUIRE(wait_for([&] { return plain.workbench().is_right(); }));
    keep_modal("box_unsaved", [](QDialog* dialog) { dialog->reject(); });
    CHECK_FALSE(plain.close());
    plain.workbench().give_up_unsaved();
  }
  Room window;
  const QString file = window.bench().file();
  resize(window);
  window.after([&] { window.bench().edit({"robot[r1]/@x=0.3"}, "move r1"); });
  window.file(QByteArray(kRoom).replace("a room", "their room"));
  keep(*window.dialog<QMessageBox>("changed_on_disk"), "box_changed_on_disk");
  window.dialog<QMessageBox>("changed_on_disk")->reject();
  keep_modal("box_write_over", [](QDialog* dialog) { dialog->reject(); });
  window.act("save");
  window.bench().type(QString(kRoom).replace("<limits", "<limit"));
  REQUIRE(wait_for([&] { return !window.bench().problems().empty(); }));
  keep_modal("box_mistakes", [](QDialog* dialog) { dialog->reject(); });
  window.act("save");
  REQUIRE(QFile::remove(file));
  REQUIRE(wait_for([&] { return window.bench().is_gone_from_disk(); }));
  keep(window, "gone_from_disk");
}

TEST_CASE("Pictures: a weight that is learned, a control surface, and figures as a table",
          "[.pictures]") {
  Window window(world_file("learned_priorities"));
  resize(window);
  QString behavior;
  visit(window.bench().tree(), [&](const ElementPlace& place) {
    if (behavior.isEmpty() && place.path.contains("/behavior[")) behavior = place.path;
    return behavior.isEmpty();
  });
  window.choose(behavior);
  play_until(window, 2.0);
  keep(window, "live_weight");

  window.open(world_file("clutter"));
  FuzzyPanel* const fuzzy = inferring(window);
  auto* bar = fuzzy->findChild<QScrollArea*>()->verticalScrollBar();
  REQUIRE(wait_for([&] {
    bar->setValue(bar->maximum());
    return bar->value() > 0;
  }));
  keep(window, "control_surface");
  show_figures(window.get<QWidget>("fuzzy_page"));
  keep(*window.dialog("figures_dialog"), "as_a_table");
}

TEST_CASE("Pictures: a network that learns, a film that is written, and runs to choose from",
          "[.pictures]") {
  Window window(world_file("four_resources"));
  resize(window);
  window.choose(window->scene().stage().bodies().front().path);
  LearningCurve curve;
  curve.resize(640, 400);
  for (double n = 1.0; n < 1e5; n *= 1.3) curve.add(n, 1e5, 0.5 / std::sqrt(n));
  curve.show();
  keep(curve, "learning_curve");

  play_until(window, 4.0);
  window->findChild<Exporter*>()->write_film(window.folder() + "/run.avi");
  auto* progress = window.get<QDialog>("film_progress");
  progress->show();  // it waits some seconds, and goes with a film that is ready
  CHECK(progress->grab().save(qEnvironmentVariable("ELSIE_PICTURES", ".") + "/film_progress.png"));
  window.await_closed("film_progress");

  window.file(kRoom);
  REQUIRE(window->open(study_in(window, 1, 6)));
  keep(*window.dialog("run_dialog"), "runs_of_a_database");
  window.dialog("run_dialog")->reject();
}

TEST_CASE("Pictures: a recording, a network that has learned, a list and a lock", "[.pictures]") {
  Window window;
  const QString recording = window.folder() + "/forage.mcap";
  QProcess run;
  run.start(build_file("elsie"),
            {"run", world_file("find_resource"), "--record", recording, "--duration", "20"});
  REQUIRE(run.waitForFinished(kPatience_ms));
  window.open(recording);
  resize(window);
  auto* line = window->findChild<TimeLine*>();
  REQUIRE(wait_for([&] { return !line->events().empty(); }));
  line->go_to(12.0);
  REQUIRE(wait_for([&] { return window.bench().time_s() > 11.9; }));
  keep(window, "recording");

  window.open(world_file("learned_priorities"));
  REQUIRE(wait_for([&] { return window.bench().is_right(); }));
  const QString robot = window->scene().stage().bodies().front().path;
  window.choose(robot);
  window.act("lock");
  window.get<WorldTree>("world_tree")
      ->tree()
      ->setCurrentItem(window.get<WorldTree>("world_tree")->item(robot)->parent());
  keep(window, "list_and_lock");
}

TEST_CASE("Pictures: the end of a run, a robot that is stuck, and a behaviour that is written",
          "[.pictures]") {
  Window window;
  resize(window);
  window.after([&] { window.act("new"); });
  window.run_to_the_end();
  window->scene().show_all();
  keep(window, "run_card_success");
  window.open(window.file(R"(<world format="1">
  <arena length="5" width="5"/>
  <obstacles><static_box id="block" x="0.4"/></obstacles>
  <resources><resource x="1.5"/></resources>
  <robots>
    <robot id="r1" team="red" x="-1.5">
      <sensors><beam_range/></sensors>
      <behaviors><go_to_point id="back" x="-2" y="0"/><go_to_point id="ahead" x="1.5" y="0"/></behaviors>
      <coordinator><fusion_vector_summation/></coordinator>
    </robot>
  </robots>
  <goals><collect/></goals>
  <limits time="40"/>
</world>
)"));
  resize(window);
  run_until(window, 25.0);
  keep(window, "stuck_notice");
  window.run_to_the_end();
  keep(window, "run_card_failure");
  window.choose("robot[r1]");
  window.act("write_behavior");
  auto* dialog = window.dialog("new_behavior_dialog");
  dialog->findChild<QLineEdit*>("behavior_folder")->setText(window.folder());
  dialog->findChild<QLineEdit*>("behavior_name")->setText("steady");
  keep(*dialog, "dialog_new_behavior");
  window.after([&] { Window::press(dialog, QDialogButtonBox::Ok); });
  REQUIRE(wait_for([&] { return window.bench().text().contains("<steady/>"); }));
  keep(window, "source");
  window.step();  // so that there is something to film
  for (const char* action : {"export_film", "export_picture"}) {
    keep_modal(QString("dialog_") + action, [](QDialog* modal) { modal->reject(); });
    window.act(action);
  }
  window->findChild<Sharer*>()->write(window.folder() + "/steady.html", nullptr);
  auto* shared = window.dialog("page_written");
  keep(*shared, "dialog_page_written");
  shared->close();
  window.choose("robot[r1]/behavior[steady]");
  window.act("tutorial");
  keep(*window.dialog("help_window"), "help");
}
