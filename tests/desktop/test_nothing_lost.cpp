// What a user typed, changed or had on disk is there whatever happens.
#include <QFile>
#include <QLabel>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QStandardPaths>
#include <QTimer>
#include <csignal>

#include <catch2/catch.hpp>
#include <sys/resource.h>

#include "text/world_editor.h"
#include "window.h"

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
    why = problems.empty() ? QString() : problems.front().message;
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

  SECTION("and read again if the user wishes") {
    window.after(
        [&] { QTest::mouseClick(box->findChild<QPushButton*>("read_again"), Qt::LeftButton); });
    CHECK(window.bench().text().toUtf8() == theirs);
    CHECK_FALSE(window->isWindowModified());
  }
  SECTION("and stays as it is until the user saves once more") {
    QTest::mouseClick(box->findChild<QPushButton*>("keep_mine"), Qt::LeftButton);
    CHECK(window.bench().text().toUtf8() == mine);
    CHECK(bytes_of(file) == theirs);
    CHECK(window->isWindowModified());
  }
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
  QTimer::singleShot(300, &window.window(), [&] {
    auto* box = window->findChild<QMessageBox*>("recovered");
    REQUIRE(box);
    box->button(QMessageBox::Yes)->click();
  });
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
