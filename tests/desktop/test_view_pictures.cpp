// Pictures of worlds in the view alone, for docs and for eyes: scripts/desktop-pictures. Hidden
// from ordinary runs.
#include <QDockWidget>
#include <cmath>

#include <catch2/catch.hpp>

#include "engine/elements.h"
#include "scene/scene_view.h"
#include "window.h"

using namespace elsie::desktop;

namespace {

constexpr const char* kCrowd = R"(<world format="1" name="a hundred robots">
  <arena length="10" width="10"/>
  <layouts>
    <scatter id="box" count="20" gap="0.3"><static_box length="0.4" width="0.4" height="0.4"/><in_box/></scatter>
    <scatter id="red" count="50" gap="0.15"><robot team="red">
      <sensors><beam_range id="left" yaw_deg="30"/><beam_range id="right" yaw_deg="-30"/></sensors>
      <behaviors><avoid_obstacle/></behaviors><coordinator><arbiter_suppression/></coordinator>
    </robot><in_box/><heading/></scatter>
    <scatter id="blue" count="50" gap="0.15"><robot team="blue">
      <sensors><beam_range id="left" yaw_deg="30"/><beam_range id="right" yaw_deg="-30"/></sensors>
      <behaviors><avoid_obstacle/></behaviors><coordinator><arbiter_suppression/></coordinator>
    </robot><in_box/><heading/></scatter>
  </layouts>
  <limits time="600"/>
</world>)";

void keep(SceneView& scene, const QString& name) {
  const QString folder = qEnvironmentVariable("ELSIE_PICTURES", ".");
  CHECK(scene.picture().save(folder + "/view_" + name + ".png"));
}

/// A view of 960 x 600, most of a window of 1280 x 800, of a world after some time.
void show(Window& window, const QString& file, double time_s) {
  window.open(file);
  window->resize(1280, 800);
  for (QDockWidget* each : window->findChildren<QDockWidget*>()) each->hide();
  REQUIRE(wait_for([&] { return !window->scene().stage().is_empty(); }));
  if (time_s > 0.0) {
    window.bench().set_speed(0.0);
    run_until(window, time_s);
    SceneView& scene = window->scene();
    const QString robot = robot_id(scene.stage().bodies().front().path);
    // The engine sends what it has stored bit by bit.
    REQUIRE(wait_for([&] {
      const auto pieces = scene.trails().pieces(robot, time_s);
      const auto at = scene.stage().bodies().front().frame.origin;
      return !pieces.empty() &&
             std::hypot(pieces.back().back().x() - at.x, pieces.back().back().y() - at.y) < 0.1;
    }));
  }
  window->scene().show_all();
}

}  // namespace

TEST_CASE("Pictures: worlds in the view", "[.pictures]") {
  for (const auto& [world, time_s] : {std::pair{"clutter", 8.0},
                                      {"four_resources", 6.0},
                                      {"find_resource", 8.0},
                                      {"train", 8.0},
                                      {"shapes", 2.0},
                                      {"drives", 4.0},
                                      {"maze", 20.0}}) {
    Window window;
    show(window, world_file(world), time_s);
    keep(window->scene(), world);
  }
  const QString examples = ELSIE_SOURCE_DIR "/examples/";
  for (const auto& [file, name, time_s] : {std::tuple{"09-acts/foraging.xml", "foraging", 40.0},
                                           {"09-acts/trail.xml", "field", 40.0},
                                           {"08-senses/phototaxis.xml", "lamp", 8.0}}) {
    Window window;
    show(window, examples + file, time_s);
    keep(window->scene(), name);
  }
}

TEST_CASE("Pictures: a hundred robots in the view", "[.pictures]") {
  Window window;
  show(window, window.file(kCrowd), 5.0);
  keep(window->scene(), "crowd");
  window->scene().camera().distance *= 6.0;
  keep(window->scene(), "crowd_far");
}

TEST_CASE("Pictures: the camera's places", "[.pictures]") {
  Window window;
  show(window, world_file("clutter"), 8.0);
  SceneView& scene = window->scene();
  const QString robot = scene.stage().bodies().front().path;
  window.choose(robot);
  for (const char* where :
       {"view_top", "view_front", "view_side", "view_isometric", "follow_behind", "robot_eye"}) {
    window.act(where);
    keep(scene, where);
  }
}
