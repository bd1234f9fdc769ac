// The clicks of docs/desktop.md: from an empty world to a robot that avoids obstacles.
#include <QAction>
#include <QFileInfo>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QToolBar>
#include <map>

#include <catch2/catch.hpp>

#include "scene/scene_view.h"
#include "window.h"
#include "world/form.h"

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
  /// `last`: the button that closes the dialog after that.
  void on_ok(const char* dialog, QDialogButtonBox::StandardButton last = QDialogButtonBox::Ok) {
    auto* buttons = window_.dialog(dialog)->findChild<QDialogButtonBox*>("buttons");
    window_.after([&] { on(buttons->button(QDialogButtonBox::Ok)); });
    if (last != QDialogButtonBox::Ok) {
      REQUIRE(wait_for([&] { return buttons->button(last) != nullptr; }));
      on(buttons->button(last));
    }
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
  REQUIRE(wait_for([&] { return window.bench().run_state() == Workbench::Run::ended; }));
  CHECK(window.bench().time_s() > 299.0);

  // The file runs headless.
  const QString file = window.folder() + "/walk.xml";
  REQUIRE(window.saved_as(file).isEmpty());
  window.after([&] { window.bench().reset(1); });
  CHECK(window.hash_at_the_end() == headless_hash({file}));

  // It drives all the time, and touches nothing.
  const Json robot = headless({file}).at("robots").front();
  CHECK(robot.at("distance_m").get<double>() > 60.0);
  CHECK(robot.at("collisions").get<int>() == 0);
}

TEST_CASE("Case 1 of the experiments is built, trained, run and saved in the window alone") {
  Window window;
  Clicks click(window);
  const auto filled = [&](const char* form, const std::map<QString, QString>& values) {
    QDialog* dialog = window.dialog("element_dialog");
    for (const auto& [name, value] : values) {
      auto* edit = dialog->findChild<Form*>(form)->findChild<QLineEdit*>(name);
      INFO(name.toStdString());
      REQUIRE(edit);
      type_over(edit, value);
    }
    return dialog;
  };
  const auto add = [&](const char* action, const char* form,
                       const std::map<QString, QString>& values) {
    window.act(action);
    filled(form, values);
    click.on_ok("element_dialog");
  };
  const auto add_sensor = [&](const char* kind, const std::map<QString, QString>& values) {
    window.choose("robot[collector]");
    window.act("add_sensor");
    auto* kinds = window.dialog("element_dialog")->findChild<QListWidget*>("kinds");
    kinds->setCurrentItem(kinds->findItems(kind, Qt::MatchExactly).front());
    filled((std::string("form_") + kind).c_str(), values);
    click.on_ok("element_dialog");
  };

  window.after([&] { click.on(window.get<QPushButton>("empty_world")); });
  add("arena", "form_arena", {{"length", "10"}, {"width", "10"}});
  for (const auto& [x, y] : {std::pair{"4", "4"}, {"-4", "4"}, {"-4", "-4"}, {"4", "-4"}}) {
    add("add_resource", "form_resource", {{"x", x}, {"y", y}});
  }
  add("add_robot", "form_robot", {{"id", "collector"}});
  add_sensor("beam_range", {{"id", "left"}, {"yaw_deg", "15"}});
  add_sensor("beam_range", {{"id", "right"}, {"yaw_deg", "-15"}});
  add_sensor("vision", {{"id", "eye"}});

  window.choose("robot[collector]");
  window.act("behaviors");
  QDialog* behaviors = window.dialog("behaviors_dialog");
  auto* pool = behaviors->findChild<QListWidget*>("pool");
  for (const char* name : {"avoid_obstacle", "find_resource"}) {
    pool->setCurrentItem(pool->findItems(name, Qt::MatchExactly).front());
    click.on(behaviors->findChild<QPushButton*>("add"));
  }
  click.on_ok("behaviors_dialog");

  const QString file = window.folder() + "/case_1.xml";
  REQUIRE(window.saved_as(file).isEmpty());  // the weights are written next to it
  window.choose("robot[collector]");
  window.act("coordinator");
  auto* kinds = window.dialog("element_dialog")->findChild<QListWidget*>("kinds");
  kinds->setCurrentItem(kinds->findItems("fusion_neural_network", Qt::MatchExactly).front());
  filled("form_fusion_neural_network",
         {{"hidden", "2 2"},
          {"training",
           QFileInfo(build_file("../share/elsie/training_sets/two_sensors_two_behaviors.txt"))
               .canonicalFilePath()},
          {"attempts", "10"}});
  click.on_ok("element_dialog", QDialogButtonBox::Close);  // trains, and shows how
  CHECK(window.bench().text().contains(".weights"));
  add("add_goal", "form_collect", {});
  add("limits", "form_limits", {{"time", "60"}});

  REQUIRE(window.saved_as(file).isEmpty());
  CHECK(window.hash_at_the_end() == headless_hash({file}));
}
