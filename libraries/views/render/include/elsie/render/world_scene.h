// A world as cameras and people see it. To cameras:
//
// Floor, sky, walls, robots and obstacles without a colour are grey, no brighter than 0.55 of full
// light, so that coloured and white things stand out. Resources have their colour or their team's
// (world::resource_colour()). Chargers are yellow: discs on the floor as large as the area in which
// they charge, or boxes if range sensors see them. All robots look alike, whatever their team, so
// that none is mistaken for a resource. Patches of the floor, its image and, if it has one, its
// colour are as in the world's file. Lamps are balls.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/render/scene.h"
#include "elsie/simulation/camera_renderer.h"
#include "elsie/world/colours.h"
#include "elsie/world/parts.h"

namespace elsie::render {

/// A person sees world::kShown instead of greys, and robots in the colours of their teams.
enum class Viewer { camera, person };

/// The scene of a world. Robots are the carriers of their bodies, by their index in the world.
class WorldScene {
 public:
  /// Everything is at its start.
  explicit WorldScene(const world::World& world, Viewer viewer = Viewer::camera);

  /// Moves a robot: the frame's origin is on the floor below the middle of its axle. Its segments
  /// stay in place.
  void place_robot(std::size_t robot, const Frame& frame);
  /// Moves a segment of a robot; the origin is as for a robot.
  void place_segment(std::size_t robot, std::size_t segment, const Frame& frame);
  /// Moves a box by its index in the world: the frame's origin is in the middle of its bottom.
  /// None: removed.
  void place_box(std::size_t box, const std::optional<Frame>& frame);

  /// Shows what robots shine, and nothing that they shone before.
  void show_lights(std::span<const simulation::CarriedLight> lights);

  const Scene& scene() const { return scene_; }

  /// What moves together, in the lists of the scene.
  using Body = std::vector<Placed>;
  /// By the index of the box in the world.
  const std::vector<Body>& boxes() const { return boxes_; }
  /// The robot itself, then its segments; by its index in the world.
  const std::vector<std::vector<Body>>& robots() const { return robots_; }

 private:
  void add_robot(const world::Robot& robot, const Colour& colour, const Colour& tyre);

  Scene scene_;
  std::vector<Body> boxes_;
  std::vector<std::vector<Body>> robots_;
  std::size_t lights_from_ = 0;  // among the balls
};

}  // namespace elsie::render
