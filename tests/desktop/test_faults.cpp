// Every fault of a plugin that the program knows, in the window: the window and what is unsaved
// survive, and the plugin is named.
#include <QLabel>
#include <QMessageBox>
#include <QStatusBar>

#include <catch2/catch.hpp>

#include "window.h"

using namespace elsie::desktop;

namespace {

QStringList options() { return {"--plugin-path", build_file("../tests/program/plugins")}; }

QString world_with(const QString& behavior) {
  return QString(kRoom).replace("<wander/>", '<' + behavior + "/>");
}

/// What became of a run with a faulty plugin.
struct Outcome {
  QString named;  // in the report of the engine's end, or the reason for the run's
  bool is_lost = false;
};

Outcome run_with(Window& window, const QString& behavior) {
  constexpr int kStuck_ms = 2500;  // in the midst of a second: "dawdling" sleeps that long
  Outcome outcome;
  bool has_ended = false;
  QObject here;
  QObject::connect(&window.bench(), &Workbench::engine_lost, &here, [&](const QString& report) {
    outcome = {report, true};
  });
  QObject::connect(&window.bench(), &Workbench::ended, &here, [&](const Json& end) {
    has_ended = true;
    outcome.named += QString::fromStdString(end.dump());
  });
  window.bench().open_text(world_with(behavior), {}, false);
  window.bench().set_speed(0.0);
  const auto is_over = [&] { return outcome.is_lost || has_ended; };
  const auto is_opened = [&] {
    return is_over() || window.bench().is_right() || !window.bench().problems().empty();
  };
  if (!QTest::qWaitFor(is_opened, kStuck_ms)) {
    window.act("stop_engine");
    REQUIRE(wait_for(is_over));
  }
  for (const Problem& problem : window.bench().problems()) {
    outcome.named += problem.message;
  }
  if (window.bench().is_right() && !is_over()) {
    window.bench().run();
    if (!QTest::qWaitFor(is_over, kStuck_ms)) {
      window.act("stop_engine");
      REQUIRE(wait_for(is_over));
    }
  }
  for (QMessageBox* box : window->findChildren<QMessageBox*>("engine_lost")) {
    box->close();
  }
  return outcome;
}

}  // namespace

TEST_CASE("With any fault of a plugin the window goes on, and names it") {
  Window window({}, options());
  const auto name = GENERATE(
      as<std::string>(),
      // while it runs
      "throwing", "not_a_number", "segfaulting", "dividing", "aborting", "throwing_through",
      "illegal", "bus_error", "exiting", "overflowing", "looping", "calling_nowhere",
      "smashing_stack", "dawdling", "leaving", "leaving_in_c", "leaving_quickly",
      "handling_its_crash", "rounding", "looping_at_once", "leaving_at_once",
      // before
      "throws_when_made", "loops_when_made", "loops_when_configured", "loops_when_equipped",
      "loops_when_reset", "crashes_when_made", "crashes_when_configured", "leaving_when_made");
  const QString plugin = QString::fromStdString(name);
  CAPTURE(name);
  const Outcome outcome = run_with(window, plugin);
  CAPTURE(outcome.named.toStdString());
  CHECK(outcome.named.contains(plugin));
  CHECK(window.bench().text() == world_with(plugin));
  CHECK(window->isWindowModified());

  // The next world runs as if nothing had been.
  window.answer = MainWindow::Answer::discard;
  const QString file = window.file(kRoom);
  window.open(file);
  CHECK(window.run_to_the_end().at("state_hash").get<std::string>() == headless_hash({file}));
}

TEST_CASE("With a fault that nobody can lay at a plugin's door the window goes on, too") {
  Window window({}, options());
  const auto name = GENERATE(
      as<std::string>(), "crashing_elsewhere", "leaving_elsewhere", "forgetting_handlers",
      "blocking_and_looping", "leaving_by_system_call", "becoming_another", "killing",
      "crashing_beside", "leaving_a_thread", "forking_and_crashing", "forking", "starting",
      "writing_to_a_broken_pipe", "printing", "blocking", "smashing_heap", "rounding_when_made",
      "leaving_when_destroyed", "crashes_when_destroyed", "leaving_at_the_end");
  const QString plugin = QString::fromStdString(name);
  CAPTURE(name);
  run_with(window, plugin);
  CHECK(window.bench().text() == world_with(plugin));
  const QString file = window.file(kRoom);
  window.open(file);
  CHECK(window.run_to_the_end().at("state_hash").get<std::string>() == headless_hash({file}));
}

TEST_CASE("While a plugin does not return, the window says so") {
  Window window({}, options());
  window.bench().open_text(world_with("looping"), {}, false);
  REQUIRE(wait_for([&] { return window.bench().is_right(); }));
  window.bench().set_speed(0.0);
  window.bench().run();
  QTest::qWait(300);
  window.bench().pause();  // which nobody answers
  REQUIRE(wait_for(
      [&] { return window->statusBar()->currentMessage().contains("Stop the engine now"); }));
  QString report;
  QObject::connect(&window.bench(), &Workbench::engine_lost, &window.window(),
                   [&](const QString& said) { report = said; });
  window.act("stop_engine");
  REQUIRE(wait_for([&] { return !report.isEmpty(); }));
  CHECK(report.contains("looping"));
}

TEST_CASE(
    "A library that ends the engine while it is loaded is named, and the text can be edited") {
  qputenv("TRESPASS_WHILE_LOADED", "leave");
  MainWindow window(build_file("elsie"), options());
  window.show();
  QString report;
  QObject::connect(&window.workbench(), &Workbench::engine_lost, &window,
                   [&](const QString& said) { report = said; });
  REQUIRE(wait_for([&] { return !window.workbench().engine().is_there(); }));
  qunsetenv("TRESPASS_WHILE_LOADED");
  CHECK(report.contains("trespassers"));
  window.workbench().open_text(kRoom, {}, true);
  REQUIRE(wait_for([&] { return window.workbench().is_right(); }));
}
