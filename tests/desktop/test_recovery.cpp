// Unsaved work outlives its window.
#include <QPlainTextEdit>
#include <QProcess>
#include <QStatusBar>
#include <csignal>
#include <fstream>

#include <catch2/catch.hpp>

#include "disk.h"
#include "engine/recovery.h"
#include "hands.h"
#include "text/sources_panel.h"

using namespace elsie::desktop;

namespace {

QString leave_behind(const QString& name, const Json& json) {
  REQUIRE(kept_work().mkpath("."));
  write(kept_work().filePath(name), QByteArray::fromStdString(json.dump()));
  return kept_work().filePath(name);
}

/// Runs a case of this program that ends with its death.
void run_until_killed(const QString& tag, const QString& home) {
  QProcess killed;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert("ELSIE_TEST_HOME", home);
  killed.setProcessEnvironment(environment);
  killed.start(QApplication::applicationFilePath(), {tag});
  REQUIRE(killed.waitForFinished(kPatience_ms));
  REQUIRE(killed.exitStatus() == QProcess::CrashExit);
}

}  // namespace

TEST_CASE("Unsaved work that cannot be kept is said once") {
  Room window;
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
  CHECK(window->offer_recovered("maze.xml"));
  CHECK(window->statusBar()->currentMessage().contains("'maze.xml' is not opened"));
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
    REQUIRE(first.keep({"/w/a.xml", "one", true}));
    REQUIRE(second.keep({"/w/a.xml", "two"}));
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
  CHECK(window.saved_as(file).isEmpty());
  CHECK(left() == before);
  window.after([&] { window.bench().edit({"robot[r1]/@x=0.5"}, "move"); });
  window.answer = MainWindow::Answer::discard;
  window.after([&] { window.open(file); });
  CHECK(left() == before);
  window.after([&] { window.bench().edit({"robot[r1]/@x=0.75"}, "move"); });
  CHECK(window->close());
  CHECK(left() == before);
}

// Started as a program of its own by the next test.
TEST_CASE("A window with unsaved work is killed", "[.killed]") {
  Window window;
  window.open(qEnvironmentVariable("ELSIE_TEST_HOME") + "/room.xml");
  window.after([&] { window.bench().edit({"robot[r1]/@x=0.25"}, "move"); });
  ::raise(SIGKILL);
}

// Likewise.
TEST_CASE("A window in which a value was typed, and not entered, is killed", "[.typing]") {
  Window window;
  window.open(qEnvironmentVariable("ELSIE_TEST_HOME") + "/room.xml");
  window.choose("robot[r1]");
  type_over(field(window, "x"), "0.25");
  ::raise(SIGKILL);
}

// Likewise.
TEST_CASE("A window is killed in whose dialog of a sensor something was typed", "[.making]") {
  Window window;
  window.open(qEnvironmentVariable("ELSIE_TEST_HOME") + "/room.xml");
  window.choose("robot[r1]");
  QDialog* dialog = window.dialog_of("add_sensor");
  type_over(dialog->findChild<QLineEdit*>("id"), "looks_left");
  type_over(dialog->findChild<QLineEdit*>("yaw_deg"), "45");
  ::raise(SIGKILL);
}

// Likewise.
TEST_CASE("A window is killed in whose dialog of a robot something was typed", "[.editing]") {
  Window window;
  window.open(qEnvironmentVariable("ELSIE_TEST_HOME") + "/room.xml");
  window.choose("robot[r1]");
  window.act("edit");
  QDialog* dialog = window.dialog("element_dialog");
  type_over(dialog->findChild<QLineEdit*>("max_speed"), "0.25");
  type_over(dialog->findChild<QLineEdit*>("coverage"), "0.75");
  ::raise(SIGKILL);
}

// Likewise.
TEST_CASE("A window is killed in which a source was changed", "[.writing]") {
  Window window;
  const QString home = qEnvironmentVariable("ELSIE_TEST_HOME");
  window.open(home + "/room.xml");
  REQUIRE(window->findChild<SourcesPanel*>()->open(home + "/veer.cpp").isEmpty());
  type_text(window.get<QWidget>("source_text"), "// more ");
  ::raise(SIGKILL);
}

TEST_CASE("What was typed in an open dialog survives: it is entered, and undo takes it back") {
  const QString home = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation);
  std::ofstream((home + "/room.xml").toStdString()) << kRoom;
  QStringList expected;
  SECTION("of a new element") {
    run_until_killed("[.making]", home);
    expected << "<beam_range id=\"looks_left\" yaw_deg=\"45\"/>";
  }
  SECTION("of one that is edited") {
    run_until_killed("[.editing]", home);
    expected << "max_speed=\"0.25\""
             << "coverage=\"0.75\"";
  }
  Window window;
  at_dialog("recovered", press_yes);
  window->offer_recovered();
  for (const QString& each : expected) {
    INFO(each.toStdString());
    CHECK(wait_for([&] { return window.bench().text().contains(each); }));
  }
  for (qsizetype i = 0; i < expected.size(); ++i) window.after([&] { window.act("undo"); });
  CHECK(window.bench().text() == kRoom);
}

TEST_CASE("A plugin that was written in the window comes back with the world that needs it") {
  Window window;
  const QString source = window.folder() + "/veer.py";
  std::ofstream(source.toStdString()) << R"(import elsie


class Veer(elsie.Behavior):
    """Drives straight on."""

    def respond(self, now):
        return elsie.Motion(forward=0.1)
)";
  QString text = QString(kRoom).replace("<wander/>", "<veer/>");
  const Json json{{"file", ""}, {"text", text.toStdString()}, {"plugins", {source.toStdString()}}};
  leave_behind("needs.json", json);
  at_dialog("recovered", press_yes);
  window->offer_recovered();
  REQUIRE(
      wait_for([&] { return window.bench().is_right() || !window.bench().problems().empty(); }));
  CHECK(window.bench().is_right());
  CHECK(window.bench().tree().is_object());
}

TEST_CASE("What a dialog has kept goes with it") {
  const auto left = [] { return kept_work().entryList({"*.json"}, QDir::Files).size(); };
  Room window;
  const auto before = left();
  window.choose("robot[r1]");
  QDialog* dialog = window.dialog_of("add_sensor");
  CHECK(left() == before);
  type_over(dialog->findChild<QLineEdit*>("id"), "looks_left");
  CHECK(left() == before + 1);
  Window::press(dialog, QDialogButtonBox::Cancel);
  CHECK(left() == before);
}

TEST_CASE("The text of a source that was not saved survives; a source that is gone is said") {
  const QString home = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation);
  std::ofstream((home + "/room.xml").toStdString()) << kRoom;
  const QString source = home + "/veer.cpp";
  std::ofstream(source.toStdString()) << "// veer\n";
  run_until_killed("[.writing]", home);
  const QByteArray before = bytes_of(source);
  const auto left = [] { return kept_work().entryList({"*.json"}, QDir::Files).size(); };
  SECTION("it is open, and not saved") {
    Window window;
    at_dialog("recovered", press_yes);
    window->offer_recovered();
    auto* text = window.get<QPlainTextEdit>("source_text");
    CHECK(text->toPlainText() == "// more // veer\n");
    CHECK(text->document()->isModified());
    CHECK(bytes_of(source) == before);
    CHECK(left() == 1);
  }
  SECTION("its file is gone") {
    REQUIRE(QFile::remove(source));
    Window window;
    at_dialog("recovered", press_yes);
    window->offer_recovered();
    QString said;
    for (auto* box : window->findChildren<QMessageBox*>()) said += box->text();
    CHECK(said.contains("veer.cpp"));
  }
  for (const QString& each : kept_work().entryList({"*.json"}, QDir::Files)) {
    QFile::remove(kept_work().filePath(each));
  }
}

TEST_CASE("A value that was typed and not entered survives, too") {
  const QString home = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation);
  std::ofstream((home + "/room.xml").toStdString()) << kRoom;
  run_until_killed("[.typing]", home);
  Window window;
  at_dialog("recovered", press_yes);
  window->offer_recovered();
  CHECK(wait_for([&] { return window.bench().text().contains("x=\"0.25\""); }));
  window.after([&] { window.act("undo"); });
  CHECK(window.bench().text() == kRoom);
}

TEST_CASE("The unsaved work of a window that was killed is offered by the next one") {
  const QString home = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation);
  std::ofstream((home + "/room.xml").toStdString()) << kRoom;
  run_until_killed("[.killed]", home);
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
