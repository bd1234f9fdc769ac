// The past of a run, which the time line shows.
#include <QLabel>
#include <QStatusBar>
#include <QToolButton>

#include <catch2/catch.hpp>

#include "control_bar.h"
#include "hands.h"
#include "scene/scene_view.h"
#include "window.h"

using namespace elsie::desktop;

TEST_CASE("The past of a run is shown, and the run goes on from now") {
  Window window;
  window.open(window.file(kRoom));
  window.bench().run();
  REQUIRE(wait_for([&] { return window.bench().time_s() > 1.0; }));
  window.bench().pause();
  REQUIRE(wait_for([&] { return window.bench().run_state() == Workbench::Run::paused; }));
  const double now_s = window.bench().time_s();
  window.bench().ask({{"do", "at"}, {"time_s", 0.5}}, {});
  REQUIRE(wait_for([&] { return std::abs(window->scene().stage().time_s() - 0.5) < 0.1; }));
  window.bench().ask({{"do", "at"}}, {});
  REQUIRE(wait_for([&] { return window->scene().stage().time_s() == now_s; }));
}

TEST_CASE("A step while the view shows the past is one of the present, and the time line says so") {
  Window window;
  window.open(window.file(kRoom));
  run_until(window, 1.0);
  auto* line = window->findChild<TimeLine*>();
  auto* label = window.get<QLabel>("shown_time");
  const double now_s = window.bench().time_s();
  line->setFocus();
  QTest::keyClick(line, Qt::Key_Home);
  REQUIRE(wait_for([&] { return label->text().startsWith("0.00 of"); }));
  QTest::mouseClick(window.get<QToolButton>("step"), Qt::LeftButton);
  REQUIRE(wait_for([&] { return window.bench().time_s() > now_s; }));
  CHECK_FALSE(line->is_in_the_past());
  CHECK(label->text() == QString("%1 s").arg(window.bench().time_s(), 0, 'f', 2));
}

TEST_CASE("Looking back in a run that goes on shows how far it came") {
  Window window;
  window.open(window.file(kRoom));
  window.bench().set_speed(0.0);
  window.bench().run();
  auto* line = window->findChild<TimeLine*>();
  REQUIRE(wait_for([&] { return window.bench().time_s() > 0.5; }));
  line->setFocus();
  QTest::keyClick(line, Qt::Key_Home);
  REQUIRE(wait_for([&] { return window->scene().stage().time_s() == 0.0; }));
  Json span;
  window.bench().ask({{"do", "at"}, {"time_s", 0.0}}, [&](const Json& answer) { span = answer; });
  REQUIRE(wait_for([&] { return !span.is_null(); }));
  const QString shown = QString("0.00 of %1 s").arg(span["to_s"].get<double>(), 0, 'f', 2);
  CHECK(wait_for([&] { return window.get<QLabel>("shown_time")->text() == shown; }));
}

TEST_CASE("What is dragged in the past does not change the present") {
  Window window;
  window.open(window.file(kRoom));
  run_until(window, 1.0);
  SceneView& scene = window->scene();
  window.choose("obstacle[crate]");
  auto* line = window->findChild<TimeLine*>();
  line->setFocus();
  QTest::keyClick(line, Qt::Key_Home);
  REQUIRE(wait_for([&] { return scene.stage().time_s() == 0.0; }));
  const auto foot = scene.handle(SceneView::Tool::move);
  const auto goal = scene.pixel_of({-1.0, 1.0, 0.0});
  REQUIRE((foot && goal));
  QTest::mousePress(&scene, Qt::LeftButton, {}, foot->toPoint());
  QTest::mouseMove(&scene, (0.5 * (*foot + *goal)).toPoint());
  QTest::mouseMove(&scene, goal->toPoint());
  QTest::mouseRelease(&scene, Qt::LeftButton, {}, goal->toPoint());
  CHECK_FALSE(line->is_in_the_past());
  REQUIRE(wait_for([&] { return scene.stage().time_s() > 0.5; }));
  CHECK(window.bench().text() == kRoom);
  CHECK(window->statusBar()->currentMessage().contains("past"));
}
