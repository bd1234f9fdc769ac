// What the window shows of a world and of a run: the present state, whole, and where it is looked
// for.
#include <QAbstractButton>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QStatusBar>
#include <QTabBar>
#include <QTabWidget>
#include <QTextBlock>
#include <QToolBar>

#include <catch2/catch.hpp>

#include "hands.h"
#include "inferring.h"
#include "paint/figures.h"
#include "scene/scene_view.h"
#include "scripted_engine.h"
#include "text/code_editor.h"
#include "text/problems_panel.h"
#include "text/sources_panel.h"
#include "text/world_editor.h"
#include "watch/fuzzy_instant.h"
#include "watch/fuzzy_panel.h"
#include "watch/plots_panel.h"
#include "world/form.h"
#include "world/properties.h"

using namespace elsie::desktop;

namespace {

/// A dock that is shown and not behind another one.
bool is_in_front(const QDockWidget* dock) {
  return dock->isVisible() && !dock->visibleRegion().isEmpty();
}

/// The letters of the menus, buttons and labels that are visible, with their texts.
QMap<QString, QStringList> mnemonics(MainWindow& window) {
  QMap<QString, QStringList> all;
  const auto note = [&](const QString& text) {
    if (const QKeySequence key = QKeySequence::mnemonic(text); !key.isEmpty()) {
      all[key.toString()] << text;
    }
  };
  for (const QAction* each : window.menuBar()->actions()) note(each->text());
  for (const QWidget* each : window.findChildren<QWidget*>()) {
    if (!each->isVisible() || each->window() != &window) continue;
    if (const auto* button = qobject_cast<const QAbstractButton*>(each)) note(button->text());
    if (const auto* label = qobject_cast<const QLabel*>(each); label && label->buddy()) {
      note(label->text());
    }
  }
  return all;
}

QString doubled(const QMap<QString, QStringList>& all) {
  QString doubled;
  for (const QStringList& texts : all) {
    if (texts.size() > 1) doubled += texts.join(" | ") + '\n';
  }
  return doubled;
}

}  // namespace

TEST_CASE("At rest, Properties shows where a thing is, also after an edit and a new engine") {
  Room window;
  window.choose("robot[r1]");
  auto* x = window.get<QLabel>("x_live");
  CHECK(wait_for([&] { return x->text() == "now at 0.0 s: x -1.00 m"; }));
  window.bench().edit({"robot[r1]/@x=-1.5"}, "move r1");
  CHECK(wait_for([&] { return x->text() == "now at 0.0 s: x -1.50 m"; }));
  window.bench().undo();
  CHECK(wait_for([&] { return x->text() == "now at 0.0 s: x -1.00 m"; }));

  window.bench().run();
  auto* speed = window.get<QLabel>("max_speed_live");
  REQUIRE(wait_for([&] { return !x->text().endsWith("-1.00 m") && !speed->text().isEmpty(); }));
  window.act("stop_engine");
  REQUIRE(wait_for([&] { return window.bench().run_state() == Workbench::Run::none; }));
  REQUIRE(wait_for([&] { return window.bench().run_state() == Workbench::Run::ready; }));
  CHECK(wait_for([&] { return x->text() == "now at 0.0 s: x -1.00 m"; }));
}

TEST_CASE("A world with errors shows its text, at the first of them, and the view says so") {
  Window window;
  window.act("layout_author");
  window.get<QDockWidget>("dock_coordination")->raise();
  window.open(
      window.file("<world format=\"1\">\n  <robots>\n    <robot id=\"a\" speed=\"1\"/>\n"
                  "    <robot id=\"b\" x=\"left\"/>\n  </robots>\n</world>\n"));
  REQUIRE(window.bench().problems().size() == 2);
  CHECK(wait_for([&] { return is_in_front(window.get<QDockWidget>("dock_text")); }));
  CHECK(window.get<WorldEditor>("world_editor")->textCursor().blockNumber() + 1 == 3);
  CHECK(window->scene().notice().contains("2 errors"));
  window.open(window.file(kRoom, "right.xml"));
  CHECK(wait_for([&] { return window->scene().notice().isEmpty(); }));
}

TEST_CASE("Why a run failed is in the list of errors until the next run") {
  const QString reason = QString("the body of r1 is lost, ").repeated(30);
  ScriptedEngine elsie(QString(kOpens) + R"(run) say "{\"answer\":$id}"
      say '{"event":"ended","outcome":"stopped","reason":")" +
                       reason + R"("}' ;;
)");
  ScriptedWindow window(elsie);
  window.open_world();
  window.workbench().run();
  auto* list = window.findChild<QTreeWidget*>("problems");
  REQUIRE(wait_for([&] { return list->topLevelItemCount() == 1; }));
  CHECK(list->topLevelItem(0)->toolTip(0).contains(reason));
  window.workbench().reset(1);
  CHECK(wait_for([&] { return list->topLevelItemCount() == 0; }));
}

TEST_CASE("No letter with Alt leads to two things of the window, or of a menu") {
  Window window;
  CHECK(doubled(mnemonics(window.window())).toStdString().empty());  // the start page
  for (const QMenu* menu : window->menuBar()->findChildren<QMenu*>()) {
    QMap<QString, QStringList> letters;
    for (const QAction* each : menu->actions()) {
      if (const QKeySequence key = QKeySequence::mnemonic(each->text()); !key.isEmpty()) {
        letters[key.toString()] << each->text();
      }
    }
    CHECK(doubled(letters).toStdString().empty());
  }
  window.open(window.file(kRoom));
  CHECK(doubled(mnemonics(window.window())).toStdString().empty());
}

TEST_CASE("Bars are hidden by the menu View, and stay so") {
  const auto bars = [](Window& window) {
    return std::vector<const QWidget*>{window.get<QToolBar>("tools"),
                                       window.get<QToolBar>("environment"), window->statusBar()};
  };
  const std::vector<const char*> toggles{"show_control_bar", "show_environment_bar",
                                         "show_status_bar"};
  {
    Window window;
    for (std::size_t i = 0; i < toggles.size(); ++i) {
      CHECK(bars(window)[i]->isVisible());
      window.act(toggles[i]);
      CHECK_FALSE(bars(window)[i]->isVisible());
    }
    CHECK(window->close());
  }
  Window window;
  for (std::size_t i = 0; i < toggles.size(); ++i) {
    CHECK_FALSE(bars(window)[i]->isVisible());
    window.act(toggles[i]);
    CHECK(bars(window)[i]->isVisible());
  }
  CHECK(window->close());
}

TEST_CASE("The numbers that are plotted are plotted again in the next window") {
  {
    Room window;
    window.get<QDockWidget>("dock_plots")->raise();
    auto* plots = window->findChild<PlotsPanel*>();
    window.bench().run();
    REQUIRE(wait_for([&] { return plots->names().contains("r1/speed"); }));
    plots->choose("r1/speed", true);
    CHECK(window->close());
  }
  Room window;
  window.get<QDockWidget>("dock_plots")->raise();
  auto* plots = window->findChild<PlotsPanel*>();
  window.bench().run();
  CHECK(wait_for([&] { return plots->chosen() == QStringList{"r1/speed"}; }));
  plots->choose("r1/speed", false);
  CHECK(window->close());
}

TEST_CASE("Usual teams that a world does not use give way to its own") {
  Window window;
  const QString others = QString(kRoom)
                             .replace("team=\"red\"", "team=\"green\"")
                             .replace("<robots>", "<teams><team id=\"green\"/></teams><robots>");
  window.open(window.file(others.toUtf8(), "others.xml"));
  CHECK(wait_for([&] { return window->findChild<QDockWidget*>("dock_team_green") != nullptr; }));
  CHECK(window.get<QDockWidget>("dock_team_red")->isHidden());
  CHECK(window.get<QDockWidget>("dock_team_blue")->isHidden());
  window.act("layout_author");
  CHECK(window.get<QDockWidget>("dock_team_red")->isHidden());
  QString tip;  // of a tab whose name may be cut off
  for (const QTabBar* tabs : window->findChildren<QTabBar*>()) {
    for (int i = 0; i < tabs->count(); ++i) {
      if (tabs->tabText(i) == "green") tip = tabs->tabToolTip(i);
    }
  }
  CHECK(tip == "green");
  window.open(window.file(kRoom));
  CHECK(wait_for([&] { return !window.get<QDockWidget>("dock_team_red")->isHidden(); }));
  window.open(
      window.file("<world format=\"1\"><arena length=\"4\" width=\"4\"/></world>", "e.xml"));
  CHECK(wait_for([&] { return !window.get<QDockWidget>("dock_team_blue")->isHidden(); }));
  CHECK_FALSE(window.get<QDockWidget>("dock_team_red")->isHidden());
}

TEST_CASE("Nested behaviours are in the tree, and their coordinator is edited where it is") {
  Window window;
  window.open(world_file("nested"));
  auto* tree = window.get<WorldTree>("world_tree");
  const QString blend = "robot[r1]/behavior[journey]";
  for (const char* inner : {"/behavior[wander]", "/behavior[recharge]", "/coordinator"}) {
    CAPTURE(inner);
    REQUIRE(tree->item(blend + inner));
  }
  click_row(tree, blend + "/coordinator", Qt::RightButton);
  QDialog* dialog = window.dialog("element_dialog");
  CHECK(dialog->windowTitle().contains("arbiter_subsumption"));
  Window::press(dialog, QDialogButtonBox::Cancel);
  window.await_closed("element_dialog");
  window.get<QDockWidget>("dock_coordination")->raise();
  window.bench().edit({blend + "/behavior[wander]/@speed=10"}, "slower");
  REQUIRE(wait_for([&] { return window.bench().undo_name() == "slower"; }));
  CHECK(window.bench().text().contains("<wander speed=\"10\"/>"));
}

TEST_CASE("Readable: nothing of the fuzzy window is cut off at the side", "[readable]") {
  Window window;
  window->resize(1280, 720);
  window.open(world_file("clutter"));
  window.act("layout_watch");
  auto* dock = show_dock(window.window(), "dock_fuzzy");
  auto* fuzzy = window->findChild<FuzzyPanel*>();
  window.bench().run();
  REQUIRE(wait_for([&] { return !fuzzy->now().degrees.empty(); }));
  window.bench().pause();
  CHECK(dock->width() >= 400);
  const auto fits = [&] {
    const auto* area = fuzzy->findChild<QScrollArea*>();
    return area->widget()->width() <= area->viewport()->width();
  };
  CHECK(fits());
  window->resizeDocks({dock}, {280}, Qt::Horizontal);
  CHECK(wait_for(fits));
}

TEST_CASE("Readable: numbers of different units have strips of their own, high enough",
          "[readable]") {
  Window window;
  window->resize(1280, 720);
  window.open(window.file(kRoom));
  window.act("layout_watch");
  window.get<QDockWidget>("dock_plots")->raise();
  auto* plots = window->findChild<PlotsPanel*>();
  window.bench().run();
  REQUIRE(wait_for([&] { return plots->names().contains("r1/energy"); }));
  const auto height = [&] { return window.get<QWidget>("plot")->minimumHeight(); };
  plots->choose("r1/speed", true);
  const int one = height();
  CHECK(one >= 7 * window->fontMetrics().height());
  plots->choose("r1/energy", true);
  CHECK(height() == 2 * one);
  plots->choose("r1/speed", false);
  plots->choose("r1/energy", false);
}

TEST_CASE("Readable: the tree has no scroll bar at the side, and a long field shows its beginning",
          "[readable]") {
  Window window;
  window->resize(1280, 720);
  window.act("layout_author");
  window.open(world_file("clutter"));
  const auto* tree = window.get<WorldTree>("world_tree")->tree();
  CHECK(wait_for([&] { return tree->horizontalScrollBar()->maximum() == 0; }));
  window.choose("");
  auto& form = window.get<Properties>("properties")->form();
  auto* description = qobject_cast<QLineEdit*>(form.editor("description"));
  REQUIRE(description);
  CHECK(description->cursorPosition() == 0);
  window.choose("robot[r1]");
  window.bench().run();
  auto* energy = window.get<QLabel>("energy_live");
  REQUIRE(wait_for([&] { return energy->isVisible(); }));
  window.bench().pause();
  CHECK(form.editor("energy")->width() >= 8 * form.fontMetrics().averageCharWidth());
}

namespace {

const QByteArray kTwoModels = QByteArray(kRoom).replace("<wander/>", R"(<avoid_obstacle
    left_model="left.fcl" right_model="right.fcl"/>)");

}  // namespace

TEST_CASE("A fuzzy model is edited in the window, and shown as the run uses it") {
  Window window;
  const QByteArray shipped =
      bytes_of(build_file("../share/elsie/fuzzy_models/avoid_obstacle_left.fcl"));
  const QString model = window.file(shipped, "left.fcl");
  window.file(shipped, "right.fcl");
  window.open(window.file(kTwoModels));
  window.choose("robot[r1]");
  FuzzyPanel* fuzzy = inferring(window);
  const auto* page = dynamic_cast<const ShowsFigures*>(window.get<QWidget>("fuzzy_page"));
  const auto shows = [&](const QString& rule) {
    const auto rows = page->figures().rows;
    return std::any_of(rows.begin(), rows.end(),
                       [&](const QStringList& row) { return row.join(' ').contains(rule); });
  };
  const QString before = "range IS far OR azimuth IS behind THEN speed IS fast";
  const QString after = "range IS far OR azimuth IS behind THEN speed IS slow";
  CHECK(shows(before));

  click_on(window.get<QAbstractButton>("edit_model"));
  auto* text = window.get<CodeEditor>("source_text");
  REQUIRE(wait_for([&] { return text->whole_text().toUtf8() == shipped; }));
  const qsizetype line = text->whole_text().left(text->whole_text().indexOf(before)).count('\n');
  text->go_to(static_cast<int>(line) + 1);
  QTextCursor at = text->textCursor();
  at.select(QTextCursor::LineUnderCursor);
  at.insertText("  RULE 1 : IF " + after + ";");
  text->setFocus();
  press_key(text, Qt::Key_S, Qt::ControlModifier);
  CHECK(bytes_of(model) == QByteArray(shipped).replace(before.toUtf8(), after.toUtf8()));
  CHECK(window.get<QLabel>("source_state")->text().contains("the next one"));
  CHECK(shows(before));  // the run goes on with the model that it has
  auto* models = window.get<QComboBox>("fuzzy_models");
  const int chosen = models->currentIndex();
  REQUIRE(models->count() == 2);
  models->setCurrentIndex(1 - chosen);
  models->setCurrentIndex(chosen);
  CHECK(shows(before));

  window.act("reset");
  show_dock(window.window(), "dock_fuzzy");
  window.bench().run();
  CHECK(wait_for([&] { return shows(after); }));
  CHECK_FALSE(shows(before));
  CHECK(fuzzy->problem() == QString());
}

TEST_CASE("A fuzzy model that is saved is checked, and used by the next run, whichever is shown") {
  Window window;
  const QByteArray shipped =
      bytes_of(build_file("../share/elsie/fuzzy_models/avoid_obstacle_left.fcl"));
  const QString left = window.file(shipped, "left.fcl");
  window.file(shipped, "right.fcl");
  window.open(window.file(kTwoModels));
  window.choose("robot[r1]");
  inferring(window);
  auto* sources = window->findChild<SourcesPanel*>();
  REQUIRE(sources->open(left).isEmpty());
  CHECK(window.get<QAbstractButton>("save_source")->toolTip() == "Saves the file (Ctrl+S)");
  auto* text = window.get<CodeEditor>("source_text");
  const auto type = [&](const QByteArray& model) {
    text->selectAll();
    text->insertPlainText(model);
  };
  for (const int chosen : {0, 1}) {  // left and right
    INFO(chosen);
    window.get<QComboBox>("fuzzy_models")->setCurrentIndex(chosen);
    type(QByteArray(shipped).replace("IS fast", "IS no_such_term"));
    CHECK(sources->save({left}).isEmpty());
    CHECK(window.get<QLabel>("source_state")->text().contains("no_such_term"));
    type(shipped);
    CHECK(sources->save({left}).isEmpty());
    CHECK(window.get<QLabel>("source_state")->text().contains("the next one"));
  }

  window.after([&] { window.act("reset"); });
  REQUIRE(window.bench().run_state() == Workbench::Run::ready);
  const std::uint64_t epoch = window.bench().epoch();
  type(shipped + "// again\n");
  window.answer = MainWindow::Answer::save;
  Q_EMIT window.get<QTabWidget>("source_tabs")->tabCloseRequested(0);
  CHECK(bytes_of(left) == shipped + "// again\n");
  CHECK(wait_for([&] { return window.bench().epoch() > epoch; }));  // the run reads it again
}
