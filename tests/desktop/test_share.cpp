// Runs that are shared as pages.
#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QMessageBox>
#include <QProgressDialog>
#include <QTextBrowser>
#include <QTreeWidget>

#include "export/sharer.h"
#include "hands.h"

using namespace elsie::desktop;

namespace {

const QString kShort = QString(kRoom).replace("\"60\"", "\"3\"");

/// Whether the page of the run is written. The name of the file is asked for, as by a user.
bool share(Window& window, const QString& file, const std::function<void()>& meanwhile = {}) {
  std::optional<bool> is_whole;
  auto* sharer = window->findChild<Sharer*>();
  const auto connection = QObject::connect(sharer, &Sharer::ended, &window.window(),
                                           [&](bool whole) { is_whole = whole; });
  at_dialog("export_dialog", [&](QDialog* dialog) { save_as_file(dialog, file); });
  window.act("share");
  if (meanwhile) meanwhile();
  REQUIRE(wait_for([&] { return is_whole.has_value(); }));
  QObject::disconnect(connection);
  return *is_whole;
}

QString hash_of(const Json& end) { return QString::fromStdString(end.at("state_hash")); }

/// Takes addresses in the place of the system's browser.
class Browser {
 public:
  Browser() { QDesktopServices::setUrlHandler("file", &browser_, "setSource"); }
  ~Browser() { QDesktopServices::unsetUrlHandler("file"); }
  QUrl shown() const { return browser_.source(); }

 private:
  QTextBrowser browser_;
};

}  // namespace

TEST_CASE("The run is shared as a page, and opened in the browser") {
  Browser browser;
  Room window(kShort);
  const QString hash = hash_of(window.run_to_the_end());
  const QString file = window.folder() + "/shared.html";
  REQUIRE(share(window, file));
  const QByteArray page = bytes_of(file);
  CHECK(page.startsWith("<!doctype html>"));
  CHECK(page.contains(hash.toUtf8()));
  auto* box = window.dialog<QMessageBox>("page_written");
  CHECK(box->text().contains("shared.html"));
  CHECK(box->text().contains(
      QString("%1 MB").arg(static_cast<double>(page.size()) / 1e6, 0, 'f', 2)));
  CHECK(browser.shown().isEmpty());
  QTest::mouseClick(box->findChild<QPushButton*>("open_page"), Qt::LeftButton);
  CHECK(browser.shown() == QUrl::fromLocalFile(file));
}

TEST_CASE("The page of a run in an unsaved world has its edits, and ends now") {
  Room window(QString(kShort).replace("\"3\"", "\"60\""));
  window.after([&] { window.bench().edit({"robot[r1]/@max_speed=0.11"}, "slower"); });
  run_until(window, 1.0);
  window.after([&] { window.bench().edit({"robot[r1]/@max_speed=0.22"}, "faster"); });
  run_until(window, 2.0);
  const QString file = window.folder() + "/room.html";
  REQUIRE(share(window, file));
  const QByteArray page = bytes_of(file);
  CHECK(page.contains("after 2.0 s"));
  window.file(kRoom, "edited.xml");
  const QString edited = window.folder() + "/edited.xml";
  {
    QFile text(edited);
    REQUIRE(text.open(QIODevice::WriteOnly));
    text.write(QString(kRoom).replace("team=", "max_speed=\"0.11\" team=").toUtf8());
  }
  CHECK(page.contains(headless_hash({edited, "--seed", QString::number(window.bench().seed()),
                                     "--at", "1:robot[r1]/@max_speed=0.22", "--duration", "2"})
                          .c_str()));
  CHECK(window.bench().is_modified());  // nothing is saved
}

TEST_CASE("A recording and a run of a database are shared, and not what was played of them") {
  Window window;
  SECTION("a recording") {
    const QString room = window.file(kShort.toUtf8().constData());
    const QString recording = window.folder() + "/run.mcap";
    run_elsie({"run", room, "--seed", "7", "--record", recording});
    window.open(recording);
    const QString file = window.folder() + "/seven.html";
    REQUIRE(share(window, file));
    CHECK(bytes_of(file).contains(headless_hash({room, "--seed", "7"}).c_str()));
  }
  SECTION("a run of a database") {
    REQUIRE(window->open(study_in(window, 5, 6)));
    auto* dialog = window.dialog("run_dialog");
    auto* runs = dialog->findChild<QTreeWidget*>("runs");
    runs->setFocus();
    QTest::keyClick(runs, Qt::Key_Down);
    Window::press(dialog, QDialogButtonBox::Open);
    REQUIRE(wait_for([&] { return window.bench().is_right(); }));
    const QString file = window.folder() + "/six.html";
    REQUIRE(share(window, file));
    CHECK(bytes_of(file).contains(
        headless_hash({window.folder() + "/room.xml", "--seed", "6", "--duration", "3"}).c_str()));
  }
}

TEST_CASE("A page that cannot be written says why, and leaves the file as it was") {
  Room window(kShort);
  window.run_to_the_end();
  auto* sharer = window->findChild<Sharer*>();
  std::optional<bool> is_whole;
  QObject::connect(sharer, &Sharer::ended, &window.window(), [&](bool whole) { is_whole = whole; });
  const QString notes = window.file("my notes", "notes.html");
  QString file = notes, sentence = "notes.html";
  SECTION("another file is there") {}
  SECTION("the folder does not exist") { file = "/no/such/folder/page.html"; }
  SECTION("it is no page") {
    file = window.folder() + "/page.txt";
    sentence = "must end in .html";
  }
  if (file.startsWith("/no")) sentence = "/no/such/folder/page.html";
  sharer->write(file, nullptr);
  REQUIRE(wait_for([&] { return is_whole.has_value(); }));
  CHECK_FALSE(*is_whole);
  const QString said = window.dialog<QMessageBox>("page_failed")->text();
  CAPTURE(said.toStdString());
  CHECK(said.contains(sentence));
  CHECK(bytes_of(notes) == "my notes");
}

TEST_CASE("A recording that is gone, and a cancelled page, leave the file as it was") {
  Window window;
  const QString room = window.file(kShort.toUtf8().constData());
  const QString recording = window.folder() + "/run.mcap", file = window.folder() + "/run.html";
  run_elsie({"run", room, "--record", recording});
  window.open(recording);
  SECTION("gone") {
    REQUIRE(QFile::remove(recording));
    CHECK_FALSE(share(window, file));
    CHECK(window.dialog<QMessageBox>("page_failed")->text().contains("run.mcap"));
  }
  SECTION("cancelled") {
    CHECK_FALSE(share(window, file, [&] {
      auto* progress = window.get<QProgressDialog>("page_progress");
      CHECK_FALSE(progress->isModal());
      auto* cancel = progress->findChild<QPushButton*>();
      REQUIRE(wait_for([&] { return cancel->isVisible(); }));
      QTest::mouseClick(cancel, Qt::LeftButton);
    }));
    CHECK_FALSE(window->findChild<QMessageBox*>("page_failed"));
  }
  CHECK_FALSE(QFileInfo::exists(file));
}

TEST_CASE("Without a run there is no page") {
  Room window;
  window.act("share");
  CHECK(window.said().contains("There is no run to show"));
}
