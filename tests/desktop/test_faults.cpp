// Faults of plugins of every kind, in the window: the window and what is unsaved survive, and the
// plugin is named. tests/program has all of them.
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <csignal>

#include <catch2/catch.hpp>

#include "control_bar.h"
#include "export/exporter.h"
#include "scripted_engine.h"
#include "window.h"

using namespace elsie::desktop;

namespace {

QStringList options() { return {"--plugin-path", build_file("../tests/program/plugins")}; }

QString world_with(const QString& behavior) {
  return QString(kRoom).replace("<wander/>", '<' + behavior + "/>");
}

/// The processes of this program that are engines.
QList<int> engines() {
  QProcess children;
  children.start("pgrep",
                 {"-P", QString::number(QApplication::applicationPid()), "-f", "elsie session"});
  REQUIRE(children.waitForFinished(kPatience_ms));
  QList<int> found;
  for (const QByteArray& each : children.readAllStandardOutput().split('\n')) {
    if (!each.isEmpty()) found << each.toInt();
  }
  return found;
}

/// Whether a process has neither ended nor waits for its parent to see that.
bool is_running(int process) {
  QFile status(QString("/proc/%1/stat").arg(process));
  if (!status.open(QIODevice::ReadOnly)) return false;
  const QByteArray text = status.readAll();
  return text.mid(text.lastIndexOf(')') + 2, 1) != "Z";
}

/// Waits until it is so, or stops an engine that does not answer or takes long for each step.
void wait_or_stop(Window& window, bool is_slow, const std::function<bool()>& is_so,
                  const std::function<bool()>& is_over) {
  Workbench& bench = window.bench();
  const auto is_stuck = [&] {
    const qint64 waiting_ms = bench.engine().waiting_ms();
    if (waiting_ms == 0) bench.ask({{"do", "ping"}}, {});
    constexpr int kStuck_ms = 1500;
    const bool is_within_a_step = waiting_ms > 100 && waiting_ms < 250;
    return waiting_ms > kStuck_ms || (is_slow && bench.time_s() > 0.495 && is_within_a_step);
  };
  REQUIRE(wait_for([&] { return is_so() || is_stuck(); }));
  if (!is_so()) {
    window.act("stop_engine");
    REQUIRE(wait_for(is_over));
  }
}

/// What became of a run with a faulty plugin.
struct Outcome {
  QString named;  // in the report of the engine's end, or the reason for the run's
  bool is_lost = false;
  QString box;  // what the user reads of its end
};

Outcome run_world(Window& window, const QString& text) {
  const bool is_slow = text.contains("<dawdling/>") || text.contains("<sleeping/>");
  Outcome outcome;
  bool has_ended = false;
  QObject here;
  QObject::connect(&window.bench(), &Workbench::engine_lost, &here, [&](const QString& report) {
    outcome = {report, true, {}};
  });
  QObject::connect(&window.bench(), &Workbench::ended, &here, [&](const Json& end) {
    has_ended = true;
    outcome.named += QString::fromStdString(end.dump());
  });
  window.bench().open_text(text, {}, false);
  window.bench().set_speed(0.0);
  const auto is_over = [&] { return outcome.is_lost || has_ended; };
  const auto is_opened = [&] {
    return is_over() || window.bench().is_right() || !window.bench().problems().empty();
  };
  wait_or_stop(window, false, is_opened, is_over);
  for (const Problem& problem : window.bench().problems()) {
    outcome.named += problem.message;
  }
  if (window.bench().is_right() && !is_over()) {
    window.bench().run();
    wait_or_stop(window, is_slow, is_over, is_over);
  }
  for (QMessageBox* box : window->findChildren<QMessageBox*>("engine_lost")) {
    outcome.box = box->text();
    box->close();
  }
  return outcome;
}

Outcome run_with(Window& window, const QString& behavior) {
  return run_world(window, world_with(behavior));
}

/// The next world runs as if nothing had been.
void check_next_run(Window& window) {
  window.answer = MainWindow::Answer::discard;
  const QString file = window.file(QByteArray(kRoom).replace("\"60\"", "\"10\""));
  window.open(file);
  static const std::string hash = headless_hash({file});
  CHECK(window.hash_at_the_end() == hash);
}

}  // namespace

TEST_CASE("With any fault of a plugin the window goes on, and names it") {
  Window window({}, options());
  const auto name =
      GENERATE(as<std::string>(),
               // while it runs
               "throwing", "not_a_number", "segfaulting", "aborting", "exiting", "overflowing",
               "looping", "dawdling", "leaving", "rounding", "looping_at_once", "leaving_at_once",
               // before
               "throws_when_made", "loops_when_made", "loops_when_equipped",
               "crashes_when_configured", "leaving_when_made");
  const QString plugin = QString::fromStdString(name);
  CAPTURE(name);
  const Outcome outcome = run_with(window, plugin);
  CAPTURE(outcome.named.toStdString());
  CHECK(outcome.named.contains(plugin));
  CHECK(outcome.is_lost == (outcome.box.startsWith("A plugin ended the engine.") ||
                            outcome.box.startsWith("You stopped the engine.")));
  CHECK(window.bench().text() == world_with(plugin));
  CHECK(window->isWindowModified());
  check_next_run(window);
}

TEST_CASE("With a fault that nobody can lay at a plugin's door the window goes on, too") {
  Window window({}, options());
  const auto name = GENERATE(
      as<std::string>(), "crashing_elsewhere", "hoarding", "gulping", "killing", "leaving_a_thread",
      "forking", "writing_to_a_broken_pipe", "printing", "smashing_heap", "crashes_when_destroyed",
      "leaving_at_the_end", "segfaulting_beside", "looping_beside", "sleeping");
  const QString plugin = QString::fromStdString(name);
  CAPTURE(name);
  run_with(window, plugin);
  CHECK(window.bench().text() == world_with(plugin));
  check_next_run(window);
}

TEST_CASE("A coordinator, a sensor or a measure that fails is named, too") {
  Window window({}, options());
  const auto [name, from, to] = GENERATE(table<std::string, std::string, std::string>(
      {{"crashing_coordinator", "<arbiter_suppression/>", "<crashing_coordinator/>"},
       {"crashing_sensor", "<beam_range id=\"ahead\"/>", "<crashing_sensor/>"},
       {"unable_to_report", "<limits time=\"60\"/>",
        "<measures><unable_to_report/></measures><limits time=\"2\"/>"}}));
  CAPTURE(name);
  const QString text =
      QString(kRoom).replace(QString::fromStdString(from), QString::fromStdString(to));
  const Outcome outcome = run_world(window, text);
  CAPTURE(outcome.named.toStdString());
  CHECK(outcome.named.contains(QString::fromStdString(name)));
  CHECK(window.bench().text() == text);
  check_next_run(window);
}

TEST_CASE("While a plugin does not return, the window says so") {
  Window window({}, options());
  window.open_text(world_with("looping"));
  window.bench().set_speed(0.0);
  window.bench().run();
  REQUIRE(wait_for([&] { return window.said().contains("Stop the engine now"); }));
  CHECK(window.get<QLabel>("pace")->text().startsWith("0.0x"));
  CHECK(window.get<QLabel>("outcome")->text().contains("no answer"));
  QString report;
  QObject::connect(&window.bench(), &Workbench::engine_lost, &window.window(),
                   [&](const QString& said) { report = said; });
  window.act("stop_engine");
  REQUIRE(wait_for([&] { return !report.isEmpty(); }));
  CHECK(report.contains("looping"));
  CHECK(window->findChild<QMessageBox*>("engine_lost")->text().startsWith("You stopped"));
}

TEST_CASE("An edit that waits for an engine that hangs is made by the next one") {
  Window window({}, options());
  auto& bench = window.bench();
  const bool is_step = GENERATE(false, true);
  CAPTURE(is_step);
  const QString text = world_with(is_step ? "looping_at_once" : "looping");
  window.open(window.file(text.toUtf8()));
  bench.set_speed(0.0);
  is_step ? bench.step() : bench.run();
  REQUIRE(wait_for([&] { return bench.engine().waiting_ms() > 1000; }));
  bench.edit({"robot[r1]/@x=-1.5"}, "move r1");
  bench.edit({"robot[r1]/@y=0.5"}, "and again");
  CHECK(window->isWindowModified());
  window.act("stop_engine");
  REQUIRE(wait_for([&] { return bench.undo_name() == "and again"; }));
  CHECK(bench.text().contains("x=\"-1.5\""));
  CHECK(bench.text().contains("y=\"0.5\""));
  CHECK(window->isWindowModified());
  CHECK_FALSE(window->findChild<QMessageBox*>("engine_lost")->text().contains("not made"));
  window.after([&] { bench.undo(); });
  window.after([&] { bench.undo(); });
  CHECK(bench.text() == text);
  CHECK_FALSE(window->isWindowModified());
}

TEST_CASE("An edit that hangs the engine is given up and named; those after it are made") {
  Window window({}, options());
  auto& bench = window.bench();
  window.open(window.file(kRoom));
  bench.edit({"robot[r1]/behavior[+]=<loops_when_made/>"}, "add what hangs");
  bench.edit({"robot[r1]/@x=0.5"}, "move r1");
  REQUIRE(wait_for([&] { return bench.engine().waiting_ms() > 500; }));
  window.act("stop_engine");
  REQUIRE(wait_for([&] { return bench.undo_name() == "move r1"; }));
  CHECK(bench.text() == QString(kRoom).replace("x=\"-1\"", "x=\"0.5\""));
  const QString said = window->findChild<QMessageBox*>("engine_lost")->text();
  CHECK(said.contains("add what hangs"));
  CHECK_FALSE(said.contains("move r1"));
}

TEST_CASE("An engine that is killed from outside is laid at no plugin's door") {
  Room window;
  const QList<int> found = engines();
  REQUIRE(found.size() == 1);
  REQUIRE(::kill(found.front(), SIGKILL) == 0);
  auto* box = window.dialog<QMessageBox>("engine_lost");
  CHECK(box->text().startsWith("The engine ended."));
  CHECK(box->informativeText().contains("killed from outside"));
  REQUIRE(wait_for([&] { return window.bench().is_right(); }));
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

TEST_CASE("A library that never finishes loading is named once the user ends the engine") {
  QTemporaryDir folder;
  const QString sign = folder.filePath("loops");
  qputenv("TRESPASS_WHILE_LOADED", "loop");
  qputenv("TRESPASS_SIGN", sign.toUtf8());
  MainWindow window(build_file("elsie"), options());
  window.show();
  REQUIRE(wait_for([&] {
    return QFile::exists(sign) &&
           window.statusBar()->currentMessage().contains("Stop the engine now");
  }));
  qunsetenv("TRESPASS_WHILE_LOADED");
  qunsetenv("TRESPASS_SIGN");
  QString report;
  QObject::connect(&window.workbench(), &Workbench::engine_lost, &window,
                   [&](const QString& said) { report = said; });
  window.findChild<QAction*>("stop_engine")->trigger();
  REQUIRE(wait_for([&] { return !report.isEmpty(); }));
  CHECK(report.contains("trespassers"));
  window.workbench().open_text(kRoom, {}, true);
  CHECK(wait_for([&] { return window.workbench().is_right(); }));
}

TEST_CASE("A library that changes the rounding of numbers while it is loaded changes no run") {
  qputenv("TRESPASS_WHILE_LOADED", "round");
  Window window({}, options());
  qunsetenv("TRESPASS_WHILE_LOADED");
  check_next_run(window);
}

TEST_CASE("A world at the ends of what is allowed is refused, or has an end that is said") {
  const auto [from, to] = GENERATE(table<const char*, const char*>(
      {{"<sensors>", R"(<body height="8" mass="12" wheel_torque="9000"/><sensors>)"},
       {"<sensors>", R"(<body mass="1e-12" wheel_mass="1e-300"/><sensors>)"},
       {"x=\"-1\">", R"(x="-1" max_speed="90"><body wheel_torque="9000"/>)"},
       {"<obstacles>", R"(<physics cfm="0" friction="900"/><obstacles>)"},
       {"<obstacles>", R"(<physics erp="1"/><obstacles>)"},
       {"<static_box id=\"crate\"",
        R"(<dynamic_box id="crate" length="1e-300" width="1e-300" height="1e-300" mass="1e-300")"},
       {"<static_box id=\"crate\" x=\"1\" y=\"1\"/>",
        R"(<moving_box id="crate" length="1" width="3" speed="90"><waypoint x="1.9"/></moving_box>)"}}));
  CAPTURE(to);
  const QString text = QString(kRoom).replace(from, to).replace("time=\"60\"", "time=\"10\"");
  REQUIRE(text.contains(to));
  Window window;
  const Outcome outcome = run_world(window, text);
  CHECK_FALSE(outcome.is_lost);
  CHECK_FALSE(outcome.named.isEmpty());
  CHECK(window.bench().text() == text);
  check_next_run(window);
}

TEST_CASE("An engine that ends again and again is not started for ever, and is said once") {
  ScriptedEngine elsie(QString(kOpens).replace(";;", "; (sleep 0.3; kill -9 $$) & ;;"));
  ScriptedWindow window(elsie);
  window.workbench().open_text("<world/>", {}, false);
  REQUIRE(wait_for([&] {
    const Problems& problems = window.workbench().problems();
    return !problems.empty() && problems.front().message.contains("3 times");
  }));
  CHECK(wait_for([&] { return elsie.starts() == 4; }));  // the last one has no world
  CHECK(window.findChildren<QMessageBox*>("engine_lost").size() == 1);
  CHECK(window.findChild<QMessageBox*>("engine_lost")->text().contains("as a text"));
  CHECK(window.findChild<QMessageBox*>("engine_lost")->text().startsWith("The engine ended."));
  CHECK(window.findChild<QMessageBox*>("engine_lost")
            ->informativeText()
            .contains("killed from outside"));
  CHECK(window.workbench().text() == "<world/>");
  CHECK(window.workbench().engine().is_there());

  // What the user does next is tried.
  window.workbench().type("<world />");
  REQUIRE(wait_for([&] { return window.workbench().is_right(); }));
  window.workbench().give_up_unsaved();
}

TEST_CASE("A message that the window cannot use ends the engine, and not the window") {
  ScriptedEngine elsie(QString(kOpens).replace(R"(\"epoch\":1)", R"(\"epoch\":\"first\")"));
  ScriptedWindow window(elsie);
  window.workbench().open_text("<world/>", {}, false);
  REQUIRE(wait_for([&] { return !window.workbench().problems().empty(); }));
  CHECK(window.workbench().text() == "<world/>");
  CHECK(window.findChild<QMessageBox*>("engine_lost")
            ->informativeText()
            .contains("unreadable message"));
  window.workbench().give_up_unsaved();
}

TEST_CASE("What an older scene has to say is not heard") {
  ScriptedEngine elsie(
      R"(open) say "{\"answer\":$id,$world,$scene,\"epoch\":5}"
         say '{"event":"state","epoch":4,"time_s":99,"robots":[]}'
         say '{"event":"state","epoch":5,"time_s":1,"robots":[]}' ;;
)");
  MainWindow window(elsie.program(), {});
  std::vector<double> times;
  QObject::connect(&window.workbench(), &Workbench::state, &window,
                   [&](const Json& state) { times.push_back(state["time_s"].get<double>()); });
  window.workbench().open_text("<world/>", {});
  REQUIRE(wait_for([&] { return !times.empty(); }));
  CHECK(times == std::vector{1.0});
}

TEST_CASE("A seed that the engine refuses is not shown as the one that runs") {
  ScriptedEngine elsie(QString(kOpens) +
                       R"(reset) say "{\"answer\":$id,\"refused\":[{\"message\":\"no\"}]}" ;;
)");
  ScriptedWindow window(elsie);
  window.open_world();
  auto* seed = window.findChild<QLineEdit*>("seed");
  enter(seed, "77");
  CHECK(wait_for([&] { return seed->text() == "1"; }));
  CHECK(window.workbench().seed() == 1);
  CHECK(window.findChild<QLabel*>("seed_shown")->text().contains("seed 1"));
}

TEST_CASE("Playing the past stops when the past is refused") {
  ScriptedEngine elsie(QString(kOpens) +
                       R"(at) if [ -e "$(dirname "$0")/past" ]; then
      say "{\"answer\":$id,\"refused\":[{\"message\":\"no\"}]}"
    else
      touch "$(dirname "$0")/past"; say "{\"answer\":$id,\"to_s\":1000,\"time_s\":0}"
    fi ;;
)");
  ScriptedWindow window(elsie);
  window.open_world();
  auto* line = window.findChild<TimeLine*>();
  line->go_to(0.0);
  REQUIRE(wait_for([&] { return QFileInfo::exists(elsie.folder() + "/past"); }));
  bool was_playing = false;
  QObject::connect(line, &TimeLine::past_changed, &window,
                   [&] { was_playing |= line->is_playing(); });
  line->play();
  CHECK(was_playing);
  CHECK(wait_for([&] { return !line->is_playing(); }));
  CHECK_FALSE(line->is_in_the_past());
}

TEST_CASE("A run that is refused is said, and the window does not show one") {
  Room window;
  window->findChild<Exporter*>()->record_into("/proc/run.csv");
  auto* run = window.get<QToolButton>("run");
  QString why;
  QObject::connect(&window.bench(), &Workbench::refused, &window.window(),
                   [&](const Problems& problems) { why = problems.front().message; });
  QTest::mouseClick(run, Qt::LeftButton);
  REQUIRE(wait_for([&] { return !why.isEmpty(); }));
  CHECK(window.said() == why);
  CHECK(window.bench().run_state() == Workbench::Run::ready);
  CHECK(run->text().contains("Start"));
  // The next run is not recorded, and starts.
  QTest::mouseClick(run, Qt::LeftButton);
  CHECK(wait_for([&] { return window.bench().time_s() > 0.0; }));
}

TEST_CASE("Without an engine a world can be saved, and the window does not say that there is one") {
  ScriptedEngine elsie("*) exit 3 ;;\n");
  QTemporaryDir folder;
  ScriptedWindow window(elsie);
  REQUIRE(wait_for([&] { return !window.workbench().engine().is_there(); }));
  window.workbench().open_text(kRoom, {}, false);
  REQUIRE(wait_for([&] {
    return !window.workbench().problems().empty() && !window.workbench().engine().is_there();
  }));
  CHECK(window.findChild<QMessageBox*>("engine_lost")->text().contains("does not start again"));
  std::optional<QString> why;
  const QString file = folder.filePath("saved.xml");
  window.workbench().save_as(file, [&](const QString& said) { why = said; });
  REQUIRE(wait_for([&] { return why.has_value(); }));
  CHECK(why->isEmpty());
  CHECK(bytes_of(file) == kRoom);
  CHECK_FALSE(window.workbench().is_modified());
}

TEST_CASE("An engine that hangs does not hold the window up when another world is opened") {
  Window window({}, options());
  window.open_text(world_with("looping"));
  window.bench().set_speed(0.0);
  window.bench().run();
  // It hangs once it does not answer.
  REQUIRE(wait_for([&] { return window.bench().engine().waiting_ms() > 1000; }));
  const QString file = window.file(kRoom);
  const QList<int> found = engines();
  REQUIRE(found.size() == 1);
  REQUIRE(window->open(file));
  CHECK(is_running(found.front()));  // it is still ending
  REQUIRE(wait_for([&] { return window.bench().is_right(); }));
}
