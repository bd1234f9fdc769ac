// A new world that succeeds, behaviours that are written in the window, and pages of help.
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QTabWidget>
#include <QTextBrowser>
#include <QTreeWidget>

#include "hands.h"
#include "new_world.h"
#include "text/code_editor.h"
#include "text/sources_panel.h"
#include "watch/coordination_panel.h"

using namespace elsie::desktop;

namespace {

QDialog* new_behavior(Window& window, const QString& name, int language) {
  window.act("write_behavior");
  auto* dialog = window.dialog("new_behavior_dialog");
  dialog->findChild<QLineEdit*>("behavior_folder")->setText(window.folder());
  dialog->findChild<QComboBox*>("behavior_language")->setCurrentIndex(language);
  type_over(dialog->findChild<QLineEdit*>("behavior_name"), name);
  return dialog;
}

/// Gives the robot r1 a new behaviour. Returns its source, which is open in the window.
QString source_of_new(Window& window, const QString& name, int language) {
  window.choose("robot[r1]");
  Window::press(new_behavior(window, name, language), QDialogButtonBox::Ok);
  REQUIRE(wait_for([&] { return window.bench().text().contains('<' + name + "/>"); }));
  window.await_closed("new_behavior_dialog");
  return window.get<CodeEditor>("source_text")->whole_text();
}

/// Saves this as the source whose tab is in front.
void save_source(Window& window, const QString& source) {
  QWidget* const tab = window.get<QTabWidget>("source_tabs")->currentWidget();
  auto* text = tab->findChild<CodeEditor*>("source_text");
  REQUIRE(text);
  text->selectAll();
  text->insertPlainText(source);
  text->setFocus();
  press_key(text, Qt::Key_S, Qt::ControlModifier);
}

/// What the dialog refuses, in its words.
QString refused_in(QDialog* dialog) {
  auto* warning = dialog->findChild<QLabel*>("behavior_warning");
  Window::press(dialog, QDialogButtonBox::Ok);
  REQUIRE(wait_for([&] { return warning->isVisible() && !warning->text().isEmpty(); }));
  return warning->text();
}

}  // namespace

TEST_CASE("New world is there at once, and its robot collects all with each of ten seeds") {
  Window window;
  window.after([&] { window.act("new"); });
  CHECK(window->findChildren<QDialog*>().isEmpty());
  CHECK(window.bench().text() == new_world());
  CHECK(window.bench().problems().empty());
  CHECK_FALSE(window->isWindowModified());
  const QString file = window.file(new_world().toUtf8().constData(), "new.xml");
  for (int seed = 1; seed <= 10; ++seed) {
    const Json run = headless({file, "--seed", QString::number(seed), "--duration", "120"});
    INFO(seed);
    CHECK(run.at("outcome") == "success");
  }
}

TEST_CASE("Enter presses the buttons of the start page") {
  Window window;
  const auto key = GENERATE(Qt::Key_Return, Qt::Key_Enter, Qt::Key_Space);
  CAPTURE(key);
  auto* button = window.get<QPushButton>("new_world");
  REQUIRE(button->isVisible());
  button->setFocus();
  window.after([&] { press_key(button, key); });
  CHECK(window.bench().text() == new_world());
}

TEST_CASE("Another speed before the start leaves Coordination as it is") {
  Window window;
  window.after([&] { window.act("new"); });
  window.get<QDockWidget>("dock_coordination")->raise();
  auto* panel = window->findChild<CoordinationPanel*>();
  REQUIRE(wait_for([&] { return panel->rows() > 0; }));
  auto* speed = window.get<QComboBox>("speed");
  speed->setFocus();
  press_key(speed, Qt::Key_Down);
  CHECK(window.bench().speed() > 1.0);
  CHECK(panel->rows() > 0);
}

TEST_CASE("A behaviour is written, compiled, loaded and given to the selected robot") {
  Room window;
  window.choose("robot[r1]");
  auto* dialog = new_behavior(window, "Steady Pace", 0);
  CHECK(refused_in(dialog).contains("'Steady Pace' is not a name for a plugin"));
  type_over(dialog->findChild<QLineEdit*>("behavior_name"), "wander");
  CHECK(refused_in(dialog).contains("there is a behavior 'wander' already", Qt::CaseInsensitive));
  QDir(window.folder()).mkdir("steady");
  type_over(dialog->findChild<QLineEdit*>("behavior_name"), "steady");
  CHECK(refused_in(dialog).contains("exists already"));
  dialog->findChild<QLineEdit*>("behavior_folder")->setText("/proc");
  CHECK(refused_in(dialog).contains("cannot be made"));
  QDir(window.folder()).rmdir("steady");
  dialog->findChild<QLineEdit*>("behavior_folder")->setText(window.folder());
  Window::press(dialog, QDialogButtonBox::Ok);
  window.await_closed("new_behavior_dialog");
  auto* text = window.get<CodeEditor>("source_text");
  CHECK(text->whole_text().contains("ELSIE_BEHAVIOR(Steady, \"steady\""));
  CHECK(window.get<QDockWidget>("dock_source")->isVisible());
  REQUIRE(wait_for([&] { return window.bench().text().contains("<steady/>"); }));
  window.step();

  // What is saved with an error is listed, with its line; the old version stays.
  const QString right = text->whole_text();
  const QString wrong =
      QString(right).replace("double speed = 10.0;", "double speed = no_such_speed;");
  const qsizetype line = right.left(right.indexOf("double speed")).count('\n') + 1;
  text->selectAll();
  text->insertPlainText(wrong);
  text->setFocus();
  press_key(text, Qt::Key_S, Qt::ControlModifier);
  auto* list = window.get<QTreeWidget>("problems");
  REQUIRE(wait_for([&] { return list->topLevelItemCount() > 0; }));
  CHECK(list->topLevelItem(0)->text(2) == "steady.cpp");
  CHECK(list->topLevelItem(0)->text(1) == QString::number(line));
  CHECK(window.get<QLabel>("source_state")->text().contains("Not loaded"));
  text->go_to(1);
  window.act("next_problem");
  CHECK(text->textCursor().blockNumber() + 1 == line);
  window.step();
  text->selectAll();
  text->insertPlainText(right + "\n// again\n");
  press_key(text, Qt::Key_S, Qt::ControlModifier);
  REQUIRE(wait_for([&] { return list->topLevelItemCount() == 0; }));
  CHECK(window.get<QLabel>("source_state")->text().contains("Loaded"));

  // Another engine has it, too.
  window.after([&] { window.open(window.file(window.bench().text().toUtf8(), "other.xml")); });
  CHECK(window.bench().is_right());
  CHECK(window.bench().text().contains("<steady/>"));
}

TEST_CASE("A behaviour in Python is loaded at once") {
  Room window;
  window.choose("robot[r1]");
  Window::press(new_behavior(window, "calm", 1), QDialogButtonBox::Ok);
  REQUIRE(wait_for([&] { return window.bench().text().contains("<calm/>"); }));
  CHECK(window.get<CodeEditor>("source_text")->whole_text().contains("class Calm"));
  window.step();
}

TEST_CASE("The errors of a source stay listed while other plugins are loaded") {
  Room window;
  const QString right = source_of_new(window, "steady", 0);
  auto* list = window.get<QTreeWidget>("problems");
  save_source(window, "#include <no_such_header>\n" + right);
  REQUIRE(wait_for([&] { return list->topLevelItemCount() == 1; }));

  Window::press(new_behavior(window, "still", 1), QDialogButtonBox::Ok);
  REQUIRE(wait_for([&] { return window.bench().text().contains("<still/>"); }));
  REQUIRE(list->topLevelItemCount() == 1);
  CHECK(list->topLevelItem(0)->toolTip(0).contains("no_such_header"));
  window.get<QTabWidget>("source_tabs")->setCurrentIndex(0);
  save_source(window, right);
  CHECK(wait_for([&] { return list->topLevelItemCount() == 0; }));
}

TEST_CASE("Of a script only the present error is listed, and another one is refused for its own") {
  Room window;
  const QString right = source_of_new(window, "calm", 1);
  auto* list = window.get<QTreeWidget>("problems");
  const auto lists = [&](const char* error) {
    for (int i = 0; i < list->topLevelItemCount(); ++i) {
      if (list->topLevelItem(i)->toolTip(0).contains(error)) return true;
    }
    return false;
  };
  save_source(window, "import no_such_one\n" + right);
  REQUIRE(wait_for([&] { return lists("no_such_one"); }));

  std::optional<Problems> odd;
  window.bench().add_plugin(window.file("import elsie\nimport no_such_odd\n", "odd.py"),
                            &window.window(), [&](const Problems& problems) { odd = problems; });
  REQUIRE(wait_for([&] { return odd.has_value(); }));
  REQUIRE(odd->size() == 1);
  CHECK(odd->front().message.contains("odd.py"));
  CHECK(lists("no_such_one"));

  Window::press(new_behavior(window, "still", 1), QDialogButtonBox::Ok);
  REQUIRE(wait_for([&] { return window.bench().text().contains("<still/>"); }));
  window.get<QTabWidget>("source_tabs")->setCurrentIndex(0);
  save_source(window, "import no_such_two\n" + right);
  REQUIRE(wait_for([&] { return lists("no_such_two"); }));
  CHECK_FALSE(lists("no_such_one"));
  CHECK(lists("odd.py"));
  save_source(window, right);
  CHECK(wait_for([&] { return !lists("no_such_two"); }));
}

TEST_CASE("The errors of a plugin stay listed when a world is opened") {
  QTemporaryDir folder;
  const QString script = folder.filePath("odd.py");
  std::ofstream(script.toStdString()) << "import elsie\nimport no_such_odd\n";
  Window window({}, {"--draft", script});
  auto* list = window.get<QTreeWidget>("problems");
  REQUIRE(wait_for([&] { return list->topLevelItemCount() == 1; }));
  window.open(window.file(kRoom));
  REQUIRE(window.bench().is_right());
  REQUIRE(list->topLevelItemCount() == 1);
  CHECK(list->topLevelItem(0)->toolTip(0).contains("odd.py"));
}

TEST_CASE(
    "Without a compiler, a behaviour in C++ is written, and a sentence says what is missing") {
  const QByteArray before = qgetenv("CXX");
  qputenv("CXX", "/no/such/compiler");
  {
    Room window;
    window.choose("robot[r1]");
    Window::press(new_behavior(window, "steady", 0), QDialogButtonBox::Ok);
    auto* list = window.get<QTreeWidget>("problems");
    REQUIRE(wait_for([&] { return list->topLevelItemCount() > 0; }));
    CHECK(list->topLevelItem(0)->text(0).contains("/no/such/compiler"));
    CHECK(window.get<QLabel>("source_state")->text().contains("Not loaded"));
    CHECK_FALSE(window.bench().text().contains("steady"));
  }
  before.isEmpty() ? qunsetenv("CXX") : qputenv("CXX", before);
}

TEST_CASE("A source that is not saved is asked about before the window closes") {
  Room window;
  const QString source = window.file("// mine\n", "mine.cpp");
  auto* sources = window->findChild<SourcesPanel*>();
  REQUIRE(sources->open(source).isEmpty());
  window.get<CodeEditor>("source_text")->insertPlainText("// more\n");
  CHECK(window.get<QTabWidget>("source_tabs")->tabText(0) == "mine.cpp*");
  window.answer = MainWindow::Answer::cancel;
  CHECK_FALSE(window->close());
  window.answer = MainWindow::Answer::save;
  CHECK(window->close());
  CHECK(bytes_of(source) == "// more\n// mine\n");
}

TEST_CASE("A source that is not saved is asked about before its tab closes") {
  Room window;
  const QString source = window.file("// mine\n", "mine.cpp");
  auto* sources = window->findChild<SourcesPanel*>();
  auto* tabs = window.get<QTabWidget>("source_tabs");
  REQUIRE(sources->open(source).isEmpty());
  const auto type = [&] {
    tabs->currentWidget()->findChild<CodeEditor*>("source_text")->insertPlainText("// more\n");
  };
  const auto close_tab = [&](MainWindow::Answer answer) {
    window.answer = answer;
    Q_EMIT tabs->tabCloseRequested(0);
  };
  SECTION("which takes no question without changes") {
    close_tab(MainWindow::Answer::cancel);
    CHECK(window.asked == 0);
    CHECK(tabs->count() == 0);
  }
  SECTION("and stays, loses its text or saves it, as one likes") {
    type();
    close_tab(MainWindow::Answer::cancel);
    CHECK(window.asked == 1);
    CHECK(tabs->tabText(0) == "mine.cpp*");
    CHECK(bytes_of(source) == "// mine\n");
    close_tab(MainWindow::Answer::discard);
    CHECK(tabs->count() == 0);
    CHECK(bytes_of(source) == "// mine\n");
    REQUIRE(sources->open(source).isEmpty());
    type();
    close_tab(MainWindow::Answer::save);
    CHECK(tabs->count() == 0);
    CHECK(bytes_of(source) == "// more\n// mine\n");
  }
}

TEST_CASE("A source that another program has changed is overwritten only at the second try") {
  Room window;
  const QString source = window.file("// mine\r\n", "mine.cpp");
  auto* sources = window->findChild<SourcesPanel*>();
  REQUIRE(sources->open(source).isEmpty());
  window.get<CodeEditor>("source_text")->insertPlainText("// more\n");
  window.file("// theirs\r\n", "mine.cpp");
  CHECK(sources->save({source}).contains("has been changed by another program"));
  CHECK(bytes_of(source) == "// theirs\r\n");
  CHECK(sources->save({source}).isEmpty());
  CHECK(bytes_of(source) == "// more\r\n// mine\r\n");  // line ends stay
}

TEST_CASE("A source that is not in UTF-8 is not opened, because saving would damage it") {
  Room window;
  const QString source = window.folder() + "/old.cpp";
  QFile file(source);
  REQUIRE(file.open(QIODevice::WriteOnly));
  file.write("// M\xfcller\n");
  file.close();
  CHECK(window->findChild<SourcesPanel*>()->open(source).contains("is not in UTF-8"));
}

TEST_CASE("Help opens the tutorial and the page of the selected plugin, without a network") {
  Room window;
  window.act("tutorial");
  auto* text = window.get<QTextBrowser>("help_text");
  CHECK(text->toPlainText().contains("Your first behaviour"));
  window.choose("robot[r1]/behavior[wander]");
  window.act("page_of_selected");
  CHECK(text->toPlainText().startsWith("wander"));
  CHECK(text->source().isLocalFile());
}

TEST_CASE("Another world starts with the usual seed, and without words about the run before it") {
  Room window(QString(kRoom).replace("\"60\"", "\"1\""));
  auto* seed = window.get<QLineEdit>("seed");
  const auto end_with_seed_4 = [&] {
    window.after([&] { window.bench().reset(4); });
    window.run_to_the_end();
    REQUIRE(window.said().startsWith("Time is up"));
  };
  end_with_seed_4();
  window.after([&] { window.act("new"); });
  CHECK(window.bench().seed() == 1);
  CHECK(seed->text() == "1");
  CHECK_FALSE(window.said().startsWith("Time is up"));
  window.open(window.file(QString(kRoom).replace("\"60\"", "\"1\"").toUtf8(), "short.xml"));
  end_with_seed_4();
  window.after([&] { window.open(window.file(kRoom, "other.xml")); });
  CHECK(window.bench().seed() == 1);
  CHECK(seed->text() == "1");
  CHECK_FALSE(window.said().startsWith("Time is up"));
}
