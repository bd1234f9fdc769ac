// The keys of commands, changed and kept for the user.
#include <QFile>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QTableWidget>

#include <catch2/catch.hpp>

#include "hands.h"
#include "scene/scene_view.h"

using namespace elsie::desktop;

namespace {

/// Sets a key by pressing it in the field of the command.
void choose_key(QDialog* dialog, const char* command, const char* filter, Qt::Key key,
                Qt::KeyboardModifiers keys) {
  auto* names = dialog->findChild<QLineEdit*>("filter");
  names->clear();
  QTest::keyClicks(names, filter);
  auto* edit = dialog->findChild<QKeySequenceEdit*>(QString("key_") + command);
  REQUIRE(edit);
  bool is_finished = false;  // it waits whether a second key follows
  QObject::connect(edit, &QKeySequenceEdit::editingFinished, dialog, [&] { is_finished = true; });
  QTest::keyClick(edit, key, keys);
  REQUIRE(wait_for([&] { return is_finished; }));
  edit->disconnect(dialog);
  CHECK(edit->keySequence() == QKeySequence(keys | key));
}

struct KeptKeys {
  KeptKeys() { QSettings().remove("shortcuts"); }
  ~KeptKeys() { QSettings().remove("shortcuts"); }
};

}  // namespace

TEST_CASE("Keys of commands are changed, and stay so for the user; a key in use is refused") {
  const KeptKeys kept;
  {
    Window window;
    window.act("shortcuts");
    QDialog* dialog = window.dialog("shortcuts_dialog");
    choose_key(dialog, "view_top", "From the top", Qt::Key_R, Qt::ControlModifier);
    Window::press(dialog, QDialogButtonBox::Ok);
    REQUIRE(dialog->isVisible());
    CHECK(dialog->findChild<QLabel*>("refusal")->text().contains("Reset"));
    choose_key(dialog, "view_top", "From the top", Qt::Key_T,
               Qt::ControlModifier | Qt::ShiftModifier);
    Window::press(dialog, QDialogButtonBox::Ok);
    CHECK_FALSE(dialog->isVisible());
  }
  Window again;
  again.open(again.file(kRoom));
  SceneView& scene = again->scene();
  REQUIRE(scene.camera().pitch > -1.5);
  press_key(&scene, Qt::Key_T, Qt::ControlModifier | Qt::ShiftModifier);
  CHECK(scene.camera().pitch < -1.5);
  CHECK(again.get<QAction>("reset")->shortcut() == QKeySequence("Ctrl+R"));

  again.act("shortcuts");
  QDialog* dialog = again.dialog("shortcuts_dialog");
  Window::press(dialog, QDialogButtonBox::RestoreDefaults);
  Window::press(dialog, QDialogButtonBox::Ok);
  CHECK(again.get<QAction>("view_top")->shortcut() == QKeySequence("7"));
}

TEST_CASE("The page of the manual has the keys of all commands, and no others") {
  QFile page(ELSIE_SOURCE_DIR "/docs/desktop.md");
  REQUIRE(page.open(QIODevice::ReadOnly));
  const QString table =
      QString::fromUtf8(page.readAll()).section("| key | command |", 1).section("\n\n", 0, 0);
  QStringList written;
  for (const QString& row : table.split('\n', Qt::SkipEmptyParts).mid(1)) {
    written << row.section('|', 1, 1).trimmed() + " = " + row.section('|', 2, 2).trimmed();
  }
  Window window;
  QStringList real;
  for (const QAction* each : window->findChildren<QAction*>()) {
    if (!each->objectName().isEmpty() && !each->shortcut().isEmpty()) {
      real << each->shortcut().toString(QKeySequence::PortableText) + " = " +
                  each->text().remove('&').remove("...");
    }
  }
  written.sort();
  real.sort();
  CHECK(written.join('\n').toStdString() == real.join('\n').toStdString());
}

TEST_CASE("Keys of the view are shown in its menu, and typed in fields") {
  const KeptKeys kept;
  Room window;
  CHECK(window.get<QAction>("view_top")->shortcut() == QKeySequence("7"));
  SceneView& scene = window->scene();
  scene.setFocus();
  press_key(&scene, Qt::Key_7);
  CHECK(scene.camera().pitch < -1.5);
  press_key(&scene, Qt::Key_M);
  CHECK(scene.tool() == SceneView::Tool::measure);
  auto* seed = window.get<QLineEdit>("seed");
  seed->setFocus();
  seed->selectAll();
  press_key(seed, Qt::Key_3);
  CHECK(seed->text() == "3");
  CHECK(scene.camera().pitch < -1.5);
}
