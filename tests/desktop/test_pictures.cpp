// Pictures of every window, for docs and for eyes: scripts/desktop-pictures. Hidden from ordinary
// runs.
#include <QComboBox>
#include <QDockWidget>
#include <QListWidget>
#include <QTabWidget>
#include <QTreeWidget>

#include <catch2/catch.hpp>

#include "scene/scene_view.h"
#include "watch/fuzzy_instant.h"
#include "watch/fuzzy_panel.h"
#include "watch/plots_panel.h"
#include "watch/vision_panel.h"
#include "window.h"
#include "world/form.h"

using namespace elsie::desktop;

namespace {

void keep(QWidget& widget, const QString& name) {
  QTest::qWait(300);
  const QString folder = qEnvironmentVariable("ELSIE_PICTURES", ".");
  CHECK(widget.grab().save(folder + '/' + name + ".png"));
}

void resize(Window& window) {
  const QStringList size = qEnvironmentVariable("ELSIE_PICTURE_SIZE", "1280x800").split('x');
  window->resize(size[0].toInt(), size[1].toInt());
  window->arrange("author");
}

void run_until(Window& window, double time_s) {
  window.bench().set_speed(4.0);
  window.bench().run();
  REQUIRE(wait_for([&] {
    return window.bench().time_s() > time_s || window.bench().run_state() == Workbench::Run::ended;
  }));
  window.bench().pause();
  QTest::qWait(200);
}

void keep_dialog(Window& window, const char* action, const QString& name) {
  window.act(action);
  QDialog* dialog = nullptr;
  REQUIRE(wait_for([&] {
    for (QDialog* each : window->findChildren<QDialog*>()) {
      if (each->isVisible()) dialog = each;
    }
    return dialog != nullptr;
  }));
  keep(*dialog, name);
  if (auto* tabs = dialog->findChild<QTabWidget*>("pages"); tabs && tabs->count() > 1) {
    tabs->setCurrentIndex(tabs->count() - 1);
    keep(*dialog, name + "_last_page");
  }
  dialog->reject();
  REQUIRE(
      wait_for([&] { return !dialog->isVisible() || window->findChildren<QDialog*>().isEmpty(); }));
  QTest::qWait(50);
}

}  // namespace

TEST_CASE("Pictures: the start page", "[.pictures]") {
  Window window;
  resize(window);
  auto* examples = window.get<QListWidget>("examples");
  REQUIRE(wait_for([&] { return !examples->item(examples->count() - 1)->icon().isNull(); }));
  keep(window.window(), "start");
}

TEST_CASE("Pictures: a world being built, and watched", "[.pictures]") {
  Window window(world_file("ten_robots"));
  resize(window);
  run_until(window, 12.0);
  window.choose(window->scene().stage().bodies().front().path);
  keep(window.window(), "author");
  window->arrange("watch");
  window.get<QDockWidget>("dock_fuzzy")->raise();
  window.bench().run();
  auto* fuzzy = window->findChild<FuzzyPanel*>();
  wait_for([&] { return !fuzzy->now().degrees.empty(); });
  window.bench().pause();
  keep(window.window(), "fuzzy");
  window.get<QDockWidget>("dock_sensors")->raise();
  keep(window.window(), "sensors");
  window->arrange("author");
  window.get<QDockWidget>("dock_text")->raise();
  keep(window.window(), "text");
}

TEST_CASE("Pictures: cameras and plots", "[.pictures]") {
  Window window(world_file("four_resources"));
  resize(window);
  window->arrange("watch");
  auto* plots = window->findChild<PlotsPanel*>();
  window.get<QDockWidget>("dock_plots")->raise();
  run_until(window, 1.0);
  for (const QString& name : plots->names()) {
    if (name.endsWith("/speed") || name.endsWith("/energy")) plots->choose(name, true);
  }
  run_until(window, 15.0);
  keep(window.window(), "watch");
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
