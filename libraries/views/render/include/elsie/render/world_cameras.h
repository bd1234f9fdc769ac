// The cameras of a simulated world.
#pragma once

#include <memory>

#include "elsie/simulation/camera_renderer.h"

namespace elsie::render {

/// For simulation::Options::cameras: takes the pictures with a Renderer. Throws RenderError.
std::unique_ptr<simulation::CameraRenderer> world_cameras(const world::World& world);

}  // namespace elsie::render
