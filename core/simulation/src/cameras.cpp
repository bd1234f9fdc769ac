#include "cameras.h"

#include <numbers>
#include <string>

namespace elsie::simulation {
namespace {

/// What is wrong with a camera where pictures may have so many pixels in width and height.
std::optional<std::string> problem_with(const Camera& camera, int largest) {
  if (camera.width < 1 || camera.height < 1 || camera.width > largest || camera.height > largest) {
    return "its camera takes pictures of " + std::to_string(camera.width) + " x " +
           std::to_string(camera.height) + " pixels, but on this machine both may be from 1 to " +
           std::to_string(largest);
  }
  if (!(camera.horizontal_fov_rad > 0.0 && camera.horizontal_fov_rad < std::numbers::pi)) {
    return "its camera has a horizontal field of view of " +
           std::to_string(degrees(camera.horizontal_fov_rad)) +
           " degrees, which must be above 0 and below 180";
  }
  return std::nullopt;
}

}  // namespace

Cameras::Cameras(const world::World& world, std::span<const std::unique_ptr<Robot>> robots,
                 std::vector<world::Problem>& problems)
    : world_(world), robots_(robots) {
  for (std::size_t r = 0; r < robots.size(); ++r) {
    for (std::size_t s = 0; s < robots[r]->sensor_count(); ++s) {
      if (robots[r]->camera(s)) {
        mounts_.push_back({r, s});
      }
    }
  }
  if (mounts_.empty()) {
    return;
  }
  const auto blame = [&](const Mount& mount, const std::string& problem) {
    const world::PluginUse& use = world.robots[mount.robot].sensors[mount.sensor];
    problems.push_back(
        {use.location.file, use.location.line, "plugin '" + use.plugin + "': " + problem});
  };
  try {
    renderer_.emplace();
  } catch (const render::RenderError& error) {
    blame(mounts_.front(), error.what());  // once, not for every camera
    return;
  }
  for (const Mount& mount : mounts_) {
    if (const auto problem =
            problem_with(*robots[mount.robot]->camera(mount.sensor), renderer_->largest_size())) {
      blame(mount, *problem);
    }
  }
  scene_.emplace(world);
}

std::optional<std::string> Cameras::problem_of(const Camera& camera) const {
  return problem_with(camera, renderer_->largest_size());
}

void Cameras::take(const physics::Engine& engine) {
  if (mounts_.empty()) {
    return;
  }
  views_.clear();
  pictures_.clear();
  for (const Mount& mount : mounts_) {
    Robot& robot = *robots_[mount.robot];
    if (!robot.empty()) {
      views_.push_back(
          {robot.sensor_frame(mount.sensor), *robot.camera(mount.sensor), mount.robot});
      pictures_.push_back(&robot.picture(mount.sensor));
    }
  }
  if (!views_.empty()) {
    place_bodies(engine);
    renderer_->render(scene_->scene(), views_, pictures_);
  }
}

void Cameras::place_bodies(const physics::Engine& engine) {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    scene_->place_robot(i, engine.robot(i).frame);
    for (std::size_t segment = 0; segment < engine.segments(i); ++segment) {
      scene_->place_segment(i, segment, engine.segment(i, segment).frame);
    }
  }
  for (std::size_t i = 0; i < world_.boxes.size(); ++i) {
    if (world_.boxes[i].kind != world::BoxKind::fixed) {
      scene_->place_box(i, engine.has_box(i) ? std::optional(engine.box(i)) : std::nullopt);
    }
  }
}

}  // namespace elsie::simulation
