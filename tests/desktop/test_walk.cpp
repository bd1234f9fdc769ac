// The clicks of docs/desktop.md: from an empty world to a robot that avoids obstacles.
#include <QAction>
#include <QListWidget>
#include <QPushButton>
#include <QToolBar>

#include <catch2/catch.hpp>

#include "scene/scene_view.h"
#include "window.h"

using namespace elsie::desktop;

namespace {

/// Clicks, counted.
class Clicks {
 public:
  explicit Clicks(Window& window) : window_(window) {}

  void on(QWidget* widget) {
    REQUIRE(widget);
    REQUIRE(widget->isEnabled());
    REQUIRE(widget->isVisible());
    ++count;
    QTest::mouseClick(widget, Qt::LeftButton);
  }
  /// The button that the tool bars have for the action.
  void on_tool(const char* action) {
    for (QToolBar* bar : window_->findChildren<QToolBar*>()) {
      if (QWidget* button = bar->widgetForAction(window_.get<QAction>(action))) {
        on(button);
        return;
      }
    }
    FAIL("no tool bar has " << action);
  }
  void on_ok(const char* dialog) {
    auto* opened = window_.dialog(dialog);
    window_.after(
        [&] { on(opened->findChild<QDialogButtonBox*>("buttons")->button(QDialogButtonBox::Ok)); });
    REQUIRE(wait_for([&] { return !window_->findChild<QDialog*>(dialog); }));
  }

  int count = 0;

 private:
  Window& window_;
};

}  // namespace

TEST_CASE("From an empty world to a robot that avoids obstacles in nine clicks") {
  Window window;
  Clicks click(window);
  window.after([&] { click.on(window.get<QPushButton>("empty_world")); });
  click.on_tool("add_robot");
  click.on_ok("element_dialog");
  click.on_tool("add_sensor");
  click.on_ok("element_dialog");
  click.on_tool("behaviors");
  click.on(window.dialog("behaviors_dialog")->findChild<QPushButton*>("add"));
  click.on_ok("behaviors_dialog");
  click.on(window.get<QToolButton>("run"));
  CHECK(click.count == 9);

  CHECK(window.bench().text().contains("<avoid_obstacle"));
  CHECK(window.bench().text().contains("<beam_range"));
  window.bench().set_speed(0.0);
  REQUIRE(wait_for([&] { return window.bench().time_s() > 60.0; }));
  const Stage::Body* robot = window->scene().stage().body_of("robot[r1]");
  REQUIRE(robot);
  // It drives, and no wall stops it.
  CHECK(std::hypot(robot->frame.origin.x, robot->frame.origin.y) > 0.1);

  // The file runs headless.
  const QString file = window.folder() + "/walk.xml";
  QString why = "not saved";
  window.bench().save_as(file, [&](const QString& sentence) { why = sentence; });
  REQUIRE(wait_for([&] { return why.isEmpty(); }));
  window.after([&] { window.bench().reset(1); });
  CHECK(window.run_to_the_end().at("state_hash").get<std::string>() == headless_hash({file}));
}
