// Runs in the window: recordings and databases that it opens, films and recordings that it writes.
#include <QClipboard>
#include <QDir>
#include <QDockWidget>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QSlider>
#include <QToolButton>
#include <QTreeWidget>
#include <fstream>
#include <sstream>

#include <catch2/catch.hpp>

#include "control_bar.h"
#include "disk.h"
#include "export/exporter.h"
#include "hands.h"
#include "watch/plots_panel.h"

using namespace elsie::desktop;

namespace {

std::string content_of(const QString& file) { return bytes_of(file).toStdString(); }

/// Whether the film that is written into the file is whole.
bool write_film(Window& window, const QString& file, const std::function<void()>& meanwhile = {}) {
  std::optional<bool> is_whole;
  auto* exporter = window->findChild<Exporter*>();
  QObject::connect(exporter, &Exporter::film_ended, &window.window(),
                   [&](bool whole) { is_whole = whole; });
  exporter->write_film(file);
  if (meanwhile) meanwhile();
  REQUIRE(wait_for([&] { return is_whole.has_value(); }));
  return *is_whole;
}

}  // namespace

TEST_CASE("A recording opens as the world that makes the same run, in a folder that goes with it") {
  Window window;
  const QString room = window.file(kRoom);
  const QString recording = window.folder() + "/run.mcap";
  run_elsie(
      {"run", room, "--seed", "7", "--record", recording, "--at", "1:robot[r1]/@max_speed=0.1"});
  window.open(recording);
  CHECK(window.bench().is_borrowed());
  CHECK(window.bench().seed() == 7);
  CHECK(window.get<QLineEdit>("seed")->text() == "7");
  CHECK(window.hash_at_the_end() ==
        headless_hash({room, "--seed", "7", "--at", "1:robot[r1]/@max_speed=0.1"}));
  const QString borrowed = window.bench().file();
  REQUIRE(QFile::exists(borrowed));
  window.after([&] { window.open(room); });
  CHECK_FALSE(QFileInfo(borrowed).dir().exists());
  CHECK_FALSE(window.bench().is_borrowed());
}

TEST_CASE("A run of a results database opens at its seed") {
  Window window;
  const QString database = study_in(window, 5, 6);
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
  CHECK(window.hash_at_the_end() ==
        headless_hash({window.folder() + "/room.xml", "--seed", "6", "--duration", "3"}));

  // Cancel opens nothing.
  const QString text = window.bench().text();
  window.await_closed("run_dialog");
  REQUIRE(window->open(database));
  Window::press(window.dialog("run_dialog"), QDialogButtonBox::Cancel);
  window.await_closed("run_dialog");
  CHECK(window.bench().text() == text);
}

TEST_CASE("A file that only looks like a recording is said, while the window stays alive") {
  Room window;
  const QString broken = window.file("\x89MCAP0\r\n and no more", "broken.mcap");
  REQUIRE(window->open(broken));
  auto* box = window.dialog<QMessageBox>("warning");
  CHECK_FALSE(box->text().isEmpty());
  CHECK(window.bench().text() == kRoom);
  CHECK(box->text().startsWith('\'' + broken + '\''));  // and not with the name of a program
  CHECK_FALSE(window.said().contains("Reading"));
}

TEST_CASE("A recording whose writing was cut off says that it is not whole") {
  Window window;
  const QString whole = window.folder() + "/run.mcap";
  run_elsie({"run", world_file("find_resource"), "--record", whole, "--duration", "12"});
  const QByteArray bytes = bytes_of(whole);
  const QString cut = window.folder() + "/cut.mcap";
  write(cut, bytes.left(bytes.size() * 3 / 4));
  window.open(cut);
  auto* label = window.get<QLabel>("recording");
  REQUIRE(wait_for([&] { return label->text().contains("cut.mcap"); }));
  CHECK(label->text().contains("not whole"));
  window.open(whole);
  REQUIRE(wait_for([&] { return label->text().contains("run.mcap"); }));
  CHECK_FALSE(label->text().contains("not whole"));
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

TEST_CASE("A recording is played to its end, with the robots where they were recorded") {
  Window window;
  const QString recording = window.folder() + "/run.mcap", table = window.folder() + "/run.csv";
  run_elsie({"run", window.file(kRoom), "--seed", "7", "--duration", "3", "--record", recording,
             "--record", table});
  window.open(recording);
  auto* line = window->findChild<TimeLine*>();
  auto* slider = window.get<QSlider>("time");
  const auto* label = window.get<QLabel>("recording");
  CHECK(label->isVisible());
  CHECK(label->text() == "recording run.mcap");
  REQUIRE(wait_for([&] { return window.get<QLabel>("shown_time")->text() == "0.00 of 3.00 s"; }));

  // The scrub bar leads ahead, and the robot is where it was.
  const double across = slider->width() / 2.0;
  click_at(slider, QPoint(static_cast<int>(across), slider->height() / 2));
  REQUIRE(wait_for([&] {
    return window.bench().run_state() == Workbench::Run::paused && window.bench().time_s() > 1.0;
  }));
  CHECK(std::abs(window.bench().time_s() - 1.5) < 0.1);
  line->go_to(2.0);
  REQUIRE(wait_for([&] { return std::abs(window.bench().time_s() - 2.0) < 1e-6; }));
  std::istringstream rows(content_of(table));
  std::string row;
  while (std::getline(rows, row) && row.rfind("2,r1,", 0) != 0) {
  }
  const QStringList cells = QString::fromStdString(row).split(',');
  REQUIRE(cells.size() > 4);
  const Stage::Body* robot = window->scene().stage().body_of("robot[r1]");
  REQUIRE(robot);
  CHECK(robot->frame.origin.x == Approx(cells[2].toDouble()).margin(1e-5));
  CHECK(robot->frame.origin.y == Approx(cells[3].toDouble()).margin(1e-5));

  // Start plays from what is shown, at its speed, and comes to the end of the recording.
  QTest::keyClick(line, Qt::Key_Home);
  REQUIRE(wait_for([&] { return line->is_in_the_past() && window.bench().time_s() < 0.01; }));
  window.bench().set_speed(0.2);  // it must not end before the pause
  auto* run = window.get<QToolButton>("run");
  click_on(run);
  CHECK(line->is_playing());
  CHECK(run->text().contains("Pause"));
  CHECK(window.get<QLabel>("outcome")->text() == "playing the past");
  REQUIRE(wait_for([&] { return window.bench().time_s() > 0.1; }));
  click_on(run);
  CHECK_FALSE(line->is_playing());
  const double held_s = window.bench().time_s();
  window.bench().set_speed(2.0);
  QTest::qWait(200);
  CHECK(window.bench().time_s() - held_s < 0.2);  // one that was under way
  click_on(run);
  REQUIRE(wait_for([&] {
    return window.bench().run_state() == Workbench::Run::paused && window.bench().is_at_halt();
  }));
  CHECK(window.bench().time_s() == Approx(3.0));
  CHECK(label->text() == "recording run.mcap, as recorded");

  // What is changed is no recording any more.
  window.after([&] { window.bench().edit({"robot[r1]/@max_speed=0.1"}, "slow"); });
  window.bench().step();
  CHECK(wait_for([&] { return label->text() == "recording run.mcap, changed"; }));
  window.after([&] { window.open(window.file(kRoom)); });
  CHECK_FALSE(label->isVisible());
}

TEST_CASE("A recording of which another run was made here says so at its end") {
  Window window;
  window.file("1 1 0 1\n0.2 1 1 0\n1 0.2 1 0\n", "samples.txt");
  const QString pupil = window.file(R"(<world format="1">
  <arena length="4" width="4"/>
  <robots>
    <robot id="r1">
      <sensors><beam_range id="left" yaw_deg="35"/><beam_range id="right" yaw_deg="-35"/></sensors>
      <behaviors><avoid_obstacle/><wander/></behaviors>
      <coordinator><fusion_neural_network training="samples.txt"/></coordinator>
    </robot>
  </robots>
  <limits time="2"/>
</world>
)");
  const QString recording = window.folder() + "/run.mcap";
  run_elsie({"run", pupil, "--record", recording});
  window.file("1 1 1 0\n0.2 1 0 1\n1 0.2 0 1\n", "samples.txt");
  window.open(recording);
  const auto* label = window.get<QLabel>("recording");
  CHECK(label->text() == "recording run.mcap");
  window.run_to_the_end();
  CHECK(label->text() == "recording run.mcap, not as recorded");
  CHECK(window.dialog<QMessageBox>("warning")->text().contains("other files of the world"));
}

TEST_CASE("The table of a run is not taken for a world") {
  Window window;
  const QString table = window.folder() + "/run.csv";
  run_elsie({"run", window.file(kRoom), "--record", table, "--duration", "1"});
  CHECK_FALSE(window->open(table));
  CHECK(window.dialog<QMessageBox>("warning")->text().contains("Record the run as .mcap"));
  CHECK(window.bench().text().isEmpty());
}

TEST_CASE("A run that is over is played again from the past that is shown") {
  Room window(QString(kRoom).replace("\"60\"", "\"2\""));
  window.run_to_the_end();
  auto* line = window->findChild<TimeLine*>();
  line->go_to(1.0);
  REQUIRE(wait_for([&] { return window.bench().time_s() < 1.1; }));
  window.bench().set_speed(5.0);
  window.act("run");
  CHECK(line->is_playing());
  REQUIRE(wait_for([&] { return !line->is_in_the_past(); }));
  CHECK(window.bench().run_state() == Workbench::Run::ended);
  CHECK(wait_for([&] { return window.bench().time_s() == Approx(2.0); }));
}

TEST_CASE("Start after the end of a run starts it again") {
  Room window(QString(kRoom).replace("\"60\"", "\"2\""));
  const std::string first = window.hash_at_the_end();
  Json end;
  QObject::connect(&window.bench(), &Workbench::ended, &window.window(),
                   [&](const Json& event) { end = event; });
  click_on(window.get<QToolButton>("run"));
  REQUIRE(wait_for([&] { return !end.is_null(); }));
  CHECK(end.at("state_hash").get<std::string>() == first);
}

TEST_CASE("A film has the pictures of the run, and replaces its file only when it is whole") {
  Room window;
  run_until(window, 0.5);
  const double until_s = window.bench().time_s();
  window->findChild<TimeLine*>()->go_to(0.2);  // whatever is shown
  REQUIRE(wait_for([&] { return window.bench().time_s() < 0.3; }));
  CHECK(window.bench().latest_s() == until_s);
  const QString film = window.folder() + "/run.avi";
  std::ofstream(film.toStdString()) << "before";
  CHECK(write_film(window, film, [&] { CHECK(content_of(film) == "before"); }));
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
  Room window;
  run_until(window, 0.5);
  CHECK_FALSE(write_film(window, window.folder() + "/no/such/folder/run.avi"));
  auto* box = window->findChild<QMessageBox*>("film_failed");
  REQUIRE(box);
  CHECK(box->text().contains("could not be written"));
}

TEST_CASE("What is saved as CSV says how it was sampled") {
  Room window;
  window->arrange("watch");
  auto* plots = window->findChild<PlotsPanel*>();
  window.get<QDockWidget>("dock_plots")->raise();
  run_until(window, 1.0);
  REQUIRE(wait_for([&] { return plots->names().contains("r1/speed"); }));
  plots->choose("r1/speed", true);
  const QString table = window.folder() + "/speed.csv";
  at_dialog("save_plot_dialog", [&](QDialog* dialog) {
    CHECK(dialog->windowTitle().contains(" samples, up to "));
    save_as_file(dialog, table);
  });
  QTest::mouseClick(window.get<QToolButton>("plots_save"), Qt::LeftButton);
  CHECK(content_of(table).starts_with("time_s,r1/speed\n"));
  CHECK(window.get<QToolButton>("plots_save")->toolTip().contains("equal times"));

  at_dialog("export_dialog", [&](QDialog* dialog) {
    CHECK(dialog->windowTitle().contains("10 samples per simulated second"));
    dialog->reject();
  });
  window.act("record");
}

TEST_CASE("The next run is recorded, and its command line repeats it") {
  Room window;
  const QString room = window.bench().file();
  const QString table = window.folder() + "/run.csv";
  window->findChild<Exporter*>()->record_into(table);
  window.after([&] { window.bench().reset(4); });
  window.run_to_the_end();
  REQUIRE(wait_for([&] { return QFile::exists(table) && bytes_of(table).contains("r1"); }));
  window.act("copy_command");
  REQUIRE(wait_for([] { return QApplication::clipboard()->text().contains("--seed 4"); }));
  CHECK(QApplication::clipboard()->text().contains(room));
}

TEST_CASE("Keys and a menu of the time line lead through the past and to its events") {
  Room window;
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
  auto* menu = window.get<QMenu>("events_menu");
  Q_EMIT menu->aboutToShow();
  REQUIRE(menu->actions().size() == 2);
  CHECK(menu->actions().front()->text() == "0.70 s: first");
  menu->actions().front()->trigger();
  CHECK(shows(0.7));
  CHECK(line->is_in_the_past());
}
