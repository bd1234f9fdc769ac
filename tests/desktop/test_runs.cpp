// Runs in the window: recordings and databases that it opens, films and recordings that it writes.
#include <QClipboard>
#include <QDir>
#include <QFileInfo>
#include <QLineEdit>
#include <QMessageBox>
#include <QToolButton>
#include <QTreeWidget>
#include <fstream>
#include <iterator>

#include <catch2/catch.hpp>

#include "control_bar.h"
#include "export/exporter.h"
#include "export/film.h"
#include "scene/scene_view.h"
#include "window.h"

using namespace elsie::desktop;

namespace {

void run_elsie(const QStringList& words) {
  QProcess program;
  program.start(build_file("elsie"), words);
  REQUIRE(program.waitForFinished(kPatience_ms));
  CAPTURE(program.readAllStandardError().toStdString());
  REQUIRE(program.exitCode() <= 1);
}

std::string content_of(const QString& file) {
  std::ifstream in(file.toStdString(), std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void run_until(Window& window, double time_s) {
  REQUIRE(wait_for([&] {
    return window.bench().run_state() == Workbench::Run::ready ||
           window.bench().run_state() == Workbench::Run::paused;
  }));
  window.bench().run_until(time_s);
  // It may be there before this looks, and its last snapshot is by a rounding error early.
  REQUIRE(wait_for([&] {
    return window.bench().run_state() != Workbench::Run::running &&
           window.bench().time_s() >= time_s - 1e-6;
  }));
}

}  // namespace

TEST_CASE("A recording opens as the world that makes the same run, at its seed") {
  Window window;
  const QString room = window.file(kRoom);
  const QString recording = window.folder() + "/run.mcap";
  run_elsie(
      {"run", room, "--seed", "7", "--record", recording, "--at", "1:robot[r1]/@max_speed=0.1"});
  window.open(recording);
  CHECK(window.bench().is_borrowed());
  CHECK(window.bench().seed() == 7);
  CHECK(window.get<QLineEdit>("seed")->text() == "7");
  CHECK(window.run_to_the_end().at("state_hash").get<std::string>() ==
        headless_hash({room, "--seed", "7", "--at", "1:robot[r1]/@max_speed=0.1"}));
}

TEST_CASE("A run of a results database opens at its seed") {
  Window window;
  window.file(kRoom);
  const QString study = window.file(R"(<experiment format="1" name="study">
  <worlds><world file="room.xml"/></worlds>
  <set path="limits/@time" value="3"/>
  <seeds from="5" to="6"/>
</experiment>
)",
                                    "study.xml");
  const QString database = window.folder() + "/study.sqlite";
  run_elsie({"batch", study, "--database", database});
  REQUIRE(window->open(database));
  auto* dialog = window.dialog("run_dialog");
  auto* runs = dialog->findChild<QTreeWidget*>("runs");
  REQUIRE(runs->topLevelItemCount() == 2);
  CHECK(runs->topLevelItem(0)->text(2) == "5");
  CHECK(runs->topLevelItem(1)->text(2) == "6");
  CHECK(runs->topLevelItem(1)->text(3) == "no_goals");
  runs->setFocus();
  QTest::keyClick(runs, Qt::Key_Down);
  Window::press(dialog, QDialogButtonBox::Open);
  REQUIRE(wait_for([&] { return window.bench().is_right(); }));
  CHECK(window.bench().seed() == 6);
  CHECK(window.run_to_the_end().at("state_hash").get<std::string>() ==
        headless_hash({window.folder() + "/room.xml", "--seed", "6", "--duration", "3"}));

  // Cancel opens nothing.
  const QString text = window.bench().text();
  REQUIRE(wait_for([&] { return !window->findChild<QDialog*>("run_dialog"); }));
  REQUIRE(window->open(database));
  Window::press(window.dialog("run_dialog"), QDialogButtonBox::Cancel);
  REQUIRE(wait_for([&] { return !window->findChild<QDialog*>("run_dialog"); }));
  CHECK(window.bench().text() == text);
}

TEST_CASE("A file that only looks like a recording is said, while the window stays alive") {
  Window window;
  window.open(window.file(kRoom));
  const QString broken = window.file("\x89MCAP0\r\n and no more", "broken.mcap");
  REQUIRE(window->open(broken));
  auto* box = window.dialog<QMessageBox>("warning");
  CHECK_FALSE(box->text().isEmpty());
  CHECK(window.bench().text() == kRoom);
}

TEST_CASE("The world of a recording is in a folder that goes with it, and is saved elsewhere") {
  Window window;
  const QString recording = window.folder() + "/run.mcap";
  run_elsie({"run", window.file(kRoom), "--record", recording, "--duration", "1"});
  window.open(recording);
  const QString borrowed = window.bench().file();
  REQUIRE(QFile::exists(borrowed));
  window.after([&] { window.open(window.file(kRoom)); });
  CHECK_FALSE(QFileInfo(borrowed).dir().exists());
  CHECK_FALSE(window.bench().is_borrowed());
}

TEST_CASE("The events of a recording are on the time line, and the run goes on to one of them") {
  Window window;
  const QString recording = window.folder() + "/run.mcap";
  run_elsie({"run", world_file("find_resource"), "--record", recording, "--duration", "12"});
  window.open(recording);
  auto* line = window->findChild<TimeLine*>();
  REQUIRE(wait_for([&] { return line->tip_at(7.25).contains("collected"); }));
  CHECK(line->tip_at(7.25).contains("in the recording"));
  CHECK(window.bench().time_s() == 0.0);
  line->setFocus();
  const auto next_at = [&](double time_s) {
    QTest::keyClick(line, Qt::Key_Period);
    return wait_for([&] {
      return window.bench().run_state() == Workbench::Run::paused &&
             std::abs(window.bench().time_s() - time_s) < 0.02;
    });
  };
  CHECK(next_at(0.31));
  CHECK(next_at(7.25));
  CHECK(wait_for([&] { return !line->tip_at(7.25).contains("in the recording"); }));
}

TEST_CASE("A film has the pictures of the run, and replaces its file only when it is whole") {
  Window window;
  window.open(window.file(kRoom));
  run_until(window, 0.5);
  const double until_s = window.bench().time_s();
  const QString film = window.folder() + "/run.avi";
  std::ofstream(film.toStdString()) << "before";
  std::optional<bool> is_whole;
  auto* exporter = window->findChild<Exporter*>();
  REQUIRE(exporter);
  QObject::connect(exporter, &Exporter::film_ended, &window.window(),
                   [&](bool whole) { is_whole = whole; });
  exporter->write_film(film);
  CHECK(content_of(film) == "before");
  REQUIRE(wait_for([&] { return is_whole.has_value(); }));
  CHECK(*is_whole);
  const std::string bytes = content_of(film);
  CHECK(bytes.substr(0, 4) == "RIFF");
  CHECK(bytes.substr(8, 4) == "AVI ");
  std::size_t pictures = 0;
  for (std::size_t at = bytes.find("\xff\xd8\xff"); at != std::string::npos;
       at = bytes.find("\xff\xd8\xff", at + 3)) {
    ++pictures;
  }
  CHECK(pictures == static_cast<std::size_t>(25.0 * until_s + 1e-6) + 1);
  // The run goes on from where it was.
  CHECK(wait_for([&] { return window->scene().stage().time_s() == until_s; }));
}

TEST_CASE("A film that cannot be written says why") {
  Window window;
  window.open(window.file(kRoom));
  run_until(window, 0.5);
  std::optional<bool> is_whole;
  auto* exporter = window->findChild<Exporter*>();
  QObject::connect(exporter, &Exporter::film_ended, &window.window(),
                   [&](bool whole) { is_whole = whole; });
  exporter->write_film(window.folder() + "/no/such/folder/run.avi");
  REQUIRE(wait_for([&] { return is_whole.has_value(); }));
  CHECK_FALSE(*is_whole);
  auto* box = window->findChild<QMessageBox*>("film_failed");
  REQUIRE(box);
  CHECK(box->text().contains("could not be written"));
}

TEST_CASE("The next run is recorded, and its command line repeats it") {
  Window window;
  const QString room = window.file(kRoom);
  window.open(room);
  const QString table = window.folder() + "/run.csv";
  window->findChild<Exporter*>()->record_into(table);
  window.after([&] { window.bench().reset(4); });
  window.run_to_the_end();
  REQUIRE(wait_for([&] { return content_of(table).find("r1") != std::string::npos; }));
  window.act("copy_command");
  REQUIRE(wait_for([] { return QApplication::clipboard()->text().contains("--seed 4"); }));
  CHECK(QApplication::clipboard()->text().contains(room));
}

TEST_CASE("The keys of the time line step through the past and to its events") {
  Window window;
  window.open(window.file(kRoom));
  run_until(window, 2.0);
  auto* line = window->findChild<TimeLine*>();
  REQUIRE(line);
  const double until_s = window.bench().time_s();
  line->mark(0.7, "first");
  line->mark(1.5, "second");
  line->setFocus();
  const auto shows = [&](double time_s) {
    return wait_for([&] { return std::abs(window->scene().stage().time_s() - time_s) < 0.06; });
  };
  QTest::keyClick(line, Qt::Key_Home);
  CHECK(shows(0.0));
  QTest::keyClick(line, Qt::Key_Period);
  CHECK(shows(0.7));
  QTest::keyClick(line, Qt::Key_Period);
  CHECK(shows(1.5));
  QTest::keyClick(line, Qt::Key_Comma);
  CHECK(shows(0.7));
  QTest::keyClick(line, Qt::Key_Right);
  CHECK(shows(0.8));
  QTest::keyClick(line, Qt::Key_Right, Qt::ShiftModifier);
  CHECK(shows(1.8));
  QTest::keyClick(line, Qt::Key_Left);
  CHECK(shows(1.7));
  QTest::keyClick(line, Qt::Key_End);
  CHECK(shows(until_s));
  CHECK_FALSE(line->is_in_the_past());
  CHECK(line->tip_at(0.71).contains("first"));
  CHECK(line->tip_at(1.1).isEmpty());
}
