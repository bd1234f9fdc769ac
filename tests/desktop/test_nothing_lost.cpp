// What a user typed, changed or had on disk is there whatever happens.
#include <QDir>
#include <QFile>
#include <QFileSystemWatcher>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTimer>
#include <csignal>

#include <catch2/catch.hpp>
#include <sys/resource.h>
#include <sys/stat.h>

#include "engine/recovery.h"
#include "text/problems_panel.h"
#include "text/world_editor.h"
#include "window.h"
#include "world/form.h"
#include "world/properties.h"

using namespace elsie::desktop;

namespace {

QByteArray bytes_of(const QString& path) {
  QFile file(path);
  REQUIRE(file.open(QIODevice::ReadOnly));
  return file.readAll();
}

void write(const QString& path, const QByteArray& bytes) {
  QFile file(path);
  REQUIRE(file.open(QIODevice::WriteOnly));
  file.write(bytes);
}

/// Files that a process writes may be no larger than this while it lives.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit now{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &now);
  }
  ~FullDisk() { setrlimit(RLIMIT_FSIZE, &before_); }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
};

QDir kept_work() {
  return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/recovery");
}

QString leave_behind(const QString& name, const Json& json) {
  REQUIRE(kept_work().mkpath("."));
  write(kept_work().filePath(name), QByteArray::fromStdString(json.dump()));
  return kept_work().filePath(name);
}

void press_yes(QDialog* box) {
  QTest::mouseClick(qobject_cast<QMessageBox*>(box)->button(QMessageBox::Yes), Qt::LeftButton);
}
void press_no(QDialog* box) {
  QTest::mouseClick(qobject_cast<QMessageBox*>(box)->button(QMessageBox::No), Qt::LeftButton);
}

/// Types into a field of the chosen thing, and does not enter it.
void type_into(Window& window, const char* field, const QString& text) {
  auto* edit = qobject_cast<QLineEdit*>(window.get<Properties>("properties")->form().editor(field));
  REQUIRE(edit);
  edit->setFocus();
  edit->selectAll();
  QTest::keyClicks(edit, text);
}

/// What the window's own save says: "" if it is done.
QString saved(Window& window, const QString& file) {
  std::optional<QString> said;
  window.bench().save_as(file, [&](const QString& sentence) { said = sentence; });
  REQUIRE(wait_for([&] { return said.has_value(); }));
  return *said;
}

}  // namespace

TEST_CASE("Changes are made one after another, in the order of the keys") {
  Window window;
  window.open(window.file(kRoom));
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
  CHECK_FALSE(QTest::qWaitFor([&] { return answers > 0; }, 300));
  window.act("stop_engine");
  REQUIRE(wait_for([&] { return bench.engine().waiting_ms() == 0 && answers == 2; }));
  CHECK(why.contains("loops_when_made"));
  CHECK(bench.text() == "<world format=\"1\"> typed, and not right");
  CHECK(editor->toPlainText() == bench.text());
  REQUIRE(wait_for([&] { return !bench.problems().empty(); }));
  window.after([&] { bench.undo(); });
  CHECK(bench.text() == kRoom);
  QTest::qWait(50);
  CHECK(answers == 2);
}

TEST_CASE("Line ends and the mark of UTF-8 are saved as they were") {
  const QByteArray unix_text(kRoom);
  QByteArray windows_text = unix_text;
  windows_text.replace("\n", "\r\n");
  const QByteArray mark("\xEF\xBB\xBF");
  for (const QByteArray& text : {unix_text, windows_text, mark + unix_text, mark + windows_text}) {
    Window window;
    const QString file = window.file("");
    write(file, text);
    window.open(file);
    window.after([&] { window.bench().edit({"robot[r1]/@x=-1.5"}, "move"); });
    CHECK(saved(window, file).isEmpty());
    QByteArray expected = text;
    expected.replace("x=\"-1\"", "x=\"-1.5\"");
    CHECK(bytes_of(file) == expected);
  }
}

TEST_CASE("A text in another encoding is refused with its line, and what is open stays") {
  Window window;
  window.open(window.file(kRoom));
  const QString file = window.file("", "latin1.xml");
  write(file, "<world format=\"1\">\n<!-- \xE9 -->\n</world>\n");
  QString why;
  CHECK_FALSE(window.bench().open(file, why));
  CHECK(why.contains("line 2"));
  CHECK(window.bench().text() == kRoom);
}

TEST_CASE("A file that another program has changed is asked about, and never written over") {
  Window window;
  const QString file = window.file(kRoom);
  window.open(file);
  window.after([&] { window.bench().edit({"robot[r1]/@x=-1.5"}, "move"); });
  const QByteArray mine = window.bench().text().toUtf8();
  QByteArray theirs(kRoom);
  theirs.replace("a room", "their room");
  write(file, theirs);
  auto* box = window.dialog<QMessageBox>("changed_on_disk");
  CHECK(box->text().contains("unsaved"));

  SECTION("and read again if the user wishes, and undo leads back") {
    window.after(
        [&] { QTest::mouseClick(box->findChild<QPushButton*>("read_again"), Qt::LeftButton); });
    CHECK(window.bench().text().toUtf8() == theirs);
    CHECK_FALSE(window->isWindowModified());
    CHECK_FALSE(window.bench().is_changed_on_disk());
    window.after([&] { window.act("undo"); });
    CHECK(window.bench().text().toUtf8() == mine);
    CHECK(window->isWindowModified());
    CHECK(saved(window, file).isEmpty());
    CHECK(bytes_of(file) == mine);
  }
  SECTION("and Enter, which one may be typing, keeps what is unsaved") {
    QTest::keyClick(box, Qt::Key_Return);
    REQUIRE(wait_for([&] { return !window->findChild<QMessageBox*>("changed_on_disk"); }));
    CHECK(window.bench().text().toUtf8() == mine);
  }
  SECTION("and stays as it is until the user saves once more") {
    QTest::mouseClick(box->findChild<QPushButton*>("keep_mine"), Qt::LeftButton);
    CHECK(window.bench().text().toUtf8() == mine);
    CHECK(bytes_of(file) == theirs);
    CHECK(window->isWindowModified());
  }
}

TEST_CASE("A text with mistakes is there again after what another program wrote was read") {
  Window window;
  const QString file = window.file(kRoom);
  window.open(file);
  const QString typed = QString(kRoom).replace("<limits", "<limit");
  window.bench().type(typed);
  REQUIRE(wait_for([&] { return !window.bench().problems().empty(); }));
  const QByteArray theirs = QByteArray(kRoom).replace("a room", "their room");
  write(file, theirs);
  auto* box = window.dialog<QMessageBox>("changed_on_disk");
  QTest::mouseClick(box->findChild<QPushButton*>("read_again"), Qt::LeftButton);
  REQUIRE(wait_for([&] { return !window->isWindowModified(); }));
  CHECK(window.bench().is_right());
  CHECK(window.bench().text().toUtf8() == theirs);
  window.act("undo");
  REQUIRE(wait_for([&] { return window.bench().text() == typed; }));
  CHECK(wait_for([&] { return window->isWindowModified(); }));
  window.bench().give_up_unsaved();
}

TEST_CASE("A world whose file is taken away is unsaved until it is back, or saved") {
  Window window;
  const QString file = window.file(kRoom);
  window.open(file);
  CHECK_FALSE(window->isWindowModified());
  REQUIRE(QFile::remove(file));
  REQUIRE(wait_for([&] { return window->isWindowModified(); }));
  CHECK(window->statusBar()->currentMessage().contains("not on disk any more"));
  SECTION("closing asks") {
    window.answer = MainWindow::Answer::cancel;
    CHECK_FALSE(window->close());
    CHECK(window.asked == 1);
    window.answer = MainWindow::Answer::save;
    CHECK(window->close());
    CHECK(bytes_of(file) == kRoom);
  }
  SECTION("it comes back as it was") {
    write(file, kRoom);
    REQUIRE(wait_for([&] { return !window->isWindowModified(); }));
    CHECK(window->findChild<QMessageBox*>("changed_on_disk") == nullptr);
    CHECK(window->close());
    CHECK(window.asked == 0);
  }
  SECTION("a crash does not take it") {
    bool is_kept = false;
    for (const QString& name : kept_work().entryList({"*.json"}, QDir::Files)) {
      is_kept |= bytes_of(kept_work().filePath(name)).contains(file.toUtf8());
    }
    CHECK(is_kept);
  }
}

TEST_CASE("A file that a program replaces in two steps is not missed") {
  Window window;
  const QString file = window.file(kRoom);
  window.open(file);
  bool was_missed = false;
  QObject::connect(&window.bench(), &Workbench::history_changed, &window.window(),
                   [&] { was_missed |= window.bench().is_gone_from_disk(); });
  QFileSystemWatcher watcher({file});
  bool is_seen = false;
  QObject::connect(&watcher, &QFileSystemWatcher::fileChanged, &watcher, [&] { is_seen = true; });
  REQUIRE(QFile::remove(file));
  REQUIRE(wait_for([&] { return is_seen; }));
  write(file, QByteArray(kRoom).replace("a room", "their room"));
  window.dialog<QMessageBox>("changed_on_disk");
  CHECK_FALSE(was_missed);
}

TEST_CASE("The same text on disk again asks nothing") {
  Window window;
  const QString file = window.file(kRoom);
  window.open(file);
  write(file, kRoom);
  QTest::qWait(300);
  CHECK(window->findChild<QMessageBox*>("changed_on_disk") == nullptr);
}

TEST_CASE("A world that cannot be saved is said, and the file is what it was") {
  Window window;
  const QString file = window.file(kRoom);
  window.open(file);
  window.after([&] { window.bench().edit({"robot[r1]/@x=-1.5"}, "move"); });

  SECTION("on a full disk") {
    const FullDisk full(64);
    CHECK(saved(window, file).contains("could not be saved"));
  }
  SECTION("in a folder that is not there, or takes no files") {
    CHECK(saved(window, window.folder() + "/nowhere/room.xml").contains("no such folder"));
    CHECK(saved(window, "/proc/room.xml").contains("could not be saved"));
  }
  CHECK(bytes_of(file) == kRoom);
  CHECK(window.bench().file() == file);
  CHECK(window->isWindowModified());
  CHECK(saved(window, file).isEmpty());
  CHECK(bytes_of(file) == window.bench().text().toUtf8());
}

TEST_CASE("Unsaved work that cannot be kept is said once") {
  Window window;
  window.open(window.file(kRoom));
  QStringList notes;
  QObject::connect(&window.bench(), &Workbench::noted, &window.window(),
                   [&](const QString& note) { notes << note; });
  const FullDisk full(64);
  for (const char* x : {"0.1", "0.2"}) {
    window.after([&] { window.bench().edit({QString("robot[r1]/@x=") + x}, "move"); });
  }
  CHECK(notes.filter("Save the world").size() == 1);
}

TEST_CASE("Unsaved work that was left behind is offered, and a damaged one is said") {
  const QDir kept(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/recovery");
  REQUIRE(kept.mkpath("."));
  const QString whole = kept.filePath("one.json"), damaged = kept.filePath("other.json");
  write(whole, QByteArray::fromStdString(Json{{"file", ""}, {"text", kRoom}}.dump()));
  write(damaged, "{\"file\": \"/tmp/x.xml\", \"te");
  Window window;
  at_dialog("recovered", press_yes);
  window->offer_recovered();
  QString said;
  for (auto* box : window->findChildren<QMessageBox*>()) {
    said += box->text();
  }
  CHECK(said.contains("other.json"));
  REQUIRE(wait_for([&] { return window.bench().is_right(); }));
  CHECK(window.bench().text() == kRoom);
  CHECK(window->isWindowModified());
  CHECK_FALSE(QFile::exists(whole));
  CHECK(QFile::remove(damaged));
}

TEST_CASE("Two windows do not share what they keep, and what is kept outlives its window") {
  const auto texts = [] {
    QStringList all;
    for (const Recovered& each : Recovery::left_behind()) all << each.text;
    return all;
  };
  QString kept_in;
  {
    Recovery first, second;
    REQUIRE(first.keep("/w/a.xml", "one", true));
    REQUIRE(second.keep("/w/a.xml", "two", false));
    CHECK_FALSE(texts().contains("one"));  // their windows are open
    CHECK_FALSE(texts().contains("two"));
    second.forget();
  }
  CHECK(texts().contains("one"));
  CHECK_FALSE(texts().contains("two"));
  for (const Recovered& each : Recovery::left_behind()) {
    if (each.text == "one") {
      CHECK(each.is_borrowed);
      Recovery::discard(each);
    }
  }
  CHECK_FALSE(texts().contains("one"));
}

TEST_CASE("Unsaved work that is taken up is discarded only once it is kept again") {
  const QString file =
      leave_behind("full.json", {{"file", "/nowhere/w.xml"}, {"text", kRoom}, {"borrowed", true}});
  {
    Window window;
    at_dialog("recovered", press_yes);
    const FullDisk full(64);
    window->offer_recovered();
    CHECK(QFile::exists(file));
    CHECK(window.bench().is_borrowed());  // Save asks where
    CHECK(window.bench().text() == kRoom);
  }
  CHECK(QFile::remove(file));
}

TEST_CASE("What was saved, given up or replaced is not offered again") {
  const auto left = [] { return kept_work().entryList({"*.json"}, QDir::Files).size(); };
  const auto before = left();
  Window window;
  const QString file = window.file(kRoom);
  const auto change = [&] {
    window.after([&] { window.bench().edit({"robot[r1]/@x=0.25"}, "move"); });
    CHECK(left() == before + 1);
  };
  window.open(file);
  change();
  CHECK(saved(window, file).isEmpty());
  CHECK(left() == before);
  window.after([&] { window.bench().edit({"robot[r1]/@x=0.5"}, "move"); });
  window.answer = MainWindow::Answer::discard;
  window.after([&] { window.open(file); });
  CHECK(left() == before);
  window.after([&] { window.bench().edit({"robot[r1]/@x=0.75"}, "move"); });
  CHECK(window->close());
  CHECK(left() == before);
}

TEST_CASE("What is typed in a field and not entered is saved, too") {
  Window window;
  const QString file = window.file(kRoom);
  window.open(file);
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
  Window window;
  window.open(window.file(kRoom));
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

TEST_CASE("A file whose lines end in two ways keeps each of them") {
  QByteArray text(kRoom);
  text.replace("-->\n", "-->\r\n");
  text.replace("<robots>\n", "<robots>\r\n");
  Window window;
  const QString file = window.file("");
  write(file, text);
  window.open(file);
  window.after([&] { window.bench().edit({"robot[r1]/@x=-1.5"}, "move"); });
  window.after([&] { window.bench().edit({"limits/@time=61"}, "longer"); });
  CHECK(saved(window, file).isEmpty());
  text.replace("x=\"-1\"", "x=\"-1.5\"");
  text.replace("time=\"60\"", "time=\"61\"");
  CHECK(bytes_of(file) == text);
}

TEST_CASE("A write-protected file is asked about, and stays write-protected") {
  Window window;
  const QString file = window.file(kRoom);
  REQUIRE(chmod(file.toUtf8().constData(), 0444) == 0);
  window.open(file);
  window.after([&] { window.bench().edit({"robot[r1]/@x=-1.5"}, "move"); });
  at_dialog("write_protected", press_no);
  window.act("save");
  CHECK(bytes_of(file) == kRoom);
  CHECK(window->isWindowModified());
  at_dialog("write_protected", press_yes);
  window.act("save");
  CHECK(bytes_of(file).contains("-1.5"));
  CHECK_FALSE(window->isWindowModified());
  CHECK((QFile::permissions(file) & (QFile::WriteOwner | QFile::WriteGroup)) == 0);
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
  CHECK(saved(window, target).isEmpty());
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
  CHECK(saved(window, target).isEmpty());
  window.after([&] { bench.reset(1); });
  CHECK(window.run_to_the_end().at("state_hash").get<std::string>() == headless_hash({target}));
}

TEST_CASE("A new world that was saved finds what lies beside it") {
  Window window;
  window.bench().open_text(kRoom, {}, false);
  REQUIRE(wait_for([&] { return window.bench().is_right(); }));
  CHECK(saved(window, window.folder() + "/mine.xml").isEmpty());
  window.file("<robot_template format=\"1\" max_speed=\"0.1\"/>", "beside.xml");
  Problems refused{{}};
  window.bench().edit({"robot[r1]/@template=beside.xml"}, "template", {}, &window.window(),
                      [&](const Problems& problems) { refused = problems; });
  REQUIRE(wait_for([&] { return refused.empty() || !refused.front().message.isEmpty(); }));
  CHECK(refused.empty());
}

TEST_CASE("What is no file of a world is refused at once, and not waited for") {
  Window window;
  window.open(window.file(kRoom));
  const QString pipe = window.folder() + "/pipe.xml";
  REQUIRE(mkfifo(pipe.toUtf8().constData(), 0600) == 0);
  for (const QString& file : {pipe, QString("/dev/zero"), window.folder()}) {
    QString why;
    CHECK_FALSE(window.bench().open(file, why));
    CHECK(why.contains("device or a pipe"));
  }
  QFile large(window.folder() + "/large.xml");
  REQUIRE((large.open(QIODevice::WriteOnly) && large.resize(40'000'000)));
  QString why;
  CHECK_FALSE(window.bench().open(large.fileName(), why));
  CHECK(why.contains("32 MB"));
  CHECK(window.bench().text() == kRoom);
}

TEST_CASE("A file that was taken away and comes back is watched, as before") {
  Window window;
  const QString file = window.file(kRoom);
  window.open(file);
  QFileSystemWatcher watcher({file});
  bool is_seen = false;
  QObject::connect(&watcher, &QFileSystemWatcher::fileChanged, &watcher, [&] { is_seen = true; });
  REQUIRE(QFile::remove(file));
  REQUIRE(wait_for([&] { return is_seen; }));
  QApplication::processEvents();
  write(file, QByteArray(kRoom).replace("a room", "their room"));
  auto* box = window.dialog<QMessageBox>("changed_on_disk");
  QTest::mouseClick(box->findChild<QPushButton*>("keep_mine"), Qt::LeftButton);
  // And changes after that.
  REQUIRE(wait_for([&] { return !window->findChild<QMessageBox*>("changed_on_disk"); }));
  write(file, QByteArray(kRoom).replace("a room", "another room"));
  CHECK(window.dialog<QMessageBox>("changed_on_disk"));
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

// Started as a program of its own by the next test.
TEST_CASE("A window with unsaved work is killed", "[.killed]") {
  Window window;
  window.open(qEnvironmentVariable("ELSIE_TEST_HOME") + "/room.xml");
  window.after([&] { window.bench().edit({"robot[r1]/@x=0.25"}, "move"); });
  ::raise(SIGKILL);
}

// As the one before.
TEST_CASE("A window with an edit that waits is killed", "[.killed_waiting]") {
  Window window({}, {"--plugin-path", build_file("../tests/program/plugins")});
  window.open(qEnvironmentVariable("ELSIE_TEST_HOME") + "/waiting.xml");
  window.bench().set_speed(0.0);
  window.bench().run();
  REQUIRE(wait_for([&] { return window.bench().engine().waiting_ms() > 1000; }));
  window.bench().edit({"robot[r1]/@x=0.25"}, "move");
  ::raise(SIGKILL);
}

TEST_CASE("An edit that waited when its window was killed is made in the next one") {
  const QString home = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation);
  std::ofstream((home + "/waiting.xml").toStdString())
      << QString(kRoom).replace("<wander/>", "<looping/>").toStdString();
  QProcess killed;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert("ELSIE_TEST_HOME", home);
  killed.setProcessEnvironment(environment);
  killed.start(QApplication::applicationFilePath(), {"[.killed_waiting]"});
  REQUIRE(killed.waitForFinished(kPatience_ms));
  REQUIRE(killed.exitStatus() == QProcess::CrashExit);
  Window window({}, {"--plugin-path", build_file("../tests/program/plugins")});
  at_dialog("recovered", press_yes);
  window->offer_recovered();
  REQUIRE(wait_for([&] { return window.bench().undo_name() == "move"; }));
  CHECK(window.bench().text().contains("x=\"0.25\""));
  CHECK(window->isWindowModified());
}

TEST_CASE("The unsaved work of a window that was killed is offered by the next one") {
  const QString home = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation);
  std::ofstream((home + "/room.xml").toStdString()) << kRoom;
  QProcess killed;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert("ELSIE_TEST_HOME", home);
  killed.setProcessEnvironment(environment);
  killed.start(QApplication::applicationFilePath(), {"[.killed]"});
  REQUIRE(killed.waitForFinished(kPatience_ms));
  REQUIRE(killed.exitStatus() == QProcess::CrashExit);
  Window window;
  at_dialog("recovered", [&](QDialog* dialog) {
    CHECK(qobject_cast<QMessageBox*>(dialog)->text().contains(home + "/room.xml"));
    press_yes(dialog);
  });
  window->offer_recovered();
  REQUIRE(wait_for([&] { return window.bench().is_right(); }));
  CHECK(window.bench().text().contains("x=\"0.25\""));
  CHECK(window.bench().file() == home + "/room.xml");
  CHECK(window->isWindowModified());
}
