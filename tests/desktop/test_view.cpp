// The main view: camera, overlays, handles and keys, by real mouse events.
#include <QImage>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "hands.h"
#include "watch/vision_panel.h"

using namespace elsie::desktop;

namespace {

constexpr const char* kSeeing = R"(<world format="1">
  <arena length="4" width="4"/>
  <obstacles><static_box id="crate" x="1" y="0.3"/></obstacles>
  <robots>
    <robot id="r1" team="red" x="-1">
      <sensors>
        <beam_range id="ahead"/>
        <proximity id="skin" yaw_deg="90"/>
        <vision id="eye"/>
      </sensors>
      <behaviors><wander/></behaviors>
      <coordinator><arbiter_suppression/></coordinator>
    </robot>
  </robots>
  <limits time="60"/>
</world>
)";

}  // namespace

TEST_CASE("The camera orbits, pans and zooms by the mouse, and looks from three sides by keys") {
  Room window(kSeeing);
  SceneView& scene = window->scene();
  const QPoint middle = scene.rect().center();
  const double yaw = scene.camera().yaw, pitch = scene.camera().pitch;
  drag_by_hand(&scene, Qt::LeftButton, middle, middle + QPoint(60, 0));
  CHECK(scene.camera().yaw != yaw);
  CHECK(scene.camera().pitch == pitch);
  const auto before = scene.camera().target;
  drag_by_hand(&scene, Qt::RightButton, middle, middle + QPoint(0, 50));
  CHECK(std::hypot(scene.camera().target.x - before.x, scene.camera().target.y - before.y) > 0.05);
  const double distance = scene.camera().distance;
  turn_wheel(&scene, middle, 240);
  CHECK(scene.camera().distance < distance);

  // What is under the pointer stays there.
  const auto under = scene.camera().on_plane({200.0, 150.0}, scene.size());
  REQUIRE(under);
  turn_wheel(&scene, {200, 150}, 120);
  const auto still = scene.pixel_of(*under);
  REQUIRE(still);
  CHECK(std::hypot(still->x() - 200.0, still->y() - 150.0) < 1.0);

  scene.setFocus();
  QTest::keyClick(&scene, Qt::Key_7);
  CHECK(scene.camera().pitch < -1.5);
  QTest::keyClick(&scene, Qt::Key_1);
  CHECK(scene.camera().pitch > -0.2);
  const double front = scene.camera().yaw;
  QTest::keyClick(&scene, Qt::Key_3);
  CHECK(std::abs(scene.camera().yaw - front) == Approx(M_PI / 2.0));
}

TEST_CASE("Ctrl and the mouse move the camera, also over the handle of what is chosen") {
  Room window(kSeeing);
  SceneView& scene = window->scene();
  REQUIRE(wait_for([&] { return scene.stage().body_of("robot[r1]") != nullptr; }));
  window.choose("robot[r1]");
  const auto handle = scene.handle(SceneView::Tool::move);
  REQUIRE(handle);
  const double yaw = scene.camera().yaw;
  drag_by_hand(&scene, Qt::LeftButton, handle->toPoint(), handle->toPoint() + QPoint(50, 10),
               Qt::ControlModifier);
  CHECK(scene.camera().yaw != yaw);
  CHECK(window.bench().text() == kSeeing);
}

TEST_CASE("The camera follows a robot") {
  Room window(kSeeing);
  SceneView& scene = window->scene();
  window.choose("robot[r1]");
  scene.setFocus();
  QTest::keyClick(&scene, Qt::Key_F, Qt::ShiftModifier);
  window.run_past(2.0);
  REQUIRE(wait_for([&] {
    const auto& robot = scene.stage().body_of("robot[r1]")->frame.origin;
    return std::abs(scene.camera().target.x - robot.x) < 1e-6 &&
           std::abs(scene.camera().target.y - robot.y) < 1e-6;
  }));
  CHECK(std::abs(scene.camera().target.x + 1.0) > 0.05);  // it has driven
}

TEST_CASE("The camera that follows a robot rises over what would hide it, and sinks again") {
  const bool is_at_wall = GENERATE(true, false);
  INFO((is_at_wall ? "a wall" : "a box"));
  Room window(QString(kSeeing)
                  .replace("x=\"-1\"", is_at_wall ? "x=\"-1.8\"" : "x=\"0.3\"")
                  .replace("x=\"1\" y=\"0.3\"",
                           is_at_wall ? "x=\"1\" y=\"1.5\"" : "x=\"-0.1\" y=\"0\" height=\"0.4\"")
                  .replace("<wander/>", "<go_to_point x=\"1.6\" y=\"0\"/>"));
  SceneView& scene = window->scene();
  // What is seen of the world where the robot is.
  const auto seen = [&] {
    const auto* chassis = scene.stage().chassis_of(*scene.stage().body_of("robot[r1]"));
    const auto eye = scene.camera().frame().origin;
    return scene.stage().at(eye, scene.stage().frame_of(*chassis).origin - eye).toStdString();
  };
  window.choose("robot[r1]");
  scene.setFocus();
  QTest::keyClick(&scene, Qt::Key_B);
  CHECK(seen() == "robot[r1]");
  const QPoint middle = scene.rect().center();
  drag_by_hand(&scene, Qt::LeftButton, middle, middle - QPoint(0, 200), Qt::ControlModifier);
  CHECK(seen() == "robot[r1]");
  const double raised = scene.camera().raised;
  CHECK(raised > 0.1);
  window.run_past(4.0);
  CHECK(seen() == "robot[r1]");
  CHECK(scene.camera().raised < 0.9 * raised);
}

TEST_CASE("A camera that does not follow stands behind walls, if one likes") {
  const auto orbited = [](const QString& text, bool hides) {
    Room window(text);
    SceneView& scene = window->scene();
    scene.camera() = OrbitCamera();
    const QPoint middle = scene.rect().center();
    drag_by_hand(&scene, Qt::LeftButton, middle, middle - QPoint(0, 200));
    window.step();
    const auto eye = scene.camera().frame().origin;
    CHECK(scene.stage().is_hidden({-1.0, 0.0, 0.05}, eye) == hides);
    return eye;
  };
  const auto in_the_open = orbited(QString(kSeeing)
                                       .replace("width=\"4\"", "width=\"4\" walls=\"false\"")
                                       .replace("<static_box id=\"crate\" x=\"1\" y=\"0.3\"/>", ""),
                                   false);
  CHECK(orbited(kSeeing, true) == in_the_open);
}

TEST_CASE(
    "Trajectories, sketches of plugins, names and grid are drawn and can be hidden; "
    "no robot's camera sees them") {
  Room window(kSeeing);
  window->arrange("watch");
  SceneView& scene = window->scene();
  auto* vision = window->findChild<VisionPanel*>();
  window.run_past(2.0);
  REQUIRE(scene.stage().marks().size() >= 17);  // one ray, eight edges each of two pyramids
  REQUIRE(wait_for([&] { return !vision->picture("r1/eye raw").isNull(); }));
  const QImage with = scene.picture(1);
  const QImage seen = vision->picture("r1/eye raw");
  for (const char* name : {"show_trails", "show_sketches", "show_names", "show_grid"}) {
    INFO(name);
    window.act(name);
    CHECK(scene.picture(1) != with);
    window.act(name);
    CHECK(scene.picture(1) == with);
  }
  // A camera's picture has the world only, whatever the window draws: with everything hidden from
  // the start, the same step of the same run gives the same picture.
  const double time_s = window.bench().time_s();
  Window other;
  other.open(other.file(kSeeing));
  other->arrange("watch");
  auto* other_vision = other->findChild<VisionPanel*>();
  for (const char* name : {"show_trails", "show_sketches", "show_names", "show_grid"}) {
    other.act(name);
  }
  while (other.bench().time_s() < time_s) {
    const double before_s = other.bench().time_s();
    other.act("step");
    REQUIRE(wait_for([&] { return other.bench().time_s() > before_s; }));
  }
  REQUIRE(other.bench().time_s() == time_s);
  REQUIRE(wait_for([&] { return !other_vision->picture("r1/eye raw").isNull(); }));
  CHECK(wait_for([&] { return other_vision->picture("r1/eye raw") == seen; }));
  CHECK(with != other->scene().picture(1));
}

TEST_CASE("Lines behind robots are the same painted bit by bit and at once") {
  Room window(kSeeing);
  SceneView& scene = window->scene();
  scene.overlays() = {.trails = true, .sketches = false, .names = false, .grid = false};
  window.run_past(3.0);
  const QImage bit_by_bit = scene.picture(1).convertToFormat(QImage::Format_Grayscale8);
  scene.follow({});
  scene.camera().yaw += 1.0;
  scene.show_all();
  scene.camera().yaw -= 1.0;
  scene.show_all();  // the lines are painted again
  const QImage at_once = scene.picture(1).convertToFormat(QImage::Format_Grayscale8);
  REQUIRE(bit_by_bit.size() == at_once.size());
  int different = 0;
  for (int y = 0; y < at_once.height(); ++y) {
    for (int x = 0; x < at_once.width(); ++x) {
      different += std::abs(qGray(bit_by_bit.pixel(x, y)) - qGray(at_once.pixel(x, y))) > 60;
    }
  }
  CHECK(different < 20);
}

TEST_CASE("G, R and S with an axis and a number move, turn and resize; Esc leaves all as it was") {
  Room window;
  SceneView& scene = window->scene();
  REQUIRE(wait_for([&] { return scene.stage().body_of("obstacle[crate]") != nullptr; }));
  window.choose("obstacle[crate]");
  scene.setFocus();
  const auto type = [&](const char* keys) {
    for (const char* key = keys; *key; ++key) {
      QTest::keyClick(&scene, *key);
    }
  };
  type("gy-0.5");
  QTest::keyClick(&scene, Qt::Key_Escape);
  CHECK(window.bench().text() == kRoom);
  window.after([&] {
    type("gy-0.5");
    QTest::keyClick(&scene, Qt::Key_Return);
  });
  CHECK(window.bench().text().contains("y=\"0.5\""));
  window.after([&] {
    type("r30");
    QTest::keyClick(&scene, Qt::Key_Return);
  });
  CHECK(window.bench().text().contains("heading_deg=\"30\""));
  const QString before = window.bench().text();
  window.after([&] {
    type("sx2");
    QTest::keyClick(&scene, Qt::Key_Return);
  });
  CHECK(window.bench().text() != before);
  CHECK(window.bench().undo_name().contains("crate"));
  CHECK_FALSE(window->findChild<QDialog*>("element_dialog"));  // Enter was the view's
  for (int i = 0; i < 3; ++i) {
    window.after([&] { window.act("undo"); });
  }
  CHECK(window.bench().text() == kRoom);
}

TEST_CASE("The measuring tape says how far apart two places are") {
  Room window;
  SceneView& scene = window->scene();
  scene.look(OrbitCamera::kFromTop);
  const auto from = scene.pixel_of({-1.0, 0.0, 0.0}), to = scene.pixel_of({1.0, 0.0, 0.0});
  REQUIRE((from && to));
  double length = 0.0;
  QObject::connect(&scene, &SceneView::measured, &scene,
                   [&](double x, double y, double to_x, double to_y) {
                     length = std::hypot(to_x - x, to_y - y);
                   });
  window.act("measure");
  drag_by_hand(&scene, Qt::LeftButton, from->toPoint(), to->toPoint());
  CHECK(length == Approx(2.0).margin(0.02));
  CHECK(window.said().contains(" m"));
  CHECK(window.bench().text() == kRoom);
}

TEST_CASE("The arena is whole in a view of any size until the camera is moved") {
  Room window(kSeeing);
  SceneView& scene = window->scene();
  const auto is_whole = [&] {
    for (const double x : {-2.0, 2.0}) {
      for (const double y : {-2.0, 2.0}) {
        const auto at = scene.camera().project({x, y, 0.0}, scene.size());
        if (!at || !QRectF(scene.rect()).contains(*at)) return false;
      }
    }
    return true;
  };
  CHECK(is_whole());
  for (const QSize size : {QSize(900, 500), QSize(1500, 600), QSize(1000, 1000)}) {
    const QSize before = scene.size();
    window->resize(size);
    REQUIRE(wait_for([&] { return scene.size() != before; }));
    CHECK(is_whole());
  }
  turn_wheel(&scene, scene.rect().center(), 480);
  const double near = scene.camera().distance;
  const QSize before = scene.size();
  window->resize(1200, 700);
  REQUIRE(wait_for([&] { return scene.size() != before; }));
  CHECK(scene.camera().distance == near);
}

TEST_CASE("Names do not lie over one another, however small the robots are") {
  Window window(world_file("ten_robots"));
  SceneView& scene = window->scene();
  REQUIRE(wait_for([&] { return scene.labels().size() == 10; }));
  const auto are_apart = [&] {
    const std::vector<Label> labels = scene.labels();
    for (std::size_t i = 0; i < labels.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        if (labels[i].box.intersects(labels[k].box)) return false;
      }
    }
    return true;
  };
  CHECK(are_apart());
  for (int i = 0; i < 12; ++i) turn_wheel(&scene, scene.rect().center(), -240);
  CHECK_FALSE(scene.labels().empty());
  CHECK(scene.labels().size() < 10);
  CHECK(are_apart());
}

TEST_CASE("The names of a crowd do not hide it") {
  QByteArray crowd;
  for (int i = 0; i < 400; ++i) {
    crowd += "<robot id=\"robot" + QByteArray::number(i) + "\" x=\"" +
             QByteArray::number(i % 20 - 9.5) + "\" y=\"" + QByteArray::number(i / 20 - 9.5) +
             "\"/>";
  }
  Window window;
  window.open(window.file("<world format=\"1\"><arena length=\"21\" width=\"21\"/><robots>" +
                          crowd + "</robots></world>"));
  const SceneView& scene = window->scene();
  REQUIRE(wait_for([&] { return scene.stage().bodies().size() == 400; }));
  double covered = 0.0;
  for (const Label& each : scene.labels()) covered += each.box.width() * each.box.height();
  CHECK(covered > 0.0);
  CHECK(covered < 0.17 * scene.width() * scene.height());
}

TEST_CASE("What is locked is marked in the trees and in the view, and can be unlocked") {
  Room window(kSeeing);
  SceneView& scene = window->scene();
  REQUIRE(wait_for([&] { return scene.stage().body_of("robot[r1]") != nullptr; }));
  auto* tree = window.get<WorldTree>("world_tree");
  auto* team = window.get<WorldTree>("team_tree_red");
  scene.overlays() = {false, false, false, false};
  window.choose("robot[r1]");
  const QAction* lock = window.get<QAction>("lock");
  CHECK(lock->text().remove('&') == "Lock against the mouse");
  CHECK_FALSE(tree->item("robot[r1]")->toolTip(0).contains("Locked"));
  const auto picture = [&] {
    window->findChild<WorldTree*>("world_tree")->tree()->clearSelection();
    const QImage image = scene.grab().toImage();
    window.choose("robot[r1]");
    return image;
  };
  const QImage before = picture();
  window.act("lock");
  CHECK(tree->item("robot[r1]")->toolTip(0).contains("Locked"));
  CHECK(tree->item("robot[r1]")->toolTip(0).contains("Locked"));
  CHECK(team->item("robot[r1]")->toolTip(0).contains("Locked"));
  CHECK_FALSE(tree->item("robot[r1]/sensor[ahead]")->toolTip(0).contains("Locked"));
  CHECK(lock->text().remove('&') == "Unlock for the mouse");
  CHECK(picture() != before);

  // The mark goes with a new name, and with the lock.
  window.after([&] { window.bench().edit({"robot[r1]/@id=r9"}, "rename"); });
  CHECK(tree->item("robot[r9]")->toolTip(0).contains("Locked"));
  window.choose("robot[r9]");
  window.act("lock");
  CHECK_FALSE(tree->item("robot[r9]")->toolTip(0).contains("Locked"));
}

TEST_CASE("A field lies over the floor in the view while the world runs") {
  Room window(R"(<world format="1"><arena length="4" width="4"/>
  <floor colour="#808080"/>
  <fields><field id="heat" cell="0.5" start="1" full="1" colour="#0000ff"/></fields>
  <limits time="60"/></world>
)");
  REQUIRE(wait_for([&] { return window->scene().stage().has_fields(); }));
  CHECK(wait_for([&] {
    const auto image = window->scene().stage().drawn().image;
    return image.pixels && image.size.x == 4.0 && image.pixels->pixel(3, 3)[2] > 200 &&
           image.pixels->pixel(3, 3)[0] < 40;
  }));
}

TEST_CASE("A dashed circle shows how far the selected robot perceives its team") {
  Room window(QString(kSeeing).replace("team=\"red\"", "team=\"red\" coverage=\"0.9\""));
  auto& scene = window->scene();
  scene.look(OrbitCamera::kFromTop);
  const auto dashes = [&] {
    const QImage image = scene.grab().toImage();
    int count = 0;
    for (int i = 0; i < 60; ++i) {
      const double angle = 2.0 * std::numbers::pi * (i + 0.25) / 60;
      const auto at = scene.camera().project(
          {-1.0 + 0.9 * std::cos(angle), 0.9 * std::sin(angle), 0.0}, scene.size());
      REQUIRE(at);
      bool is_orange = false;
      for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
          const QColor pixel =
              image.pixelColor(at->toPoint() * image.devicePixelRatio() + QPoint(x, y));
          is_orange = is_orange || pixel.red() - pixel.blue() > 60;
        }
      }
      count += is_orange ? 1 : 0;
    }
    return count;
  };
  CHECK(dashes() < 5);
  window.choose("robot[r1]");
  CHECK(dashes() > 50);
}

TEST_CASE("What robots shine is drawn as lamps are") {
  Stage stage;
  const Json axes = {{1, 0, 0.2}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Json light = {{"shape", "sphere"},       {"axis", "up"},  {"size", {0.06, 0.06, 0.06}},
                      {"colour", {255, 200, 0}}, {"frame", axes}, {"body", -1},
                      {"path", "robot[r1]"}};
  REQUIRE(stage.set_scene({{"arena", {4, 4}},
                           {"has_actuators", true},
                           {"bodies", Json::array()},
                           {"shapes", Json::array()}},
                          1));
  CHECK(stage.has_actuators());
  const std::size_t before = stage.drawn().balls.size();
  stage.take_lights(Json::array({light}));
  CHECK(stage.drawn().balls.size() == before + 1);
  CHECK(stage.drawn().balls.back().colour == elsie::Colour{255, 200, 0});
  stage.take_lights(Json::array());
  CHECK(stage.drawn().balls.size() == before);
  stage.take_lights(Json::array({{{"shape", "star"}}}));
  CHECK(stage.drawn().balls.size() == before);
}

TEST_CASE("A field lies over patches and nests, as in pictures from above") {
  Room window(R"(<world format="1"><arena length="4" width="4"/>
  <floor colour="#808080"/>
  <patches><disc_patch id="spot" x="1" y="1" radius="0.5" colour="#ff0000"/></patches>
  <fields><field id="heat" cell="0.5" start="0.5" full="1" colour="#0000ff"/></fields>
  <limits time="60"/></world>
)");
  const auto red = [&](double x, double y) {
    const auto scene = window->scene().stage().drawn();
    if (!scene.image.pixels || !scene.patches.empty()) return 0;
    const elsie::Image& pixels = *scene.image.pixels;
    const auto part = [](double at, int count) { return static_cast<int>((0.5 + at / 4) * count); };
    const auto* const pixel = pixels.pixel(part(x, pixels.width), part(-y, pixels.height));
    return pixel[2] > 60 ? int{pixel[0]} : 0;
  };
  // Half of what is below is seen: the patch is redder than the floor.
  CHECK(wait_for([&] { return red(1.0, 1.0) > red(-1.0, -1.0) + 40; }));
  CHECK(red(-1.0, -1.0) > 40);
}
