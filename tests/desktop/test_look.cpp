// What the view shows of a world: fronts, wheels, goals, sensors, and robots that are far away; how
// finely it is drawn, and where its camera may be.
#include <QImage>
#include <cmath>

#include <catch2/catch.hpp>

#include "hands.h"
#include "scene/quality.h"

using namespace elsie;
using namespace elsie::desktop;

namespace {

constexpr const char* kGoals = R"(<world format="1">
  <arena length="4" width="4"/>
  <robots>
    <robot id="r1" team="red" x="-1">
      <sensors><beam_range id="ahead"/></sensors>
      <behaviors><wander/></behaviors>
      <coordinator><arbiter_suppression/></coordinator>
    </robot>
  </robots>
  <goals><reach robot="r1" x="1" y="1" radius="0.3"/></goals>
  <limits time="60"/>
</world>
)";

/// Without what is drawn over the world.
void show_solids_only(SceneView& scene) { scene.overlays() = {false, false, false, false}; }

QColor seen(SceneView& scene, const QImage& picture, const Vector3& at) {
  const auto pixel = scene.pixel_of(at);
  REQUIRE(pixel);
  return picture.pixelColor((*pixel * scene.devicePixelRatioF()).toPoint());
}

bool is_red(const QColor& colour) {
  return colour.red() > 2 * colour.green() && colour.red() > 2 * colour.blue();
}

bool stands_on_the_stage(Window& window) {
  return wait_for([&] { return window->scene().stage().body_of("robot[r1]") != nullptr; });
}

}  // namespace

TEST_CASE("A robot shows where its front is") {
  Room window;
  REQUIRE(stands_on_the_stage(window));
  SceneView& scene = window->scene();
  show_solids_only(scene);
  scene.look(OrbitCamera::kFromTop);
  scene.camera().target = {-1.0, 0.0, 0.0};
  scene.camera().distance = 1.0;
  const Stage& stage = scene.stage();
  const Stage::Solid& chassis = *stage.chassis_of(*stage.body_of("robot[r1]"));
  const Frame frame = stage.frame_of(chassis);
  const QImage picture = scene.picture(1);
  int marked_ahead = 0, marked_behind = 0;
  for (double part = 0.05; part < 0.45; part += 0.05) {
    const Vector3 ahead{part * chassis.shape.size.x, 0.0, 0.5 * chassis.shape.size.z};
    marked_ahead += !is_red(seen(scene, picture, frame.point(ahead)));
    marked_behind += !is_red(seen(scene, picture, frame.point({-ahead.x, 0.0, ahead.z})));
  }
  CHECK(marked_ahead >= 3);
  CHECK(marked_behind == 0);
}

TEST_CASE("Wheels turn as far as the robot has driven") {
  Room window;
  REQUIRE(stands_on_the_stage(window));
  const Stage& stage = window->scene().stage();
  const auto wheel = [&]() -> const Stage::Solid& {
    return *std::find_if(stage.solids().begin(), stage.solids().end(), [](const auto& solid) {
      return solid.material == render::Material::wheel;
    });
  };
  CHECK(wheel().turned_rad == 0.0);
  window.bench().run();
  REQUIRE(wait_for([&] { return std::abs(wheel().turned_rad) > 0.3; }));
  window.pause();
  const double turned = wheel().turned_rad;
  const auto drawn = stage.drawn();
  const Frame axle = stage.frame_of(wheel());
  const auto same_place = std::find_if(drawn.cylinders.begin(), drawn.cylinders.end(),
                                       [&](const render::Cylinder& each) {
                                         const Vector3 away = each.frame.origin - axle.origin;
                                         return dot(away, away) < 1e-9;
                                       });
  REQUIRE(same_place != drawn.cylinders.end());
  CHECK(dot(same_place->frame.forward, axle.forward) == Approx(std::cos(turned)).margin(1e-6));
}

TEST_CASE("A robot that would be a speck has a ring of its team's colour") {
  Room window;
  REQUIRE(stands_on_the_stage(window));
  SceneView& scene = window->scene();
  show_solids_only(scene);
  const auto red_pixels = [&] {
    const QImage picture = scene.picture(1);
    int count = 0;
    for (int y = 0; y < picture.height(); ++y) {
      for (int x = 0; x < picture.width(); ++x) count += is_red(picture.pixelColor(x, y));
    }
    return count;
  };
  scene.camera().distance = 200.0;
  CHECK(red_pixels() > 20);
  CHECK(red_pixels() < 400);
}

TEST_CASE("The picture is full at rest, and begins anew when something moves") {
  Room window;
  REQUIRE(stands_on_the_stage(window));
  SceneView& scene = window->scene();
  if (!scene.photograph().is_possible()) return;  // without OpenGL
  scene.photograph().set_finest(render::kFinished);
  REQUIRE(wait_for([&] { return scene.photograph().is_finished(); }));
  const QImage full = scene.photograph().image().copy();
  scene.camera().orbit({40.0, 0.0});
  scene.show_all();
  scene.repaint();
  CHECK(scene.photograph().refined() == 0);
  REQUIRE(wait_for([&] { return scene.photograph().is_finished(); }));
  CHECK(scene.photograph().image() != full);
}

TEST_CASE("A picture of another view between two passes does not get into this one") {
  Room window;
  REQUIRE(stands_on_the_stage(window));
  SceneView& scene = window->scene();
  if (!scene.photograph().is_possible()) return;  // without OpenGL
  scene.picture(4);
  const QImage alone = scene.photograph().image().copy();
  scene.picture(2);
  SceneView other;
  other.resize(300, 200);
  other.set_scene(window.bench().scene(), window.bench().epoch());
  CHECK(other.film_picture(1.0).size() == QSize(300, 200));
  scene.photograph().refine();
  scene.photograph().refine();
  scene.photograph().develop();
  CHECK(scene.photograph().image() == alone);
}

TEST_CASE("A moving picture becomes rougher while it takes too long, and finer again") {
  Quality quality;
  const std::size_t first = quality.number();
  quality.took(100.0);
  CHECK(quality.number() == first);  // a single one may have had bad luck
  for (int i = 0; i < 20; ++i) quality.took(100.0);
  CHECK(quality.number() == 0);
  CHECK(quality.level().passes == 1);
  for (int i = 0; i < 100; ++i) quality.took(1.0);
  CHECK(quality.number() + 1 == Quality::kLevels.size());
  // Nothing is tried that would be too slow.
  Quality careful;
  for (int i = 0; i < 100; ++i) careful.took(0.7 * Quality::kMost_ms);
  CHECK(careful.number() == first);
}

TEST_CASE("The camera stays above the floor") {
  OrbitCamera camera;
  for (const double distance : {10.0, 0.05}) {
    camera.distance = distance;
    for (int i = 0; i < 50; ++i) camera.orbit({0.0, -100.0});
    CHECK(camera.frame().origin.z > 0.02);
  }
  camera.distance = 10.0;
  for (int i = 0; i < 50; ++i) camera.orbit({0.0, -100.0});
  for (int i = 0; i < 60; ++i) {
    camera.zoom(0.8, {320.0, 200.0}, {640.0, 400.0});
    CHECK(camera.frame().origin.z > 0.02);
  }
}

TEST_CASE("A world fills the view when it is opened") {
  OrbitCamera camera;
  for (const QSizeF size : {QSizeF(1280, 800), QSizeF(500, 700), QSizeF(900, 300)}) {
    for (const double length : {2.0, 12.0}) {
      camera.show(length, 2.0, 0.3, size);
      QRectF area;
      for (int corner = 0; corner < 8; ++corner) {
        const auto at = camera.project(
            {(corner & 1 ? 0.5 : -0.5) * length, corner & 2 ? 1.0 : -1.0, corner & 4 ? 0.3 : 0.0},
            size);
        REQUIRE(at);
        CHECK(QRectF(QPointF(), size).contains(*at));
        area =
            corner == 0 ? QRectF(*at, QSizeF(1e-9, 1e-9)) : area.united({*at, QSizeF(1e-9, 1e-9)});
      }
      CHECK(std::max(area.width() / size.width(), area.height() / size.height()) > 0.8);
      CHECK(std::abs(area.center().x() - 0.5 * size.width()) < 0.05 * size.width());
      CHECK(std::abs(area.center().y() - 0.5 * size.height()) < 0.05 * size.height());
    }
  }
}

TEST_CASE(
    "The camera looks obliquely by a key, follows a robot from behind, and sits in its place") {
  Room window;
  REQUIRE(stands_on_the_stage(window));
  SceneView& scene = window->scene();
  window.choose("robot[r1]");
  scene.setFocus();
  QTest::keyClick(&scene, Qt::Key_9);
  CHECK(scene.camera().pitch == Approx(-0.6155));
  QTest::keyClick(&scene, Qt::Key_B);
  const auto robot = [&] { return scene.stage().body_of("robot[r1]")->frame; };
  const auto is_behind = [&] {
    const Frame eye = scene.camera().frame();
    return dot(eye.origin - robot().origin, robot().forward) < -0.5;
  };
  CHECK(is_behind());
  window.run_past(2.0);
  CHECK(is_behind());
  QTest::keyClick(&scene, Qt::Key_0);
  CHECK(dot(scene.camera().frame().forward, robot().forward) == Approx(1.0));
  CHECK(std::hypot(scene.camera().frame().origin.x - robot().origin.x,
                   scene.camera().frame().origin.y - robot().origin.y) < 0.3);
  // It does not see the robot itself.
  show_solids_only(scene);
  const QImage ahead = scene.picture(1);
  CHECK_FALSE(is_red(ahead.pixelColor(ahead.width() / 2, ahead.height() - 2)));
  // A hand on the camera takes it out of there.
  const QPoint middle = scene.rect().center();
  drag_by_hand(&scene, Qt::LeftButton, middle, middle + QPoint(60, 0));
  CHECK_FALSE(scene.camera().seat);
  CHECK(scene.followed().isEmpty());
}

TEST_CASE("Goals have their places in the view, with their names") {
  Room window(kGoals);
  REQUIRE(stands_on_the_stage(window));
  SceneView& scene = window->scene();
  REQUIRE(scene.stage().goals().size() == 1);
  CHECK(scene.stage().goals().front().radius == Approx(0.3));
  const std::vector<Label> labels = scene.labels();
  CHECK(std::any_of(labels.begin(), labels.end(),
                    [](const Label& each) { return each.text == "goal of r1"; }));
  scene.look(OrbitCamera::kFromTop);
  const QColor middle = seen(scene, scene.picture(1), {1.0, 1.0, 0.0});
  CHECK(middle.green() < 200);  // the cross
}

TEST_CASE("A selected sensor is marked, and beams are drawn before the first step") {
  Room window;
  REQUIRE(stands_on_the_stage(window));
  SceneView& scene = window->scene();
  REQUIRE(wait_for([&] { return !scene.stage().marks().empty(); }));
  const auto& beam = scene.stage().marks().front();
  CHECK(beam.end().x - beam.begin().x > 0.5);
  const QImage before = scene.picture(1);
  window.choose("robot[r1]/sensor[ahead]");
  CHECK(scene.stage().sensor_frame("robot[r1]/sensor[ahead]"));
  CHECK(scene.picture(1) != before);
}
