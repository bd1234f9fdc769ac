// The editor of worlds and the list of problems.
#include <QAbstractItemView>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <QTreeWidget>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "engine/compiler_messages.h"
#include "text/completion.h"
#include "text/problems_panel.h"
#include "text/world_editor.h"
#include "waiting.h"

using elsie::desktop::activate;
using elsie::desktop::complete;
using elsie::desktop::ProblemsPanel;
using elsie::desktop::wait_for;
using elsie::desktop::WorldEditor;

namespace {

const elsie::desktop::Catalog kCatalog(nlohmann::ordered_json::parse(R"({
  "elements": {
    "world": {"attributes": [{"name": "seed", "type": "integer"}], "children": ["arena", "robot"]},
    "robot": {"attributes": [{"name": "id", "type": "text"},
                             {"name": "drive", "type": "choice", "choices": ["wheels", "omni"]},
                             {"name": "locked", "type": "boolean"}],
              "children": ["sensors"]},
    "sensors": {"attributes": [], "children": [], "holds": "sensor"},
    "sensor": {"attributes": [{"name": "rate", "type": "number"}]}},
  "plugins": [{"name": "camera", "kind": "sensor", "parameters": [{"name": "width"}]},
              {"name": "camera", "kind": "behavior", "parameters": [{"name": "wrong"}]}]})"));

QString lines(int count) {
  QString text;
  for (int i = 1; i <= count; ++i) {
    text += QStringLiteral("<box id=\"b%1\"/>\n").arg(i);
  }
  return text;
}

/// Waits for a timer of its own: those that were started before and are shorter have fired by then,
/// however slow the machine is.
void after_ms(int ms) {
  bool has_fired = false;
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, &timer, [&] { has_fired = true; });
  timer.start(ms);
  REQUIRE(wait_for([&] { return has_fired; }));
}

}  // namespace

TEST_CASE("typing is reported once, 400 ms after the last key stroke") {
  WorldEditor editor;
  editor.set_text(QStringLiteral("<world/>"));
  QSignalSpy edited(&editor, &WorldEditor::edited);
  editor.moveCursor(QTextCursor::End);
  QTest::keyClicks(&editor, QStringLiteral("a"));
  QElapsedTimer since_last;
  since_last.start();
  QTest::keyClicks(&editor, QStringLiteral("b"));
  CHECK(edited.count() == 0);
  REQUIRE(wait_for([&] { return edited.count() > 0; }));
  CHECK(since_last.elapsed() >= 350);  // a timer of Qt may be 5 % early
  after_ms(500);
  CHECK(edited.count() == 1);
  CHECK(edited[0][0].toString() == QStringLiteral("<world/>ab"));
}

TEST_CASE("a text from outside keeps cursor and scroll position and is no edit") {
  WorldEditor editor;
  editor.resize(400, 200);
  editor.show();
  editor.set_text(lines(200));
  editor.go_to(100);
  const int scroll = editor.verticalScrollBar()->value();
  REQUIRE(scroll > 0);
  QSignalSpy edited(&editor, &WorldEditor::edited);
  QString changed = lines(200);
  changed.replace(QStringLiteral("\"b150\""), QStringLiteral("\"other\""));
  editor.set_text(changed);
  CHECK(editor.toPlainText() == changed);
  CHECK(editor.textCursor().blockNumber() == 99);
  CHECK(editor.verticalScrollBar()->value() == scroll);
  after_ms(500);
  CHECK(edited.count() == 0);
}

TEST_CASE("a text from outside does not erase what is being typed") {
  WorldEditor editor;
  editor.set_text(QStringLiteral("<world/>"));
  QSignalSpy edited(&editor, &WorldEditor::edited);
  QTest::keyClicks(&editor, QStringLiteral("x"));
  editor.set_text(QStringLiteral("<world />"));
  CHECK(editor.toPlainText() == QStringLiteral("x<world/>"));
  REQUIRE(wait_for([&] { return edited.count() > 0; }));
}

TEST_CASE("undo and redo are wishes to the window, which takes first what was typed") {
  WorldEditor editor;
  QSignalSpy undo(&editor, &WorldEditor::undo_wished);
  QSignalSpy redo(&editor, &WorldEditor::redo_wished);
  QSignalSpy edited(&editor, &WorldEditor::edited);
  QTest::keyClicks(&editor, QStringLiteral("x"));
  QTest::keyClick(&editor, Qt::Key_Z, Qt::ControlModifier);
  CHECK(undo.count() == 1);
  CHECK(editor.toPlainText() == QStringLiteral("x"));
  CHECK(edited.count() == 0);
  editor.commit();
  CHECK(edited.count() == 1);
  QTest::keyClick(&editor, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  CHECK(redo.count() == 1);
}

TEST_CASE("lines with problems are marked, with the messages as tool tips") {
  WorldEditor editor;
  editor.resize(400, 200);
  editor.show();
  editor.set_text(lines(3));
  editor.set_problems({{{}, 2, QStringLiteral("first")}, {{}, 2, QStringLiteral("second")}});
  CHECK(editor.extraSelections().size() == 2);  // the line of the cursor, and line 2
  CHECK(editor.extraSelections()[1].cursor.blockNumber() == 1);
  const int height = editor.cursorRect().height();
  CHECK(editor.problem_at(height / 2).isEmpty());
  CHECK(editor.problem_at(height + height / 2 + 4) == QStringLiteral("first\nsecond"));
  editor.set_problems({});
  CHECK(editor.extraSelections().size() == 1);
}

TEST_CASE("Ctrl+F finds, goes on from the other end, and Esc closes") {
  WorldEditor editor;
  editor.resize(400, 200);
  editor.show();
  editor.set_text(lines(20));
  QTest::keyClick(&editor, Qt::Key_F, Qt::ControlModifier);
  auto* word = editor.findChild<QLineEdit*>(QStringLiteral("find_word"));
  REQUIRE(word->isVisible());
  QTest::keyClicks(word, QStringLiteral("b2"));
  CHECK(editor.textCursor().blockNumber() == 1);
  QTest::keyClick(word, Qt::Key_Return);
  CHECK(editor.textCursor().blockNumber() == 19);
  QTest::keyClick(word, Qt::Key_Return);
  CHECK(editor.textCursor().blockNumber() == 1);
  QTest::keyClicks(word, QStringLiteral("xyz"));
  CHECK(editor.findChild<QLabel*>(QStringLiteral("find_verdict"))->text() ==
        QStringLiteral("not found"));
  QTest::keyClick(word, Qt::Key_Escape);
  CHECK(!word->isVisible());
}

TEST_CASE("elements, attributes and choices are completed from the catalog") {
  const auto words = [](const char* before) {
    return complete(kCatalog, QString::fromUtf8(before)).words.join(u' ');
  };
  CHECK(words("<world><") == QStringLiteral("arena robot"));
  CHECK(words("<world><!-- <robot> --><") == QStringLiteral("arena robot"));
  CHECK(words("<world><robot id=\"a>b\"><") == QStringLiteral("sensors"));
  CHECK(words("<world><robot id=\"a\" ") == QStringLiteral("drive locked"));
  CHECK(words("<world><robot drive=\"") == QStringLiteral("omni wheels"));
  CHECK(words("<world><robot locked=\"") == QStringLiteral("false true"));
  CHECK(words("<world><robot><sensors><") == QStringLiteral("camera"));
  CHECK(words("<world><robot><sensors><camera ") == QStringLiteral("rate width"));
  CHECK(words("<world><robot></") == QStringLiteral("robot"));
  CHECK(words("<world>") == QString());
  CHECK(words("<!-- <") == QString());
  CHECK(complete(kCatalog, QStringLiteral("<world><robot dr")).prefix == QStringLiteral("dr"));
}

TEST_CASE("elements in elements of plugins are completed at any depth") {
  const elsie::desktop::Catalog catalog(nlohmann::ordered_json::parse(R"({
    "elements": {
      "robot": {"attributes": [], "children": ["behaviors", "coordinator"]},
      "behaviors": {"attributes": [], "children": [], "holds": "behavior"},
      "coordinator": {"attributes": [], "children": [], "holds": "coordinator"},
      "state": {"attributes": [{"name": "of_another_kind"}], "children": []}},
    "plugins": [
      {"name": "states", "kind": "coordinator", "parameters": [], "elements": [
        {"name": "state", "list": 0, "nests": true, "parameters": [{"name": "behavior"}],
         "elements": [{"name": "way", "list": 1, "parameters": [{"name": "to"}]}]},
        {"name": "group", "list": 0, "parameters": []},
        {"name": "note", "list": 2, "parameters": []}]},
      {"name": "blend", "kind": "behavior", "parameters": [], "holds_behaviors": true}]})"));
  const auto words = [&](const char* inside) {
    return complete(catalog, QStringLiteral("<robot><coordinator>") + QString::fromUtf8(inside))
        .words.join(u' ');
  };
  CHECK(words("<states><") == QStringLiteral("group note state"));
  CHECK(words("<states><state><") == QStringLiteral("group state way"));
  CHECK(words("<states><state><state><state><") == QStringLiteral("group state way"));
  CHECK(words("<states><state><state ") == QStringLiteral("behavior"));
  CHECK(words("<states><state><state><way ") == QStringLiteral("to"));
  CHECK(words("<states><state><way/></state><") == QStringLiteral("group note state"));
  CHECK(words("<states><group><") == QString());
  // A behaviour that holds others has their lists, and these are what they are in a robot.
  const auto completed = [&](const char* text) {
    return complete(catalog, QString::fromUtf8(text)).words.join(u' ');
  };
  CHECK(completed("<robot><behaviors><blend><") == QStringLiteral("behaviors coordinator"));
  CHECK(completed("<robot><behaviors><blend><coordinator><states><state ") ==
        QStringLiteral("behavior"));
}

TEST_CASE("Ctrl+Space takes the only word that fits") {
  WorldEditor editor;
  editor.set_catalog(kCatalog);
  editor.set_text(QStringLiteral("<world><ro"));
  editor.moveCursor(QTextCursor::End);
  QTest::keyClick(&editor, Qt::Key_Space, Qt::ControlModifier);
  CHECK(editor.toPlainText() == QStringLiteral("<world><robot"));
}

TEST_CASE("words are offered while typing, and Enter takes one") {
  WorldEditor editor;
  editor.resize(400, 200);
  editor.show();
  editor.set_catalog(kCatalog);
  editor.set_text(QStringLiteral("<world>"));
  editor.moveCursor(QTextCursor::End);
  QTest::keyClicks(&editor, QStringLiteral("<"));
  QAbstractItemView* popup = nullptr;
  for (QWidget* widget : QApplication::topLevelWidgets()) {
    if (widget->objectName() == QStringLiteral("completions") && widget->isVisible()) {
      popup = qobject_cast<QAbstractItemView*>(widget);
    }
  }
  REQUIRE(popup != nullptr);
  QTest::keyClick(popup, Qt::Key_Return);
  CHECK(editor.toPlainText() == QStringLiteral("<world><arena"));
}

TEST_CASE("problems lead to their lines by Enter, double click and F8") {
  ProblemsPanel panel;
  panel.resize(400, 200);
  panel.show();
  activate(panel);
  panel.set_problems({{QStringLiteral("/w/a.xml"), 3, QStringLiteral("one")},
                      {QStringLiteral("/w/b.xml"), 7, QStringLiteral("two")}});
  QSignalSpy go(&panel, &ProblemsPanel::go_to);
  auto* list = panel.findChild<QTreeWidget*>(QStringLiteral("problems"));
  list->setFocus();
  list->setCurrentItem(list->topLevelItem(0));
  QTest::keyClick(list, Qt::Key_Return);
  REQUIRE(go.count() == 1);
  CHECK(go[0][0].toString() == QStringLiteral("/w/a.xml"));
  CHECK(go[0][1].toInt() == 3);
  QTest::keyClick(list, Qt::Key_F8);
  REQUIRE(go.count() == 2);
  CHECK(go[1][1].toInt() == 7);
  panel.next();
  CHECK(go[2][1].toInt() == 3);
  const QPoint second = list->visualItemRect(list->topLevelItem(1)).center();
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, second);
  QTest::mouseDClick(list->viewport(), Qt::LeftButton, {}, second);
  CHECK(go.last()[1].toInt() == 7);
}

TEST_CASE("what a compiler says leads to the line of its first error") {
  ProblemsPanel panel;
  panel.set_problems({{QStringLiteral("/w/pace.cpp"), 7,
                       QStringLiteral("/w/pace.cpp:7:2: error: 'publik' does not name a type\n"
                                      "    7 |  publik:\n"
                                      "/w/pace.cpp:23:25: error: 'speed' was not declared\n")}});
  auto* list = panel.findChild<QTreeWidget*>(QStringLiteral("problems"));
  const QTreeWidgetItem* problem = list->topLevelItem(0);
  CHECK(problem->text(1) == QStringLiteral("7"));
  CHECK_FALSE(problem->text(0).contains(QStringLiteral("was not declared")));
  QSignalSpy go(&panel, &ProblemsPanel::go_to);
  panel.next();
  REQUIRE(go.count() == 1);
  CHECK(go[0][1].toInt() == 7);
  Q_EMIT list->itemDoubleClicked(problem->child(0), 0);  // the line that it quotes
  CHECK(go[1][1].toInt() == 7);
  Q_EMIT list->itemDoubleClicked(problem->child(1), 0);
  CHECK(go[2][1].toInt() == 23);
}

TEST_CASE("a key stroke changes no other character, also not blanks that are no plain ones") {
  WorldEditor editor;
  const QString text = QStringLiteral("<!-- 10\u00A0m, 3\u202Fs -->\n<world/>\n");
  editor.set_text(text);
  CHECK(editor.whole_text() == text);
  QSignalSpy edited(&editor, &WorldEditor::edited);
  QTest::keyClicks(&editor, QStringLiteral("x"));
  editor.commit();
  REQUIRE(edited.count() == 1);
  CHECK(edited[0][0].toString() == QStringLiteral("x") + text);
}

TEST_CASE("a warning says that it is one") {
  ProblemsPanel panel;
  panel.set_problems({{QStringLiteral("/w/a.xml"), 3, QStringLiteral("too soft"), true}});
  auto* list = panel.findChild<QTreeWidget*>(QStringLiteral("problems"));
  CHECK(list->topLevelItem(0)->text(0) == QStringLiteral("Warning: too soft"));
}

TEST_CASE("errors of compilers and of Python lead to their files and lines") {
  using elsie::desktop::Problem;
  using elsie::desktop::problems_in;
  const auto first = [](const char* message) { return problems_in(message).front(); };
  Problem found = first("/home/me/pace.cpp:13:7: error: expected ';'\n   13 | int x\n");
  CHECK(found.file == "/home/me/pace.cpp");
  CHECK(found.line == 13);
  CHECK(found.message == "expected ';'");
  found = first(
      "/home/me/my plugins/pace.py: pace.py:4: SyntaxError: invalid syntax; the library "
      "that was there before is still in use");
  CHECK(found.file == "/home/me/my plugins/pace.py");
  CHECK(found.line == 4);
  found = first("--plugin: '/home/me/pace.py' pace.py:4: SyntaxError: invalid syntax");
  CHECK(found.file == "/home/me/pace.py");
  CHECK(found.line == 4);
  found = first("plugin 'pace' of robot 'r1' failed in step 3: ValueError: no (pace.py, line 9)");
  CHECK(found.file == "pace.py");
  CHECK(found.line == 9);
  CHECK(first("the disk is full").line == 0);
}
