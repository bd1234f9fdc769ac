// A window with an engine of its own for a test, and what tests do with it.
#pragma once

#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QCompleter>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QFile>
#include <QFileSystemModel>
#include <QItemSelectionModel>
#include <QLineEdit>
#include <QProcess>
#include <QPushButton>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>
#include <algorithm>
#include <fstream>
#include <functional>
#include <optional>
#include <string>

#include <catch2/catch.hpp>

#include "main_window.h"
#include "scene/scene_view.h"
#include "waiting.h"
#include "world/world_tree.h"

namespace elsie::desktop {

inline QString build_file(const QString& name) {
  return QApplication::applicationDirPath() + '/' + name;
}
inline QString world_file(const QString& name) {
  return build_file("../share/elsie/worlds/" + name + ".xml");
}
inline QByteArray bytes_of(const QString& path) {
  QFile file(path);
  REQUIRE(file.open(QIODevice::ReadOnly));
  return file.readAll();
}

/// Does something with the modal dialog of that name, once it is there and gets the keys: until
/// then, they may be shortcuts of the window behind it.
inline void at_dialog(const QString& name, const std::function<void(QDialog*)>& answer) {
  auto* waiting = new QTimer(qApp);
  QObject::connect(waiting, &QTimer::timeout, waiting, [=] {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    if (dialog && dialog->objectName() == name && is_activated(*dialog)) {
      waiting->deleteLater();
      answer(dialog);
    }
  });
  waiting->start(20);
}

/// Types a file into Qt's own file dialog and presses Save. The dialog selects the file that
/// it began with once it has read the folder, and takes what is selected before what is typed; it
/// selects less again only while the line has the focus.
inline void save_as_file(QDialog* dialog, const QString& file) {
  auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
  auto* list = dialog->findChild<QAbstractItemView*>("listView");
  auto* accept = dialog->findChild<QDialogButtonBox*>("buttonBox")->button(QDialogButtonBox::Save);
  const bool was_named =
      !name->text().isEmpty() &&
      QFile::exists(list->rootIndex().data(QFileSystemModel::FilePathRole).toString() + '/' +
                    name->text());
  wait_for([&] {
    return was_named ? list->selectionModel()->hasSelection()
                     : list->model()->rowCount(list->rootIndex()) > 0;
  });
  wait_for([&] {
    dialog->activateWindow();
    name->setFocus();
    name->selectAll();
    QTest::keyClicks(name, file);
    if (name->completer()) name->completer()->popup()->hide();
    return !list->selectionModel()->hasSelection() && accept->isEnabled();
  });
  QTest::mouseClick(accept, Qt::LeftButton);
}

inline constexpr const char* kRoom = R"(<world format="1">
  <!-- a room -->
  <arena length="4" width="4"/>
  <obstacles>
    <static_box id="crate" x="1" y="1"/>
  </obstacles>
  <robots>
    <robot id="r1" team="red" x="-1">
      <sensors><beam_range id="ahead"/></sensors>
      <behaviors><wander/></behaviors>
      <coordinator><arbiter_suppression/></coordinator>
    </robot>
  </robots>
  <limits time="60"/>
</world>
)";

/// Shows a dock in front of its neighbours, also if it has nothing to show yet.
inline QDockWidget* show_dock(QWidget& window, const char* name) {
  auto* dock = window.findChild<QDockWidget*>(name);
  REQUIRE(dock);
  dock->show();
  dock->raise();
  return dock;
}

/// A window, and a folder for files. All windows of a test program have the settings of main.cpp.
class Window {
 public:
  /// `options`: for the engine, such as where plugins are.
  explicit Window(const QString& file = {}, const QStringList& options = {})
      : window_(build_file("elsie"), options) {
    window_.ask_about_unsaved = [this](const QString&) {
      ++asked;
      return answer;
    };
    constexpr int kFewPasses = 4;  // of pictures at rest, which most tests do not look at
    window_.scene().photograph().set_finest(kFewPasses);
    window_.show();
    activate(window_);
    REQUIRE(wait_for([&] { return !window_.workbench().catalog().is_empty(); }));
    if (!file.isEmpty()) {
      open(file);
    }
  }
  ~Window() { bench().give_up_unsaved(); }

  MainWindow* operator->() { return &window_; }
  MainWindow& window() { return window_; }
  Workbench& bench() { return window_.workbench(); }
  template <class Widget>
  Widget* get(const char* name) {
    auto* found = window_.findChild<Widget*>(name);
    REQUIRE(found);
    return found;
  }
  void act(const char* name) { get<QAction>(name)->trigger(); }

  void open(const QString& file) {
    REQUIRE(window_.open(file));
    REQUIRE(wait_for([&] { return bench().is_right() || !bench().problems().empty(); }));
  }
  void open_text(const QString& text) {
    bench().open_text(text, {}, false);
    REQUIRE(wait_for([&] { return bench().is_right(); }));
  }
  /// As a click on it in the tree does.
  void choose(const QString& path) {
    auto* tree = get<WorldTree>("world_tree");
    REQUIRE(tree->item(path));
    tree->tree()->setCurrentItem(tree->item(path));
  }
  QString folder() const { return folder_.path(); }
  /// A file of this test with that text.
  QString file(const char* text, const QString& name = "room.xml") {
    const QString path = folder_.filePath(name);
    std::ofstream(path.toStdString()) << text;
    return path;
  }
  /// Waits until what was ordered is described.
  void after(const std::function<void()>& order) {
    bool is_described = false;
    const auto connection =
        QObject::connect(&bench(), &Workbench::described, &window_, [&] { is_described = true; });
    order();
    REQUIRE(wait_for([&] { return is_described; }));
    QObject::disconnect(connection);
  }
  void pause() {
    bench().pause();
    REQUIRE(wait_for([&] { return bench().run_state() == Workbench::Run::paused; }));
  }
  void step() {
    bench().step();
    REQUIRE(wait_for([&] { return bench().run_state() == Workbench::Run::paused; }));
  }
  /// Runs at this speed until the time is past, and pauses.
  void run_past(double time_s, double speed = 5.0) {
    bench().set_speed(speed);
    bench().run();
    REQUIRE(wait_for([&] { return bench().time_s() > time_s; }));
    pause();
  }
  /// What the window's own save says: "" if it is done.
  QString saved_as(const QString& file) {
    std::optional<QString> said;
    bench().save_as(file, [&](const QString& sentence) { said = sentence; });
    REQUIRE(wait_for([&] { return said.has_value(); }));
    return *said;
  }
  QString said() { return window_.statusBar()->currentMessage(); }
  /// Waits until no dialog of that name is open.
  void await_closed(const char* name) {
    REQUIRE(wait_for([&] { return !window_.findChild<QDialog*>(name); }));
  }
  /// Runs to the end, and returns the state hash.
  std::string hash_at_the_end() { return run_to_the_end().at("state_hash").get<std::string>(); }
  Json run_to_the_end() {
    Json end;
    const auto connection = QObject::connect(&bench(), &Workbench::ended, &window_,
                                             [&](const Json& event) { end = event; });
    bench().set_speed(0.0);
    bench().run();
    REQUIRE(wait_for([&] { return !end.is_null(); }));
    QObject::disconnect(connection);
    return end;
  }
  /// Waits until the dialog is shown and gets the keys.
  template <class Dialog = QDialog>
  Dialog* dialog(const char* name) {
    Dialog* found = nullptr;
    REQUIRE(wait_for([&] {
      const auto all = window_.findChildren<Dialog*>(name);  // one may be about to be deleted
      const auto shown = std::find_if(all.begin(), all.end(), std::mem_fn(&QWidget::isVisible));
      found = shown == all.end() ? nullptr : *shown;
      return found && is_activated(*found);
    }));
    return found;
  }
  /// The one dialog that is shown, once it is.
  QDialog* any_dialog() {
    QDialog* found = nullptr;
    REQUIRE(wait_for([&] {
      for (QDialog* each : window_.findChildren<QDialog*>()) {
        if (each->isVisible()) found = each;
      }
      return found != nullptr;
    }));
    return found;
  }
  /// The dialog of an element that a command opens.
  QDialog* dialog_of(const char* command) {
    act(command);
    return dialog("element_dialog");
  }
  static void press(QDialog* dialog, QDialogButtonBox::StandardButton which) {
    QTest::mouseClick(dialog->findChild<QDialogButtonBox*>("buttons")->button(which),
                      Qt::LeftButton);
  }

  MainWindow::Answer answer = MainWindow::Answer::discard;
  int asked = 0;

 private:
  QTemporaryDir folder_;
  MainWindow window_;
};

/// Types a text in the place of the one that is there, without Enter.
inline void type_over(QLineEdit* edit, const QString& text) {
  REQUIRE(edit);
  edit->setFocus();
  edit->selectAll();
  QTest::keyClicks(edit, text);
}
inline void enter(QLineEdit* edit, const QString& text) {
  type_over(edit, text);
  QTest::keyClick(edit, Qt::Key_Return);
}

/// A window with a world, the room if no other is given, in a file of its own.
class Room : public Window {
 public:
  explicit Room(const QString& text = kRoom, const QStringList& options = {})
      : Window({}, options) {
    open(file(text.toUtf8().constData()));
  }
};

/// Runs to this time and pauses there, or ends before.
inline void run_until(Window& window, double time_s) {
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

inline void run_elsie(const QStringList& words) {
  QProcess program;
  program.start(build_file("elsie"), words);
  REQUIRE(program.waitForFinished(kPatience_ms));
  CAPTURE(program.readAllStandardError().toStdString());
  REQUIRE(program.exitCode() <= 1);
}

/// The database of a study of kRoom with these seeds, in the folder of the window.
inline QString study_in(Window& window, int first, int last) {
  window.file(kRoom);
  const QString text = QString(R"(<experiment format="1" name="study">
  <worlds><world file="room.xml"/></worlds>
  <set path="limits/@time" value="3"/>
  <seeds from="%1" to="%2"/>
</experiment>
)");
  const QString study = window.file(text.arg(first).arg(last).toUtf8(), "study.xml");
  const QString database = window.folder() + "/study.sqlite";
  run_elsie({"batch", study, "--database", database});
  return database;
}

/// What `elsie run --json` says.
inline Json headless(const QStringList& arguments) {
  QProcess run;
  run.start(build_file("elsie"), QStringList{"run"} + arguments + QStringList{"--json"});
  REQUIRE(run.waitForFinished(kPatience_ms));
  const Json json = Json::parse(run.readAllStandardOutput().toStdString(), nullptr, false);
  REQUIRE(json.is_object());
  return json;
}
inline std::string headless_hash(const QStringList& arguments) {
  return headless(arguments).at("state_hash").get<std::string>();
}

}  // namespace elsie::desktop
