#include "elsie/render/world_cameras.h"

#include <optional>
#include <vector>

#include "elsie/render/renderer.h"
#include "elsie/render/world_scene.h"

namespace elsie::render {
namespace {

class WorldCameras final : public simulation::CameraRenderer {
 public:
  explicit WorldCameras(const world::World& world) : world_(world), scene_(world) {}

  int largest_size() const override { return renderer_.largest_size(); }

  void take(const physics::Engine& engine, std::span<const simulation::CameraView> views,
            std::span<const simulation::CarriedLight> lights) override {
    place_bodies(engine);
    scene_.show_lights(lights);
    views_.clear();
    pictures_.clear();
    for (const simulation::CameraView& view : views) {
      views_.push_back({view.frame, view.camera, view.robot});
      pictures_.push_back(view.picture);
    }
    renderer_.render(scene_.scene(), views_, pictures_);
  }

 private:
  void place_bodies(const physics::Engine& engine) {
    for (std::size_t i = 0; i < world_.robots.size(); ++i) {
      scene_.place_robot(i, engine.robot(i).frame);
      for (std::size_t segment = 0; segment < engine.segments(i); ++segment) {
        scene_.place_segment(i, segment, engine.segment(i, segment).frame);
      }
    }
    for (std::size_t i = 0; i < world_.obstacles.size(); ++i) {
      if (world_.obstacles[i].kind != world::ObstacleKind::fixed) {
        scene_.place_box(i,
                         engine.has_obstacle(i) ? std::optional(engine.obstacle(i)) : std::nullopt);
      }
    }
  }

  const world::World& world_;
  Renderer renderer_;
  WorldScene scene_;
  std::vector<View> views_;
  std::vector<Image*> pictures_;
};

}  // namespace

std::unique_ptr<simulation::CameraRenderer> world_cameras(const world::World& world) {
  return std::make_unique<WorldCameras>(world);
}

}  // namespace elsie::render
