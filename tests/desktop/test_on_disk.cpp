// The file of a world on disk, which other programs change, and that cannot always be written.
#include <QFileSystemWatcher>
#include <QStatusBar>
#include <QTest>

#include <catch2/catch.hpp>
#include <sys/stat.h>

#include "disk.h"

using namespace elsie::desktop;

TEST_CASE("Line ends and the mark of UTF-8 are kept; of two kinds, the more frequent one") {
  const QByteArray unix_text(kRoom);
  const QByteArray windows_text = QByteArray(kRoom).replace("\n", "\r\n");
  const QByteArray mixed =
      QByteArray(kRoom).replace("-->\n", "-->\r\n").replace("<robots>\n", "<robots>\r\n");
  const QByteArray mark("\xEF\xBB\xBF");
  for (QByteArray text : {unix_text, windows_text, mixed, mark + unix_text, mark + windows_text}) {
    Window window;
    const QString file = window.file("");
    write(file, text);
    window.open(file);
    window.after([&] { window.bench().edit({"robot[r1]/@x=-1.5"}, "move"); });
    window.after([&] { window.bench().edit({"limits/@time=61"}, "longer"); });
    CHECK(window.saved_as(file).isEmpty());
    if (text == mixed) text = unix_text;
    text.replace("x=\"-1\"", "x=\"-1.5\"").replace("time=\"60\"", "time=\"61\"");
    CHECK(bytes_of(file) == text);
  }
}

TEST_CASE("A text in another encoding is refused with its line, and what is open stays") {
  Room window;
  const QString file = window.file("", "latin1.xml");
  write(file, "<world format=\"1\">\n<!-- \xE9 -->\n</world>\n");
  QString why;
  CHECK_FALSE(window.bench().open(file, why));
  CHECK(why.contains("line 2"));
  CHECK(window.bench().text() == kRoom);
}

TEST_CASE("A file that another program has changed is asked about, and never written over") {
  Room window;
  const QString file = window.bench().file();
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
    CHECK(window.saved_as(file).isEmpty());
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
  Room window;
  const QString file = window.bench().file();
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
  Room window;
  const QString file = window.bench().file();
  CHECK_FALSE(window->isWindowModified());
  REQUIRE(QFile::remove(file));
  REQUIRE(wait_for([&] { return window->isWindowModified(); }));
  CHECK(window.said().contains("not on disk any more"));
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

TEST_CASE("The same text on disk again asks nothing") {
  Room window;
  const QString file = window.bench().file();
  write(file, kRoom);
  QTest::qWait(300);
  CHECK(window->findChild<QMessageBox*>("changed_on_disk") == nullptr);
}

TEST_CASE("A world that cannot be saved is said, and the file is what it was") {
  Room window;
  const QString file = window.bench().file();
  window.after([&] { window.bench().edit({"robot[r1]/@x=-1.5"}, "move"); });

  SECTION("on a full disk") {
    const FullDisk full(64);
    CHECK(window.saved_as(file).contains("could not be saved"));
  }
  SECTION("in a folder that is not there, or takes no files") {
    CHECK(window.saved_as(window.folder() + "/nowhere/room.xml").contains("no such folder"));
    CHECK(window.saved_as("/proc/room.xml").contains("could not be saved"));
  }
  CHECK(bytes_of(file) == kRoom);
  CHECK(window.bench().file() == file);
  CHECK(window->isWindowModified());
  CHECK(window.saved_as(file).isEmpty());
  CHECK(bytes_of(file) == window.bench().text().toUtf8());
}

TEST_CASE("A world whose folder is taken away says so when it is saved") {
  Window window;
  QDir(window.folder()).mkdir("mine");
  const QString file = window.file(kRoom, "mine/room.xml");
  window.open(file);
  window.after([&] { window.bench().edit({"robot[r1]/@x=-1.5"}, "move"); });
  REQUIRE(QDir(window.folder() + "/mine").removeRecursively());
  const QString why = window.saved_as(file);
  CHECK(why.contains("there is no folder '" + window.folder() + "/mine'"));
  CHECK_FALSE(why.contains("unchanged"));
  window.bench().give_up_unsaved();
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

TEST_CASE("What is no file of a world is refused at once, and not waited for") {
  Room window;
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

TEST_CASE("A file that a program replaces in two steps is not missed, and is watched as before") {
  Room window;
  const QString file = window.bench().file();
  bool was_missed = false;
  QObject::connect(&window.bench(), &Workbench::history_changed, &window.window(),
                   [&] { was_missed |= window.bench().is_gone_from_disk(); });
  QFileSystemWatcher watcher({file});
  bool is_seen = false;
  QObject::connect(&watcher, &QFileSystemWatcher::fileChanged, &watcher, [&] { is_seen = true; });
  REQUIRE(QFile::remove(file));
  REQUIRE(wait_for([&] { return is_seen; }));
  write(file, QByteArray(kRoom).replace("a room", "their room"));
  auto* box = window.dialog<QMessageBox>("changed_on_disk");
  CHECK_FALSE(was_missed);
  QTest::mouseClick(box->findChild<QPushButton*>("keep_mine"), Qt::LeftButton);
  // And changes after that.
  REQUIRE(wait_for([&] { return !window->findChild<QMessageBox*>("changed_on_disk"); }));
  write(file, QByteArray(kRoom).replace("a room", "another room"));
  CHECK(window.dialog<QMessageBox>("changed_on_disk"));
}
