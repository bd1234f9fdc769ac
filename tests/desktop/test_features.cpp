// What a user finds in the window, each by its name, by real clicks and key presses.
#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QSpinBox>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <QTreeWidget>

#include <catch2/catch.hpp>

#include "authoring/authoring.h"
#include "hands.h"
#include "inferring.h"
#include "watch/control_surface.h"
#include "watch/plots_panel.h"
#include "watch/vision_panel.h"
#include "window.h"
#include "world/form.h"
#include "world/properties.h"

using namespace elsie::desktop;

namespace {

void add_with(Window& window, const char* action) {
  window.act(action);
  QDialog* dialog = window.dialog("element_dialog");
  Window::press(dialog, QDialogButtonBox::Ok);
  const auto* refusal = dialog->findChild<QLabel*>("refusal");
  REQUIRE(wait_for([&] {
    return !window->findChild<QDialog*>("element_dialog") || !refusal->text().isEmpty();
  }));
  if (window->findChild<QDialog*>("element_dialog")) {
    FAIL(refusal->text().toStdString());
  }
}

}  // namespace

TEST_CASE("Menus: file, edit, view, simulation and help, each with what it names") {
  Window window;
  const QHash<QString, QStringList> named{
      {"File",
       {"new", "open", "save", "save_as", "export_picture", "export_film", "share", "record",
        "copy_command", "quit"}},
      {"Edit", {"undo", "redo", "cut", "copy", "paste", "duplicate", "delete", "edit", "rename"}},
      {"View",
       {"view_all", "view_top", "follow", "measure", "show_trails", "show_sketches",
        "layout_author", "layout_reset"}},
      {"Simulation",
       {"run", "step", "reset", "show_end", "physics", "arena", "limits", "stop_engine"}},
      {"Help", {"tutorial", "page_of_selected", "commands", "keys", "shortcuts", "about"}}};
  QStringList titles;
  for (QAction* menu : window->menuBar()->actions()) {
    const QString title = menu->text().remove('&');
    titles << title;
    INFO(title.toStdString());
    REQUIRE(menu->menu());
    for (const QString& name : named[title]) {
      INFO(name.toStdString());
      CHECK(menu->menu()->actions().contains(window.get<QAction>(name.toUtf8().constData())));
    }
  }
  CHECK(titles == QStringList{"File", "Edit", "View", "Simulation", "Help"});
}

TEST_CASE("All tools fit a window of 1280 pixels") {
  Room window;
  window->resize(1280, 800);
  for (const char* name : {"tools", "environment"}) {
    auto* bar = window.get<QToolBar>(name);
    REQUIRE(wait_for([&] { return window->width() == 1280 && bar->geometry().right() < 1280; }));
    const auto* more = bar->findChild<QToolButton*>("qt_toolbar_ext_button");
    REQUIRE(more);
    CHECK(wait_for([&] { return !more->isVisible(); }));
    for (QAction* each : bar->actions()) {
      if (each->isSeparator()) continue;
      INFO(each->text().toStdString());
      CHECK(bar->widgetForAction(each)->isVisible());
    }
  }
}

TEST_CASE("The status bar shows simulated time, real-time factor, seed and outcome") {
  Room window(QString(kRoom).replace("time=\"60\"", "time=\"2\""));
  window.after([&] { window.bench().reset(7); });
  window.bench().set_speed(1.0);
  window.bench().run();
  const QRegularExpression pace("^[0-9]+\\.[0-9]x of 1x$");
  REQUIRE(wait_for([&] {
    const QString text = window.get<QLabel>("pace")->text();
    return pace.match(text).hasMatch() && text != "0.0x of 1x";
  }));
  CHECK(window.get<QLabel>("seed_shown")->text().contains("7"));
  REQUIRE(wait_for([&] { return window.bench().run_state() == Workbench::Run::ended; }));
  CHECK(wait_for([&] { return window.get<QLabel>("time_s")->text() == "2.00 s"; }));
  CHECK_FALSE(window.get<QLabel>("outcome")->text().isEmpty());
}

TEST_CASE("Windows float, hide, and come back as they were left") {
  {
    Room window;
    auto* sensors = window.get<QDockWidget>("dock_sensors");
    auto* coordination = window.get<QDockWidget>("dock_coordination");
    CHECK_FALSE(sensors->isVisible());
    sensors->toggleViewAction()->trigger();
    sensors->setFloating(true);
    coordination->toggleViewAction()->trigger();
    CHECK(coordination->isHidden());
    window->close();
  }
  Room again;
  CHECK(again.get<QDockWidget>("dock_sensors")->isFloating());
  CHECK(again.get<QDockWidget>("dock_coordination")->isHidden());
  again.act("layout_reset");
  CHECK_FALSE(again.get<QDockWidget>("dock_sensors")->isFloating());
  CHECK_FALSE(again.get<QDockWidget>("dock_coordination")->isHidden());
  again->close();
}

TEST_CASE("On a large screen the text stands beside the view, elsewhere below it") {
  Room window;
  auto* text = window.get<QDockWidget>("dock_text");
  window->resize(1280, 800);
  window.act("layout_author");
  CHECK(window->dockWidgetArea(text) == Qt::BottomDockWidgetArea);
  window->resize(2400, 1300);
  window.act("layout_author");
  CHECK(window->dockWidgetArea(text) == Qt::RightDockWidgetArea);
  CHECK(wait_for([&] { return text->x() >= window->scene().width() && text->width() > 400; }));
  CHECK(text->x() < window.get<QDockWidget>("dock_properties")->x());
}

TEST_CASE("Physics parameters are changed while it runs, and the run is that of --at") {
  Room window(QString(kRoom).replace("time=\"60\"", "time=\"8\""));
  window.bench().set_speed(1.0);
  click_on(window.get<QToolButton>("run"));
  REQUIRE(wait_for([&] { return window.bench().time_s() > 0.2; }));
  window.bench().set_speed(0.1);  // it must not end before the change
  QDialog* dialog = window.dialog_of("physics");
  auto* form = dialog->findChild<Form*>("form_physics");
  REQUIRE(form);
  for (const char* name : {"gravity", "erp", "cfm", "step"}) {
    INFO(name);
    CHECK(form->editor(name));
  }
  for (const auto& [name, value] : {std::pair("gravity", "-5"), {"erp", "0.4"}}) {
    click_on(form->editor(name));
    type_text(dialog, value);
  }
  window.after([&] { Window::press(dialog, QDialogButtonBox::Ok); });
  CHECK(window.bench().text().contains("gravity=\"-5\""));
  CHECK(window.bench().run_state() == Workbench::Run::running);
  Json end;
  QObject::connect(&window.bench(), &Workbench::ended, &window.window(),
                   [&](const Json& event) { end = event; });
  window.bench().set_speed(0.0);
  REQUIRE(wait_for([&] { return !end.is_null(); }));

  // The command that repeats it makes the same run; one without the changes another.
  QApplication::clipboard()->clear();
  window.act("copy_command");
  REQUIRE(wait_for([&] { return !QApplication::clipboard()->text().isEmpty(); }));
  const QStringList words = QProcess::splitCommand(QApplication::clipboard()->text());
  CHECK(words.filter("physics/@gravity=-5").size() == 1);
  const std::string hash = end.at("state_hash").get<std::string>();
  CHECK(headless_hash(words.mid(2)) == hash);
  CHECK(headless_hash({window.bench().file()}) != hash);
}

TEST_CASE("The control bar paces a run from 0.1 to as fast as possible") {
  Room window;
  auto* speed = window.get<QComboBox>("speed");
  speed->setFocus();
  while (speed->currentIndex() > 0) {
    QTest::keyClick(speed, Qt::Key_Up);
  }
  CHECK(window.bench().speed() == 0.1);
  QElapsedTimer clock;
  clock.start();
  QTest::mouseClick(window.get<QToolButton>("run"), Qt::LeftButton);
  REQUIRE(wait_for([&] { return window.bench().time_s() >= 0.1; }));
  CHECK(clock.elapsed() >= 900);  // a tenth of real time
  QTest::keyClick(speed, Qt::Key_End);
  CHECK(window.bench().speed() == 0.0);
  CHECK(wait_for([&] { return window.bench().run_state() == Workbench::Run::ended; }));
}

TEST_CASE("Boxes of three kinds, resources, chargers, goals, measures and teams are put in") {
  Room window;
  auto* tree = window.get<WorldTree>("world_tree");
  const std::pair<const char*, const char*> added[] = {{"add_static", "<static_box"},
                                                       {"add_dynamic", "<dynamic_box"},
                                                       {"add_moving", "<moving_box"},
                                                       {"add_resource", "<resource "},
                                                       {"add_cylinder", "<static_cylinder"},
                                                       {"add_prism", "<static_prism"},
                                                       {"add_charger", "<charger "},
                                                       {"add_nest", "<nest "},
                                                       {"add_lamp", "<lamp "},
                                                       {"add_patch", "<rectangle_patch "},
                                                       {"add_measure", "<measures>"},
                                                       {"add_team", "<teams>"},
                                                       {"add_field", "<fields>"},
                                                       {"add_goal", "<goals>"}};
  for (const auto& [action, text] : added) {
    INFO(action);
    const qsizetype before = window.bench().text().count(text);
    add_with(window, action);
    CHECK(window.bench().text().count(text) == before + 1);
  }
  for (const char* path : {"obstacle[moving_box_1]", "charger[charger_1]", "resource[resource_1]",
                           "nest[nest_1]", "lamp[lamp_1]", "patch[rectangle_patch_1]"}) {
    INFO(path);
    CHECK(tree->item(path));
  }
  QDialog* dialog = window.dialog_of("add_static");
  dialog->findChild<Form*>("form_static_box")->set_value("length", "0.75");
  window.after([&] { Window::press(dialog, QDialogButtonBox::Ok); });
  CHECK(window.bench().text().contains("length=\"0.75\""));
}

TEST_CASE("A rule is chosen among those of the plugins, and stands in the tree") {
  Room window;
  QDialog* dialog = window.dialog_of("add_rule");
  auto* kinds = dialog->findChild<QListWidget*>("kinds");
  const auto respawn = kinds->findItems("respawn", Qt::MatchExactly);
  REQUIRE(respawn.size() == 1);
  kinds->setCurrentItem(respawn.front());
  window.after([&] { Window::press(dialog, QDialogButtonBox::Ok); });
  CHECK(window.bench().text().contains("<rules>"));
  CHECK(window.bench().text().contains("<respawn"));
  CHECK(window.get<WorldTree>("world_tree")->item("rule[respawn]"));
}

TEST_CASE("A group of goals begins with one, and has the goals in it in the tree") {
  Room window;
  QDialog* dialog = window.dialog_of("add_goal");
  auto* kinds = dialog->findChild<QListWidget*>("kinds");
  const auto any = kinds->findItems("any", Qt::MatchExactly);
  REQUIRE(any.size() == 1);
  kinds->setCurrentItem(any.front());
  window.after([&] { Window::press(dialog, QDialogButtonBox::Ok); });
  CHECK(window.bench().text().contains("<endure/>"));
  auto* tree = window.get<WorldTree>("world_tree");
  const QString group = tree->item("goal[2]") ? "goal[2]" : "goal[1]";
  CHECK(tree->item(group + "/endure"));
  window.after([&] {
    window.bench().edit({group + "/travel[+]=<travel any=\"true\" distance=\"3\"/>"}, "add");
  });
  CHECK(tree->item(group + "/travel"));
}

TEST_CASE("A prism begins as a regular polygon with the corners that its dialog says") {
  Room window;
  QDialog* dialog = window.dialog_of("add_prism");
  dialog->findChild<Form*>("form_outline")->set_value("corners", "5");
  dialog->findChild<Form*>("form_outline")->set_value("radius", "0.3");
  window.after([&] { Window::press(dialog, QDialogButtonBox::Ok); });
  CHECK(window.bench().text().count("<point ") == 5);
  CHECK(window.bench().text().contains("<point x=\"0.3000\" y=\"0.0000\"/>"));
  window.after([&] { window->findChild<Authoring*>()->add_point("obstacle[static_prism_1]"); });
  CHECK(window.bench().text().count("<point ") == 6);
}

TEST_CASE("Every window is shown and hidden from the menu") {
  Window window;
  QMenu* windows = nullptr;
  for (QMenu* each : window->findChildren<QMenu*>()) {
    windows = each->title().remove(u'&').contains("Windows") ? each : windows;
  }
  REQUIRE(windows);
  Q_EMIT windows->aboutToShow();
  CHECK(windows->actions().size() >= 11);
  for (QDockWidget* dock : window->findChildren<QDockWidget*>()) {
    INFO(dock->windowTitle().toStdString());
    CHECK(windows->actions().contains(dock->toggleViewAction()));
    const bool was_hidden = dock->isHidden();
    dock->toggleViewAction()->trigger();
    CHECK(dock->isHidden() != was_hidden);
  }
}

TEST_CASE("Vision: raw and processed pictures of all cameras side by side") {
  Window window(world_file("four_resources"));
  window->arrange("watch");
  auto* vision = window->findChild<VisionPanel*>();
  window.bench().run();
  REQUIRE(wait_for([&] { return vision->pictures().size() >= 2; }));
  int raw = 0, processed = 0;
  for (const QString& name : vision->pictures()) {
    raw += name.endsWith(" raw");
    processed += name.endsWith(" processed");
    CHECK_FALSE(vision->picture(name).isNull());
  }
  CHECK(raw > 0);
  CHECK(processed == raw);
}

TEST_CASE("The fuzzy viewer shows the model, its rules and its control surface as it infers") {
  Window window(world_file("clutter"));
  FuzzyPanel* const fuzzy = inferring(window);
  CHECK(fuzzy->problem().isEmpty());
  const auto* surface = fuzzy->findChild<ControlSurface*>();
  REQUIRE(surface);
  CHECK(surface->grid().rows == FuzzyGrid::kAcross);
  CHECK(fuzzy->now().sets.size() == fuzzy->now().centres.size());
  window.after([&] { window.open(window.file(kRoom)); });
  CHECK(fuzzy->now().degrees.empty());  // of another world
}

TEST_CASE("Plots: what is chosen goes on while another window lies in front, also after a reset") {
  Room window;
  auto* plots = window->findChild<PlotsPanel*>();
  window.get<QDockWidget>("dock_plots")->raise();
  window.bench().step();
  REQUIRE(wait_for([&] { return plots->names().contains("r1/speed"); }));
  plots->choose("r1/speed", true);
  window.get<QDockWidget>("dock_coordination")->raise();
  window.bench().run();
  REQUIRE(wait_for([&] { return window.bench().time_s() > 1.0; }));
  window.pause();
  const QString table = window.folder() + "/speed.csv";
  REQUIRE(plots->save(table).isEmpty());
  CHECK(bytes_of(table).count('\n') > 10);
  window.after([&] { window.bench().reset(1); });
  CHECK(plots->chosen() == QStringList{"r1/speed"});
}

TEST_CASE("Worlds are opened and saved elsewhere; the files opened last are listed") {
  Room window;
  const QString file = window.bench().file();
  window.after([&] { window.bench().edit({"robot[r1]/@x=0"}, "move"); });
  const QString copy = window.folder() + "/copy.xml";
  at_dialog("save_dialog", [&](QDialog* dialog) { save_as_file(dialog, copy); });
  window.act("save_as");
  REQUIRE(wait_for([&] { return QFile::exists(copy) && !window->isWindowModified(); }));
  CHECK(window.bench().file() == copy);
  CHECK(bytes_of(file) == kRoom);
  QStringList recent;
  for (QMenu* each : window->findChildren<QMenu*>()) {
    if (each->title().contains("opened")) {
      for (QAction* action : each->actions()) recent << action->text();
    }
  }
  CHECK(recent.join(' ').contains("room.xml"));
}

TEST_CASE("The start page has examples with pictures") {
  Window window;
  auto* page = window->findChild<QWidget*>("start_page");
  REQUIRE(page);
  auto* examples = window.get<QListWidget>("examples");
  REQUIRE(examples->count() > 10);
  CHECK(wait_for([&] {
    for (int i = 0; i < examples->count(); ++i) {
      if (examples->item(i)->icon().availableSizes().isEmpty()) return false;
    }
    return true;
  }));
}
