// What a user meets every day: menus, dialogs, files that are browsed to, windows that float.
#include <QContextMenuEvent>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QFile>
#include <QListWidget>
#include <QToolButton>
#include <QTreeWidgetItemIterator>

#include <catch2/catch.hpp>

#include "hands.h"

using namespace elsie::desktop;

namespace {

const QString kAvoiding = QString(kRoom).replace("<wander/>", "<avoid_obstacle/>");

/// The row of a list, such as "sensors", below an element.
QTreeWidgetItem* row_of_list(WorldTree* tree, const QString& holder, const QString& list) {
  for (QTreeWidgetItemIterator it(tree->tree()); *it; ++it) {
    const QTreeWidgetItem* above = (*it)->parent();
    if ((*it)->data(0, Qt::UserRole + 2).toString() == list && above == tree->item(holder)) {
      return *it;
    }
  }
  return nullptr;
}

void right_click_list(Window& window, const QString& holder, const QString& list) {
  auto* tree = window.get<WorldTree>("world_tree");
  QTreeWidgetItem* row = row_of_list(tree, holder, list);
  REQUIRE(row);
  tree->tree()->scrollToItem(row);
  click_at(tree->tree()->viewport(), tree->tree()->visualItemRect(row).center(), Qt::RightButton);
}

void press_menu_key(QWidget* in) {
  QContextMenuEvent wish(QContextMenuEvent::Keyboard, QPoint(5, 5), in->mapToGlobal(QPoint(5, 5)));
  QApplication::sendEvent(in, &wish);
}

}  // namespace

TEST_CASE("A file that is browsed to in Properties is named as seen from the world") {
  Room window(kAvoiding);
  REQUIRE(QFile::copy(build_file("../share/elsie/fuzzy_models/avoid_obstacle_left.fcl"),
                      window.folder() + "/mine.fcl"));
  window.choose("robot[r1]/behavior[avoid_obstacle]");
  at_dialog("browse_dialog", [&](QDialog* browse) {
    browse->findChild<QLineEdit*>("fileNameEdit")->setText(window.folder() + "/mine.fcl");
    auto* open = browse->findChild<QDialogButtonBox*>("buttonBox")->button(QDialogButtonBox::Open);
    REQUIRE(wait_for([&] { return open->isEnabled(); }));  // the folder is read
    QTest::mouseClick(open, Qt::LeftButton);
  });
  window.after(
      [&] { QTest::mouseClick(window.get<QToolButton>("left_model_browse"), Qt::LeftButton); });
  CHECK(window.bench().text().contains("left_model=\"mine.fcl\""));
}

TEST_CASE("The menu key opens the menu of the row that has the keyboard in a tree") {
  Room window;
  auto* tree = window.get<WorldTree>("world_tree");
  click_row(tree, "robot[r1]");
  auto is_picked = pick_when_open("element_menu", "Add sensor");
  press_menu_key(tree->tree());
  CHECK(*is_picked);
  window.dialog("element_dialog")->reject();
  window.await_closed("element_dialog");
  tree->tree()->setCurrentItem(row_of_list(tree, "robot[r1]", "sensors"));
  is_picked = pick_when_open("list_menu", "Add sensor");
  press_menu_key(tree->tree());
  CHECK(*is_picked);
}

TEST_CASE("Shift+F10 opens the menus that the menu key opens") {
  Room window;
  auto* tree = window.get<WorldTree>("world_tree");
  click_row(tree, "robot[r1]");
  auto is_open = pick_when_open("element_menu", "");
  press_key(tree->tree(), Qt::Key_F10, Qt::ShiftModifier);
  CHECK(*is_open);
  QLineEdit* x = field(window, "x");
  x->setFocus();
  is_open = pick_when_open("qt_edit_menu", "");
  press_key(x, Qt::Key_F10, Qt::ShiftModifier);
  CHECK(wait_for([&] { return *is_open; }));
}

TEST_CASE("The menu of a list offers what may be added to it, and what may be pasted into it") {
  Room window;
  auto is_picked = pick_when_open("list_menu", "Add robot");
  right_click_list(window, "", "robots");
  CHECK(*is_picked);
  QDialog* dialog = window.dialog("element_dialog");
  CHECK(dialog->windowTitle() == "New robot");
  dialog->reject();
  window.await_closed("element_dialog");

  is_picked = pick_when_open("list_menu", "Add sensor");
  right_click_list(window, "robot[r1]", "sensors");
  CHECK(*is_picked);
  dialog = window.dialog("element_dialog");
  CHECK(dialog->windowTitle() == "New sensor of r1");
  dialog->reject();
  window.await_closed("element_dialog");

  window.choose("robot[r1]/sensor[ahead]");
  window.act("copy");
  is_picked = pick_when_open("list_menu", "Paste");
  window.after([&] { right_click_list(window, "robot[r1]", "sensors"); });
  CHECK(window.bench().text().count("<beam_range") == 2);
  window.choose("robot[r1]");
  window.act("copy");
  is_picked = pick_when_open("list_menu", "Paste");
  window.after([&] { right_click_list(window, "", "robots"); });
  CHECK(window.bench().text().count("<robot ") == 2);
}

TEST_CASE("Cancel takes back what was applied immediately, a new name, too") {
  Room window;
  click_row(window.get<WorldTree>("world_tree"), "robot[r1]", Qt::RightButton);
  QDialog* dialog = window.dialog("element_dialog");
  QTest::mouseClick(dialog->findChild<QAbstractButton*>("apply_immediately"), Qt::LeftButton, {},
                    QPoint(8, 8));
  auto* form = dialog->findChild<Form*>("form_robot");
  for (const auto& change : {std::pair("id", "r9"), {"leader", "true"}, {"x", "0.5"}}) {
    INFO(change.first);
    window.after([&] { form->set_value(change.first, change.second); });
  }
  CHECK(window.bench().text().contains("<robot id=\"r9\" team=\"red\" x=\"0.5\""));
  CHECK(window.bench().text().contains("leader=\"true\""));
  window.after([&] { Window::press(dialog, QDialogButtonBox::Cancel); });
  CHECK(window.bench().text() == kRoom);
  CHECK(window.bench().undo_name() == "cancel the edit of r9");
}

TEST_CASE("A behaviour that holds others is put in with one, so that it is not refused") {
  Room window;
  window.choose("robot[r1]");
  window.act("behaviors");
  QDialog* dialog = window.dialog("behaviors_dialog");
  auto* pool = dialog->findChild<QListWidget*>("pool");
  const auto found = pool->findItems("blend", Qt::MatchExactly);
  REQUIRE(found.size() == 1);
  pool->setCurrentItem(found.front());
  click_on(dialog->findChild<QPushButton*>("add"));
  window.after([&] { Window::press(dialog, QDialogButtonBox::Ok); });
  CHECK(window.get<WorldTree>("world_tree")->item("robot[r1]/behavior[blend]/behavior[wander]"));
  CHECK(window.get<WorldTree>("world_tree")->item("robot[r1]/behavior[blend]/coordinator"));
}

TEST_CASE("A floating window comes before the main one when that is activated") {
  Room window;
  auto* dock = window.get<QDockWidget>("dock_properties");
  dock->setFloating(true);
  const QPoint middle = window->mapToGlobal(window->rect().center());
  dock->move(middle - QPoint(100, 100));
  QWidget other;
  other.setGeometry(0, 0, 50, 50);
  other.show();
  activate(other);
  window->raise();
  const auto in_front = [&] { return QApplication::topLevelAt(middle); };
  REQUIRE(wait_for([&] { return in_front() == &window.window(); }));
  activate(window.window());
  CHECK(wait_for([&] { return in_front() == dock; }));
}
