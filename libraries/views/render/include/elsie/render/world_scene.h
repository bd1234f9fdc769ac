// A world as cameras see it.
//
// Floor, sky, walls, obstacles without a colour of their own and robots are greys, none brighter
// than 0.55 of full light, so that colours stand out, and white does too. Resources have their own
// colour or their team's (world::box_colour()). Chargers are yellow: discs on the floor as large as
// the area in which they charge, or boxes if range sensors should see them. Robots of all teams
// look alike, so that a robot is not mistaken for a resource.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/render/scene.h"
#include "elsie/world/description.h"

namespace elsie::render {

struct Look {
  /// Whether chassis have their team's colour: for people who watch, not for cameras.
  bool team_coloured_robots = false;
};

/// The scene of a world. A robot's place in the world's list is the carrier of its parts.
class WorldScene {
 public:
  /// Everything is where the world puts it.
  explicit WorldScene(const world::World& world, const Look& look = {});

  /// Moves a robot: the frame's origin is on the floor below the middle of its axle. What it pulls
  /// stays where it is.
  void place_robot(std::size_t robot, const Frame& frame);
  /// Moves one of the segments that a robot pulls; the origin as a robot's.
  void place_segment(std::size_t robot, std::size_t segment, const Frame& frame);
  /// Moves a box of the world's list; the frame's origin is in the middle of its bottom. Without a
  /// frame, the box is hidden.
  void place_box(std::size_t box, const std::optional<Frame>& frame);

  const Scene& scene() const { return scene_; }

 private:
  /// Where the parts of a robot or a segment are in the scene's lists, and in its own frame.
  struct Body {
    std::size_t chassis, first_wheel;
    double clearance, half_axle, wheel_radius;
  };

  void add_walls(const world::Arena& arena);
  void add_robot(const world::Robot& robot, const Colour& colour);
  /// Anything with a chassis and two wheels.
  template <class Part>
  Body add_body(const Part& part, const Colour& colour, std::size_t carrier);
  void place(const Body& body, const Frame& frame);

  Scene scene_;
  std::size_t first_box_ = 0;  // of the world's
  std::vector<Body> robots_;
  std::vector<std::vector<Body>> segments_;  // of each robot
};

}  // namespace elsie::render
