// The few shapes of which everything consists.
#pragma once

#include <cstdint>
#include <vector>

namespace elsie::render {

/// A corner of a mesh. A face has the light of one normal, which OpenGL takes from the last corner
/// of each triangle ("flat" shading). So a corner has the normal of one face, and other faces can
/// share it: a box has 8 corners instead of 24.
struct Vertex {
  float position[3];
  float normal[3];
};

/// Triangles, counter-clockwise seen from outside.
struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<std::uint16_t> indices;
};

/// x and y from -1/2 to 1/2, z from 0 to 1.
Mesh box_mesh();
/// The part of a prism between its axis, at x = y = 0, and one of its sides, at x = 1 from y = -1/2
/// to 1/2; z from 0 to 1. Its faces towards other parts are left out.
Mesh wedge_mesh();
/// A cylinder of radius 1 about the y axis, from y = -1/2 to 1/2.
Mesh cylinder_mesh();
/// A ball of radius 1 around the origin.
Mesh ball_mesh();
/// x and y from -1 to 1 at z = 0, facing up.
Mesh square_mesh();
/// A disc of radius 1 at z = 0, facing up.
Mesh disc_mesh();

}  // namespace elsie::render
