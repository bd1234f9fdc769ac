// The cameras of a simulated world.
#pragma once

#include <memory>

#include "elsie/simulation/camera_renderer.h"

namespace elsie::render {

/// For simulation::Options::cameras: takes pictures with a Renderer. Throws RenderError if there is
/// none.
std::unique_ptr<simulation::CameraRenderer> world_cameras(const world::World& world);

}  // namespace elsie::render
