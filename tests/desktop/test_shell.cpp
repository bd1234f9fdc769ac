// The shell of the window: icons, bars, theme, docks that come by themselves, and the palette of
// commands.
#include <QDockWidget>
#include <QListWidget>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QToolBar>

#include <catch2/catch.hpp>

#include "command_palette.h"
#include "hands.h"
#include "look/icons.h"
#include "look/language.h"
#include "look/theme.h"
#include "scene/scene_view.h"
#include "text/code_editor.h"
#include "text/problems_panel.h"
#include "text/sources_panel.h"
#include "watch/coordination_panel.h"
#include "watch/plots_panel.h"
#include "world/words.h"

using namespace elsie::desktop;

namespace {

/// The colour of the lines of an icon.
QColor ink_of(const QIcon& icon) {
  const QImage picture = icon.pixmap(QSize(32, 32)).toImage();
  QColor darkest(Qt::transparent);
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const QColor pixel = picture.pixelColor(x, y);
      if (pixel.alpha() > darkest.alpha()) darkest = pixel;
    }
  }
  return darkest;
}

bool is_shown(Window& window, const char* dock) {
  return !window.get<QDockWidget>(dock)->isHidden();
}

/// What the palette lists first for these letters.
QString first_for(Window& window, const char* letters) {
  QString first;
  at_dialog("commands_dialog", [&](QDialog* dialog) {
    QTest::keyClicks(dialog->findChild<QLineEdit*>("wish"), letters);
    first = dialog->findChild<QListWidget*>("fitting")->item(0)->text();
    dialog->reject();
  });
  press_key(&window.window(), Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
  return first;
}

/// Types into the palette and presses Enter.
void command_by_typing(Window& window, const char* letters) {
  at_dialog("commands_dialog", [letters](QDialog* dialog) {
    QTest::keyClicks(dialog->findChild<QLineEdit*>("wish"), letters);
    QTest::keyClick(dialog->findChild<QLineEdit*>("wish"), Qt::Key_Return);
  });
  press_key(&window.window(), Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
}

}  // namespace

TEST_CASE("Every tool has an icon, and a tool tip where it shows no word") {
  Room window;
  for (const char* name : {"tools", "environment"}) {
    for (const QAction* each : window.get<QToolBar>(name)->actions()) {
      const auto* button = qobject_cast<QToolButton*>(
          window.get<QToolBar>(name)->widgetForAction(const_cast<QAction*>(each)));
      if (!button) continue;
      INFO(button->text().toStdString());
      CHECK_FALSE(button->icon().isNull());
      CHECK_FALSE(button->toolTip().isEmpty());
    }
  }
}

TEST_CASE("Icons have the colour of the texts next to them, in light and dark") {
  const QString before = theme();
  for (const char* name : {"light", "dark"}) {
    choose_theme(name);
    CHECK(ink_of(icon("save")) == QApplication::palette().color(QPalette::ButtonText));
  }
  CHECK(icon("no such drawing").isNull());
  choose_theme(before);
}

TEST_CASE("The theme is chosen in the menu, shows at once, and stays for the user") {
  const QString before = theme();
  Window window;
  window.act("theme_dark");
  CHECK(wait_for([&] { return is_dark(window->palette()); }));
  CHECK(QSettings().value("theme").toString() == "dark");
  window.act("theme_light");
  CHECK(wait_for([&] { return !is_dark(window->palette()); }));
  choose_theme(before);
}

TEST_CASE("The language is chosen in the menu, and stays for the user") {
  const QString before = language();
  Window window;
  window.act("language_de");
  CHECK(language() == "de");
  CHECK(window.said().contains("next window"));
  choose_language(before);
}

TEST_CASE("All tools fit a window of 1024 pixels, as icons; a wide one has words next to them") {
  Room window;
  const auto* bar = window.get<QToolBar>("environment");
  for (const auto& [width, style] :
       {std::pair(1024, Qt::ToolButtonIconOnly), {1700, Qt::ToolButtonTextBesideIcon}}) {
    window->resize(width, 768);
    REQUIRE(wait_for(
        [&, wide = width] { return window->width() == wide && bar->geometry().right() < wide; }));
    CHECK(bar->toolButtonStyle() == style);
    for (const char* name : {"tools", "environment"}) {
      const auto* more =
          window.get<QToolBar>(name)->findChild<QToolButton*>("qt_toolbar_ext_button");
      REQUIRE(more);
      CHECK(wait_for([&] { return !more->isVisible(); }));
    }
  }
}

TEST_CASE("The start page has the window to itself; the docks come with the world") {
  Window window;
  CHECK_FALSE(is_shown(window, "dock_world"));
  CHECK_FALSE(is_shown(window, "dock_coordination"));
  window.open(window.file(kRoom));
  CHECK(is_shown(window, "dock_world"));
  CHECK(is_shown(window, "dock_coordination"));
  window.act("start_page");
  CHECK_FALSE(is_shown(window, "dock_world"));
  window.act("start_page");
  CHECK(is_shown(window, "dock_world"));
}

TEST_CASE("Docks with nothing to show are away, and come by themselves when they have something") {
  Room window;
  window.act("layout_watch");
  CHECK_FALSE(is_shown(window, "dock_vision"));
  CHECK_FALSE(is_shown(window, "dock_fuzzy"));
  CHECK_FALSE(is_shown(window, "dock_graph"));
  CHECK(is_shown(window, "dock_sensors"));
  window.run_past(0.5);
  CHECK_FALSE(is_shown(window, "dock_vision"));  // the room has no camera

  window.open(world_file("four_resources"));
  window.bench().run();
  CHECK(wait_for([&] { return is_shown(window, "dock_vision"); }));
  window.pause();
  window.act("layout_reset");
}

TEST_CASE("Letters find a command: beginnings of words before letters in their middle") {
  CHECK(fit("", "Save"));
  CHECK_FALSE(fit("sx", "Save"));
  CHECK(*fit("save", "Save as") > *fit("save", "Autosave"));
  CHECK(*fit("sas", "Save as") > *fit("sas", "Chassis"));
}

TEST_CASE("The palette runs commands, sets numbers and goes to robots, by typing and Enter") {
  Room window;
  command_by_typing(window, "speed 3");
  CHECK(wait_for([&] { return window.bench().speed() == 3.0; }));
  command_by_typing(window, "goto r1");
  const auto* tree = window.get<WorldTree>("world_tree");
  CHECK(wait_for([&] { return tree->selection() == QStringList{"robot[r1]"}; }));
  command_by_typing(window, "frtop");
  CHECK(wait_for([&] { return window->scene().camera().pitch < -1.5; }));
}

TEST_CASE("Readable: the palette finds commands by their English words and by those of the window",
          "[readable]") {
  Room window;
  for (const auto& [letters, name] : {std::pair("german", "language_de"),
                                      {"deutsch", "language_de"},
                                      {"english", "language_en"},
                                      {"save as", "save_as"},
                                      {"from the top", "view_top"},
                                      {"undo", "undo"},
                                      {"static box", "add_static"}}) {
    INFO(letters);
    if (QString(letters) == "undo") {
      window.after([&] { window.bench().edit({"robot[r1]/@x=0"}, "move"); });
    }
    CHECK(first_for(window, letters).toStdString() ==
          window.get<QAction>(name)->text().remove('&').remove("...").toStdString());
  }
  CHECK(first_for(window, "window sensors")
            .contains(window.get<QDockWidget>("dock_sensors")->windowTitle()));
  CHECK(first_for(window, "go to r1").contains("r1"));
  if (language() == "de") {
    CHECK(first_for(window, "englisch").contains("English"));
    CHECK(first_for(window, "von oben") == window.get<QAction>("view_top")->text().remove('&'));
  }
}

TEST_CASE("A tree has one column: the name, and the kind in grey; what is given is its tool tip") {
  Room window;
  const auto* tree = window.get<WorldTree>("world_tree");
  CHECK(const_cast<WorldTree*>(tree)->tree()->columnCount() == 1);
  const QTreeWidgetItem* ahead = tree->item("robot[r1]/sensor[ahead]");
  REQUIRE(ahead);
  CHECK(ahead->text(0) == "ahead (beam_range)");
  CHECK_FALSE(ahead->icon(0).isNull());
  CHECK(tree->item("robot[r1]")->toolTip(0).contains("x=-1"));
}

TEST_CASE("Three behaviours and a plot have room below the view") {
  Room window(QString(kRoom).replace("<wander/>",
                                     "<wander/><avoid_obstacle/><go_to_point x=\"1\" y=\"0\"/>"));
  window->resize(1280, 800);
  window->arrange("author");
  run_until(window, 0.5);
  const auto* coordination = window.get<QAbstractScrollArea>("coordination");
  REQUIRE(wait_for([&] { return window->findChild<CoordinationPanel*>()->rows() == 3; }));
  CHECK(coordination->verticalScrollBar()->maximum() == 0);
  show_dock(window.window(), "dock_plots");
  auto* plots = window->findChild<PlotsPanel*>();
  REQUIRE(wait_for([&] { return plots->names().contains("r1/speed"); }));
  plots->choose("r1/speed", true);
  const auto* area = plots->findChild<QScrollArea*>();
  REQUIRE(wait_for([&] { return area->isVisible() && area->height() > 50; }));
  CHECK(area->verticalScrollBar()->maximum() == 0);
  plots->choose("r1/speed", false);
}

TEST_CASE("Names of world files are labels in words, without the unit that they end in") {
  CHECK(in_words("max_speed") == "Max speed");
  CHECK(in_words("keep_distance_m", "m") == "Keep distance");
  CHECK(in_words("turn_rad_s", "rad/s") == "Turn");
  CHECK(in_words("x", "m") == "x");
  CHECK(in_words("behaviors") == "Behaviours");  // as in all other words of the window
  CHECK(in_words("erp") == "ERP");
  CHECK(unit_in_words("deg") == QString("\u00b0"));
  CHECK(unit_in_words("rad/s/deg") == QString("rad/s/\u00b0"));
  CHECK(unit_in_words("m/s2") == QString("m/s\u00b2"));
}

TEST_CASE("A compiler's lines are below its error, in a fixed font, and lead to the file") {
  Window window;
  const QString source = window.file("first\nsecond\nthird\n", "veer.cpp");
  auto* panel = window->findChild<ProblemsPanel*>();
  panel->set_problems({{{},
                        0,
                        "'veer.cpp' cannot be compiled:\n" + source +
                            ":2:7: error: 'rate' was not declared\n    2 | second\n",
                        false}});
  auto* list = panel->findChild<QTreeWidget*>("problems");
  QTreeWidgetItem* error = list->topLevelItem(0);
  REQUIRE(error->childCount() == 2);
  CHECK(error->text(0).endsWith("'rate' was not declared"));
  CHECK(error->text(1) == "2");
  CHECK(error->child(1)->text(0) == "    2 | second");
  CHECK(QFontInfo(error->child(0)->font(0)).fixedPitch());
  Q_EMIT list->itemDoubleClicked(error->child(0), 0);
  auto* shown = window->findChild<SourcesPanel*>();
  REQUIRE(shown->has(source));
  auto* text = shown->findChild<CodeEditor*>("source_text");
  CHECK(text->textCursor().blockNumber() == 1);
  text->insertPlainText("my ");
  CHECK(shown->modified() == QStringList{source});
  CHECK(shown->save({source}).isEmpty());
  CHECK(bytes_of(source) == "first\nmy second\nthird\n");
}
