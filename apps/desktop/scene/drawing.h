// The lines of the view: the floor's grid, the places of goals, what plugins sketch.
#pragma once

#include <vector>

#include "elsie/render/scene.h"

#include "scene/camera.h"
#include "scene/stage.h"

namespace elsie::desktop {

/// The distance between labelled lines of the grid, m: finer when the camera is near.
double grid_step(const Stage& stage, const OrbitCamera& camera);
/// Lines on the floor of the arena; those between the labelled ones are fainter.
std::vector<render::Stroke> grid_lines(const Stage& stage, const OrbitCamera& camera);
/// Dashed circles around the places of goals.
std::vector<render::Stroke> goal_lines(const Stage& stage);
/// The lines and the shafts of arrows that plugins draw.
std::vector<render::Stroke> sketch_lines(const Stage& stage);
/// A cone in front of a sensor.
std::vector<render::Stroke> sensor_lines(const Frame& sensor);

}  // namespace elsie::desktop
