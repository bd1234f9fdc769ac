#include "meshes.h"

#include <array>
#include <cmath>
#include <numbers>

namespace elsie::render {
namespace {

constexpr int kCylinderSides = 20;
constexpr int kBallSides = 20;
constexpr int kBallRings = 10;
constexpr int kDiscSides = 32;

Vertex vertex(double x, double y, double z) {
  return {{static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)}, {0, 0, 0}};
}

/// Adds a flat face with its corners in counter-clockwise order; the first one has its normal.
void add_face(Mesh& mesh, const std::vector<int>& corners, double nx, double ny, double nz) {
  const auto speaker = static_cast<std::uint16_t>(corners[0]);
  float* normal = mesh.vertices[speaker].normal;
  normal[0] = static_cast<float>(nx);
  normal[1] = static_cast<float>(ny);
  normal[2] = static_cast<float>(nz);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    mesh.indices.push_back(static_cast<std::uint16_t>(corners[i]));
    mesh.indices.push_back(static_cast<std::uint16_t>(corners[i + 1]));
    mesh.indices.push_back(speaker);
  }
}

double turn(int part, int parts) { return 2.0 * std::numbers::pi * part / parts; }

Mesh box_mesh() {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) {  // bits of i: x, y, z
    mesh.vertices.push_back(vertex(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 1.0 : 0.0));
  }
  // Each face begins with a different corner.
  add_face(mesh, {0, 4, 6, 2}, -1, 0, 0);
  add_face(mesh, {1, 3, 7, 5}, 1, 0, 0);
  add_face(mesh, {4, 0, 1, 5}, 0, -1, 0);
  add_face(mesh, {2, 6, 7, 3}, 0, 1, 0);
  add_face(mesh, {3, 1, 0, 2}, 0, 0, -1);
  add_face(mesh, {6, 4, 5, 7}, 0, 0, 1);
  return mesh;
}

Mesh wedge_mesh() {
  Mesh mesh;
  for (const double z : {0.0, 1.0}) {
    for (const double y : {-0.5, 0.5}) mesh.vertices.push_back(vertex(1, y, z));
    mesh.vertices.push_back(vertex(0, 0, z));
  }
  add_face(mesh, {0, 1, 4, 3}, 1, 0, 0);
  add_face(mesh, {2, 1, 0}, 0, 0, -1);
  add_face(mesh, {5, 3, 4}, 0, 0, 1);
  return mesh;
}

Mesh cylinder_mesh() {
  Mesh mesh;
  const int n = kCylinderSides;
  for (const double y : {-0.5, 0.5}) {
    for (int i = 0; i < n; ++i) {
      mesh.vertices.push_back(vertex(std::cos(turn(i, n)), y, std::sin(turn(i, n))));
    }
  }
  std::vector<int> right, left;
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    const double middle = turn(2 * i + 1, 2 * n);
    add_face(mesh, {i, n + i, n + next, next}, std::cos(middle), 0, std::sin(middle));
    left.push_back(2 * n - 1 - i);
    right.push_back(i);
  }
  add_face(mesh, left, 0, 1, 0);
  // The corners of this side all have normals of the rim.
  mesh.vertices.push_back(mesh.vertices[0]);
  right[0] = 2 * n;
  add_face(mesh, right, 0, -1, 0);
  return mesh;
}

Mesh ball_mesh() {
  Mesh mesh;
  const auto place = [](double ring, double side) {
    const double up = std::numbers::pi * (ring / kBallRings - 0.5);
    const double round = 2.0 * std::numbers::pi * side / kBallSides;
    return vertex(std::cos(up) * std::cos(round), std::cos(up) * std::sin(round), std::sin(up));
  };
  for (int ring = 0; ring <= kBallRings; ++ring) {  // the first and the last one are the poles
    for (int side = 0; side < kBallSides; ++side) mesh.vertices.push_back(place(ring, side));
  }
  for (int ring = 0; ring < kBallRings; ++ring) {
    for (int side = 0; side < kBallSides; ++side) {
      const auto corner = [&](int r, int s) { return r * kBallSides + s % kBallSides; };
      const auto own = static_cast<int>(mesh.vertices.size());
      mesh.vertices.push_back(place(ring, side));
      const Vertex out = place(ring + 0.5, side + 0.5);
      add_face(mesh,
               {own, corner(ring, side + 1), corner(ring + 1, side + 1), corner(ring + 1, side)},
               out.position[0], out.position[1], out.position[2]);
    }
  }
  return mesh;
}

Mesh square_mesh() {
  Mesh mesh;
  mesh.vertices = {vertex(-1, -1, 0), vertex(1, -1, 0), vertex(1, 1, 0), vertex(-1, 1, 0)};
  add_face(mesh, {0, 1, 2, 3}, 0, 0, 1);
  return mesh;
}

Mesh triangle_mesh() {
  Mesh mesh;
  mesh.vertices = {vertex(0, 0, 0), vertex(1, -0.5, 0), vertex(1, 0.5, 0)};
  add_face(mesh, {0, 1, 2}, 0, 0, 1);
  return mesh;
}

Mesh disc_mesh() {
  Mesh mesh;
  std::vector<int> corners;
  for (int i = 0; i < kDiscSides; ++i) {
    const double angle = turn(i, kDiscSides);
    mesh.vertices.push_back(vertex(std::cos(angle), std::sin(angle), 0));
    corners.push_back(i);
  }
  add_face(mesh, corners, 0, 0, 1);
  return mesh;
}

}  // namespace

std::array<Mesh, kMeshes> meshes() {
  return {square_mesh(), square_mesh(), triangle_mesh(), disc_mesh(),
          box_mesh(),    wedge_mesh(),  cylinder_mesh(), ball_mesh()};
}

}  // namespace elsie::render
