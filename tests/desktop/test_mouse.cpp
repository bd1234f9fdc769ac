// The mouse in the view, and commands by menus and keys.
#include <QComboBox>
#include <QDockWidget>
#include <QFileDialog>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QRegularExpression>
#include <memory>

#include <catch2/catch.hpp>

#include "export/film.h"
#include "hands.h"
#include "text/world_editor.h"
#include "training/trainer.h"
#include "world/form.h"
#include "world/properties.h"

using namespace elsie::desktop;

namespace {

/// The room, once the view has it.
class SeenRoom : public Room {
 public:
  SeenRoom() {
    REQUIRE(wait_for([&] { return window().scene().stage().body_of("robot[r1]") != nullptr; }));
  }
};

double number_in(Window& window, const QString& path, const char* name) {
  const ElementPlace place = place_of(window.bench().tree(), path);
  REQUIRE(place.element);
  return attribute(*place.element, name).toDouble();
}

/// Makes the crate so large that its corner can be gripped.
void enlarge(Window& window) {
  window.after([&] {
    window.bench().edit({"obstacle[crate]/@length=0.5", "obstacle[crate]/@width=0.5"}, "enlarge");
  });
}

/// Clicks through the menu bar, as a hand does.
void pick(Window& window, const char* menu_title, const char* action) {
  for (QAction* each : window->menuBar()->actions()) {
    if (each->text().remove('&') != menu_title) {
      continue;
    }
    QMenu* menu = each->menu();
    QTest::mouseClick(window->menuBar(), Qt::LeftButton, {},
                      window->menuBar()->actionGeometry(each).center());
    REQUIRE(wait_for([&] { return menu->isVisible(); }));
    QTest::mouseClick(menu, Qt::LeftButton, {},
                      menu->actionGeometry(window.get<QAction>(action)).center());
    window->activateWindow();  // a bare X server does not do it
    return;
  }
  FAIL("there is no menu " << menu_title);
}

}  // namespace

TEST_CASE("Shift and a click choose several things in the view") {
  SeenRoom window;
  SceneView& scene = window->scene();
  auto* tree = window.get<WorldTree>("world_tree");
  click_at(&scene, pixel_at(window, {1.0, 1.0, 0.1}));
  click_at(&scene, pixel_at(window, {-1.0, 0.0, 0.05}), Qt::LeftButton, Qt::ShiftModifier);
  CHECK(tree->selection().size() == 2);
  click_at(&scene, pixel_at(window, {1.0, 1.0, 0.1}), Qt::LeftButton, Qt::ShiftModifier);
  CHECK(tree->selection() == QStringList{"robot[r1]"});
  click_at(&scene, pixel_at(window, {-1.5, -1.5, 0.0}));
  CHECK(tree->selection().isEmpty());
}

TEST_CASE("A double click in the view follows a robot, and leaves it again") {
  SeenRoom window;
  SceneView& scene = window->scene();
  const QPoint at = pixel_at(window, {-1.0, 0.0, 0.05});
  QTest::mouseDClick(&scene, Qt::LeftButton, {}, at);
  CHECK(scene.followed() == "robot[r1]");
  QTest::mouseDClick(&scene, Qt::LeftButton, {}, pixel_at(window, {-1.0, 0.0, 0.05}));
  CHECK(scene.followed().isEmpty());
}

TEST_CASE("A box is turned by its knob and resized by its corner") {
  SeenRoom window;
  enlarge(window);
  SceneView& scene = window->scene();
  press_key(&scene, Qt::Key_7);
  click_at(&scene, pixel_at(window, {1.0, 1.0, 0.1}));
  const auto knob = scene.handle(SceneView::Tool::turn);
  REQUIRE(knob);
  window.after([&] {
    drag_by_hand(&scene, Qt::LeftButton, knob->toPoint(), pixel_at(window, {1.0, 1.8, 0.0}));
  });
  CHECK(number_in(window, "obstacle[crate]", "heading_deg") == Approx(90.0).margin(3.0));
  CHECK(window.bench().undo_name() == "turn crate");
  window.after([&] { window.act("undo"); });
  REQUIRE(wait_for([&] { return scene.handle(SceneView::Tool::resize).has_value(); }));
  const QPoint corner = scene.handle(SceneView::Tool::resize)->toPoint();
  window.after([&] {
    drag_by_hand(&scene, Qt::LeftButton, corner, pixel_at(window, {1.4, 1.3, 0.0}));
  });
  CHECK(number_in(window, "obstacle[crate]", "length") == Approx(0.8).margin(0.05));
  CHECK(number_in(window, "obstacle[crate]", "width") == Approx(0.6).margin(0.05));
  CHECK(window.bench().undo_name() == "resize crate");
}

TEST_CASE("Patches and lamps are chosen, moved, turned and resized in the view") {
  SeenRoom window;
  SceneView& scene = window->scene();
  window.after([&] {
    window.bench().edit(
        {"patch[+]=<rectangle_patch id=\"mat\" x=\"-1\" y=\"-1\" length=\"0.6\" width=\"0.4\"/>",
         "patch[+]=<disc_patch id=\"spot\" x=\"-1\" y=\"-1\" radius=\"0.3\" colour=\"#ff0000\"/>",
         "patch[+]=<line_patch id=\"track\" y=\"1.2\" width=\"0.1\"><point x=\"-1\" y=\"0\"/>"
         "<point x=\"0\" y=\"0\"/></line_patch>",
         "lamp[+]=<lamp id=\"sun\" x=\"0.2\" y=\"-1\" z=\"0.1\"/>"},
        "add");
  });
  press_key(&scene, Qt::Key_7);
  const auto choose = [&](double x, double y, const QString& path) {
    click_at(&scene, pixel_at(window, {x, y, 0.0}));
    REQUIRE(window.get<WorldTree>("world_tree")->selection() == QStringList{path});
  };
  const auto drag = [&](SceneView::Tool tool, double x, double y) {
    REQUIRE(wait_for([&] { return scene.handle(tool).has_value(); }));
    const QPoint from = scene.handle(tool)->toPoint();
    window.after([&] {
      drag_by_hand(&scene, Qt::LeftButton, from, pixel_at(window, {x, y, 0.0}));
    });
  };
  choose(-1.0, -1.0, "patch[spot]");
  drag(SceneView::Tool::move, -0.5, -1.5);
  CHECK(number_in(window, "patch[spot]", "x") == Approx(-0.5).margin(0.03));
  CHECK(number_in(window, "patch[spot]", "y") == Approx(-1.5).margin(0.03));
  drag(SceneView::Tool::resize, -0.1, -1.2);
  CHECK(number_in(window, "patch[spot]", "radius") == Approx(0.4).margin(0.03));
  choose(-1.0, -1.0, "patch[mat]");
  drag(SceneView::Tool::turn, -1.0, -0.5);
  CHECK(number_in(window, "patch[mat]", "heading_deg") == Approx(90.0).margin(3.0));
  choose(-0.5, 1.2, "patch[track]");
  CHECK_FALSE(scene.handle(SceneView::Tool::resize));
  drag(SceneView::Tool::move, 0.3, 1.5);  // from the origin of its points
  CHECK(number_in(window, "patch[track]", "x") == Approx(0.3).margin(0.03));
  CHECK(number_in(window, "patch[track]", "y") == Approx(1.5).margin(0.03));
  choose(0.2, -1.0, "lamp[sun]");
  drag(SceneView::Tool::move, 0.8, -1.2);
  CHECK(number_in(window, "lamp[sun]", "x") == Approx(0.8).margin(0.03));
}

TEST_CASE("What is chosen is moved by a drag of itself, and what is not turns the camera") {
  SeenRoom window;
  enlarge(window);
  const QString before = window.bench().text();
  SceneView& scene = window->scene();
  press_key(&scene, Qt::Key_7);
  const double yaw = scene.camera().yaw;
  const auto drag = [&] {
    drag_by_hand(&scene, Qt::LeftButton, pixel_at(window, {1.15, 1.1, 0.0}),
                 pixel_at(window, {0.15, 0.6, 0.0}));
  };
  click_at(&scene, pixel_at(window, {1.0, 1.0, 0.1}));
  window.after(drag);
  CHECK(number_in(window, "obstacle[crate]", "x") == Approx(0.0).margin(0.1));
  CHECK(number_in(window, "obstacle[crate]", "y") == Approx(0.5).margin(0.1));
  CHECK(scene.camera().yaw == yaw);
  window.after([&] { window.act("undo"); });
  CHECK(window.bench().text() == before);
  click_at(&scene, pixel_at(window, {-1.5, -1.5, 0.0}));
  drag();
  CHECK(scene.camera().yaw != yaw);
  CHECK(window.bench().undo_name() == "enlarge");
}

TEST_CASE("A thing that is small on the screen has no corner to resize it by: it is moved") {
  SeenRoom window;
  SceneView& scene = window->scene();
  window.after([&] {
    window.bench().edit({"obstacle[crate]=<static_box id=\"crate\" x=\"1\" y=\"1\" "
                         "length=\"0.2\" width=\"0.2\"/>"},
                        "replace");
  });
  click_at(&scene, pixel_at(window, {1.0, 1.0, 0.05}));
  const auto foot = scene.handle(SceneView::Tool::move);
  REQUIRE(foot);
  CHECK_FALSE(scene.handle(SceneView::Tool::resize));
  window.after([&] {
    drag_by_hand(&scene, Qt::LeftButton, foot->toPoint(), pixel_at(window, {0.5, 1.0, 0.0}));
  });
  CHECK(window.bench().undo_name() == "move crate");
  CHECK(number_in(window, "obstacle[crate]", "length") == 0.2);
  press_key(&scene, Qt::Key_F);  // near
  CHECK(scene.handle(SceneView::Tool::resize));
}

TEST_CASE("A cylinder stays round, and a prism keeps its form, when they are resized") {
  SeenRoom window;
  const auto resize = [&](const QString& element, const QPointF& to) {
    window.after([&] { window.bench().edit({"obstacle[crate]=" + element}, "replace"); });
    SceneView& scene = window->scene();
    press_key(&scene, Qt::Key_7);
    click_at(&scene, pixel_at(window, {1.0, 1.0, 0.1}));
    REQUIRE(wait_for([&] { return scene.handle(SceneView::Tool::resize).has_value(); }));
    const QPoint corner = scene.handle(SceneView::Tool::resize)->toPoint();
    window.after([&] {
      drag_by_hand(&scene, Qt::LeftButton, corner, pixel_at(window, {to.x(), to.y(), 0.0}));
    });
  };
  resize("<static_cylinder id=\"crate\" x=\"1\" y=\"1\" radius=\"0.2\"/>", {1.4, 1.25});
  CHECK(number_in(window, "obstacle[crate]", "radius") == Approx(0.4).margin(0.03));
  // Its farthest corners are 0.4 m and 0.2 m from its middle.
  resize(
      "<static_prism id=\"crate\" x=\"1\" y=\"1\"><point x=\"0\" y=\"0\"/><point x=\"0.6\" "
      "y=\"0\"/><point x=\"0\" y=\"0.3\"/></static_prism>",
      {1.8, 1.1});
  CHECK(number_in(window, "obstacle[crate]/point[2]", "x") == Approx(1.2).margin(0.05));
  CHECK(number_in(window, "obstacle[crate]/point[3]", "y") == Approx(0.15).margin(0.03));
}

TEST_CASE("Ctrl during a drag snaps to 0.1 m, Shift makes it finer") {
  SeenRoom window;
  SceneView& scene = window->scene();
  press_key(&scene, Qt::Key_7);
  click_at(&scene, pixel_at(window, {1.0, 1.0, 0.1}));
  const auto drag = [&](const QPoint& to, Qt::KeyboardModifiers keys) {
    const QPoint from = scene.handle(SceneView::Tool::move)->toPoint();
    QTest::mousePress(&scene, Qt::LeftButton, {}, from);
    QMouseEvent move(QEvent::MouseMove, to, scene.mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                     keys);
    QApplication::sendEvent(&scene, &move);
    QTest::mouseRelease(&scene, Qt::LeftButton, keys, to);
  };
  window.after([&] { drag(pixel_at(window, {0.43, 0.68, 0.0}), Qt::ControlModifier); });
  CHECK(number_in(window, "obstacle[crate]", "x") == Approx(0.4).margin(1e-9));
  CHECK(number_in(window, "obstacle[crate]", "y") == Approx(0.7).margin(1e-9));
  REQUIRE(
      wait_for([&] { return scene.stage().body_of("obstacle[crate]")->frame.origin.x < 0.41; }));
  const double x = number_in(window, "obstacle[crate]", "x");
  window.after([&] { drag(pixel_at(window, {1.4, 0.7, 0.0}), Qt::ShiftModifier); });
  CHECK(number_in(window, "obstacle[crate]", "x") - x == Approx(0.2).margin(0.02));
}

TEST_CASE("Arrow keys in the view move what is chosen by 10 cm, with Shift by 1 cm") {
  SeenRoom window;
  SceneView& scene = window->scene();
  click_at(&scene, pixel_at(window, {1.0, 1.0, 0.1}));
  window.after([&] { press_key(&scene, Qt::Key_Up); });
  CHECK(number_in(window, "obstacle[crate]", "y") == Approx(1.1));
  window.after([&] { press_key(&scene, Qt::Key_Left, Qt::ShiftModifier); });
  CHECK(number_in(window, "obstacle[crate]", "x") == Approx(0.99));
}

TEST_CASE("The views are in the menu, and F6 goes round the windows") {
  SeenRoom window;
  pick(window, "View", "view_top");
  CHECK(window->scene().camera().pitch < -1.5);
  QSet<QDockWidget*> visited;
  for (int i = 0; i < 8; ++i) {
    press_key(&window.window(), Qt::Key_F6);
    for (QDockWidget* dock : window->findChildren<QDockWidget*>()) {
      QWidget* focus = QApplication::focusWidget();
      if (focus && dock->isAncestorOf(focus)) visited << dock;
    }
  }
  CHECK(visited.size() >= 6);
}

TEST_CASE("F1 shows the keys, the commands dialog does what is typed, and About names Qt") {
  SeenRoom window;
  const auto text_when_shown = [] {
    auto text = std::make_shared<QString>();
    auto* waiting = new QTimer(qApp);
    QObject::connect(waiting, &QTimer::timeout, waiting, [waiting, text] {
      if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
        waiting->deleteLater();
        *text = box->text();
        box->close();
      }
    });
    waiting->start(20);
    return text;
  };
  const auto keys = text_when_shown();
  press_key(&window.window(), Qt::Key_F1);
  CHECK(keys->contains("F5"));
  CHECK(keys->contains("In the view"));
  const auto about = text_when_shown();
  pick(window, "Help", "about");
  CHECK(about->contains(qVersion()));

  at_dialog("commands_dialog", [](QDialog* dialog) {
    QTest::keyClicks(dialog->findChild<QLineEdit*>("wish"), "From the top");
    auto* list = dialog->findChild<QListWidget*>("fitting");
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualItemRect(list->item(0)).center());
  });
  window->activateWindow();
  press_key(&window.window(), Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
  CHECK(wait_for([&] { return window->scene().camera().pitch < -1.5; }));
}

TEST_CASE("F8 goes to the next error") {
  Window window;
  window.open(
      window.file("<world format=\"1\">\n  <robots>\n    <robot id=\"a\" speed=\"1\"/>\n"
                  "    <robot id=\"b\" speed=\"1\"/>\n  </robots>\n</world>\n"));
  REQUIRE(window.bench().problems().size() == 2);
  auto* editor = window->findChild<WorldEditor*>();
  QSet<int> lines;
  for (int i = 0; i < 2; ++i) {
    press_key(&window.window(), Qt::Key_F8);
    lines << editor->textCursor().blockNumber() + 1;
  }
  CHECK(lines == QSet<int>{3, 4});
}

TEST_CASE("A world is opened by dropping it, from the files opened last, and from the examples") {
  Window window;
  const QString file = window.file(kRoom);
  QMimeData held;
  held.setUrls({QUrl::fromLocalFile(file)});
  QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &held, Qt::LeftButton, {});
  QApplication::sendEvent(&window.window(), &enter);
  REQUIRE(enter.isAccepted());
  QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &held, Qt::LeftButton, {});
  QApplication::sendEvent(&window.window(), &drop);
  REQUIRE(wait_for([&] { return window.bench().is_right(); }));
  CHECK(window.bench().file() == file);

  const QString other = window.file(kRoom, "other.xml");
  window.after([&] { window.open(other); });
  QAction* recent = nullptr;
  for (QMenu* each : window->findChildren<QMenu*>()) {
    for (QAction* action : each->actions()) {
      if (action->text() == file) recent = action;
    }
  }
  REQUIRE(recent);
  window.after([&] { recent->trigger(); });
  CHECK(window.bench().file() == file);

  window.act("start_page");
  auto* examples = window.get<QListWidget>("examples");
  REQUIRE(examples->isVisible());
  QListWidgetItem* first = examples->item(0);
  examples->scrollToItem(first);
  window.after([&] {
    const QPoint at = examples->visualItemRect(first).center();
    QTest::mouseClick(examples->viewport(), Qt::LeftButton, {}, at);
    QTest::mouseDClick(examples->viewport(), Qt::LeftButton, {}, at);
  });
  CHECK(window.bench().file() != file);
  CHECK(wait_for([&] { return window.bench().is_right(); }));
}

TEST_CASE("A picture is exported whole or not at all") {
  SeenRoom window;
  const auto export_as = [&](const QString& file) {
    at_dialog("export_dialog", [file](QDialog* dialog) {
      auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
      wait_for([&] {  // the menu gives the focus back some time later
        dialog->activateWindow();
        name->setFocus();
        return name->hasFocus();
      });
      save_as_file(dialog, file);
    });
    at_dialog("picture_dialog",
              [](QDialog* dialog) { Window::press(dialog, QDialogButtonBox::Ok); });
    pick(window, "File", "export_picture");
  };
  const QString picture = window.folder() + "/view.png";
  export_as(picture);
  REQUIRE(wait_for([&] { return window.said().contains("view.png"); }));
  CHECK(QImage(picture).width() == 1890);  // 16 cm at 300 dots per inch
  export_as(window.folder() + "/view.letter");
  auto* box = window.dialog<QMessageBox>("picture_failed");
  CHECK(box->text().contains(".png"));
  box->close();
  CHECK_FALSE(QFile::exists(window.folder() + "/view.letter"));
}

TEST_CASE("A film that outgrows its format is refused, and leaves the file as it was") {
  QTemporaryDir folder;
  const QString file = folder.filePath("run.avi");
  std::ofstream(file.toStdString()) << "before";
  {
    Film film(file, 25.0, 20'000);
    QImage noise(200, 200, QImage::Format_RGB32);
    for (int i = 0; i < 40'000; ++i) {
      noise.setPixel(i % 200, i / 200, QRgb(0xff000000U + 2654435761U * static_cast<unsigned>(i)));
    }
    int added = 0;
    while (added < 100 && film.add(noise)) ++added;
    CHECK(added < 100);
    CHECK(film.error().contains("AVI"));
    CHECK_FALSE(film.end());
  }
  CHECK(bytes_of(file) == "before");
}

TEST_CASE("A trainer whose program cannot start says so, and takes the next lesson") {
  Trainer trainer({}, {});
  int failures = 0;
  QObject::connect(&trainer, &Trainer::failed, &trainer, [&] { ++failures; });
  trainer.train({"<world/>", "world.xml", {}, "robot[r1]/coordinator", {}}, "r1.weights");
  CHECK(wait_for([&] { return failures == 1; }));
  CHECK_FALSE(trainer.is_busy());
  trainer.train({"<world/>", "world.xml", {}, "robot[r1]/coordinator", {}}, "r1.weights");
  CHECK(wait_for([&] { return failures == 2; }));
}

TEST_CASE("A scene that is none leaves the stage empty, and the window alive") {
  SceneView view;
  view.resize(200, 150);
  const Json body = {{"path", "robot[r1]"}};
  const Json shape = {
      {"shape", "box"},      {"size", {1, 1, 1}},
      {"axis", "up"},        {"frame", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
      {"colour", {1, 2, 3}}, {"body", 7}};
  for (const Json& scene :
       {Json{{"arena", {4, 4}}, {"bodies", {body}}, {"shapes", {shape}}}, Json{{"arena", "wide"}},
        Json{{"arena", {4, 4}}, {"bodies", {body}}, {"shapes", {7}}}}) {
    view.set_scene(scene, 1);
    CHECK(view.stage().is_empty());
    CHECK_FALSE(view.picture(1).isNull());
  }
}

TEST_CASE("Where a robot is now, and how fast, is shown beside what it was given") {
  SeenRoom window;
  click_at(&window->scene(), pixel_at(window, {-1.0, 0.0, 0.05}));
  press_key(&window->scene(), Qt::Key_Space);
  auto* properties = window.get<Properties>("properties");
  auto* x = properties->form().findChild<QLabel*>("x_live");
  auto* speed = properties->form().findChild<QLabel*>("max_speed_live");
  auto* energy = properties->form().findChild<QLabel*>("energy_live");
  REQUIRE((x && speed && energy));
  CHECK(wait_for([&] {
    return x->text().contains(QRegularExpression("^now at [0-9.]+ s: x -0\\.[0-9]+ m$"));
  }));
  CHECK(x->isVisible());
  CHECK(wait_for([&] { return speed->text().contains(" s: speed 0.") && speed->isVisible(); }));
  CHECK(wait_for([&] { return energy->text().contains(" s: energy ") && energy->isVisible(); }));
  CHECK(window.bench().text() == kRoom);
}

TEST_CASE("The view says when it shows the past") {
  SeenRoom window;
  window.bench().set_speed(5.0);
  press_key(&window->scene(), Qt::Key_Space);
  REQUIRE(wait_for([&] { return window.bench().time_s() > 1.0; }));
  press_key(&window->scene(), Qt::Key_Space);
  REQUIRE(wait_for([&] { return window.bench().run_state() == Workbench::Run::paused; }));
  CHECK_FALSE(window->scene().stage().is_past());
  window.get<QWidget>("time")->setFocus();
  press_key(&window.window(), Qt::Key_Home);
  REQUIRE(wait_for([&] { return window->scene().stage().is_past(); }));
  click_on(window.get<QToolButton>("now"));
  CHECK(wait_for([&] { return !window->scene().stage().is_past(); }));
}
