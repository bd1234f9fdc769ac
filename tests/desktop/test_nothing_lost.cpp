// What a user typed or changed is there whatever happens.
#include <QLineEdit>
#include <QTest>

#include <catch2/catch.hpp>

#include "disk.h"
#include "text/world_editor.h"
#include "world/form.h"
#include "world/properties.h"

using namespace elsie::desktop;

namespace {

/// Types into a field of the chosen thing, and does not enter it.
void type_into(Window& window, const char* field, const QString& text) {
  type_over(qobject_cast<QLineEdit*>(window.get<Properties>("properties")->form().editor(field)),
            text);
}

}  // namespace

TEST_CASE("Changes are made one after another, in the order of the keys") {
  Room window;
  auto& bench = window.bench();
  bench.edit({"robot[r1]/@x=0.1"}, "one");
  bench.edit({"robot[r1]/@x=0.2"}, "two");
  bench.undo();
  bench.undo();
  bench.edit({"robot[r1]/@y=0.5"}, "three");
  bench.undo();
  bench.redo();
  bool is_over = false;
  bench.edit({"robot[r1]/@heading_deg=5"}, "four", {}, &window.window(),
             [&](const Problems& problems) { is_over = problems.empty(); });
  REQUIRE(wait_for([&] { return is_over; }));
  CHECK(bench.text().contains("x=\"-1\""));
  CHECK(bench.text().contains("y=\"0.5\""));
  CHECK(bench.undo_name() == "four");
  window.after([&] { bench.undo(); });
  CHECK(bench.undo_name() == "three");
}

TEST_CASE("What waits when the engine ends is answered once, and what was typed stays") {
  Window window({}, {"--plugin-path", build_file("../tests/program/plugins")});
  window.open(window.file(kRoom));
  auto& bench = window.bench();
  int answers = 0;
  QString why;
  const auto hear = [&](const Problems& problems) {
    ++answers;
    if (why.isEmpty() && !problems.empty()) why = problems.front().message;  // the first
  };
  auto gone = std::make_unique<QObject>();
  bench.edit({"robot[r1]/behavior[+]=<loops_when_made/>"}, "stuck", {}, &window.window(), hear);
  bench.edit({"robot[r1]/@x=0.3"}, "for nobody", {}, gone.get(), hear);
  bench.edit({"robot[r1]/@x=0.4"}, "after that", {}, &window.window(), hear);
  gone.reset();
  auto* editor = window.get<WorldEditor>("world_editor");
  editor->setPlainText("<world format=\"1\"> typed, and not right");
  editor->commit();
  REQUIRE(wait_for([&] { return bench.engine().waiting_ms() > 1000; }));
  CHECK(answers == 0);
  window.act("stop_engine");
  REQUIRE(wait_for([&] { return bench.engine().waiting_ms() == 0 && answers == 2; }));
  CHECK(why.contains("loops_when_made"));
  CHECK(bench.text() == "<world format=\"1\"> typed, and not right");
  CHECK(editor->toPlainText() == bench.text());
  REQUIRE(wait_for([&] { return !bench.problems().empty(); }));
  window.after([&] { bench.undo(); });
  CHECK(bench.text() == kRoom);
  window.after([&] { bench.edit({"robot[r1]/@x=0.5"}, "after all of them"); });
  CHECK(answers == 2);
}

TEST_CASE("What is typed in a field and not entered is saved, too") {
  Room window;
  const QString file = window.bench().file();
  window.choose("robot[r1]");
  type_into(window, "x", "0.5");
  window.act("save");
  CHECK(bytes_of(file).contains("x=\"0.5\""));

  SECTION("and closing asks about it") {
    type_into(window, "y", "0.25");
    window.answer = MainWindow::Answer::cancel;
    CHECK_FALSE(window->close());
    CHECK(window.asked == 1);
    window.answer = MainWindow::Answer::save;
    CHECK(window->close());
    CHECK(bytes_of(file).contains("y=\"0.25\""));
  }
}

TEST_CASE("Closing asks about an edit that the engine has not made yet") {
  Room window;
  window.bench().edit({"robot[r1]/@x=0.5"}, "move");
  CHECK(window.bench().is_modified());
  window.answer = MainWindow::Answer::cancel;
  CHECK_FALSE(window->close());
  CHECK(window.asked == 1);
  // One that is refused was none.
  window.after([&] { window.bench().undo(); });
  bool is_refused = false;
  window.bench().edit({"robot[r1]/@x=far"}, "move", {}, &window.window(),
                      [&](const Problems& problems) { is_refused = !problems.empty(); });
  REQUIRE(wait_for([&] { return is_refused; }));
  CHECK_FALSE(window->isWindowModified());
}

TEST_CASE("Saving elsewhere keeps the run and what can be undone, and the engine knows the file") {
  Window window;
  REQUIRE(QDir(window.folder()).mkdir("other"));
  window.file("<robot_template format=\"1\" max_speed=\"0.2\"/>", "part.xml");
  const QString file =
      window.file(QString(kRoom).replace("id=\"r1\"", "id=\"r1\" template=\"part.xml\"").toUtf8());
  window.open(file);
  REQUIRE(window.bench().is_right());
  auto& bench = window.bench();
  window.after([&] { bench.edit({"robot[r1]/@x=-1.5"}, "move"); });
  bench.step();
  REQUIRE(wait_for([&] { return bench.time_s() > 0.0; }));
  REQUIRE(wait_for([&] { return bench.run_state() == Workbench::Run::paused; }));
  const double time_s = bench.time_s();
  const QString target = window.folder() + "/other/room.xml";
  CHECK(window.saved_as(target).isEmpty());
  CHECK(bench.time_s() == time_s);
  CHECK(bench.run_state() == Workbench::Run::paused);
  CHECK(bench.undo_name() == "move");
  CHECK_FALSE(window->isWindowModified());
  CHECK(bytes_of(target) == bench.text().toUtf8());
  CHECK(bench.text().contains("../part.xml"));

  Json command;
  bench.ask({{"do", "command"}}, [&](const Json& answer) { command = answer; });
  REQUIRE(wait_for([&] { return !command.is_null(); }));
  CHECK(QString::fromStdString(command["text"].get<std::string>()).contains(target));

  window.after([&] { bench.undo(); });
  CHECK(bench.text().contains("x=\"-1\""));
  CHECK(bench.text().contains("../part.xml"));
  CHECK(window->isWindowModified());
  window.after([&] { bench.redo(); });
  CHECK_FALSE(window->isWindowModified());

  // What is wrong in it is found in its own text, and files are searched beside it.
  auto* editor = window.get<WorldEditor>("world_editor");
  editor->setPlainText(QString(bench.text()).replace("<limits", "<limit"));
  editor->commit();
  REQUIRE(wait_for([&] { return !bench.problems().empty(); }));
  CHECK(bench.problems().front().file == target);
  window.after([&] { window.act("undo"); });
  window.file("<robot_template format=\"1\" max_speed=\"0.1\"/>", "other/beside.xml");
  window.after([&] { bench.edit({"robot[r1]/@template=beside.xml"}, "template"); });
  CHECK(window.saved_as(target).isEmpty());
  window.after([&] { bench.reset(1); });
  CHECK(window.hash_at_the_end() == headless_hash({target}));
}

TEST_CASE("A new world that was saved finds what lies beside it") {
  Window window;
  window.open_text(kRoom);
  CHECK(window.saved_as(window.folder() + "/mine.xml").isEmpty());
  window.file("<robot_template format=\"1\" max_speed=\"0.1\"/>", "beside.xml");
  Problems refused{{}};
  window.bench().edit({"robot[r1]/@template=beside.xml"}, "template", {}, &window.window(),
                      [&](const Problems& problems) { refused = problems; });
  REQUIRE(wait_for([&] { return refused.empty() || !refused.front().message.isEmpty(); }));
  CHECK(refused.empty());
}

TEST_CASE("What makes a wrong world right can be undone, and no engine is started for each try") {
  Window window;
  const QByteArray wrong = "<world format=\"1\"><arena length=\"4\" width=\"4\"";
  const QString file = window.file("");
  write(file, wrong);
  window.open(file);
  REQUIRE_FALSE(window.bench().problems().empty());
  const int generation = window.bench().engine().generation();
  window.after([&] { window.bench().type(wrong + " "); });
  window.after([&] { window.bench().type(wrong + " /"); });
  CHECK(window.bench().engine().generation() == generation);
  const QString right = wrong + "/></world>";
  window.bench().type(right);
  REQUIRE(wait_for([&] { return window.bench().is_right(); }));
  CHECK(window.bench().problems().empty());
  CHECK(window.bench().undo_name() == "type");
  const auto lead = [&](const char* way, const QString& text) {  // by as many steps as were typed
    for (int i = 0; i < 3 && window.bench().text() != text; ++i) {
      window.after([&] { window.act(way); });
    }
    CHECK(window.bench().text() == text);
  };
  lead("undo", wrong);
  CHECK_FALSE(window.bench().problems().empty());
  CHECK_FALSE(window->isWindowModified());
  lead("redo", right);
  CHECK(window.bench().is_right());
  window.bench().give_up_unsaved();
}
