#include "step/cameras.h"

#include <numbers>
#include <string>

#include "elsie/base/number_text.h"

namespace elsie::simulation {
namespace {

/// The problem of a camera, if pictures may be at most this wide and high, px.
std::optional<std::string> problem_with(const Camera& camera, int largest) {
  if (camera.width < 1 || camera.height < 1 || camera.width > largest || camera.height > largest) {
    return "its camera takes pictures of " + std::to_string(camera.width) + " x " +
           std::to_string(camera.height) + " pixels, but on this machine both may be from 1 to " +
           std::to_string(largest);
  }
  if (!(camera.horizontal_fov_rad > 0.0 && camera.horizontal_fov_rad < std::numbers::pi)) {
    return "its camera has a horizontal field of view of " +
           base::number_text(degrees(camera.horizontal_fov_rad), 6) +
           " degrees, which must be above 0 and below 180";
  }
  return std::nullopt;
}

}  // namespace

Cameras::Cameras(const world::World& world, const std::vector<std::shared_ptr<Robot>>& robots,
                 const MakeCameraRenderer& make_renderer, std::vector<base::Problem>& problems)
    : robots_(robots) {
  for (std::size_t r = 0; r < robots.size(); ++r) {
    for (std::size_t s = 0; s < robots[r]->sensor_count(); ++s) {
      if (robots[r]->camera(s)) {
        mounts_.push_back({r, s});
      }
    }
  }
  if (mounts_.empty()) return;
  const auto blame = [&](const Mount& mount, const std::string& problem) {
    const world::PluginUse& use = world.robots[mount.robot].sensors[mount.sensor];
    problems.push_back(
        {use.location.file, use.location.line, "plugin '" + use.plugin + "': " + problem});
  };
  if (!make_renderer) {
    blame(mounts_.front(),
          "no renderer was given for its camera; the program that runs this world must set "
          "Options::cameras");
    return;
  }
  try {
    renderer_ = make_renderer(world);
  } catch (const base::Error& error) {
    blame(mounts_.front(), error.what());  // once, not for every camera
    return;
  }
  for (const Mount& mount : mounts_) {
    if (const auto problem =
            problem_with(*robots[mount.robot]->camera(mount.sensor), renderer_->largest_size())) {
      blame(mount, *problem);
    }
  }
}

std::optional<std::string> Cameras::problem_of(const Camera& camera) const {
  return problem_with(camera, renderer_->largest_size());
}

void Cameras::take(const physics::Engine& engine) {
  if (mounts_.empty()) return;
  views_.clear();
  for (const Mount& mount : mounts_) {
    Robot& robot = *robots_[mount.robot];
    if (!robot.empty()) {
      views_.push_back({robot.sensor_frame(mount.sensor), *robot.camera(mount.sensor), mount.robot,
                        &robot.picture(mount.sensor)});
    }
  }
  if (views_.empty()) return;
  lights_.clear();
  std::vector<LampView> shown;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    shown.clear();
    robots_[i]->list_lights(shown);
    for (const LampView& light : shown) lights_.push_back({i, light.place, light.colour});
  }
  renderer_->take(engine, views_, lights_);
}

}  // namespace elsie::simulation
