// Films that ffmpeg writes, and pictures for print and from above.
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QMessageBox>
#include <QProgressDialog>
#include <QRadioButton>
#include <QStandardItemModel>
#include <QTimer>
#include <algorithm>
#include <cerrno>
#include <cmath>
#include <system_error>

#include "control_bar.h"
#include "export/exporter.h"
#include "hands.h"

using namespace elsie::desktop;

namespace {

/// While it lives, programs are found in this folder first, or only there.
class Programs {
 public:
  explicit Programs(bool only_there = false) : before_(qgetenv("PATH")) {
    qputenv("PATH", folder_.path().toUtf8() + (only_there ? QByteArray() : ':' + before_));
  }
  ~Programs() { qputenv("PATH", before_); }
  Programs(const Programs&) = delete;
  Programs& operator=(const Programs&) = delete;

  void add(const char* name, const QByteArray& script) {
    QFile file(folder_.filePath(name));
    REQUIRE(file.open(QIODevice::WriteOnly));
    file.write("#!/bin/sh\n" + script);
    file.close();
    REQUIRE(file.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
  }
  QString file(const char* name) const { return folder_.filePath(name); }

 private:
  QTemporaryDir folder_;
  QByteArray before_;
};

/// Writes its words beside it, and what it gets into the last of them.
const QByteArray kCopies =
    "echo \"$@\" > \"$(dirname \"$0\")/words\"\nfor last; do :; done\ncat > \"$last\"\n";

bool film_of(Window& window, const QString& file, const FilmChoice& choice,
             const std::function<void()>& meanwhile = {}) {
  std::optional<bool> is_whole;
  auto* exporter = window->findChild<Exporter*>();
  QObject::connect(exporter, &Exporter::film_ended, &window.window(),
                   [&](bool whole) { is_whole = whole; });
  exporter->write_film(file, choice);
  if (meanwhile) meanwhile();
  REQUIRE(wait_for([&] { return is_whole.has_value(); }));
  QObject::disconnect(exporter, &Exporter::film_ended, nullptr, nullptr);
  return *is_whole;
}

/// Whether the picture is written.
bool picture_of(Window& window, const std::function<void(Exporter&)>& write) {
  std::optional<bool> is_whole;
  auto* exporter = window->findChild<Exporter*>();
  QObject::connect(exporter, &Exporter::picture_ended, &window.window(),
                   [&](bool whole) { is_whole = whole; });
  write(*exporter);
  REQUIRE(wait_for([&] { return is_whole.has_value(); }));
  QObject::disconnect(exporter, &Exporter::picture_ended, nullptr, nullptr);
  return *is_whole;
}

}  // namespace

TEST_CASE("A film goes through ffmpeg in its size and speed, while the window lives") {
  Programs programs;
  programs.add("ffmpeg", kCopies);
  Room window(QString(kRoom).replace("\"60\"", "\"2\""));
  window.run_to_the_end();
  const QString mp4 = window.folder() + "/run.mp4";
  QFile before(window.file("before", "run.mp4"));
  const auto permissions =
      QFile::ReadOwner | QFile::WriteOwner | QFile::ReadUser | QFile::WriteUser | QFile::ReadGroup;
  REQUIRE(before.setPermissions(permissions));
  const bool is_whole = film_of(window, mp4, {"mp4", QSize(320, 180), 8.0}, [&] {
    CHECK_FALSE(window.get<QProgressDialog>("film_progress")->isModal());
    CHECK(bytes_of(mp4) == "before");
  });
  CHECK(is_whole);
  const int pictures = static_cast<int>(25.0 / 8.0 * window.bench().latest_s() + 1e-6) + 1;
  CHECK(bytes_of(mp4).size() == pictures * 320 * 180 * 3);
  const QString words = bytes_of(programs.file("words"));
  CHECK(words.contains("-s 320x180 -r 25 "));
  CHECK(words.contains("libx264"));
  CHECK(QDir(window.folder()).entryList({"*.mp4*", "*.part"}, QDir::Files | QDir::Hidden).size() ==
        1);
  CHECK((before.permissions() & ~(QFile::ReadUser | QFile::WriteUser)) ==
        (permissions & ~(QFile::ReadUser | QFile::WriteUser)));
  // All of the pictures show something, and not all the same.
  const QByteArray all = bytes_of(mp4);
  CHECK(all.left(320 * 180 * 3) != all.right(320 * 180 * 3));

  CHECK(film_of(window, window.folder() + "/run.webm", {"webm", QSize(320, 180), 8.0}));
  CHECK(bytes_of(programs.file("words")).contains("libvpx-vp9"));
  CHECK(film_of(window, window.folder() + "/run.gif", {"gif", QSize(320, 180), 8.0}));
  CHECK(bytes_of(programs.file("words")).contains("paletteuse"));
}

TEST_CASE("Who moves the time while a film is written does not change it") {
  Programs programs;
  programs.add("ffmpeg", kCopies);
  Room window(QString(kRoom).replace("\"60\"", "\"2\""));
  window.run_to_the_end();
  const QString calm = window.folder() + "/calm.mp4", restless = window.folder() + "/restless.mp4";
  CHECK(film_of(window, calm, {"mp4", QSize(160, 90), 8.0}));
  QTimer mover;
  QObject::connect(&mover, &QTimer::timeout, [&] {
    window.bench().ask({{"do", "at"}, {"time_s", 0.0}}, {});
  });
  CHECK(film_of(window, restless, {"mp4", QSize(160, 90), 8.0}, [&] { mover.start(10); }));
  CHECK((bytes_of(calm) == bytes_of(restless)));
}

TEST_CASE("A file that is no film is refused in a sentence") {
  Room window;
  run_until(window, 0.5);
  CHECK_FALSE(film_of(window, window.folder() + "/run.mov", {"mp4", QSize(160, 90), 8.0}));
  CHECK(window.dialog<QMessageBox>("film_failed")->text().contains("run.mov' does not end in"));
  CHECK_FALSE(QFile::exists(window.folder() + "/run.mov"));
}

TEST_CASE("A film that ffmpeg cannot write, or that is cancelled, leaves the file as it was") {
  Programs programs;
  Room window;
  run_until(window, 2.0);
  const QString mp4 = window.file("before", "run.mp4");
  SECTION("ffmpeg fails, and its last words are said") {
    programs.add("ffmpeg", "echo 'Unknown encoder libx264' >&2\nexit 1\n");
    CHECK_FALSE(film_of(window, mp4, {"mp4", QSize(320, 180), 1.0}));
    CHECK(window.dialog<QMessageBox>("film_failed")->text().contains("Unknown encoder libx264"));
  }
  SECTION("a full disk is said, which is not in its last words") {
    programs.add("ffmpeg",
                 "echo '[mp4 @ 0x1] Could not write header: No space left on device' >&2\n"
                 "echo 'Error initializing output stream 0:0 --' >&2\nexit 1\n");
    CHECK_FALSE(film_of(window, mp4, {"mp4", QSize(320, 180), 1.0}));
    const std::string said = std::generic_category().message(ENOSPC);  // in the user's language
    CHECK(window.dialog<QMessageBox>("film_failed")->text().contains(QString::fromStdString(said)));
  }
  SECTION("Cancel") {
    programs.add("ffmpeg", "exec sleep 60\n");
    CHECK_FALSE(film_of(window, mp4, {"mp4", QSize(320, 180), 1.0}, [&] {
      auto* cancel = window.get<QProgressDialog>("film_progress")->findChild<QPushButton*>();
      REQUIRE(wait_for([&] { return cancel->isVisible(); }));
      QTest::mouseClick(cancel, Qt::LeftButton);
    }));
  }
  SECTION("the run goes on") {
    programs.add("ffmpeg", "exec sleep 60\n");
    CHECK_FALSE(
        film_of(window, mp4, {"mp4", QSize(320, 180), 0.25}, [&] { window.bench().reset(2); }));
    CHECK(window.dialog<QMessageBox>("film_failed")->text().contains("meanwhile"));
  }
  CHECK(bytes_of(mp4) == "before");
  CHECK(wait_for([&] {
    return QDir(window.folder())
               .entryList({"run.mp4*", "*.part"}, QDir::Files | QDir::Hidden)
               .size() == 1;
  }));
}

TEST_CASE("Without ffmpeg the dialog says how to install it, and offers what works") {
  Programs none(true);
  Room window;
  run_until(window, 1.0);
  bool is_seen = false;
  at_dialog("film_dialog", [&](QDialog* dialog) {
    is_seen = true;
    auto* format = dialog->findChild<QComboBox*>("film_format");
    CHECK(format->currentData().toString() == "avi");
    const auto* rows = static_cast<QStandardItemModel*>(format->model());
    for (int i = 0; i < format->count(); ++i) {
      CHECK(rows->item(i)->isEnabled() == (format->itemData(i).toString() == "avi"));
    }
    CHECK(dialog->findChild<QLabel*>("film_hint")->text().contains("sudo apt install ffmpeg"));
    dialog->reject();
  });
  window.act("export_film");
  CHECK(is_seen);
}

TEST_CASE("A picture of the view has the dots for print") {
  Room window;
  run_until(window, 1.0);
  const QString file = window.folder() + "/view.png";
  REQUIRE(picture_of(window, [&](Exporter& exporter) {
    exporter.write_view(file, {false, "png", QSize(600, 400), 300});
  }));
  const QImage written(file);
  CHECK(written.size() == QSize(600, 400));
  CHECK(written.dotsPerMeterX() == 11811);
  CHECK(window->scene().picture(1).size() == window->scene().size());
}

TEST_CASE("A picture of lines is as wide as chosen, whatever the resolution of pixels") {
  Room window;
  for (const double width_cm : {100.0, 5.3, 1.0}) {
    INFO(width_cm);
    double shown_cm = 0.0;
    at_dialog("picture_dialog", [&](QDialog* dialog) {
      auto* format = dialog->findChild<QComboBox*>("picture_format");
      auto* width = dialog->findChild<QDoubleSpinBox*>("picture_width");
      dialog->findChild<QComboBox*>("picture_dpi")->setCurrentIndex(3);
      dialog->findChild<QRadioButton*>("picture_above")->setChecked(true);
      format->setCurrentIndex(format->findData("svg"));
      width->setValue(width_cm);
      shown_cm = width->value();
      Window::press(dialog, QDialogButtonBox::Ok);
    });
    const auto choice = ask_for_picture(QSize(800, 600), &window.window());
    REQUIRE(choice);
    CHECK(shown_cm == std::max(width_cm, 5.3));  // narrower ones are not offered
    CHECK(choice->size.width() / choice->dpi * 2.54 == Approx(shown_cm).margin(0.02));
    const QString file = window.folder() + "/wide.svg";
    REQUIRE(picture_of(window, [&](Exporter& it) { it.write_from_above(file, *choice); }));
    CHECK(bytes_of(file).contains(
        QStringLiteral("width=\"%1px\"").arg(std::lround(shown_cm / 2.54 * 96)).toUtf8()));
  }
}

TEST_CASE("The world from above is drawn as PNG, SVG and PDF, with the paths so far") {
  Room window;
  run_until(window, 2.0);
  const auto drawn = [&](const char* name) {
    const QString file = window.folder() + '/' + name;
    REQUIRE(picture_of(window, [&](Exporter& exporter) {
      exporter.write_from_above(file, {true, "", QSize(600, 600), 96});
    }));
    return bytes_of(file);
  };
  CHECK(QImage::fromData(drawn("above.png")).width() == 600);
  CHECK(drawn("above.svg").contains("<svg"));
  CHECK(drawn("above.svg").contains("r1"));
  CHECK(drawn("above.pdf").startsWith("%PDF"));
  // 1200 of 300 dots per inch are 4 inches, whatever the format.
  const QString svg = window.folder() + "/small.svg";
  REQUIRE(picture_of(window, [&](Exporter& exporter) {
    exporter.write_from_above(svg, {true, "svg", QSize(1200, 1200), 300});
  }));
  CHECK(bytes_of(svg).contains("width=\"384px\""));
  CHECK_FALSE(picture_of(window, [&](Exporter& exporter) {
    exporter.write_from_above("/no/such/folder/above.svg", {true, "svg", QSize(600, 600), 96});
  }));
  CHECK(window.dialog<QMessageBox>("picture_failed")->text().contains("/no/such/folder/above.svg"));
}
