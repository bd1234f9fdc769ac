// The few shapes of which everything consists.
#pragma once

#include <array>
#include <cstddef>
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

/// The meshes, in the order in which they are drawn.
enum MeshKind : std::size_t {
  kSquare,    // x and y from -1 to 1 at z = 0, facing up
  kImage,     // the same, with the image of the floor
  kTriangle,  // with its corners at 0, (1, -1/2) and (1, 1/2) at z = 0, facing up
  kDisc,      // of radius 1 at z = 0, facing up
  kBox,       // x and y from -1/2 to 1/2, z from 0 to 1
  kWedge,     // the part of a prism between its axis, at x = y = 0, and one of its sides, at x = 1
              // from y = -1/2 to 1/2; z from 0 to 1; without its faces towards other parts
  kCylinder,  // of radius 1 about the y axis, from y = -1/2 to 1/2
  kBall,      // of radius 1 around the origin
  kMeshes
};
std::array<Mesh, kMeshes> meshes();

inline float single(double value) { return static_cast<float>(value); }

/// A corner of a mesh in pictures for people, where faces that meet smoothly share a normal.
/// `inset` is moved towards the middle along each axis, in units of a bevel.
struct SmoothVertex {
  float position[3];
  float normal[3];
  float inset[3];
};
struct SmoothMesh {
  std::vector<SmoothVertex> vertices;
  std::vector<std::uint16_t> indices;
};
/// The same meshes, rounder; a box has bevelled edges. Its first kBoxSides indices are a box
/// without.
inline constexpr int kBoxSides = 36;
std::array<SmoothMesh, kMeshes> smooth_meshes();

}  // namespace elsie::render
